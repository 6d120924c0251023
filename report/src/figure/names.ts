// How the names of places stand along an axis: in one row, in two, or upright, whichever first gives all of them room.
import { write_label } from "../format";

export interface NameLayout {
  arrangement: "level" | "staggered" | "upright";
  /** Height below the ticks beyond that of one row. */
  extra: number;
  /** Upright names that stand too close are told one of so many. */
  every: number;
}

/** Estimates the width of the widest name. */
export function widest_name(names: string[], font: number): number {
  return 0.58 * font * Math.max(0, ...names.map((name) => write_label(name).length));
}

export function lay_names(names: string[], width: number, font: number): NameLayout {
  const apart = width / Math.max(1, names.length);
  const widest = widest_name(names, font);
  if (widest + 0.6 * font <= apart) return { arrangement: "level", extra: 0, every: 1 };
  if (widest + 0.6 * font <= 2 * apart) return { arrangement: "staggered", extra: 1.3 * font, every: 1 };
  return { arrangement: "upright", extra: widest - 0.6 * font, every: Math.max(1, Math.ceil((1.3 * font) / apart)) };
}
