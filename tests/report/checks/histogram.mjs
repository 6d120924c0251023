// Checks of histograms and heatmaps: every bar's height read by the ticks, every cell's presence and colour.
import { is_number, read_number, unit_factor } from "./expect.mjs";
import { read_axis, read_edges, with_print_figure } from "./figure.mjs";

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

/** The last point of every curve over the bars, read by the ticks of the figure; its button hides it. */
async function check_curves(page, section, expect) {
  const curves = section.curves ?? [];
  const drawn = page.locator(`[id="${section.id}"] .vector .curve`);
  expect.equal(await drawn.count(), curves.length, `${section.id}: curves`);
  if (curves.length === 0) return;
  const title = await page.locator(`[id="${section.id}"] .axis-title.x`).textContent();
  const factor = unit_factor(/\(([^()]*)\)$/.exec(title)?.[1] ?? "", section.x.unit);
  await with_print_figure(page, section.id, async (figure) => {
    const [to_x, to_y] = [await read_axis(figure, "x", "linear"), await read_axis(figure, "y", "linear")];
    const highest = Math.max(...section.frames.flatMap(({ values }) => values.filter(is_number)), ...curves.flatMap(({ values }) => values.filter(is_number)));
    for (const curve of curves) {
      const last = curve.values.findLastIndex((value, k) => is_number(value) && is_number(curve.x[k]));
      const path = await figure.locator(`path.curve[data-series=${JSON.stringify(curve.label)}]`).getAttribute("d");
      const [x, y] = path.split(/[ML]/).at(-1).split(",").map(Number);
      expect.that(Math.abs(to_x(x) * factor - curve.x[last]) <= 4e-3 * Math.max(...curve.x), `${section.id}: ${curve.label} ends at x ${to_x(x) * factor}`);
      expect.that(Math.abs(to_y(y) - curve.values[last]) <= 4e-3 * highest, `${section.id}: ${curve.label} ends at ${to_y(y)}, not ${curve.values[last]}`);
    }
  });
  const button = page.locator(`[id="${section.id}"] .frames button`).nth(section.frames.length);
  await button.click();
  expect.equal(await drawn.count(), curves.length - 1, `${section.id}: curves without a hidden one`);
  await button.click();
}

export async function check_histogram(page, section, expect) {
  const last = section.frames.length - 1;
  for (const index of new Set([0, last])) await check_frame(page, section, index, expect);
  await show_only(page, section, [0, last]);
  const groups = await page.locator(`[id="${section.id}"] .bars`).count();
  expect.equal(groups, new Set([0, last]).size, `${section.id}: frames laid over each other`);
  const references = await page.locator(`[id="${section.id}"] .vector .reference`).count();
  expect.equal(references, section.reference ? 1 : 0, `${section.id}: reference`);
  await check_curves(page, section, expect);
}

/** The ends of a given range have the colours of the ends of the map. */
function check_range(section, cells, expect) {
  const ends = section.colours === "diverging" ? ["rgb(33,102,172)", "rgb(178,24,43)"] : ["rgb(68,1,84)", "rgb(253,231,37)"];
  section.range.forEach((end, k) => {
    for (const { colour } of cells.filter(({ value }) => value === end)) expect.equal(colour, ends[k], `${section.id}: colour at ${end}`);
  });
}

export async function check_heatmap(page, section, expect) {
  const cells = await page.locator(`[id="${section.id}"] .vector .cell`).evaluateAll((rects) =>
    rects.map((rect) => ({ value: Number(rect.dataset.value), colour: rect.getAttribute("fill") })));
  const wanted = section.values.flat().filter(is_number);
  expect.equal(cells.length, wanted.length, `${section.id}: cells`);
  expect.that(cells.every(({ value }, k) => value === wanted[k]), `${section.id}: values of the cells`);
  const sorted = [...cells].sort((a, b) => a.value - b.value);
  if (section.written) {
    const texts = await page.locator(`[id="${section.id}"] .vector .cell-value`).allTextContents();
    wanted.forEach((value, k) => expect.near(read_number(texts[k]), value, `${section.id}: text of cell ${k}`, 6e-2));
  }
  if (section.range) return check_range(section, cells, expect);
  // Colours begin at zero where values nearly do.
  const from_zero = sorted[0]?.value > 0 && sorted[0].value < 0.05 * sorted.at(-1).value;
  if (!from_zero) expect.equal(sorted[0]?.colour, "rgb(68,1,84)", `${section.id}: colour of the smallest`);
  if (sorted.at(-1)?.value > sorted[0]?.value) expect.equal(sorted.at(-1).colour, "rgb(253,231,37)", `${section.id}: colour of the largest`);
}
