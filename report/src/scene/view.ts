// The view of the cell: rods and outline on a stage.
import { Vector3 } from "three";
import { current_palette } from "../palette";
import { type CellOutline, corner_of, make_cell_outline } from "./cell_outline";
import type { CellFrame } from "./frame";
import { has_cell } from "./images";
import { make_rod_mesh, type RodMesh } from "./rods";
import { make_stage, type Stage } from "./stage";

export interface View extends Stage {
  rods: RodMesh;
  outline: CellOutline;
  adapt_to_scheme: () => void;
}

/** The ball around the cell, or around the fibers where there is no cell [m]. */
function measure_extent(frame: CellFrame): { middle: Vector3; radius: number } {
  const corners: Vector3[] = [];
  if (has_cell(frame)) {
    for (let k = 0; k < 8; ++k) corners.push(new Vector3(...corner_of(frame, [k & 1, (k >> 1) & 1, k >> 2])));
  } else {
    for (let k = 0; k < frame.points.length; k += 3) corners.push(new Vector3().fromArray(frame.points, k));
  }
  const middle = new Vector3();
  for (const corner of corners) middle.addScaledVector(corner, 1 / corners.length);
  const radius = Math.max(1e-9, ...corners.map((corner) => corner.distanceTo(middle)));
  return { middle, radius };
}

/** Makes the view in its host; throws where the browser has no WebGL. */
export function make_view(host: HTMLElement, first: CellFrame, capacity: number): View {
  const rods = make_rod_mesh(capacity);
  const outline = make_cell_outline();
  outline.lines.visible = has_cell(first);
  const stage = make_stage(host, {
    ...measure_extent(first),
    from: new Vector3(0.42, 0.36, 1),
    crowded: capacity > 4_000,
    prepare: (palette, away) => rods.set_surroundings(palette.surface, [away - 0.6, away + 1.3]),
  });
  stage.scene.add(rods.mesh, outline.lines);
  const adapt_to_scheme = (): void => {
    outline.set_colour(current_palette().muted);
    stage.redraw();
  };
  adapt_to_scheme();
  return Object.assign(stage, { rods, outline, adapt_to_scheme });
}
