// The headlines of a report: large numbers, each with its course over the run and what changed.
import { type ComparedFact, is_number, type ReportDocument } from "../document";
import { make, make_label, make_svg } from "../dom";
import { choose_unit, is_component, write_number, write_quantity } from "../format";
import { choose_compared, choose_headlines, type Headline } from "../headline";
import { make_sample, unit_of } from "./comparison";

const spark = { width: 120, height: 30 };

/** Draws the course of a number without axes: where it came from is told in words beside it. */
function draw_spark({ x, values }: NonNullable<Headline["course"]>): SVGSVGElement | undefined {
  const points = values.map((y, k) => [x[k], y] as const).filter((point): point is [number, number] => point.every(is_number));
  const [xs, ys] = [points.map(([at]) => at), points.map(([, y]) => y)];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [low, high] = [Math.min(...ys), Math.max(...ys)];
  if (points.length < 2 || !(right > left) || !(high > low)) return undefined;
  const place = ([at, y]: [number, number]): string =>
    `${((spark.width - 8) * (at - left)) / (right - left) + 2},${spark.height - 4 - ((spark.height - 8) * (y - low)) / (high - low)}`;
  const places = points.map(place);
  const [end_x, end_y] = places.at(-1)!.split(",");
  return make_svg(
    "svg", { class: "spark", viewBox: `0 0 ${spark.width} ${spark.height}`, "aria-hidden": "true" },
    make_svg("path", { d: `M${places.join("L")}` }), make_svg("circle", { cx: end_x, cy: end_y, r: 2.6 }),
  );
}

/** Tells shares and components of tensors from counts and from amounts with a unit. */
function is_share({ label, value, unit }: Headline, first: number): boolean {
  return is_component(label) || unit === "%" || ((!unit || unit === "1") && !(Number.isInteger(value) && Number.isInteger(first)));
}

function sign(change: number, magnitude: string): string {
  return `${change < 0 ? "\u2212" : "+"}${magnitude}`;
}

/** Says where a number came from: a share by the difference, all else in per cent; an amount that began at nothing has none. */
function tell_change(headline: Headline): string | undefined {
  const { value, unit, course } = headline;
  const first = course?.values.find(is_number);
  if (first === undefined || !is_number(value)) return undefined;
  const change = value - first;
  if (Math.abs(change) <= 1e-9 * Math.abs(first)) return "as at the start";
  const from = `from ${write_quantity(first, unit, 3)}`;
  if (is_share(headline, first)) return `${from}, ${sign(change, write_quantity(Math.abs(change), unit === "%" ? "points" : unit, 3))}`;
  if (!(Math.abs(first) > 1e-9 * Math.abs(value)) || first * value < 0) return from;
  const share = (100 * change) / Math.abs(first);
  if (Math.abs(share) >= 1000) return from;
  return `${from}, ${sign(change, write_number(Number(Math.abs(share).toPrecision(2)), 2))}\u2009%`;
}

/** Letters of a number beyond which it is set smaller. */
const longest_large = 8;

/** Sets a number and its unit; a line may end between them, never inside of one. */
function make_tile_value(number: string, unit: string): HTMLElement {
  const value = make("span", { class: number.length > longest_large ? "number long" : "number" }, number);
  return make("span", { class: "tile-value" }, value, ...(unit ? [" ", make("span", { class: "unit" }, unit)] : []));
}

function make_tile(headline: Headline): HTMLElement {
  const { label, value, unit, note } = headline;
  const shown = choose_unit(unit, Math.abs(value ?? 0));
  const number = write_number(is_number(value) ? value * shown.factor : null, 3);
  const tile = make(
    "li", { class: "tile", "data-label": label, "data-value": value ?? "" },
    make("span", { class: "tile-label" }, make_label(label)),
    make_tile_value(number, shown.unit),
  );
  const drawn = headline.course && draw_spark(headline.course);
  if (drawn) tile.append(drawn);
  const told = tell_change(headline) ?? note;
  if (told) tile.append(make("span", { class: "tile-note" }, make_label(told)));
  return tile;
}

/** Makes the tile of a fact of several runs: their numbers below each other, in one unit. */
function make_compared_tile({ fact, runs }: { fact: ComparedFact; runs: string[] }): HTMLElement {
  const { unit, factor } = unit_of(fact);
  const title = make("span", { class: "tile-label" }, make_label(fact.label));
  if (unit) title.append(make("span", { class: "unit" }, ` (${unit})`));
  const rows = runs.map((run, k) => {
    const value = fact.values[k];
    const shown = is_number(value) ? write_number(value * factor, 3) : (value ?? "–");
    return make("li", { "data-run": run, "data-value": value ?? "" }, make_sample(k), make("span", { class: "run" }, make_label(run)), make("b", {}, shown));
  });
  return make("li", { class: "tile compared", "data-label": fact.label }, title, make("ul", {}, ...rows));
}

/** Makes the row of tiles, or nothing where the document has no numbers to headline. */
export function render_tiles(found: ReportDocument): HTMLElement | undefined {
  const tiles = [...choose_headlines(found).map(make_tile), ...choose_compared(found).map(make_compared_tile)];
  if (tiles.length === 0) return undefined;
  return make("ul", { class: "tiles", "aria-label": "Results" }, ...tiles);
}
