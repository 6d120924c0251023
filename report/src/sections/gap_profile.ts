// Profiles through the gap at the node that the reader has clicked.
import { make_curves } from "../chart/curves";
import type { LinesSection, ShellLayers } from "../document";
import { make, make_label } from "../dom";
import { draw_lines } from "../figure/lines_figure";
import { screen_size } from "../figure/size";
import { write_axis_title } from "../format";
import { current_palette } from "../palette";
import { decode_base64 } from "../scene/frame";
import { make_plot } from "./plot";

export interface GapProfile {
  element: HTMLElement;
  show: (node: number, place: string) => void;
}

const profile_height = 170;

interface DecodedLayers {
  heights: number[];
  thickness: Float32Array;
  fields: { label: string; unit?: string; values: Float32Array }[];
}

function decode_layers(layers: ShellLayers): DecodedLayers {
  const floats = (text: string): Float32Array => new Float32Array(decode_base64(text));
  return {
    heights: layers.heights, thickness: floats(layers.thickness),
    fields: layers.fields.map(({ label, unit, values }) => ({ label, unit, values: floats(values) })),
  };
}

/** Puts one field at a node as a section of curves. */
function section_of(layers: DecodedLayers, field: DecodedLayers["fields"][number], node: number): LinesSection {
  const count = layers.heights.length;
  const values = Array.from(field.values.subarray(node * count, (node + 1) * count), (value) => (Number.isFinite(value) ? value : null));
  return {
    kind: "lines", id: "", title: field.label,
    x: { label: "height over the mid-plane", unit: "m", values: layers.heights.map((height) => (height * layers.thickness[node]!) / 2) },
    y: { label: field.label, unit: field.unit }, series: [{ label: field.label, values }],
  };
}

export function make_gap_profile(encoded: ShellLayers): GapProfile {
  const layers = decode_layers(encoded);
  const title = make("h3", {});
  const charts = make("div", { class: "profiles" });
  const element = make("div", { class: "gap", hidden: true }, title, charts);
  const show = (node: number, place: string): void => {
    element.hidden = false;
    element.dataset.node = String(node);
    title.replaceChildren(make_label(`Through the gap at ${place} when filling ends, from the mid-plane to the wall`));
    charts.replaceChildren(...layers.fields.map((field) => {
      const made = make_curves(section_of(layers, field, node));
      const host = make("div", { class: "vector" });
      const titles = { x: write_axis_title(made.x_label, made.x_unit.unit), y: write_axis_title(made.y_label, made.y_unit.unit) };
      const plot = make_plot(titles, host);
      const draw = (): void => host.replaceChildren(draw_lines(field.label, made, { x_scale: "linear", y_scale: "linear" }, current_palette(), screen_size(host.clientWidth || 300, profile_height)));
      requestAnimationFrame(draw);
      return plot;
    }));
  };
  return { element, show };
}
