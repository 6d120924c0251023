// How numbers, units and symbols are written for a reader.
import { is_number, type Value } from "./document";

const minus = "\u2212";
const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/**
 * The units in which the magnitudes of an SI unit are shown, each from some magnitude on. One table for facts, tables and
 * charts: a length on a part reads in mm wherever it stands, 0.9 mm as well as 200 mm.
 */
const ladders: Record<string, [from: number, unit: string, factor: number][]> = {
  m: [[0, "nm", 1e9], [1e-7, "µm", 1e6], [1e-4, "mm", 1e3], [1, "m", 1], [1e3, "km", 1e-3]],
  s: [[0, "ns", 1e9], [1e-6, "µs", 1e6], [1e-3, "ms", 1e3], [0.1, "s", 1]],
  Pa: [[0, "Pa", 1], [1e3, "kPa", 1e-3], [1e5, "MPa", 1e-6], [1e9, "GPa", 1e-9]],
  N: [[0, "nN", 1e9], [1e-6, "µN", 1e6], [1e-3, "mN", 1e3], [1, "N", 1], [1e3, "kN", 1e-3]],
  J: [[0, "nJ", 1e9], [1e-6, "µJ", 1e6], [1e-3, "mJ", 1e3], [1, "J", 1], [1e3, "kJ", 1e-3]],
  W: [[0, "nW", 1e9], [1e-6, "µW", 1e6], [1e-3, "mW", 1e3], [1, "W", 1], [1e3, "kW", 1e-3]],
  "W/m3": [[0, "W/m3", 1], [1e3, "kW/m3", 1e-3], [1e6, "MW/m3", 1e-6], [1e9, "GW/m3", 1e-9]],
  "N m": [[0, "nN m", 1e9], [1e-6, "µN m", 1e6], [1e-3, "mN m", 1e3], [1, "N m", 1]],
  "1/m": [[0, "1/m", 1], [100, "1/mm", 1e-3]],
};

/** A unit to show, and the factor by which a value is multiplied to be in it. */
export interface ShownUnit {
  unit: string;
  factor: number;
}

function superscript(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((digit) => superscripts[Number(digit)]).join("");
  return (exponent < 0 ? "⁻" : "") + digits;
}

/** Writes a unit in typographic form: "kg/m^3" as kg/m³, "1/s" as s⁻¹, "um" as µm. */
export function write_unit(unit: string | undefined): string {
  if (!unit || unit === "1") return "";
  const inverse = /^1\/([a-zµ]+)(?:\^?(\d))?$/i.exec(unit);
  if (inverse) return inverse[1]! + superscript(-Number(inverse[2] ?? 1));
  return unit
    .replace(/\bu([msN])\b/g, "µ$1")
    .replace(/\^(-?\d+)|(?<=[a-z])(\d)(?![\d.])/gi, (_all, power?: string, bare?: string) => superscript(Number(power ?? bare)))
    .replace(/([a-zµ])[ *]([a-z])/gi, "$1·$2")
    .replace(/^degC$/, "°C")
    .replace(/^deg$/, "°");
}

/** Chooses the unit in which the largest of some magnitudes reads well. */
export function choose_unit(unit: string | undefined, largest: number): ShownUnit {
  const ladder = unit === undefined ? undefined : ladders[unit];
  if (!ladder || !Number.isFinite(largest) || largest <= 0) return { unit: write_unit(unit), factor: 1 };
  // 1.0001 keeps a value a round-off below a step on the upper side of it.
  const [, shown, factor] = ladder.filter(([from]) => largest * 1.0001 >= from).at(-1)!;
  return { unit: write_unit(shown), factor };
}

export function largest_magnitude(values: Iterable<Value | undefined>): number {
  let largest = 0;
  for (const value of values) if (is_number(value)) largest = Math.max(largest, Math.abs(value));
  return largest;
}

