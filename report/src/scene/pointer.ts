// Pointing at fibers: hovering tells about one, a click follows all pieces of its birth fiber through time.
import { Vector2 } from "three";
import { make } from "../dom";
import type { MeasuredFrame } from "./colouring";
import { show_fiber } from "./fiber_facts";
import type { PlacedRods } from "./images";
import { pick_rod } from "./picking";
import type { View } from "./view";

export interface Pointer {
  /** Forgets the fiber under the cursor: numbers of fibers change when fibers break. */
  frame_changed: () => void;
}

interface Current {
  measured: MeasuredFrame;
  placed: PlacedRods;
}

/** How close in screen pixels the cursor must come. */
const reach_in_pixels = 5;

/** A drag turns the camera; a press that hardly moves is a click. */
const click_slack_in_pixels = 4;

export function follow_pointer(stage: HTMLElement, view: View, current: () => Current): Pointer {
  const box = make("div", { class: "fiber-facts", role: "status", hidden: true });
  stage.append(box);
  let family: number | undefined;
  let pressed_at = { x: 0, y: 0 };

  const find_fiber = (event: PointerEvent): number | undefined => {
    const area = view.canvas.getBoundingClientRect();
    const x = (event.clientX - area.left) / area.width;
    const y = (event.clientY - area.top) / area.height;
    const half_height = Math.tan((view.camera.fov * Math.PI) / 360);
    const { placed } = current();
    const rod = pick_rod(placed, {
      camera: view.camera, cursor: new Vector2(2 * x - 1, 1 - 2 * y), factor: view.factor,
      tolerance: (reach_in_pixels * 2 * half_height) / area.height,
    });
    return rod === undefined ? undefined : placed.fiber[rod];
  };

  let hovered: number | undefined;
  const hover = (fiber: number | undefined): void => {
    hovered = fiber;
    box.hidden = fiber === undefined;
    if (fiber !== undefined) show_fiber(box, current().measured, fiber);
    view.rods.emphasize(fiber, family);
    view.redraw();
  };

  const choose = (fiber: number | undefined): void => {
    family = fiber === undefined ? undefined : current().measured.frame.birth[fiber];
    if (family === undefined) delete stage.dataset.family;
    else stage.dataset.family = String(family);
    hover(fiber);
  };

  view.canvas.addEventListener("pointermove", (event) => {
    const fiber = event.buttons === 0 ? find_fiber(event) : undefined;
    // Drawing thousands of rods for nothing new is felt where there is no graphics card.
    if (fiber !== hovered) hover(fiber);
  });
  view.canvas.addEventListener("pointerleave", () => hover(undefined));
  view.canvas.addEventListener("pointerdown", (event) => { pressed_at = { x: event.clientX, y: event.clientY }; });
  view.canvas.addEventListener("pointerup", (event) => {
    const moved = Math.hypot(event.clientX - pressed_at.x, event.clientY - pressed_at.y);
    if (moved < click_slack_in_pixels) choose(find_fiber(event));
  });
  return { frame_changed: () => hover(undefined) };
}
