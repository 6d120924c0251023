// The twelve edges of the periodic cell.
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import type { CellFrame } from "./frame";

export interface CellOutline {
  lines: LineSegments;
  place: (frame: CellFrame, factor: number) => void;
  set_colour: (colour: string) => void;
}

type Three = [number, number, number];

/** Gives the corner at fractions (a, b, c) of the lattice vectors [m]. */
export function corner_of(frame: CellFrame, fractions: Three): Three {
  return [0, 1, 2].map((k) => {
    const row = frame.lattice.slice(3 * k, 3 * k + 3);
    return frame.origin[k]! + row[0]! * fractions[0] + row[1]! * fractions[1] + row[2]! * fractions[2];
  }) as Three;
}

export function make_cell_outline(): CellOutline {
  const geometry = new BufferGeometry();
  const positions = new BufferAttribute(new Float32Array(12 * 2 * 3), 3);
  geometry.setAttribute("position", positions);
  const material = new LineBasicMaterial({ transparent: true, opacity: 0.75 });
  const lines = new LineSegments(geometry, material);
  lines.frustumCulled = false;
  const place = (frame: CellFrame, factor: number): void => {
    let at = 0;
    for (let axis = 0; axis < 3; ++axis) {
      for (const [p, q] of [[0, 0], [0, 1], [1, 0], [1, 1]] as const) {
        for (const along of [0, 1]) {
          const fractions: Three = [0, 0, 0];
          fractions[axis] = along;
          fractions[(axis + 1) % 3] = p;
          fractions[(axis + 2) % 3] = q;
          positions.set(corner_of(frame, fractions).map((value) => value * factor), 3 * at++);
        }
      }
    }
    positions.needsUpdate = true;
  };
  return { lines, place, set_colour: (colour) => material.color.setStyle(colour, "srgb-linear") };
}
