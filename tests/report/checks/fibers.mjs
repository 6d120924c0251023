// Checks of the cell in 3D: what is drawn at the first and last time, colours, pointing, playing.
import { read_number, read_quantity, unit_factor } from "./expect.mjs";
import { check_cancelled_film, check_saved_frames } from "./saved.mjs";
import { decode, move_slider, read_pixels } from "./stage.mjs";

function read_frame(frame) {
  return {
    time_s: frame.time_s, offsets: decode(frame.offsets, Int32Array), points: decode(frame.points, Float32Array),
    birth: decode(frame.birth, Int32Array),
  };
}

const node_of = (frame, node) => [...frame.points.subarray(3 * node, 3 * node + 3)];
const minus = (a, b) => a.map((value, k) => value - b[k]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(...a);

function length_of(frame, fiber) {
  let sum = 0;
  for (let node = frame.offsets[fiber]; node < frame.offsets[fiber + 1] - 1; ++node) {
    sum += norm(minus(node_of(frame, node + 1), node_of(frame, node)));
  }
  return sum;
}

/** Radius of the circle through three nodes: product of the sides over four times the area. */
function smallest_radius(frame, fiber) {
  let smallest = Infinity;
  for (let node = frame.offsets[fiber] + 1; node < frame.offsets[fiber + 1] - 1; ++node) {
    const [a, b, c] = [node - 1, node, node + 1].map((k) => node_of(frame, k));
    const area = norm(cross(minus(b, a), minus(c, a))) / 2;
    smallest = Math.min(smallest, (norm(minus(b, a)) * norm(minus(c, b)) * norm(minus(c, a))) / (4 * area));
  }
  return smallest;
}

async function check_frame(stage, frame, what, expect) {
  const pixels = await read_pixels(stage);
  const fibers = frame.offsets.length - 1;
  const rods = frame.offsets.at(-1) - fibers;
  const data = await stage.evaluate((element) => ({ ...element.dataset }));
  expect.equal(Number(data.time), frame.time_s, `${what}: time`);
  expect.equal(Number(data.fibers), fibers, `${what}: fibers`);
  const drawn = Number(data.drawnRods);
  // A window shows a rod twice that sticks out of it; other ways of drawing show every rod once.
  const right = data.images === "window" ? drawn >= rods && drawn < 9 * rods : drawn === rods;
  expect.that(right, `${what}: ${drawn} rods drawn of ${rods}`);
  // The renderer's own count of triangles: every rod has the same number.
  expect.that(Number(data.triangles) > 0 && Number(data.triangles) % drawn === 0, `${what}: ${data.triangles} triangles for ${drawn} rods`);
  expect.that(pixels.count > 200 && pixels.colours > 20, `${what}: ${pixels.count} pixels of fibers in ${pixels.colours} colours`);
  return { per_rod: Number(data.triangles) / drawn, pixels };
}

/** Changes the colouring and back: pixels must change with it and return with it. */
async function check_colourings(section, stage, expect, id) {
  const select = section.locator("select[name=colour]");
  await select.selectOption("length");
  const first = await read_pixels(stage);
  for (const colouring of ["curvature", "birth", "angle_x"]) {
    await select.selectOption(colouring);
    const pixels = await read_pixels(stage);
    expect.equal(await stage.getAttribute("data-colouring"), colouring, `${id}: colouring`);
    expect.that(pixels.sum !== first.sum, `${id}: colours change for ${colouring}`);
    expect.that(Math.abs(pixels.count - first.count) <= 0.02 * first.count, `${id}: only colours change for ${colouring}`);
    const label = await section.locator(".colour-bar").getAttribute("aria-label");
    expect.that(label.includes(colouring.split("_")[0]), `${id}: the colour bar is that of ${colouring}, found “${label}”`);
  }
  await select.selectOption("length");
  expect.equal((await read_pixels(stage)).sum, first.sum, `${id}: pixels of the first colouring are back`);
}

/** The colour bar of the length must end at the longest fiber of all times. */
async function check_colour_bar(section, frames, expect, id) {
  const every = frames.flatMap((frame) => Array.from(frame.birth, (_birth, fiber) => length_of(frame, fiber)));
  const largest = Math.max(...every);
  const unit = /\(([^()]*)\)$/.exec(await section.locator(".colour-bar").getAttribute("aria-label"))[1];
  const ticks = (await section.locator(".colour-bar svg text").allTextContents()).map((text) => read_number(text) * unit_factor(unit, "m"));
  const last = Math.max(...ticks);
  expect.that(ticks.length >= 3 && last <= 1.001 * largest && last > 0.6 * largest, `${id}: colour bar up to ${last} for fibers up to ${largest}`);
}

/** Points at places of the canvas until a fiber answers, and compares what it tells. */
async function check_pointing(page, stage, frame, expect, id) {
  const box = stage.locator(".fiber-facts");
  const area = await stage.locator("canvas").boundingBox();
  let found;
  for (let k = 0; k < 400 && found === undefined; ++k) {
    // A low-discrepancy walk over the middle of the canvas.
    const x = area.x + area.width * (0.15 + 0.7 * ((k * 0.7548776662) % 1));
    const y = area.y + area.height * (0.15 + 0.7 * ((k * 0.569840296) % 1));
    await page.mouse.move(x, y);
    if (await box.isVisible()) found = { x, y };
  }
  expect.that(found !== undefined, `${id}: a fiber answers to the pointer`);
  if (!found) return;
  const fiber = Number(await box.getAttribute("data-fiber"));
  const told = await box.locator("dd").allTextContents();
  expect.equal(told[0], String(fiber), `${id}: number of the fiber`);
  expect.near(read_quantity(told[1], "m"), length_of(frame, fiber), `${id}: length of fiber ${fiber}`);
  expect.equal(Number(told[2]), frame.offsets[fiber + 1] - frame.offsets[fiber] - 1, `${id}: rods of fiber ${fiber}`);
  expect.that(told[3].split(",")[0] === String(frame.birth[fiber]), `${id}: birth of fiber ${fiber}`);
  const radius = smallest_radius(frame, fiber);
  if (told[4] === "straight") expect.that(radius > 50 * length_of(frame, fiber), `${id}: fiber ${fiber} is straight, radius ${radius}`);
  else expect.near(read_quantity(told[4], "m"), radius, `${id}: radius of fiber ${fiber}`, 5e-3);
  const before = await read_pixels(stage);
  await page.mouse.down();
  await page.mouse.up();
  expect.equal(await stage.getAttribute("data-family"), String(frame.birth[fiber]), `${id}: a click follows the birth fiber`);
  if (new Set(frame.birth).size > 1) expect.that((await read_pixels(stage)).sum !== before.sum, `${id}: the others fade`);
  await page.mouse.move(area.x + 2, area.y + 2);
  await page.mouse.down();
  await page.mouse.up();
  expect.equal(await stage.getAttribute("data-family"), null, `${id}: a click beside the fibers ends it`);
  return found;
}

async function check_player(section, stage, count, expect, id) {
  await move_slider(section, 0);
  await section.locator(".player .play").click();
  for (let k = 0; k < 100 && (await stage.getAttribute("data-frame")) === "0"; ++k) await section.page().waitForTimeout(100);
  expect.that(Number(await stage.getAttribute("data-frame")) > 0, `${id}: playing moves the time`);
  await section.locator(".player .play").click();
  await move_slider(section, count - 1);
}

/** Gives the shortest of a displacement and its images under a row-major lattice. */
function nearest_image(lattice, displacement) {
  const d = [...displacement];
  for (const axis of [2, 1, 0]) {
    const cells = lattice[4 * axis] ? Math.round(d[axis] / lattice[4 * axis]) : 0;
    for (let k = 0; k < 3; ++k) d[k] -= cells * lattice[3 * k + axis];
  }
  return d;
}

/** Follows the chosen fiber in small steps of time: it must move no more than the flow and a slow drift carry it. */
async function check_motion(section, stage, frames, expect, id) {
  const steps = 20; // between two frames
  const [first, last] = [0, Math.min(3, frames.length - 1)];
  const path = [];
  for (let k = first * steps; k <= last * steps; ++k) {
    await move_slider(section, k / steps);
    path.push(await stage.evaluate(({ dataset }) => ({
      at: dataset.chosen?.split(" ").map(Number), lattice: dataset.lattice.split(" ").map(Number), time: Number(dataset.time),
    })));
  }
  const start = read_frame(frames[0]);
  const longest = Math.max(...Array.from(start.birth, (_birth, fiber) => length_of(start, fiber)));
  const sizes = [0, 4, 8].map((k) => path[0].lattice[k]);
  path.slice(1).forEach((now, k) => {
    const before = path[k];
    if (!now.at || !before.at) return;
    const moved = nearest_image(now.lattice, minus(now.at, before.at));
    const tilt = (one) => one.lattice[1] / one.lattice[4];
    const period = now.lattice[0] / now.lattice[4];
    const strain = tilt(now) - tilt(before) - period * Math.round((tilt(now) - tilt(before)) / period);
    const carried = Math.abs(strain) * sizes[1];
    // On top of the flow: a half turn of the fiber between two frames, and a drift of a whole cell.
    const own = (longest * Math.PI) / 2 / steps;
    expect.that(Math.abs(moved[0]) <= 1.05 * carried + own + sizes[0] / steps, `${id}: at ${now.time} s the chosen fiber moves ${moved[0]} m along the flow, the flow ${carried} m`);
    for (const axis of [1, 2]) expect.that(Math.abs(moved[axis]) <= own + sizes[axis] / steps, `${id}: at ${now.time} s the chosen fiber moves ${moved[axis]} m across the flow`);
  });
}

export async function check_fibers(page, document_section, expect) {
  const { id, frames } = document_section;
  const section = page.locator(`[id="${id}"]`);
  await section.scrollIntoViewIfNeeded();
  const stage = section.locator(".stage");
  expect.equal(await stage.getAttribute("data-webgl"), "working", `${id}: WebGL`);
  const [first, last] = [read_frame(frames[0]), read_frame(frames.at(-1))];
  expect.equal(Number(await stage.getAttribute("data-frame")), frames.length - 1, `${id}: the page opens at the last time`);
  await move_slider(section, 0);
  const at_first = await check_frame(stage, first, `${id} at the first time`, expect);
  const found = await check_pointing(page, stage, first, expect, id);
  if (frames.length > 1) {
    await move_slider(section, frames.length - 1);
    const at_last = await check_frame(stage, last, `${id} at the last time`, expect);
    expect.equal(at_last.per_rod, at_first.per_rod, `${id}: triangles a rod`);
    expect.that(at_last.pixels.sum !== at_first.pixels.sum, `${id}: the picture changes with time`);
    if (found) {
      await move_slider(section, 0);
      await page.mouse.click(found.x, found.y);
      await check_motion(section, stage, frames, expect, id);
      await move_slider(section, frames.length - 1);
    }
    await check_player(section, stage, frames.length, expect, id);
    await check_saved_frames(page, document_section, expect);
    await check_cancelled_film(page, document_section, expect);
  }
  await check_colourings(section, stage, expect, id);
  await check_colour_bar(section, frames.map(read_frame), expect, id);
  await section.locator("select[name=images]").selectOption("fibers");
  await check_frame(stage, last, `${id} as whole fibers`, expect);
}
