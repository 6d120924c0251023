// All rods as one instanced draw: a capsule that the vertex shader stretches between its two nodes.
import {
  BufferAttribute, DataTexture, DoubleSide, DynamicDrawUsage, GLSL3, InstancedBufferAttribute, InstancedBufferGeometry,
  LinearFilter, Mesh, NearestFilter, RGBAFormat, ShaderMaterial, Color,
} from "three";
import { type ColourScale, table_size } from "./colouring";
import type { CellFrame } from "./frame";
import type { PlacedRods } from "./images";
import type { Three } from "./lattice";

const vertex_shader = /* glsl */ `
in vec4 shape;  // direction from the axis, and which end: 0 start, 1 finish
in vec3 start;
in vec3 finish;
in float radius;
in vec2 place;  // in the colour table, at both ends
in vec2 ids;    // fiber, birth fiber
uniform float thickness;
uniform float hovered;
uniform float family;
out vec3 normal_view;
out vec3 position_view;
out vec3 position_scene;
out float table_place;
out float emphasis;
void main() {
  vec3 along = normalize(finish - start);
  vec3 aside = normalize(abs(along.y) < 0.9 ? cross(along, vec3(0, 1, 0)) : cross(along, vec3(1, 0, 0)));
  vec3 normal = mat3(aside, cross(along, aside), along) * shape.xyz;
  vec3 at = mix(start, finish, shape.w) + radius * thickness * normal;
  vec4 in_view = modelViewMatrix * vec4(at, 1.0);
  position_scene = at;
  normal_view = normalMatrix * normal;
  position_view = in_view.xyz;
  table_place = mix(place.x, place.y, shape.w);
  bool chosen = family < -0.5 || abs(ids.y - family) < 0.5;
  emphasis = abs(ids.x - hovered) < 0.5 ? 2.0 : (chosen ? 1.0 : 0.0);
  gl_Position = projectionMatrix * in_view;
  // The followed family lies in the front tenth of the depth range: faded fibers never hide it.
  if (family > -0.5 && chosen) gl_Position.z = mix(-gl_Position.w, gl_Position.z, 0.1);
}`;

const fragment_shader = /* glsl */ `
in vec3 normal_view;
in vec3 position_view;
in vec3 position_scene;
in float table_place;
in float emphasis;
uniform sampler2D table;
uniform vec3 low;   // corners of the window; what lies outside is cut off
uniform vec3 high;
uniform vec3 background;
uniform vec2 haze;  // distances where it begins and where it is full
out vec4 colour;
void main() {
  if (any(lessThan(position_scene, low)) || any(greaterThan(position_scene, high))) discard;
  // Where a rod is cut the eye looks at its inside, which is drawn as the flat face of the cut.
  vec3 n = gl_FrontFacing ? normalize(normal_view) : vec3(0.0, 0.0, 1.0);
  vec3 to_eye = normalize(-position_view);
  float facing = max(dot(n, to_eye), 0.0);
  float light = 0.56 + 0.5 * max(dot(n, normalize(vec3(-0.35, 0.65, 0.7))), 0.0);
  float gloss = pow(max(dot(n, normalize(to_eye + vec3(-0.35, 0.65, 0.7))), 0.0), 40.0);
  vec3 base = texture(table, vec2(clamp(table_place, 0.002, 0.998), 0.5)).rgb;
  vec3 lit = base * light * mix(0.58, 1.0, smoothstep(0.0, 0.5, facing)) + 0.12 * gloss;
  if (emphasis > 1.5) lit = mix(lit, vec3(1.0), 0.35);
  float far = smoothstep(haze.x, haze.y, -position_view.z);
  float fade = emphasis > 1.5 ? 0.0 : (emphasis < 0.5 ? 0.9 : 0.62 * far);
  colour = vec4(mix(lit, background, fade), 1.0);
}`;

/** Makes a unit capsule: `sides` around, and caps of `rings` rings that close the joints at hinges; none is an open tube. */
function make_capsule(sides: number, rings: number): { shape: Float32Array; index: number[] } {
  const shape: number[] = [];
  const index: number[] = [];
  const latitudes: [number, number][] = [];
  const step = Math.PI / 2 / Math.max(1, rings);
  for (let ring = rings; ring >= 0; --ring) latitudes.push([-ring * step, 0]);
  for (let ring = 0; ring <= rings; ++ring) latitudes.push([ring * step, 1]);
  for (const [latitude, end] of latitudes) {
    for (let side = 0; side < sides; ++side) {
      const around = (2 * Math.PI * side) / sides;
      shape.push(Math.cos(latitude) * Math.cos(around), Math.cos(latitude) * Math.sin(around), Math.sin(latitude), end);
    }
  }
  for (let row = 0; row + 1 < latitudes.length; ++row) {
    for (let side = 0; side < sides; ++side) {
      const next = (side + 1) % sides;
      const [a, b, c, d] = [row * sides + side, row * sides + next, (row + 1) * sides + side, (row + 1) * sides + next];
      index.push(a, b, c, b, d, c);
    }
  }
  return { shape: Float32Array.from(shape), index };
}

