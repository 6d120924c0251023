// Where the sections of a document stand on the page: picture, outcome, charts, and what is folded away.
import type { ComparisonSection, FactsSection, ReportDocument, Role, Section } from "./document";

/** Facts and charts of documents that do not say a role: what a reader looks up, not what a reader comes for. */
const known_details = new Set(["asked", "effort", "step", "flow", "timings"]);
const widest_beside_a_chart = 4; // columns of a table

function role_by_kind(section: Section): Role {
  switch (section.kind) {
    case "fibers":
    case "shell": return "picture";
    case "facts":
    case "comparison": return "outcome";
    case "table": return section.columns.length > widest_beside_a_chart ? "wide" : "chart";
    default: return "chart";
  }
}

/** Tells where a section stands: as the document says, or by its kind. */
export function role_of(section: Section): Role {
  if (section.role) return section.role;
  return known_details.has(section.id) ? "detail" : role_by_kind(section);
}

const order: Role[] = ["picture", "chart", "outcome", "detail"];

/** Gives the sections in the order of the page; those of one role keep the document's order. */
export function arrange(sections: Section[]): Section[] {
  const rank = (section: Section): number => {
    const role = role_of(section);
    return order.indexOf(role === "wide" ? "chart" : role);
  };
  return [...sections].sort((a, b) => rank(a) - rank(b));
}

/** Gives the facts from which headlines are chosen. */
export function outcome_facts(found: ReportDocument): FactsSection[] {
  return found.sections.filter((section): section is FactsSection => section.kind === "facts" && role_of(section) === "outcome");
}

/** Gives the results of several runs from which headlines are chosen. */
export function compared_outcomes(found: ReportDocument): ComparisonSection[] {
  return found.sections.filter((section): section is ComparisonSection => section.kind === "comparison" && role_of(section) === "outcome");
}
