// A box that scrolls sideways, and fades at the edges beyond which there is more.
import { make } from "../dom";

/** Puts a wide thing into a box that fades where more of it is. */
export function make_scroll(wide: HTMLElement): HTMLElement {
  const box = make("div", { class: "scroll", tabindex: 0 }, wide);
  const mark = (): void => {
    box.classList.toggle("more-left", box.scrollLeft > 1);
    box.classList.toggle("more-right", box.scrollLeft + box.clientWidth < box.scrollWidth - 1);
  };
  box.addEventListener("scroll", mark, { passive: true });
  new ResizeObserver(mark).observe(box);
  return box;
}
