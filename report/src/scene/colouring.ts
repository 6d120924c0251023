// By what the fibers are coloured: a value at both ends of every rod, its range, and its colours.
import { category_colour, sample_map } from "../palette";
import type { BreakTimes } from "./breaks";
import type { CellState } from "./cell_state";
import type { MeasuredFrame } from "./frame";
import type { PlacedRods } from "./images";

export type Colouring = "length" | "curvature" | "birth" | "break_age" | "angle_x" | "angle_y" | "angle_z";

const every_colouring: { value: Colouring; text: string }[] = [
  { value: "length", text: "length" },
  { value: "angle_x", text: "angle to x" },
  { value: "angle_y", text: "angle to y" },
  { value: "angle_z", text: "angle to z" },
  { value: "curvature", text: "curvature" },
  { value: "birth", text: "birth fiber" },
  { value: "break_age", text: "age of the last break" },
];

/** Lists the colourings for which a document has data. */
export function colourings_of(breaks: BreakTimes): { value: Colouring; text: string }[] {
  return every_colouring.filter(({ value }) => value !== "break_age" || breaks.breaks.length > 0);
}

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

export const table_size = 256;

/** Makes a table of 256 colours, red green blue alpha. */
export function make_table(colour_at: (index: number) => [number, number, number]): Uint8Array {
  const table = new Uint8Array(4 * table_size);
  for (let k = 0; k < table_size; ++k) table.set([...colour_at(k), 255], 4 * k);
  return table;
}

const sequential = make_table((k) => sample_map("tide", k / (table_size - 1)));
const heat = make_table((k) => sample_map("ember", k / (table_size - 1)));
const cooling = make_table((k) => sample_map("ember", 1 - k / (table_size - 1)));
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
export function make_scale(colouring: Colouring, frames: MeasuredFrame[], duration: number): ColourScale {
  const base = { clipped: false, categorical: false, table: sequential };
  switch (colouring) {
    case "length": {
      let max = 0;
      for (const { measures } of frames) for (const value of measures.length) max = Math.max(max, value);
      return { ...base, label: "fiber length", unit: "m", min: 0, max: max || 1 };
    }
    case "curvature": return { ...base, label: "curvature 1/R", unit: "1/m", min: 0, table: heat, ...range_of_curvature(frames) };
    case "birth": return { ...base, label: "birth fiber", unit: "", min: 0, max: table_size, table: categories, categorical: true };
    case "break_age": return { ...base, label: "since the last break", unit: "s", min: 0, max: duration || 1, table: cooling };
    default: return { ...base, label: `angle to ${colouring.slice(-1)}`, unit: "deg", min: 0, max: 90 };
  }
}

function angle_to_axis(state: CellState, rod: number, axis: number): number {
  const d = [0, 1, 2].map((k) => state.ends[3 * rod + k]! - state.starts[3 * rod + k]!) as [number, number, number];
  const across = Math.hypot(...d.filter((_component, k) => k !== axis));
  return (Math.atan2(across, Math.abs(d[axis]!)) * 180) / Math.PI;
}

/** Makes the function that gives the values at both ends of a rod. */
function value_of(colouring: Colouring, state: CellState, breaks: BreakTimes): (rod: number, fiber: number) => [number, number] {
  const { frame, measures } = state;
  const both = (value: number): [number, number] => [value, value];
  switch (colouring) {
    case "length": return (_rod, fiber) => both(measures.length[fiber]!);
    case "curvature": return (rod) => [state.curvature[2 * rod]!, state.curvature[2 * rod + 1]!];
    case "birth": return (_rod, fiber) => both((((frame.birth[fiber]! % table_size) + table_size) % table_size) + 0.5);
    case "break_age": {
      // A fiber that never broke is as pale as one that broke before the beginning.
      const ages = Float32Array.from(frame.birth, (_birth, fiber) => breaks.age(frame, fiber, state.time_s) ?? 1e30);
      return (_rod, fiber) => both(ages[fiber]!);
    }
    default: {
      const axis = "xyz".indexOf(colouring.slice(-1));
      return (rod) => both(angle_to_axis(state, rod, axis));
    }
  }
}

export interface Coloured {
  colouring: Colouring;
  scale: ColourScale;
  breaks: BreakTimes;
}

/** Gives the place in the colour table, 0 to 1, at the start and end of every placed rod. */
export function colour_rods({ colouring, scale, breaks }: Coloured, state: CellState, placed: PlacedRods): Float32Array {
  const places = new Float32Array(2 * placed.count);
  const span = scale.max - scale.min;
  const value = value_of(colouring, state, breaks);
  for (let k = 0; k < placed.count; ++k) {
    const [start, end] = value(placed.rod[k]!, placed.fiber[k]!);
    places[2 * k] = (start - scale.min) / span;
    places[2 * k + 1] = (end - scale.min) / span;
  }
  return places;
}
