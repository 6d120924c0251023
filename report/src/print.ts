// Print: live figures are replaced by vector figures in the light palette, so that paper shows what papers show.

type Draw = () => SVGSVGElement;
const printed: { host: HTMLElement; draw: Draw }[] = [];

/** Registers the vector figure that stands in for a host's live content on paper. */
export function add_print_figure(host: HTMLElement, draw: Draw): void {
  printed.push({ host, draw });
}

window.addEventListener("beforeprint", () => {
  for (const { host, draw } of printed) {
    const figure = draw();
    figure.classList.add("print-figure");
    host.append(figure);
  }
});

window.addEventListener("afterprint", () => {
  for (const figure of document.querySelectorAll(".print-figure")) figure.remove();
});
