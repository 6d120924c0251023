// Checks of what readers save: figures for papers, numbers, pictures of a view over time.
import { readFileSync } from "node:fs";
import { is_number } from "./expect.mjs";

/** Presses an entry of a section's menu and reads the file that comes. */
async function save(page, id, entry) {
  const menu = page.locator(`[id="${id}"] .menu`);
  await menu.locator("summary").click();
  const coming = page.waitForEvent("download", { timeout: 240_000 });
  await menu.getByRole("button", { name: entry, exact: true }).click();
  return readFileSync(await (await coming).path());
}

const largest_figure = 60_000; // bytes, of a chart of some hundred points

/** A figure is small, and its legend names every curve. */
async function check_figure(page, section, expect) {
  const text = String(await save(page, section.id, "Figure as SVG"));
  const points = section.series.reduce((sum, { values }) => sum + values.length, 0);
  expect.that(text.length < Math.max(largest_figure, 60 * points), `${section.id}: the saved figure has ${text.length} bytes`);
  expect.that(!text.includes("font-face") && text.includes("Inter,"), `${section.id}: the saved figure names its type and does not carry it`);
}

/** Numbers have seven digits, and all rows of the longest column are there. */
async function check_numbers(page, section, expect) {
  const [head, ...rows] = String(await save(page, section.id, "Numbers as CSV")).trim().split("\n");
  expect.equal(rows.length, Math.max(...section.series.map(({ values }) => values.length)), `${section.id}: rows of the saved numbers`);
  const unit = section.y.unit;
  if (unit) expect.that(head.includes(`[${unit}]`), `${section.id}: the header of the saved numbers tells ${unit}, found ${head}`);
  const digits = (cell) => cell.replace(/e.*|[-.]/g, "").replace(/^0+/, "").length;
  const long = rows.flatMap((row) => row.split(",")).find((cell) => !Number.isInteger(Number(cell)) && digits(cell) > 7);
  expect.equal(long, undefined, `${section.id}: a saved number with more than seven digits`);
  const first = section.series[0].values[0];
  if (!section.series[0].x && is_number(first)) expect.near(Number(rows[0].split(",").at(1)), first, `${section.id}: the first saved number`, 1e-6);
}

export async function check_saved_chart(page, section, expect) {
  await check_figure(page, section, expect);
  await check_numbers(page, section, expect);
}

/** Counts the PNG pictures of an archive whose files are stored as they are. */
function count_pictures(zip) {
  const end = zip.lastIndexOf(Buffer.from("504b0506", "hex"));
  let [at, pictures] = [0, 0];
  for (const count = zip.readUInt16LE(end + 10); pictures < count; ++pictures) {
    const size = zip.readUInt32LE(at + 18);
    const begin = at + 30 + zip.readUInt16LE(at + 26);
    if (zip.readUInt32LE(at) !== 0x04034b50 || zip.readUInt32BE(begin) !== 0x89504e47) break;
    at = begin + size;
  }
  return pictures;
}

const most_frames = 12; // pictures take a second each without a graphics card

/** The archive has a picture a frame, and the view shows again what it showed. */
export async function check_saved_frames(page, section, expect) {
  if (section.frames.length < 2 || section.frames.length > most_frames) return;
  const stage = page.locator(`[id="${section.id}"] .stage`);
  const before = await stage.getAttribute("data-time");
  const zip = await save(page, section.id, "Save frames");
  expect.equal(count_pictures(zip), section.frames.length, `${section.id}: saved pictures`);
  expect.equal(await stage.getAttribute("data-time"), before, `${section.id}: the time after saving`);
}

/** A film that is cancelled leaves nothing over the view. */
export async function check_cancelled_film(page, section, expect) {
  const element = page.locator(`[id="${section.id}"]`);
  await element.locator(".menu summary").click();
  await element.getByRole("button", { name: "Save animation", exact: true }).click();
  // A busy machine may be slower with a click of the mouse than the film is long.
  await element.locator(".saving button").evaluate((button) => button.click());
  await element.locator(".saving").waitFor({ state: "detached", timeout: 60_000 });
  expect.equal(await element.locator(".saving").count(), 0, `${section.id}: cover after a cancelled film`);
}
