// The section "fibers": the cell in three dimensions over time.
import type { FiberFrame, FibersSection } from "../document";
import { make, make_button, make_choice, make_toggle } from "../dom";
import { current_palette, watch_scheme } from "../palette";
import { write_quantity } from "../format";
import { add_print_view } from "../print";
import { save_canvas, save_csv } from "../save";
import { type Animated, make_animation_buttons } from "../scene/animation";
import { type BreakMarks, make_break_marks } from "../scene/break_marks";
import { BreakTimes, decode_breaks, see_breaks } from "../scene/breaks";
import { type CellState, middle_of_rods } from "../scene/cell_state";
import { make_colour_bar } from "../scene/colour_bar";
import { colour_rods, type Colouring, colourings_of, type ColourScale, make_scale } from "../scene/colouring";
import { FrameStore } from "../scene/frame_store";
import { type Images, type PlacedRods, place_rods } from "../scene/images";
import { centre_window, type CellWindow, type Three, window_of } from "../scene/lattice";
import { first_rod, rods_of } from "../scene/pairing";
import { compose_picture } from "../scene/picture";
import { make_player, position_of } from "../scene/player";
import { follow_pointer, piece_with, type Pointer } from "../scene/pointer";
import { make_side_panel, type SidePanel } from "../scene/side_panel";
import { make_view, type View } from "../scene/view";
import { make_section } from "./parts";
import { make_save_menu } from "./save_buttons";

const seconds_to_play = 12;
const remembered_breaks = 0.04; // of the whole time: how long the ring of a break stays

/** What is shown now; the functions below bring the view into agreement with it. */
interface Shown {
  section: FibersSection;
  store: FrameStore;
  breaks: BreakTimes;
  position: number;
  state: CellState;
  images: Images;
  follow: boolean;
  colouring: Colouring;
  scale: ColourScale;
  placed: PlacedRods;
  view: View;
  marks: BreakMarks;
  side: SidePanel;
  pointer?: Pointer;
  /** Moves the slider and everything with it. */
  go: (position: number) => void;
  stage: HTMLElement;
  bar: HTMLElement;
}

function show_colours(shown: Shown): void {
  const { view, state, placed, scale } = shown;
  view.rods.colour(colour_rods(shown, state, placed), scale);
  shown.stage.dataset.colouring = shown.colouring;
  view.redraw();
}

function choose_colours(shown: Shown, colouring: Colouring): void {
  shown.colouring = colouring;
  shown.scale = make_scale(colouring, shown.store.samples(), shown.store.duration());
  shown.bar.replaceChildren(make_colour_bar(shown.scale, current_palette()));
  show_colours(shown);
}

/** Gives the middle of the chosen rod, which goes on evenly when its fiber breaks; of its fiber where rods have no number. */
function middle_of_chosen({ state, pointer }: Shown): Three | undefined {
  const chosen = pointer?.chosen();
  const fiber = chosen && piece_with(state, chosen);
  if (!chosen || fiber === undefined) return undefined;
  const first = first_rod(state.frame, fiber);
  const start = state.frame.birth_node?.[fiber];
  if (start !== undefined && chosen.number !== undefined) return middle_of_rods(state.starts, state.ends, [first + chosen.number - start]);
  return middle_of_rods(state.starts, state.ends, Array.from({ length: rods_of(state.frame, fiber) }, (_unused, k) => first + k));
}

/** Cuts at the window where the reader wants the cell; walls let nothing through, and what touches them stays whole. */
function cut_at(shown: Shown, window: CellWindow | undefined): void {
  const { view, state, images } = shown;
  const inside = images === "window" ? window : undefined;
  const end = (side: 0 | 1): Three | undefined => inside?.size.map((size, k) =>
    state.periodic[k] ? (state.origin[k]! + side * size) * view.factor : (2 * side - 1) * 1e6) as Three | undefined;
  view.rods.set_window(end(0), end(1));
}

