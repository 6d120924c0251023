// The section "shell": a part that fills, in three dimensions over time.
import { Vector3 } from "three";
import type { ShellSection } from "../document";
import { make, make_button, make_choice, make_label, make_toggle } from "../dom";
import { current_palette, sample_map, watch_scheme } from "../palette";
import { bar_range } from "../figure/ticks";
import { write_quantity } from "../format";
import { add_print_view } from "../print";
import { save_canvas, save_csv } from "../save";
import { type Animated, make_animation_buttons } from "../scene/animation";
import { make_colour_bar } from "../scene/colour_bar";
import { type ColourScale, make_table } from "../scene/colouring";
import { compose_picture } from "../scene/picture";
import { make_player } from "../scene/player";
import { decode_shell, type DecodedField, field_at, type ShellData } from "../scene/shell";
import { make_place_labels, type PlaceLabels } from "../scene/shell_marks";
import { make_shell_mesh, type ShellMesh } from "../scene/shell_mesh";
import { make_overlays, type Overlay } from "../scene/shell_overlays";
import { follow_shell_pointer } from "../scene/shell_pointer";
import { make_stage, type Stage } from "../scene/stage";
import { make_gap_profile } from "./gap_profile";
import { make_section } from "./parts";
import { make_save_menu } from "./save_buttons";

const positions_of_slider = 120;
const seconds_to_play = 6;
const contours = 20;
const stills = 61; // pictures of the whole time: enough for a talk's slides
const viridis = make_table((k) => sample_map("viridis", k / 255));

/** What is shown now; the functions below bring the stage into agreement with it. */
interface Shown {
  section: ShellSection;
  data: ShellData;
  field: number;
  time: number;
  scale: ColourScale;
  stage: Stage;
  shell: ShellMesh;
  overlays: Overlay[];
  labels: PlaceLabels;
  host: HTMLElement;
  bar: HTMLElement;
  /** Moves the slider and everything with it. */
  go: (position: number) => void;
}

/** Makes the scale of a field, one for all times, so that colours can be compared. */
function scale_of(field: DecodedField): ColourScale {
  let [min, max] = [Infinity, -Infinity];
  for (const frame of field.frames) {
    for (const value of frame) {
      if (!Number.isFinite(value)) continue;
      min = Math.min(min, value);
      max = Math.max(max, value);
    }
  }
  if (!(min <= max)) [min, max] = [0, 1];
  // Equal values still need a bar of some height.
  if (min === max) [min, max] = [min - 0.5 * (Math.abs(min) || 1), max + 0.5 * (Math.abs(max) || 1)];
  else [min, max] = bar_range(min, max);
  return { label: field.label, unit: field.unit, min, max, clipped: false, table: viridis, categorical: false };
}

function show(shown: Shown): void {
  const { data, shell, host, scale } = shown;
  const field = data.fields[shown.field]!;
  shell.set_time(shown.time);
  for (const overlay of shown.overlays) overlay.set_time?.(shown.time);
  shell.colour(field_at(data, field, shown.time), scale);
  const filled = data.fill_time.reduce((count, time) => count + (time <= shown.time ? 1 : 0), 0);
  Object.assign(host.dataset, {
    section: shown.section.id, time: shown.time, nodes: data.nodes, filledNodes: filled, colouring: field.label,
  });
  shown.stage.redraw();
}

function choose_field(shown: Shown, index: number): void {
  shown.field = index;
  shown.scale = scale_of(shown.data.fields[index]!);
  shown.bar.replaceChildren(make_colour_bar(shown.scale, current_palette()));
  show(shown);
}

function save_nodes(shown: Shown): void {
  const { data, time } = shown;
  const axis = (k: number): number[] => Array.from({ length: data.nodes }, (_unused, node) => data.points[3 * node + k]!);
  save_csv(`${shown.section.id}-${time.toPrecision(4)}s`, [
    ...["x", "y", "z"].map((name, k) => ({ header: `${name} [m]`, values: axis(k) })),
    { header: "filled at [s]", values: [...data.fill_time] },
    ...data.fields.map((field) => ({ header: field.unit ? `${field.label} [${field.unit}]` : field.label, values: [...field_at(data, field, time)] })),
  ]);
}

function save_picture(shown: Shown): void {
  shown.stage.snapshot(2, (canvas) => {
    void compose_picture(canvas, shown.scale).then((picture) => save_canvas(`${shown.section.id}-${shown.time.toPrecision(4)}s`, picture));
  });
}

