// Checks of curves: legend, values under the cursor, pixels, zoom, and the vector figure read back by its ticks.
import { is_number, plain_label, read_number, unit_factor } from "./expect.mjs";
import { read_axis, read_edges, with_print_figure } from "./figure.mjs";
import { check_saved_chart } from "./saved.mjs";

const last_of = (values) => values.filter(is_number).at(-1) ?? null;

async function read_factors(page, section) {
  const unit_of = async (side) => /\(([^()]*)\)$/.exec(await page.locator(`[id="${section.id}"] .axis-title.${side}`).textContent())?.[1] ?? "";
  return { x: unit_factor(await unit_of("x"), section.x.unit), y: unit_factor(await unit_of("y"), section.y.unit) };
}

/** The last values are told where they are the outcome: over time and strain. */
async function check_last(page, section, expect) {
  if (section.legend === "names" || section.series.length === 0) return;
  const over_time = ["s", "min", "h"].includes(section.x.unit) || /\b(time|strain|steps?|revolutions)\b/i.test(section.x.label);
  const told = await page.locator(`[id="${section.id}"] .legend .reading`).first().evaluate((reading) => getComputedStyle(reading).visibility);
  expect.equal(told, over_time ? "visible" : "hidden", `${section.id}: last values over ${section.x.label}`);
  expect.equal(await page.locator(`[id="${section.id}"] .where`).textContent(), over_time ? "last values" : "", `${section.id}: what the legend tells`);
}

async function check_legend(page, section, factors, expect) {
  await check_last(page, section, expect);
  const values = page.locator(`[id="${section.id}"] .legend .value`);
  expect.equal(await values.count(), section.series.length, `${section.id}: legend entries`);
  const largest = Math.max(0, ...section.series.flatMap((series) => series.values.filter(is_number).map(Math.abs)));
  for (const [k, series] of section.series.entries()) {
    const what = `${section.id}: last ${series.label}`;
    const wanted = last_of(series.values);
    expect.equal(await values.nth(k).getAttribute("data-series"), series.label, `${what}: name`);
    expect.equal(await values.nth(k).getAttribute("data-last"), wanted === null ? "" : String(wanted), `${what}: data-last`);
    const shown = await values.nth(k).textContent();
    if (wanted === null) expect.equal(shown, "–", what);
    else if (Math.abs(wanted) < 1e-12 * largest) expect.equal(shown, "0", `${what}, which is round-off`);
    else expect.near(read_number(shown) * factors.y, wanted, what);
  }
}

/** The value shown must belong to one of the points nearest to the shown x; that x is rounded to four digits. */
function belongs_to_nearest(xs, ys, x, shown, slack) {
  const found = xs.map((value, k) => [value, ys[k]]).filter(([value, y]) => is_number(value) && is_number(y));
  const nearest = Math.min(...found.map(([value]) => Math.abs(value - x)));
  return found.some(([value, y]) => Math.abs(value - x) <= nearest + slack && Math.abs(y - shown) <= 6e-4 * Math.abs(y));
}

