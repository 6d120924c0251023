// Takes pictures of reports as readers meet them: wide, narrow, dark, printed.
//   node take_screenshots.mjs [--modules NODE_MODULES] [--chromium PROGRAM] [--only wide,dark] OUT REPORT.html…
import { mkdirSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { parseArgs } from "node:util";
import { browser_options, launch_browser, open_page, settle } from "./browser.mjs";

const looks = {
  wide: { viewport: { width: 1500, height: 950 } },
  narrow: { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true },
  dark: { viewport: { width: 1500, height: 950 }, colorScheme: "dark" },
  print: { viewport: { width: 1280, height: 900 } },
};

/** Scrolls through the page once, so that everything has been in view and is drawn. */
async function look_through(page) {
  await page.evaluate(async () => {
    for (let top = 0; top < document.body.scrollHeight; top += 700) {
      window.scrollTo({ top, behavior: "instant" });
      await new Promise((done) => requestAnimationFrame(done));
    }
    window.scrollTo({ top: 0, behavior: "instant" });
  });
  await settle(page);
}

const tallest = 8000; // pixels: beyond, browsers that draw in software repeat the page from its top

/** Takes the whole page, in several pictures where it is too tall for one. */
async function take_pieces(page, path) {
  const [width, height, factor] = await page.evaluate(() => [document.documentElement.clientWidth, document.documentElement.scrollHeight, devicePixelRatio]);
  const step = Math.floor(tallest / factor);
  for (let top = 0, k = 1; top < height; top += step, ++k) {
    const clip = { x: 0, y: top, width, height: Math.min(step, height - top) };
    await page.screenshot({ path: `${path}${height > step ? `-${k}` : ""}.png`, fullPage: true, clip });
  }
}

const { values: options, positionals: [out, ...reports] } = parseArgs({
  allowPositionals: true, options: { ...browser_options, only: { type: "string", default: Object.keys(looks).join(",") } },
});
mkdirSync(out, { recursive: true });
const browser = await launch_browser(options);
try {
  for (const report of reports) {
    const name = basename(report) === "report.html" ? basename(dirname(resolve(report))) : basename(report, ".html");
    for (const look of options.only.split(",")) {
      const page = await open_page(browser, resolve(report), looks[look]);
      await look_through(page);
      if (look === "print") await page.pdf({ path: join(out, `${name}-print.pdf`), preferCSSPageSize: true, printBackground: true });
      else await take_pieces(page, join(out, `${name}-${look}`));
      await page.context().close();
    }
  }
} finally {
  await browser.close();
}
