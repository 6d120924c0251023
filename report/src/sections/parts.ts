// What sections of the page are made of: a heading, a caption, a row of controls, a figure, cells of tables.
import { make, make_label } from "../dom";

export interface SectionParts {
  element: HTMLElement;
  controls: HTMLElement;
  figure: HTMLElement;
}

/** Makes the frame of a section that shows a figure with controls. */
export function make_section(section: { id: string; title: string; caption?: string; kind: string }): SectionParts {
  const controls = make("div", { class: "controls", role: "group", "aria-label": `Controls of ${section.title}` });
  const figure = make("figure", {});
  const heading = make("h2", { id: `${section.id}-title` }, make_label(section.title));
  const element = make(
    "section",
    { id: section.id, class: `kind-${section.kind}`, "aria-labelledby": `${section.id}-title` },
    make("header", {}, heading, controls),
    figure,
  );
  if (section.caption) element.append(make("p", { class: "caption" }, make_label(section.caption)));
  return { element, controls, figure };
}

/** Letters of a text that stays on one line, such as an interval. */
const longest_line = 24;

/** Makes the cell of a table that holds a text. */
export function make_text_cell(text: string): HTMLElement {
  return make("td", { class: text.length > longest_line ? "text" : "text short", "data-value": text }, make_label(text));
}