async function check_cursor(page, section, factors, expect) {
  const over = page.locator(`[id="${section.id}"] .u-over`);
  const area = await over.boundingBox();
  await page.mouse.move(area.x + 0.4 * area.width, area.y + 0.5 * area.height);
  const where = await page.locator(`[id="${section.id}"] .where`).textContent();
  if (section.legend === "names") {
    expect.equal(where, "", `${section.id}: a legend of names tells no place`);
    return;
  }
  expect.that(where.startsWith("at "), `${section.id}: the legend tells the place of the cursor, found “${where}”`);
  if (section.x.names) {
    expect.that(section.x.names.map(plain_label).includes(where.slice(3)), `${section.id}: the legend names a place, found “${where}”`);
    return;
  }
  const number = /([−\d.\u2009×⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)[^\d]*$/u.exec(where.slice(3 + section.x.label.replaceAll("_", "").length))?.[1] ?? "";
  const x = read_number(number) * factors.x;
  const values = await page.locator(`[id="${section.id}"] .legend .value`).allTextContents();
  section.series.forEach((series, k) => {
    if (last_of(series.values) === null) return;
    const shown = read_number(values[k]) * factors.y;
    const held = belongs_to_nearest(series.x ?? section.x.values, series.values, x, shown, 2e-3 * Math.abs(x));
    expect.that(held, `${section.id}: ${series.label} under the cursor at ${x} shown as ${shown}`);
  });
  await page.mouse.move(1, 1);
}

/** Counts the pixels of every curve's colour in the canvas, in the order of the legend. */
function count_pixels(page, section) {
  return page.locator(`[id="${section.id}"]`).evaluate((element) => {
    const canvas = element.querySelector("canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return [...element.querySelectorAll(".legend button")].map((button) => {
      const bits = Number.parseInt(button.style.getPropertyValue("--series").slice(1), 16);
      const colour = [bits >> 16, (bits >> 8) & 255, bits & 255];
      let count = 0;
      for (let k = 0; k < data.length; k += 4) {
        if (data[k + 3] > 150 && colour.every((value, c) => Math.abs(data[k + c] - value) < 12)) ++count;
      }
      return count;
    });
  });
}

