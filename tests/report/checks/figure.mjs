// Reads values back out of a vector figure by its ticks, as a person with a ruler would.
import { plain_label, read_number } from "./expect.mjs";

/** Gives the ticks of an axis as [place, value]. */
async function read_ticks(figure, axis) {
  const ticks = await figure.locator(`.tick-${axis}`).evaluateAll(
    (texts) => texts.map((text) => [Number(text.getAttribute("data-at") ?? text.getAttribute("x")), text.textContent]));
  return ticks.map(([at, text]) => [at, read_number(text)]);
}

/** Makes the map from places in the figure to values of an axis; names stand at 1, 2, 3, … */
export async function read_axis(figure, axis, scale, names) {
  const ticks = await read_ticks(figure, axis);
  if (names) {
    const texts = await figure.locator(`.tick-${axis}`).allTextContents();
    ticks.forEach((tick, k) => { tick[1] = 1 + names.findIndex((name) => plain_label(name) === texts[k]); });
    if (ticks.length === 1) return () => ticks[0][1];
  }
  const [[p0, v0], [p1, v1]] = [ticks[0], ticks.at(-1)];
  if (scale === "log") return (place) => v0 * (v1 / v0) ** ((place - p0) / (p1 - p0));
  return (place) => v0 + ((v1 - v0) * (place - p0)) / (p1 - p0);
}

/** Gives the places of a figure's left and right edge. */
export async function read_edges(figure) {
  return [Number(await figure.getAttribute("data-left")), Number(await figure.getAttribute("data-right"))];
}

/** Asks the page for its print figures and hands a section's to `use`. */
export async function with_print_figure(page, id, use) {
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  try {
    await use(page.locator(`[id="${id}"] .print-figure`));
  } finally {
    await page.evaluate(() => window.dispatchEvent(new Event("afterprint")));
  }
}
