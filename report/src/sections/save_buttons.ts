// The menu that saves a figure and its numbers.
import { make, make_button } from "../dom";
import { type Column, save_csv, save_png, save_svg } from "../save";

/** Makes a menu out of buttons; it closes when one is pressed, or when the reader turns elsewhere. */
export function make_save_menu(...buttons: HTMLButtonElement[]): HTMLElement {
  const entries = make("div", { class: "entries" }, ...buttons);
  const menu = make("details", { class: "menu" }, make("summary", { title: "Save as a file" }, "Save"), entries);
  menu.addEventListener("toggle", () => {
    menu.classList.remove("at-left");
    menu.classList.toggle("at-left", menu.open && entries.getBoundingClientRect().left < 0);
  });
  menu.addEventListener("click", (event) => {
    if (event.target instanceof HTMLButtonElement) menu.open = false;
  });
  menu.addEventListener("focusout", (event) => {
    if (!menu.contains(event.relatedTarget as Node | null)) menu.open = false;
  });
  return menu;
}

/** What a menu saves: the file's name, the figure for paper, the numbers. */
export interface Saved {
  name: string;
  paper: () => SVGSVGElement;
  columns: () => Column[];
}

/** Adds SVG, PNG and CSV to a row of controls; figure and numbers are made when asked for. */
export function add_save_buttons(controls: HTMLElement, { name, paper, columns }: Saved): void {
  controls.append(make_save_menu(
    make_button("Figure as SVG", "A vector figure for a paper; its text stays text", () => save_svg(name, paper())),
    make_button("Figure as PNG", "A picture of 2160 by 1200 pixels", () => void save_png(name, paper())),
    make_button("Numbers as CSV", "All numbers of the figure in the document's units", () => save_csv(name, columns())),
  ));
}
