// At which periodic image each rod is drawn.
import type { CellFrame } from "./frame";

/** Rods in the cell; whole fibers with their middle in the cell; or the positions as computed. */
export type Images = "rods" | "fibers" | "computed";

type Three = [number, number, number];

/** Inverts a 3 by 3 row-major matrix; nothing for a cell without volume. */
function invert(m: number[]): number[] | undefined {
  const [a, b, c, d, e, f, g, h, i] = m as [number, number, number, number, number, number, number, number, number];
  const determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  if (!(Math.abs(determinant) > 0)) return undefined;
  return [
    e * i - f * h, c * h - b * i, b * f - c * e,
    f * g - d * i, a * i - c * g, c * d - a * f,
    d * h - e * g, b * g - a * h, a * e - b * d,
  ].map((cofactor) => cofactor / determinant);
}

function times(m: number[], x: Three): Three {
  return [0, 3, 6].map((row) => m[row]! * x[0] + m[row + 1]! * x[1] + m[row + 2]! * x[2]) as Three;
}

export function has_cell(frame: CellFrame): boolean {
  return frame.lattice.length === 9 && invert(frame.lattice) !== undefined;
}

/** Makes the function that gives by what to shift a point so that it lies in the cell. */
function make_shift(frame: CellFrame): (point: Three) => Three {
  const inverse = has_cell(frame) ? invert(frame.lattice) : undefined;
  if (!inverse) return () => [0, 0, 0];
  const { lattice, origin, periodic } = frame;
  return (point) => {
    const inside = times(inverse, [point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]]);
    const cells = inside.map((value, k) => (periodic[k] ? -Math.floor(value) : 0)) as Three;
    return times(lattice, cells);
  };
}

function middle_of(points: Float32Array, first: number, last: number): Three {
  return [0, 1, 2].map((k) => {
    let sum = 0;
    for (let node = first; node <= last; ++node) sum += points[3 * node + k]!;
    return sum / (last - first + 1);
  }) as Three;
}

/** Where the rods are drawn: ends as xyz [m], and to which fiber and node each belongs. */
export interface PlacedRods {
  count: number;
  starts: Float32Array;
  ends: Float32Array;
  fiber: Int32Array;
  first_node: Int32Array;
}

export function place_rods(frame: CellFrame, images: Images): PlacedRods {
  const { offsets, points, fibers, rods } = frame;
  const placed: PlacedRods = {
    count: rods,
    starts: new Float32Array(3 * rods),
    ends: new Float32Array(3 * rods),
    fiber: new Int32Array(rods),
    first_node: new Int32Array(rods),
  };
  const shift_of = make_shift(frame);
  let rod = 0;
  for (let fiber = 0; fiber < fibers; ++fiber) {
    const first = offsets[fiber]!;
    const last = offsets[fiber + 1]! - 1;
    let shift: Three = images === "fibers" ? shift_of(middle_of(points, first, last)) : [0, 0, 0];
    for (let node = first; node < last; ++node, ++rod) {
      if (images === "rods") shift = shift_of(middle_of(points, node, node + 1));
      for (let k = 0; k < 3; ++k) {
        placed.starts[3 * rod + k] = points[3 * node + k]! + shift[k]!;
        placed.ends[3 * rod + k] = points[3 * node + 3 + k]! + shift[k]!;
      }
      placed.fiber[rod] = fiber;
      placed.first_node[rod] = node;
    }
  }
  return placed;
}