function tell(shown: Shown, middle: Three | undefined, breaks: number): void {
  const { state, stage } = shown;
  Object.assign(stage.dataset, {
    section: shown.section.id, frame: shown.position, time: state.time_s, images: shown.images, fibers: state.frame.fibers,
    rods: state.frame.rods, drawnRods: shown.placed.count, breaks, lattice: state.lattice.join(" "),
  });
  if (middle) stage.dataset.chosen = middle.join(" ");
  else delete stage.dataset.chosen;
}

function show_state(shown: Shown): void {
  const { view, state } = shown;
  const middle = middle_of_chosen(shown);
  const home = window_of(state);
  const window = home && middle && shown.follow ? centre_window(state, home, middle) : home;
  shown.placed = place_rods(state, shown.images, window);
  cut_at(shown, window);
  view.rods.place(shown.placed, state.frame, view.factor);
  view.outline.place(state, view.factor, window?.shift ?? [0, 0, 0]);
  const breaks = shown.marks.place(state, shown.images === "window" ? window : undefined, view.factor);
  shown.side.show(state);
  tell(shown, middle, breaks);
  show_colours(shown);
}

function go_to(shown: Shown, position: number): void {
  const before = shown.state.frame;
  shown.position = position;
  shown.state = shown.store.at(position);
  if (shown.state.frame !== before) shown.pointer?.frame_changed();
  show_state(shown);
}

function save_frame(shown: Shown): void {
  const { frame, measures } = shown.state;
  const fibers = Array.from({ length: frame.fibers }, (_unused, fiber) => fiber);
  save_csv(`${shown.section.id}-${frame.time_s}s`, [
    { header: "fiber", values: fibers },
    { header: "birth fiber", values: [...frame.birth] },
    { header: "rods", values: fibers.map((fiber) => rods_of(frame, fiber)) },
    { header: "length [m]", values: [...measures.length] },
    { header: "largest curvature [1/m]", values: [...measures.sharpest] },
  ]);
}

function save_picture(shown: Shown): void {
  const name = `${shown.section.id}-${Number(shown.state.time_s.toPrecision(5))}s`;
  shown.view.snapshot(2, (canvas) => {
    void compose_picture(canvas, shown.scale).then((picture) => save_canvas(name, picture));
  });
}

function make_thickness(shown: Shown): HTMLElement {
  const slider = make("input", { type: "range", min: 1, max: 6, step: 0.25, value: 1 });
  slider.addEventListener("input", () => {
    shown.view.rods.set_thickness(Number(slider.value));
    shown.view.redraw();
  });
  return make("label", { class: "choice", title: "Draw fibers thicker than they are" }, make("span", {}, "Thickness"), slider);
}

function animated(shown: Shown): Animated {
  const { store } = shown;
  const show = (share: number): string => {
    const time = store.times[0]! + share * store.duration();
    shown.go(position_of(store.times, time));
    return `t = ${write_quantity(time, "s")}`;
  };
  const frames = store.times.map((time) => (time - store.times[0]!) / store.duration());
  const keep_place = () => {
    const { position } = shown;
    return (): void => shown.go(position);
  };
  return { name: shown.section.id, stage: shown.view, scale: () => shown.scale, show, frames, keep_place };
}

function add_controls(controls: HTMLElement, shown: Shown): void {
  const image_options = [
    { value: "window", text: "cut at the cell" }, { value: "fibers", text: "whole fibers" }, { value: "computed", text: "as computed" },
  ];
  controls.append(
    make_choice("Colour", colourings_of(shown.breaks), shown.colouring, (value) => choose_colours(shown, value as Colouring)),
    make_choice("Images", image_options, shown.images, (value) => {
      shown.images = value as Images;
      show_state(shown);
    }),
    make_thickness(shown),
    make_toggle("Follow", "Keep the fiber that was clicked in the middle", false, (on) => {
      shown.follow = on;
      show_state(shown);
    }),
    make_toggle("Cell", "Show the cell, and lines that the melt carries along", true, (on) => {
      shown.view.outline.group.visible = on;
      shown.view.redraw();
    }),
    make_button("Reset", "Put the camera back", () => shown.view.reset_camera()),
    make_save_menu(
      make_button("Picture as PNG", "The picture with its colour bar", () => save_picture(shown)),
      make_button("Fibers as CSV", "The fibers of the frame at or after this time", () => save_frame(shown)),
      ...(shown.store.times.length > 1 ? make_animation_buttons(animated(shown)) : []),
    ),
  );
}

