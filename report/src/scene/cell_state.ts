// The cell at any time: rods with both ends, and the frame whose fibers they are.
import type { MeasuredFrame } from "./frame";
import type { Lattice } from "./lattice";

export interface CellState extends Lattice, MeasuredFrame {
  time_s: number;
  /** Ends of the rods, xyz [m], unwrapped along a fiber. */
  starts: Float32Array;
  ends: Float32Array;
  /** Curvature at the start and end of each rod [1/m]. */
  curvature: Float32Array;
  /** Fiber of each rod. */
  fiber: Int32Array;
}

/** Makes the state that a frame holds. */
export function state_of({ frame, measures }: MeasuredFrame): CellState {
  const { offsets, points, fibers, rods } = frame;
  const state: CellState = {
    frame, measures, time_s: frame.time_s, lattice: frame.lattice, origin: frame.origin, periodic: frame.periodic,
    starts: new Float32Array(3 * rods), ends: new Float32Array(3 * rods),
    curvature: new Float32Array(2 * rods), fiber: new Int32Array(rods),
  };
  let rod = 0;
  for (let fiber = 0; fiber < fibers; ++fiber) {
    for (let node = offsets[fiber]!; node < offsets[fiber + 1]! - 1; ++node, ++rod) {
      for (let k = 0; k < 3; ++k) {
        state.starts[3 * rod + k] = points[3 * node + k]!;
        state.ends[3 * rod + k] = points[3 * node + 3 + k]!;
      }
      state.curvature[2 * rod] = measures.curvature[node]!;
      state.curvature[2 * rod + 1] = measures.curvature[node + 1]!;
      state.fiber[rod] = fiber;
    }
  }
  return state;
}

/** Gives the middle of some rods, as the mean of their middles. */
export function middle_of_rods(starts: Float32Array, ends: Float32Array, rods: Iterable<number>): [number, number, number] {
  const middle: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (const rod of rods) {
    ++count;
    for (const k of [0, 1, 2] as const) middle[k] += (starts[3 * rod + k]! + ends[3 * rod + k]!) / 2;
  }
  for (const k of [0, 1, 2] as const) middle[k] /= Math.max(1, count);
  return middle;
}