/** Writes a number to some significant digits, as a power of ten where that reads better. */
export function write_number(value: Value | undefined, digits = 4): string {
  if (!is_number(value)) return "–";
  if (value === 0) return "0";
  if (Number.isInteger(value) && Math.abs(value) < 1e7) return group(String(value));
  const magnitude = Math.abs(value);
  if (magnitude >= 1e6 || magnitude < 1e-3) {
    return write_power(value, digits);
  }
  return group(String(Number(value.toPrecision(digits))));
}

/** Writes a number as a power of ten. */
export function write_power(value: number, digits = 4): string {
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e") as [string, string];
  const short = String(Number(mantissa)).replace("-", minus);
  return `${short}\u2009×\u200910${superscript(Number(exponent))}`;
}

function group(text: string): string {
  const [whole, fraction] = text.replace("-", minus).split(".") as [string, string | undefined];
  const bare = whole.replace(minus, "");
  const grouped = bare.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u2009") : whole;
  return fraction === undefined ? grouped : `${grouped}.${fraction}`;
}

/** Writes a component of a tensor with as many decimals as its largest component needs for four digits. */
export function write_component(value: Value, largest: number): string {
  if (!is_number(value) || largest >= 1e6 || largest < 1e-3) return write_number(value);
  const decimals = Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(largest))));
  const text = value.toFixed(decimals);
  return group(Number(text) === 0 ? text.replace("-", "") : text);
}

/** Writes a value with the SI prefix that suits it, for text. */
export function write_quantity(value: Value | undefined, unit?: string, digits = 4): string {
  if (!is_number(value)) return "–";
  const shown = choose_unit(unit, Math.abs(value));
  const number = write_number(value * shown.factor, digits);
  if (!shown.unit) return number;
  return shown.unit === "°" || shown.unit === "%" ? `${number}\u2009${shown.unit}` : `${number}\u00a0${shown.unit}`;
}

/** Greek letters that documents write out. */
const greek: Record<string, string> = { sigma: "σ", tau: "τ", eta: "η", xi: "ξ" };

/** Tells whether a label is a component of a tensor, such as a_11. */
export function is_component(label: string): boolean {
  return /^(\p{L}|sigma|tau)_?[1-3]{2}$/u.test(label);
}

/** A piece of a label: upright text, or a subscript ("L_N" is L with subscript N). */
export interface LabelPart {
  text: string;
  subscript: boolean;
}

/** A symbol with an underscore, such as L_N, or a component of an orientation tensor without one, such as A11. */
const symbols = /(?<![\p{L}\d_])(?:(\p{L}|sigma|tau|eta|xi)_([A-Za-z0-9]{1,6})|(A)([1-3]{2}|[1-3]{4}))(?![\p{L}\d_])/giu;

/** Components of tensors have one notation, with a small letter, however the document writes them. */
function write_letter(letter: string, index: string): string {
  return letter === "A" && /^([1-3]{2}){1,2}$/.test(index) ? "a" : (greek[letter] ?? letter);
}

export function split_label(label: string): LabelPart[] {
  const parts: LabelPart[] = [];
  let from = 0;
  for (const match of label.matchAll(symbols)) {
    const letter = (match[1] ?? match[3])!;
    const index = (match[2] ?? match[4])!;
    parts.push({ text: label.slice(from, match.index) + write_letter(letter, index), subscript: false }, { text: index, subscript: true });
    from = match.index + match[0].length;
  }
  if (from < label.length) parts.push({ text: label.slice(from), subscript: false });
  return parts;
}

// Of capitals there are no subscripts; small ones come nearest.
const small_letters: Record<string, string> = { N: "ɴ", W: "ᴡ", I: "ɪ", M: "ᴍ" };
const lowered = "₀₁₂₃₄₅₆₇₈₉";

/** Writes a label as plain text, for menus, hints and canvases, where nothing can be set lower. */
export function write_label(label: string): string {
  const lower = (index: string): string => index.replace(/\d/g, (digit) => lowered[Number(digit)]!).replace(/[NWIM]/g, (letter) => small_letters[letter]!);
  return split_label(label).map(({ text, subscript }) => (subscript ? lower(text) : text)).join("");
}

/** "label (unit)", the way an axis is titled. */
export function write_axis_title(label: string, unit: string): string {
  return unit ? `${label} (${unit})` : label;
}
