"""Makes the site that mkdocs has built work without a server, and takes out what only servers need."""
import json
import re
import shutil

KATEX = "/usr/share/javascript/katex"
FONTS = re.compile(r"(url\(fonts/[\w-]+\.woff2\) *format\([^)]*\))(?:, *url\([^)]*\) *format\([^)]*\))*")
FOR_SERVERS = ("404.html", "sitemap.xml", "sitemap.xml.gz", "search/search_index.json")


def copy_katex(pages):
    """Copies what typesets equations, with the one kind of fonts that every browser takes."""
    katex = pages / "assets/katex"
    (katex / "fonts").mkdir(parents=True)
    shutil.copy(f"{KATEX}/katex.min.js", katex)
    with open(f"{KATEX}/katex.min.css", encoding="utf-8") as file:
        (katex / "katex.min.css").write_text(FONTS.sub(r"\1", file.read()), encoding="utf-8")
    for name in set(re.findall(r"fonts/([\w-]+\.woff2)", (katex / "katex.min.css").read_text(encoding="utf-8"))):
        shutil.copy(f"{KATEX}/fonts/{name}", katex / "fonts")


def add_search(html, left_out):
    """Writes search/offline.js, which gives the theme its index and its worker.

    Pages that were opened as files may neither fetch an index nor start a worker from a file. They may load a script, and
    start a worker from what it holds. The theme takes both from the variable __search, and a function that makes words of
    what a reader types: of fibers.length those that the index has.
    """
    index = json.loads((html / "search/search_index.json").read_text(encoding="utf-8"))
    index["docs"] = [one for one in index["docs"] if one["location"].partition("#")[0] not in left_out]
    worker = next((html / "assets/javascripts/workers").glob("search.*.min.js")).read_text(encoding="utf-8")
    worker = re.sub(r"\n//# sourceMappingURL=.*", "", worker)
    (html / "search/offline.js").write_text(
        f"var __search = {{\n  index: Promise.resolve({json.dumps(index)}),\n"
        f"  worker: URL.createObjectURL(new Blob([{json.dumps(worker)}], {{type: \"text/javascript\"}})),\n"
        "  transform: (typed) => typed.replace(/[^\\p{L}\\p{N}_]+/gu, \" \").trim(),\n};\n", encoding="utf-8")


def take_out(html):
    """Takes out what is for servers, for other languages and for debuggers of the theme."""
    for name in FOR_SERVERS:
        (html / name).unlink(missing_ok=True)
    for file in html.rglob("*.map"):
        file.unlink()
    for folder in ("assets/javascripts/lunr", "assets/javascripts/workers"):
        shutil.rmtree(html / folder, ignore_errors=True)
    for file in [*html.glob("assets/javascripts/*.js"), *html.glob("assets/stylesheets/*.css")]:
        text = re.sub(r"\n?(//# sourceMappingURL=.*|/\*# sourceMappingURL=.*?\*/)", "", file.read_text(encoding="utf-8"))
        file.write_text(text, encoding="utf-8")
