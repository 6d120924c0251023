// Makes a synthetic report document: a shear_cell run of 138 fibers that turn, bend and break, and a part that fills.
import { make_charts } from "./chart_fixture.mjs";
import { make_shell } from "./shell_fixture.mjs";

/** A small deterministic generator (mulberry32): the fixture is the same on every machine. */
function make_random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const rate = 16.65;
const end_time = 1.5;
const side = 1.5e-3;
const fiber_length = 2.5e-3;
const radius = 9.5e-6;

function encode(array) {
  return Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64");
}

function make_fibers(random, count, rods) {
  return Array.from({ length: count }, () => {
    const azimuth = 2 * Math.PI * random();
    const height = 0.5 * (2 * random() - 1);
    const flat = Math.sqrt(1 - height * height);
    return {
      direction: [flat * Math.cos(azimuth), height, flat * Math.sin(azimuth)],
      middle: [side * random(), side * random(), side * random()],
      bend: 2.4 * random() * random(),
      phase: 2 * Math.PI * random(),
      // A hinge breaks at an exponential time; middle hinges sooner, as bent fibers do.
      break_time: Array.from({ length: rods - 1 }, (_unused, k) => {
        const place = Math.sin((Math.PI * (k + 1)) / rods);
        return (-Math.log(1 - random()) * 9) / (0.2 + place);
      }),
    };
  });
}

/** Nodes of a fiber at a time: a slender rod turned by the shear, and an arc on it. */
function shape_fiber(fiber, rods, time) {
  const [px, py, pz] = fiber.direction;
  const turned = [px + rate * time * py * 0.25, py, pz];
  const norm = Math.hypot(...turned);
  const p = turned.map((value) => value / norm);
  const aside = [p[1], -p[0], 0];
  const width = Math.hypot(...aside) || 1;
  const across = [aside[0] / width, aside[1] / width, 0];
  const step = fiber_length / rods;
  const nodes = [[0, 0, 0]];
  const bend = fiber.bend * Math.min(1, 0.15 + 2 * time);
  for (let rod = 0; rod < rods; ++rod) {
    const angle = bend * Math.sin((Math.PI * (rod + 0.5)) / rods + 0.6 * Math.sin(fiber.phase + 3 * time));
    const last = nodes.at(-1);
    nodes.push([0, 1, 2].map((k) => last[k] + step * (Math.cos(angle) * p[k] + Math.sin(angle) * across[k])));
  }
  // The melt carries the middle of a fiber along, however it is bent.
  const wanted = [fiber.middle[0] + rate * time * fiber.middle[1], fiber.middle[1], fiber.middle[2]];
  const found = [0, 1, 2].map((k) => nodes.reduce((sum, node) => sum + node[k], 0) / nodes.length);
  return nodes.map((node) => node.map((value, k) => value + wanted[k] - found[k]));
}

function pieces_at(fiber, rods, time) {
  const pieces = [];
  let from = 0;
  for (let hinge = 0; hinge < rods - 1; ++hinge) {
    if (fiber.break_time[hinge] > time) continue;
    pieces.push([from, hinge + 1]);
    from = hinge + 1;
  }
  return [...pieces, [from, rods]];
}

function make_frame(fibers, rods, time) {
  const offsets = [0];
  const points = [];
  const birth = [];
  const birth_node = [];
  fibers.forEach((fiber, id) => {
    const nodes = shape_fiber(fiber, rods, time);
    for (const [from, to] of pieces_at(fiber, rods, time)) {
      for (let node = from; node <= to; ++node) points.push(...nodes[node]);
      offsets.push(points.length / 3);
      birth.push(id);
      birth_node.push(from);
    }
  });
  const tilt = ((rate * time + 0.5) % 1) - 0.5;
  return {
    time_s: time,
    lattice: [side, tilt * side, 0, 0, side, 0, 0, 0, side],
    offsets: encode(Int32Array.from(offsets)),
    points: encode(Float32Array.from(points)),
    birth: encode(Int32Array.from(birth)),
    birth_node: encode(Int32Array.from(birth_node)),
    radius: encode(new Float32Array(birth.length).fill(radius)),
  };
}

function lengths_at(fibers, rods, time) {
  return fibers.flatMap((fiber) => pieces_at(fiber, rods, time).map(([from, to]) => ((to - from) * fiber_length) / rods));
}

