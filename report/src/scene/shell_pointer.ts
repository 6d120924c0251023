// Pointing at a part: hovering tells the values at the nearest node.
import { Mesh, Raycaster, Vector2 } from "three";
import { make, make_label } from "../dom";
import { write_quantity } from "../format";
import { field_at, type ShellData } from "./shell";
import type { Stage } from "./stage";

const raycaster = new Raycaster();

/** Finds the node nearest to where the cursor meets the surface. */
function find_node(event: PointerEvent, stage: Stage, mesh: Mesh, data: ShellData): number | undefined {
  const area = stage.canvas.getBoundingClientRect();
  const cursor = new Vector2((2 * (event.clientX - area.left)) / area.width - 1, 1 - (2 * (event.clientY - area.top)) / area.height);
  raycaster.setFromCamera(cursor, stage.camera);
  const hit = raycaster.intersectObject(mesh)[0];
  if (!hit?.face) return undefined;
  const { a, b, c } = hit.face;
  const away = (node: number): number =>
    Math.hypot(...hit.point.toArray().map((value, k) => value - data.points[3 * node + k]! * stage.factor));
  return [a, b, c].sort((one, other) => away(one) - away(other))[0];
}

function write_place(data: ShellData, node: number): string {
  return [0, 1, 2].map((k) => (1e3 * data.points[3 * node + k]!).toFixed(1)).join(", ") + " mm";
}

function show_node(box: HTMLElement, data: ShellData, node: number, time: number): void {
  const facts = make("dl", {});
  const add = (label: string, value: string): void => facts.append(make("dt", {}, make_label(label)), make("dd", {}, value));
  add("node", String(node));
  add("place", write_place(data, node));
  const filled = data.fill_time[node]!;
  add("filled at", write_quantity(Number.isFinite(filled) ? filled : null, "s"));
  for (const field of data.fields) {
    if (!(filled <= time) && field.frames.length > 1) continue;
    add(field.label, write_quantity(field_at(data, field, time)[node], field.unit));
  }
  box.dataset.node = String(node);
  box.replaceChildren(facts);
}

export interface ShellPointer {
  /** Tells the present values of the node under the cursor again. */
  refresh: () => void;
}

export interface ShellPointerRequest {
  host: HTMLElement;
  stage: Stage;
  mesh: Mesh;
  data: ShellData;
  time: () => number;
  /** Called with the node that was clicked and its place. */
  chose?: (node: number, place: string) => void;
}

const click_slack_in_pixels = 4;

export function follow_shell_pointer({ host, stage, mesh, data, time, chose }: ShellPointerRequest): ShellPointer {
  const box = make("div", { class: "fiber-facts", role: "status", hidden: true });
  host.append(box);
  let hovered: number | undefined;
  const refresh = (): void => {
    box.hidden = hovered === undefined;
    if (hovered !== undefined) show_node(box, data, hovered, time());
  };
  stage.canvas.addEventListener("pointermove", (event) => {
    const node = event.buttons === 0 ? find_node(event, stage, mesh, data) : undefined;
    if (node === hovered) return;
    hovered = node;
    refresh();
  });
  stage.canvas.addEventListener("pointerleave", () => {
    hovered = undefined;
    refresh();
  });
  let pressed_at = { x: 0, y: 0 };
  stage.canvas.addEventListener("pointerdown", ({ clientX: x, clientY: y }) => { pressed_at = { x, y }; });
  stage.canvas.addEventListener("pointerup", (event) => {
    if (Math.hypot(event.clientX - pressed_at.x, event.clientY - pressed_at.y) > click_slack_in_pixels) return;
    const node = find_node(event, stage, mesh, data);
    if (node !== undefined) chose?.(node, write_place(data, node));
  });
  return { refresh };
}
