// Puts a document into the report's template the way the C++ program does:
//   node fill_template.mjs TEMPLATE OUT [FIBERS [FRAMES]]     the synthetic one
//   node fill_template.mjs TEMPLATE OUT REPORT.html           that of another report
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { make_document } from "./fixture.mjs";

const marker = '"@FIBERFATE_DOCUMENT@"';

/** Reads the document out of a report. */
export function read_document(file) {
  return JSON.parse(/id="fiberfate-document">(.*?)<\/script>/s.exec(readFileSync(file, "utf8"))[1]);
}

export function fill_template(template, found) {
  const parts = template.split(marker);
  if (parts.length !== 2) throw new Error(`the template must hold ${marker} exactly once`);
  return parts.join(JSON.stringify(found).replaceAll("<", "\\u003c"));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [template, out, fibers = "138", frames = "11"] = process.argv.slice(2);
  const found = fibers.endsWith(".html") ? read_document(fibers) : make_document({ fibers: Number(fibers), frames: Number(frames) });
  writeFileSync(out, fill_template(readFileSync(template, "utf8"), found));
}
