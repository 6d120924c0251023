// The section "heatmap": a field over two axes.
import type { HeatmapSection, Value } from "../document";
import { make } from "../dom";
import { draw_heatmap, heatmap_titles } from "../figure/heatmap_figure";
import { paper_size, print_size, screen_size } from "../figure/size";
import { current_palette, light_palette, watch_scheme } from "../palette";
import { add_print_figure } from "../print";
import type { Column } from "../save";
import { make_section } from "./parts";
import { follow_width, make_plot } from "./plot";
import { add_save_buttons } from "./save_buttons";

function make_columns(section: HeatmapSection): Column[] {
  const x: Value[] = [];
  const y: Value[] = [];
  section.values.forEach((row, j) => row.forEach((_value, i) => {
    x.push(section.x.values?.[i] ?? i);
    y.push(section.y.values?.[j] ?? j);
  }));
  const header = (label: string, unit?: string): string => (unit ? `${label} [${unit}]` : label);
  return [
    { header: header(section.x.label, section.x.unit), values: x },
    { header: header(section.y.label, section.y.unit), values: y },
    { header: header(section.label ?? section.title, section.unit), values: section.values.flat() },
  ];
}

export function render_heatmap(section: HeatmapSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const canvas = make("div", { class: "vector" });
  figure.append(make_plot(heatmap_titles(section), canvas));
  const paper = (size = paper_size): SVGSVGElement => draw_heatmap(section, light_palette, size);
  watch_scheme(follow_width(canvas, (width) => draw_heatmap(section, current_palette(), screen_size(width))));
  add_save_buttons(controls, { name: section.id, paper, columns: () => make_columns(section) });
  add_print_figure(figure, () => paper(print_size));
  return element;
}
