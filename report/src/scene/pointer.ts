// Pointing at fibers: hovering tells about one, a click chooses one to follow with all pieces of its birth fiber.
import { Vector2 } from "three";
import { make } from "../dom";
import type { CellState } from "./cell_state";
import { show_fiber } from "./fiber_facts";
import type { PlacedRods } from "./images";
import { first_rod, rods_of } from "./pairing";
import { pick_rod } from "./picking";
import type { View } from "./view";

/** A rod that keeps its number through breaks. */
export interface ChosenRod {
  birth: number;
  /** Number of the rod along the fiber at birth, where the document tells it. */
  number: number | undefined;
}

export interface Pointer {
  /** Forgets the fiber under the cursor: numbers of fibers change when fibers break. */
  frame_changed: () => void;
  chosen: () => ChosenRod | undefined;
}

export interface Pointed {
  state: CellState;
  placed: PlacedRods;
}

/** How close in screen pixels the cursor must come. */
const reach_in_pixels = 5;

/** A drag turns the camera; a press that hardly moves is a click. */
const click_slack_in_pixels = 4;

/** Finds the piece that has the chosen rod now. */
export function piece_with({ frame }: CellState, chosen: ChosenRod): number | undefined {
  for (let fiber = 0; fiber < frame.fibers; ++fiber) {
    if (frame.birth[fiber] !== chosen.birth) continue;
    if (chosen.number === undefined || !frame.birth_node) return fiber;
    const start = frame.birth_node[fiber]!;
    if (chosen.number >= start && chosen.number < start + rods_of(frame, fiber)) return fiber;
  }
  return undefined;
}

function pick(event: PointerEvent, view: View, placed: PlacedRods): number | undefined {
  const area = view.canvas.getBoundingClientRect();
  const x = (event.clientX - area.left) / area.width;
  const y = (event.clientY - area.top) / area.height;
  const half_height = Math.tan((view.camera.fov * Math.PI) / 360);
  return pick_rod(placed, {
    camera: view.camera, cursor: new Vector2(2 * x - 1, 1 - 2 * y), factor: view.factor,
    tolerance: (reach_in_pixels * 2 * half_height) / area.height,
  });
}

export function follow_pointer(stage: HTMLElement, view: View, current: () => Pointed, chose: () => void): Pointer {
  const box = make("div", { class: "fiber-facts", role: "status", hidden: true });
  stage.append(box);
  let chosen: ChosenRod | undefined;
  let hovered: number | undefined;
  let pressed_at = { x: 0, y: 0 };

  const hover = (fiber: number | undefined): void => {
    hovered = fiber;
    box.hidden = fiber === undefined;
    if (fiber !== undefined) show_fiber(box, current().state, fiber);
    view.rods.emphasize(fiber, chosen?.birth);
    view.redraw();
  };
  const choose = (at: number | undefined): void => {
    const { state, placed } = current();
    const fiber = at === undefined ? undefined : placed.fiber[at]!;
    if (fiber === undefined) chosen = undefined;
    else {
      const along = placed.rod[at!]! - first_rod(state.frame, fiber);
      const start = state.frame.birth_node?.[fiber];
      chosen = { birth: state.frame.birth[fiber]!, number: start === undefined ? undefined : start + along };
    }
    if (chosen) stage.dataset.family = String(chosen.birth);
    else delete stage.dataset.family;
    hover(fiber);
    chose();
  };

  view.canvas.addEventListener("pointermove", (event) => {
    const at = event.buttons === 0 ? pick(event, view, current().placed) : undefined;
    const fiber = at === undefined ? undefined : current().placed.fiber[at];
    // Drawing thousands of rods for nothing new is felt where there is no graphics card.
    if (fiber !== hovered) hover(fiber);
  });
  view.canvas.addEventListener("pointerleave", () => hover(undefined));
  view.canvas.addEventListener("pointerdown", (event) => { pressed_at = { x: event.clientX, y: event.clientY }; });
  view.canvas.addEventListener("pointerup", (event) => {
    const moved = Math.hypot(event.clientX - pressed_at.x, event.clientY - pressed_at.y);
    if (moved < click_slack_in_pixels) choose(pick(event, view, current().placed));
  });
  return { frame_changed: () => hover(undefined), chosen: () => chosen };
}
