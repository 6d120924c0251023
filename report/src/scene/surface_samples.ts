// Nodes spread evenly over a part, with their normals: where glyphs stand.
import type { ShellData } from "./shell";

type Vector = [number, number, number];

export interface Sample {
  node: number;
  at: Vector;
  normal: Vector;
}

export interface Samples {
  samples: Sample[];
  /** How far samples are apart [m]. */
  apart: number;
}

const across = 34; // samples along the longest side

/** Adds up the normals of the triangles around every node, by area. */
function normals_of({ points, triangles, nodes }: ShellData): Float32Array {
  const normals = new Float32Array(3 * nodes);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!];
    const u = [0, 1, 2].map((k) => points[b + k]! - points[a + k]!) as Vector;
    const v = [0, 1, 2].map((k) => points[c + k]! - points[a + k]!) as Vector;
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (const node of [a, b, c]) for (const k of [0, 1, 2]) normals[node + k]! += n[k]!;
  }
  return normals;
}

/** Takes the node nearest to the middle of every box of a grid that has nodes. */
export function sample_surface(data: ShellData): Samples {
  const low: Vector = [Infinity, Infinity, Infinity];
  const high: Vector = [-Infinity, -Infinity, -Infinity];
  data.points.forEach((value, k) => {
    low[k % 3 as 0 | 1 | 2] = Math.min(low[k % 3 as 0 | 1 | 2], value);
    high[k % 3 as 0 | 1 | 2] = Math.max(high[k % 3 as 0 | 1 | 2], value);
  });
  const apart = Math.max(...low.map((value, k) => high[k]! - value)) / across;
  const best = new Map<string, { node: number; away: number }>();
  for (let node = 0; node < data.nodes; ++node) {
    const places = [0, 1, 2].map((k) => (data.points[3 * node + k]! - low[k]!) / apart);
    const box = places.map(Math.floor);
    const away = Math.hypot(...places.map((place, k) => place - box[k]! - 0.5));
    const known = best.get(box.join());
    if (!known || away < known.away) best.set(box.join(), { node, away });
  }
  const normals = normals_of(data);
  const samples = [...best.values()].map(({ node }): Sample => {
    const normal = [...normals.subarray(3 * node, 3 * node + 3)];
    const norm = Math.hypot(...normal) || 1;
    return { node, at: [...data.points.subarray(3 * node, 3 * node + 3)] as Vector, normal: normal.map((value) => value / norm) as Vector };
  });
  return { samples, apart };
}
