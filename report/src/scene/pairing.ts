// Which rod of one frame is which of the next: rods keep their number along the fiber that they were born with.
import type { CellFrame } from "./frame";

function fibers_by_birth(frame: CellFrame): Map<number, number[]> {
  const found = new Map<number, number[]>();
  for (let fiber = 0; fiber < frame.fibers; ++fiber) {
    const birth = frame.birth[fiber]!;
    const list = found.get(birth);
    if (list) list.push(fiber);
    else found.set(birth, [fiber]);
  }
  return found;
}

export function rods_of(frame: CellFrame, fiber: number): number {
  return frame.offsets[fiber + 1]! - frame.offsets[fiber]! - 1;
}

/** The number of a fiber's first rod: rods are numbered through a frame, one less than nodes a fiber. */
export function first_rod(frame: CellFrame, fiber: number): number {
  return frame.offsets[fiber]! - fiber;
}

/** Finds the earlier rod for each of a fiber's rods among the earlier pieces of its birth fiber. */
function pair_by_number(from: CellFrame, to: CellFrame, fiber: number, pieces: number[], pairs: Int32Array): void {
  const start = to.birth_node![fiber]!;
  for (const piece of pieces) {
    const shift = from.birth_node![piece]! - start;
    const first = Math.max(0, shift);
    const last = Math.min(rods_of(to, fiber), shift + rods_of(from, piece));
    for (let k = first; k < last; ++k) pairs[first_rod(to, fiber) + k] = first_rod(from, piece) + k - shift;
  }
}

/** Documents that do not number nodes tell only of fibers that have not broken in between. */
function pair_by_count(from: CellFrame, to: CellFrame, fiber: number, pieces: number[], pairs: Int32Array): void {
  const count = rods_of(to, fiber);
  const same = pieces.filter((piece) => rods_of(from, piece) === count);
  if (same.length !== 1) return;
  for (let k = 0; k < count; ++k) pairs[first_rod(to, fiber) + k] = first_rod(from, same[0]!) + k;
}

/** Gives for every rod of `to` the rod of `from` that it was, or -1. */
export function pair_rods(from: CellFrame, to: CellFrame): Int32Array {
  const pairs = new Int32Array(to.rods).fill(-1);
  const numbered = from.birth_node !== undefined && to.birth_node !== undefined;
  const earlier = fibers_by_birth(from);
  for (let fiber = 0; fiber < to.fibers; ++fiber) {
    const pieces = earlier.get(to.birth[fiber]!) ?? [];
    if (numbered) pair_by_number(from, to, fiber, pieces, pairs);
    else pair_by_count(from, to, fiber, pieces, pairs);
  }
  return pairs;
}
