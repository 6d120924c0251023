// A view over time as a film or as numbered pictures, with colour bar and time in the picture.
import { make_button } from "../dom";
import { figure_font } from "../font";
import { write_label } from "../format";
import { light_palette } from "../palette";
import { download, draw_svg } from "../save";
import { make_zip, type ZipEntry } from "../zip";
import { bar_title, make_colour_bar } from "./colour_bar";
import type { ColourScale } from "./colouring";
import type { Stage } from "./stage";

const pictures_per_second = 25;
const seconds = 8;
const stills = 60; // numbered pictures: enough for a talk's slides
const bar_room = 150; // beside a picture of 520

export interface Animated {
  name: string;
  stage: Stage;
  scale: () => ColourScale;
  /** Shows a share of the whole time, 0 to 1, and tells the time as text. */
  show: (share: number) => string;
}

/** Lays the scene, its colour bar and the time onto a canvas, for light paper. */
async function make_composer({ stage, scale }: Animated): Promise<{ picture: HTMLCanvasElement; compose: (time: string) => void }> {
  const scene = stage.canvas;
  const zoom = scene.height / 520;
  const svg = make_colour_bar(scale(), light_palette).querySelector("svg")!;
  const image = await draw_svg(svg);
  const title = write_label(bar_title(scale()));
  const picture = document.createElement("canvas");
  // Codecs want even sizes.
  picture.width = 2 * Math.round((scene.width + bar_room * zoom) / 2);
  picture.height = 2 * Math.round(scene.height / 2);
  const pen = picture.getContext("2d")!;
  const { width, height } = svg.viewBox.baseVal;
  const top = (picture.height - height * zoom) / 2;
  const compose = (time: string): void => {
    stage.draw(light_palette);
    pen.fillStyle = light_palette.surface;
    pen.fillRect(0, 0, picture.width, picture.height);
    pen.drawImage(scene, 0, 0);
    pen.drawImage(image, scene.width + 10 * zoom, top, width * zoom, height * zoom);
    pen.fillStyle = light_palette.ink;
    pen.font = `${14 * zoom}px ${figure_font}`;
    pen.fillText(title, scene.width + 10 * zoom, top + 4 * zoom);
    pen.fillText(time, 16 * zoom, 28 * zoom);
  };
  return { picture, compose };
}

/** Plays the whole time into a film; browsers stamp pictures with the clock, so it takes as long as the film. */
async function record_film(animated: Animated): Promise<Blob> {
  const { picture, compose } = await make_composer(animated);
  const stream = picture.captureStream(pictures_per_second);
  const kind = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"].find((one) => MediaRecorder.isTypeSupported(one));
  const recorder = new MediaRecorder(stream, { mimeType: kind, videoBitsPerSecond: 8e6 });
  const chunks: Blob[] = [];
  recorder.addEventListener("dataavailable", ({ data }) => chunks.push(data));
  const over = new Promise((done) => recorder.addEventListener("stop", done));
  compose(animated.show(0));
  recorder.start();
  const begin = performance.now();
  for (let share = 0; share < 1;) {
    await new Promise(requestAnimationFrame);
    share = Math.min(1, (performance.now() - begin) / (1000 * seconds));
    compose(animated.show(share));
  }
  recorder.stop();
  await over;
  return new Blob(chunks, { type: "video/webm" });
}

async function take_pictures(animated: Animated): Promise<Blob> {
  const { picture, compose } = await make_composer(animated);
  const entries: ZipEntry[] = [];
  for (let k = 0; k < stills; ++k) {
    compose(animated.show(k / (stills - 1)));
    const blob = await new Promise<Blob | null>((done) => picture.toBlob(done, "image/png"));
    if (blob) entries.push({ name: `${animated.name}-${String(k).padStart(3, "0")}.png`, bytes: new Uint8Array(await blob.arrayBuffer()) });
  }
  return make_zip(entries);
}

/** Makes the buttons that save a view over time. */
export function make_animation_buttons(animated: Animated): HTMLButtonElement[] {
  const save = (file: string, make: (animated: Animated) => Promise<Blob>) => async (): Promise<void> => {
    const blob = await make(animated);
    animated.stage.redraw();
    download(file, blob);
  };
  const film = save(`${animated.name}.webm`, record_film);
  const pictures = save(`${animated.name}.zip`, take_pictures);
  return [
    make_button("Film as WebM", `The whole time in ${seconds} s; saved when it has played`, () => void film()),
    make_button("Film as PNG frames", `${stills} numbered pictures in a ZIP file`, () => void pictures()),
  ];
}
