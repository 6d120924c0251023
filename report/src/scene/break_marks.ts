// Rings where fibers have just broken; they grow and fade.
import { BufferAttribute, BufferGeometry, Color, GLSL3, Points, ShaderMaterial } from "three";
import type { CellState } from "./cell_state";
import { type Break, place_breaks } from "./breaks";
import { type CellWindow, nearest_image, type Three } from "./lattice";

const vertex_shader = /* glsl */ `
in float age;  // 0 new to 1 forgotten
uniform float size;
out float fading;
void main() {
  fading = age;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_PointSize = size * (0.55 + 0.45 * age);
}`;

const fragment_shader = /* glsl */ `
in float fading;
uniform vec3 ink;
out vec4 colour;
void main() {
  float r = 2.0 * length(gl_PointCoord - 0.5);
  float ring = smoothstep(1.0, 0.9, r) * smoothstep(0.52, 0.66, r) + 0.35 * smoothstep(0.9, 0.8, r);
  colour = vec4(ink, ring * (1.0 - fading));
}`;

export interface BreakMarks {
  points: Points;
  /** Shows the breaks of the last `memory` seconds; gives how many. */
  place: (state: CellState, window: CellWindow | undefined, factor: number) => number;
}

/** Moves a place to its image in the window. */
function into_window(state: CellState, window: CellWindow, at: Three): Three {
  const middle = window.low.map((low, k) => low + window.size[k]! / 2) as Three;
  const away = nearest_image(state, at.map((value, k) => value - middle[k]!) as Three);
  return away.map((value, k) => value + middle[k]! - window.shift[k]!) as Three;
}

export function make_break_marks(breaks: Break[], memory: number): BreakMarks {
  const material = new ShaderMaterial({
    glslVersion: GLSL3, vertexShader: vertex_shader, fragmentShader: fragment_shader, transparent: true, depthTest: false,
    uniforms: { size: { value: 26 * Math.min(2, window.devicePixelRatio) }, ink: { value: new Color().setStyle("#e0245e", "srgb-linear") } },
  });
  const points = new Points(new BufferGeometry(), material);
  points.frustumCulled = false;
  points.renderOrder = 2;
  const place: BreakMarks["place"] = (state, cell_window, factor) => {
    const found = place_breaks(state, breaks, state.time_s - memory);
    const places = found.map(({ at }) => (cell_window ? into_window(state, cell_window, at) : at));
    points.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(places.flat(), (value) => value * factor), 3));
    points.geometry.setAttribute("age", new BufferAttribute(Float32Array.from(found, ({ age }) => age / memory), 1));
    points.visible = found.length > 0;
    return found.length;
  };
  return { points, place };
}
