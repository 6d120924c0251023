// A view over time as a film or as numbered pictures, with colour bar and time in the picture.
import { make_button } from "../dom";
import { figure_font } from "../font";
import { write_label } from "../format";
import { light_palette } from "../palette";
import { download, draw_svg } from "../save";
import { make_zip, type ZipEntry } from "../zip";
import { bar_title, make_colour_bar } from "./colour_bar";
import type { ColourScale } from "./colouring";
import { make_progress, type Progress } from "./progress";
import type { Stage } from "./stage";

const pictures_per_second = 25;
const seconds = 8;
const bar_room = 150; // beside a picture of 520

export interface Animated {
  name: string;
  stage: Stage;
  scale: () => ColourScale;
  /** Shows a share of the whole time, 0 to 1, and tells the time as text. */
  show: (share: number) => string;
  /** Shares of the whole time of which pictures are taken. */
  frames: number[];
  /** Gives what brings the view back to the time that it shows now. */
  keep_place: () => () => void;
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

type Maker = (animated: Animated, progress: Progress) => Promise<Blob>;

/** Plays the whole time into a film; browsers stamp pictures with the clock, so it takes as long as the film. */
async function record_film(animated: Animated, progress: Progress): Promise<Blob> {
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
  for (let share = 0; share < 1 && !progress.cancelled();) {
    await new Promise(requestAnimationFrame);
    share = Math.min(1, (performance.now() - begin) / (1000 * seconds));
    compose(animated.show(share));
    progress.tell(share, `Recording, ${Math.ceil(seconds * (1 - share))} s left`);
  }
  recorder.stop();
  await over;
  return new Blob(chunks, { type: "video/webm" });
}

async function take_pictures(animated: Animated, progress: Progress): Promise<Blob> {
  const { picture, compose } = await make_composer(animated);
  const entries: ZipEntry[] = [];
  const { name, frames } = animated;
  for (const [k, share] of frames.entries()) {
    if (progress.cancelled()) break;
    progress.tell(k / frames.length, `Picture ${k + 1} of ${frames.length}`);
    compose(animated.show(share));
    const blob = await new Promise<Blob | null>((done) => picture.toBlob(done, "image/png"));
    if (blob) entries.push({ name: `${name}-${String(k).padStart(3, "0")}.png`, bytes: new Uint8Array(await blob.arrayBuffer()) });
  }
  return make_zip(entries);
}

/** Makes a file while the view shows how far it is, and puts the view back. */
async function save(file: string, animated: Animated, maker: Maker): Promise<void> {
  const progress = make_progress(animated.stage.canvas.parentElement!);
  const go_back = animated.keep_place();
  try {
    const blob = await maker(animated, progress);
    if (!progress.cancelled()) download(file, blob);
  } finally {
    progress.close();
    go_back();
    animated.stage.redraw();
  }
}

/** Makes the buttons that save a view over time; not every browser records films. */
export function make_animation_buttons(animated: Animated): HTMLButtonElement[] {
  const { name, frames } = animated;
  const film = make_button("Save animation", `The whole time in ${seconds} s as a WebM film; saved when it has played`, () => void save(`${name}.webm`, animated, record_film));
  const pictures = make_button("Save frames", `${frames.length} numbered PNG pictures in a ZIP file`, () => void save(`${name}.zip`, animated, take_pictures));
  return "MediaRecorder" in window ? [film, pictures] : [pictures];
}
