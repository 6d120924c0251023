// A field over two axes as a vector figure, with its colour bar.
import { make_equal } from "../chart/curves";
import { type Axis, type HeatmapSection, is_number } from "../document";
import { make_svg } from "../dom";
import { choose_unit, largest_magnitude, type ShownUnit, write_axis_title, write_number, write_quantity } from "../format";
import { type ColourMap, css_colour, type Palette, sample_map } from "../palette";
import { type Frame, make_frame, make_svg_text } from "./frame";
import { type FigureSize, picture_size } from "./size";
import { bar_range, bar_ticks, write_ticks } from "./ticks";

/** Gives the borders of cells whose middles are known: halfway between, and as far out at the ends. */
function borders_of(middles: number[]): number[] {
  if (middles.length === 1) return [middles[0]! - 0.5, middles[0]! + 0.5];
  const between = middles.slice(1).map((value, k) => (value + middles[k]!) / 2);
  const first = 2 * middles[0]! - between[0]!;
  const last = 2 * middles.at(-1)! - between.at(-1)!;
  return [first, ...between, last];
}

function axis_values(axis: Axis, count: number): number[] {
  return Array.from({ length: count }, (_unused, k) => {
    const value = axis.values?.[k];
    return is_number(value) ? value : axis.names ? k + 1 : k;
  });
}

interface Range {
  min: number;
  max: number;
}

function range_of(section: HeatmapSection): Range {
  if (section.range) return { min: section.range[0], max: section.range[1] };
  const range = { min: Infinity, max: -Infinity };
  for (const row of section.values) {
    for (const value of row) {
      if (!is_number(value)) continue;
      range.min = Math.min(range.min, value);
      range.max = Math.max(range.max, value);
    }
  }
  if (range.min > range.max) return { min: 0, max: 1 };
  if (range.min === range.max) return { min: range.min, max: range.min + 1 };
  const [min, max] = bar_range(range.min, range.max);
  return { min, max };
}

function map_of(section: HeatmapSection): ColourMap {
  return section.colours === "diverging" ? "diverging" : "viridis";
}

/** Writes a value into its cell, dark on pale colours and pale on dark ones. */
function write_cell(frame: Frame, at: { x: number; y: number }, value: number, [red, green, blue]: number[], font: number): void {
  const light = 0.3 * red! + 0.59 * green! + 0.11 * blue! > 140;
  const place = { class: "cell-value", x: at.x, y: at.y + 0.35 * font, "font-size": font, "text-anchor": "middle" };
  frame.plot.append(make_svg("text", { ...place, fill: light ? "#1b1f24" : "#ffffff" }, write_number(value, 2)));
}

function draw_bar(frame: Frame, section: HeatmapSection, range: Range, { palette, font }: { palette: Palette; font: number }): void {
  const left = frame.right + 18;
  const height = frame.bottom - frame.top;
  const unit = choose_unit(section.unit, Math.max(Math.abs(range.min), Math.abs(range.max)));
  const steps = 64;
  for (let k = 0; k < steps; ++k) {
    frame.svg.append(make_svg("rect", {
      x: left, width: 14, y: frame.bottom - (height * (k + 1)) / steps, height: height / steps + 0.6,
      fill: css_colour(sample_map(map_of(section), (k + 0.5) / steps)),
    }));
  }
  const ticks = bar_ticks(range.min * unit.factor, range.max * unit.factor);
  const texts = write_ticks(ticks);
  for (const [k, tick] of ticks.entries()) {
    const at = frame.bottom - (height * (tick / unit.factor - range.min)) / (range.max - range.min);
    const place = { class: "tick-bar", x: left + 20, y: at + 0.35 * font, "font-size": font, fill: palette.muted };
    frame.svg.append(make_svg("text", place, texts[k]!));
  }
  const middle = (frame.top + frame.bottom) / 2;
  const title = write_axis_title(section.label ?? "", unit.unit);
  frame.svg.append(make_svg_text(title, {
    x: left + 5.9 * font, y: middle, "font-size": 1.08 * font, fill: palette.ink, "text-anchor": "middle",
    transform: `rotate(-90 ${left + 5.9 * font} ${middle})`,
  }));
}

