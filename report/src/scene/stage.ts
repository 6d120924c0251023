// The stage of a three-dimensional view: renderer, camera, controls, triad; it draws only when something has changed.
import { LinearSRGBColorSpace, PerspectiveCamera, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { make } from "../dom";
import { current_palette, light_palette, type Palette } from "../palette";
import { add_print_view } from "../print";
import { make_triad } from "./triad";

export interface Stage {
  canvas: HTMLCanvasElement;
  scene: Scene;
  camera: PerspectiveCamera;
  /** Scene units per metre: what is shown is about one unit large. */
  factor: number;
  /** Middle of what is shown, in scene units. */
  middle: Vector3;
  redraw: () => void;
  reset_camera: () => void;
  /** Draws at once, in a palette that need not be the screen's. */
  draw: (palette: Palette) => void;
  /** Draws for paper at a multiple of the screen's resolution and hands the pixels to `use`. */
  snapshot: (times: number, use: (canvas: HTMLCanvasElement) => void) => void;
}

export interface StageRequest {
  /** Corners of what is shown [m]: the camera keeps them in view. */
  corners: Vector3[];
  /** From where the camera looks at first. */
  from: Vector3;
  /** Without a graphics card smooth edges cost as much as all the rest: much to draw goes without them. */
  crowded: boolean;
  /** Called before every drawing; `away` is the distance of the camera from the middle. */
  prepare: (palette: Palette, away: number) => void;
  /** Called after every drawing on the screen. */
  finish?: (stage: Stage) => void;
}

/** Tells whether the browser draws without a graphics card, as on a remote desktop. */
export function draws_in_software(): boolean {
  return (in_software ??= find_software());
}

let in_software: boolean | undefined;

function find_software(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name = names ? String(context!.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

function ball_around(corners: Vector3[]): { middle: Vector3; radius: number } {
  const middle = new Vector3();
  for (const corner of corners) middle.addScaledVector(corner, 1 / corners.length);
  return { middle, radius: Math.max(1e-9, ...corners.map((corner) => corner.distanceTo(middle))) };
}

interface Subject {
  middle: Vector3;
  corners: Vector3[];
  from: Vector3;
}

const margin = 0.92; // of half the picture, which the farthest corner may take

/** Puts the camera as near as all corners allow. */
function stand_back(camera: PerspectiveCamera, { middle, corners, from }: Subject): void {
  const direction = from.clone().normalize();
  let [near, far] = [1.05, 60];
  for (let k = 0; k < 30; ++k) {
    const distance = (near + far) / 2;
    camera.position.copy(middle).addScaledVector(direction, distance);
    camera.lookAt(middle);
    camera.updateMatrixWorld();
    const inside = corners.every((corner) => {
      const seen = corner.clone().project(camera);
      return Math.max(Math.abs(seen.x), Math.abs(seen.y)) <= margin && seen.z < 1;
    });
    if (inside) far = distance;
    else near = distance;
  }
}

function make_renderer(crowded: boolean): WebGLRenderer {
  const plain = crowded && draws_in_software();
  const renderer = new WebGLRenderer({ antialias: !plain, alpha: true, preserveDrawingBuffer: true });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.setPixelRatio(plain ? 1 : Math.min(2, window.devicePixelRatio));
  return renderer;
}

/**
 * Lets the wheel and a finger scroll the page until the reader has chosen the view, by a click or by the keyboard; a
 * view that catches the wheel in passing stops the reader at every picture.
 */
function hold_wheel_until_active(host: HTMLElement, canvas: HTMLCanvasElement, controls: OrbitControls): void {
  const hint = make("p", { class: "hint", "aria-hidden": "true" }, "Click the picture to zoom with the wheel; Esc gives the wheel back");
  host.append(hint);
  const activate = (active: boolean): void => {
    controls.enableZoom = active;
    canvas.style.touchAction = active ? "none" : "pan-y";
    host.dataset.active = String(active);
    hint.classList.remove("shown");
  };
  canvas.tabIndex = 0;
  canvas.addEventListener("focus", () => activate(true));
  canvas.addEventListener("blur", () => activate(false));
  canvas.addEventListener("keydown", (event) => {
    if (event.key === "Escape") canvas.blur();
  });
  let timer: number | undefined;
  canvas.addEventListener("wheel", () => {
    if (controls.enableZoom) return;
    hint.classList.add("shown");
    clearTimeout(timer);
    timer = window.setTimeout(() => hint.classList.remove("shown"), 1500);
  }, { passive: true });
  // A press that begins a drag focuses too, but only where the browser gives focus to a canvas.
  canvas.addEventListener("pointerup", () => canvas.focus({ preventScroll: true }));
  activate(false);
}

/** Makes the stage in its host; throws where the browser has no WebGL. */
export function make_stage(host: HTMLElement, request: StageRequest): Stage {
  const renderer = make_renderer(request.crowded);
  const ball = ball_around(request.corners);
  const factor = 1 / ball.radius;
  const middle = ball.middle.multiplyScalar(factor);
  const corners = request.corners.map((corner) => corner.clone().multiplyScalar(factor));
  const scene = new Scene();
  const camera = new PerspectiveCamera(28, 1, 0.01, 100);
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.zoomToCursor = true;
  hold_wheel_until_active(host, renderer.domElement, controls);
  const triad = make_triad();
  host.append(renderer.domElement, triad.element);

  const place_camera = (): void => {
    stand_back(camera, { middle, corners, from: request.from });
    controls.target.copy(middle);
    controls.update();
  };
  let due: number | undefined;
  const draw = (palette: Palette = current_palette()): void => {
    if (due !== undefined) cancelAnimationFrame(due);
    due = undefined;
    request.prepare(palette, camera.position.distanceTo(middle));
    renderer.render(scene, camera);
    triad.turn(camera);
    host.dataset.triangles = String(renderer.info.render.triangles);
    request.finish?.(stage);
  };
  let framed = false;
  // Before the stage has its size there is nothing to see, and a large cell would be drawn twice.
  const redraw = (): void => {
    if (framed) due ??= requestAnimationFrame(() => draw());
  };
  const stage: Stage = {
    canvas: renderer.domElement, scene, camera, factor, middle, redraw, draw, reset_camera: place_camera,
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
  controls.addEventListener("change", redraw);
  add_print_view(draw);
  new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (!framed) place_camera();
    framed = true;
    draw();
  }).observe(host);
  return stage;
}
