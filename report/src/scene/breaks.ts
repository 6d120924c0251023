// Where and when fibers broke: told by the document, or seen between frames.
import type { FiberBreaks } from "../document";
import { type CellFrame, decode_base64 } from "./frame";
import type { CellState } from "./cell_state";
import { first_rod, rods_of } from "./pairing";

/** One broken hinge: its fiber at birth, and its node along that. */
export interface Break {
  time_s: number;
  birth: number;
  node: number;
}

/** Decodes the breaks that a document tells. */
export function decode_breaks(breaks: FiberBreaks): Break[] {
  const times = new Float32Array(decode_base64(breaks.time_s));
  const births = new Int32Array(decode_base64(breaks.birth));
  const nodes = new Int32Array(decode_base64(breaks.node));
  return Array.from(times, (time_s, k) => ({ time_s, birth: births[k]!, node: nodes[k]! }));
}

function key(birth: number, node: number): string {
  return `${birth}:${node}`;
}

function ends_of(frame: CellFrame): Set<string> {
  const ends = new Set<string>();
  for (let fiber = 0; fiber < frame.fibers; ++fiber) {
    const start = frame.birth_node![fiber]!;
    ends.add(key(frame.birth[fiber]!, start)).add(key(frame.birth[fiber]!, start + rods_of(frame, fiber)));
  }
  return ends;
}

/** Finds the ends that are new in each frame; they broke at some time since the frame before. */
export function see_breaks(frames: Iterable<CellFrame>): Break[] {
  const breaks: Break[] = [];
  let known: { ends: Set<string>; time_s: number } | undefined;
  for (const frame of frames) {
    if (!frame.birth_node) return [];
    const ends = ends_of(frame);
    for (const end of known ? ends : []) {
      if (known!.ends.has(end)) continue;
      const [birth, node] = end.split(":").map(Number) as [number, number];
      breaks.push({ time_s: (known!.time_s + frame.time_s) / 2, birth, node });
    }
    known = { ends, time_s: frame.time_s };
  }
  return breaks;
}

/** Looks breaks up by fiber and node. */
export class BreakTimes {
  private readonly times = new Map<string, number>();

  constructor(readonly breaks: Break[]) {
    for (const { birth, node, time_s } of breaks) this.times.set(key(birth, node), time_s);
  }

  /** Gives how long ago a fiber broke last at either end, s; nothing for one that has not. */
  age(frame: CellFrame, fiber: number, time_s: number): number | undefined {
    const start = frame.birth_node?.[fiber];
    if (start === undefined) return undefined;
    const birth = frame.birth[fiber]!;
    const found = [start, start + rods_of(frame, fiber)].map((node) => this.times.get(key(birth, node)))
      .filter((time): time is number => time !== undefined && time <= time_s);
    return found.length > 0 ? time_s - Math.max(...found) : undefined;
  }
}

/** Gives the places of the breaks in a span of time, xyz [m] each and its age, s. */
export function place_breaks(state: CellState, breaks: Break[], since: number): { at: [number, number, number]; age: number }[] {
  const recent = breaks.filter(({ time_s }) => time_s > since && time_s <= state.time_s);
  if (recent.length === 0) return [];
  const wanted = new Map(recent.map((one) => [key(one.birth, one.node), one.time_s]));
  const places: { at: [number, number, number]; age: number }[] = [];
  const { frame, starts } = state;
  for (let fiber = 0; fiber < frame.fibers; ++fiber) {
    const node = frame.birth_node?.[fiber];
    const time_s = node === undefined ? undefined : wanted.get(key(frame.birth[fiber]!, node));
    // A break lies at the beginning of one of its two pieces: once there is enough.
    if (time_s === undefined) continue;
    const rod = first_rod(frame, fiber);
    places.push({ at: [starts[3 * rod]!, starts[3 * rod + 1]!, starts[3 * rod + 2]!], age: state.time_s - time_s });
  }
  return places;
}
