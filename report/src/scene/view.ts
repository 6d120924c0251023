// The view of the cell: rods, window and marks on a stage.
import { Vector3 } from "three";
import { current_palette } from "../palette";
import { type CellOutline, corner_of, make_cell_outline } from "./cell_outline";
import type { CellFrame } from "./frame";
import { has_cell, type Three } from "./lattice";
import { make_rod_mesh, type RodMesh } from "./rods";
import { draws_in_software, make_stage, type Stage } from "./stage";

export interface View extends Stage {
  rods: RodMesh;
  outline: CellOutline;
  adapt_to_scheme: () => void;
}

/** The corners of the cell, or of the box around the fibers where there is no cell [m]. */
function corners_of(frame: CellFrame): Vector3[] {
  const corners: Three[] = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => [k & 1, (k >> 1) & 1, k >> 2]);
  if (has_cell(frame)) return corners.map((fractions) => new Vector3(...corner_of(frame, fractions)));
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = new Vector3(-Infinity, -Infinity, -Infinity);
  for (let k = 0; k < frame.points.length; k += 3) {
    const at = new Vector3().fromArray(frame.points, k);
    low.min(at);
    high.max(at);
  }
  return corners.map((share) => new Vector3(...share).multiply(high.clone().sub(low)).add(low));
}

export interface ViewRequest {
  /** Rods for which there is room at first. */
  capacity: number;
  /** Called after every drawing. */
  finish: (stage: Stage) => void;
}

/** Makes the view in its host; throws where the browser has no WebGL. */
export function make_view(host: HTMLElement, first: CellFrame, { capacity, finish }: ViewRequest): View {
  const rods = make_rod_mesh(capacity, draws_in_software());
  const outline = make_cell_outline();
  const stage = make_stage(host, {
    corners: corners_of(first),
    from: new Vector3(0.42, 0.36, 1),
    crowded: capacity > 4_000,
    prepare: (palette, away) => rods.set_surroundings(palette.surface, [away - 0.6, away + 1.3]),
    finish,
  });
  stage.scene.add(rods.mesh, outline.group);
  const adapt_to_scheme = (): void => {
    outline.set_colour(current_palette().muted);
    stage.redraw();
  };
  adapt_to_scheme();
  return Object.assign(stage, { rods, outline, adapt_to_scheme });
}
