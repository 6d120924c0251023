// Labelled places on a part, such as gates.
import { Vector3 } from "three";
import type { ShellPlace } from "../document";
import { make, make_label } from "../dom";
import type { Stage } from "./stage";

export interface PlaceLabels {
  element: HTMLElement;
  /** Puts the labels where the camera sees their places. */
  follow: (stage: Stage) => void;
}

/** Makes one label a place; they lie over the canvas and let the pointer through. One that finds no room at the right stands at the left. */
export function make_place_labels(places: ShellPlace[]): PlaceLabels {
  const labels = places.map(({ label, kind }) => make("span", { class: `place ${kind}` }, make_label(label)));
  const element = make("div", { class: "places", "aria-hidden": "true" }, ...labels);
  return {
    element,
    follow: (stage) => {
      places.forEach(({ at }, k) => {
        const seen = new Vector3(...at).multiplyScalar(stage.factor).project(stage.camera);
        // A hidden label has no width.
        labels[k]!.hidden = Math.abs(seen.z) > 1;
        const right = (0.5 + 0.5 * seen.x) * element.clientWidth;
        labels[k]!.classList.toggle("at-left", right + labels[k]!.offsetWidth > element.clientWidth);
        labels[k]!.style.left = `${(50 * (1 + seen.x)).toFixed(2)}%`;
        labels[k]!.style.top = `${(50 * (1 - seen.y)).toFixed(2)}%`;
      });
    },
  };
}
