// Which rod is under the cursor: the nearest to the eye of those whose axis passes close to the ray.
import { Camera, Raycaster, Vector2 } from "three";
import type { PlacedRods } from "./images";

export interface PickRequest {
  camera: Camera;
  /** Cursor in normalized device coordinates. */
  cursor: Vector2;
  /** Scene units per metre. */
  factor: number;
  /** How far from the axis still counts, as a fraction of the distance from the eye. */
  tolerance: number;
}

const raycaster = new Raycaster();

/** Gives the rod's index, or nothing where the cursor is on none. */
export function pick_rod(placed: PlacedRods, request: PickRequest): number | undefined {
  raycaster.setFromCamera(request.cursor, request.camera);
  const { origin, direction } = raycaster.ray;
  let best: number | undefined;
  let nearest = Infinity;
  for (let rod = 0; rod < placed.count; ++rod) {
    const a = [0, 1, 2].map((k) => placed.starts[3 * rod + k]! * request.factor) as [number, number, number];
    const d = [0, 1, 2].map((k) => placed.ends[3 * rod + k]! * request.factor - a[k]!) as [number, number, number];
    // Closest points of the ray o + s r and the rod a + t d, with t held within the rod.
    const w = [a[0] - origin.x, a[1] - origin.y, a[2] - origin.z] as const;
    const dr = d[0] * direction.x + d[1] * direction.y + d[2] * direction.z;
    const dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const wr = w[0] * direction.x + w[1] * direction.y + w[2] * direction.z;
    const wd = w[0] * d[0] + w[1] * d[1] + w[2] * d[2];
    const across = dd - dr * dr;
    const t = across > 1e-12 * dd ? Math.min(1, Math.max(0, (dr * wr - wd) / across)) : 0.5;
    const s = wr + t * dr;
    if (s <= 0 || s >= nearest) continue;
    const gap = Math.hypot(
      w[0] + t * d[0] - s * direction.x, w[1] + t * d[1] - s * direction.y, w[2] + t * d[2] - s * direction.z,
    );
    if (gap > request.tolerance * s) continue;
    nearest = s;
    best = rod;
  }
  return best;
}
