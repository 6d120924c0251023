// The numbers of the rods in one texture, from which the shader takes those of each.
import { DataTexture, FloatType, NearestFilter, RGBAFormat } from "three";
import type { CellFrame } from "./frame";
import type { PlacedRods } from "./images";

const rods_a_row = 1024;
const numbers_a_rod = 12; // in three texels

/** What a shader needs to read the table: start and radius, finish and fiber, colours at both ends and birth fiber. */
export const read_rods = /* glsl */ `
uniform highp sampler2D rods;
vec4 texel_of(int rod, int which) {
  return texelFetch(rods, ivec2(3 * (rod % ${rods_a_row}) + which, rod / ${rods_a_row}), 0);
}`;

export class RodTable {
  texture: DataTexture;
  private numbers!: Float32Array;

  constructor(capacity: number) {
    this.texture = this.make(capacity);
  }

  /** Writes where rods are; lengths are multiplied by `factor` to be in scene units. */
  place(placed: PlacedRods, frame: CellFrame, factor: number): void {
    // A window shows some rods twice, as many as stick out of it: their number changes with time.
    if (numbers_a_rod * placed.count > this.numbers.length) {
      this.texture.dispose();
      this.texture = this.make(Math.ceil(1.3 * placed.count));
    }
    const { numbers } = this;
    for (let rod = 0, at = 0; rod < placed.count; ++rod, at += numbers_a_rod) {
      const fiber = placed.fiber[rod]!;
      for (let k = 0; k < 3; ++k) {
        numbers[at + k] = placed.starts[3 * rod + k]! * factor;
        numbers[at + 4 + k] = placed.ends[3 * rod + k]! * factor;
      }
      numbers[at + 3] = frame.radius[fiber]! * factor;
      numbers[at + 7] = fiber;
      numbers[at + 10] = frame.birth[fiber]!;
    }
    this.texture.needsUpdate = true;
  }

  /** Writes the place in the colour table at both ends of every rod. */
  colour(places: Float32Array): void {
    for (let k = 0; k < places.length; ++k) this.numbers[numbers_a_rod * (k >> 1) + 8 + (k & 1)] = places[k]!;
    this.texture.needsUpdate = true;
  }

  private make(capacity: number): DataTexture {
    const rows = Math.max(1, Math.ceil(capacity / rods_a_row));
    this.numbers = new Float32Array(numbers_a_rod * rods_a_row * rows);
    const texture = new DataTexture(this.numbers, 3 * rods_a_row, rows, RGBAFormat, FloatType);
    texture.magFilter = NearestFilter;
    texture.minFilter = NearestFilter;
    return texture;
  }
}
