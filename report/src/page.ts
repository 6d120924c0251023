// The page: title, headlines, picture, charts two abreast, outcome, and the rest folded away.
import { name_quantities } from "./compared";
import type { ReportDocument, Section } from "./document";
import { make, make_label } from "./dom";
import { arrange, role_of } from "./layout";
import { render_section } from "./sections/registry";
import { render_tiles } from "./sections/tiles";

const charts_a_page = 4;

function make_header(found: ReportDocument): HTMLElement {
  const facts = [
    found.study && `study ${found.study}`,
    found.stop_reason && `ended: ${found.stop_reason.replaceAll("_", " ")}`,
    found.version && `fiberfate ${found.version}`,
  ].filter((text): text is string => Boolean(text));
  const header = make("header", { class: "title" });
  if (found.case) header.append(make("p", { class: "kicker" }, make_label(found.title)));
  header.append(make("h1", {}, make_label(found.case ?? found.title)));
  if (found.subtitle) header.append(make("p", { class: "subtitle" }, make_label(found.subtitle)));
  header.append(make("ul", { class: "origin" }, ...facts.map((text) => make("li", {}, text))));
  return header;
}

/** Names the case first: browsers cut titles at their end, and print them on every page. */
function write_title(found: ReportDocument): string {
  const longest = 60;
  const name = found.case ?? (found.subtitle && found.subtitle.length < longest ? found.subtitle : undefined);
  return [name, found.title, "fiberfate"].filter(Boolean).join(" – ");
}

/** Marks the entry of the section that is being read. */
function follow_reading(links: Map<string, HTMLAnchorElement>, sections: HTMLElement[]): void {
  const watcher = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      for (const link of links.values()) link.removeAttribute("aria-current");
      links.get(entry.target.id)?.setAttribute("aria-current", "true");
    }
  }, { rootMargin: "-15% 0px -75% 0px" });
  for (const section of sections) watcher.observe(section);
}

/** Gives every section an id of its own, so that links and files have names. */
function name_sections(sections: Section[]): void {
  const used = new Set<string>();
  sections.forEach((section, index) => {
    if (!section.id || used.has(section.id)) section.id = `${section.id || "section"}-${index + 1}`;
    used.add(section.id);
  });
}

/** Folds a section away under its title. */
function fold(section: Section, element: HTMLElement): HTMLElement {
  return make("details", { class: "fold" }, make("summary", {}, make_label(section.title ?? section.id)), element);
}

/** Opens what is folded where a link or the browser's history leads, and for paper. */
function unfold_on_demand(main: HTMLElement): void {
  const open_target = (): void => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const folded = target?.closest("details");
    if (folded) folded.open = true;
  };
  window.addEventListener("hashchange", open_target);
  open_target();
  let opened: HTMLDetailsElement[] = [];
  window.addEventListener("beforeprint", () => {
    opened = [...main.querySelectorAll<HTMLDetailsElement>("details.fold:not([open])")];
    for (const folded of opened) folded.open = true;
  });
  window.addEventListener("afterprint", () => {
    for (const folded of opened) folded.open = false;
  });
}

/** Ends printed pages after four charts; on the first page charts share it with the headlines, unless a picture fills it. */
function end_pages(charts: HTMLElement, has_picture: boolean): void {
  let room = has_picture ? charts_a_page : charts_a_page / 2;
  let before: Element | undefined;
  for (const chart of charts.children) {
    const wide = chart.classList.contains("role-wide");
    // A wide one begins a row.
    if (wide) room -= room % 2;
    if (room < (wide ? 2 : 1)) {
      before?.classList.add("page-end");
      room = charts_a_page;
    }
    room -= wide ? 2 : 1;
    before = chart;
  }
}

function make_main(found: ReportDocument, sections: Section[], elements: HTMLElement[]): HTMLElement {
  const charts = make("div", { class: "charts" });
  const details = make("div", { class: "details" });
  const main = make("main", {});
  const tiles = render_tiles(found);
  if (tiles) main.append(tiles);
  main.append(charts, details);
  sections.forEach((section, k) => {
    const role = role_of(section);
    elements[k]!.classList.add(`role-${role}`);
    if (role === "detail") details.append(fold(section, elements[k]!));
    else if (role === "chart" || role === "wide") charts.append(elements[k]!);
    else if (role === "picture") charts.before(elements[k]!);
    else details.before(elements[k]!);
  });
  end_pages(charts, sections.some((section) => role_of(section) === "picture"));
  return main;
}

export function render_page(host: HTMLElement, found: ReportDocument): void {
  document.title = write_title(found);
  name_sections(found.sections);
  name_quantities(found);
  const sections = arrange(found.sections);
  const elements = sections.map(render_section);
  const links = new Map<string, HTMLAnchorElement>();
  for (const section of sections) {
    links.set(section.id, make("a", { href: `#${section.id}` }, make_label(section.title ?? section.id)));
  }
  const entries = [...links.values()].map((link) => make("li", {}, link));
  const contents = make("nav", { "aria-label": "Contents" }, make("ol", {}, ...entries));
  const main = make_main(found, sections, elements);
  host.replaceChildren(make_header(found), contents, main);
  unfold_on_demand(main);
  follow_reading(links, elements);
}
