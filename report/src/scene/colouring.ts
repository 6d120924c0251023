// By what the fibers are coloured: a value at both ends of every rod, its range, and its colours.
import { category_colour, sample_map } from "../palette";
import type { CellFrame, Measures } from "./frame";
import type { PlacedRods } from "./images";

export type Colouring = "length" | "curvature" | "birth" | "angle_x" | "angle_y" | "angle_z";

export const colourings: { value: Colouring; text: string }[] = [
  { value: "length", text: "length" },
  { value: "curvature", text: "curvature" },
  { value: "birth", text: "birth fiber" },
  { value: "angle_x", text: "angle to x" },
  { value: "angle_y", text: "angle to y" },
  { value: "angle_z", text: "angle to z" },
];

export interface ColourScale {
  label: string;
  unit: string;
  min: number;
  max: number;
  /** Values above the range exist and have its last colour. */
  clipped: boolean;
  /** 256 colours, red green blue alpha; the whole table is one pass through the range. */
  table: Uint8Array;
  categorical: boolean;
}

export interface MeasuredFrame {
  frame: CellFrame;
  measures: Measures;
}

export const table_size = 256;

/** Makes a table of 256 colours, red green blue alpha. */
export function make_table(colour_at: (index: number) => [number, number, number]): Uint8Array {
  const table = new Uint8Array(4 * table_size);
  for (let k = 0; k < table_size; ++k) table.set([...colour_at(k), 255], 4 * k);
  return table;
}

const sequential = make_table((k) => sample_map("tide", k / (table_size - 1)));
const heat = make_table((k) => sample_map("ember", k / (table_size - 1)));
const categories = make_table(category_colour);

/** The range covers 99.5 % of the hinges, so that one kink does not darken all others. */
function range_of_curvature(frames: MeasuredFrame[]): { max: number; clipped: boolean } {
  const every: number[] = [];
  for (const { measures } of frames) {
    for (const value of measures.curvature) if (value > 0) every.push(value);
  }
  if (every.length === 0) return { max: 1, clipped: false };
  const sorted = Float32Array.from(every).sort();
  const last = sorted[sorted.length - 1]!;
  const high = sorted[Math.floor(0.995 * (sorted.length - 1))]!;
  return last > 1.3 * high ? { max: high, clipped: true } : { max: last, clipped: false };
}

/** Makes the scale of a colouring, one for all times, so that colours can be compared. */
export function make_scale(colouring: Colouring, frames: MeasuredFrame[]): ColourScale {
  const base = { clipped: false, categorical: false, table: sequential };
  if (colouring === "length") {
    let max = 0;
    for (const { measures } of frames) for (const value of measures.length) max = Math.max(max, value);
    return { ...base, label: "fiber length", unit: "m", min: 0, max: max || 1 };
  }
  if (colouring === "curvature") {
    return { ...base, label: "curvature 1/R", unit: "1/m", min: 0, table: heat, ...range_of_curvature(frames) };
  }
  if (colouring === "birth") {
    return { ...base, label: "birth fiber", unit: "", min: 0, max: table_size, table: categories, categorical: true };
  }
  return { ...base, label: `angle to ${colouring.slice(-1)}`, unit: "deg", min: 0, max: 90 };
}

function angle_to_axis(placed: PlacedRods, rod: number, axis: number): number {
  const d = [0, 1, 2].map((k) => placed.ends[3 * rod + k]! - placed.starts[3 * rod + k]!) as [number, number, number];
  const across = Math.hypot(...d.filter((_component, k) => k !== axis));
  return (Math.atan2(across, Math.abs(d[axis]!)) * 180) / Math.PI;
}

/** Gives the place in the colour table, 0 to 1, at the start and end of every rod. */
export function colour_rods(colouring: Colouring, scale: ColourScale, measured: MeasuredFrame, placed: PlacedRods): Float32Array {
  const { frame, measures } = measured;
  const places = new Float32Array(2 * placed.count);
  const span = scale.max - scale.min;
  for (let rod = 0; rod < placed.count; ++rod) {
    const fiber = placed.fiber[rod]!;
    const node = placed.first_node[rod]!;
    let ends: [number, number];
    if (colouring === "length") ends = [measures.length[fiber]!, measures.length[fiber]!];
    else if (colouring === "curvature") ends = [measures.curvature[node]!, measures.curvature[node + 1]!];
    else if (colouring === "birth") {
      const entry = (((frame.birth[fiber]! % table_size) + table_size) % table_size) + 0.5;
      ends = [entry, entry];
    } else {
      const angle = angle_to_axis(placed, rod, "xyz".indexOf(colouring.slice(-1)));
      ends = [angle, angle];
    }
    places[2 * rod] = (ends[0] - scale.min) / span;
    places[2 * rod + 1] = (ends[1] - scale.min) / span;
  }
  return places;
}
