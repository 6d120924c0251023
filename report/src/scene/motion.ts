// The motion between two frames: fibers ride with the melt's shear, and turn and drift evenly on top of it.
import { type CellState, middle_of_rods, state_of } from "./cell_state";
import type { MeasuredFrame } from "./frame";
import { type Lattice, nearest_image, shear_lattice, type Three, window_of } from "./lattice";
import { first_rod, pair_rods, rods_of } from "./pairing";

const most_sampled = 400; // fibers that vote on the strain
const most_turns = 12; // whole passings of the cell by itself between two frames
const parts_of_a_turn = 24; // tried between walls, whose lattice tells nothing

/** What one fiber does between two frames; its rods in the earlier frame, and both middles. */
interface Path {
  fiber: number;
  first: number;
  count: number;
  earlier: number;
  from: Three;
  to: Three;
}

function shear(x: Three, strain: number): Three {
  return [x[0] + strain * x[1], x[1], x[2]];
}

function count_up(first: number, count: number): number[] {
  return Array.from({ length: count }, (_unused, k) => first + k);
}

/** Lists the fibers of `to` whose rods all were neighbours in one fiber of `from`. */
function find_paths(from: CellState, to: CellState, pairs: Int32Array): Path[] {
  const paths: Path[] = [];
  for (let fiber = 0; fiber < to.frame.fibers; ++fiber) {
    const first = first_rod(to.frame, fiber);
    const count = rods_of(to.frame, fiber);
    const earlier = pairs[first] ?? -1;
    if (count === 0 || earlier < 0 || pairs[first + count - 1] !== earlier + count - 1) continue;
    paths.push({
      fiber, first, count, earlier,
      from: middle_of_rods(from.starts, from.ends, count_up(earlier, count)),
      to: middle_of_rods(to.starts, to.ends, count_up(first, count)),
    });
  }
  return paths;
}

/** Tells how far fibers would have strayed from the melt, were this the strain: the mean square over some of them. */
function stray(paths: Path[], to: Lattice, strain: number): number {
  const every = Math.max(1, Math.floor(paths.length / most_sampled));
  let sum = 0;
  for (let k = 0; k < paths.length; k += every) {
    const carried = shear(paths[k]!.from, strain);
    const away = nearest_image(to, paths[k]!.to.map((value, axis) => value - carried[axis]!) as Three);
    sum += away[0] ** 2;
  }
  return sum;
}

/**
 * Finds the strain between two frames. The lattices tell it but for whole passings of the cell by itself; those follow
 * from the document where it tells strains, else from the fibers, which stray least from the melt at the true one.
 */
function find_strain(from: CellState, to: CellState, paths: Path[]): number | undefined {
  if (!window_of(from) || !window_of(to) || Math.abs(from.lattice[4]! - to.lattice[4]!) > 1e-6 * to.lattice[4]!) return undefined;
  const least = to.lattice[1]! / to.lattice[4]! - from.lattice[1]! / from.lattice[4]!;
  const period = to.lattice[0]! / to.lattice[4]!;
  if (from.frame.strain !== undefined && to.frame.strain !== undefined) {
    const told = to.frame.strain - from.frame.strain;
    // Walls keep their lattice as it is: then nothing but the document tells.
    return to.periodic[1] ? least + period * Math.round((told - least) / period) : told;
  }
  const parts = to.periodic[1] ? 1 : parts_of_a_turn;
  const candidates = count_up(-most_turns * parts, 2 * most_turns * parts + 1).map((turns) => least + (turns * period) / parts);
  const scores = candidates.map((strain) => stray(paths, to, strain));
  const best = Math.min(...scores);
  // The smallest strain among the best: still cells and cells without fibers do not turn.
  return candidates.filter((_strain, k) => scores[k]! <= best * 1.0001).sort((a, b) => Math.abs(a) - Math.abs(b))[0];
}

