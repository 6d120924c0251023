// A live chart of curves on uPlot: zoom by drag, values under the cursor, linear or logarithmic axes.
import uPlot from "uplot";
import { is_number, type Scale } from "../document";
import { lay_names } from "../figure/names";
import { chart_font, chart_height, chart_room } from "../figure/size";
import { make_ticks, write_ticks } from "../figure/ticks";
import { figure_font } from "../font";
import { write_label } from "../format";
import { current_palette, type Palette } from "../palette";
import { type Curves, fits, make_equal, range_of_x, range_of_y } from "./curves";
import { draw_curves, type Scales } from "./paths";

export interface LineChart {
  /** Draws anew after curves, scales or colours have changed. */
  rebuild: () => void;
  reset_zoom: () => void;
  /** Gives the zoomed range of x, or nothing when all is shown. */
  zoomed: () => [number, number] | undefined;
}

export interface LineChartRequest {
  host: HTMLElement;
  made: Curves;
  scales: Scales;
  moved: (x: number | undefined) => void;
}

function layout_of(made: Curves, width: number): ReturnType<typeof lay_names> | undefined {
  return made.x_names && lay_names(made.x_names, width - chart_room.left - chart_room.right, chart_font);
}

/** A picture of things is nearly as high as it is wide; names that need room take it below the plot. */
function height_of(made: Curves, width: number): number {
  if (made.equal) return Math.max(chart_height, Math.round(0.8 * width));
  return chart_height + (layout_of(made, width)?.extra ?? 0);
}

/** Lays names along x, in as many rows as they need. */
function name_axis(axis: uPlot.Axis, made: Curves, width: number): uPlot.Axis {
  const layout = layout_of(made, width);
  if (!layout) return axis;
  const names = made.x_names!.map(write_label);
  const show = (k: number): string => {
    if (k % layout.every !== 0) return "";
    return layout.arrangement === "staggered" && k % 2 === 1 ? `\n${names[k]}` : names[k]!;
  };
  return {
    ...axis,
    size: chart_room.bottom + layout.extra,
    rotate: layout.arrangement === "upright" ? -90 : 0,
    splits: () => names.map((_name, k) => k + 1),
    values: (_plot, splits) => splits.map((split) => show(split - 1)),
  };
}

function make_axis(palette: Palette, side: "x" | "y", scale: Scale): uPlot.Axis {
  return {
    stroke: palette.muted,
    font: `${chart_font}px ${figure_font}`,
    size: side === "x" ? chart_room.bottom : chart_room.left,
    grid: { show: side === "y", stroke: palette.grid, width: 1 },
    ticks: { stroke: palette.muted, width: 1, size: 5 },
    border: { show: true, stroke: palette.muted, width: 1 },
    splits: (plot, _axis, min, max) => {
      const pixels = (side === "x" ? plot.bbox.width : plot.bbox.height) / uPlot.pxRatio;
      return make_ticks(min, max, scale, Math.max(2, Math.round(pixels / (side === "x" ? 95 : 62))));
    },
    values: (_plot, splits) => write_ticks(splits),
    filter: (_plot, splits) => splits,
  };
}

/** uPlot wants one sorted x for its cursor; the curves are drawn from their own arrays. */
function make_data(request: LineChartRequest): uPlot.AlignedData {
  const every = new Set<number>();
  for (const curve of request.made.curves) {
    for (const x of curve.x) if (fits(x, request.scales.x)) every.add(x);
  }
  const sorted = [...every].sort((a, b) => a - b);
  return [sorted, sorted.map(() => null)];
}

function make_options(request: LineChartRequest, zoom: () => [number, number] | undefined): uPlot.Options {
  const palette = current_palette();
  const { made, scales, host } = request;
  const width = (): number => host.clientWidth || 640;
  const ranges = (): { x: [number, number]; y: [number, number] } => {
    const x = zoom() ?? range_of_x(made, scales.x);
    const y = range_of_y(made.curves, scales.y, ...x);
    if (!made.equal) return { x, y };
    const plot_width = width() - chart_room.left - chart_room.right;
    return make_equal(x, y, plot_width / (height_of(made, width()) - chart_room.bottom - chart_room.top));
  };
  return {
    width: width(),
    height: height_of(made, width()),
    padding: [chart_room.top, chart_room.right, 0, 0],
    legend: { show: false },
    cursor: { y: false, points: { show: false }, drag: { x: true, y: false } },
    scales: {
      x: { time: false, distr: scales.x === "log" ? 3 : 1, range: () => ranges().x },
      y: { distr: scales.y === "log" ? 3 : 1, range: () => ranges().y },
    },
    axes: [name_axis(make_axis(palette, "x", scales.x), made, width()), make_axis(palette, "y", scales.y)],
    series: [{}, { show: true, stroke: "transparent", points: { show: false } }],
    hooks: {
      draw: [(plot) => draw_curves(plot, made.curves, scales, palette)],
      setCursor: [(plot) => {
        const left = plot.cursor.left;
        const inside = is_number(left) && left >= 0;
        request.moved(inside ? plot.posToVal(left, "x") : undefined);
      }],
    },
  };
}

/** Puts a chart into its host; it follows the host's width. */
export function make_line_chart(request: LineChartRequest): LineChart {
  let plot: uPlot | undefined;
  let zoom: [number, number] | undefined;
  const build = (): void => {
    plot?.destroy();
    const options = make_options(request, () => zoom);
    // A drag selects; uPlot's own zoom would ask the ranges above, which only know ours.
    options.hooks!.setSelect = [(made) => {
      if (made.select.width < 4) return;
      const from = made.posToVal(made.select.left, "x");
      zoom = [from, made.posToVal(made.select.left + made.select.width, "x")];
      build();
    }];
    options.cursor!.drag!.setScale = false;
    options.cursor!.bind = { dblclick: () => () => { reset_zoom(); return null; } };
    plot = new uPlot(options, make_data(request), request.host);
  };
  const reset_zoom = (): void => {
    zoom = undefined;
    build();
  };
  build();
  // Names are laid out for a width, so that another width needs another axis.
  let width = request.host.clientWidth;
  new ResizeObserver(() => {
    const now = request.host.clientWidth;
    if (now === width) return;
    width = now;
    if (request.made.x_names) build();
    else plot?.setSize({ width, height: height_of(request.made, width) });
  }).observe(request.host);
  return { rebuild: build, reset_zoom, zoomed: () => zoom };
}
