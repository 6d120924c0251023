// The section "table": numbers in columns, each with its unit.
import { is_number, type TableSection } from "../document";
import { make, make_button, make_label } from "../dom";
import { choose_unit, largest_magnitude, type ShownUnit, write_number } from "../format";
import { save_csv } from "../save";
import { make_section, make_text_cell } from "./parts";
import { make_scroll } from "./scroll";

/** Every column is in the unit that suits its largest number, as a chart of it would be. */
function units_of(section: TableSection): ShownUnit[] {
  return section.columns.map(({ unit }, k) => {
    const numbers = section.rows.map((row) => row[k]).filter(is_number);
    return choose_unit(unit, largest_magnitude(numbers));
  });
}

function make_head(section: TableSection, units: ShownUnit[]): HTMLElement {
  const cells = section.columns.map(({ label }, k) => {
    const text = section.rows.every((row) => typeof row[k] === "string");
    const cell = make("th", { scope: "col", class: text ? "text" : undefined }, make_label(label));
    if (units[k]!.unit) cell.append(make("span", { class: "unit" }, units[k]!.unit));
    return cell;
  });
  return make("thead", {}, make("tr", {}, ...cells));
}

function make_cell(value: string | number | null | undefined, factor: number): HTMLElement {
  if (typeof value === "string") return make_text_cell(value);
  return make("td", { "data-value": is_number(value) ? value : "" }, write_number(is_number(value) ? value * factor : value));
}

export function render_table(section: TableSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const units = units_of(section);
  const body = make("tbody", {}, ...section.rows.map((row) => {
    return make("tr", {}, ...section.columns.map((_column, k) => make_cell(row[k], units[k]!.factor)));
  }));
  figure.append(make_scroll(make("table", { class: "numbers" }, make_head(section, units), body)));
  controls.append(make_button("CSV", "Save the table as CSV", () => {
    save_csv(section.id, section.columns.map(({ label, unit }, k) => ({
      header: unit ? `${label} [${unit}]` : label,
      values: section.rows.map((row) => row[k]),
    })));
  }));
  return element;
}
