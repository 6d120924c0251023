// Checks of colours: curves stay apart and scales stay ordered for readers without one kind of cones.
import { difference, kinds_of_vision, seen_lab } from "../colour_vision.mjs";

// A difference of some 2 is just seen side by side; lines apart from their legend need several times that.
const apart_among_six = 18;
const apart_among_eight = 12;

/** The first curves of every chart must be told apart by their colours alone. */
export async function check_series_colours(page, name, expect) {
  const all = await page.locator(".kind-lines .legend, .kind-scatter .legend").evaluateAll((legends) =>
    legends.map((legend) => [...legend.querySelectorAll("button")].map((button) => [button.style.getPropertyValue("--series"), button.querySelector(".mark").className])));
  for (const entries of all) {
    // A curve and its points may share a colour, two curves may not.
    const looks = entries.slice(0, 8).map((look) => look.join());
    expect.equal(new Set(looks).size, looks.length, `${name}: looks in a legend`);
  }
  const charts = all.map((entries) => [...new Set(entries.map(([colour]) => colour))].slice(0, 8));
  const longest = charts.sort((a, b) => b.length - a.length)[0] ?? [];
  for (const vision of kinds_of_vision) {
    for (let j = 1; j < longest.length; ++j) {
      for (let i = 0; i < j; ++i) {
        const wanted = j < 6 ? apart_among_six : apart_among_eight;
        const found = difference(longest[i], longest[j], vision);
        expect.that(found >= wanted, `${name}: curves ${i} and ${j} are ${found.toFixed(1)} apart for ${vision}, wanted ${wanted}`);
      }
    }
  }
}

/** Every scale that tells an order must go one way in lightness, whatever cones a reader has. */
export async function check_maps(page, expect) {
  for (const select of await page.locator("select[name=colour]").all()) {
    const options = await select.locator("option").evaluateAll((found) => found.map(({ value }) => value));
    for (const option of options.filter((value) => value !== "birth")) {
      await select.selectOption(option);
      const scene = page.locator("figure", { has: page.locator(".colour-bar") }).filter({ has: page.locator(".stage") });
      const bars = await scene.locator(".colour-bar svg").evaluateAll((found) => found.map((svg) => [...svg.querySelectorAll("rect")].map((rect) => rect.getAttribute("fill"))));
      for (const colours of bars) {
        for (const vision of kinds_of_vision) {
          const lightness = colours.map((colour) => seen_lab(colour, vision)[0]);
          const sense = Math.sign(lightness.at(-1) - lightness[0]);
          const worst = Math.min(...lightness.slice(1).map((value, k) => sense * (value - lightness[k])));
          // Bytes round: half a unit of lightness back is not seen.
          expect.that(worst > -0.8, `scale of ${option}: lightness turns back by ${worst.toFixed(2)} for ${vision}`);
        }
      }
    }
    await select.selectOption(options[0]);
  }
}
