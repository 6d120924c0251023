// A plot on the screen: its titles as text of the page, and a figure that takes the width of the page.
import { make, make_label } from "../dom";

/** Sets the titles of both axes around a host, alike for charts and vector figures. */
export function make_plot(titles: { x: string; y: string }, host: HTMLElement): HTMLElement {
  return make(
    "div", { class: "plot" },
    make("div", { class: "axis-title y" }, make_label(titles.y)), host,
    make("div", { class: "axis-title x" }, make_label(titles.x)),
  );
}

/** Keeps a vector figure as wide as its host; gives the function that draws it anew. */
export function follow_width(host: HTMLElement, draw: (width: number) => SVGSVGElement): () => void {
  let width = 0;
  const redraw = (): void => {
    if (width > 0) host.replaceChildren(draw(width));
  };
  new ResizeObserver(() => {
    if (host.clientWidth === width) return;
    width = host.clientWidth;
    redraw();
  }).observe(host);
  return redraw;
}
