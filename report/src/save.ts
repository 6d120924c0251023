// Saving figures and their numbers as files: SVG, PNG, CSV.
import { make_svg } from "./dom";
import { write_font_rules } from "./font";

/** Hands a file to the reader. */
export function download(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The click starts the download at a later turn of the event loop.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A column of a CSV file; its header carries the unit. */
export interface Column {
  header: string;
  values: readonly (number | string | null | undefined)[];
}

function quote(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

const digits = 7;

/** Writes a number without the round-off of its last digits; counts are whole. */
function write_cell(value: Column["values"][number]): string {
  if (typeof value !== "number") return quote(value ?? "");
  if (!Number.isFinite(value)) return "";
  return String(Number.isInteger(value) ? value : Number(value.toPrecision(digits)));
}

/** Writes columns as CSV; an undefined number is an empty cell. */
export function write_csv(columns: Column[]): string {
  const length = Math.max(0, ...columns.map((column) => column.values.length));
  const lines = [columns.map((column) => quote(column.header)).join(",")];
  for (let row = 0; row < length; ++row) {
    lines.push(columns.map((column) => write_cell(column.values[row])).join(","));
  }
  return lines.join("\n") + "\n";
}

export function save_csv(name: string, columns: Column[]): void {
  download(`${name}.csv`, new Blob([write_csv(columns)], { type: "text/csv" }));
}

/** Writes a figure that carries its type with it, since pictures know no fonts of the page. */
function write_with_type(figure: SVGSVGElement): string {
  const carrying = figure.cloneNode(true) as SVGSVGElement;
  carrying.prepend(make_svg("style", {}, write_font_rules()));
  return new XMLSerializer().serializeToString(carrying);
}

/** Saves a figure as a small file: it names its type, and others for where that is missing. */
export function save_svg(name: string, figure: SVGSVGElement): void {
  const text = new XMLSerializer().serializeToString(figure);
  download(`${name}.svg`, new Blob([text], { type: "image/svg+xml" }));
}

/** Makes pixels of a figure. */
export async function draw_svg(figure: SVGSVGElement): Promise<HTMLImageElement> {
  const picture = new Image();
  picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(write_with_type(figure))}`;
  await picture.decode();
  return picture;
}

/** Saves a figure as PNG at three times its nominal size (about 300 dpi at column width). */
export async function save_png(name: string, figure: SVGSVGElement): Promise<void> {
  const scale = 3;
  const picture = await draw_svg(figure);
  const canvas = document.createElement("canvas");
  canvas.width = scale * figure.viewBox.baseVal.width;
  canvas.height = scale * figure.viewBox.baseVal.height;
  canvas.getContext("2d")?.drawImage(picture, 0, 0, canvas.width, canvas.height);
  save_canvas(name, canvas);
}

export function save_canvas(name: string, canvas: HTMLCanvasElement): void {
  canvas.toBlob((blob) => blob && download(`${name}.png`, blob), "image/png");
}
