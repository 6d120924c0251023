// The sections "lines" and "scatter": curves with legend, zoom, scales and files to save.
import { name_in_file } from "../compared";
import { make_curves, type Curves } from "../chart/curves";
import { make_legend } from "../chart/legend";
import { make_line_chart } from "../chart/line_chart";
import { is_number, type LinesSection, type Scale } from "../document";
import { make, make_button, make_toggle } from "../dom";
import { draw_lines, type View } from "../figure/lines_figure";
import { paper_size, print_size } from "../figure/size";
import { write_axis_title, write_label } from "../format";
import { current_palette, light_palette, watch_scheme } from "../palette";
import { add_print_figure } from "../print";
import type { Column } from "../save";
import { make_section } from "./parts";
import { make_plot } from "./plot";
import { add_save_buttons } from "./save_buttons";

/** Names what a column holds: the axis tells the quantity of curves with names such as “first”. */
function name_column({ y, compared }: LinesSection, curve: string): string {
  return compared || curve.toLowerCase().includes(y.label.toLowerCase()) ? curve : `${y.label}, ${curve}`;
}

/** Gives the numbers as they are in the document, in its units. */
function make_columns(section: LinesSection): Column[] {
  const header = (label: string, unit?: string): string => (unit ? `${label} [${unit}]` : label);
  const columns: Column[] = [];
  if (section.x.values) columns.push({ header: header(section.x.label, section.x.unit), values: section.x.values });
  for (const series of section.series) {
    const { curve, replicas } = name_in_file(section, series);
    const column = name_column(section, curve);
    const of_replicas = replicas > 1 ? { mean: ", mean", low: ", least", high: ", largest" } : { mean: "", low: ", low", high: ", high" };
    if (series.x) columns.push({ header: header(`${section.x.label} of ${series.label}`, section.x.unit), values: series.x });
    columns.push({ header: header(`${column}${of_replicas.mean}`, section.y.unit), values: series.values });
    if (series.low) columns.push({ header: header(`${column}${of_replicas.low}`, section.y.unit), values: series.low });
    if (series.high) columns.push({ header: header(`${column}${of_replicas.high}`, section.y.unit), values: series.high });
  }
  return columns;
}

/** What a button calls the x axis: its label where that is a short word. */
function short_name(label: string): string {
  return /^\p{L}{1,8}$/u.test(label) ? label : "x";
}

function has_positive(made: Curves, axis: "x" | "y"): boolean {
  return made.curves.some((curve) => curve[axis].some((value) => is_number(value) && value > 0));
}

export function render_lines(section: LinesSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const made = make_curves(section);
  const scales: { x: Scale; y: Scale } = {
    x: section.x.scale === "log" && has_positive(made, "x") ? "log" : "linear",
    y: section.y.scale === "log" && has_positive(made, "y") ? "log" : "linear",
  };
  const legend = make_legend(section, made, () => chart().rebuild());
  const host = make("div", { class: "chart", role: "img", "aria-label": write_label(`${made.y_label} against ${made.x_label}`) });
  const titles = { x: write_axis_title(made.x_label, made.x_unit.unit), y: write_axis_title(made.y_label, made.y_unit.unit) };
  figure.append(legend.element, make_plot(titles, host));
  let built: ReturnType<typeof make_line_chart> | undefined;
  const chart = (): ReturnType<typeof make_line_chart> => (built ??= make_line_chart({ host, made, scales, moved: legend.show }));
  const view = (): View => ({ x_scale: scales.x, y_scale: scales.y, x_range: chart().zoomed() });
  const file = (): SVGSVGElement => draw_lines(section.title, made, { ...view(), full_labels: true }, light_palette, paper_size);

  for (const axis of ["x", "y"] as const) {
    if (made.equal || (axis === "x" && made.x_names) || !has_positive(made, axis)) continue;
    controls.append(make_toggle(`log ${axis === "x" ? short_name(section.x.label) : axis}`, `Logarithmic ${axis} axis`, scales[axis] === "log", (on) => {
      scales[axis] = on ? "log" : "linear";
      chart().reset_zoom();
    }));
  }
  controls.append(
    make_button("All", "Show the whole range again (or double-click the chart); drag across it to zoom", () => chart().reset_zoom()),
  );
  const recolour = (): void => {
    legend.colour(current_palette());
    built?.rebuild();
  };
  watch_scheme(recolour);
  recolour();
  add_save_buttons(controls, { name: section.id, paper: file, columns: () => make_columns(section) });
  add_print_figure(figure, () => draw_lines(section.title, made, view(), light_palette, print_size));
  // The chart takes its width from the page, which this element joins only after this function.
  requestAnimationFrame(() => chart());
  return element;
}
