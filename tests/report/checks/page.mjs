// Checks of the page as a whole: headlines, type, room for every text, colours, columns, the wheel.
import { settle } from "../browser.mjs";
import { is_number, plain_label, read_number, unit_factor } from "./expect.mjs";
import { check_maps, check_series_colours } from "./colours.mjs";

export const looks = {
  wide: { viewport: { width: 1400, height: 950 } },
  laptop: { viewport: { width: 1280, height: 800 } },
  tablet: { viewport: { width: 800, height: 1100 } },
  narrow: { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true },
  dark: { viewport: { width: 1280, height: 800 }, colorScheme: "dark" },
  print: { viewport: { width: 1280, height: 900 } },
};

/** Every tile must show a number of the document, rounded to three digits. */
export async function check_tiles(page, found, expect) {
  const facts = found.sections.flatMap((section) => (section.kind === "facts" ? section.rows : []));
  const numbers = facts.flatMap(({ value, unit }) => (Array.isArray(value) ? [[value[0][0], unit]] : [[value, unit]])).filter(([value]) => is_number(value));
  const tiles = await page.locator(".tile:not(.compared)").evaluateAll((elements) => elements.map((element) => ({
    label: element.dataset.label, value: Number(element.dataset.value), shown: element.querySelector(".tile-value").textContent,
    unit: element.querySelector(".tile-value .unit")?.textContent ?? "",
  })));
  if (facts.some(({ headline }) => headline)) expect.equal(tiles.length, facts.filter(({ headline }) => headline).length, "headlines");
  for (const { label, value, shown, unit } of tiles) {
    const match = numbers.find(([number]) => number === value);
    expect.that(match !== undefined, `headline ${label}: ${value} is a number of the document`);
    if (!match) continue;
    const number = read_number(shown.slice(0, shown.length - unit.length));
    expect.near(number * unit_factor(unit.trim(), match[1]), value, `headline ${plain_label(label)}`, 6e-3);
  }
}

/** The tiles of several runs: every run's number, all of a tile in one unit. */
export async function check_compared_tiles(page, found, expect) {
  const rows = found.sections.filter(({ kind, role }) => kind === "comparison" && (role ?? "outcome") === "outcome").flatMap((section) => section.rows.map((row) => ({ ...row, runs: section.runs })));
  const tiles = page.locator(".tile.compared");
  if (rows.some(({ headline }) => headline)) expect.equal(await tiles.count(), Math.min(4, rows.filter(({ headline }) => headline).length), "headlines of several runs");
  for (let k = 0; k < (await tiles.count()); ++k) {
    const label = await tiles.nth(k).getAttribute("data-label");
    const row = rows.find((one) => one.label === label);
    const unit = /\((.*)\)$/.exec(await tiles.nth(k).locator(".tile-label").textContent())?.[1] ?? "";
    const shown = await tiles.nth(k).locator("li").evaluateAll((items) => items.map((item) => [item.dataset.run, item.querySelector("b").textContent]));
    shown.forEach(([run, text], j) => {
      expect.equal(run, row.runs[j], `headline ${label}: run ${j}`);
      if (is_number(row.values[j])) expect.near(read_number(text) * unit_factor(unit, row.unit), row.values[j], `headline ${label} of ${run}`, 6e-3);
    });
  }
}

/** All text is in the family that the page carries. */
async function check_type(page, name, expect) {
  const found = await page.evaluate(() => ({
    loaded: [...document.fonts].filter(({ family, status }) => family === "Inter" && status === "loaded").length,
    others: [...document.querySelectorAll("body *")].filter((element) => !getComputedStyle(element).fontFamily.startsWith("Inter"))
      .map(({ tagName }) => tagName).filter((tag) => !["SCRIPT", "STYLE", "NOSCRIPT"].includes(tag)),
  }));
  expect.equal(found.loaded, 2, `${name}: weights of the family`);
  expect.equal(found.others.join(), "", `${name}: elements in another family`);
}

