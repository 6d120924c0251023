#!/usr/bin/env python3
"""Checks the site that site/make_site.py has built: links and anchors, titles, pictures, and that it needs no server.

Usage: check_site.py HTML. Prints every link, picture, script or font that leads nowhere, every one that would be loaded from
elsewhere, and every page without a title, a heading or a way to it; exits with 1 when there is any.
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

LOADED = {("link", "href"), ("script", "src"), ("img", "src"), ("source", "src"), ("iframe", "src"), ("object", "data")}
STYLE = re.compile(r"url\(\s*[\"']?([^)\"']+)")
COMMAND = re.compile(r"\s*fiberfate (new|check|run|resume|report|export|import|explain) ")
CODE = re.compile(r"\.(?:cpp|hpp|c|py|toml|txt|md)\.html$")


class Page(html.parser.HTMLParser):
    """Reads the links, anchors and headings of a page."""

    def __init__(self, path):
        super().__init__()
        self.path, self.links, self.loaded, self.anchors = path, [], [], {""}
        self.title, self.headings, self.pictures_without_words, self.inside = "", 0, 0, ""
        self.commands_as_text = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        self.headings += tag == "h1"
        self.pictures_without_words += tag == "img" and "alt" not in values
        self.inside = tag
        for name, value in attributes:
            if (tag, name) in LOADED and not (tag == "link" and values.get("rel") in ("prev", "next")):
                self.loaded.append(value)
            elif tag == "a" and name == "href":
                self.links.append(value)
        self.loaded += STYLE.findall(values.get("style") or "")

    def handle_data(self, data):
        if self.inside == "title":
            self.title += data.strip()
        elif self.inside == "p" and COMMAND.match(data):
            self.commands_as_text.append(data.split("\n")[0])

    def handle_endtag(self, tag):
        self.inside = ""


def is_elsewhere(link):
    return bool(re.match(r"(?:[a-z]+:)?//", link)) or link.startswith("/")


def target_of(page, link):
    """Returns the file and the anchor that a link leads to."""
    path, _, anchor = link.partition("#")
    file = (page.path.parent / urllib.parse.unquote(path)).resolve() if path else page.path
    return (file / "index.html" if file.is_dir() else file), urllib.parse.unquote(anchor)


def check_links(page, pages):
    """Yields what is wrong with the links that a reader follows; notes the pages that they reach."""
    for link in page.links:
        if re.match(r"(https?|mailto):", link):
            continue
        if is_elsewhere(link):
            yield f"the link {link} leads out of the site"
            continue
        file, anchor = target_of(page, link)
        if not file.exists():
            yield f"the link {link} leads nowhere"
        elif anchor and file in pages and anchor not in pages[file].anchors:
            yield f"the link {link}: there is no such anchor"


def check_loaded(page):
    """Yields what a browser would not find, or would look for elsewhere."""
    for link in page.loaded:
        if link.startswith("data:"):
            continue
        if is_elsewhere(link):
            yield f"{link} would be loaded from elsewhere"
        elif not target_of(page, link)[0].exists():
            yield f"{link} is not there"


def check_page(page, pages):
    """Yields what is wrong with a page."""
    yield from check_links(page, pages)
    yield from check_loaded(page)
    if not page.title:
        yield "no title"
    if page.headings != 1:
        yield f"{page.headings} first headings"
    if page.pictures_without_words:
        yield "a picture without words in its place"
    for command in page.commands_as_text:
        yield f"a command became text (indented, it belongs to the list before it): {command}"


def check_styles(root):
    """Yields (file, what is wrong) for what style sheets load."""
    for sheet in root.rglob("*.css"):
        for link in STYLE.findall(sheet.read_text(encoding="utf-8")):
            if not link.startswith("data:") and (is_elsewhere(link) or not (sheet.parent / link).exists()):
                yield sheet, f"{link} is not there"


def reached(root, pages):
    """Returns the pages that links lead to from the first one."""
    waiting, found = [root / "index.html"], set()
    while waiting:
        path = waiting.pop()
        if path in pages and path not in found:
            found.add(path)
            waiting += [target_of(pages[path], link)[0] for link in pages[path].links if not re.match(r"[a-z]+:", link)]
    return found


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(root.rglob("*.html"))}
    found = [(page.path, what) for page in pages.values() for what in check_page(page, pages)]
    found += list(check_styles(root))
    found += [(path, "no link leads to it") for path in pages.keys() - reached(root, pages)]
    for path, what in found:
        print(f"{path.relative_to(root)}: {what}")
    links = sum(len(page.links) for page in pages.values())
    loaded = sum(len(page.loaded) for page in pages.values())
    code = sum(bool(CODE.search(path.name)) for path in pages)
    print(f"{len(pages)} pages ({code} of code), {links} links, {loaded} pictures, scripts and styles; {len(found)} problems")
    return 1 if found or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
