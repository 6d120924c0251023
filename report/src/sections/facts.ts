// The section "facts": labelled values, with tensors as small matrices.
import type { Fact, FactsSection, Value } from "../document";
import { make, make_label } from "../dom";
import { largest_magnitude, write_component, write_quantity, write_unit } from "../format";
import { make_section } from "./parts";

/** Writes all components to the same decimal, so that they can be compared down a column. */
function make_matrix(rows: Value[][]): HTMLElement {
  const largest = largest_magnitude(rows.flat());
  const body = make("tbody", {});
  for (const row of rows) {
    body.append(make("tr", {}, ...row.map((value) => make("td", {}, write_component(value, largest)))));
  }
  return make("table", { class: "matrix" }, body);
}

/** Sets symbols of a text; names of files stay as they are. */
function make_text(text: string, unit: string): Node {
  const shown = unit ? `${text}\u00a0${unit}` : text;
  return /\/|\.\w/.test(text) ? document.createTextNode(shown) : make("span", {}, make_label(shown));
}

function make_value(fact: Fact): Node {
  if (Array.isArray(fact.value)) {
    const matrix = make_matrix(fact.value);
    const unit = write_unit(fact.unit);
    return make("span", { class: "tensor" }, matrix, unit ? make("span", { class: "unit" }, unit) : "");
  }
  if (typeof fact.value === "string") return make_text(fact.value, write_unit(fact.unit));
  return make("span", { class: "quantity" }, write_quantity(fact.value, fact.unit));
}

/** Letters of a text that find room beside other facts. */
const longest_beside = 48;

function make_row(section: string, fact: Fact): HTMLElement {
  const raw = Array.isArray(fact.value) ? JSON.stringify(fact.value) : (fact.value ?? "");
  const data = { "data-section": section, "data-label": fact.label, "data-value": raw };
  const value = make("dd", data, make_value(fact));
  if (fact.note) value.append(make("small", {}, make_label(fact.note)));
  const long = typeof fact.value === "string" && fact.value.length > longest_beside;
  return make("div", { class: long ? "long" : undefined }, make("dt", {}, make_label(fact.label)), value);
}

export function render_facts(section: FactsSection): HTMLElement {
  const { element, figure } = make_section(section);
  figure.append(make("dl", {}, ...section.rows.map((fact) => make_row(section.id, fact))));
  return element;
}
