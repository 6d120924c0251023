// Where an axis has its ticks.
import type { Scale } from "../document";
import { write_number, write_power } from "../format";

/** Gives round values (1, 2, 5 times a power of ten) inside a range, about `count` of them. */
export function linear_ticks(min: number, max: number, count: number): number[] {
  if (!(max > min)) return [min];
  const rough = (max - min) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((candidate) => candidate >= rough * 0.75)!;
  const ticks: number[] = [];
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max + 1e-9 * step; ++k) {
    ticks.push(Number((k * step).toPrecision(12)));
  }
  return ticks;
}

/** Gives the powers of ten inside a range, and their 2 and 5 fold where the range is short and they find room. */
export function log_ticks(min: number, max: number, count: number): number[] {
  const decades = Math.log10(max / min);
  if (decades < 1) return round_ticks(min, max, [1, 2, 3, 5, 7], count);
  const ticks = round_ticks(min, max, decades < 2.5 ? [1, 2, 5] : [1], count);
  return ticks.length > 2 * count ? round_ticks(min, max, [1], count) : ticks;
}

/** Gives these multiples of powers of ten inside a range, or even ticks where there are too few. */
function round_ticks(min: number, max: number, factors: number[], count: number): number[] {
  const decades = Math.log10(max / min);
  const stride = Math.max(1, Math.ceil(decades / 8));
  const ticks: number[] = [];
  for (let power = Math.floor(Math.log10(min)); power <= Math.ceil(Math.log10(max)); ++power) {
    if (power % stride !== 0) continue;
    for (const factor of factors) {
      const tick = Number((factor * 10 ** power).toPrecision(6));
      if (tick >= min * 0.9999 && tick <= max * 1.0001) ticks.push(tick);
    }
  }
  return ticks.length >= 2 ? ticks : linear_ticks(min, max, Math.min(4, count)).filter((tick) => tick > 0);
}

export function make_ticks(min: number, max: number, scale: Scale, count: number): number[] {
  return scale === "log" ? log_ticks(min, max, count) : linear_ticks(min, max, count);
}

const near_zero = 0.05; // of the far end of a range

/** Lets a range of colours begin or end at zero where it nearly does. */
export function bar_range(min: number, max: number): [number, number] {
  return [min > 0 && min < near_zero * max ? 0 : min, max < 0 && max > near_zero * min ? 0 : max];
}

/** Gives the ticks of a colour bar. */
export function bar_ticks(min: number, max: number): number[] {
  return linear_ticks(min, max, 5);
}

const [long_number, short_number] = [1e7, 1e-3];

/** Writes ticks in full: they are round, so that they have no more digits than they need. Where one is a power of ten, all are. */
export function write_ticks(ticks: number[]): string[] {
  const sizes = ticks.map(Math.abs).filter((size) => size > 0);
  const largest = Math.max(...sizes);
  const powers = largest >= long_number || (largest < 1 && Math.min(...sizes) < short_number);
  return ticks.map((tick) => (powers && tick ? write_power(tick, 9) : write_number(tick, 9)));
}

const round_off = 1e-9;

/** Widens a range to where it reads well: room at both ends, and from zero where zero is near. */
export function pad_range(min: number, max: number, scale: Scale): [number, number] {
  if (!Number.isFinite(min) || !Number.isFinite(max)) return scale === "log" ? [1, 10] : [0, 1];
  if (scale === "log") {
    const ratio = max / min;
    // A short range needs less room than a decade, and a constant some.
    const room = ratio > 1.0001 ? Math.max(ratio ** 0.05, Math.min(1.1, ratio ** 0.1)) : 1.1;
    return [min / room, max * room];
  }
  // A constant that differs by round-off only is drawn as a constant.
  if (max - min <= round_off * Math.max(Math.abs(min), Math.abs(max)))
    return min === 0 ? [0, 1] : [min - Math.abs(min) * 0.5, max + Math.abs(max) * 0.5];
  const room = 0.06 * (max - min);
  const low = min >= 0 && min < 0.35 * max ? 0 : min - room;
  const high = max <= 0 && max > 0.35 * min ? 0 : max + room;
  return [low, high];
}
