// At which periodic images the rods are drawn.
import { type CellState, middle_of_rods } from "./cell_state";
import { type CellWindow, has_cell, invert, type Lattice, type Three, times } from "./lattice";
import { first_rod, rods_of } from "./pairing";

/** All that the window shows; whole fibers with their middle in the cell; or the positions as computed. */
export type Images = "window" | "fibers" | "computed";

/** Where the rods are drawn: ends as xyz [m], and which rod and fiber each is. A rod may be there more than once. */
export interface PlacedRods {
  count: number;
  starts: Float32Array;
  ends: Float32Array;
  rod: Int32Array;
  fiber: Int32Array;
}

class Growing {
  placed: PlacedRods;

  constructor(private readonly state: CellState) {
    const room = Math.ceil(1.25 * state.fiber.length) + 16;
    this.placed = {
      count: 0, starts: new Float32Array(3 * room), ends: new Float32Array(3 * room), rod: new Int32Array(room), fiber: new Int32Array(room),
    };
  }

  add(rod: number, shift: Three): void {
    if (this.placed.count === this.placed.rod.length) this.grow();
    const { placed, state } = this;
    const at = placed.count++;
    for (const k of [0, 1, 2] as const) {
      placed.starts[3 * at + k] = state.starts[3 * rod + k]! + shift[k];
      placed.ends[3 * at + k] = state.ends[3 * rod + k]! + shift[k];
    }
    placed.rod[at] = rod;
    placed.fiber[at] = state.fiber[rod]!;
  }

  private grow(): void {
    const old = this.placed;
    const room = Math.ceil(1.6 * old.rod.length);
    this.placed = {
      count: old.count, starts: new Float32Array(3 * room), ends: new Float32Array(3 * room), rod: new Int32Array(room), fiber: new Int32Array(room),
    };
    for (const part of ["starts", "ends", "rod", "fiber"] as const) this.placed[part].set(old[part]);
  }
}

/** Makes the function that gives by what to shift a point so that it lies in the parallelepiped of the lattice. */
function make_shift(cell: Lattice): (point: Three) => Three {
  const inverse = has_cell(cell) ? invert(cell.lattice) : undefined;
  if (!inverse) return () => [0, 0, 0];
  const { lattice, origin, periodic } = cell;
  return (point) => {
    const inside = times(inverse, [point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]]);
    const cells = inside.map((value, k) => (periodic[k] ? -Math.floor(value) : 0)) as Three;
    return times(lattice, cells);
  };
}

/** Numbers of the images at which a span of an axis reaches into the window; one where the axis is not periodic. */
function reach(low: number, high: number, size: number, periodic: boolean): [number, number] {
  return periodic ? [-Math.floor(high / size), Math.ceil((size - low) / size) - 1] : [0, 0];
}

/** Adds every image of a rod that reaches into the window; what sticks out is cut off when it is drawn. */
function add_images(state: CellState, window: CellWindow, rod: number, growing: Growing): void {
  const { lattice: h, periodic, starts, ends } = state;
  const [low, high] = [[0, 0, 0], [0, 0, 0]] as [Three, Three];
  for (const k of [0, 1, 2] as const) {
    const radius = state.frame.radius[state.fiber[rod]!]!;
    low[k] = Math.min(starts[3 * rod + k]!, ends[3 * rod + k]!) - radius - window.low[k];
    high[k] = Math.max(starts[3 * rod + k]!, ends[3 * rod + k]!) + radius - window.low[k];
  }
  const [z0, z1] = reach(low[2], high[2], window.size[2], periodic[2]!);
  for (let nz = z0; nz <= z1; ++nz) {
    const y = nz * h[5]!;
    const [y0, y1] = reach(low[1] + y, high[1] + y, window.size[1], periodic[1]!);
    for (let ny = y0; ny <= y1; ++ny) {
      const x = nz * h[2]! + ny * h[1]!;
      const [x0, x1] = reach(low[0] + x, high[0] + x, window.size[0], periodic[0]!);
      for (let nx = x0; nx <= x1; ++nx) {
        growing.add(rod, [nx * h[0]! + x - window.shift[0], ny * h[4]! + y - window.shift[1], nz * h[8]! - window.shift[2]]);
      }
    }
  }
}

function range(first: number, count: number): number[] {
  return Array.from({ length: count }, (_unused, k) => first + k);
}

/** Places the rods of a state; without a window the images in it are those of the parallelepiped. */
export function place_rods(state: CellState, images: Images, window: CellWindow | undefined): PlacedRods {
  const growing = new Growing(state);
  const shift_of = make_shift(state);
  for (let fiber = 0; fiber < state.frame.fibers; ++fiber) {
    const rods = range(first_rod(state.frame, fiber), rods_of(state.frame, fiber));
    const shift: Three = images === "fibers" && rods.length > 0 ? shift_of(middle_of_rods(state.starts, state.ends, rods)) : [0, 0, 0];
    for (const rod of rods) {
      if (images !== "window") growing.add(rod, shift);
      else if (window) add_images(state, window, rod, growing);
      else growing.add(rod, shift_of(middle_of_rods(state.starts, state.ends, [rod])));
    }
  }
  return growing.placed;
}
