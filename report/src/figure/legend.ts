// The legend of a vector figure: a row of samples and names above the plot.
import { make_svg } from "../dom";
import { split_label } from "../format";
import type { Palette } from "../palette";
import { make_svg_text } from "./frame";
import type { FigureSize } from "./size";

export interface LegendEntry {
  label: string;
  colour: string;
  mark: "line" | "dashed" | "points" | "box" | "filled";
}

const row_height = 1.7; // over the size of the type

function estimate_width(label: string, font: number): number {
  return 44 + 0.56 * font * split_label(label).reduce((sum, part) => sum + part.text.length, 0);
}

function place(entries: LegendEntry[], size: FigureSize): { x: number; y: number }[] {
  const { left } = size.room;
  let x = left;
  let y = 1.4 * size.font;
  return entries.map(({ label }) => {
    const width = estimate_width(label, size.font);
    if (x > left && x + width > size.width) {
      x = left;
      y += row_height * size.font;
    }
    const at = { x, y };
    x += width;
    return at;
  });
}

/** Gives the height that a legend takes. */
export function measure_legend(entries: LegendEntry[], size: FigureSize): number {
  if (entries.length === 0) return 0;
  return Math.max(...place(entries, size).map(({ y }) => y)) + 4;
}

function draw_mark(entry: LegendEntry, x: number, y: number): SVGElement {
  const { colour, mark } = entry;
  if (mark === "box" || mark === "filled") return make_svg("rect", { x, y: y - 6, width: 20, height: 12, fill: colour, "fill-opacity": 0.6 });
  if (mark === "points") return make_svg("circle", { cx: x + 10, cy: y, r: 3.5, fill: colour });
  const dash = mark === "dashed" ? "6 4" : undefined;
  return make_svg("line", {
    x1: x, x2: x + 22, y1: y, y2: y, stroke: colour, "stroke-width": 2, "stroke-dasharray": dash,
  });
}

export function draw_legend(svg: SVGSVGElement, entries: LegendEntry[], palette: Palette, size: FigureSize): void {
  const places = place(entries, size);
  entries.forEach((entry, k) => {
    const { x, y } = places[k]!;
    svg.append(draw_mark(entry, x, y - 4));
    svg.append(make_svg_text(entry.label, { x: x + 28, y, "font-size": size.font, fill: palette.ink }));
  });
}
