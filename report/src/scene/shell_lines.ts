// Lines on a part, such as weld lines: smooth, a few pixels wide, and there from when the melt has come.
import { Color } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { ShellLines } from "../document";
import { decode_base64 } from "./frame";
import { chain_edges } from "./line_chains";
import type { ShellData } from "./shell";

export interface MarkLines {
  lines: LineSegments2;
  set_time: (time: number) => void;
}

/** Looks the fill time of a node up by its place; a point that is no node is there from the start. */
function times_by_place(data: ShellData): (point: [number, number, number]) => number {
  const times = new Map<string, number>();
  for (let node = 0; node < data.nodes; ++node) times.set(data.points.subarray(3 * node, 3 * node + 3).join(), data.fill_time[node]!);
  return (point) => times.get(point.join()) ?? 0;
}

export function make_mark_lines(marks: ShellLines, data: ShellData, factor: number): MarkLines {
  const pieces: { ends: number[]; time: number }[] = [];
  for (const { points, times } of chain_edges(new Float32Array(decode_base64(marks.segments)), times_by_place(data))) {
    for (let k = 0; k + 1 < points.length; ++k) {
      pieces.push({ ends: [...points[k]!, ...points[k + 1]!], time: Math.max(times[k]!, times[k + 1]!) });
    }
  }
  // In the order in which they appear, so that those before a time are the first of them.
  pieces.sort((a, b) => a.time - b.time);
  const geometry = new LineSegmentsGeometry().setPositions(pieces.flatMap(({ ends }) => ends.map((value) => value * factor)));
  const colour = new Color().setStyle("#e0245e", "srgb-linear");
  const lines = new LineSegments2(geometry, new LineMaterial({ color: colour, linewidth: 3, depthTest: false }));
  lines.renderOrder = 1;
  lines.frustumCulled = false;
  const set_time = (time: number): void => {
    const later = pieces.findIndex((piece) => piece.time > time);
    geometry.instanceCount = later < 0 ? pieces.length : later;
  };
  return { lines, set_time };
}