/** Hides all curves but one, or shows them again, as the reader does, and waits until that is drawn. */
async function toggle_others(page, section, shown) {
  const buttons = page.locator(`[id="${section.id}"] .legend button`);
  for (let k = 0; k < section.series.length; ++k) if (k !== shown) await buttons.nth(k).click();
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Every curve must leave pixels of its own colour in the canvas; one that lies behind others, when those are hidden. */
async function check_pixels(page, section, expect) {
  const together = await count_pixels(page, section);
  for (const [k, series] of section.series.entries()) {
    const drawable = series.values.some((y) => is_number(y) && (section.y.scale !== "log" || y > 0));
    if (!drawable) continue;
    let count = together[k];
    if (count <= 5) {
      await toggle_others(page, section, k);
      count = (await count_pixels(page, section))[k];
      await toggle_others(page, section, k);
    }
    expect.that(count > 5, `${section.id}: ${series.label} has ${count} pixels in its colour`);
  }
}

function scale_of(section, axis, values) {
  return section[axis].scale === "log" && values.some((value) => is_number(value) && value > 0) ? "log" : "linear";
}

/** Every point with bounds has a bar. */
async function check_bars(figure, section, expect) {
  const barred = section.series.filter((series) => (section.kind === "scatter" || series.style === "points") && series.low);
  const bars = await figure.locator("path.bar").evaluateAll((paths) => paths.map((path) => (path.getAttribute("d").match(/M/g) ?? []).length));
  const wanted = barred.map((series) => series.values.filter((_value, k) => is_number(series.low[k]) && is_number(series.high[k])).length);
  expect.equal(bars.join(), wanted.join(), `${section.id}: bars of points`);
}

/** Reads the last drawn point of every curve back by the ticks of the vector figure. */
async function check_figure(page, section, factors, expect) {
  await with_print_figure(page, section.id, async (figure) => {
    const y_scale = scale_of(section, "y", section.series.flatMap((series) => series.values));
    const x_scale = scale_of(section, "x", section.series.flatMap((series) => series.x ?? section.x.values ?? []));
    const [to_x, to_y] = [await read_axis(figure, "x", x_scale, section.x.names), await read_axis(figure, "y", y_scale)];
    await check_bars(figure, section, expect);
    for (const series of section.series) {
      const xs = series.x ?? section.x.values;
      const drawn = series.values.map((y, k) => [xs[k], y]).filter(([x, y]) =>
        is_number(x) && is_number(y) && (y_scale === "linear" || y > 0) && (x_scale === "linear" || x > 0));
      if (drawn.length === 0) continue;
      const mark = figure.locator(`[data-series=${JSON.stringify(series.label)}]`).last();
      const [px, py] = await mark.evaluate((node) => {
        const text = node.getAttribute("d") ?? `${node.getAttribute("cx")},${node.getAttribute("cy")}`;
        return text.replace(/h2$|Z$/, "").split(/[ML]/).at(-1).split(",").map(Number);
      });
      const largest = Math.max(...section.series.flatMap((other) => other.values.filter(is_number)).map(Math.abs));
      const off = Math.abs(to_y(py) * factors.y - drawn.at(-1)[1]);
      const allowed = y_scale === "log" ? 4e-3 * drawn.at(-1)[1] : 2e-3 * largest;
      expect.that(off <= allowed, `${section.id}: ${series.label} ends at ${to_y(py) * factors.y} in the figure, at ${drawn.at(-1)[1]} in the document`);
      const x_off = Math.abs(to_x(px) * factors.x - drawn.at(-1)[0]);
      expect.that(x_off <= 4e-3 * Math.max(...xs.filter(is_number).map(Math.abs)), `${section.id}: ${series.label} ends at x ${to_x(px) * factors.x}, not ${drawn.at(-1)[0]}`);
    }
  });
}

/** A drag across the second quarter of the chart must leave a figure of that range, and the button must undo it. */
async function check_zoom(page, section, expect) {
  const range = async () => {
    let found;
    await with_print_figure(page, section.id, async (figure) => {
      const to_x = await read_axis(figure, "x", "linear");
      found = (await read_edges(figure)).map(to_x);
    });
    return found;
  };
  const before = await range();
  const area = await page.locator(`[id="${section.id}"] .u-over`).boundingBox();
  const middle = area.y + area.height / 2;
  await page.mouse.move(area.x + 0.25 * area.width, middle);
  await page.mouse.down();
  await page.mouse.move(area.x + 0.5 * area.width, middle, { steps: 5 });
  await page.mouse.up();
  const [from, to] = await range();
  const width = before[1] - before[0];
  expect.that(Math.abs(from - (before[0] + 0.25 * width)) < 0.01 * width, `${section.id}: zoom begins at ${from}`);
  expect.that(Math.abs(to - (before[0] + 0.5 * width)) < 0.01 * width, `${section.id}: zoom ends at ${to}`);
  await page.locator(`[id="${section.id}"] .controls button`, { hasText: "All" }).click();
  const after = await range();
  expect.that(Math.abs(after[1] - before[1]) < 1e-6 * width, `${section.id}: the whole range is back`);
  await page.mouse.move(1, 1);
}

/** The button of the logarithmic x axis must give one: what is drawn at a place is what its ticks say. */
async function check_log_axis(page, section, expect) {
  const button = page.locator(`[id="${section.id}"] .controls button`, { hasText: "log time" });
  expect.equal(await button.count(), 1, `${section.id}: a logarithmic x axis is offered`);
  await button.click();
  await with_print_figure(page, section.id, async (figure) => {
    const positive = section.x.values.filter((x) => is_number(x) && x > 0);
    const to_x = await read_axis(figure, "x", "log");
    const [from, to] = (await read_edges(figure)).map(to_x);
    const unit = Math.max(...positive) / to;
    expect.that(Math.abs(from * unit - Math.min(...positive)) <= 1e-2 * Math.min(...positive), `${section.id}: the logarithmic axis begins at ${from}`);
  });
  await button.click();
}

export async function check_lines(page, section, expect) {
  await page.locator(`[id="${section.id}"]`).scrollIntoViewIfNeeded();
  const factors = await read_factors(page, section);
  await check_legend(page, section, factors, expect);
  await check_pixels(page, section, expect);
  await check_cursor(page, section, factors, expect);
  await check_figure(page, section, factors, expect);
  const linear = section.x.scale !== "log" && (section.x.values ?? []).length > 3;
  if (linear && section.kind === "lines") await check_zoom(page, section, expect);
  if (linear && section.id === "orientation") await check_log_axis(page, section, expect);
  await check_saved_chart(page, section, expect);
}
