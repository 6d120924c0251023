// A live chart of curves on uPlot: zoom by drag, values under the cursor, linear or logarithmic axes.
import uPlot from "uplot";
import { is_number, type Scale } from "../document";
import { figure_font } from "../figure/frame";
import { make_ticks } from "../figure/ticks";
import { write_number } from "../format";
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

const chart_height = 340;
const picture_height = 520; // of curves with one scale for both axes
const axis_room = { x: 32, y: 64 };
const padding = { top: 10, right: 12 };

function height_of(made: Curves): number {
  return made.equal ? picture_height : chart_height;
}

function make_axis(palette: Palette, side: "x" | "y", scale: Scale): uPlot.Axis {
  return {
    stroke: palette.muted,
    font: `12px ${figure_font}`,
    size: axis_room[side],
    grid: { show: side === "y", stroke: palette.grid, width: 1 },
    ticks: { stroke: palette.muted, width: 1, size: 5 },
    border: { show: true, stroke: palette.muted, width: 1 },
    splits: (plot, _axis, min, max) => {
      const pixels = (side === "x" ? plot.bbox.width : plot.bbox.height) / uPlot.pxRatio;
      return make_ticks(min, max, scale, Math.max(2, Math.round(pixels / (side === "x" ? 95 : 62))));
    },
    values: (_plot, splits) => splits.map((split) => write_number(split)),
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
    const x = zoom() ?? range_of_x(made.curves, scales.x);
    const y = range_of_y(made.curves, scales.y, ...x);
    if (!made.equal) return { x, y };
    const plot_width = width() - axis_room.y - padding.right;
    return make_equal(x, y, plot_width / (picture_height - axis_room.x - padding.top));
  };
  return {
    width: width(),
    height: height_of(made),
    padding: [padding.top, padding.right, 0, 0],
    legend: { show: false },
    cursor: { y: false, points: { show: false }, drag: { x: true, y: false } },
    scales: {
      x: { time: false, distr: scales.x === "log" ? 3 : 1, range: () => ranges().x },
      y: { distr: scales.y === "log" ? 3 : 1, range: () => ranges().y },
    },
    axes: [make_axis(palette, "x", scales.x), make_axis(palette, "y", scales.y)],
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
  new ResizeObserver(() => plot?.setSize({ width: request.host.clientWidth, height: height_of(request.made) })).observe(request.host);
  return { rebuild: build, reset_zoom, zoomed: () => zoom };
}
