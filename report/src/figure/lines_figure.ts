// Curves as a vector figure, for print and for papers.
import type { Curve, Curves } from "../chart/curves";
import { fits, range_of_x, range_of_y } from "../chart/curves";
import type { Scale, Value } from "../document";
import { make_svg } from "../dom";
import { write_axis_title } from "../format";
import type { Palette } from "../palette";
import { type Frame, make_frame } from "./frame";
import { draw_legend, measure_legend } from "./legend";

export interface View {
  x_scale: Scale;
  y_scale: Scale;
  /** The zoomed range of x, or nothing for all. */
  x_range?: [number, number];
}

function trace(frame: Frame, xs: Value[], ys: Value[], view: View): string {
  let path = "";
  let pen_down = false;
  ys.forEach((y, k) => {
    const x = xs[k];
    const drawn = fits(x, view.x_scale) && fits(y, view.y_scale);
    if (drawn) path += `${pen_down ? "L" : "M"}${frame.to_x(x).toFixed(2)},${frame.to_y(y).toFixed(2)}`;
    pen_down = drawn;
  });
  return path;
}

function draw_band(frame: Frame, curve: Curve, view: View, colour: string): void {
  if (!curve.low || !curve.high) return;
  const forth = trace(frame, curve.x, curve.high, view);
  const back = trace(frame, [...curve.x].reverse(), [...curve.low].reverse(), view).replace("M", "L");
  frame.plot.append(make_svg("path", { d: `${forth}${back}Z`, fill: colour, "fill-opacity": 0.16 }));
}

function draw_curve(frame: Frame, curve: Curve, view: View, colour: string): void {
  draw_band(frame, curve, view, colour);
  if (curve.style !== "points") {
    frame.plot.append(make_svg("path", {
      d: trace(frame, curve.x, curve.y, view), fill: "none", stroke: colour, "stroke-width": 2,
      "stroke-linejoin": "round", "stroke-dasharray": curve.style === "dashed" ? "6 4" : undefined,
    }));
    return;
  }
  curve.y.forEach((y, k) => {
    const x = curve.x[k];
    if (!fits(x, view.x_scale) || !fits(y, view.y_scale)) return;
    frame.plot.append(make_svg("circle", {
      cx: frame.to_x(x).toFixed(2), cy: frame.to_y(y).toFixed(2), r: 3.2, fill: colour, "fill-opacity": 0.85,
    }));
  });
}

/** Draws the visible curves as the reader has zoomed and scaled them. */
export function draw_lines(title: string, made: Curves, view: View, palette: Palette): SVGSVGElement {
  const shown = made.curves.filter((curve) => curve.visible);
  const x_range = view.x_range ?? range_of_x(made.curves, view.x_scale);
  const y_range = range_of_y(shown, view.y_scale, ...x_range);
  const colour_of = (curve: Curve): string => palette.series[curve.colour % palette.series.length]!;
  const entries = shown.map((curve) => ({ label: curve.label, colour: colour_of(curve), mark: curve.style }));
  const frame = make_frame({
    x: { title: write_axis_title(made.x_label, made.x_unit.unit), min: x_range[0], max: x_range[1], scale: view.x_scale },
    y: { title: write_axis_title(made.y_label, made.y_unit.unit), min: y_range[0], max: y_range[1], scale: view.y_scale },
    palette,
    description: `${title}: ${made.y_label} against ${made.x_label}`,
    top: measure_legend(entries),
  });
  for (const curve of shown) draw_curve(frame, curve, view, colour_of(curve));
  draw_legend(frame.svg, entries, palette);
  return frame.svg;
}
