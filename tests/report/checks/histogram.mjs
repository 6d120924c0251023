// Checks of histograms and heatmaps: every bar's height read by the ticks, every cell's presence and colour.
import { is_number } from "./expect.mjs";
import { read_axis, read_edges } from "./figure.mjs";

async function show_only(page, section, wanted) {
  const buttons = page.locator(`[id="${section.id}"] .frames button`);
  for (let k = 0; k < section.frames.length; ++k) {
    const on = (await buttons.nth(k).getAttribute("aria-pressed")) === "true";
    if (on !== wanted.includes(k)) await buttons.nth(k).click();
  }
}

async function check_frame(page, section, index, expect) {
  await show_only(page, section, [index]);
  const figure = page.locator(`[id="${section.id}"] .vector svg`);
  const to_y = await read_axis(figure, "y", "linear");
  const bars = await figure.locator(".bars rect").evaluateAll((rects) => rects.map((rect) => ({
    top: Number(rect.getAttribute("y")), width: Number(rect.getAttribute("width")), height: Number(rect.getAttribute("height")),
  })));
  const { label, values } = section.frames[index];
  expect.equal(bars.length, section.edges.length - 1, `${section.id}: bars at ${label}`);
  const largest = Math.max(1e-300, ...section.frames.flatMap((frame) => frame.values.filter(is_number)));
  const span = section.edges.at(-1) - section.edges[0];
  const [left, right] = await read_edges(figure);
  bars.forEach((bar, k) => {
    const height = to_y(bar.top) - to_y(bar.top + bar.height);
    const wanted = is_number(values[k]) ? values[k] : 0;
    expect.that(Math.abs(height - wanted) <= 2e-3 * largest, `${section.id}: bar ${k} at ${label} is ${height} high, not ${wanted}`);
    const share = bar.width / (right - left);
    expect.that(Math.abs(share - (section.edges[k + 1] - section.edges[k]) / span) < 1e-6, `${section.id}: width of bar ${k}`);
  });
}

export async function check_histogram(page, section, expect) {
  const last = section.frames.length - 1;
  for (const index of new Set([0, last])) await check_frame(page, section, index, expect);
  await show_only(page, section, [0, last]);
  const groups = await page.locator(`[id="${section.id}"] .bars`).count();
  expect.equal(groups, new Set([0, last]).size, `${section.id}: frames laid over each other`);
  const references = await page.locator(`[id="${section.id}"] .vector .reference`).count();
  expect.equal(references, section.reference ? 1 : 0, `${section.id}: reference`);
}

export async function check_heatmap(page, section, expect) {
  const cells = await page.locator(`[id="${section.id}"] .vector .cell`).evaluateAll((rects) =>
    rects.map((rect) => ({ value: Number(rect.dataset.value), colour: rect.getAttribute("fill") })));
  const wanted = section.values.flat().filter(is_number);
  expect.equal(cells.length, wanted.length, `${section.id}: cells`);
  expect.that(cells.every(({ value }, k) => value === wanted[k]), `${section.id}: values of the cells`);
  const sorted = [...cells].sort((a, b) => a.value - b.value);
  expect.equal(sorted[0]?.colour, "rgb(68,1,84)", `${section.id}: colour of the smallest`);
  if (sorted.at(-1)?.value > sorted[0]?.value) expect.equal(sorted.at(-1).colour, "rgb(253,231,37)", `${section.id}: colour of the largest`);
}
