// Checks of the sections that are text: facts, tables, and the note for an unknown kind.
import { is_number, plain_label, read_number, read_quantity, unit_factor } from "./expect.mjs";

async function check_fact(expect, shown, fact, what) {
  if (Array.isArray(fact.value)) {
    const cells = await shown.locator(".matrix td").allTextContents();
    const largest = Math.max(...fact.value.flat().map(Math.abs));
    expect.equal(cells.length, 9, `${what}: components`);
    fact.value.flat().forEach((value, k) => {
      expect.that(Math.abs(read_number(cells[k]) - value) <= 6e-4 * largest, `${what}: component ${k} shown ${cells[k]}, is ${value}`);
    });
    return;
  }
  const text = await shown.evaluate((node) => node.childNodes[0]?.textContent ?? "");
  if (typeof fact.value === "string") expect.that([fact.value, plain_label(fact.value)].some((one) => text.startsWith(one)), `${what}: shown “${text}”, is “${fact.value}”`);
  else if (is_number(fact.value)) expect.near(read_quantity(text, fact.unit), fact.value, what);
  else expect.equal(text, "–", what);
}

export async function check_facts(page, section, expect) {
  const rows = page.locator(`[id="${section.id}"] dl > div`);
  expect.equal(await rows.count(), section.rows.length, `${section.id}: facts`);
  for (const [k, fact] of section.rows.entries()) {
    const what = `${section.id}: ${fact.label}`;
    expect.equal(await rows.nth(k).locator("dt").textContent(), plain_label(fact.label), `${what}: label`);
    await check_fact(expect, rows.nth(k).locator("dd"), fact, what);
  }
}

export async function check_table(page, section, expect) {
  const rows = page.locator(`[id="${section.id}"] tbody tr`);
  const units = await page.locator(`[id="${section.id}"] thead th`).evaluateAll(
    (cells) => cells.map((cell) => cell.querySelector(".unit")?.textContent ?? ""));
  expect.equal(await rows.count(), section.rows.length, `${section.id}: rows`);
  for (const [j, row] of section.rows.entries()) {
    const cells = await rows.nth(j).locator("td").allTextContents();
    expect.equal(cells.length, section.columns.length, `${section.id}: columns of row ${j}`);
    row.forEach((value, k) => {
      const what = `${section.id}: row ${j}, ${section.columns[k].label}`;
      if (typeof value === "string") expect.equal(cells[k], plain_label(value), what);
      else if (is_number(value)) expect.near(read_number(cells[k]) * unit_factor(units[k], section.columns[k].unit), value, what);
      else expect.equal(cells[k], "–", what);
    });
  }
}

/** Every fact of every run, with the ends of replicas. */
export async function check_comparison(page, section, expect) {
  const table = page.locator(`[id="${section.id}"] table`);
  const heads = await table.locator("thead th").allTextContents();
  expect.equal(heads.join(), section.runs.map(plain_label).join(), `${section.id}: runs`);
  const rows = table.locator("tbody tr");
  expect.equal(await rows.count(), section.rows.length, `${section.id}: rows`);
  for (const [j, fact] of section.rows.entries()) {
    const unit = (await rows.nth(j).locator("th .unit").allTextContents()).join("").trim();
    const cells = await rows.nth(j).locator("td").evaluateAll((all) => all.map((cell) => [cell.childNodes[0]?.textContent ?? "", cell.querySelector("small")?.textContent]));
    fact.values.forEach((value, k) => {
      const what = `${section.id}: ${fact.label} of ${section.runs[k]}`;
      if (is_number(value)) expect.near(read_number(cells[k][0]) * unit_factor(unit, fact.unit), value, what);
      else expect.equal(cells[k][0], value === null ? "–" : plain_label(value), what);
      if (!is_number(fact.low?.[k]) || fact.low[k] === fact.high[k]) return;
      const ends = (cells[k][1] ?? "").split(" to ").map((text) => read_number(text) * unit_factor(unit, fact.unit));
      expect.near(ends[0], fact.low[k], `${what}, least`);
      expect.near(ends[1], fact.high[k], `${what}, largest`);
    });
  }
}

export async function check_note(page, section, expect) {
  const text = await page.locator(`[id="${section.id}"] .note`).textContent();
  expect.that(text.includes(section.kind), `${section.id}: the note names the unknown kind`);
}