/** No text of a figure leaves it or touches another text of its kind; no text of the page is cut off. */
async function check_room(page, name, expect) {
  const faults = await page.evaluate(() => {
    const told = [];
    const overlap = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0.5 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.5;
    const visible = (element) => element.getClientRects().length > 0;
    for (const figure of document.querySelectorAll("main svg")) {
      const texts = [...figure.querySelectorAll("text")].filter(visible);
      const boxes = texts.map((text) => text.getBoundingClientRect());
      const whole = figure.getBoundingClientRect();
      texts.forEach((text, k) => {
        const inside = boxes[k].left >= whole.left - 1 && boxes[k].right <= whole.right + 1 && boxes[k].top >= whole.top - 1 && boxes[k].bottom <= whole.bottom + 1;
        if (!inside && !figure.classList.contains("triad")) told.push(`“${text.textContent}” leaves its figure in ${figure.closest("section")?.id}`);
        for (let j = 0; j < k; ++j) if (overlap(boxes[j], boxes[k])) told.push(`“${texts[j].textContent}” lies on “${text.textContent}” in ${figure.closest("section")?.id}`);
      });
    }
    for (const element of document.querySelectorAll("h1, h2, p, dt, dd, li, button, summary, .axis-title, .tile > span, .legend > *")) {
      if (visible(element) && element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0 && getComputedStyle(element).display !== "inline") {
        told.push(`“${element.textContent.slice(0, 40)}” needs ${element.scrollWidth} px and has ${element.clientWidth}`);
      }
    }
    if (document.documentElement.scrollWidth > window.innerWidth + 1) told.push(`the page is ${document.documentElement.scrollWidth} px wide`);
    return told;
  });
  expect.equal([...new Set(faults)].slice(0, 8).join("; "), "", `${name}: room for text`);
}

/** No text and no table sticks out of a box that holds it at its left or right, unless that box scrolls. */
async function check_boxes(page, name, expect) {
  const faults = await page.evaluate(() => {
    const told = [];
    const check = (holder, places, what) => {
      if (!holder.checkVisibility()) return;
      for (let box = holder; box.id !== "page"; box = box.parentElement) {
        const { display, overflowX, position } = getComputedStyle(box);
        const { left, right } = box.getBoundingClientRect();
        const out = Math.max(...places.map((place) => Math.max(left - place.left, place.right - right)));
        const holds = display !== "inline" && display !== "contents" && overflowX === "visible";
        if (holds && out > 1) told.push(`${what} sticks ${out.toFixed(0)} px out of ${box.tagName}.${box.className} in ${box.closest("section")?.id}`);
        if (overflowX !== "visible" || position === "absolute") return;
      }
    };
    const walker = document.createTreeWalker(document.querySelector("#page"), NodeFilter.SHOW_TEXT);
    for (let text = walker.nextNode(); text; text = walker.nextNode()) {
      if (text.data.trim() === "" || text.parentElement.closest("svg, option")) continue;
      const range = document.createRange();
      range.selectNodeContents(text);
      check(text.parentElement, [...range.getClientRects()], `“${text.data.slice(0, 40)}”`);
    }
    for (const table of document.querySelectorAll("table")) check(table.parentElement, [table.getBoundingClientRect()], `the table “${table.textContent.slice(0, 40)}”`);
    return told;
  });
  expect.equal([...new Set(faults)].slice(0, 8).join("; "), "", `${name}: text in its box`);
}

/** Boxes that scroll say so at the edge beyond which there is more; labels on a part are whole. */
async function check_edges(page, name, expect) {
  const faults = await page.evaluate(() => {
    const scrolls = [...document.querySelectorAll(".scroll")].filter((box) => box.checkVisibility());
    const unmarked = scrolls.filter((box) => (box.scrollWidth > box.clientWidth + 1) !== box.classList.contains("more-right"));
    const labels = [...document.querySelectorAll(".place")].filter((label) => label.textContent !== "" && label.checkVisibility());
    const cut = labels.filter((label) => {
      const [own, whole] = [label, label.parentElement].map((box) => box.getBoundingClientRect());
      return own.left < whole.left - 1 || own.right > whole.right + 1;
    });
    return [...unmarked.map((box) => `the table of ${box.closest("section").id} does not say whether it scrolls`), ...cut.map((label) => `the label “${label.textContent}” is cut`)];
  });
  expect.equal(faults.join("; "), "", `${name}: edges`);
}

