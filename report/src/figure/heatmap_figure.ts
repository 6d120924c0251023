// A field over two axes as a vector figure, with its colour bar.
import { type HeatmapSection, is_number, type Value } from "../document";
import { make_svg } from "../dom";
import { choose_unit, largest_magnitude, write_axis_title, write_number, write_quantity } from "../format";
import { css_colour, type Palette, sample_map } from "../palette";
import { type Frame, make_frame, make_svg_text } from "./frame";
import type { FigureSize } from "./size";
import { bar_ticks } from "./ticks";

/** Gives the borders of cells whose middles are known: halfway between, and as far out at the ends. */
function borders_of(middles: number[]): number[] {
  if (middles.length === 1) return [middles[0]! - 0.5, middles[0]! + 0.5];
  const between = middles.slice(1).map((value, k) => (value + middles[k]!) / 2);
  const first = 2 * middles[0]! - between[0]!;
  const last = 2 * middles.at(-1)! - between.at(-1)!;
  return [first, ...between, last];
}

function axis_values(axis: { values?: Value[] }, count: number): number[] {
  return Array.from({ length: count }, (_unused, k) => {
    const value = axis.values?.[k];
    return is_number(value) ? value : k;
  });
}

interface Range {
  min: number;
  max: number;
}

function range_of(values: Value[][]): Range {
  const range = { min: Infinity, max: -Infinity };
  for (const row of values) {
    for (const value of row) {
      if (!is_number(value)) continue;
      range.min = Math.min(range.min, value);
      range.max = Math.max(range.max, value);
    }
  }
  if (range.min > range.max) return { min: 0, max: 1 };
  return range.min === range.max ? { min: range.min, max: range.min + 1 } : range;
}

function draw_bar(frame: Frame, section: HeatmapSection, range: Range, { palette, font }: { palette: Palette; font: number }): void {
  const left = frame.right + 18;
  const height = frame.bottom - frame.top;
  const unit = choose_unit(section.unit, Math.max(Math.abs(range.min), Math.abs(range.max)));
  const steps = 64;
  for (let k = 0; k < steps; ++k) {
    frame.svg.append(make_svg("rect", {
      x: left, width: 14, y: frame.bottom - (height * (k + 1)) / steps, height: height / steps + 0.6,
      fill: css_colour(sample_map("viridis", (k + 0.5) / steps)),
    }));
  }
  for (const tick of bar_ticks(range.min * unit.factor, range.max * unit.factor)) {
    const at = frame.bottom - (height * (tick / unit.factor - range.min)) / (range.max - range.min);
    const place = { class: "tick-bar", x: left + 20, y: at + 0.35 * font, "font-size": font, fill: palette.muted };
    frame.svg.append(make_svg("text", place, write_number(tick, 3)));
  }
  const middle = (frame.top + frame.bottom) / 2;
  const title = write_axis_title(section.label ?? "", unit.unit);
  frame.svg.append(make_svg_text(title, {
    x: left + 5.9 * font, y: middle, "font-size": 1.08 * font, fill: palette.ink, "text-anchor": "middle",
    transform: `rotate(-90 ${left + 5.9 * font} ${middle})`,
  }));
}

/** Titles the axes in the units of the figure. */
export function heatmap_titles(section: HeatmapSection): { x: string; y: string } {
  const columns = section.values[0]?.length ?? 0;
  const x_unit = choose_unit(section.x.unit, largest_magnitude(axis_values(section.x, columns)));
  const y_unit = choose_unit(section.y.unit, largest_magnitude(axis_values(section.y, section.values.length)));
  return { x: write_axis_title(section.x.label, x_unit.unit), y: write_axis_title(section.y.label, y_unit.unit) };
}

/** Draws `values[row][column]`, rows along y and columns along x. */
export function draw_heatmap(section: HeatmapSection, palette: Palette, size: FigureSize): SVGSVGElement {
  const columns = section.values[0]?.length ?? 0;
  const xs = axis_values(section.x, columns);
  const ys = axis_values(section.y, section.values.length);
  const x_unit = choose_unit(section.x.unit, largest_magnitude(xs));
  const y_unit = choose_unit(section.y.unit, largest_magnitude(ys));
  const x_borders = borders_of(xs).map((value) => value * x_unit.factor);
  const y_borders = borders_of(ys).map((value) => value * y_unit.factor);
  const range = range_of(section.values);
  const titles = heatmap_titles(section);
  const frame = make_frame({
    x: { title: titles.x, min: x_borders[0]!, max: x_borders.at(-1)!, scale: "linear" },
    y: { title: titles.y, min: y_borders[0]!, max: y_borders.at(-1)!, scale: "linear" },
    palette, size, description: section.title, right: 26 + 6.6 * size.font, grid: "none",
  });
  section.values.forEach((row, j) => row.forEach((value, i) => {
    if (!is_number(value)) return;
    const fraction = (value - range.min) / (range.max - range.min);
    const left = Math.min(frame.to_x(x_borders[i]!), frame.to_x(x_borders[i + 1]!));
    const top = Math.min(frame.to_y(y_borders[j]!), frame.to_y(y_borders[j + 1]!));
    const label = `${section.x.label} ${write_quantity(xs[i], section.x.unit)}, ${section.y.label} ${write_quantity(ys[j], section.y.unit)}: ${write_quantity(value, section.unit)}`;
    // A little overlap hides the hairlines that antialiasing leaves between neighbours.
    frame.plot.append(make_svg("rect", {
      x: left, y: top, class: "cell",
      width: Math.abs(frame.to_x(x_borders[i + 1]!) - frame.to_x(x_borders[i]!)) + 0.4,
      height: Math.abs(frame.to_y(y_borders[j + 1]!) - frame.to_y(y_borders[j]!)) + 0.4,
      fill: css_colour(sample_map("viridis", fraction)), "data-value": value,
    }, make_svg("title", {}, label)));
  }));
  draw_bar(frame, section, range, { palette, font: size.font });
  return frame.svg;
}
