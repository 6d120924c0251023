// The surface of a part, decoded from the document: triangles, fill time, fields over time, marks.
import type { ShellField, ShellSection } from "../document";
import { decode_base64 } from "./frame";

export interface ShellData {
  /** Nodes, xyz [m]. */
  points: Float32Array;
  triangles: Int32Array;
  /** When the melt came to each node [s]; NaN where it never did. */
  fill_time: Float32Array;
  /** Times of the fields' frames [s]. */
  times: number[];
  fields: DecodedField[];
  nodes: number;
  /** The end of what is shown [s]. */
  end: number;
}

export interface DecodedField {
  label: string;
  unit: string;
  /** One value a node in each; one frame alone holds at all times. */
  frames: Float32Array[];
}

function decode_floats(text: string): Float32Array {
  return new Float32Array(decode_base64(text));
}

function decode_field(field: ShellField, nodes: number, times: number): DecodedField {
  const frames = field.frames.map(decode_floats);
  if (frames.some(({ length }) => length !== nodes)) throw new Error(`the field “${field.label}” does not have ${nodes} values`);
  if (frames.length !== 1 && frames.length !== times) throw new Error(`the field “${field.label}” has ${frames.length} frames for ${times} times`);
  return { label: field.label, unit: field.unit ?? "", frames };
}

/** Decodes a section; throws where its parts do not belong together. */
export function decode_shell(section: ShellSection): ShellData {
  const points = decode_floats(section.points);
  const triangles = new Int32Array(decode_base64(section.triangles));
  const fill_time = decode_floats(section.fill_time);
  const nodes = points.length / 3;
  if (fill_time.length !== nodes || triangles.some((node) => node < 0 || node >= nodes)) {
    throw new Error(`the surface has ${nodes} nodes, but ${fill_time.length} fill times or triangles of other nodes`);
  }
  const fields = section.fields.map((field) => decode_field(field, nodes, section.times.length));
  if (fields.length === 0) throw new Error("it holds no fields");
  const last_filled = fill_time.reduce((latest, time) => (time > latest ? time : latest), 0);
  return { points, triangles, fill_time, times: section.times, fields, nodes, end: Math.max(last_filled, section.times.at(-1) ?? 0) };
}

/** Gives the values of a field at a time, linear between its frames. */
export function field_at(data: ShellData, field: DecodedField, time: number): Float32Array {
  if (field.frames.length === 1) return field.frames[0]!;
  const { times } = data;
  let above = times.findIndex((one) => one >= time);
  if (above < 0) above = times.length - 1;
  const below = Math.max(0, above - 1);
  const span = times[above]! - times[below]!;
  const share = span > 0 ? Math.min(1, Math.max(0, (time - times[below]!) / span)) : 1;
  const [a, b] = [field.frames[below]!, field.frames[above]!];
  // What is not there yet in the frame before has the value of the frame after.
  return b.map((value, node) => (Number.isFinite(a[node]) ? a[node]! + share * (value - a[node]!) : value));
}

/** Lists the edges of the outline, two nodes each: those of a single triangle, and those where patches meet at an angle. */
export function outline_edges(data: ShellData): number[] {
  const faces = new Map<string, number[]>();
  const normal = (triangle: number): [number, number, number] => {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * data.triangles[3 * triangle + k]!) as [number, number, number];
    const u = [0, 1, 2].map((k) => data.points[b + k]! - data.points[a + k]!) as [number, number, number];
    const v = [0, 1, 2].map((k) => data.points[c + k]! - data.points[a + k]!) as [number, number, number];
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]] as const;
    const length = Math.hypot(...n) || 1;
    return [n[0] / length, n[1] / length, n[2] / length];
  };
  for (let triangle = 0; 3 * triangle < data.triangles.length; ++triangle) {
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [data.triangles[3 * triangle + k]!, data.triangles[3 * triangle + ((k + 1) % 3)]!];
      const key = a < b ? `${a},${b}` : `${b},${a}`;
      const known = faces.get(key);
      if (known) known.push(triangle);
      else faces.set(key, [triangle]);
    }
  }
  const edges: number[] = [];
  const fold = Math.cos((35 * Math.PI) / 180);
  for (const [key, sides] of faces) {
    const [first, second] = sides.map(normal);
    const folded = first && second && Math.abs(first[0] * second[0] + first[1] * second[1] + first[2] * second[2]) < fold;
    if (sides.length !== 2 || folded) edges.push(...key.split(",").map(Number));
  }
  return edges;
}
