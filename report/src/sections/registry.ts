// Which function renders which kind of section; an unknown or broken one becomes a note, never a broken page.
import type { Section } from "../document";
import { make } from "../dom";
import { render_comparison } from "./comparison";
import { render_facts } from "./facts";
import { render_fibers } from "./fibers";
import { render_heatmap } from "./heatmap";
import { render_histogram } from "./histogram";
import { render_lines } from "./lines";
import { make_section } from "./parts";
import { render_shell } from "./shell";
import { render_table } from "./table";

function render_kind(section: Section): HTMLElement | undefined {
  switch (section.kind) {
    case "facts": return render_facts(section);
    case "comparison": return render_comparison(section);
    case "lines":
    case "scatter": return render_lines(section);
    case "histogram": return render_histogram(section);
    case "table": return render_table(section);
    case "heatmap": return render_heatmap(section);
    case "fibers": return render_fibers(section);
    case "shell": return render_shell(section);
    default: return undefined;
  }
}

function render_note(section: Section, text: string): HTMLElement {
  const { element, figure } = make_section({ id: section.id, title: section.title ?? section.id, kind: "note" });
  figure.append(make("p", { class: "note" }, text));
  return element;
}

export function render_section(section: Section): HTMLElement {
  try {
    return render_kind(section) ?? render_note(section, `This page does not know sections of kind “${(section as Section).kind}”.`);
  } catch (error) {
    return render_note(section, `This section could not be shown: ${error instanceof Error ? error.message : String(error)}.`);
  }
}
