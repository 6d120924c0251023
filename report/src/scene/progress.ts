// What lies over a view while it is saved: how far that is, and a button that ends it. It keeps the camera steady, too.
import { make, make_button } from "../dom";

export interface Progress {
  /** Shows a share, 0 to 1, and what it is in words. */
  tell: (share: number, text: string) => void;
  cancelled: () => boolean;
  close: () => void;
}

export function make_progress(host: HTMLElement): Progress {
  let ended = false;
  const bar = make("progress", { max: 1, value: 0 });
  const words = make("span", {});
  const cover = make("div", { class: "saving", role: "status" }, make("div", {}, words, bar, make_button("Cancel", "Save nothing", () => { ended = true; })));
  host.append(cover);
  return {
    tell: (share, text) => {
      bar.value = share;
      words.textContent = text;
    },
    cancelled: () => ended,
    close: () => cover.remove(),
  };
}
