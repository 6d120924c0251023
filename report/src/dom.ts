// Small functions that make elements of the page.
import { split_label, write_label } from "./format";

type Attributes = Record<string, string | number | boolean | undefined>;
type Child = Node | string;

function apply(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
}

/** Makes an HTML element. */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  apply(element, attributes, children);
  return element;
}

/** Makes an SVG element. */
export function make_svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  apply(element, attributes, children);
  return element;
}

/** Sets a label with its subscripts. */
export function make_label(label: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  for (const part of split_label(label)) {
    fragment.append(part.subscript ? make("sub", {}, part.text) : part.text);
  }
  return fragment;
}

export function make_button(text: string, title: string, action: () => void): HTMLButtonElement {
  const button = make("button", { type: "button", title }, text);
  button.addEventListener("click", action);
  return button;
}

/** Makes a push button that stays down, and tells its state to assistive technology. */
export function make_toggle(
  text: Child,
  title: string,
  pressed: boolean,
  action: (pressed: boolean) => void,
): HTMLButtonElement {
  const button = make("button", { type: "button", title, "aria-pressed": String(pressed) }, text);
  button.addEventListener("click", () => {
    const now = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(now));
    action(now);
  });
  return button;
}

/** Makes a labelled choice out of a few. */
export function make_choice(
  label: string,
  options: { value: string; text: string }[],
  chosen: string,
  action: (value: string) => void,
): HTMLLabelElement {
  const select = make("select", { name: label.toLowerCase() });
  for (const { value, text } of options) {
    select.append(make("option", { value, selected: value === chosen }, write_label(text)));
  }
  select.addEventListener("change", () => action(select.value));
  return make("label", { class: "choice" }, make("span", {}, label), select);
}
