// The edges of the window onto the cell, and lines in its far face that the melt carries along.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from "three";
import { type CellWindow, has_cell, type Lattice, type Three, times, window_of } from "./lattice";

export interface CellOutline {
  group: Group;
  /** Puts edges and lines in place for a window that may have left its home. */
  place: (cell: Lattice, factor: number, shift: Three) => void;
  set_colour: (colour: string) => void;
}

/** Gives the corner at fractions of the lattice vectors, or of the window where there is one [m]. */
export function corner_of(cell: Lattice, fractions: Three): Three {
  const window = window_of(cell);
  const away = window ? fractions.map((share, k) => share * window.size[k]!) : times(cell.lattice, fractions);
  return away.map((value, k) => value + cell.origin[k]!) as Three;
}

function edges_of(cell: Lattice): number[] {
  const positions: number[] = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (const [p, q] of [[0, 0], [0, 1], [1, 0], [1, 1]] as const) {
      for (const along of [0, 1]) {
        const fractions: Three = [0, 0, 0];
        fractions[axis] = along;
        fractions[(axis + 1) % 3] = p;
        fractions[(axis + 2) % 3] = q;
        positions.push(...corner_of(cell, fractions));
      }
    }
  }
  return positions;
}

/**
 * Lists lines of constant place along x in the undeformed melt, about as far apart as the cell is high, tilted by what
 * the melt has sheared since they were upright; what lies outside the window is left out.
 */
function flow_lines(window: CellWindow, tilt: number, { apart, foot: first }: { apart: number; foot: number }): number[] {
  const [width, height] = window.size;
  const positions: number[] = [];
  for (let foot = first - 3 * apart; foot < width + 3 * apart; foot += apart) {
    // x(share) = foot + tilt share; the part of it within 0 and the width.
    const bounds = tilt === 0 ? [0, 1] : [(0 - foot) / tilt, (width - foot) / tilt].sort((a, b) => a - b) as [number, number];
    const [from, to] = [Math.max(0, bounds[0]!), Math.min(1, bounds[1]!)];
    if (to <= from || (tilt === 0 && (foot < 0 || foot > width))) continue;
    for (const share of [from, to]) positions.push(window.low[0] + foot + tilt * share, window.low[1] + height * share, window.low[2]);
  }
  return positions;
}

function make_lines(opacity: number): LineSegments<BufferGeometry, LineBasicMaterial> {
  const lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity }));
  lines.frustumCulled = false;
  return lines;
}

function set_positions(lines: LineSegments, positions: number[], factor: number): void {
  lines.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions, (value) => value * factor), 3));
}

export function make_cell_outline(): CellOutline {
  const edges = make_lines(0.75);
  const leaning = [make_lines(0.5), make_lines(0.5)];
  const group = new Group();
  group.add(edges, ...leaning);
  const place: CellOutline["place"] = (cell, factor, shift) => {
    set_positions(edges, has_cell(cell) ? edges_of(cell) : [], factor);
    const window = window_of(cell);
    if (!window) return;
    const apart = window.size[0] / Math.max(1, Math.round(window.size[0] / window.size[1]));
    // Lines that lean by one distance stand where their neighbours stood: two sets trade places without a jump.
    const turns = cell.lattice[1]! / apart;
    const share = turns - Math.floor(turns);
    [share, share - 1].forEach((one, k) => {
      const foot = one * apart * (shift[1] / window.size[1]) - shift[0];
      set_positions(leaning[k]!, flow_lines(window, one * apart, { apart, foot: foot - apart * Math.floor(foot / apart) }), factor);
      leaning[k]!.material.opacity = 0.5 * (1 - Math.abs(one));
    });
  };
  const set_colour = (colour: string): void => {
    for (const lines of [edges, ...leaning]) lines.material.color.setStyle(colour, "srgb-linear");
  };
  return { group, place, set_colour };
}
