// The frame of a vector figure: axes, ticks, titles, and the map from values to places.
import type { Scale } from "../document";
import { make_svg } from "../dom";
import { split_label, write_number } from "../format";
import type { Palette } from "../palette";
import { make_ticks } from "./ticks";

export interface FrameAxis {
  title: string;
  min: number;
  max: number;
  scale: Scale;
}

export interface FrameRequest {
  x: FrameAxis;
  y: FrameAxis;
  palette: Palette;
  description: string;
  /** Room at the right for a colour bar. */
  right?: number;
  /** Room at the top for a legend. */
  top?: number;
  grid?: "both" | "none";
  height?: number;
}

export interface Frame {
  svg: SVGSVGElement;
  /** Draw here; what leaves the plot is clipped. */
  plot: SVGGElement;
  to_x: (value: number) => number;
  to_y: (value: number) => number;
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export const figure_width = 720;
export const figure_height = 400;
/** Room around the plot for ticks and titles. */
export const room = { left: 78, right: 14, top: 14, bottom: 56 };
export const figure_font = "'Helvetica Neue', Helvetica, Arial, 'DejaVu Sans', sans-serif";

let clips = 0;

function make_map(axis: FrameAxis, from: number, to: number): (value: number) => number {
  const warp = axis.scale === "log" ? Math.log10 : (value: number): number => value;
  const low = warp(axis.min);
  const span = warp(axis.max) - low || 1;
  return (value) => from + ((warp(value) - low) / span) * (to - from);
}

/** Sets a label with subscripts in SVG. */
export function make_svg_text(label: string, attributes: Record<string, string | number>): SVGTextElement {
  const text = make_svg("text", attributes);
  let raised = false;
  for (const part of split_label(label)) {
    const shift = part.subscript ? "0.25em" : raised ? "-0.18em" : undefined;
    text.append(make_svg("tspan", { dy: shift, "font-size": part.subscript ? "72%" : undefined }, part.text));
    raised = part.subscript;
  }
  return text;
}

function draw_ticks(frame: Frame, request: FrameRequest): void {
  const { palette, x, y } = request;
  const axes = make_svg("g", { "font-size": 13, fill: palette.muted, stroke: "none" });
  const grid = request.grid !== "none";
  for (const tick of make_ticks(x.min, x.max, x.scale, 7)) {
    const at = frame.to_x(tick);
    const end = frame.bottom + 5;
    axes.append(make_svg("line", { x1: at, x2: at, y1: frame.bottom, y2: end, stroke: palette.muted }));
    axes.append(make_svg("text", { class: "tick-x", x: at, y: end + 14, "text-anchor": "middle" }, write_number(tick)));
  }
  for (const tick of make_ticks(y.min, y.max, y.scale, 5)) {
    const at = frame.to_y(tick);
    const from = grid ? frame.right : frame.left;
    axes.append(make_svg("line", { x1: frame.left - 5, x2: frame.left, y1: at, y2: at, stroke: palette.muted }));
    if (grid) axes.append(make_svg("line", { x1: frame.left, x2: from, y1: at, y2: at, stroke: palette.grid }));
    axes.append(make_svg("text", { class: "tick-y", x: frame.left - 9, y: at + 4.5, "text-anchor": "end" }, write_number(tick)));
  }
  const corner = `M${frame.left},${frame.top}V${frame.bottom}H${frame.right}`;
  axes.append(make_svg("path", { d: corner, fill: "none", stroke: palette.muted }));
  frame.svg.append(axes);
}

function draw_titles(frame: Frame, request: FrameRequest): void {
  const middle = (frame.top + frame.bottom) / 2;
  const style = { "font-size": 14, fill: request.palette.ink, "text-anchor": "middle" };
  const below = { ...style, x: (frame.left + frame.right) / 2, y: frame.bottom + 42 };
  const beside = { ...style, x: 18, y: middle, transform: `rotate(-90 18 ${middle})` };
  frame.svg.append(make_svg_text(request.x.title, below), make_svg_text(request.y.title, beside));
}

/** Draws axes and titles and hands back the plot to draw in. */
export function make_frame(request: FrameRequest): Frame {
  const height = request.height ?? figure_height;
  const edges = {
    left: room.left,
    right: figure_width - (request.right ?? room.right),
    top: room.top + (request.top ?? 0),
    bottom: height - room.bottom,
  };
  const svg = make_svg("svg", {
    xmlns: "http://www.w3.org/2000/svg",
    viewBox: `0 0 ${figure_width} ${height}`,
    width: figure_width,
    height,
    "font-family": figure_font,
    role: "img",
    "aria-label": request.description,
  });
  const clip = `clip-${++clips}`;
  const { left, right, top, bottom } = edges;
  // Points on the border are drawn whole.
  const slack = 4;
  const box = make_svg("rect", {
    x: left - slack, y: top - slack, width: right - left + 2 * slack, height: bottom - top + 2 * slack,
  });
  const plot = make_svg("g", { "clip-path": `url(#${clip})` });
  const frame = {
    svg, plot, ...edges,
    to_x: make_map(request.x, left, right),
    to_y: make_map(request.y, bottom, top),
  };
  svg.append(make_svg("defs", {}, make_svg("clipPath", { id: clip }, box)));
  draw_ticks(frame, request);
  svg.append(plot);
  draw_titles(frame, request);
  return frame;
}
