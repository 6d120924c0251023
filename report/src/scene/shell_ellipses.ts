// Ellipses on a part that show how fibers lie in its surface: longer along more fibers, round where none is preferred.
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial,
} from "three";
import type { ShellTensors } from "../document";
import { decode_base64 } from "./frame";
import type { ShellData } from "./shell";
import { type Sample, sample_surface, type Samples } from "./surface_samples";

type Vector = [number, number, number];

const corners = 20; // of the polygon that stands for an ellipse

export interface ShellEllipses {
  group: Group;
  set_time: (time: number) => void;
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Gives two unit vectors in the surface. */
function tangents(normal: Vector): [Vector, Vector] {
  const aside = cross(normal, Math.abs(normal[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]);
  const norm = Math.hypot(...aside) || 1;
  const first = aside.map((value) => value / norm) as Vector;
  return [first, cross(normal, first)];
}

/** Applies a tensor given as 11 22 33 23 31 12. */
function apply(t: Float32Array, x: Vector): Vector {
  return [t[0]! * x[0] + t[5]! * x[1] + t[4]! * x[2], t[5]! * x[0] + t[1]! * x[1] + t[3]! * x[2], t[4]! * x[0] + t[3]! * x[1] + t[2]! * x[2]];
}

/** Gives the axes of the ellipse whose radii are the principal values in the surface. */
export function ellipse_axes(tensor: Float32Array, normal: Vector): [Vector, Vector] {
  const [u, v] = tangents(normal);
  const [a, b, c] = [dot(u, apply(tensor, u)), dot(u, apply(tensor, v)), dot(v, apply(tensor, v))];
  const angle = Math.atan2(2 * b, a - c) / 2;
  const spread = Math.hypot((a - c) / 2, b);
  const along = (cosine: number, sine: number, radius: number): Vector => u.map((value, k) => radius * (cosine * value + sine * v[k]!)) as Vector;
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return [along(cosine, sine, (a + c) / 2 + spread), along(-sine, cosine, Math.max(0, (a + c) / 2 - spread))];
}

/** Lays the rims of all ellipses out, one after the other. */
function lay_rims(samples: Sample[], tensors: Float32Array, { apart, factor }: { apart: number; factor: number }): Float32Array {
  const rims = new Float32Array(3 * corners * samples.length);
  samples.forEach(({ node, at, normal }, s) => {
    const [major, minor] = ellipse_axes(tensors.subarray(6 * node, 6 * node + 6), normal);
    for (let k = 0; k < corners; ++k) {
      const [cosine, sine] = [Math.cos((2 * Math.PI * k) / corners), Math.sin((2 * Math.PI * k) / corners)];
      for (const axis of [0, 1, 2]) {
        rims[3 * (corners * s + k) + axis] = (at[axis]! + 0.55 * apart * (cosine * major[axis]! + sine * minor[axis]!)) * factor;
      }
    }
  });
  return rims;
}

function make_parts(rims: Float32Array, count: number): { fill: Mesh; line: LineSegments } {
  const [faces, edges]: [number[], number[]] = [[], []];
  for (let s = 0; s < count; ++s) {
    for (let k = 0; k < corners; ++k) {
      const [here, next] = [corners * s + k, corners * s + ((k + 1) % corners)];
      edges.push(here, next);
      if (k > 0 && k + 1 < corners) faces.push(corners * s, here, next);
    }
  }
  const positions = new BufferAttribute(rims, 3);
  const shape = (index: number[]): BufferGeometry => new BufferGeometry().setAttribute("position", positions).setIndex(index);
  const white = new MeshBasicMaterial({ color: new Color(1, 1, 1), transparent: true, opacity: 0.62, side: DoubleSide, depthWrite: false });
  const black = new LineBasicMaterial({ color: new Color(0.08, 0.08, 0.1) });
  return { fill: new Mesh(shape(faces), white), line: new LineSegments(shape(edges), black) };
}

/** Makes the ellipses of the tensors' last frame; they appear with the melt. */
export function make_ellipses(tensors: ShellTensors, data: ShellData, factor: number): ShellEllipses {
  const values = new Float32Array(decode_base64(tensors.frames.at(-1)!));
  if (values.length !== 6 * data.nodes) throw new Error(`“${tensors.label}” does not have ${6 * data.nodes} values`);
  const { samples: all, apart }: Samples = sample_surface(data);
  const samples = all.filter(({ node }) => Number.isFinite(values[6 * node]!) && Number.isFinite(data.fill_time[node]!))
    .sort((a, b) => data.fill_time[a.node]! - data.fill_time[b.node]!);
  const { fill, line } = make_parts(lay_rims(samples, values, { apart, factor }), samples.length);
  const group = new Group();
  group.add(fill, line);
  const set_time = (time: number): void => {
    const later = samples.findIndex(({ node }) => data.fill_time[node]! > time);
    const count = later < 0 ? samples.length : later;
    fill.geometry.setDrawRange(0, 3 * (corners - 2) * count);
    line.geometry.setDrawRange(0, 2 * corners * count);
  };
  return { group, set_time };
}
