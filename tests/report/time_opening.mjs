// Says how long a report takes to open in headless Chromium, until its picture is drawn without a graphics card.
//   node time_opening.mjs [--modules NODE_MODULES] [--chromium PROGRAM] REPORT.html…
import { statSync } from "node:fs";
import { resolve } from "node:path";
import { parseArgs } from "node:util";
import { browser_options, launch_browser, open_page } from "./browser.mjs";

const tries = 3;
const { values: options, positionals: reports } = parseArgs({ allowPositionals: true, options: browser_options });
const browser = await launch_browser(options);

/** Waits until the graphics have done what they were asked for: reading a pixel takes that long. */
function finish_picture(page) {
  return page.evaluate(() => {
    const graphics = document.querySelector(".stage canvas")?.getContext("webgl2");
    graphics?.readPixels(0, 0, 1, 1, graphics.RGBA, graphics.UNSIGNED_BYTE, new Uint8Array(4));
  });
}

try {
  for (const report of reports) {
    const seconds = [];
    for (let k = 0; k < tries; ++k) {
      const begun = performance.now();
      const page = await open_page(browser, resolve(report));
      await finish_picture(page);
      seconds.push((performance.now() - begun) / 1e3);
      await page.context().close();
    }
    console.log(`${report}: ${(statSync(report).size / 1e6).toFixed(1)} MB, drawn after ${seconds.map((one) => one.toFixed(1)).join(", ")} s`);
  }
} finally {
  await browser.close();
}
