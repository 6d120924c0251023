// The buttons that save a figure and its numbers.
import { make_button } from "../dom";
import { type Column, save_csv, save_png, save_svg } from "../save";

/** Adds SVG, PNG and CSV to a row of controls; figure and numbers are made when asked for. */
export function add_save_buttons(controls: HTMLElement, name: string, paper: () => SVGSVGElement, columns: () => Column[]): void {
  controls.append(
    make_button("SVG", "Save the figure as SVG", () => save_svg(name, paper())),
    make_button("PNG", "Save the figure as PNG", () => void save_png(name, paper())),
    make_button("CSV", "Save the numbers as CSV", () => save_csv(name, columns())),
  );
}