function animated(shown: Shown): Animated {
  const show = (share: number): string => {
    shown.go(positions_of_slider * share);
    return `t = ${write_quantity(shown.time, "s")}`;
  };
  const frames = Array.from({ length: stills }, (_unused, k) => k / (stills - 1));
  const keep_place = () => {
    const position = (positions_of_slider * shown.time) / shown.data.end;
    return (): void => shown.go(position);
  };
  return { name: shown.section.id, stage: shown.stage, scale: () => shown.scale, show, frames, keep_place };
}

function add_controls(controls: HTMLElement, shown: Shown): void {
  const fields = shown.data.fields.map(({ label }, k) => ({ value: String(k), text: label }));
  controls.append(make_choice("Colour", fields, "0", (value) => choose_field(shown, Number(value))));
  for (const { label, title, object } of shown.overlays) {
    controls.append(make_toggle(make_label(label), title, object.visible, (on) => {
      object.visible = on;
      shown.stage.redraw();
    }));
  }
  controls.append(
    make_toggle("Fronts", "Show lines of equal fill time", false, (on) => {
      shown.shell.set_contour(on ? shown.data.end / contours : 0);
      shown.stage.redraw();
    }),
    make_button("Reset", "Put the camera back", () => shown.stage.reset_camera()),
    make_save_menu(
      make_button("Picture as PNG", "The picture with its colour bar", () => save_picture(shown)),
      make_button("Nodes as CSV", "All fields at the nodes at this time", () => save_nodes(shown)),
      ...make_animation_buttons(animated(shown)),
    ),
  );
}

function corners_of(points: Float32Array): Vector3[] {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = new Vector3(-Infinity, -Infinity, -Infinity);
  for (let k = 0; k < points.length; k += 3) {
    const at = new Vector3().fromArray(points, k);
    low.min(at);
    high.max(at);
  }
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new Vector3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z));
}

function start_stage(section: ShellSection, data: ShellData, host: HTMLElement, bar: HTMLElement): Shown | undefined {
  const labels = make_place_labels(section.places ?? []);
  let shell: ShellMesh | undefined;
  let stage: Stage;
  try {
    stage = make_stage(host, {
      corners: corners_of(data.points),
      from: new Vector3(0.25, 0.45, 1),
      crowded: data.nodes > 20_000,
      prepare: (palette) => shell?.adapt(palette),
      finish: labels.follow,
    });
  } catch {
    host.dataset.webgl = "missing";
    host.append(make("p", { class: "note" }, "The part cannot be shown in 3D: this browser has WebGL turned off or has no graphics driver. All numbers of the report are complete without it."));
    return undefined;
  }
  host.dataset.webgl = "working";
  shell = make_shell_mesh(data, stage.factor);
  const overlays = make_overlays(section, data, stage.factor);
  stage.scene.add(shell.mesh, shell.outline, ...overlays.map(({ object }) => object));
  host.append(labels.element);
  return { section, data, field: 0, time: data.end, scale: scale_of(data.fields[0]!), stage, shell, overlays, labels, host, bar, go: () => {} };
}

export function render_shell(section: ShellSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const data = decode_shell(section);
  const host = make("div", { class: "stage", role: "img", "aria-label": `${section.title}: drag to turn, scroll to zoom, point at the part for its numbers` });
  const bar = make("div", { class: "bar" });
  figure.append(make("div", { class: "scene" }, host, bar));
  const shown = start_stage(section, data, host, bar);
  if (!shown) return element;
  const times = Array.from({ length: positions_of_slider + 1 }, (_unused, k) => (data.end * k) / positions_of_slider);
  const profile = section.layers && make_gap_profile(section.layers);
  const pointer = follow_shell_pointer({ host, stage: shown.stage, mesh: shown.shell.mesh, data, time: () => shown.time, chose: profile?.show });
  const player = make_player(times, (_position, time) => {
    shown.time = time;
    show(shown);
    pointer.refresh();
  }, { seconds: seconds_to_play, start: positions_of_slider });
  shown.go = player.go;
  add_controls(controls, shown);
  figure.append(player.element);
  if (profile) figure.append(make("p", { class: "between" }, "Click the part for the profiles through its gap."), profile.element);
  choose_field(shown, 0);
  add_print_view((palette) => bar.replaceChildren(make_colour_bar(shown.scale, palette)));
  watch_scheme(() => choose_field(shown, shown.field));
  return element;
}
