// What checks of the views in 3D share: decoding binary parts, reading pixels, moving the time slider.

/** Decodes a base64 part of the document. */
export function decode(text, Type) {
  const bytes = Buffer.from(text, "base64");
  return new Type(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
}

/** Gives the scene's pixels that are not background. */
export function read_pixels(stage) {
  return stage.evaluate((element) => new Promise((resolve) => {
    requestAnimationFrame(() => requestAnimationFrame(() => {
      const canvas = element.querySelector("canvas");
      const copy = document.createElement("canvas");
      copy.width = canvas.width;
      copy.height = canvas.height;
      const pen = copy.getContext("2d");
      pen.drawImage(canvas, 0, 0);
      const { data } = pen.getImageData(0, 0, copy.width, copy.height);
      const colours = new Set();
      let count = 0;
      let sum = 0;
      for (let k = 0; k < data.length; k += 4) {
        if (data[k + 3] < 250) continue;
        ++count;
        colours.add((data[k] << 16) | (data[k + 1] << 8) | data[k + 2]);
        sum = (sum * 31 + data[k] * 65536 + data[k + 1] * 256 + data[k + 2] + k) % 2147483647;
      }
      resolve({ count, colours: colours.size, sum });
    }));
  }));
}

/** Moves the time slider of a section to a position. */
export async function move_slider(section, index) {
  await section.locator(".player input").evaluate((input, value) => {
    input.value = String(value);
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }, index);
}
