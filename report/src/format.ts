// How numbers, units and symbols are written for a reader.
import { is_number, type Value } from "./document";

const prefixes: Record<number, string> = {
  "-15": "f", "-12": "p", "-9": "n", "-6": "µ", "-3": "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T",
};
const minus = "\u2212";
const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** SI units that take a prefix; only these are rescaled, every other unit is shown as it came. */
const scalable = new Set(["m", "s", "Pa", "Pa s", "N", "J", "W", "N m", "Hz"]);

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
    .replace(/\^(-?\d+)/g, (_all, power: string) => superscript(Number(power)))
    .replace(/([a-zµ])[ *]([a-z])/gi, "$1·$2")
    .replace(/^degC$/, "°C")
    .replace(/^deg$/, "°");
}

/** Chooses the SI prefix in which the largest of some magnitudes reads between 1 and 1000. */
export function choose_unit(unit: string | undefined, largest: number): ShownUnit {
  const plain = { unit: write_unit(unit), factor: 1 };
  if (!unit || !Number.isFinite(largest) || largest <= 0) return plain;
  const bare = unit === "1/m" ? "m" : unit;
  if (!scalable.has(bare)) return plain;
  // 0.9999 keeps a value a round-off below a power of 1000 in the larger unit.
  const exponent = 3 * Math.floor(Math.log10(largest / 0.9999) / 3);
  const power = unit === "1/m" ? Math.min(3, Math.max(0, exponent)) : exponent;
  const prefix = prefixes[unit === "1/m" ? -power : power];
  if (prefix === undefined) return plain;
  const factor = 10 ** -power;
  if (unit === "1/m") return { unit: `${prefix}m⁻¹`, factor };
  return { unit: write_unit(prefix + unit), factor };
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
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e") as [string, string];
    const short = String(Number(mantissa)).replace("-", minus);
    return `${short}\u2009×\u200910${superscript(Number(exponent))}`;
  }
  return group(String(Number(value.toPrecision(digits))));
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
  return group(value.toFixed(decimals));
}

/** Writes a value with the SI prefix that suits it, for text. */
export function write_quantity(value: Value | undefined, unit?: string, digits = 4): string {
  if (!is_number(value)) return "–";
  const shown = choose_unit(unit, Math.abs(value));
  const number = write_number(value * shown.factor, digits);
  if (!shown.unit) return number;
  return shown.unit === "°" || shown.unit === "%" ? `${number}\u2009${shown.unit}` : `${number}\u00a0${shown.unit}`;
}

/** A piece of a label: upright text, or a subscript ("L_N" is L with subscript N). */
export interface LabelPart {
  text: string;
  subscript: boolean;
}

export function split_label(label: string): LabelPart[] {
  const parts: LabelPart[] = [];
  let from = 0;
  for (const match of label.matchAll(/(?<![A-Za-z0-9_])(\p{L})_([A-Za-z0-9]{1,6})(?![A-Za-z0-9_])/gu)) {
    const at = match.index + match[1]!.length;
    parts.push({ text: label.slice(from, at), subscript: false }, { text: match[2]!, subscript: true });
    from = at + 1 + match[2]!.length;
  }
  if (from < label.length) parts.push({ text: label.slice(from), subscript: false });
  return parts;
}

/** "label (unit)", the way an axis is titled. */
export function write_axis_title(label: string, unit: string): string {
  return unit ? `${label} (${unit})` : label;
}
