// Which point of a curve is under the cursor.
import { is_number } from "../document";
import type { Curve } from "./curves";

/** Gives the index of the finite point nearest in x, or nothing for an empty curve. */
export function find_nearest(curve: Curve, x: number): number | undefined {
  let best: number | undefined;
  let distance = Infinity;
  curve.x.forEach((value, k) => {
    if (!is_number(value) || !is_number(curve.y[k])) return;
    const away = Math.abs(value - x);
    if (away >= distance) return;
    distance = away;
    best = k;
  });
  return best;
}
