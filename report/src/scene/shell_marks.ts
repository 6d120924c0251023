// Marks on a part: labelled places such as gates, and lines such as weld lines.
import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, Vector3 } from "three";
import type { ShellLines, ShellPlace } from "../document";
import { make } from "../dom";
import { decode_base64 } from "./frame";
import type { Stage } from "./stage";

export interface PlaceLabels {
  element: HTMLElement;
  /** Puts the labels where the camera sees their places. */
  follow: (stage: Stage) => void;
}

/** Makes one label a place; they lie over the canvas and let the pointer through. */
export function make_place_labels(places: ShellPlace[]): PlaceLabels {
  const labels = places.map(({ label, kind }) => make("span", { class: `place ${kind}` }, label));
  const element = make("div", { class: "places", "aria-hidden": "true" }, ...labels);
  return {
    element,
    follow: (stage) => {
      const { clientWidth: width, clientHeight: height } = stage.canvas;
      places.forEach(({ at }, k) => {
        const seen = new Vector3(...at).multiplyScalar(stage.factor).project(stage.camera);
        labels[k]!.style.transform = `translate(${(((seen.x + 1) * width) / 2).toFixed(1)}px, ${(((1 - seen.y) * height) / 2).toFixed(1)}px)`;
        labels[k]!.hidden = Math.abs(seen.z) > 1;
      });
    },
  };
}

/** Makes the segments of one kind of line, drawn over the surface. */
export function make_mark_lines(lines: ShellLines, factor: number): LineSegments {
  const ends = new Float32Array(decode_base64(lines.segments));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(ends.map((value) => value * factor), 3));
  const colour = new Color().setStyle("#d6336c", "srgb-linear");
  const segments = new LineSegments(geometry, new LineBasicMaterial({ color: colour, depthTest: false }));
  segments.renderOrder = 1;
  return segments;
}