/** Both axes of a picture of things are in one unit. */
function units_of(section: HeatmapSection, xs: number[], ys: number[]): [ShownUnit, ShownUnit] {
  const every = section.equal ? [...xs, ...ys] : undefined;
  return [choose_unit(section.x.unit, largest_magnitude(every ?? xs)), choose_unit(section.y.unit, largest_magnitude(every ?? ys))];
}

/** Titles the axes in the units of the figure. */
export function heatmap_titles(section: HeatmapSection): { x: string; y: string } {
  const columns = section.values[0]?.length ?? 0;
  const [x_unit, y_unit] = units_of(section, axis_values(section.x, columns), axis_values(section.y, section.values.length));
  return { x: write_axis_title(section.x.label, x_unit.unit), y: write_axis_title(section.y.label, y_unit.unit) };
}

function tell_place(axis: Axis, value: number, k: number): string {
  return axis.names ? `${axis.label} ${axis.names[k] ?? ""}`.trim() : `${axis.label} ${write_quantity(value, axis.unit)}`;
}

function middle_of(frame: Frame, xs: number[], ys: number[], i: number, j: number): { x: number; y: number } {
  return { x: frame.to_x((xs[i]! + xs[i + 1]!) / 2), y: frame.to_y((ys[j]! + ys[j + 1]!) / 2) };
}

type Span = [number, number];

function spans_of(section: HeatmapSection, x: Span, y: Span, size: FigureSize & { right: number }): { x: Span; y: Span } {
  if (!section.equal) return { x, y };
  return make_equal(x, y, (size.width - size.room.left - size.right) / (size.height - size.room.top - size.room.bottom));
}

/** Draws `values[row][column]`, rows along y and columns along x. */
export function draw_heatmap(section: HeatmapSection, palette: Palette, asked: FigureSize): SVGSVGElement {
  const size = section.equal ? picture_size(asked) : asked;
  const columns = section.values[0]?.length ?? 0;
  const xs = axis_values(section.x, columns);
  const ys = axis_values(section.y, section.values.length);
  const [x_unit, y_unit] = units_of(section, xs, ys);
  const x_borders = borders_of(xs).map((value) => value * x_unit.factor);
  const y_borders = borders_of(ys).map((value) => value * y_unit.factor);
  const range = range_of(section);
  const titles = heatmap_titles(section);
  const right = 26 + 6.6 * size.font;
  const spans = spans_of(section, [x_borders[0]!, x_borders.at(-1)!], [y_borders[0]!, y_borders.at(-1)!], { ...size, right });
  const frame = make_frame({
    x: { title: titles.x, min: spans.x[0], max: spans.x[1], scale: "linear", names: section.x.names },
    y: { title: titles.y, min: spans.y[0], max: spans.y[1], scale: "linear", names: section.y.names },
    palette, size, description: section.title, right, grid: "none",
  });
  section.values.forEach((row, j) => row.forEach((value, i) => {
    if (!is_number(value)) return;
    const fraction = (value - range.min) / (range.max - range.min);
    const left = Math.min(frame.to_x(x_borders[i]!), frame.to_x(x_borders[i + 1]!));
    const top = Math.min(frame.to_y(y_borders[j]!), frame.to_y(y_borders[j + 1]!));
    const colour = sample_map(map_of(section), Math.min(1, Math.max(0, fraction)));
    const label = `${tell_place(section.x, xs[i]!, i)}, ${tell_place(section.y, ys[j]!, j)}: ${write_quantity(value, section.unit)}`;
    // A little overlap hides the hairlines that antialiasing leaves between neighbours.
    frame.plot.append(make_svg("rect", {
      x: left, y: top, class: "cell",
      width: Math.abs(frame.to_x(x_borders[i + 1]!) - frame.to_x(x_borders[i]!)) + 0.4,
      height: Math.abs(frame.to_y(y_borders[j + 1]!) - frame.to_y(y_borders[j]!)) + 0.4,
      fill: css_colour(colour), "data-value": value,
    }, make_svg("title", {}, label)));
    if (section.written) write_cell(frame, middle_of(frame, x_borders, y_borders, i, j), value, colour, size.font);
  }));
  draw_bar(frame, section, range, { palette, font: size.font });
  return frame.svg;
}
