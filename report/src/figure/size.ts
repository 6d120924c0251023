// How large figures are: for a paper, for the printed page, and for the screen, where titles stand beside the figure.

export interface FigureSize {
  width: number;
  height: number;
  /** Size of the ticks' type. */
  font: number;
  /** Room around the plot for ticks and titles. */
  room: { left: number; right: number; top: number; bottom: number };
  /** Drawn into the figure, or set as text of the page beside it. */
  titles: "drawn" | "beside";
}

function with_titles(width: number, height: number, font: number): FigureSize {
  const room = { left: 6 * font, right: 1.1 * font, top: 1.1 * font, bottom: 4.2 * font };
  return { width, height, font, room, titles: "drawn" };
}

/** Of files that readers save: two columns of a journal wide. */
export const paper_size = with_titles(720, 400, 13);

/** Of the printed page: half of its width, so that four figures fill it. */
export const print_size = with_titles(420, 430, 11.5);

/** Height of all charts on the screen. */
export const chart_height = 270;
export const chart_font = 12;
/** Room around every chart on the screen, whoever draws it. */
export const chart_room = { left: 62, right: 14, top: 10, bottom: 28 };

/** Gives the size of a chart in a host of some width. */
export function screen_size(width: number, height = chart_height): FigureSize {
  return { width: Math.max(200, width), height, font: chart_font, room: chart_room, titles: "beside" };
}

/** Gives the height at which a picture of things fills most of its width. */
export function picture_size(size: FigureSize): FigureSize {
  return { ...size, height: Math.max(size.height, Math.round(0.8 * size.width)) };
}
