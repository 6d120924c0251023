// The section "comparison": facts of several runs side by side, each run in its colour.
import { type ComparedFact, type ComparisonSection, is_number } from "../document";
import { make, make_button, make_label } from "../dom";
import { choose_unit, largest_magnitude, type ShownUnit, write_number } from "../format";
import { current_palette, watch_scheme } from "../palette";
import { save_csv } from "../save";
import { make_section, make_text_cell } from "./parts";
import { make_scroll } from "./scroll";

/** Makes the sample of a run's colour, which its curves have, too. */
export function make_sample(run: number): HTMLElement {
  const sample = make("span", { class: "mark box", "aria-hidden": "true" });
  const colour = (): void => {
    const { series } = current_palette();
    sample.style.setProperty("--series", series[run % series.length]!);
  };
  colour();
  watch_scheme(colour);
  return sample;
}

/** All runs are in the unit that suits the largest of them. */
export function unit_of(fact: ComparedFact): ShownUnit {
  return choose_unit(fact.unit, largest_magnitude(fact.values.filter(is_number)));
}

/** Writes what one run has, and the ends of its replicas below. */
function make_cell(fact: ComparedFact, run: number, factor: number): HTMLElement {
  const value = fact.values[run];
  if (typeof value === "string") return make_text_cell(value);
  const cell = make("td", { "data-value": value ?? "" }, write_number(is_number(value) ? value * factor : value));
  const [low, high] = [fact.low?.[run], fact.high?.[run]];
  if (is_number(low) && is_number(high) && high > low) cell.append(make("small", {}, `${write_number(low * factor)} to ${write_number(high * factor)}`));
  return cell;
}

function make_row(fact: ComparedFact): HTMLElement {
  const { unit, factor } = unit_of(fact);
  const head = make("th", { scope: "row" }, make_label(fact.label));
  if (unit) head.append(make("span", { class: "unit" }, ` ${unit}`));
  return make("tr", { "data-label": fact.label }, head, ...fact.values.map((_value, run) => make_cell(fact, run, factor)));
}

export function render_comparison(section: ComparisonSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const heads = section.runs.map((run, k) => make("th", { scope: "col" }, make_sample(k), make_label(run)));
  const head = make("thead", {}, make("tr", {}, make("td", {}), ...heads));
  const body = make("tbody", {}, ...section.rows.map(make_row));
  figure.append(make_scroll(make("table", { class: "numbers runs" }, head, body)));
  controls.append(make_button("CSV", "Save the table as CSV", () => save_csv(section.id, [
    { header: "fact", values: section.rows.map(({ label, unit }) => (unit ? `${label} [${unit}]` : label)) },
    ...section.runs.map((run, k) => ({ header: run, values: section.rows.map(({ values }) => values[k]) })),
  ])));
  return element;
}
