// One state of the cell, decoded from the document and measured.
import type { FiberFrame } from "../document";
import { make_upright, type Three } from "./lattice";

export interface CellFrame {
  time_s: number;
  /** Row-major; columns are the lattice vectors [m], the first along x, the second in the plane of x and y. */
  lattice: number[];
  origin: Three;
  periodic: boolean[];
  /** Shear strain since the start, where the document tells it. */
  strain?: number;
  /** Node offsets, fibers + 1. */
  offsets: Int32Array;
  /** Nodes, xyz [m]. */
  points: Float32Array;
  birth: Int32Array;
  /** Number of each fiber's first node along the fiber that it was born with, where the document tells it. */
  birth_node?: Int32Array;
  radius: Float32Array;
  fibers: number;
  rods: number;
}

/** What follows from a frame's nodes. */
export interface Measures {
  /** Length of each fiber [m]. */
  length: Float32Array;
  /** Curvature 1/R at each node [1/m]; zero at free ends and where three nodes lie on a line. */
  curvature: Float32Array;
  /** The largest curvature of each fiber [1/m]. */
  sharpest: Float32Array;
}

export interface MeasuredFrame {
  frame: CellFrame;
  measures: Measures;
}

export function decode_base64(text: string): ArrayBuffer {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
  return bytes.buffer;
}

/** Decodes nodes: as they are, or as steps of a grid from a corner. */
function decode_points(frame: FiberFrame): Float32Array {
  if (frame.points !== undefined) return new Float32Array(decode_base64(frame.points));
  const { steps, corner, step } = frame.grid!;
  const whole = new Uint16Array(decode_base64(steps));
  const points = new Float32Array(whole.length);
  for (const axis of [0, 1, 2]) {
    const [low, width] = [corner[axis]!, step[axis]!];
    for (let k = axis; k < whole.length; k += 3) points[k] = low + width * whole[k]!;
  }
  return points;
}

/** Decodes a frame; throws where its parts do not belong together. */
export function decode_frame(frame: FiberFrame): CellFrame {
  const offsets = new Int32Array(decode_base64(frame.offsets));
  const points = decode_points(frame);
  const birth = new Int32Array(decode_base64(frame.birth));
  const birth_node = frame.birth_node === undefined ? undefined : new Int32Array(decode_base64(frame.birth_node));
  const radius = new Float32Array(decode_base64(frame.radius));
  const fibers = Math.max(0, offsets.length - 1);
  const nodes = offsets[fibers] ?? 0;
  const whole = points.length === 3 * nodes && birth.length === fibers && radius.length === fibers;
  if (!whole || (birth_node && birth_node.length !== fibers)) {
    throw new Error(`the frame at ${frame.time_s} s has ${fibers} fibers and ${nodes} nodes, but ${points.length / 3} points, ${birth.length} birth ids, ${radius.length} radii`);
  }
  return {
    time_s: frame.time_s,
    lattice: make_upright(frame.lattice),
    origin: [frame.origin?.[0] ?? 0, frame.origin?.[1] ?? 0, frame.origin?.[2] ?? 0],
    periodic: frame.periodic ?? [true, true, true],
    strain: frame.strain,
    offsets, points, birth, birth_node, radius, fibers,
    rods: nodes - fibers,
  };
}

// Math.hypot and short arrays would take most of the time in which a large report opens.
function size_of(x: number, y: number, z: number): number {
  return Math.sqrt(x * x + y * y + z * z);
}

function distance(points: Float32Array, a: number, b: number): number {
  return size_of(points[3 * b]! - points[3 * a]!, points[3 * b + 1]! - points[3 * a + 1]!, points[3 * b + 2]! - points[3 * a + 2]!);
}

/**
 * Gives the curvature of the circle through nodes n-1, n, n+1: 1/R = 4 area / (a b c).
 * Below what single precision can tell from a straight line it is zero.
 */
function curvature_at(points: Float32Array, n: number): number {
  const k = 3 * n;
  const [x, y, z] = [points[k]!, points[k + 1]!, points[k + 2]!];
  const [ux, uy, uz] = [x - points[k - 3]!, y - points[k - 2]!, z - points[k - 1]!];
  const [vx, vy, vz] = [points[k + 3]! - x, points[k + 4]! - y, points[k + 5]! - z];
  const cross = size_of(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
  const a = size_of(ux, uy, uz);
  const b = size_of(vx, vy, vz);
  const product = a * b * size_of(ux + vx, uy + vy, uz + vz);
  if (!(product > 0)) return 0;
  const largest = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  const round_off = 4 * 1.2e-7 * largest * (a + b);
  return cross <= round_off ? 0 : (2 * cross) / product;
}

export function measure_frame(frame: CellFrame): Measures {
  const { offsets, points, fibers } = frame;
  const length = new Float32Array(fibers);
  const sharpest = new Float32Array(fibers);
  const curvature = new Float32Array(points.length / 3);
  for (let fiber = 0; fiber < fibers; ++fiber) {
    const first = offsets[fiber]!;
    const last = offsets[fiber + 1]! - 1;
    let sum = 0;
    for (let node = first; node < last; ++node) {
      sum += distance(points, node, node + 1);
      if (node > first) curvature[node] = curvature_at(points, node);
      sharpest[fiber] = Math.max(sharpest[fiber]!, curvature[node]!);
    }
    length[fiber] = sum;
  }
  return { length, curvature, sharpest };
}
