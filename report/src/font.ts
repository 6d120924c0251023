// The one family of type of the report: shipped inside the page.
import regular from "inter-ui/web/Inter-Regular.woff2?inline";
import semibold from "inter-ui/web/Inter-SemiBold.woff2?inline";

/** The family as style sheets, canvases and figures name it; the others stand in where fonts are turned off. */
export const figure_font = "Inter, 'Helvetica Neue', Helvetica, Arial, 'DejaVu Sans', sans-serif";

const faces = [
  { source: regular, weight: "400" },
  { source: semibold, weight: "600" },
];

/** Makes the family known to the page; canvases draw text in it only after that. */
export async function load_fonts(): Promise<void> {
  const made = faces.map(({ source, weight }) => new FontFace("Inter", `url(${source})`, { weight }));
  for (const face of made) document.fonts.add(face);
  await Promise.allSettled(made.map((face) => face.load()));
}

/** Gives the rules by which a figure keeps its type while it becomes pixels. */
export function write_font_rules(): string {
  return faces.map(({ source, weight }) => `@font-face{font-family:Inter;font-weight:${weight};src:url(${source})}`).join("");
}
