// The section "histogram": frames to choose and lay over each other.
import type { HistogramSection } from "../document";
import { make, make_toggle } from "../dom";
import { draw_histogram, frame_colour, histogram_titles } from "../figure/histogram_figure";
import { paper_size, print_size, screen_size } from "../figure/size";
import { current_palette, light_palette, watch_scheme } from "../palette";
import { add_print_figure } from "../print";
import type { Column } from "../save";
import { make_section } from "./parts";
import { follow_width, make_plot } from "./plot";
import { add_save_buttons } from "./save_buttons";

function make_columns(section: HistogramSection): Column[] {
  const unit = section.x.unit ? ` [${section.x.unit}]` : "";
  const count = section.y.unit ? ` [${section.y.unit}]` : "";
  const frames = section.reference ? [...section.frames, section.reference] : section.frames;
  return [
    { header: `${section.x.label} from${unit}`, values: section.edges.slice(0, -1) },
    { header: `${section.x.label} to${unit}`, values: section.edges.slice(1) },
    ...frames.map((frame) => ({ header: `${section.y.label} ${frame.label}${count}`, values: frame.values })),
  ];
}

export function render_histogram(section: HistogramSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const count = section.frames.length;
  const chosen = new Set(count > 0 ? [0, count - 1] : []);
  const ordered = (): number[] => [...chosen].sort((a, b) => a - b);
  const canvas = make("div", { class: "vector" });
  const paper = (size = paper_size): SVGSVGElement => draw_histogram(section, ordered(), light_palette, size);
  const redraw = follow_width(canvas, (width) => draw_histogram(section, ordered(), current_palette(), screen_size(width)));
  const buttons = section.frames.map((frame, index) => {
    const mark = make("span", { class: "mark box", "aria-hidden": "true" });
    const button = make_toggle(mark, `Show or hide ${frame.label}`, chosen.has(index), (on) => {
      if (on) chosen.add(index);
      else chosen.delete(index);
      draw();
    });
    button.append(frame.label);
    return button;
  });
  const draw = (): void => {
    const palette = current_palette();
    buttons.forEach((button, index) => button.style.setProperty("--series", frame_colour(index, count, palette)));
    redraw();
  };
  const legend = make("div", { class: "legend frames" }, ...buttons);
  if (section.reference) {
    legend.append(make("span", { class: "reference" }, make("span", { class: "mark dashed", "aria-hidden": "true" }), section.reference.label));
  }
  figure.append(legend, make_plot(histogram_titles(section), canvas));
  watch_scheme(draw);
  draw();
  add_save_buttons(controls, { name: section.id, paper, columns: () => make_columns(section) });
  add_print_figure(figure, () => paper(print_size));
  return element;
}
