// The time slider with its play button: playing runs evenly in time, also between frames.
import { make } from "../dom";
import { write_quantity } from "../format";

export interface Player {
  element: HTMLElement;
  /** Goes to a position: the number of a frame, or a place between two. */
  go: (position: number) => void;
}

export interface Pace {
  /** Seconds that the whole takes. */
  seconds: number;
  /** Position at which the slider stands at first. */
  start: number;
}

/** Gives the time at a position, linear between frames. */
export function time_at(times: number[], position: number): number {
  const below = Math.max(0, Math.min(times.length - 2, Math.floor(position)));
  const above = Math.min(times.length - 1, below + 1);
  return times[below]! + (position - below) * (times[above]! - times[below]!);
}

/** Gives the position of a time. */
export function position_of(times: number[], time: number): number {
  if (!(time > times[0]!)) return 0;
  const above = times.findIndex((one) => one >= time);
  if (above < 0) return times.length - 1;
  return above - (times[above]! - time) / (times[above]! - times[above - 1]!);
}

/** Moves the slider by whole frames where the reader uses the arrow keys. */
function step_by_frames(slider: HTMLInputElement, update: () => void): void {
  slider.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const at = Number(slider.value);
    slider.value = String(step > 0 ? Math.floor(at + 1e-6) + 1 : Math.ceil(at - 1e-6) - 1);
    update();
  });
}

/** Runs a clock that calls back with the seconds since the last call, until that says that all is over. */
function make_clock(tick: (seconds: number) => boolean): { toggle: () => boolean; stop: () => void } {
  let request: number | undefined;
  let last = 0;
  const stop = (): void => {
    if (request !== undefined) cancelAnimationFrame(request);
    request = undefined;
  };
  const run = (now: number): void => {
    // A tab in the background or a slow picture must not make the time jump.
    const over = tick(Math.min(0.1, (now - last) / 1000));
    last = now;
    request = over ? undefined : requestAnimationFrame(run);
  };
  const toggle = (): boolean => {
    if (request !== undefined) {
      stop();
      return false;
    }
    last = performance.now();
    request = requestAnimationFrame(run);
    return true;
  };
  return { toggle, stop };
}

/** Makes the slider over the frames' times; `show` is called with the position and its time. */
export function make_player(times: number[], show: (position: number, time: number) => void, pace: Pace): Player {
  const last = times.length - 1;
  const slider = make("input", { type: "range", min: 0, max: last, step: 0.01, value: pace.start, "aria-label": "Time" });
  const label = make("output", {});
  const button = make("button", { type: "button", class: "play" });
  const tell = (): number => {
    const time = time_at(times, Number(slider.value));
    label.textContent = `t = ${write_quantity(time, "s")}`;
    slider.setAttribute("aria-valuetext", label.textContent);
    return time;
  };
  const update = (): void => show(Number(slider.value), tell());
  const set_playing = (playing: boolean): void => {
    button.textContent = playing ? "❚❚" : "▶";
    button.setAttribute("aria-label", playing ? "Pause" : "Play");
  };
  const rate = (times[last]! - times[0]!) / pace.seconds;
  const clock = make_clock((seconds) => {
    slider.value = String(position_of(times, time_at(times, Number(slider.value)) + rate * seconds));
    update();
    const over = Number(slider.value) >= last;
    if (over) set_playing(false);
    return over;
  });
  const stop = (): void => {
    clock.stop();
    set_playing(false);
  };
  button.addEventListener("click", () => {
    if (Number(slider.value) >= last) slider.value = "0";
    set_playing(clock.toggle());
  });
  slider.addEventListener("input", () => {
    stop();
    update();
  });
  step_by_frames(slider, () => {
    stop();
    update();
  });
  const element = make("div", { class: "player" }, button, slider, label);
  if (last < 1) element.classList.add("single");
  set_playing(false);
  tell();
  const go = (position: number): void => {
    stop();
    slider.value = String(position);
    update();
  };
  return { element, go };
}
