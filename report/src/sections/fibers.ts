// The section "fibers": the cell in three dimensions over time.
import type { FibersSection } from "../document";
import { make, make_button, make_choice, make_toggle } from "../dom";
import { current_palette, watch_scheme } from "../palette";
import { add_print_view } from "../print";
import { save_canvas, save_csv } from "../save";
import { make_colour_bar } from "../scene/colour_bar";
import { colour_rods, type Colouring, colourings, type ColourScale, make_scale, type MeasuredFrame } from "../scene/colouring";
import { decode_frame, measure_frame } from "../scene/frame";
import { has_cell, type Images, type PlacedRods, place_rods } from "../scene/images";
import { follow_pointer } from "../scene/pointer";
import { compose_picture } from "../scene/picture";
import { make_player } from "../scene/player";
import { make_view, type View } from "../scene/view";
import { make_section } from "./parts";
import { make_save_menu } from "./save_buttons";

/** What is shown now; the functions below bring the view into agreement with it. */
interface Shown {
  section: FibersSection;
  frames: MeasuredFrame[];
  index: number;
  images: Images;
  colouring: Colouring;
  scale: ColourScale;
  placed: PlacedRods;
  view: View;
  stage: HTMLElement;
  bar: HTMLElement;
}

function show_colours(shown: Shown): void {
  const { view, stage, colouring, scale, placed } = shown;
  view.rods.colour(colour_rods(colouring, scale, shown.frames[shown.index]!, placed), scale);
  shown.bar.replaceChildren(make_colour_bar(scale, current_palette()));
  stage.dataset.colouring = colouring;
  view.redraw();
}

function show_frame(shown: Shown): void {
  const { frame } = shown.frames[shown.index]!;
  const { view, stage } = shown;
  shown.placed = place_rods(frame, shown.images);
  view.rods.place(shown.placed, frame, view.factor);
  if (has_cell(frame)) view.outline.place(frame, view.factor);
  Object.assign(stage.dataset, {
    section: shown.section.id, frame: shown.index, time: frame.time_s, images: shown.images,
    fibers: frame.fibers, rods: frame.rods, drawnRods: shown.placed.count,
  });
  show_colours(shown);
}

function save_frame(shown: Shown): void {
  const { frame, measures } = shown.frames[shown.index]!;
  const fibers = Array.from({ length: frame.fibers }, (_unused, fiber) => fiber);
  save_csv(`${shown.section.id}-${frame.time_s}s`, [
    { header: "fiber", values: fibers },
    { header: "birth fiber", values: [...frame.birth] },
    { header: "rods", values: fibers.map((fiber) => frame.offsets[fiber + 1]! - frame.offsets[fiber]! - 1) },
    { header: "length [m]", values: [...measures.length] },
    { header: "largest curvature [1/m]", values: [...measures.sharpest] },
  ]);
}

function save_picture(shown: Shown): void {
  const { time_s } = shown.frames[shown.index]!.frame;
  shown.view.snapshot(2, (canvas) => {
    void compose_picture(canvas, shown.scale).then((picture) => save_canvas(`${shown.section.id}-${time_s}s`, picture));
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

function add_controls(controls: HTMLElement, shown: Shown): void {
  const image_options = [
    { value: "rods", text: "rods in the cell" }, { value: "fibers", text: "whole fibers" }, { value: "computed", text: "as computed" },
  ];
  controls.append(
    make_choice("Colour", colourings, shown.colouring, (value) => {
      shown.colouring = value as Colouring;
      shown.scale = make_scale(shown.colouring, shown.frames);
      show_colours(shown);
    }),
    make_choice("Images", image_options, shown.images, (value) => {
      shown.images = value as Images;
      show_frame(shown);
    }),
    make_thickness(shown),
    make_toggle("Cell", "Show the outline of the cell", true, (on) => {
      shown.view.outline.lines.visible = on && has_cell(shown.frames[shown.index]!.frame);
      shown.view.redraw();
    }),
    make_button("Reset", "Put the camera back", () => shown.view.reset_camera()),
    make_save_menu(
      make_button("Picture as PNG", "The picture with its colour bar", () => save_picture(shown)),
      make_button("Fibers as CSV", "The fibers at this time", () => save_frame(shown)),
    ),
  );
}

function start_view(section: FibersSection, frames: MeasuredFrame[], stage: HTMLElement, bar: HTMLElement): Shown | undefined {
  const capacity = Math.max(...frames.map(({ frame }) => frame.rods));
  let view: View;
  try {
    view = make_view(stage, frames[0]!.frame, capacity);
  } catch {
    stage.dataset.webgl = "missing";
    stage.append(make("p", { class: "note" }, "The cell cannot be shown in 3D: this browser has WebGL turned off or has no graphics driver. All numbers of the report are complete without it."));
    return undefined;
  }
  stage.dataset.webgl = "working";
  const colouring: Colouring = "length";
  return {
    section, frames, index: 0, images: "rods", colouring, scale: make_scale(colouring, frames),
    placed: place_rods(frames[0]!.frame, "rods"), view, stage, bar,
  };
}

export function render_fibers(section: FibersSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  if (section.frames.length === 0) throw new Error("it holds no frames");
  const frames = section.frames.map((raw) => {
    const frame = decode_frame(raw);
    return { frame, measures: measure_frame(frame) };
  });
  const stage = make("div", { class: "stage", role: "img", "aria-label": `${section.title}: drag to turn, scroll to zoom, point at a fiber for its numbers` });
  const bar = make("div", { class: "bar" });
  figure.append(make("div", { class: "scene" }, stage, bar));
  const shown = start_view(section, frames, stage, bar);
  if (!shown) return element;
  const player = make_player(frames.map(({ frame }) => frame.time_s), (index) => {
    shown.index = index;
    show_frame(shown);
    pointer.frame_changed();
  });
  const pointer = follow_pointer(stage, shown.view, () => ({ measured: frames[shown.index]!, placed: shown.placed }));
  add_controls(controls, shown);
  figure.append(player.element);
  show_frame(shown);
  add_print_view((palette) => bar.replaceChildren(make_colour_bar(shown.scale, palette)));
  watch_scheme(() => {
    shown.view.adapt_to_scheme();
    show_colours(shown);
  });
  return element;
}
