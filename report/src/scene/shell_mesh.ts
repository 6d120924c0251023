// The part as one draw: coloured where the melt is, pale where it is not yet, with a line along the front.
import {
  BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, DynamicDrawUsage, GLSL3, LinearFilter, LineBasicMaterial,
  LineSegments, Mesh, RGBAFormat, ShaderMaterial,
} from "three";
import type { Palette } from "../palette";
import { type ColourScale, table_size } from "./colouring";
import { outline_edges, type ShellData } from "./shell";

/** Stands for a node that is never filled: later than every time. */
const never = 1e30;

const vertex_shader = /* glsl */ `
in float filled;  // time at which the melt comes
in float place;   // in the colour table
out vec3 position_view;
out float fill_time;
out float table_place;
void main() {
  vec4 in_view = modelViewMatrix * vec4(position, 1.0);
  position_view = in_view.xyz;
  fill_time = filled;
  table_place = place;
  gl_Position = projectionMatrix * in_view;
}`;

const fragment_shader = /* glsl */ `
in vec3 position_view;
in float fill_time;
in float table_place;
uniform sampler2D table;
uniform float time;
uniform float contour;  // seconds between lines of equal fill time; 0: none
uniform vec3 empty;
uniform vec3 ink;
out vec4 colour;
void main() {
  vec3 n = normalize(cross(dFdx(position_view), dFdy(position_view)));
  float light = 0.72 + 0.32 * abs(dot(n, normalize(vec3(-0.25, 0.55, 0.8))));
  float late = fill_time - time;
  float width = max(fwidth(fill_time), 1e-12);
  vec3 base = texture(table, vec2(clamp(table_place, 0.002, 0.998), 0.5)).rgb;
  vec3 lit = (late > 0.0 ? empty : base) * light;
  float front = late > 0.0 || fill_time > 1e29 ? 0.0 : 1.0 - smoothstep(0.8, 2.2, -late / width);
  if (contour > 0.0 && late <= 0.0) {
    float from_line = abs(fract(fill_time / contour + 0.5) - 0.5) * contour / width;
    front = max(front, 0.55 * (1.0 - smoothstep(0.4, 1.2, from_line)));
  }
  colour = vec4(mix(lit, ink, 0.75 * front), 1.0);
}`;

export interface ShellMesh {
  mesh: Mesh;
  outline: LineSegments;
  set_time: (time: number) => void;
  set_contour: (seconds: number) => void;
  colour: (values: Float32Array, scale: ColourScale) => void;
  adapt: (palette: Palette) => void;
}

function make_material(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: vertex_shader,
    fragmentShader: fragment_shader,
    side: DoubleSide,
    // The outline lies on the surface and must win against it.
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    uniforms: {
      table: { value: null }, time: { value: 0 }, contour: { value: 0 },
      empty: { value: [0.9, 0.9, 0.9] }, ink: { value: [0, 0, 0] },
    },
  });
}

function make_outline(data: ShellData, positions: BufferAttribute): LineSegments {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", positions);
  geometry.setIndex(outline_edges(data));
  return new LineSegments(geometry, new LineBasicMaterial());
}

function as_given(colour: string): Color {
  // Colours go to the screen as they are given, without three's colour management.
  return new Color().setStyle(colour, "srgb-linear");
}

export function make_shell_mesh(data: ShellData, factor: number): ShellMesh {
  const geometry = new BufferGeometry();
  const positions = new BufferAttribute(data.points.map((value) => value * factor), 3);
  geometry.setAttribute("position", positions);
  geometry.setAttribute("filled", new BufferAttribute(data.fill_time.map((time) => (Number.isFinite(time) ? time : never)), 1));
  const places = new BufferAttribute(new Float32Array(data.nodes), 1).setUsage(DynamicDrawUsage);
  geometry.setAttribute("place", places);
  geometry.setIndex(new BufferAttribute(Uint32Array.from(data.triangles), 1));
  const material = make_material();
  const uniforms = material.uniforms as Record<string, { value: unknown }>;
  const outline = make_outline(data, positions);
  return {
    mesh: new Mesh(geometry, material),
    outline,
    set_time: (time) => { uniforms.time!.value = time; },
    set_contour: (seconds) => { uniforms.contour!.value = seconds; },
    colour: (values, scale) => {
      const span = scale.max - scale.min;
      for (let node = 0; node < data.nodes; ++node) places.array[node] = (values[node]! - scale.min) / span || 0;
      places.needsUpdate = true;
      (uniforms.table!.value as DataTexture | null)?.dispose();
      const texture = new DataTexture(scale.table, table_size, 1, RGBAFormat);
      texture.magFilter = texture.minFilter = LinearFilter;
      texture.needsUpdate = true;
      uniforms.table!.value = texture;
    },
    adapt: (palette) => {
      const [empty, ink] = [as_given(palette.grid), as_given(palette.ink)];
      uniforms.empty!.value = [empty.r, empty.g, empty.b];
      uniforms.ink!.value = [ink.r, ink.g, ink.b];
      (outline.material as LineBasicMaterial).color.copy(as_given(palette.muted));
    },
  };
}
