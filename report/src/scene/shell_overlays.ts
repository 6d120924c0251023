// What lies over a part and can be turned on and off: lines, ellipses of orientation, axes.
import type { Object3D } from "three";
import type { ShellSection } from "../document";
import type { ShellData } from "./shell";
import { make_axes } from "./shell_axes";
import { make_ellipses } from "./shell_ellipses";
import { make_mark_lines } from "./shell_lines";

export interface Overlay {
  label: string;
  title: string;
  object: Object3D;
  set_time?: (time: number) => void;
}

/** Makes the overlays of a section; lines are shown at first, the others when the reader asks. */
export function make_overlays(section: ShellSection, data: ShellData, factor: number): Overlay[] {
  const lines = (section.lines ?? []).map((one): Overlay => {
    const { lines: object, set_time } = make_mark_lines(one, data, factor);
    return { label: one.label, title: `Show the ${one.label}`, object, set_time };
  });
  const ellipses = (section.tensors ?? []).map((one): Overlay => {
    const { group: object, set_time } = make_ellipses(one, data, factor);
    object.visible = false;
    return { label: one.label, title: "Ellipses are longer along more fibers, and round where none is preferred", object, set_time };
  });
  const axes = (section.directions ?? []).map((one): Overlay => {
    const object = make_axes(one, factor);
    object.visible = false;
    return { label: one.label, title: `Strokes along the ${one.label}, the longer the larger`, object };
  });
  return [...lines, ...ellipses, ...axes];
}
