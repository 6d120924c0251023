// How uPlot draws a curve: in the curve's own order and at its own x, so that loops and scatter work too.
import uPlot from "uplot";
import { type Curve, fits } from "./curves";
import type { Scale } from "../document";
import type { Palette } from "../palette";

export interface Scales {
  x: Scale;
  y: Scale;
}

function trace(plot: uPlot, path: Path2D, curve: Curve, ys: (number | null)[], scales: Scales): void {
  let pen_down = false;
  ys.forEach((y, k) => {
    const x = curve.x[k];
    const drawn = fits(x, scales.x) && fits(y, scales.y);
    if (drawn) {
      const to = [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)] as const;
      if (pen_down) path.lineTo(...to);
      else path.moveTo(...to);
    }
    pen_down = drawn;
  });
}

function draw_band(plot: uPlot, curve: Curve, scales: Scales): void {
  const { low, high } = curve;
  if (!low || !high) return;
  const path = new Path2D();
  const corner = (k: number, y: number | null | undefined): void => {
    const x = curve.x[k];
    if (!fits(x, scales.x) || !fits(y, scales.y)) return;
    path.lineTo(plot.valToPos(x, "x", true), plot.valToPos(y, "y", true));
  };
  high.forEach((y, k) => corner(k, y));
  for (let k = low.length - 1; k >= 0; --k) corner(k, low[k]);
  plot.ctx.globalAlpha = 0.16;
  plot.ctx.fill(path);
  plot.ctx.globalAlpha = 1;
}

function draw_points(plot: uPlot, curve: Curve, scales: Scales): void {
  const radius = 3.2 * uPlot.pxRatio;
  plot.ctx.globalAlpha = 0.85;
  curve.y.forEach((y, k) => {
    const x = curve.x[k];
    if (!fits(x, scales.x) || !fits(y, scales.y)) return;
    plot.ctx.beginPath();
    plot.ctx.arc(plot.valToPos(x, "x", true), plot.valToPos(y, "y", true), radius, 0, 2 * Math.PI);
    plot.ctx.fill();
  });
  plot.ctx.globalAlpha = 1;
}

/** Draws all visible curves into a uPlot's canvas, clipped to its plot. */
export function draw_curves(plot: uPlot, curves: Curve[], scales: Scales, palette: Palette): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  for (const curve of curves) {
    if (!curve.visible) continue;
    const colour = palette.series[curve.colour % palette.series.length]!;
    ctx.strokeStyle = colour;
    ctx.fillStyle = colour;
    ctx.lineWidth = 2 * uPlot.pxRatio;
    ctx.lineJoin = "round";
    ctx.setLineDash(curve.style === "dashed" ? [6 * uPlot.pxRatio, 4 * uPlot.pxRatio] : []);
    draw_band(plot, curve, scales);
    if (curve.style === "points") {
      draw_points(plot, curve, scales);
      continue;
    }
    const path = new Path2D();
    trace(plot, path, curve, curve.y, scales);
    ctx.stroke(path);
  }
  ctx.restore();
}
