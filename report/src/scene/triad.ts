// The axis triad in the corner of the view, drawn as vectors over the canvas.
import { Camera, Vector3 } from "three";
import { make_svg } from "../dom";

export interface Triad {
  element: SVGSVGElement;
  turn: (camera: Camera) => void;
}

const reach = 26;
const colours = ["#d1495b", "#3c9d5d", "#3d7dca"];

export function make_triad(): Triad {
  const element = make_svg("svg", { class: "triad", viewBox: "-44 -44 88 88", "aria-hidden": "true" });
  const axes = ["x", "y", "z"].map((name, k) => {
    const line = make_svg("line", { stroke: colours[k], "stroke-width": 2.4, "stroke-linecap": "round" });
    const text = make_svg("text", {
      fill: colours[k], "font-size": 14, "font-weight": 600, "text-anchor": "middle", "dominant-baseline": "central",
    }, name);
    element.append(line, text);
    return { line, text, direction: new Vector3().setComponent(k, 1) };
  });
  const turn = (camera: Camera): void => {
    for (const { line, text, direction } of axes) {
      const seen = direction.clone().transformDirection(camera.matrixWorldInverse);
      line.setAttribute("x2", (reach * seen.x).toFixed(2));
      line.setAttribute("y2", (-reach * seen.y).toFixed(2));
      text.setAttribute("x", ((reach + 10) * seen.x).toFixed(2));
      text.setAttribute("y", (-(reach + 10) * seen.y).toFixed(2));
    }
  };
  return { element, turn };
}
