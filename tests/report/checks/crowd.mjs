// Checks a cell of many rods, whose nodes are on a grid and which is drawn as strips: rods are where the document has them.
import { read_pixels } from "./stage.mjs";

const side = 1e-3;
const rods = 21;
const rows = 15; // of fibers along x, each way: 225 fibers, 4725 rods, more than are drawn as capsules without a graphics card

function encode(array) {
  return Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64");
}

/** Straight fibers along x in a square pattern that fills the lower half of the cell only. */
function make_frame() {
  const fibers = rows * rows;
  const steps = new Uint16Array(3 * fibers * (rods + 1));
  let at = 0;
  for (let fiber = 0; fiber < fibers; ++fiber) {
    for (let node = 0; node <= rods; ++node) {
      const place = [(0.9 * node) / rods + 0.05, (0.5 * (0.5 + (fiber % rows))) / rows, (0.5 + Math.floor(fiber / rows)) / rows];
      for (const share of place) steps[at++] = Math.round(65535 * share);
    }
  }
  const count_up = Int32Array.from({ length: fibers }, (_unused, k) => k);
  return {
    time_s: 0, strain: 0, lattice: [side, 0, 0, 0, side, 0, 0, 0, side], offsets: encode(Int32Array.from({ length: fibers + 1 }, (_unused, k) => k * (rods + 1))),
    grid: { steps: encode(steps), corner: [0, 0, 0], step: [side / 65535, side / 65535, side / 65535] },
    birth: encode(count_up), birth_node: encode(new Int32Array(fibers)), radius: encode(new Float32Array(fibers).fill(9.5e-6)),
  };
}

export function make_crowd() {
  const nothing = { time_s: "", birth: "", node: "" };
  const caption = "Of this large result the picture shows 40 of 200 frames and every second fiber.";
  return { schema: 2, title: "A crowd", sections: [{ kind: "fibers", id: "cell", title: "The cell", caption, frames: [make_frame()], breaks: nothing }] };
}

/** Counts what is drawn in the upper and lower third of the picture. */
function count_by_height(stage) {
  return stage.evaluate((element) => {
    const canvas = element.querySelector("canvas");
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const pen = copy.getContext("2d");
    pen.drawImage(canvas, 0, 0);
    const count = (top) => pen.getImageData(0, top, copy.width, Math.floor(copy.height / 3)).data.filter((value, k) => k % 4 === 3 && value > 250).length;
    return { above: count(0), below: count(Math.floor((2 * copy.height) / 3)) };
  });
}

export async function check_crowd(page, expect) {
  const stage = page.locator("#cell .stage");
  const pixels = await read_pixels(stage);
  const data = await stage.evaluate((element) => ({ ...element.dataset }));
  expect.equal(Number(data.rods), rods * rows * rows, "crowd: rods");
  expect.equal(Number(data.triangles), 2 * Number(data.drawnRods), "crowd: a strip is two triangles");
  expect.that(pixels.count > 5000 && pixels.colours > 20, `crowd: ${pixels.count} pixels of fibers in ${pixels.colours} colours`);
  const { above, below } = await count_by_height(stage);
  expect.that(below > 4 * above, `crowd: ${below} pixels in the lower third, where fibers are, ${above} in the upper`);
  const told = await page.locator("#cell figcaption, #cell .caption").first().textContent();
  expect.that(told.includes("every second fiber"), `crowd: the choice is told (${told})`);
}
