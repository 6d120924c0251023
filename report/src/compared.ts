// Charts of several runs: their curves bear the names of runs, and the quantity stands in the title.
import type { LinesSection, ReportDocument, Series } from "./document";
import { split_label } from "./format";

/** The last part of a title such as "Mean fiber lengths: L_N". */
function part_of({ title }: LinesSection): string | undefined {
  return /: ([^:]+)$/.exec(title)?.[1];
}

/** Dashes of a quantity told it from its neighbours in the chart of one run; the curves of runs are told apart by colours. */
function undash(series: Series, runs: string[]): void {
  if (series.style === "dashed" && runs.includes(series.label)) series.style = "line";
}

/** Lets axes of charts of several runs say their quantity, and tells the charts of which runs their curves are. */
export function name_quantities({ sections }: ReportDocument): void {
  const runs = sections.flatMap((section) => (section.kind === "comparison" ? section.runs : []));
  if (runs.length === 0) return;
  for (const section of sections) {
    if (section.kind !== "lines" && section.kind !== "scatter") continue;
    for (const series of section.series) undash(series, runs);
    const part = part_of(section);
    const symbol = part !== undefined && split_label(part).some(({ subscript }) => subscript);
    if (part !== undefined) section.y.label = `${section.y.label}, ${part}`;
    section.compared = { quantity: symbol ? part : section.y.label, runs };
  }
}

const most_names = 3;

/** Names a curve for a file, where no title stands beside it: its quantity, its run, and what of replicas it is. */
export function name_in_file({ compared }: LinesSection, { label, low }: Series): { curve: string; replicas: number } {
  if (!compared?.runs.includes(label)) return { curve: label, replicas: 1 };
  const names = label.split(", ");
  const runs = names.length > most_names ? `${names[0]}, …, ${names.at(-1)}` : label;
  return { curve: `${compared.quantity} of ${runs}`, replicas: low ? names.length : 1 };
}

/** Names a curve in the legend of a file. */
export function name_in_legend(section: LinesSection, series: Series): string {
  const { curve, replicas } = name_in_file(section, series);
  return replicas > 1 ? `${curve} (mean, least to largest of ${replicas})` : curve;
}
