// The colour bar beside the view.
import { make, make_label, make_svg } from "../dom";
import { choose_unit, write_axis_title, write_label } from "../format";
import { bar_ticks, write_ticks } from "../figure/ticks";
import { figure_font } from "../font";
import type { Palette } from "../palette";
import { type ColourScale, table_size } from "./colouring";

const height = 260;
const top = 30;

function colour_of(scale: ColourScale, index: number): string {
  const [red, green, blue] = scale.table.subarray(4 * index, 4 * index + 3);
  return `rgb(${red},${green},${blue})`;
}

interface Tick {
  /** Place in the bar, from 0 at its lower end to 1. */
  share: number;
  text: string;
}

/** Lists the ticks; birth fibers are told apart, not ordered, so their bar has none. */
function list_ticks(scale: ColourScale): Tick[] {
  if (scale.categorical) return [];
  const { factor } = choose_unit(scale.unit, scale.max);
  const ticks = scale.unit === "deg" ? [0, 30, 60, 90] : bar_ticks(scale.min * factor, scale.max * factor);
  const texts = write_ticks(ticks);
  return ticks.map((tick, k) => ({ share: (tick / factor - scale.min) / (scale.max - scale.min), text: texts[k]! }));
}

function draw_ticks(svg: SVGSVGElement, ticks: Tick[], palette: Palette): void {
  for (const { share, text } of ticks) {
    const at = top + height * (1 - share);
    svg.append(make_svg("line", { x1: 14, x2: 18, y1: at, y2: at, stroke: palette.muted }));
    svg.append(make_svg("text", { x: 22, y: at + 4, "font-size": 12, fill: palette.muted }, text));
  }
}

/** Marks that there are values above the bar. */
function draw_clipping(svg: SVGSVGElement, scale: ColourScale): void {
  svg.append(make_svg("title", {}, "up to the 99.5 % quantile"));
  svg.append(make_svg("path", { d: `M0,${top - 2}L7,${top - 10}L14,${top - 2}Z`, fill: colour_of(scale, table_size - 1) }));
}

/** Estimates the width of the bar with its widest tick. */
function measure_width(ticks: Tick[]): number {
  return 24 + 7 * Math.max(7, ...ticks.map(({ text }) => text.length));
}

/** Says what is coloured, and in which unit. */
export function bar_title(scale: ColourScale): string {
  return write_axis_title(scale.label, choose_unit(scale.unit, scale.max).unit);
}

/** Draws the bar under its title. */
export function make_colour_bar(scale: ColourScale, palette: Palette): HTMLElement {
  const ticks = list_ticks(scale);
  const width = measure_width(ticks);
  const svg = make_svg("svg", {
    xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 ${width} ${top + height + 12}`, width, height: top + height + 12, "font-family": figure_font,
  });
  const steps = scale.categorical ? 26 : 130;
  for (let k = 0; k < steps; ++k) {
    const index = scale.categorical ? k : Math.floor(((k + 0.5) / steps) * table_size);
    svg.append(make_svg("rect", {
      x: 0, width: 14, y: top + height - ((k + 1) * height) / steps, height: height / steps + 0.5, fill: colour_of(scale, index),
    }));
  }
  draw_ticks(svg, ticks, palette);
  if (scale.clipped) draw_clipping(svg, scale);
  const title = bar_title(scale);
  return make("div", { class: "colour-bar", role: "img", "aria-label": `Colour bar: ${write_label(title)}` }, make("span", {}, make_label(title)), svg);
}
