// A small histogram of the fiber lengths beside the cell, for the time that is shown.
import { make_svg } from "../dom";
import { figure_font } from "../font";
import { choose_unit, write_number } from "../format";
import type { Palette } from "../palette";
import type { MeasuredFrame } from "./frame";

const size = { width: 210, height: 128, left: 4, right: 6, top: 6, bottom: 20 };
const bins = 24;

export interface LengthChart {
  element: SVGSVGElement;
  show: (frame: MeasuredFrame, palette: Palette) => void;
}

/** Weighs fibers by their length: the share of the fiber volume that each bin holds. */
function shares_of({ measures }: MeasuredFrame, longest: number): number[] {
  const shares = new Array<number>(bins).fill(0);
  let total = 0;
  for (const length of measures.length) {
    // A fiber as long as the longest belongs to the last bin.
    shares[Math.min(bins - 1, Math.floor((length / longest) * bins * (1 - 1e-6)))]! += length;
    total += length;
  }
  return shares.map((share) => share / (total || 1));
}

/** Makes the chart; its axis spans the lengths of all times. */
export function make_length_chart(longest: number): LengthChart {
  const { width, height, left, right, top, bottom } = size;
  const element = make_svg("svg", {
    class: "length-chart", viewBox: `0 0 ${width} ${height}`, width, height, "font-family": figure_font, role: "img",
    "aria-label": "Share of the fiber volume over fiber length at the time that is shown",
  });
  const unit = choose_unit("m", longest);
  const show = (frame: MeasuredFrame, palette: Palette): void => {
    const shares = shares_of(frame, longest);
    const highest = Math.max(...shares, 1e-9);
    const step = (width - left - right) / bins;
    element.replaceChildren();
    shares.forEach((share, k) => {
      const tall = ((height - top - bottom) * share) / highest;
      element.append(make_svg("rect", {
        x: left + k * step + 0.4, width: step - 0.8, y: height - bottom - tall, height: tall, fill: palette.series[0], "fill-opacity": 0.75, "data-value": share,
      }));
    });
    element.append(make_svg("line", { x1: left, x2: width - right, y1: height - bottom, y2: height - bottom, stroke: palette.muted }));
    for (const [share, anchor] of [[0, "start"], [0.5, "middle"], [1, "end"]] as const) {
      const text = `${write_number(longest * unit.factor * share, 3)}${share === 1 ? ` ${unit.unit}` : ""}`;
      const x = left + share * (width - left - right);
      element.append(make_svg("text", { x, y: height - 5, "font-size": 11, fill: palette.muted, "text-anchor": anchor }, text));
    }
  };
  return { element, show };
}
