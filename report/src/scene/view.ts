// The three-dimensional view: renderer, camera, controls; it draws only when something has changed.
import { LinearSRGBColorSpace, PerspectiveCamera, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { current_palette, light_palette, type Palette } from "../palette";
import { type CellOutline, corner_of, make_cell_outline } from "./cell_outline";
import type { CellFrame } from "./frame";
import { has_cell } from "./images";
import { make_rod_mesh, type RodMesh } from "./rods";
import { make_triad } from "./triad";

export interface View {
  canvas: HTMLCanvasElement;
  rods: RodMesh;
  outline: CellOutline;
  camera: PerspectiveCamera;
  /** Scene units per metre: the cell is about one unit large. */
  factor: number;
  redraw: () => void;
  reset_camera: () => void;
  adapt_to_scheme: () => void;
  /** Draws for paper at a multiple of the screen's resolution and hands the pixels to `use`. */
  snapshot: (times: number, use: (canvas: HTMLCanvasElement) => void) => void;
}

interface Extent {
  middle: Vector3;
  radius: number;
}

/** The ball around the cell, or around the fibers where there is no cell [m]. */
function measure_extent(frame: CellFrame): Extent {
  const corners: Vector3[] = [];
  if (has_cell(frame)) {
    for (let k = 0; k < 8; ++k) corners.push(new Vector3(...corner_of(frame, [k & 1, (k >> 1) & 1, k >> 2])));
  } else {
    for (let k = 0; k < frame.points.length; k += 3) corners.push(new Vector3().fromArray(frame.points, k));
  }
  const middle = new Vector3();
  for (const corner of corners) middle.addScaledVector(corner, 1 / corners.length);
  const radius = Math.max(1e-9, ...corners.map((corner) => corner.distanceTo(middle)));
  return { middle, radius };
}

/** Tells whether the browser draws without a graphics card, as on a remote desktop. */
function draws_in_software(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? String(context!.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

/** Smooth edges cost a processor as much as all the rest: many rods without a graphics card go without them. */
function make_renderer(capacity: number): WebGLRenderer {
  const plain = capacity > 4_000 && draws_in_software();
  const renderer = new WebGLRenderer({ antialias: !plain, alpha: true, preserveDrawingBuffer: true });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.setPixelRatio(plain ? 1 : Math.min(2, window.devicePixelRatio));
  return renderer;
}

function place_camera(camera: PerspectiveCamera, controls: OrbitControls, extent: Extent): void {
  const distance = (1.02 * extent.radius) / Math.sin((camera.fov * Math.PI) / 360);
  const narrow = Math.max(1, 1 / camera.aspect);
  camera.position.copy(extent.middle).addScaledVector(new Vector3(0.42, 0.36, 1).normalize(), distance * narrow);
  controls.target.copy(extent.middle);
  controls.update();
}

/** Makes the view in its host; throws where the browser has no WebGL. */
export function make_view(host: HTMLElement, first: CellFrame, capacity: number): View {
  const renderer = make_renderer(capacity);
  const metres = measure_extent(first);
  const factor = 1 / metres.radius;
  const extent = { middle: metres.middle.multiplyScalar(factor), radius: 1 };
  const scene = new Scene();
  const rods = make_rod_mesh(capacity);
  const outline = make_cell_outline();
  outline.lines.visible = has_cell(first);
  scene.add(rods.mesh, outline.lines);
  const camera = new PerspectiveCamera(28, 1, 0.01, 100);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.zoomToCursor = true;
  const triad = make_triad();
  host.append(renderer.domElement, triad.element);

  const draw = (palette: Palette = current_palette()): void => {
    const away = camera.position.distanceTo(extent.middle);
    rods.set_surroundings(palette.surface, [away - 0.6, away + 1.3]);
    renderer.render(scene, camera);
    triad.turn(camera);
    host.dataset.triangles = String(renderer.info.render.triangles);
  };
  let due = false;
  const redraw = (): void => {
    if (due) return;
    due = true;
    requestAnimationFrame(() => {
      due = false;
      draw();
    });
  };
  const adapt_to_scheme = (): void => {
    outline.set_colour(current_palette().muted);
    redraw();
  };
  controls.addEventListener("change", redraw);
  let framed = false;
  new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (!framed) place_camera(camera, controls, extent);
    framed = true;
    draw();
  }).observe(host);
  adapt_to_scheme();
  return {
    canvas: renderer.domElement, rods, outline, camera, factor, redraw, adapt_to_scheme,
    reset_camera: () => place_camera(camera, controls, extent),
    snapshot: (times, use) => {
      const before = renderer.getPixelRatio();
      const size = renderer.getSize(new Vector2());
      renderer.setPixelRatio(before * times);
      draw(light_palette);
      use(renderer.domElement);
      renderer.setPixelRatio(before);
      renderer.setSize(size.x, size.y);
      draw();
    },
  };
}
