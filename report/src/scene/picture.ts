// The view as a picture for a paper: pixels of the scene with the colour bar beside them.
import { write_label } from "../format";
import { light_palette } from "../palette";
import { draw_svg } from "../save";
import type { ColourScale } from "./colouring";
import { bar_title, make_colour_bar } from "./colour_bar";

/** Lays the scene and its colour bar onto one white canvas. */
export async function compose_picture(scene: HTMLCanvasElement, scale: ColourScale): Promise<HTMLCanvasElement> {
  const picture = document.createElement("canvas");
  // The scene's canvas has its old size again after the first wait: everything of it is read before.
  const width_of_scene = scene.width;
  const zoom = scene.height / 520;
  picture.width = width_of_scene + 150 * zoom;
  picture.height = scene.height;
  const pen = picture.getContext("2d")!;
  pen.fillStyle = light_palette.surface;
  pen.fillRect(0, 0, picture.width, picture.height);
  pen.drawImage(scene, 0, 0);
  const svg = make_colour_bar(scale, light_palette).querySelector("svg")!;
  const image = await draw_svg(svg);
  const { width, height } = svg.viewBox.baseVal;
  const top = (picture.height - height * zoom) / 2;
  pen.drawImage(image, width_of_scene + 10 * zoom, top, width * zoom, height * zoom);
  pen.fillStyle = light_palette.ink;
  pen.font = `${14 * zoom}px ${getComputedStyle(document.body).fontFamily}`;
  pen.fillText(write_label(bar_title(scale)), width_of_scene + 10 * zoom, top + 4 * zoom);
  return picture;
}