function start_view(section: FibersSection, store: FrameStore, stage: HTMLElement, bar: HTMLElement): Shown | undefined {
  const first = store.frame(0);
  let view: View;
  const longest = Math.max(...store.samples().flatMap(({ measures }) => measures.length.reduce((most, one) => Math.max(most, one), 0)), 1e-12);
  const side = make_side_panel(longest);
  try {
    view = make_view(stage, first.frame, { capacity: first.frame.rods, finish: side.turn });
  } catch {
    stage.dataset.webgl = "missing";
    stage.append(make("p", { class: "note" }, "The cell cannot be shown in 3D: this browser has WebGL turned off or has no graphics driver. All numbers of the report are complete without it."));
    return undefined;
  }
  stage.dataset.webgl = "working";
  const breaks = new BreakTimes(section.breaks ? decode_breaks(section.breaks) : see_breaks(store.all()));
  const marks = make_break_marks(breaks.breaks, remembered_breaks * store.duration() || 1);
  view.scene.add(marks.points);
  const colouring: Colouring = breaks.breaks.length > 0 || has_many_lengths(store) ? "length" : "angle_x";
  const state = store.at(0);
  return {
    section, store, breaks, position: 0, state, images: "window", follow: false, colouring,
    scale: make_scale(colouring, store.samples(), store.duration()), placed: place_rods(state, "window", window_of(state)),
    view, marks, side, stage, bar, go: () => {},
  };
}

/** Lengths tell nothing where all fibers are equally long. */
function has_many_lengths(store: FrameStore): boolean {
  return store.samples().some(({ measures: { length } }) => length.some((one) => Math.abs(one - length[0]!) > 1e-3 * length[0]!));
}

/** Says how the times between frames come about. */
function explain_between(frames: FiberFrame[], is_sheared: boolean): string {
  if (frames.length > 1 && !is_sheared) return `${frames.length} frames, one after another; a cell that stretches goes on in new images of its lattice.`;
  return frames.length > 1 ? `${frames.length} frames; between them fibers ride with the shear, and turn and drift evenly on top of it.` : "";
}

export function render_fibers(section: FibersSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  if (section.frames.length === 0) throw new Error("it holds no frames");
  const store = new FrameStore(section.frames);
  const stage = make("div", { class: "stage", role: "img", "aria-label": `${section.title}: drag to turn, click and scroll to zoom, point at a fiber for its numbers, click it to follow it` });
  const bar = make("div", { class: "bar" });
  const scene = make("div", { class: "scene" }, stage, bar);
  figure.append(scene);
  const shown = start_view(section, store, stage, bar);
  if (!shown) return element;
  scene.append(shown.side.element);
  // The end is the most telling moment: all breaks are there, and the orientation has come about.
  const last = section.frames.length - 1;
  const player = make_player(store.times, (position) => go_to(shown, position), { seconds: seconds_to_play, start: last });
  shown.go = player.go;
  shown.pointer = follow_pointer(stage, shown.view, () => shown, () => show_state(shown));
  add_controls(controls, shown);
  figure.append(player.element, make("p", { class: "between" }, explain_between(section.frames, window_of(store.at(0)) !== undefined)));
  go_to(shown, last);
  choose_colours(shown, shown.colouring);
  add_print_view((palette) => bar.replaceChildren(make_colour_bar(shown.scale, palette)));
  watch_scheme(() => {
    shown.view.adapt_to_scheme();
    choose_colours(shown, shown.colouring);
    shown.side.show(shown.state);
  });
  return element;
}