/** Turns a rod evenly from one direction to another, with its length between both. */
function turn(a: Three, b: Three, share: number): Three {
  const [la, lb] = [Math.hypot(...a), Math.hypot(...b)];
  const length = la + share * (lb - la);
  const cosine = Math.min(1, Math.max(-1, (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (la * lb || 1)));
  const angle = Math.acos(cosine);
  const sine = Math.sin(angle);
  const [wa, wb] = sine < 1e-4 ? [1 - share, share] : [Math.sin((1 - share) * angle) / sine, Math.sin(share * angle) / sine];
  const mixed = [0, 1, 2].map((k) => (wa * a[k]!) / (la || 1) + (wb * b[k]!) / (lb || 1)) as Three;
  const norm = Math.hypot(...mixed) || 1;
  return mixed.map((value) => (value * length) / norm) as Three;
}

function rod_of(state: CellState, rod: number): Three {
  return [0, 1, 2].map((k) => state.ends[3 * rod + k]! - state.starts[3 * rod + k]!) as Three;
}

/** Lays a chain of rods out from its first node, then moves it to where its middle is. */
function lay_chain(out: CellState, first: number, rods: Three[], middle: Three): void {
  const at: Three = [0, 0, 0];
  rods.forEach((rod, k) => {
    for (const axis of [0, 1, 2] as const) {
      out.starts[3 * (first + k) + axis] = at[axis];
      at[axis] += rod[axis];
      out.ends[3 * (first + k) + axis] = at[axis];
    }
  });
  const found = middle_of_rods(out.starts, out.ends, count_up(first, rods.length));
  for (let k = first; k < first + rods.length; ++k) {
    for (const axis of [0, 1, 2] as const) {
      const shift = middle[axis] - found[axis];
      out.starts[3 * k + axis]! += shift;
      out.ends[3 * k + axis]! += shift;
    }
  }
}

/** Puts fibers that have no past where the melt comes from. */
function carry_back(out: CellState, to: CellState, strain: number): void {
  for (const [ends, source] of [[out.starts, to.starts], [out.ends, to.ends]] as const) {
    for (let k = 0; k < source.length; k += 3) ends.set(shear([source[k]!, source[k + 1]!, source[k + 2]!], strain), k);
  }
}

/** Mixes the curvature at both ends of a fiber's rods. */
function mix_curvature(out: CellState, from: CellState, to: CellState, path: Path, share: number): void {
  for (let k = 0; k < 2 * path.count; ++k) {
    const [a, b] = [from.curvature[2 * path.earlier + k]!, to.curvature[2 * path.first + k]!];
    out.curvature[2 * path.first + k] = a + share * (b - a);
  }
}

export interface Motion {
  /** Shear strain from one frame to the other; nothing where it cannot be told. */
  strain: number | undefined;
  /** Gives the cell at a share of the way, above 0 and up to 1: with the fibers of the later frame. */
  at: (share: number) => CellState;
}

/** Prepares the motion from one frame to the next. */
export function make_motion(from_frame: MeasuredFrame, to_frame: MeasuredFrame): Motion {
  const [from, to] = [state_of(from_frame), state_of(to_frame)];
  const paths = find_paths(from, to, pair_rods(from.frame, to.frame));
  const strain = find_strain(from, to, paths);
  const out = state_of(to_frame);
  const at = (share: number): CellState => {
    out.time_s = from.time_s + share * (to.time_s - from.time_s);
    if (strain === undefined) return out;
    if (out.periodic[1]) out.lattice = shear_lattice(from.lattice, share * strain);
    carry_back(out, to, (share - 1) * strain);
    for (const path of paths) {
      const carried = shear(path.from, strain);
      const away = nearest_image(to, path.to.map((value, k) => value - carried[k]!) as Three);
      const drift = shear(away, -strain);
      const middle = shear(path.from.map((value, k) => value + share * drift[k]!) as Three, share * strain);
      const rods = count_up(0, path.count).map((k) => turn(rod_of(from, path.earlier + k), rod_of(to, path.first + k), share));
      lay_chain(out, path.first, rods, middle);
      mix_curvature(out, from, to, path, share);
    }
    return out;
  };
  return { strain, at };
}
