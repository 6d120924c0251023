// What is told about one fiber.
import { make } from "../dom";
import { write_quantity } from "../format";
import type { MeasuredFrame } from "./frame";

/** Fills a box with number, length, birth fiber and sharpest bend of a fiber. */
export function show_fiber(box: HTMLElement, measured: MeasuredFrame, fiber: number): void {
  const { frame, measures } = measured;
  const sharpest = measures.sharpest[fiber]!;
  const birth = frame.birth[fiber]!;
  const pieces = frame.birth.filter((other) => other === birth).length;
  const rods = frame.offsets[fiber + 1]! - frame.offsets[fiber]! - 1;
  const rows: [string, string][] = [
    ["fiber", String(fiber)],
    ["length", write_quantity(measures.length[fiber], "m")],
    ["rods", String(rods)],
    ["birth fiber", `${birth}${pieces > 1 ? `, now ${pieces} pieces` : ""}`],
    ["smallest radius", sharpest > 0 ? write_quantity(1 / sharpest, "m") : "straight"],
  ];
  const facts = make("dl", {});
  for (const [label, value] of rows) facts.append(make("dt", {}, label), make("dd", {}, value));
  box.dataset.fiber = String(fiber);
  box.replaceChildren(facts);
}
