// Opens pages of the site as files, with the network cut: equations are typeset, the search finds keys, nothing is asked of a server.
//   node browse_site.mjs [--modules NODE_MODULES] [--chromium PROGRAM] [--pictures DIR] SITE
import { mkdirSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import { browser_options, launch_browser, settle } from "../report/browser.mjs";

const patience = 240000; // ms, on a machine that is busy with other tests

const complaints = [];

function expect(is_so, what) {
  if (!is_so) complaints.push(what);
}

/** Opens a page of the site in a context of its own, and complains of errors and of requests that leave the files. */
async function open_file(context, site, name) {
  const page = await context.newPage();
  page.on("request", (request) => expect(/^(file|blob|data):/.test(request.url()), `${name} asks for ${request.url()}`));
  page.on("requestfailed", (request) => complaints.push(`${name} does not get ${request.url()}`));
  page.on("pageerror", (error) => complaints.push(`${name}: ${error.message}`));
  await page.goto(pathToFileURL(join(site, name)).href);
  await settle(page);
  return page;
}

/** Counts the equations of a page, and complains of those that are not typeset, or with errors. */
async function check_equations(page, name) {
  const found = await page.evaluate(() => {
    const all = [...document.querySelectorAll(".arithmatex")];
    const errors = [...document.querySelectorAll(".katex-error")].map((one) => one.title);
    const left = document.querySelector("article").cloneNode(true);
    left.querySelectorAll(".katex, pre, code").forEach((one) => one.remove());
    return { all: all.length, typeset: all.filter((one) => one.querySelector(".katex-html")).length, errors,
      dollars: left.textContent.match(/\$[^$]*\\[^$]*|\$\S+\$/g) ?? [] };
  });
  expect(found.typeset === found.all, `${name}: ${found.all - found.typeset} equations are not typeset`);
  for (const error of found.errors) complaints.push(`${name}: ${error}`);
  for (const rest of found.dollars) complaints.push(`${name}: an equation is left as text: ${rest}`);
  return found.all;
}

/** Searches for a word from a page, and complains where the page that has it is not found. */
async function check_search(context, site, [from, word, target]) {
  const page = await open_file(context, site, from);
  await page.click("[data-md-component=search-query]");
  await page.keyboard.type(word);
  const link = page.locator(`.md-search-result__item a[href*="${target}"]`).first();
  const is_found = await link.waitFor().then(() => true, () => false);
  expect(is_found, `searching ${word} from ${from} does not find ${target}`);
  if (is_found) {
    await link.click();
    await page.waitForURL((url) => url.href.includes(target));
  }
  await page.close();
}

const { values: options, positionals: [folder] } = parseArgs({
  allowPositionals: true, options: { ...browser_options, pictures: { type: "string" } },
});
const site = resolve(folder);
const theory = readdirSync(join(site, "docs/theory")).map((name) => `docs/theory/${name}`);
const searches = [
  ["index.html", "orientation_tolerance", "docs/guide/case_keys.html"],
  ["docs/theory/closures.html", "fibers.length", "docs/guide/case_keys.html"],
  ["cases/30_plaque/index.html", "plaque", "cases/30_plaque/index.html"],
];
const browser = await launch_browser(options);
try {
  const context = await browser.newContext({ viewport: { width: 1400, height: 1000 }, offline: true });
  context.setDefaultTimeout(patience);
  let equations = 0;
  for (const name of ["index.html", "cases/index.html", "cases/30_plaque/index.html", "docs/guide/case_keys.html", ...theory]) {
    const page = await open_file(context, site, name);
    equations += await check_equations(page, name);
    if (options.pictures) {
      mkdirSync(options.pictures, { recursive: true });
      await page.screenshot({ path: join(options.pictures, `${name.replaceAll("/", "_")}.png`) });
    }
    await page.close();
  }
  expect(equations > 100, `only ${equations} equations`);
  for (const search of searches) await check_search(context, site, search);
  console.log(`${theory.length + 4} pages, ${equations} equations, ${searches.length} searches`);
} finally {
  await browser.close();
}
for (const complaint of complaints) console.log(complaint);
process.exitCode = complaints.length ? 1 : 0;
