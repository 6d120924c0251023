// How far apart colours are for readers with full colour vision and without one kind of cones.

// Machado, Oliveira & Fernandes (2009), IEEE TVCG 15, table of matrices at severity 1, for linear RGB.
const deficiencies = {
  none: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
export const kinds_of_vision = Object.keys(deficiencies);

const times = (matrix, x) => matrix.map((row) => row.reduce((sum, value, k) => sum + value * x[k], 0));

/** Reads "#rrggbb" or "rgb(r,g,b)" as linear RGB in [0, 1]. */
function linear_rgb(colour) {
  const bytes = colour.startsWith("#")
    ? [1, 3, 5].map((k) => Number.parseInt(colour.slice(k, k + 2), 16)) : colour.match(/\d+/g).slice(0, 3).map(Number);
  return bytes.map((byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4));
}

/** CIE L*a*b* under D65 of a colour as a kind of vision sees it. */
export function seen_lab(colour, vision = "none") {
  const rgb = times(deficiencies[vision], linear_rgb(colour)).map((value) => Math.min(1, Math.max(0, value)));
  const xyz = times([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.072175], [0.0193339, 0.119192, 0.9503041]], rgb);
  const f = xyz.map((value, k) => {
    const t = value / [0.95047, 1, 1.08883][k];
    return t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116;
  });
  return [116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])];
}

/** The CIE 1976 difference of two colours; a difference of some 2 is just seen side by side. */
export function difference(a, b, vision) {
  const [one, other] = [seen_lab(a, vision), seen_lab(b, vision)];
  return Math.hypot(...one.map((value, k) => value - other[k]));
}

/** The contrast ratio of two colours (WCAG 2). */
export function contrast(a, b) {
  const luminance = (colour) => linear_rgb(colour).reduce((sum, value, k) => sum + value * [0.2126, 0.7152, 0.0722][k], 0);
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}