export interface RodMesh {
  mesh: Mesh;
  /** Puts rods in place; lengths are multiplied by `factor` to be in scene units. */
  place: (placed: PlacedRods, frame: CellFrame, factor: number) => void;
  colour: (places: Float32Array, scale: ColourScale) => void;
  emphasize: (fiber: number | undefined, family: number | undefined) => void;
  set_thickness: (times: number) => void;
  /** Cuts off what lies outside two corners, in scene units; nothing without them. */
  set_window: (low: Three | undefined, high: Three | undefined) => void;
  set_surroundings: (background: string, haze: [number, number]) => void;
  dispose: () => void;
}

/** Farther than anything of a scene. */
const nowhere: Three = [1e6, 1e6, 1e6];

function make_material(): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: vertex_shader,
    fragmentShader: fragment_shader,
    side: DoubleSide,
    uniforms: {
      low: { value: nowhere.map((value) => -value) }, high: { value: [...nowhere] },
      thickness: { value: 1 }, hovered: { value: -1 }, family: { value: -1 },
      table: { value: null }, background: { value: [1, 1, 1] }, haze: { value: [1, 2] },
    },
  });
}

function scaled(values: Float32Array, factor: number): Float32Array {
  return values.map((value) => value * factor);
}

/** Makes the mesh for at most `capacity` rods; many rods get plainer capsules. */
export function make_rod_mesh(capacity: number): RodMesh {
  const capsule = capacity > 12_000 ? make_capsule(6, 0) : capacity > 4_000 ? make_capsule(8, 1) : make_capsule(14, 3);
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("shape", new BufferAttribute(capsule.shape, 4));
  geometry.setIndex(capsule.index);
  const material = make_material();
  const uniforms = material.uniforms as Record<string, { value: unknown }>;
  const mesh = new Mesh(geometry, material);
  // The box of the unit capsule says nothing about where its instances are.
  mesh.frustumCulled = false;
  const put = (name: string, values: Float32Array, size: number): void => {
    const kept = geometry.getAttribute(name) as InstancedBufferAttribute | undefined;
    if (kept && kept.array.length >= values.length) {
      kept.array.set(values);
      kept.needsUpdate = true;
      return;
    }
    // A window shows some rods twice, as many as stick out of it: their number changes with time.
    const array = new Float32Array(Math.max(size * capacity, Math.ceil(1.3 * values.length)));
    array.set(values);
    geometry.setAttribute(name, new InstancedBufferAttribute(array, size).setUsage(DynamicDrawUsage));
  };
  return {
    mesh,
    place: (placed, frame, factor) => {
      const fibers = placed.fiber.subarray(0, placed.count);
      put("start", scaled(placed.starts.subarray(0, 3 * placed.count), factor), 3);
      put("finish", scaled(placed.ends.subarray(0, 3 * placed.count), factor), 3);
      put("radius", Float32Array.from(fibers, (fiber) => frame.radius[fiber]! * factor), 1);
      const ids = new Float32Array(2 * placed.count);
      for (let k = 0; k < placed.count; ++k) {
        ids[2 * k] = fibers[k]!;
        ids[2 * k + 1] = frame.birth[fibers[k]!]!;
      }
      put("ids", ids, 2);
      geometry.instanceCount = placed.count;
    },
    colour: (places, scale) => {
      put("place", places, 2);
      (uniforms.table!.value as DataTexture | null)?.dispose();
      const texture = new DataTexture(scale.table, table_size, 1, RGBAFormat);
      const filter = scale.categorical ? NearestFilter : LinearFilter;
      texture.magFilter = filter;
      texture.minFilter = filter;
      texture.needsUpdate = true;
      uniforms.table!.value = texture;
    },
    emphasize: (fiber, family) => {
      uniforms.hovered!.value = fiber ?? -1;
      uniforms.family!.value = family ?? -1;
    },
    set_window: (low, high) => {
      uniforms.low!.value = low ?? nowhere.map((value) => -value);
      uniforms.high!.value = high ?? nowhere;
    },
    set_thickness: (times) => { uniforms.thickness!.value = times; },
    set_surroundings: (background, haze) => {
      // Colours go to the screen as they are given, without three's colour management.
      const hex = new Color().setStyle(background, "srgb-linear");
      uniforms.background!.value = [hex.r, hex.g, hex.b];
      uniforms.haze!.value = haze;
    },
    dispose: () => { geometry.dispose(); material.dispose(); },
  };
}
