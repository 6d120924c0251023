// The legend of a chart: a button a curve that shows its value under the cursor and hides it on a click.
import { make, make_label } from "../dom";
import { type Axis, is_number, type LinesSection, type Value } from "../document";
import { largest_magnitude, write_label, write_number } from "../format";
import type { Palette } from "../palette";
import type { Curve, Curves } from "./curves";
import { find_nearest } from "./nearest";

export interface Legend {
  element: HTMLElement;
  /** Shows the values nearest to an x, or the last values where there is none and they are the outcome. */
  show: (x: number | undefined) => void;
  colour: (palette: Palette) => void;
}

function make_entry(section: string, curve: Curve, unit: string, toggled: () => void): [HTMLElement, HTMLElement] {
  const value = make("span", {
    class: "value", "data-section": section, "data-series": curve.label, "data-last": curve.last ?? "",
  });
  const button = make(
    "button",
    { type: "button", "aria-pressed": "true", title: `Show or hide ${write_label(curve.label)}` },
    make("span", { class: `mark ${curve.style}`, "aria-hidden": "true" }),
    make("span", {}, make_label(curve.label)), make("span", { class: "reading" }, value, unit ? ` ${unit}` : ""),
  );
  button.addEventListener("click", () => {
    curve.visible = !curve.visible;
    button.setAttribute("aria-pressed", String(curve.visible));
    toggled();
  });
  return [button, value];
}

const round_off = 1e-12;

/** Tells whether what stands last on an axis is the outcome: on one of time or strain, not on one of angles or places. */
function is_progress({ label, unit }: Axis): boolean {
  return unit === "s" || unit === "min" || unit === "h" || /\b(time|strain|steps?|revolutions)\b/i.test(label);
}

/** Makes the legend; `toggled` is called when a curve is shown or hidden. */
export function make_legend(section: LinesSection, made: Curves, toggled: () => void): Legend {
  const entries = made.curves.map((curve) => make_entry(section.id, curve, made.y_unit.unit, toggled));
  const where = make("span", { class: "where", "aria-live": "off" });
  const names = section.legend === "names";
  const progress = is_progress(section.x);
  const element = make("div", { class: names ? "legend names" : "legend" }, ...entries.map(([button]) => button), where);
  const largest = largest_magnitude(made.curves.flatMap(({ y }) => y));
  // What is left of a difference by round-off is told as nothing.
  const quiet = (value: Value | undefined): Value | undefined => (is_number(value) && Math.abs(value) < round_off * largest ? 0 : value);
  const show = (x: number | undefined): void => {
    made.curves.forEach((curve, k) => {
      const index = x === undefined ? undefined : find_nearest(curve, x);
      const last = curve.last === null ? null : curve.last * made.y_unit.factor;
      entries[k]![1].textContent = write_number(quiet(index === undefined ? last : curve.y[index]));
    });
    where.replaceChildren();
    if (names) return;
    // Hidden values keep their room, so that the chart stays in its place when the cursor comes.
    element.classList.toggle("quiet", x === undefined && !progress);
    if (x === undefined) where.append(progress ? "last values" : "");
    else if (made.x_names) where.append("at ", make_label(made.x_names[Math.round(x) - 1] ?? ""));
    else where.append("at ", make_label(made.x_label), ` ${write_number(x)} ${made.x_unit.unit}`);
  };
  const colour = (palette: Palette): void => {
    made.curves.forEach((curve, k) => {
      entries[k]![0].style.setProperty("--series", palette.series[curve.colour % palette.series.length]!);
    });
  };
  show(undefined);
  return { element, show, colour };
}