function averages(lengths) {
  const sum = lengths.reduce((a, b) => a + b, 0);
  return { number: sum / lengths.length, weight: lengths.reduce((a, b) => a + b * b, 0) / sum };
}

function orientation_at(fibers, rods, time) {
  const a = [0, 0, 0];
  for (const fiber of fibers) {
    const nodes = shape_fiber(fiber, rods, time);
    for (let rod = 0; rod < rods; ++rod) {
      const d = [0, 1, 2].map((k) => nodes[rod + 1][k] - nodes[rod][k]);
      const square = d[0] ** 2 + d[1] ** 2 + d[2] ** 2;
      for (let k = 0; k < 3; ++k) a[k] += d[k] ** 2 / square / rods / fibers.length;
    }
  }
  return a;
}

function make_length_section(fibers, rods, times) {
  const found = times.map((time) => averages(lengths_at(fibers, rods, time)));
  return {
    kind: "lines", id: "length", title: "Fiber length",
    caption: "Number average L_N and weight average L_W. The band is the 95 % confidence of L_N over the fibers.",
    x: { label: "time", unit: "s", scale: "linear", values: times },
    y: { label: "length", unit: "m", scale: "linear" },
    series: [
      {
        label: "L_N", values: found.map((average) => average.number),
        low: found.map((average) => average.number * 0.96), high: found.map((average) => average.number * 1.04),
      },
      { label: "L_W", values: found.map((average) => average.weight) },
      {
        label: "measured L_N", style: "points", x: [0, 0.3, 0.6, 0.9, 1.2, 1.5],
        values: [2.5e-3, 1.93e-3, 1.55e-3, 1.33e-3, null, 1.04e-3],
      },
    ],
  };
}

function make_histogram(fibers, rods, times) {
  const bins = 25;
  const edges = Array.from({ length: bins + 1 }, (_unused, k) => (k * 1.0001 * fiber_length) / bins);
  const count = (time) => {
    const values = new Array(bins).fill(0);
    for (const length of lengths_at(fibers, rods, time)) {
      values[Math.min(bins - 1, Math.max(0, Math.ceil(length / edges[1] - 1e-6) - 1))] += 1;
    }
    return values;
  };
  const long_time = Array.from({ length: bins }, (_unused, k) => 190 * Math.exp(-k / 3.4));
  return {
    kind: "histogram", id: "length_histogram", title: "Length distribution",
    caption: "Fibers by length at chosen times.",
    x: { label: "fiber length", unit: "m" }, y: { label: "fibers" }, edges,
    frames: times.map((time) => ({ label: `t = ${time.toFixed(2)} s`, values: count(time) })),
    reference: { label: "Flory distribution", values: long_time },
  };
}

