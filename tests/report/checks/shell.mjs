// Checks of the part in 3D: what is filled at several times, colours, pointing at nodes.
import { read_number, read_quantity, unit_factor } from "./expect.mjs";
import { decode, move_slider, read_pixels } from "./stage.mjs";

/** Decodes what the page shows: points, triangles, fill times, and the values of fields that hold at all times. */
function read_part(section) {
  return {
    points: decode(section.points, Float32Array), triangles: decode(section.triangles, Int32Array),
    fill_time: decode(section.fill_time, Float32Array),
    fields: section.fields.map(({ frames }) => frames.map((frame) => decode(frame, Float32Array))),
  };
}

const positions = 120;

function end_of(section, part) {
  return Math.max(section.times.at(-1) ?? 0, ...part.fill_time.filter(Number.isFinite));
}

/** At every position of the slider the page must count the nodes that the melt has reached. */
async function check_times(element, stage, section, part, expect) {
  const end = end_of(section, part);
  const sums = [];
  for (const position of [0, positions / 2, positions]) {
    await move_slider(element, position);
    const pixels = await read_pixels(stage);
    const time = Number(await stage.getAttribute("data-time"));
    const filled = part.fill_time.filter((one) => one <= time).length;
    expect.near(time, (end * position) / positions, `${section.id}: time at position ${position}`, 1e-12);
    expect.equal(Number(await stage.getAttribute("data-filled-nodes")), filled, `${section.id}: filled nodes at ${time} s`);
    expect.that(pixels.count > 2000, `${section.id}: ${pixels.count} pixels of the part at ${time} s`);
    sums.push(pixels);
  }
  expect.that(sums[2].colours > sums[0].colours, `${section.id}: a full part has more colours than an empty one`);
  expect.that(Math.abs(sums[2].count - sums[0].count) <= 0.01 * sums[0].count, `${section.id}: filling changes colours only`);
}

/** Every field recolours the part and has a colour bar that spans its values. */
async function check_fields(element, stage, section, part, expect) {
  const select = element.locator("select[name=colour]");
  for (let k = 0; k < section.fields.length; ++k) {
    const { label, unit } = section.fields[k];
    await select.selectOption(String(k));
    await read_pixels(stage);
    expect.equal(await stage.getAttribute("data-colouring"), label, `${section.id}: colouring`);
    const title = await element.locator(".colour-bar").getAttribute("aria-label");
    const values = part.fields[k].flatMap((frame) => [...frame]).filter(Number.isFinite);
    const [least, high] = [Math.min(...values), Math.max(...values)];
    const low = least > 0 && least < 0.05 * high ? 0 : least;
    const shown_unit = /\(([^()]*)\)$/.exec(title)?.[1] ?? "";
    const ticks = (await element.locator(".colour-bar svg text").allTextContents()).map((text) => read_number(text) * unit_factor(shown_unit, unit));
    const slack = 1e-6 * Math.max(Math.abs(low), Math.abs(high));
    const inside = least === high || ticks.every((tick) => tick >= low - slack && tick <= high + slack);
    expect.that(ticks.length >= 2 && inside, `${section.id}: ticks ${ticks} of ${label} lie between ${low} and ${high}`);
    const shown = await element.locator(".colour-bar svg text").allTextContents();
    expect.that(shown.every((text) => text.replace(/×.*|[\s−.]/gu, "").replace(/^0+|0+$/g, "").length <= 6), `${section.id}: ticks ${shown} of ${label} are round`);
    if (low === 0) expect.that(shown.includes("0"), `${section.id}: the bar of ${label} begins at 0, found ${shown}`);
  }
  await select.selectOption("0");
}

/** Points at the middle of the canvas and around it until a node answers. */
async function check_pointing(page, stage, section, part, expect) {
  const box = stage.locator(".fiber-facts");
  const area = await stage.locator("canvas").boundingBox();
  let visible = false;
  for (let k = 0; k < 200 && !visible; ++k) {
    await page.mouse.move(area.x + area.width * (0.2 + 0.6 * ((k * 0.7548776662) % 1)), area.y + area.height * (0.2 + 0.6 * ((k * 0.569840296) % 1)));
    visible = await box.isVisible();
  }
  expect.that(visible, `${section.id}: a node answers to the pointer`);
  if (!visible) return;
  const node = Number(await box.getAttribute("data-node"));
  const told = await box.locator("dd").allTextContents();
  expect.equal(told[0], String(node), `${section.id}: number of the node`);
  const place = told[1].replace(" mm", "").split(", ").map(Number);
  place.forEach((value, k) => expect.that(Math.abs(value - 1e3 * part.points[3 * node + k]) <= 0.051, `${section.id}: place of node ${node}`));
  const filled = part.fill_time[node];
  if (Number.isFinite(filled)) expect.near(read_quantity(told[2], "s"), filled, `${section.id}: fill time of node ${node}`);
}

export async function check_shell(page, section, expect) {
  const element = page.locator(`[id="${section.id}"]`);
  const stage = element.locator(".stage");
  await stage.scrollIntoViewIfNeeded();
  const part = read_part(section);
  expect.equal(await stage.getAttribute("data-webgl"), "working", `${section.id}: WebGL`);
  expect.equal(Number(await stage.getAttribute("data-nodes")), part.points.length / 3, `${section.id}: nodes`);
  await check_times(element, stage, section, part, expect);
  await check_fields(element, stage, section, part, expect);
  await check_pointing(page, stage, section, part, expect);
  expect.equal(await element.locator(".place").count(), section.places?.length ?? 0, `${section.id}: places`);
  // Four for the view and its files, two that save it over time, and one a kind of lines, tensors and directions.
  const overlays = [section.lines, section.tensors, section.directions].reduce((sum, kind) => sum + (kind?.length ?? 0), 0);
  expect.equal(await element.locator(".controls button").count(), 6 + overlays, `${section.id}: buttons`);
}
