// The curves of a lines section: values scaled to the shown unit, with their ranges.
import { name_in_legend } from "../compared";
import { is_number, type LinesSection, type Scale, type Series, type Value } from "../document";
import { choose_unit, largest_magnitude, type ShownUnit } from "../format";
import { pad_range } from "../figure/ticks";

export interface Curve {
  label: string;
  /** Its name in a file, where no title stands beside it. */
  full_label: string;
  style: "line" | "dashed" | "points" | "filled";
  colour: number;
  visible: boolean;
  x: Value[];
  y: Value[];
  low?: Value[];
  high?: Value[];
  /** The last finite value of the document, unscaled. */
  last: Value;
  source: Series;
}

export interface Curves {
  curves: Curve[];
  x_unit: ShownUnit;
  y_unit: ShownUnit;
  x_label: string;
  y_label: string;
  /** A unit is as long on x as on y. */
  equal: boolean;
  /** Names of places along x, at 1, 2, 3, … */
  x_names?: string[];
}

function scale_all(values: Value[], factor: number): Value[] {
  return values.map((value) => (is_number(value) ? value * factor : null));
}

/** Scales a section's series to units that read well. */
export function make_curves(section: LinesSection): Curves {
  const shared = section.x.values ?? [];
  const equal = section.equal === true;
  const xs = section.series.flatMap((series) => series.x ?? shared);
  const ys = section.series.flatMap((series) => series.values);
  const x_unit = choose_unit(section.x.unit, largest_magnitude(equal ? [...xs, ...ys] : xs));
  const y_unit = equal ? x_unit : choose_unit(section.y.unit, largest_magnitude(ys));
  const curves = section.series.map((series, index): Curve => ({
    label: series.label,
    full_label: name_in_legend(section, series),
    style: section.kind === "scatter" ? "points" : (series.style ?? "line"),
    colour: series.colour ?? index,
    visible: true,
    x: scale_all(series.x ?? shared, x_unit.factor),
    y: scale_all(series.values, y_unit.factor),
    low: series.low && scale_all(series.low, y_unit.factor),
    high: series.high && scale_all(series.high, y_unit.factor),
    last: series.values.filter(is_number).at(-1) ?? null,
    source: series,
  }));
  return { curves, x_unit, y_unit, x_label: section.x.label, y_label: section.y.label, equal, x_names: section.x.names };
}

/** Tells whether a value has a place on a scale. */
export function fits(value: Value | undefined, scale: Scale): value is number {
  return is_number(value) && (scale === "linear" || value > 0);
}

/** Gives the runs of neighbouring points at which all of some arrays can be drawn; a missing value ends a run. */
export function split_runs(arrays: Value[][], scales: Scale[]): number[][] {
  const runs: number[][] = [];
  let run: number[] = [];
  const length = Math.max(0, ...arrays.map((array) => array.length));
  for (let k = 0; k < length; ++k) {
    if (arrays.every((array, which) => fits(array[k], scales[which]!))) run.push(k);
    else if (run.length > 0) {
      runs.push(run);
      run = [];
    }
  }
  return run.length > 0 ? [...runs, run] : runs;
}

/** Gives the padded range in y of the visible curves between two x. */
export function range_of_y(curves: Curve[], scale: Scale, from = -Infinity, to = Infinity): [number, number] {
  let min = Infinity;
  let max = -Infinity;
  for (const curve of curves) {
    if (!curve.visible) continue;
    curve.x.forEach((x, k) => {
      if (!is_number(x) || x < from || x > to) return;
      for (const value of [curve.y[k], curve.low?.[k], curve.high?.[k]]) {
        if (!fits(value, scale)) continue;
        min = Math.min(min, value);
        max = Math.max(max, value);
      }
    });
  }
  return pad_range(min, max, scale);
}

/** Gives the range in x of all curves, without room at the ends: time starts at the axis. */
export function range_of_x({ curves, x_names }: Curves, scale: Scale): [number, number] {
  if (x_names) return [0.5, x_names.length + 0.5];
  let min = Infinity;
  let max = -Infinity;
  for (const curve of curves) {
    for (const x of curve.x) {
      if (!fits(x, scale)) continue;
      min = Math.min(min, x);
      max = Math.max(max, x);
    }
  }
  const scattered = curves.some((curve) => curve.style === "points") && curves.every((curve) => curve.style === "points" || curve.x.length < 3);
  return min < max && !scattered ? [min, max] : pad_range(min, max, scale);
}

/** Widens one of two ranges about its middle until a unit is as long on both axes of a plot of this width over height. */
export function make_equal(x: [number, number], y: [number, number], shape: number): { x: [number, number]; y: [number, number] } {
  const widen = ([low, high]: [number, number], span: number): [number, number] => {
    const middle = (low + high) / 2;
    return span > high - low ? [middle - span / 2, middle + span / 2] : [low, high];
  };
  return { x: widen(x, (y[1] - y[0]) * shape), y: widen(y, (x[1] - x[0]) / shape) };
}
