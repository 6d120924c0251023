// A sphere beside the cell that shows how many rods point each way; it turns with the camera.
import { type Camera, Matrix4, Vector3 } from "three";
import { make } from "../dom";
import { sample_map } from "../palette";
import type { CellState } from "./cell_state";
import { make_table, table_size } from "./colouring";

const pixels = 150;
const bins = 28; // along each side of the map
const viridis = make_table((k) => sample_map("viridis", k / (table_size - 1)));
/** Readers compare times: the scale stays the same, and what is above has its last colour. */
export const sphere_top = 10;

export interface OrientationSphere {
  element: HTMLCanvasElement;
  measure: (state: CellState) => void;
  draw: (camera: Camera) => void;
}

/**
 * The half sphere around x, the direction of the flow, laid out as a square (hemi-octahedral map): no pole where bins run
 * together, and its rim, where opposite ends meet, in the plane across the flow.
 */
function to_map(x: number, y: number, z: number): [number, number] {
  const sign = x < 0 ? -1 : 1;
  const norm = Math.abs(x) + Math.abs(y) + Math.abs(z);
  const [p, q] = [(sign * y) / norm, (sign * z) / norm];
  return [((p + q + 1) / 2) * bins - 0.5, ((p - q + 1) / 2) * bins - 0.5];
}

/** Gives the number of a bin; across the rim lie the opposite directions, which are the same. */
function bin_at(i: number, j: number): number {
  const outside = [i, j].filter((k) => k < 0 || k >= bins).length;
  if (outside === 0) return i * bins + j;
  const opposite = (k: number): number => (k < 0 ? bins - 1 : k >= bins ? 0 : bins - 1 - k);
  return outside === 1 ? opposite(i) * bins + opposite(j) : Math.max(0, Math.min(bins - 1, i)) * bins + Math.max(0, Math.min(bins - 1, j));
}

/** Gives four bins around a place of the map with their shares. */
function around([u, v]: [number, number]): [bin: number, share: number][] {
  const [i, j] = [Math.floor(u), Math.floor(v)];
  const [a, b] = [u - i, v - j];
  return [
    [bin_at(i, j), (1 - a) * (1 - b)], [bin_at(i + 1, j), a * (1 - b)],
    [bin_at(i, j + 1), (1 - a) * b], [bin_at(i + 1, j + 1), a * b],
  ];
}

/** Spreads every bin over its neighbours, 1 2 1 each way. */
function blur(values: Float32Array): Float32Array {
  const at = (from: Float32Array, i: number, j: number): number => from[bin_at(i, j)]!;
  const across = values.map((value, k) => {
    const [i, j] = [Math.floor(k / bins), k % bins];
    return (at(values, i - 1, j) + 2 * value + at(values, i + 1, j)) / 4;
  });
  return across.map((value, k) => {
    const [i, j] = [Math.floor(k / bins), k % bins];
    return (at(across, i, j - 1) + 2 * value + at(across, i, j + 1)) / 4;
  });
}

/** What directions spread evenly would leave in every bin: a Fibonacci lattice on the sphere. */
function even_shares(): Float32Array {
  const shares = new Float32Array(bins * bins);
  const count = 40_000;
  for (let k = 0; k < count; ++k) {
    const z = 1 - (2 * k + 1) / count;
    const azimuth = k * Math.PI * (3 - Math.sqrt(5));
    const flat = Math.sqrt(1 - z * z);
    for (const [bin, share] of around(to_map(flat * Math.cos(azimuth), flat * Math.sin(azimuth), z))) shares[bin]! += share / count;
  }
  return blur(shares);
}

/** Sums the length of rods by direction; a rod points both ways. Gives multiples of the isotropic density. */
function density_of({ starts, ends }: CellState, even: Float32Array): Float32Array {
  const sums = new Float32Array(bins * bins);
  let total = 0;
  for (let k = 0; k < starts.length; k += 3) {
    const [x, y, z] = [ends[k]! - starts[k]!, ends[k + 1]! - starts[k + 1]!, ends[k + 2]! - starts[k + 2]!];
    const length = Math.hypot(x, y, z);
    if (!(length > 0)) continue;
    for (const [bin, share] of around(to_map(x, y, z))) sums[bin]! += share * length;
    total += length;
  }
  return blur(sums).map((sum, bin) => sum / (total * even[bin]! || 1));
}

export function make_orientation_sphere(): OrientationSphere {
  const element = make("canvas", { class: "sphere", width: pixels, height: pixels, role: "img", "aria-label": "Density of rod directions on a sphere that turns with the view" });
  const pen = element.getContext("2d")!;
  const image = pen.createImageData(pixels, pixels);
  const even = even_shares();
  let density: Float32Array = new Float32Array(bins * bins);
  const draw = (camera: Camera): void => {
    const to_world = new Matrix4().extractRotation(camera.matrixWorld);
    const direction = new Vector3();
    for (let row = 0; row < pixels; ++row) {
      for (let column = 0; column < pixels; ++column) {
        const [x, y] = [(2 * (column + 0.5)) / pixels - 1, 1 - (2 * (row + 0.5)) / pixels];
        const square = x * x + y * y;
        const at = 4 * (row * pixels + column);
        image.data[at + 3] = square < 1 ? Math.min(255, (1 - square) * pixels * 255) : 0;
        if (square >= 1) continue;
        direction.set(x, y, Math.sqrt(1 - square)).applyMatrix4(to_world);
        const light = 0.8 + 0.2 * Math.sqrt(1 - square);
        // The square root shows the thin parts of a distribution beside its peak.
        const found = around(to_map(direction.x, direction.y, direction.z)).reduce((sum, [bin, share]) => sum + share * density[bin]!, 0);
        const entry = 4 * Math.round((table_size - 1) * Math.min(1, Math.sqrt(found / sphere_top)));
        for (const k of [0, 1, 2]) image.data[at + k] = light * viridis[entry + k]!;
      }
    }
    pen.putImageData(image, 0, 0);
  };
  return { element, measure: (state) => { density = density_of(state, even); }, draw };
}
