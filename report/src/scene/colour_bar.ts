// The colour bar beside the view.
import { make, make_svg } from "../dom";
import { choose_unit, write_axis_title, write_number } from "../format";
import { bar_ticks } from "../figure/ticks";
import { figure_font } from "../font";
import type { Palette } from "../palette";
import { type ColourScale, table_size } from "./colouring";

const height = 260;
const top = 30;

function colour_of(scale: ColourScale, index: number): string {
  const [red, green, blue] = scale.table.subarray(4 * index, 4 * index + 3);
  return `rgb(${red},${green},${blue})`;
}

function draw_ticks(svg: SVGSVGElement, scale: ColourScale, palette: Palette): void {
  const unit = choose_unit(scale.unit, scale.max);
  const ticks = scale.unit === "deg" ? [0, 30, 60, 90] : bar_ticks(scale.min * unit.factor, scale.max * unit.factor);
  for (const tick of ticks) {
    const at = top + height - (height * (tick / unit.factor - scale.min)) / (scale.max - scale.min);
    svg.append(make_svg("line", { x1: 14, x2: 18, y1: at, y2: at, stroke: palette.muted }));
    svg.append(make_svg("text", { x: 22, y: at + 4, "font-size": 12, fill: palette.muted }, write_number(tick, 3)));
  }
  if (scale.clipped) {
    const note = `up to the 99.5 % quantile`;
    svg.append(make_svg("title", {}, note));
    svg.append(make_svg("path", { d: `M0,${top - 2}L7,${top - 10}L14,${top - 2}Z`, fill: colour_of(scale, table_size - 1) }));
  }
}

/** Draws the bar; birth fibers are told apart, not ordered, so their bar has no ticks. */
export function make_colour_bar(scale: ColourScale, palette: Palette): HTMLElement {
  const unit = choose_unit(scale.unit, scale.max);
  const svg = make_svg("svg", {
    xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 74 ${top + height + 12}`, width: 74, height: top + height + 12, "font-family": figure_font,
  });
  const steps = scale.categorical ? 26 : 130;
  for (let k = 0; k < steps; ++k) {
    const index = scale.categorical ? k : Math.floor(((k + 0.5) / steps) * table_size);
    svg.append(make_svg("rect", {
      x: 0, width: 14, y: top + height - ((k + 1) * height) / steps, height: height / steps + 0.5, fill: colour_of(scale, index),
    }));
  }
  if (!scale.categorical) draw_ticks(svg, scale, palette);
  const title = write_axis_title(scale.label, unit.unit);
  return make("div", { class: "colour-bar", role: "img", "aria-label": `Colour bar: ${title}` }, make("span", {}, title), svg);
}
