// The frames of a section: decoded when they are wanted, and the cell at any position between them.
import type { FiberFrame } from "../document";
import { type CellState, state_of } from "./cell_state";
import { type CellFrame, decode_frame, type MeasuredFrame, measure_frame } from "./frame";
import { make_motion, type Motion } from "./motion";

const most_kept_bytes = 2e8; // of base64 of decoded frames; what is more is decoded again
const most_measured_bytes = 4e6; // of base64: so much is measured while the page opens, with all frames if they are small
const fewest_samples = 6; // frames from which ranges are taken where there are many large ones

export class FrameStore {
  readonly times: number[];
  private readonly kept = new Map<number, MeasuredFrame>();
  private motion: { index: number; motion: Motion } | undefined;
  private readonly room: number;
  private readonly sampled: number;

  constructor(private readonly raw: FiberFrame[]) {
    this.times = raw.map(({ time_s }) => time_s);
    const largest = Math.max(...raw.map(({ points, grid }) => (points ?? grid?.steps ?? "").length), 1);
    this.room = Math.max(3, Math.floor(most_kept_bytes / largest));
    this.sampled = Math.min(this.room, Math.max(fewest_samples, Math.floor(most_measured_bytes / largest)));
  }

  duration(): number {
    return this.times.at(-1)! - this.times[0]!;
  }

  /** Gives a frame, decoded and measured. */
  frame(index: number): MeasuredFrame {
    const known = this.kept.get(index);
    if (known) return known;
    const frame = decode_frame(this.raw[index]!);
    const made = { frame, measures: measure_frame(frame) };
    if (this.kept.size >= this.room) this.kept.delete(this.kept.keys().next().value!);
    this.kept.set(index, made);
    return made;
  }

  /** Gives some frames that stand for all: the first, the last, and a few between. */
  samples(): MeasuredFrame[] {
    const last = this.raw.length - 1;
    if (last < this.sampled) return this.raw.map((_frame, index) => this.frame(index));
    return Array.from({ length: this.sampled }, (_unused, k) => this.frame(Math.round((k * last) / (this.sampled - 1))));
  }

  /** Gives all frames, one after the other. */
  *all(): Generator<CellFrame> {
    for (let index = 0; index < this.raw.length; ++index) yield this.frame(index).frame;
  }

  /** Gives the cell at a position: a frame where it is whole, the motion between two where it is not. */
  at(position: number): CellState {
    const index = Math.floor(position);
    if (position === index) return state_of(this.frame(index));
    if (this.motion?.index !== index) this.motion = { index, motion: make_motion(this.frame(index), this.frame(index + 1)) };
    return this.motion.motion.at(position - index);
  }
}
