// The section "table": numbers in columns, each with its unit.
import { is_number, type TableSection } from "../document";
import { make, make_button, make_label } from "../dom";
import { write_number, write_unit } from "../format";
import { save_csv } from "../save";
import { make_section } from "./parts";

function make_head(section: TableSection): HTMLElement {
  const cells = section.columns.map(({ label, unit }) => {
    const cell = make("th", { scope: "col" }, make_label(label));
    const shown = write_unit(unit);
    if (shown) cell.append(make("span", { class: "unit" }, shown));
    return cell;
  });
  return make("thead", {}, make("tr", {}, ...cells));
}

function make_cell(value: string | number | null | undefined): HTMLElement {
  if (typeof value === "string") return make("td", { class: "text" }, make_label(value));
  return make("td", { "data-value": is_number(value) ? value : "" }, write_number(value));
}

export function render_table(section: TableSection): HTMLElement {
  const { element, controls, figure } = make_section(section);
  const body = make("tbody", {}, ...section.rows.map((row) => {
    return make("tr", {}, ...section.columns.map((_column, k) => make_cell(row[k])));
  }));
  figure.append(make("div", { class: "scroll", tabindex: 0 }, make("table", { class: "numbers" }, make_head(section), body)));
  controls.append(make_button("CSV", "Save the table as CSV", () => {
    save_csv(section.id, section.columns.map(({ label, unit }, k) => ({
      header: unit ? `${label} [${unit}]` : label,
      values: section.rows.map((row) => row[k]),
    })));
  }));
  return element;
}
