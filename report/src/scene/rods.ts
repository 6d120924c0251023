// All rods in one draw: capsules that the vertex shader stretches between two nodes, or strips where there are many.
import {
  BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, GLSL3, InstancedBufferGeometry, LinearFilter, Mesh, NearestFilter,
  RGBAFormat, ShaderMaterial,
} from "three";
import { type ColourScale, table_size } from "./colouring";
import type { CellFrame } from "./frame";
import type { PlacedRods } from "./images";
import type { Three } from "./lattice";
import { read_rods, RodTable } from "./rod_table";

/**
 * With RIBBON a rod is a strip that faces the eye and is shaded round: two triangles. Strips are not instances, either:
 * browsers without a graphics card take as long for an instance as for a thousand triangles.
 */
const vertex_shader = /* glsl */ `
#ifndef RIBBON
in vec4 shape;  // direction from the axis, and which end: 0 start, 1 finish
#endif
uniform float thickness;
uniform float hovered;
uniform float family;
out vec3 normal_view;
out vec3 position_view;
out vec3 position_scene;
out float table_place;
out float emphasis;
${read_rods}
void main() {
#ifdef RIBBON
  int rod = gl_VertexID / 4;
  float end = float((gl_VertexID / 2) % 2);
  float side = float(2 * (gl_VertexID % 2) - 1);
#else
  int rod = gl_InstanceID;
  float end = shape.w;
#endif
  vec4 first = texel_of(rod, 0), second = texel_of(rod, 1), third = texel_of(rod, 2);
  vec3 start = first.xyz, finish = second.xyz, middle = mix(start, finish, end);
  float radius = first.w * thickness;
  vec3 along = normalize(finish - start);
#ifdef RIBBON
  vec3 to_eye = normalize((inverse(modelViewMatrix) * vec4(0, 0, 0, 1)).xyz - middle);
  vec3 aside = cross(along, to_eye);
  aside = dot(aside, aside) > 1e-8 ? normalize(aside) : normalize(cross(to_eye, vec3(0.3, 1, 0.2)));
  vec3 normal = side * aside;
  // A little longer than the rod: no gaps at hinges, and a rod that points at the eye is still seen.
  vec3 at = middle + radius * (normal + 0.8 * (2.0 * end - 1.0) * cross(to_eye, aside));
#else
  vec3 aside = normalize(abs(along.y) < 0.9 ? cross(along, vec3(0, 1, 0)) : cross(along, vec3(1, 0, 0)));
  vec3 normal = mat3(aside, cross(along, aside), along) * shape.xyz;
  vec3 at = middle + radius * normal;
#endif
  vec4 in_view = modelViewMatrix * vec4(at, 1.0);
  position_scene = at;
  normal_view = normalMatrix * normal;
  position_view = in_view.xyz;
  table_place = mix(third.x, third.y, end);
  bool chosen = family < -0.5 || abs(third.z - family) < 0.5;
  emphasis = abs(second.w - hovered) < 0.5 ? 2.0 : (chosen ? 1.0 : 0.0);
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
  vec3 to_eye = normalize(-position_view);
#ifdef RIBBON
  vec3 n = normalize(normal_view + sqrt(max(0.0, 1.0 - dot(normal_view, normal_view))) * to_eye);
#else
  // Where a rod is cut the eye looks at its inside, which is drawn as the flat face of the cut.
  vec3 n = gl_FrontFacing ? normalize(normal_view) : vec3(0.0, 0.0, 1.0);
#endif
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

/** Makes a unit capsule: `sides` around, and caps of `rings` rings that close the joints at hinges. */
function make_capsule(sides: number, rings: number): InstancedBufferGeometry {
  const shape: number[] = [];
  const index: number[] = [];
  const latitudes: [number, number][] = [];
  const step = Math.PI / 2 / rings;
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
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("shape", new BufferAttribute(Float32Array.from(shape), 4));
  geometry.setIndex(index);
  return geometry;
}

/** Makes the corners of strips: only their numbers, from which the shader knows rod, end and side. */
function make_ribbons(count: number): BufferAttribute {
  const index = new Uint32Array(6 * count);
  for (let rod = 0; rod < count; ++rod) index.set([0, 1, 2, 1, 3, 2].map((corner) => 4 * rod + corner), 6 * rod);
  return new BufferAttribute(index, 1);
}

/** Gives a geometry the number of its rods. */
function set_count(geometry: BufferGeometry, count: number): void {
  if (geometry instanceof InstancedBufferGeometry) {
    geometry.instanceCount = count;
    return;
  }
  if ((geometry.getIndex()?.count ?? 0) < 6 * count) {
    geometry.dispose();
    geometry.setIndex(make_ribbons(Math.ceil(1.3 * count)));
  }
  geometry.setDrawRange(0, 6 * count);
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

function make_material(ribbons: boolean): ShaderMaterial {
  return new ShaderMaterial({
    glslVersion: GLSL3,
    defines: ribbons ? { RIBBON: "" } : {},
    vertexShader: vertex_shader,
    fragmentShader: fragment_shader,
    side: DoubleSide,
    uniforms: {
      low: { value: nowhere.map((value) => -value) }, high: { value: [...nowhere] },
      rods: { value: null }, thickness: { value: 1 }, hovered: { value: -1 }, family: { value: -1 },
      table: { value: null }, background: { value: [1, 1, 1] }, haze: { value: [1, 2] },
    },
  });
}

const most_smooth = 4_000; // rods; capsules of more are plainer
const most_capsules = 12_000; // rods; more are strips

/** Makes the mesh for at most `capacity` rods at first; without a graphics card, where there are many, of strips. */
export function make_rod_mesh(capacity: number, software: boolean): RodMesh {
  const ribbons = capacity > (software ? most_smooth : most_capsules);
  const geometry = ribbons ? new BufferGeometry() : capacity > most_smooth ? make_capsule(8, 1) : make_capsule(14, 3);
  const table = new RodTable(Math.ceil(1.3 * capacity));
  const material = make_material(ribbons);
  const uniforms = material.uniforms as Record<string, { value: unknown }>;
  const mesh = new Mesh(geometry, material);
  // The box of the unit capsule says nothing about where its instances are.
  mesh.frustumCulled = false;
  return {
    mesh,
    place: (placed, frame, factor) => {
      table.place(placed, frame, factor);
      uniforms.rods!.value = table.texture;
      set_count(geometry, placed.count);
    },
    colour: (places, scale) => {
      table.colour(places);
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
    dispose: () => { geometry.dispose(); material.dispose(); table.texture.dispose(); },
  };
}
