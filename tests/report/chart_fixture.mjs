// Sections that charts of other studies need: laws over bars, bars of points, named places, correlations, filled outlines.

const places = ["gate", "runner", "middle of the plate", "corner", "last to fill"];
const parameters = ["lambda", "C_I", "k_0"];

function make_laws() {
  const edges = Array.from({ length: 21 }, (_unused, k) => k * 2.5e-4);
  const middles = edges.slice(1).map((edge, k) => (edge + edges[k]) / 2);
  const share = (x, scale) => (2.5e-2 / scale) * x * 1e3 * Math.exp(-((x / scale) ** 2)) * 1e-1;
  const fine = Array.from({ length: 101 }, (_unused, k) => k * 5e-5);
  return {
    kind: "histogram", id: "laws", title: "Fibers by length", caption: "Curves: laws fitted to the list.",
    x: { label: "length", unit: "m" }, y: { label: "share of the fibers", unit: "%" }, edges,
    frames: [{ label: "corrected", values: middles.map((x, k) => share(x, 1.5e-3) * (1 + 0.15 * Math.sin(5 * k))) }],
    reference: { label: "as measured", values: middles.map((x) => share(x, 1.7e-3)) },
    curves: [
      { label: "Weibull", x: fine, values: fine.map((x) => (x < 1.25e-4 ? null : share(x, 1.5e-3))) },
      { label: "log-normal", x: fine, values: fine.map((x) => share(x, 1.4e-3)), style: "dashed" },
    ],
  };
}

function make_places() {
  const at = places.map((_name, k) => k + 1);
  return {
    kind: "lines", id: "places", title: "Measured and fitted lengths", x: { label: "place", names: places }, y: { label: "length", unit: "m" },
    series: [
      { label: "L_N, fitted", x: at, values: at.map((k) => 2e-3 / k), low: at.map((k) => 1.8e-3 / k), high: at.map((k) => 2.2e-3 / k), colour: 0 },
      {
        label: "L_N, measured", style: "points", colour: 0, x: [1, 1, 2, 3, 4, 5], values: [2.1e-3, 1.9e-3, 1.1e-3, 6e-4, 5.2e-4, 4.1e-4],
        low: [2e-3, 1.8e-3, 1e-3, 5.6e-4, 5e-4, null], high: [2.2e-3, 2e-3, 1.2e-3, 6.4e-4, 5.4e-4, null],
      },
    ],
  };
}

function make_parity() {
  const measured = [1e-3, 2e-3, 4e-3, 8e-3];
  return {
    kind: "lines", id: "parity", title: "Predicted against measured", equal: true, legend: "names",
    x: { label: "measured length", unit: "m" }, y: { label: "predicted length", unit: "m" },
    series: [
      { label: "50 rpm", style: "points", x: measured, values: measured.map((x, k) => x * (1 + 0.06 * (k - 1.5))) },
      { label: "equal", style: "dashed", x: [0, 9e-3], values: [0, 9e-3] },
    ],
  };
}

function make_correlation() {
  const values = [[-0.97, -0.2, 1], [0.31, 1, -0.2], [1, 0.31, -0.97]];
  return {
    kind: "heatmap", id: "correlation", title: "Correlation of the parameters", label: "correlation", values,
    x: { label: "", names: parameters }, y: { label: "", names: [...parameters].reverse() }, range: [-1, 1], colours: "diverging", written: true,
  };
}

function make_slice(random) {
  const x = [];
  const values = [];
  for (let k = 0; k < 80; ++k) {
    const [cx, cy, turn] = [1.5e-3 * random(), 1.5e-3 * random(), Math.PI * random()];
    for (let step = 0; step <= 12; ++step) {
      const angle = (2 * Math.PI * step) / 12;
      const [u, v] = [6e-5 * Math.cos(angle), 1.5e-5 * Math.sin(angle)];
      x.push(cx + u * Math.cos(turn) - v * Math.sin(turn));
      values.push(cy + u * Math.sin(turn) + v * Math.cos(turn));
    }
    x.push(x.at(-1));
    values.push(null);
  }
  return {
    kind: "lines", id: "slice", title: "A cut through the middle", equal: true, legend: "names", x: { label: "x", unit: "m" }, y: { label: "y", unit: "m" },
    series: [
      { label: "fibers", style: "filled", x, values },
      { label: "cell", style: "dashed", x: [0, 1.5e-3, 1.5e-3, 0, 0], values: [0, 0, 1.5e-3, 1.5e-3, 0] },
    ],
  };
}

function make_comparison() {
  return {
    kind: "comparison", id: "runs", title: "Results side by side", runs: ["slow", "fast_1, fast_2", "weak matrix"],
    rows: [
      { label: "L_N", unit: "m", headline: true, values: [1.234e-3, 8.31e-4, 6.2e-4], low: [null, 8.1e-4, null], high: [null, 8.52e-4, null] },
      { label: "Breaks", values: [120, 371.5, 612], low: [null, 362, null], high: [null, 381, null] },
      { label: "Friction", values: ["coulomb", "coulomb", "none"] }, { label: "Largest overlap", unit: "radii", values: [0.012, null, 0.02] },
    ],
  };
}

/** Makes the sections; `random` gives numbers from 0 to 1. */
export function make_charts(random) {
  return [make_laws(), make_places(), make_parity(), make_correlation(), make_slice(random), make_comparison()];
}
