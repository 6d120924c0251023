// The entry of the report: reads the document in the page and renders it.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { read_document } from "./document";
import { make } from "./dom";
import { load_fonts } from "./font";
import { render_page } from "./page";

async function start(host: HTMLElement): Promise<void> {
  try {
    const found = read_document();
    // Charts draw their text onto a canvas: the type has to be there before them.
    await load_fonts();
    render_page(host, found);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    host.replaceChildren(make("p", { class: "note", role: "alert" }, `This report cannot be shown: ${reason}.`));
  }
}

void start(document.getElementById("page")!);
