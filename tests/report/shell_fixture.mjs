// Makes a synthetic section "shell": a bent plate with an opening that fills from two gates.

function encode(array) {
  return Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64");
}

const [columns, rows] = [48, 24];
const size = 0.2;
const bend = 0.25;
const gates = [[0.02, 0.05], [0.18, 0.05]];
const speed = 0.1;

function is_open(column, row) {
  return column >= 20 && column < 30 && row >= 10 && row < 18;
}

/** A plate of 200 × 100 mm rolled onto a cylinder. */
function place_of(u, v) {
  return [bend * Math.sin((u - size / 2) / bend), v, bend * (Math.cos((u - size / 2) / bend) - 1)];
}

export function make_shell() {
  const [points, fill_time, pressure, triangles] = [[], [], [], []];
  const times = [0.25, 0.5, 0.75, 1];
  const flat = [];
  for (let row = 0; row <= rows; ++row) {
    for (let column = 0; column <= columns; ++column) {
      const [u, v] = [(size * column) / columns, (size * row) / (2 * rows)];
      flat.push([u, v]);
      points.push(...place_of(u, v));
      fill_time.push(u > 0.195 && v > 0.09 ? NaN : Math.min(...gates.map(([x, y]) => Math.hypot(u - x, v - y))) / speed);
    }
  }
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      if (is_open(column, row)) continue;
      const a = row * (columns + 1) + column;
      triangles.push(a, a + 1, a + columns + 2, a, a + columns + 2, a + columns + 1);
    }
  }
  for (const time of times) {
    pressure.push(Float32Array.from(fill_time, (filled) => (filled <= time ? 3e7 * (time - filled) : 0)));
  }
  const weld = Float32Array.from([...place_of(0.1, 0), ...place_of(0.1, 0.04)]);
  return {
    kind: "shell", id: "part", title: "The part", caption: "A synthetic filling of a bent plate from two gates.",
    points: encode(Float32Array.from(points)), triangles: encode(Int32Array.from(triangles)), fill_time: encode(Float32Array.from(fill_time)),
    times,
    fields: [
      { label: "fill time", unit: "s", frames: [encode(Float32Array.from(fill_time))] },
      { label: "pressure", unit: "Pa", frames: pressure.map(encode) },
      { label: "length L_N", unit: "m", frames: [encode(Float32Array.from(flat, ([u, v]) => 1e-3 * (1 + u + v)))] },
    ],
    places: gates.map(([u, v], k) => ({ label: `G${k + 1}`, kind: "gate", at: place_of(u, v) })),
    lines: [{ label: "weld lines", segments: encode(weld) }],
  };
}
