// The entry of the report: reads the document in the page and renders it.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { read_document } from "./document";
import { make } from "./dom";
import { render_page } from "./page";

const host = document.getElementById("page")!;
try {
  render_page(host, read_document());
} catch (error) {
  const reason = error instanceof Error ? error.message : String(error);
  host.replaceChildren(make("p", { class: "note", role: "alert" }, `This report cannot be shown: ${reason}.`));
}