/** Makes the document; more fibers test the speed, fewer keep the file small. */
export function make_document({ fibers: count = 138, rods = 25, frames: frame_count = 11, seed = 7 } = {}) {
  const random = make_random(seed);
  const fibers = make_fibers(random, count, rods);
  const times = Array.from({ length: 151 }, (_unused, k) => (k * end_time) / 150);
  const frame_times = Array.from({ length: frame_count }, (_unused, k) => (k * end_time) / Math.max(1, frame_count - 1));
  const a = times.map((time) => orientation_at(fibers, rods, time));
  const last = averages(lengths_at(fibers, rods, end_time));
  const breaks = times.map((time) => lengths_at(fibers, rods, time).length - count);
  return {
    schema: 1, title: "Fiber attrition in simple shear", study: "shear_cell", version: "0.1.0", stop_reason: "end time reached",
    subtitle: `${count} glass fibers of 2.5 mm in a periodic cell of molten polypropylene, sheared at 16.65 1/s for 1.5 s`,
    sections: [
      {
        kind: "facts", id: "asked", title: "Inputs",
        rows: [
          { label: "fibers", value: count }, { label: "rods per fiber", value: rods },
          { label: "fiber diameter", value: 1.9e-5, unit: "m" }, { label: "fiber length", value: fiber_length, unit: "m" },
          { label: "Young's modulus", value: 7.3e10, unit: "Pa" }, { label: "viscosity", value: 200, unit: "Pa s" },
          { label: "shear rate", value: rate, unit: "1/s" }, { label: "breakage law", value: "probability", note: "checked every 10 ms of physical time" },
          { label: "duration", value: end_time, unit: "s" }, { label: "cell", value: "1.5 × 1.5 × 1.5", unit: "mm", note: "periodic, deforms with the flow" },
        ],
      },
      {
        kind: "facts", id: "found", title: "Results",
        rows: [
          { label: "L_N", value: last.number, unit: "m", note: "number average" },
          { label: "L_W", value: last.weight, unit: "m", note: "weight average" },
          { label: "breaks", value: breaks.at(-1) }, { label: "fibers at the end", value: count + breaks.at(-1) },
          { label: "A_2", value: [[a.at(-1)[0], 0.061, -0.004], [0.061, a.at(-1)[1], 0.002], [-0.004, 0.002, a.at(-1)[2]]], note: "orientation tensor, number-weighted" },
          { label: "largest overlap", value: 0.0132, note: "in fiber radii" },
          { label: "speed", value: 3714503, unit: "1/s", note: "rod-steps per second" }, { label: "rest", value: null, note: "not measured" },
        ],
      },
      make_length_section(fibers, rods, times),
      {
        kind: "lines", id: "orientation", title: "Orientation", caption: "Diagonal of the second-order orientation tensor.",
        x: { label: "time", unit: "s", values: times }, y: { label: "A_2 components" },
        series: ["a11", "a22", "a33"].map((label, k) => ({ label, values: a.map((row) => row[k]), style: k === 1 ? "dashed" : "line" })),
      },
      {
        kind: "lines", id: "breaks", title: "Breaks and contacts", x: { label: "time", unit: "s", values: times }, y: { label: "count" },
        series: [{ label: "breaks", values: breaks }, { label: "contacts", values: times.map((time) => Math.round(900 * Math.exp(-time) + 60 * Math.sin(40 * time))) }],
      },
      {
        // What is conserved differs by round-off from row to row and must show as a constant.
        kind: "lines", id: "total_length", title: "Total fiber length", x: { label: "time", unit: "s", values: times }, y: { label: "length", unit: "m" },
        series: [{ label: "total", values: times.map((_unused, k) => count * fiber_length * (1 + ((k % 3) - 1) * 2.3e-16)) }],
      },
      {
        kind: "lines", id: "step", title: "Step size", x: { label: "time", unit: "s", values: times }, y: { label: "step size", unit: "s", scale: "log" },
        series: [{ label: "step size", values: times.map((time, k) => (k % 37 === 36 ? null : 1e-4 * 10 ** (-1.6 * Math.abs(Math.sin(9 * time)) ** 8))) }],
      },
      make_histogram(fibers, rods, [0, 0.25, 0.5, 1, 1.5]),
      {
        kind: "scatter", id: "radius_at_break", title: "Radius of curvature at breaks", caption: "One point a break; the critical radius is 0.35 mm.",
        x: { label: "time", unit: "s" }, y: { label: "radius of curvature", unit: "m", scale: "log" },
        series: [{ label: "breaks", x: Array.from({ length: 160 }, () => end_time * random()), values: Array.from({ length: 160 }, () => 3.5e-4 * (0.4 + random()) ** 0.5) }],
      },
      { kind: "fibers", id: "cell", title: "The cell", caption: "Point at a fiber for its numbers; click to follow its pieces through time.", frames: frame_times.map((time) => make_frame(fibers, rods, time)) },
      make_shell(),
      {
        kind: "heatmap", id: "contacts_map", title: "Contacts by place along the fiber", label: "contacts", unit: "",
        x: { label: "arc length", unit: "m", values: Array.from({ length: 25 }, (_unused, k) => (k + 0.5) * 1e-4) },
        y: { label: "time", unit: "s", values: Array.from({ length: 16 }, (_unused, k) => k / 10) },
        values: Array.from({ length: 16 }, (_unused, j) => Array.from({ length: 25 }, (_other, i) => (i === 3 && j === 4 ? null : 12 * Math.exp(-j / 8) * (1 + 0.5 * Math.cos(i / 4))))),
      },
      {
        kind: "table", id: "timings", title: "Where the time went", columns: [{ label: "phase" }, { label: "time", unit: "s" }, { label: "share", unit: "%" }],
        rows: [["neighbours", 1.21, 14.2], ["loads", 3.02, 35.4], ["solve", 3.4, 39.9], ["update", 0.5, 5.9], ["breakage", 0.11, 1.3], ["output", 0.28, null]],
      },
      ...make_charts(random),
      { kind: "hologram", id: "later", title: "A kind of a later version" },
    ],
  };
}
