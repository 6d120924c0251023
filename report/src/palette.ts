// Colours of figures in light and dark surroundings, and the colour maps of quantities.

export interface Palette {
  ink: string;
  muted: string;
  grid: string;
  surface: string;
  series: string[];
}

/** Series colours stay apart also for readers without one kind of cones (tests/report/checks/colours.mjs). */
export const light_palette: Palette = {
  ink: "#1b1f24",
  muted: "#59616b",
  grid: "#e6e8eb",
  surface: "#ffffff",
  series: ["#0055a5", "#c64300", "#00b377", "#ad5c94", "#e28500", "#4185eb", "#4c4878", "#7a244e"],
};

export const dark_palette: Palette = {
  ink: "#e8eaed",
  muted: "#9aa3ad",
  grid: "#2d3238",
  surface: "#16191d",
  series: ["#5b86e3", "#db7824", "#39e997", "#e085b8", "#e2cc33", "#a3dbff", "#bdc0af", "#ee528b"],
};

const dark_scheme = window.matchMedia("(prefers-color-scheme: dark)");

export function current_palette(): Palette {
  return dark_scheme.matches ? dark_palette : light_palette;
}

/** Calls back whenever the reader's colour scheme changes. */
export function watch_scheme(action: () => void): void {
  dark_scheme.addEventListener("change", action);
}

type Rgb = [number, number, number];

// Viridis as published, for fields. The two maps for fibers have their lightness monotone too, but keep away from
// white and black: a fiber of any colour must show on a light and on a dark page.
const maps = {
  viridis: ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"],
  tide: ["#f0b440", "#a9bf4e", "#4fae7b", "#2a8f9e", "#3277b5", "#4a57b4"],
  // Blue below the middle, red above it; the middle is pale in both schemes, and what is written on it dark.
  diverging: ["#2166ac", "#6ba3cf", "#c9dfee", "#f4f4f2", "#fbd5c0", "#e58368", "#b2182b"],
  ember: ["#b3c0ce", "#cdbb9c", "#e3a85c", "#dd7a36", "#c94a2b", "#a3222a", "#7a1230"],
};
export type ColourMap = keyof typeof maps;

function parse(hex: string): Rgb {
  const bits = Number.parseInt(hex.slice(1), 16);
  return [bits >> 16, (bits >> 8) & 255, bits & 255];
}

/** Gives the colour of a fraction in [0, 1] as 8-bit red, green, blue. */
export function sample_map(name: ColourMap, fraction: number): Rgb {
  const stops = maps[name];
  const at = Math.min(1, Math.max(0, fraction)) * (stops.length - 1);
  const below = Math.min(stops.length - 2, Math.floor(at));
  const a = parse(stops[below]!);
  const b = parse(stops[below + 1]!);
  return a.map((value, k) => Math.round(value + (b[k]! - value) * (at - below))) as Rgb;
}

export function css_colour(rgb: Rgb): string {
  return `rgb(${rgb.join(",")})`;
}

/** Gives the n-th of any number of distinguishable colours: hues apart by the golden angle, three lightnesses. */
export function category_colour(index: number): Rgb {
  const hue = (index * 137.50776 + 210) % 360;
  const lightness = [0.52, 0.64, 0.43][index % 3]!;
  const chroma = 0.55 * (1 - Math.abs(2 * lightness - 1));
  const channel = (shift: number): number => {
    const k = (shift + hue / 30) % 12;
    return Math.round(255 * (lightness - (chroma / 2) * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}
