// The time slider with its play button.
import { make } from "../dom";
import { write_quantity } from "../format";

export interface Player {
  element: HTMLElement;
  index: () => number;
}

export interface Pace {
  per_second: number;
  /** Index at which the slider stands at first. */
  start: number;
}

/** Makes the slider over the frames' times; `show` is called with the chosen frame's index. */
export function make_player(times: number[], show: (index: number) => void, pace: Pace = { per_second: 6, start: 0 }): Player {
  const last = times.length - 1;
  const slider = make("input", { type: "range", min: 0, max: last, step: 1, value: pace.start, "aria-label": "Time" });
  const label = make("output", {});
  const button = make("button", { type: "button", class: "play", "aria-label": "Play" }, "▶");
  let timer: number | undefined;
  const update = (): void => {
    const index = Number(slider.value);
    label.textContent = `t = ${write_quantity(times[index], "s")}`;
    slider.setAttribute("aria-valuetext", label.textContent);
    show(index);
  };
  const stop = (): void => {
    clearInterval(timer);
    timer = undefined;
    button.textContent = "▶";
    button.setAttribute("aria-label", "Play");
  };
  const advance = (): void => {
    slider.value = String(Number(slider.value) + 1);
    update();
    if (Number(slider.value) === last) stop();
  };
  button.addEventListener("click", () => {
    if (timer !== undefined) {
      stop();
      return;
    }
    if (Number(slider.value) === last) slider.value = "-1";
    button.textContent = "❚❚";
    button.setAttribute("aria-label", "Pause");
    timer = window.setInterval(advance, 1000 / pace.per_second);
    advance();
  });
  slider.addEventListener("input", () => {
    stop();
    update();
  });
  const element = make("div", { class: "player" }, button, slider, label);
  if (last < 1) element.classList.add("single");
  label.textContent = `t = ${write_quantity(times[pace.start], "s")}`;
  return { element, index: () => Number(slider.value) };
}
