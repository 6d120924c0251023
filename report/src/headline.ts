// Which few numbers stand on top of the page, and what became of each in the course of the run.
import { type ComparedFact, type Fact, is_number, type LinesSection, type ReportDocument, type Series, type Value } from "./document";
import { compared_outcomes, outcome_facts } from "./layout";

export interface Headline {
  label: string;
  value: Value;
  unit?: string;
  note?: string;
  /** The same quantity over the run, where the document has a curve of it. */
  course?: { x: Value[]; values: Value[] };
}

const most_headlines = 6;

function plain(label: string): string {
  return label.toLowerCase().replaceAll(/[_\s]/g, "");
}

interface FoundSeries {
  section: LinesSection;
  series: Series;
}

function find_series(found: ReportDocument, label: string): FoundSeries | undefined {
  for (const section of found.sections) {
    if (section.kind !== "lines") continue;
    const series = section.series.find((one) => plain(one.label) === plain(label));
    if (series) return { section, series };
  }
  return undefined;
}

/** A curve tells the course of a fact when it ends where the fact stands. */
function course_of(found: ReportDocument, label: string, value: number): Headline["course"] {
  const match = find_series(found, label);
  if (!match) return undefined;
  const last = match.series.values.filter(is_number).at(-1);
  if (last === undefined || Math.abs(last - value) > 1e-3 * Math.abs(value)) return undefined;
  return { x: match.series.x ?? match.section.x.values ?? [], values: match.series.values };
}

/** A tensor stands for itself by its first component, under its own name. */
function headline_of(found: ReportDocument, fact: Fact): Headline | undefined {
  const { unit, note } = fact;
  const tensor = Array.isArray(fact.value);
  const value = tensor ? (fact.value as Value[][])[0]?.[0] : fact.value;
  if (!is_number(value)) return undefined;
  const label = tensor ? "a_11" : fact.label;
  return { label, value, unit, note: tensor ? fact.label : note, course: course_of(found, label, value) };
}

/** Chooses the document's headlines, or those of its results that have a course, and others up to six. */
export function choose_headlines(found: ReportDocument): Headline[] {
  const facts = found.sections.flatMap((section) => (section.kind === "facts" ? section.rows : []));
  const marked = facts.filter((fact) => fact.headline);
  const candidates = marked.length > 0 ? marked : outcome_facts(found).flatMap((section) => section.rows);
  const headlines = candidates.map((fact) => headline_of(found, fact)).filter((one): one is Headline => one !== undefined);
  if (marked.length > 0) return headlines;
  return [...headlines.filter((one) => one.course), ...headlines.filter((one) => !one.course)].slice(0, most_headlines);
}

/** Tells whether a chart shows this fact of all runs: alone, as comparisons have it. */
function drawn_alone(found: ReportDocument, label: string): boolean {
  const name = plain(label.split(", ").at(-1)!);
  return found.sections.some((section) => section.kind === "lines" && plain((section.title ?? "").split(": ").at(-1)!) === name);
}

const most_compared = 4;
const round_off = 1e-6;

/** Chooses what of several runs stands on top: the headlines, or else numbers in which the runs differ. */
export function choose_compared(found: ReportDocument): { fact: ComparedFact; runs: string[] }[] {
  const all = compared_outcomes(found).flatMap(({ rows, runs }) => rows.map((fact) => ({ fact, runs })));
  const marked = all.filter(({ fact }) => fact.headline);
  const differs = ({ fact }: { fact: ComparedFact }): boolean => {
    if (!fact.values.every(is_number)) return false;
    const [least, most] = [Math.min(...fact.values), Math.max(...fact.values)];
    return most - least > round_off * Math.max(Math.abs(least), Math.abs(most));
  };
  if (marked.length > 0) return marked.slice(0, most_compared);
  const found_different = all.filter(differs);
  // As on the page of one run: first what has a course.
  const has_course = ({ fact }: { fact: ComparedFact }): boolean => drawn_alone(found, fact.label);
  return [...found_different.filter(has_course), ...found_different.filter((one) => !has_course(one))].slice(0, most_compared);
}
