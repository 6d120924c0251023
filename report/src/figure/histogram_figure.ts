// A histogram as a vector figure: one filled frame, or several laid over each other.
import { type HistogramSection, is_number, type Series, type Value } from "../document";
import { make_svg } from "../dom";
import { choose_unit, largest_magnitude, write_axis_title, write_number } from "../format";
import { css_colour, type Palette, sample_map } from "../palette";
import { type Frame, make_frame } from "./frame";
import { draw_legend, type LegendEntry, measure_legend } from "./legend";
import type { FigureSize } from "./size";
import { pad_range } from "./ticks";

/** Colours times along a map from early to late; a lone time has the first series colour. */
export function frame_colour(index: number, count: number, palette: Palette): string {
  if (count === 1) return palette.series[0]!;
  return css_colour(sample_map("viridis", 0.12 + (0.7 * index) / (count - 1)));
}

function outline(frame: Frame, edges: number[], values: Value[], base: number): string {
  let path = "";
  values.forEach((value, bin) => {
    const height = frame.to_y(is_number(value) ? value : base);
    path += `${bin === 0 ? `M${frame.to_x(edges[0]!)},${frame.to_y(base)}` : ""}V${height}H${frame.to_x(edges[bin + 1]!)}`;
  });
  return `${path}V${frame.to_y(base)}`;
}

function draw_bars(frame: Frame, section: HistogramSection, chosen: number, colour: string, scaled: number[]): void {
  const shown = section.frames[chosen]!;
  const group = make_svg("g", { class: "bars", "data-frame": shown.label, fill: colour, "fill-opacity": 0.55 });
  shown.values.forEach((value, bin) => {
    const left = frame.to_x(scaled[bin]!);
    const width = frame.to_x(scaled[bin + 1]!) - left;
    const top = frame.to_y(is_number(value) ? value : 0);
    const label = `${shown.label}: ${write_number(scaled[bin])} to ${write_number(scaled[bin + 1])}, ${write_number(value)}`;
    const bar = make_svg(
      "rect",
      { x: left, width: Math.max(0, width), y: top, height: Math.max(0, frame.to_y(0) - top), "data-value": value ?? "" },
      make_svg("title", {}, label),
    );
    group.append(bar);
  });
  frame.plot.append(group);
  frame.plot.append(make_svg("path", {
    d: outline(frame, scaled, shown.values, 0), fill: "none", stroke: colour, "stroke-width": 1.8,
  }));
}

/** What of a histogram is drawn: numbers of its frames and of its curves. */
export interface Chosen {
  frames: number[];
  curves: number[];
}

/** Curves are lines over bars: their colours follow those of the bars. */
export function curve_colour(section: HistogramSection, index: number, palette: Palette): string {
  return palette.series[(1 + (section.curves?.[index]?.colour ?? index)) % palette.series.length]!;
}

function draw_curve(frame: Frame, curve: Series, factor: number, colour: string): void {
  let path = "";
  let pen = "M";
  curve.values.forEach((y, k) => {
    const x = curve.x?.[k];
    if (!is_number(x) || !is_number(y)) {
      pen = "M";
      return;
    }
    path += `${pen}${frame.to_x(x * factor).toFixed(2)},${frame.to_y(y).toFixed(2)}`;
    pen = "L";
  });
  frame.plot.append(make_svg("path", {
    class: "curve", "data-series": curve.label, d: path, fill: "none", stroke: colour, "stroke-width": 2, "stroke-linejoin": "round",
    "stroke-dasharray": curve.style === "dashed" ? "6 4" : undefined,
  }));
}

/** Titles the axes in the units of the figure. */
export function histogram_titles(section: HistogramSection): { x: string; y: string } {
  return {
    x: write_axis_title(section.x.label, choose_unit(section.x.unit, largest_magnitude(section.edges)).unit),
    y: write_axis_title(section.y.label, choose_unit(section.y.unit, 0).unit),
  };
}

function list_entries(section: HistogramSection, chosen: Chosen, palette: Palette): LegendEntry[] {
  const { frames, reference, curves = [] } = section;
  const entries: LegendEntry[] = chosen.frames.map((index) => ({
    label: frames[index]!.label, colour: frame_colour(index, frames.length, palette), mark: "box",
  }));
  for (const index of chosen.curves) {
    const mark = curves[index]!.style === "dashed" ? "dashed" : "line";
    entries.push({ label: curves[index]!.label, colour: curve_colour(section, index, palette), mark });
  }
  if (reference) entries.push({ label: reference.label, colour: palette.ink, mark: "dashed" });
  return entries;
}

/** Draws the chosen frames of a histogram, curves over them, and its reference as a dashed outline. */
export function draw_histogram(section: HistogramSection, chosen: Chosen, palette: Palette, size: FigureSize): SVGSVGElement {
  const { frames, reference, edges, curves = [] } = section;
  const x_unit = choose_unit(section.x.unit, largest_magnitude(edges));
  const titles = histogram_titles(section);
  const legend = size.titles === "drawn";
  const scaled = edges.map((edge) => edge * x_unit.factor);
  // All frames share the height, so that times can be compared by switching.
  const every = [...frames, ...curves, ...(reference ? [reference] : [])].flatMap(({ values }) => values);
  const entries = list_entries(section, chosen, palette);
  const frame = make_frame({
    x: { title: titles.x, min: scaled[0]!, max: scaled.at(-1)!, scale: "linear" },
    y: {
      title: titles.y, min: 0, max: pad_range(0, largest_magnitude(every), "linear")[1], scale: "linear",
    },
    palette, size,
    description: `${section.title}: histogram of ${section.x.label} at ${chosen.frames.map((index) => frames[index]!.label).join(", ")}`,
    top: legend ? measure_legend(entries, size) : 0,
  });
  for (const index of chosen.frames) draw_bars(frame, section, index, frame_colour(index, frames.length, palette), scaled);
  if (reference) {
    frame.plot.append(make_svg("path", {
      class: "reference", d: outline(frame, scaled, reference.values, 0), fill: "none",
      stroke: palette.ink, "stroke-width": 1.6, "stroke-dasharray": "6 4",
    }));
  }
  for (const index of chosen.curves) draw_curve(frame, curves[index]!, x_unit.factor, curve_colour(section, index, palette));
  if (legend) draw_legend(frame.svg, entries, palette, size);
  return frame.svg;
}
