// Opens a report from disk in headless Chromium with the network cut and compares what it shows with its document:
//   node check_report.mjs [--modules NODE_MODULES] [--chromium PROGRAM] [--screenshot PNG] REPORT.html | --template TEMPLATE.html
// The second form puts the synthetic document of fixture.mjs into the template first.
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { browser_options, launch_browser, open_page } from "./browser.mjs";
import { Expect, plain_label } from "./checks/expect.mjs";
import { check_crowd, make_crowd } from "./checks/crowd.mjs";
import { check_fibers } from "./checks/fibers.mjs";
import { check_heatmap, check_histogram } from "./checks/histogram.mjs";
import { check_lines } from "./checks/lines.mjs";
import { check_compared_tiles, check_look, check_tiles, looks } from "./checks/page.mjs";
import { check_shell } from "./checks/shell.mjs";
import { check_comparison, check_facts, check_note, check_table } from "./checks/text.mjs";
import { fill_template } from "./fill_template.mjs";
import { make_document } from "./fixture.mjs";

const checks = {
  facts: check_facts, comparison: check_comparison, lines: check_lines, scatter: check_lines, histogram: check_histogram, table: check_table,
  heatmap: check_heatmap, fibers: check_fibers, shell: check_shell,
};

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    ...browser_options,
    template: { type: "string" },
    screenshot: { type: "string" },
  },
});

/** Opens the report and notes every error and every attempt to load something. */
function open_report(browser, file, expect, { look = {}, allowed_error = /(?!)/ } = {}) {
  return open_page(browser, file, look, (page) => {
    page.on("console", (message) => {
      const bad = message.type() === "error" && !allowed_error.test(message.text());
      if (bad) expect.that(false, `console error: ${message.text()}`);
    });
    page.on("pageerror", (error) => expect.that(false, `uncaught ${error.stack}`));
    page.on("request", (request) => {
      const own = /^(file|data|blob):/.test(request.url());
      if (!own) expect.that(false, `the page asked for ${request.url()}`);
    });
  });
}

async function check_page(page, found, expect) {
  expect.equal(await page.locator("h1").textContent(), plain_label(found.case ?? found.title), "title");
  await check_tiles(page, found, expect);
  await check_compared_tiles(page, found, expect);
  await page.evaluate(() => document.querySelectorAll("details.fold").forEach((folded) => { folded.open = true; }));
  expect.equal(await page.locator("nav a").count(), found.sections.length, "entries of the contents");
  expect.equal(await page.locator("main section").count(), found.sections.length, "sections");
  for (const section of found.sections) {
    try {
      await (checks[section.kind] ?? check_note)(page, section, expect);
    } catch (error) {
      expect.that(false, `${section.id}: the check could not go on: ${error.stack}`);
    }
  }
}

/** The page as it is read on a large screen, on a small one, at night and on paper. */
async function check_looks(browser, file, expect) {
  for (const [name, look] of Object.entries(looks)) {
    const page = await open_report(browser, file, expect, { look });
    try {
      await check_look(page, name, expect);
    } catch (error) {
      expect.that(false, `${name}: the check could not go on: ${error.stack}`);
    }
    await page.context().close();
  }
}

/** Without WebGL the page must say so and show everything else. */
async function check_without_webgl(browser, file, found, expect) {
  const page = await open_report(browser, file, expect, { allowed_error: /WebGL/ });
  await page.addInitScript(() => {
    const original = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind.startsWith("webgl") ? null : original.call(this, kind, ...rest);
    };
  });
  await page.reload();
  await page.waitForSelector("main section");
  for (const section of found.sections.filter(({ kind }) => kind === "fibers" || kind === "shell")) {
    const text = await page.locator(`[id="${section.id}"] .stage`).textContent();
    expect.that(text.includes("WebGL"), `${section.id}: the page says that WebGL is missing`);
  }
  expect.equal(await page.locator("main section").count(), found.sections.length, "sections without WebGL");
}

/** Many rods are drawn in another way than few. */
async function check_many_rods(browser, template, expect) {
  const file = join(folder, "crowd.html");
  writeFileSync(file, fill_template(readFileSync(template, "utf8"), make_crowd()));
  const page = await open_report(browser, file, expect);
  await check_crowd(page, expect);
  await page.context().close();
}

const folder = mkdtempSync(join(tmpdir(), "fiberfate-report-"));
const expect = new Expect();
try {
  let file = positionals[0] && resolve(positionals[0]);
  if (options.template) {
    file = join(folder, "report.html");
    writeFileSync(file, fill_template(readFileSync(options.template, "utf8"), make_document()));
  }
  if (!file) throw new Error("name a report, or a template with --template");
  const browser = await launch_browser(options);
  try {
    const begun = performance.now();
    const page = await open_report(browser, file, expect);
    console.log(`${(statSync(file).size / 1e6).toFixed(1)} MB, drawn after ${((performance.now() - begun) / 1e3).toFixed(1)} s`);
    const found = JSON.parse(await page.locator("#fiberfate-document").textContent());
    // Before the checks, which zoom into plots.
    if (options.screenshot) await page.screenshot({ path: options.screenshot, fullPage: true });
    await check_page(page, found, expect);
    await page.context().close();
    await check_looks(browser, file, expect);
    await check_without_webgl(browser, file, found, expect);
    if (options.template) await check_many_rods(browser, options.template, expect);
  } finally {
    await browser.close();
  }
} finally {
  rmSync(folder, { recursive: true });
}
for (const failure of expect.failures) console.log(`FAILED ${failure}`);
console.log(`${expect.passed} passed, ${expect.failures.length} failed`);
process.exitCode = expect.failures.length > 0 || expect.passed === 0 ? 1 : 0;
