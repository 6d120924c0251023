// The section "histogram": frames to choose and lay over each other.
import type { HistogramSection } from "../document";
import { make, make_label, make_toggle } from "../dom";
import { type Chosen, curve_colour, draw_histogram, frame_colour, histogram_titles } from "../figure/histogram_figure";
import { paper_size, print_size, screen_size } from "../figure/size";
import { write_label } from "../format";
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
    ...(section.curves ?? []).flatMap((curve) => [
      { header: `${section.x.label} of ${curve.label}${unit}`, values: curve.x ?? [] },
      { header: `${section.y.label} ${curve.label}${count}`, values: curve.values },
    ]),
  ];
}

/** Makes a button an entry that shows and hides it. */
function make_entries(labels: string[], mark: (index: number) => string, shown: Set<number>, draw: () => void): HTMLButtonElement[] {
  return labels.map((label, index) => {
    const sample = make("span", { class: `mark ${mark(index)}`, "aria-hidden": "true" });
    const button = make_toggle(sample, `Show or hide ${write_label(label)}`, shown.has(index), (on) => {
      if (on) shown.add(index);
      else shown.delete(index);
      draw();
    });
    button.append(make_label(label));
    return button;
  });
}

export function render_histogram(section: HistogramSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const count = section.frames.length;
  const curves = section.curves ?? [];
  const frames_shown = new Set(count > 0 ? [0, count - 1] : []);
  const curves_shown = new Set(curves.keys());
  const ordered = (): Chosen => {
    const sorted = (numbers: Set<number>): number[] => [...numbers].sort((a, b) => a - b);
    return { frames: sorted(frames_shown), curves: sorted(curves_shown) };
  };
  const canvas = make("div", { class: "vector" });
  const paper = (size = paper_size): SVGSVGElement => draw_histogram(section, ordered(), light_palette, size);
  const redraw = follow_width(canvas, (width) => draw_histogram(section, ordered(), current_palette(), screen_size(width)));
  const buttons = make_entries(section.frames.map(({ label }) => label), () => "box", frames_shown, () => draw());
  const lines = make_entries(curves.map(({ label }) => label), (k) => curves[k]!.style ?? "line", curves_shown, () => draw());
  const draw = (): void => {
    const palette = current_palette();
    buttons.forEach((button, index) => button.style.setProperty("--series", frame_colour(index, count, palette)));
    lines.forEach((button, index) => button.style.setProperty("--series", curve_colour(section, index, palette)));
    redraw();
  };
  const legend = make("div", { class: "legend frames" }, ...buttons, ...lines);
  if (section.reference) {
    legend.append(make("span", { class: "reference" }, make("span", { class: "mark dashed", "aria-hidden": "true" }), make_label(section.reference.label)));
  }
  figure.append(legend, make_plot(histogram_titles(section), canvas));
  watch_scheme(draw);
  draw();
  add_save_buttons(controls, { name: section.id, paper, columns: () => make_columns(section) });
  add_print_figure(figure, () => paper(print_size));
  return element;
}
