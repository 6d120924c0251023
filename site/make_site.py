#!/usr/bin/env python3
"""Makes the site: the pages of docs/, the gallery with pictures, search and equations; it opens without a server.

    make_site.py [--program FIBERFATE] OUT      build it into OUT/html; with the program, its cases get pictures
    make_site.py --missing                      print the Debian packages that are missing for that

OUT also keeps the pages that mkdocs reads and the pictures, which are drawn again only where they are out of date.
"""
import argparse
import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys

SITE = pathlib.Path(__file__).resolve().parent
ROOT = SITE.parent
MODULES = {"mkdocs": "mkdocs", "pymdownx": "python3-pymdownx", "h5py": "python3-h5py", "numpy": "python3-numpy"}
FILES = {"/usr/share/mkdocs/themes/material/base.html": "mkdocs-material",
         "/usr/share/javascript/katex/katex.min.js": "libjs-katex"}


def missing():
    """Returns the packages that are not there."""
    return [package for module, package in MODULES.items() if not importlib.util.find_spec(module)] + \
        [package for file, package in FILES.items() if not pathlib.Path(file).exists()]


def stage_pages(pages, pictures):
    """Lays out all pages; returns those that only show a file."""
    import gallery
    from staging import Stage
    stage, folders = Stage(ROOT, pages), gallery.cases(ROOT)
    for page in [*sorted((ROOT / "docs").rglob("*.md")), ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md"]:
        stage.add_page(page.relative_to(ROOT).as_posix())
    for folder in folders:
        gallery.add_case(stage, folder, pictures.get(folder.name))
        for file in [*folder.glob("*.png"), *folder.glob("*.svg")]:
            shutil.copy(file, pages / "cases" / folder.name)
    stage.write("cases/index.md", gallery.gallery(folders, pictures))
    home = (SITE / "index.md").read_text(encoding="utf-8")
    stage.write("index.md", home if pictures else home.replace(home[home.index("!["):home.index("fiberfate predicts")], ""))
    return stage.sources


def configure(out, pages):
    """Writes mkdocs' configuration."""
    from gallery import cases
    from navigation import navigation
    configuration = {"INHERIT": str(SITE / "mkdocs.yml"), "docs_dir": str(pages), "site_dir": str(out / "html"),
                     "theme": {"custom_dir": str(SITE / "theme")}, "nav": navigation(ROOT, cases(ROOT))}
    (out / "mkdocs.yml").write_text(json.dumps(configuration, indent=2), encoding="utf-8")


def run_mkdocs(out):
    """Runs mkdocs; shows what it says only when something is wrong."""
    words = [sys.executable, "-m", "mkdocs", "build", "--strict", "--clean", "-f", str(out / "mkdocs.yml")]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"mkdocs failed\n{done.stdout}{done.stderr}")


def build(out, program):
    """Builds the site."""
    import offline
    from pictures import draw_all
    pages = out / "pages"
    shutil.rmtree(pages, ignore_errors=True)
    pictures = draw_all(ROOT, program, out / "pictures") if program else {}
    sources = stage_pages(pages, pictures)
    for picture in pictures.values():
        (pages / "pictures").mkdir(exist_ok=True)
        shutil.copy(picture.file, pages / "pictures")
    offline.copy_katex(pages)
    configure(out, pages)
    run_mkdocs(out)
    offline.add_search(out / "html", {source.removesuffix(".md") + ".html" for source in sources})
    offline.take_out(out / "html")
    print(f"{len(list((out / 'html').rglob('*.html')))} pages: {out / 'html/index.html'}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="?", type=pathlib.Path)
    parser.add_argument("--program")
    parser.add_argument("--missing", action="store_true")
    options = parser.parse_args()
    if options.missing or missing():
        print(*missing())
        return 0 if options.missing else "these Debian packages are missing"
    options.out.mkdir(parents=True, exist_ok=True)
    build(options.out.resolve(), options.program)
    return 0


if __name__ == "__main__":
    sys.exit(main())
