// Headless Chromium for checks and screenshots: how it starts, and how it opens a report with the network cut.
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const browser_arguments = [
  "--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
];

/** Options of the command line that say where things are, for parseArgs. */
export const browser_options = {
  modules: { type: "string", default: fileURLToPath(new URL("../../report/node_modules", import.meta.url)) },
  chromium: { type: "string", default: "/usr/bin/chromium" },
};

export function launch_browser({ modules, chromium: program }) {
  const { chromium } = createRequire(join(resolve(modules), "anchor.js"))("playwright-core");
  return chromium.launch({ executablePath: program, args: browser_arguments });
}

/** Opens a report on a page that may load nothing but itself; `watch` may listen before it loads. */
export async function open_page(browser, file, context_options = {}, watch = () => {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, offline: true, ...context_options });
  context.setDefaultTimeout(120_000); // ms: without a graphics card a busy machine is slow
  const page = await context.newPage();
  watch(page);
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector("main section");
  await settle(page);
  return page;
}

/** Waits until what was changed is drawn. */
export function settle(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
