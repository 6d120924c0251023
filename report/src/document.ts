// The report document, schemas 1 and 2, as the C++ program writes it (docs/formats/report.md).

/** A number; null stands for NaN or infinity. */
export type Value = number | null;
export type Scale = "linear" | "log";

export interface Axis {
  label: string;
  unit?: string;
  scale?: Scale;
  values?: Value[];
  /** Names that stand at 1, 2, 3, … along the axis instead of numbers. */
  names?: string[];
}

/** Where a section stands on the page. */
export type Role = "picture" | "outcome" | "chart" | "wide" | "detail";

interface SectionBase {
  id: string;
  title: string;
  caption?: string;
  /** Without it the page goes by kind and id. */
  role?: Role;
}

export interface Fact {
  label: string;
  value: string | Value | Value[][];
  unit?: string;
  note?: string;
  /** Among the few that a reader wants first. */
  headline?: boolean;
}
export interface FactsSection extends SectionBase {
  kind: "facts";
  rows: Fact[];
}

/** A fact of several runs. */
export interface ComparedFact {
  label: string;
  unit?: string;
  headline?: boolean;
  /** One a run; of replicas their mean. */
  values: (string | Value)[];
  /** The least and the largest of replicas. */
  low?: Value[];
  high?: Value[];
}
export interface ComparisonSection extends SectionBase {
  kind: "comparison";
  runs: string[];
  rows: ComparedFact[];
}

export interface Series {
  label: string;
  values: Value[];
  x?: Value[];
  /** Closed outlines are filled; a missing value ends one. */
  style?: "line" | "dashed" | "points" | "filled";
  /** Bounds of a band, of points those of a bar each. */
  low?: Value[];
  high?: Value[];
  /** Number of its colour, from 0; without it that of its place in the list. */
  colour?: number;
}
export interface Compared {
  quantity: string;
  runs: string[];
}

export interface LinesSection extends SectionBase {
  kind: "lines" | "scatter";
  x: Axis;
  y: Axis;
  series: Series[];
  /** A unit is as long on x as on y: for pictures of things. */
  equal?: boolean;
  /** The legend tells names alone: where values at a place say nothing. */
  legend?: "names";
  /** Not of the document: what the curves of runs are curves of, which the page finds out. */
  compared?: Compared;
}

export interface HistogramFrame {
  label: string;
  values: Value[];
}
export interface HistogramSection extends SectionBase {
  kind: "histogram";
  x: Axis;
  y: Axis;
  edges: number[];
  frames: HistogramFrame[];
  reference?: HistogramFrame;
  /** Drawn over the bars, each with its own x. */
  curves?: Series[];
}

export interface TableSection extends SectionBase {
  kind: "table";
  columns: { label: string; unit?: string }[];
  rows: (string | Value)[][];
}

export interface HeatmapSection extends SectionBase {
  kind: "heatmap";
  x: Axis;
  y: Axis;
  values: Value[][];
  label?: string;
  unit?: string;
  /** What the colours span; without it from the least value to the largest. */
  range?: [number, number];
  /** `diverging` tells what lies below and above the middle of the range apart. */
  colours?: "sequential" | "diverging";
  /** Every value is written into its cell. */
  written?: boolean;
  /** A unit is as long on x as on y. */
  equal?: boolean;
}

/** One state of the cell; binary parts are base64 of little-endian numbers, lengths in metres. */
export interface FiberFrame {
  time_s: number;
  lattice: number[];
  origin?: number[];
  periodic?: boolean[];
  /** Shear strain since the start. */
  strain?: number;
  offsets: string;
  /** Nodes as float32; absent where `grid` holds them. */
  points?: string;
  /** Nodes as uint16 steps of a grid along x, y, z [m]. */
  grid?: { steps: string; corner: number[]; step: number[] };
  birth: string;
  birth_node?: string;
  radius: string;
}
/** Broken hinges, one entry each: when (float32, s), of which birth fiber and at which node along it (int32). */
export interface FiberBreaks {
  time_s: string;
  birth: string;
  node: string;
}
export interface FibersSection extends SectionBase {
  kind: "fibers";
  frames: FiberFrame[];
  breaks?: FiberBreaks;
}

/** A field at the nodes of a part; each frame is base64 of float32, one alone holds at all times. */
export interface ShellField {
  label: string;
  unit?: string;
  frames: string[];
}
/** A labelled place on a part [m]; `kind` is its look. */
export interface ShellPlace {
  label: string;
  kind: "gate" | "place" | "trap";
  at: [number, number, number];
}
/** Line segments on a part: base64 of float32, six coordinates each [m]. */
export interface ShellLines {
  label: string;
  segments: string;
}
/** Symmetric tensors at the nodes: float32, 11 22 33 23 31 12 a node; one frame alone holds at all times. */
export interface ShellTensors {
  label: string;
  frames: string[];
}
/** Directions on the part at some places: float32, xyz each; their length is their size, in `unit`. */
export interface ShellDirections {
  label: string;
  unit?: string;
  at: string;
  vectors: string;
}
/** Profiles from the mid-plane to the wall: float32, one value a node and layer, layers of a node together. */
export interface ShellLayers {
  /** Heights of the layers over the mid-plane, over half of the thickness. */
  heights: number[];
  /** Thickness at each node as float32 [m]. */
  thickness: string;
  fields: { label: string; unit?: string; values: string }[];
}
export interface ShellSection extends SectionBase {
  kind: "shell";
  points: string;
  triangles: string;
  fill_time: string;
  times: number[];
  fields: ShellField[];
  places?: ShellPlace[];
  lines?: ShellLines[];
  tensors?: ShellTensors[];
  directions?: ShellDirections[];
  layers?: ShellLayers;
}

export type Section =
  | FactsSection
  | ComparisonSection
  | LinesSection
  | HistogramSection
  | TableSection
  | HeatmapSection
  | FibersSection
  | ShellSection;

export interface ReportDocument {
  schema: number;
  title: string;
  /** Name of the case or of its folder. */
  case?: string;
  subtitle?: string;
  study?: string;
  version?: string;
  stop_reason?: string;
  sections: Section[];
}

/** Schema 2 adds to schema 1 and takes nothing away. */
export const known_schemas = [1, 2];

/** Reads the document out of the page, or says why there is none to show. */
export function read_document(): ReportDocument {
  const text = document.getElementById("fiberfate-document")?.textContent ?? "";
  const parsed: unknown = JSON.parse(text);
  if (typeof parsed !== "object" || parsed === null) {
    throw new Error("this page is the empty template; `fiberfate report DIR` fills it");
  }
  const found = parsed as ReportDocument;
  if (!known_schemas.includes(found.schema)) {
    throw new Error(`the document has schema ${found.schema}, this page reads ${known_schemas.join(" and ")}`);
  }
  return found;
}

/** Tells whether a value is a finite number. */
export function is_number(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value);
}
