// The frame of a vector figure: axes, ticks, titles, and the map from values to places.
import type { Scale } from "../document";
import { make_svg } from "../dom";
import { figure_font } from "../font";
import { split_label, write_label } from "../format";
import type { Palette } from "../palette";
import { lay_names, type NameLayout, widest_name } from "./names";
import type { FigureSize } from "./size";
import { make_ticks, write_ticks } from "./ticks";

export interface FrameAxis {
  title: string;
  min: number;
  max: number;
  scale: Scale;
  /** Names that stand at 1, 2, 3, … instead of numbers. */
  names?: string[];
}

export interface FrameRequest {
  x: FrameAxis;
  y: FrameAxis;
  palette: Palette;
  size: FigureSize;
  description: string;
  /** Room at the right for a colour bar. */
  right?: number;
  /** Room at the top for a legend. */
  top?: number;
  grid?: "both" | "none";
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

const y_apart = 5.2; // of ticks along y, over the size of the type

function ticks_of(axis: FrameAxis, length: number, apart: number): { at: number; text: string }[] {
  if (axis.names) return axis.names.map((text, k) => ({ at: k + 1, text }));
  const count = Math.max(3, Math.round(length / apart));
  const ticks = make_ticks(axis.min, axis.max, axis.scale, count);
  const texts = write_ticks(ticks);
  return ticks.map((at, k) => ({ at, text: texts[k]! }));
}

/** Sets a number or a name below its tick. */
function draw_tick_text(text: string, k: number, place: { x: number; y: number }, font: number, layout?: NameLayout): SVGElement {
  const { x, y } = place;
  if (!layout) return make_svg("text", { class: "tick-x", x, y: y + 1.3 * font, "text-anchor": "middle" }, text);
  if (layout.arrangement === "upright")
    return make_svg_text(text, { class: "tick-x", "data-at": x, x: x + 0.35 * font, y: y + 4, "text-anchor": "end", transform: `rotate(-90 ${x + 0.35 * font} ${y + 4})` });
  const row = layout.arrangement === "staggered" && k % 2 === 1 ? 1 : 0;
  return make_svg_text(text, { class: "tick-x", "data-at": x, x, y: y + (1.1 + 1.3 * row) * font, "text-anchor": "middle" });
}

function draw_ticks(frame: Frame, request: FrameRequest): void {
  const { palette, x, y, size } = request;
  const { font } = size;
  const axes = make_svg("g", { "font-size": font, fill: palette.muted, stroke: "none" });
  const grid = request.grid !== "none";
  const layout = layout_of(request);
  ticks_of(x, frame.right - frame.left, 7.9 * font).forEach(({ at: value, text }, k) => {
    const at = frame.to_x(value);
    const end = frame.bottom + 5;
    axes.append(make_svg("line", { x1: at, x2: at, y1: frame.bottom, y2: end, stroke: palette.muted }));
    if (!layout || k % layout.every === 0) axes.append(draw_tick_text(text, k, { x: at, y: end }, font, layout));
  });
  for (const { at: value, text } of ticks_of(y, frame.bottom - frame.top, y_apart * font)) {
    const at = frame.to_y(value);
    axes.append(make_svg("line", { x1: frame.left - 5, x2: frame.left, y1: at, y2: at, stroke: palette.muted }));
    if (grid) axes.append(make_svg("line", { x1: frame.left, x2: frame.right, y1: at, y2: at, stroke: palette.grid }));
    axes.append(make_svg_text(text, { class: "tick-y", "data-at": at, x: frame.left - 9, y: at + 0.35 * font, "text-anchor": "end" }));
  }
  const corner = `M${frame.left},${frame.top}V${frame.bottom}H${frame.right}`;
  axes.append(make_svg("path", { d: corner, fill: "none", stroke: palette.muted }));
  frame.svg.append(axes);
}

function draw_titles(frame: Frame, request: FrameRequest): void {
  const { font } = request.size;
  const middle = (frame.top + frame.bottom) / 2;
  const style = { "font-size": 1.08 * font, fill: request.palette.ink, "text-anchor": "middle" };
  const names = layout_of(request)?.extra ?? 0;
  const below = { ...style, x: (frame.left + frame.right) / 2, y: frame.bottom + names + 3.4 * font };
  const beside = { ...style, x: 1.3 * font, y: middle, transform: `rotate(-90 ${1.3 * font} ${middle})` };
  if (request.x.title) frame.svg.append(make_svg_text(request.x.title, below));
  if (request.y.title) frame.svg.append(make_svg_text(request.y.title, beside));
}

/** Room at the left: names and powers of ten may need more than most numbers. */
function left_of({ size, y }: FrameRequest): number {
  const title = size.titles === "drawn" ? 2 * size.font : 0;
  const texts = ticks_of(y, size.height - size.room.top - size.room.bottom, y_apart * size.font).map(({ text }) => text);
  return Math.max(size.room.left, widest_name(texts, size.font) + 14 + title);
}

function layout_of(request: FrameRequest): NameLayout | undefined {
  const { size, x, right } = request;
  return x.names && lay_names(x.names, size.width - left_of(request) - (right ?? size.room.right), size.font);
}

function place_edges(request: FrameRequest): { left: number; right: number; top: number; bottom: number } {
  const { size, right, top } = request;
  return {
    left: left_of(request),
    right: size.width - (right ?? size.room.right),
    top: size.room.top + (top ?? 0),
    bottom: size.height - size.room.bottom - (layout_of(request)?.extra ?? 0),
  };
}

/** Draws axes and titles and hands back the plot to draw in. */
export function make_frame(request: FrameRequest): Frame {
  const { size } = request;
  const edges = place_edges(request);
  const svg = make_svg("svg", {
    xmlns: "http://www.w3.org/2000/svg",
    viewBox: `0 0 ${size.width} ${size.height}`,
    width: size.width,
    height: size.height,
    "font-family": figure_font,
    role: "img",
    "aria-label": write_label(request.description),
    "data-left": edges.left,
    "data-right": edges.right,
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
  if (size.titles === "drawn") draw_titles(frame, request);
  return frame;
}
