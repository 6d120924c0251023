// Curves as a vector figure, for print and for papers.
import type { Curve, Curves } from "../chart/curves";
import { make_equal, range_of_x, range_of_y, split_runs } from "../chart/curves";
import type { Scale, Value } from "../document";
import { make_svg } from "../dom";
import { write_axis_title } from "../format";
import type { Palette } from "../palette";
import { type Frame, make_frame } from "./frame";
import { draw_legend, measure_legend } from "./legend";
import { type FigureSize, picture_size } from "./size";

export interface View {
  x_scale: Scale;
  y_scale: Scale;
  /** The zoomed range of x, or nothing for all. */
  x_range?: [number, number];
  /** Curves are named as for a file that stands alone. */
  full_labels?: boolean;
}

function place(frame: Frame, xs: Value[], ys: Value[], k: number): string {
  return `${frame.to_x(xs[k]!).toFixed(2)},${frame.to_y(ys[k]!).toFixed(2)}`;
}

function draw_band(frame: Frame, curve: Curve, view: View, colour: string): void {
  const { x, low, high } = curve;
  if (!low || !high) return;
  let path = "";
  for (const run of split_runs([x, low, high], [view.x_scale, view.y_scale, view.y_scale])) {
    const forth = run.map((k) => place(frame, x, high, k));
    const back = run.reverse().map((k) => place(frame, x, low, k));
    path += `M${[...forth, ...back].join("L")}Z`;
  }
  frame.plot.append(make_svg("path", { class: "band", d: path, fill: colour, "fill-opacity": 0.16 }));
}

function draw_points(frame: Frame, curve: Curve, view: View, colour: string): void {
  const { x, y, low, high } = curve;
  if (low && high) {
    const bars = split_runs([x, low, high], [view.x_scale, view.y_scale, view.y_scale]).flat()
      .map((k) => `M${place(frame, x, low, k)}L${place(frame, x, high, k)}`);
    frame.plot.append(make_svg("path", { class: "bar", d: bars.join(""), fill: "none", stroke: colour, "stroke-width": 1.4 }));
  }
  for (const k of split_runs([x, y], [view.x_scale, view.y_scale]).flat()) {
    const [cx, cy] = place(frame, x, y, k).split(",");
    frame.plot.append(make_svg("circle", { "data-series": curve.label, cx, cy, r: 3.2, fill: colour, "fill-opacity": 0.85 }));
  }
}

function draw_curve(frame: Frame, curve: Curve, view: View, colour: string, width: number): void {
  if (curve.style === "points") return draw_points(frame, curve, view, colour);
  draw_band(frame, curve, view, colour);
  const runs = split_runs([curve.x, curve.y], [view.x_scale, view.y_scale]);
  if (curve.style === "filled") {
    const outlines = runs.map((run) => `M${run.map((k) => place(frame, curve.x, curve.y, k)).join("L")}Z`);
    frame.plot.append(make_svg("path", { "data-series": curve.label, d: outlines.join(""), fill: colour }));
    return;
  }
  const lines = runs.map((run) => `M${run.map((k) => place(frame, curve.x, curve.y, k)).join("L")}${run.length === 1 ? "h2" : ""}`);
  frame.plot.append(make_svg("path", {
    "data-series": curve.label, d: lines.join(""), fill: "none", stroke: colour, "stroke-width": width,
    "stroke-linejoin": "round", "stroke-dasharray": curve.style === "dashed" ? "6 4" : undefined,
  }));
}

/** Draws the visible curves as the reader has zoomed and scaled them. */
export function draw_lines(title: string, made: Curves, view: View, palette: Palette, asked: FigureSize): SVGSVGElement {
  const size = made.equal ? picture_size(asked) : asked;
  const shown = made.curves.filter((curve) => curve.visible);
  let x_range = view.x_range ?? range_of_x(made, view.x_scale);
  let y_range = range_of_y(shown, view.y_scale, ...x_range);
  const colour_of = (curve: Curve): string => palette.series[curve.colour % palette.series.length]!;
  const entries = shown.map((curve) => ({ label: view.full_labels ? curve.full_label : curve.label, colour: colour_of(curve), mark: curve.style }));
  const top = measure_legend(entries, size);
  if (made.equal) {
    const { width, height, room } = size;
    ({ x: x_range, y: y_range } = make_equal(x_range, y_range, (width - room.left - room.right) / (height - top - room.top - room.bottom)));
  }
  const frame = make_frame({
    x: { title: write_axis_title(made.x_label, made.x_unit.unit), min: x_range[0], max: x_range[1], scale: view.x_scale, names: made.x_names },
    y: { title: write_axis_title(made.y_label, made.y_unit.unit), min: y_range[0], max: y_range[1], scale: view.y_scale },
    palette, size, top,
    description: `${title}: ${made.y_label} against ${made.x_label}`,
  });
  for (const curve of shown) draw_curve(frame, curve, view, colour_of(curve), made.equal ? 1.2 : 2);
  draw_legend(frame.svg, entries, palette, size);
  return frame.svg;
}
