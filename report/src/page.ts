// The page: title, contents, sections.
import type { ReportDocument, Section } from "./document";
import { make, make_label } from "./dom";
import { render_section } from "./sections/registry";

function make_header(found: ReportDocument): HTMLElement {
  const facts = [
    found.study && `study ${found.study}`,
    found.stop_reason && `ended: ${found.stop_reason}`,
    found.version && `fiberfate ${found.version}`,
  ].filter((text): text is string => Boolean(text));
  const header = make("header", { class: "title" }, make("h1", {}, make_label(found.title)));
  if (found.subtitle) header.append(make("p", { class: "subtitle" }, make_label(found.subtitle)));
  header.append(make("ul", { class: "origin" }, ...facts.map((text) => make("li", {}, text))));
  return header;
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

export function render_page(host: HTMLElement, found: ReportDocument): void {
  document.title = `${found.title} – fiberfate`;
  name_sections(found.sections);
  const sections = found.sections.map(render_section);
  const links = new Map<string, HTMLAnchorElement>();
  for (const section of found.sections) {
    links.set(section.id, make("a", { href: `#${section.id}` }, make_label(section.title ?? section.id)));
  }
  const entries = [...links.values()].map((link) => make("li", {}, link));
  const contents = make("nav", { "aria-label": "Contents" }, make("ol", {}, ...entries));
  host.replaceChildren(make_header(found), contents, make("main", {}, ...sections));
  follow_reading(links, sections);
}
