// Counts what held and what did not, and compares shown text with numbers.

const prefixes = { f: 1e-15, p: 1e-12, n: 1e-9, µ: 1e-6, m: 1e-3, k: 1e3, M: 1e6, G: 1e9, T: 1e12 };
const raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** Collects the outcome of checks. */
export class Expect {
  passed = 0;
  failures = [];

  that(holds, what) {
    if (holds) ++this.passed;
    else this.failures.push(what);
  }

  equal(found, wanted, what) {
    this.that(Object.is(found, wanted), `${what}: found ${JSON.stringify(found)}, wanted ${JSON.stringify(wanted)}`);
  }

  /** Shown numbers have four digits: half a unit of the last is 5e-4 of a number that begins with 1. */
  near(found, wanted, what, tolerance = 6e-4) {
    const close = Math.abs(found - wanted) <= tolerance * Math.max(Math.abs(wanted), 1e-300);
    this.that(close, `${what}: shown ${found}, the document says ${wanted}`);
  }
}

/** Reads a shown number back: "−1.5 × 10⁻⁶" and "3 714 503" included; NaN for what is not a number. */
export function read_number(text) {
  const plain = text.replaceAll("\u2212", "-").replaceAll("\u2009", "").trim();
  const power = /^(-?[\d.]+)×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/.exec(plain);
  if (!power) return plain === "" ? NaN : Number(plain);
  const exponent = [...power[2]].map((letter) => (letter === "⁻" ? "-" : raised.indexOf(letter))).join("");
  return Number(power[1]) * 10 ** Number(exponent);
}

/** Gives by what a shown unit is larger than the document's: 1e-3 for "mm" where the document has "m". */
export function unit_factor(shown, unit = "") {
  const bare = shown.replaceAll("·", " ").trim();
  if (unit === "1/m") return bare === "m⁻¹" ? 1 : 1 / prefixes[bare[0]];
  if (bare === unit || bare.length !== unit.length + 1 || !bare.endsWith(unit)) return 1;
  return prefixes[bare[0]] ?? 1;
}

/** Reads a shown quantity back in the document's unit. */
export function read_quantity(text, unit) {
  const [number, ...rest] = text.replace(/\u2009([%°])$/u, "\u00a0$1").split("\u00a0");
  return read_number(number) * unit_factor(rest.join("\u00a0"), unit);
}

export const is_number = (value) => typeof value === "number" && Number.isFinite(value);

/** The text of a label without its marks for subscripts; components of tensors have a small letter. */
export const plain_label = (label) => label
  .replace(/(?<![\p{L}\d_])(\p{L})_([A-Za-z0-9]{1,6})(?![\p{L}\d_])/gu, "$1$2")
  .replace(/(?<![\p{L}\d_])A(([1-3]{2}){1,2})(?![\p{L}\d_])/gu, "a$1");