/** Every menu opens inside the window. */
async function check_menus(page, name, expect) {
  const faults = await page.evaluate(() => [...document.querySelectorAll("details.menu")].map((menu) => {
    menu.open = true;
    menu.dispatchEvent(new Event("toggle"));
    const { left, right } = menu.querySelector(".entries").getBoundingClientRect();
    menu.open = false;
    return left >= 0 && right <= document.documentElement.clientWidth ? "" : `the menu of ${menu.closest("section").id} reaches from ${left} to ${right}`;
  }).filter(Boolean));
  expect.equal(faults.join("; "), "", `${name}: menus`);
}

/** What no reader should meet: a zero with a sign, one of many. */
async function check_wording(page, name, expect) {
  const text = await page.locator("body").innerText();
  const odd = text.match(/[−-]0(\.0+)?(?![.\d])|\b1 (bins|fibers|rods|steps|classes|intervals)\b|\bNaN\b|\bundefined\b|\binfinity\b/giu) ?? [];
  expect.equal(odd.join(", "), "", `${name}: odd wording`);
}

async function check_columns(page, name, expect) {
  const columns = await page.evaluate(() => {
    const charts = document.querySelector(".charts");
    return charts ? getComputedStyle(charts).gridTemplateColumns.split(" ").length : 0;
  });
  if (columns > 0) expect.equal(columns, name === "narrow" || name === "tablet" ? 1 : 2, `${name}: charts abreast`);
}

/** The wheel scrolls the page over a view, and zooms it only when the reader has clicked it. */
async function check_wheel(page, expect) {
  const canvas = page.locator(".stage canvas").first();
  if ((await canvas.count()) === 0) return;
  await canvas.scrollIntoViewIfNeeded();
  const area = await canvas.boundingBox();
  // A browser without a graphics card may take a second to scroll.
  const turn = async () => {
    const before = await page.evaluate(() => window.scrollY);
    await page.mouse.wheel(0, 120);
    for (let k = 0; k < 15 && (await page.evaluate(() => window.scrollY)) === before; ++k) await page.waitForTimeout(100);
    await page.waitForTimeout(300);
    return (await page.evaluate(() => window.scrollY)) - before;
  };
  await page.mouse.move(area.x + area.width / 2, area.y + area.height / 2);
  expect.that(Math.abs(await turn()) > 20, "the wheel scrolls the page over a view that is not active");
  const now = await canvas.boundingBox();
  await page.mouse.click(now.x + 12, Math.max(now.y + 30, 40));
  expect.equal(await turn(), 0, "the wheel does not scroll the page over an active view");
  await page.keyboard.press("Escape");
  expect.that(Math.abs(await turn()) > 20, "Escape gives the wheel back to the page");
}

/** On paper four charts make a page: two abreast, none higher than half of A4 between its margins. */
async function check_paper(page, expect) {
  await page.emulateMedia({ media: "print" });
  await page.setViewportSize({ width: 695, height: 1017 });
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  await settle(page);
  await check_columns(page, "print", expect);
  const heights = await page.locator(".charts > section:not(.role-wide)").evaluateAll((sections) => sections.map((section) => [section.id, section.getBoundingClientRect().height]));
  for (const [id, height] of heights) expect.that(height <= 1017 / 2, `${id}: ${height} px high on paper`);
  const pages = await page.locator(".charts").evaluateAll(([charts]) => [...(charts?.children ?? [])].reduce((counts, chart) => {
    counts[counts.length - 1] += chart.classList.contains("role-wide") ? 2 : 1;
    return chart.classList.contains("page-end") ? [...counts, 0] : counts;
  }, [0]));
  expect.that(pages.every((count) => count <= 4), `print: ${pages.join(", ")} charts on the pages`);
  await check_room(page, "print", expect);
  const pdf = await page.pdf({ preferCSSPageSize: true });
  expect.that(pdf.length > 10_000, "the page prints");
}

export async function check_look(page, name, expect) {
  if (name === "print") {
    await check_paper(page, expect);
    return;
  }
  await check_type(page, name, expect);
  await check_columns(page, name, expect);
  await page.evaluate(() => document.querySelectorAll("details.fold").forEach((folded) => { folded.open = true; }));
  await settle(page);
  await check_room(page, name, expect);
  await check_boxes(page, name, expect);
  await check_menus(page, name, expect);
  await check_edges(page, name, expect);
  await check_wording(page, name, expect);
  if (name === "wide" || name === "dark") await check_series_colours(page, name, expect);
  if (name === "wide") await check_maps(page, expect);
  if (name === "laptop") await check_wheel(page, expect);
}
