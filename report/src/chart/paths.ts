// How uPlot draws a curve: in the curve's own order and at its own x, so that loops and scatter work too.
import uPlot from "uplot";
import type { Scale, Value } from "../document";
import type { Palette } from "../palette";
import { type Curve, split_runs } from "./curves";

export interface Scales {
  x: Scale;
  y: Scale;
}

function draw_line(plot: uPlot, curve: Curve, scales: Scales): void {
  const path = new Path2D();
  for (const run of split_runs([curve.x, curve.y], [scales.x, scales.y])) {
    const [x, y] = [plot.valToPos(curve.x[run[0]!]!, "x", true), plot.valToPos(curve.y[run[0]!]!, "y", true)];
    path.moveTo(x, y);
    // A point alone between gaps would have no line: it is drawn as a dash as long as the line is wide.
    if (run.length === 1) path.lineTo(x + 2 * uPlot.pxRatio, y);
    for (const k of run) path.lineTo(plot.valToPos(curve.x[k]!, "x", true), plot.valToPos(curve.y[k]!, "y", true));
  }
  plot.ctx.stroke(path);
}

function draw_band(plot: uPlot, curve: Curve, scales: Scales): void {
  const { x, low, high } = curve;
  if (!low || !high) return;
  const path = new Path2D();
  for (const run of split_runs([x, low, high], [scales.x, scales.y, scales.y])) {
    const corner = (k: number, ys: Value[]): void => path.lineTo(plot.valToPos(x[k]!, "x", true), plot.valToPos(ys[k]!, "y", true));
    path.moveTo(plot.valToPos(x[run[0]!]!, "x", true), plot.valToPos(high[run[0]!]!, "y", true));
    for (const k of run) corner(k, high);
    for (const k of run.reverse()) corner(k, low);
    path.closePath();
  }
  plot.ctx.globalAlpha = 0.16;
  plot.ctx.fill(path);
  plot.ctx.globalAlpha = 1;
}

/** Draws the bounds of every point as a bar through it. */
function draw_bars(plot: uPlot, curve: Curve, scales: Scales): void {
  const { x, low, high } = curve;
  if (!low || !high) return;
  const path = new Path2D();
  for (const k of split_runs([x, low, high], [scales.x, scales.y, scales.y]).flat()) {
    const at = plot.valToPos(x[k]!, "x", true);
    path.moveTo(at, plot.valToPos(low[k]!, "y", true));
    path.lineTo(at, plot.valToPos(high[k]!, "y", true));
  }
  plot.ctx.lineWidth = 1.4 * uPlot.pxRatio;
  plot.ctx.stroke(path);
}

function fill_outlines(plot: uPlot, curve: Curve, scales: Scales): void {
  const path = new Path2D();
  for (const run of split_runs([curve.x, curve.y], [scales.x, scales.y])) {
    run.forEach((k, step) => {
      const [x, y] = [plot.valToPos(curve.x[k]!, "x", true), plot.valToPos(curve.y[k]!, "y", true)];
      if (step === 0) path.moveTo(x, y);
      else path.lineTo(x, y);
    });
    path.closePath();
  }
  plot.ctx.fill(path);
}

function draw_points(plot: uPlot, curve: Curve, scales: Scales): void {
  const radius = 3.2 * uPlot.pxRatio;
  plot.ctx.globalAlpha = 0.85;
  for (const k of split_runs([curve.x, curve.y], [scales.x, scales.y]).flat()) {
    plot.ctx.beginPath();
    plot.ctx.arc(plot.valToPos(curve.x[k]!, "x", true), plot.valToPos(curve.y[k]!, "y", true), radius, 0, 2 * Math.PI);
    plot.ctx.fill();
  }
  plot.ctx.globalAlpha = 1;
}

function draw_curve(plot: uPlot, curve: Curve, scales: Scales): void {
  if (curve.style === "filled") return fill_outlines(plot, curve, scales);
  if (curve.style === "points") {
    draw_bars(plot, curve, scales);
    return draw_points(plot, curve, scales);
  }
  draw_band(plot, curve, scales);
  draw_line(plot, curve, scales);
}

/** Draws all visible curves into a uPlot's canvas, clipped to its plot. */
export function draw_curves(plot: uPlot, curves: Curve[], scales: Scales, palette: Palette): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  // Points on the border are drawn whole.
  const slack = 4 * uPlot.pxRatio;
  ctx.rect(bbox.left - slack, bbox.top - slack, bbox.width + 2 * slack, bbox.height + 2 * slack);
  ctx.clip();
  for (const curve of curves) {
    if (!curve.visible) continue;
    const colour = palette.series[curve.colour % palette.series.length]!;
    ctx.strokeStyle = colour;
    ctx.fillStyle = colour;
    ctx.lineWidth = 2 * uPlot.pxRatio;
    ctx.lineJoin = "round";
    ctx.setLineDash(curve.style === "dashed" ? [6 * uPlot.pxRatio, 4 * uPlot.pxRatio] : []);
    draw_curve(plot, curve, scales);
  }
  ctx.restore();
}
