// Print: live figures are replaced by vector figures in the light palette, so that paper shows what papers show.

import { current_palette, light_palette, type Palette } from "./palette";

type Draw = () => SVGSVGElement;
const printed: { host: HTMLElement; draw: Draw }[] = [];
const views: ((palette: Palette) => void)[] = [];

/** Registers the vector figure that stands in for a host's live content on paper. */
export function add_print_figure(host: HTMLElement, draw: Draw): void {
  printed.push({ host, draw });
}

/** Registers how a view that is printed as it stands is drawn in a palette. */
export function add_print_view(draw: (palette: Palette) => void): void {
  views.push(draw);
}

window.addEventListener("beforeprint", () => {
  for (const draw of views) draw(light_palette);
  for (const { host, draw } of printed) {
    const figure = draw();
    figure.classList.add("print-figure");
    host.append(figure);
  }
});

window.addEventListener("afterprint", () => {
  for (const draw of views) draw(current_palette());
  for (const figure of document.querySelectorAll(".print-figure")) figure.remove();
});
