// Strokes on a part along directions such as the stiffest axis; the longer, the larger the value.
import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments } from "three";
import type { ShellDirections } from "../document";
import { decode_base64 } from "./frame";

const most_strokes = 2500;

/** Gives the directions that are drawn: all, or every second, third, …, of so many that they would touch. */
export function make_axes(directions: ShellDirections, factor: number): LineSegments {
  const at = new Float32Array(decode_base64(directions.at));
  const vectors = new Float32Array(decode_base64(directions.vectors));
  const count = at.length / 3;
  const every = Math.max(1, Math.ceil(count / most_strokes));
  let largest = 0;
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < count; ++k) {
    largest = Math.max(largest, Math.hypot(vectors[3 * k]!, vectors[3 * k + 1]!, vectors[3 * k + 2]!));
    for (const axis of [0, 1, 2]) {
      low = Math.min(low, at[3 * k + axis]!);
      high = Math.max(high, at[3 * k + axis]!);
    }
  }
  const reach = (0.45 * (high - low)) / Math.sqrt(Math.min(count, most_strokes)) / (largest || 1);
  const ends: number[] = [];
  for (let k = 0; k < count; k += every) {
    for (const sign of [-1, 1]) for (const axis of [0, 1, 2]) ends.push((at[3 * k + axis]! + sign * reach * vectors[3 * k + axis]!) * factor);
  }
  const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(Float32Array.from(ends), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: new Color(0.08, 0.08, 0.1) }));
}
