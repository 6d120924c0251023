// What stands beside the cell and follows its slider: lengths and orientation.
import { make } from "../dom";
import { current_palette } from "../palette";
import type { CellState } from "./cell_state";
import { make_length_chart } from "./length_chart";
import { make_orientation_sphere, sphere_top } from "./orientation_sphere";
import type { Stage } from "./stage";

export interface SidePanel {
  element: HTMLElement;
  show: (state: CellState) => void;
  /** Turns the sphere with the camera. */
  turn: (stage: Stage) => void;
}

export function make_side_panel(longest: number): SidePanel {
  const lengths = make_length_chart(longest);
  const sphere = make_orientation_sphere();
  const element = make(
    "aside", { class: "side" },
    make("h3", {}, "Fiber length by volume"), lengths.element,
    make("h3", {}, "Directions of rods"), sphere.element,
    make("p", {}, `1 is isotropic, bright is ${sphere_top} times as many and more; seen as the cell is`),
  );
  const show = (state: CellState): void => {
    lengths.show(state, current_palette());
    sphere.measure(state);
  };
  return { element, show, turn: (stage) => sphere.draw(stage.camera) };
}
