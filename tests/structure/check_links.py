#!/usr/bin/env python3
"""Checks what the documentation points at: links lead to files and headings that exist, and so do the sources it names.

Usage: check_links.py ROOT, the sources or the installed pages (which have no src/). Prints every dead link as
file:line: what is wrong, every page of docs/ that no other page links to, every source file that a page names and that
is not there, every row of a table "| `file` | `name` |" whose file does not contain the name, and every line of C or C++
that a page quotes from docs/examples and that is not in the example any more; exits with 1 when there is any.
"""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.*)$", re.MULTILINE)
MODULES = "base|io|microstructure|fibers|packing|dynamics|continuum|molding|calibration|keys|results|studies|app"
SOURCE = re.compile(rf"`(?:src/)?((?:{MODULES})/[\w/.]+)`")
SOURCE_AND_NAME = re.compile(rf"^\| `((?:{MODULES})/[\w/.]+)` \| `([\w:]+)` \|")


def pages(root):
    yield from sorted(root.glob("*.md"))
    for folder in ("docs", "cases"):
        yield from sorted((root / folder).rglob("*.md"))


def anchors(page):
    """Names of a page's headings as links spell them: lower case, spaces as hyphens, punctuation dropped."""
    for heading in HEADING.findall(page.read_text(encoding="utf-8")):
        yield re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def links(page):
    fenced = False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        fenced ^= line.lstrip().startswith("```")
        if not fenced:
            yield from ((number, link) for link in LINK.findall(line) if "://" not in link)


def files_named(root, name):
    """Sources that a page means by "dynamics/motion" or "dynamics/motion.hpp"; a folder stands for itself."""
    path = root / "src" / name
    return [path] if path.exists() else sorted(path.parent.glob(path.name + ".*"))


def missing_sources(root, page):
    """Yields (line, what is wrong) for the sources that a page names; guides name files that a reader is to make."""
    if page.name.startswith("adding_") or root / "docs" not in page.parents or not (root / "src").exists():
        return
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        yield from ((number, f"src/{name} does not exist") for name in SOURCE.findall(line) if not files_named(root, name))
        row = SOURCE_AND_NAME.match(line)
        path = row and root / "src" / row[1]
        if path and path.is_file() and row[2].split("::")[-1] not in path.read_text(encoding="utf-8"):
            yield number, f"src/{row[1]} does not name {row[2]}"


def misquoted(root, page):
    """Yields (line, what is wrong) for code on a page that links to examples."""
    text = page.read_text(encoding="utf-8")
    if "](../examples/" not in text:
        return
    examples = {line.strip() for example in (root / "docs/examples").iterdir() for line in example.read_text(encoding="utf-8").splitlines()}
    quotes = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("```"):
            quotes = line in ("```c", "```cpp")
        elif quotes and line.strip() not in examples | {"", "…"}:
            yield number, f"no example has the line: {line.strip()}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found, reached, count = [], set(), 0
    for page in pages(root):
        found += [f"{page.relative_to(root)}:{number}: {what}" for check in (missing_sources, misquoted)
                  for number, what in check(root, page)]
        for number, link in links(page):
            count += 1
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            if target != page:
                reached.add(target)
            if not target.exists():
                found.append(f"{page.relative_to(root)}:{number}: {link} does not exist")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                found.append(f"{page.relative_to(root)}:{number}: {link}: there is no such heading")
    found += [f"{page.relative_to(root)}:1: no page links to it"
              for page in sorted((root / "docs").rglob("*.md")) if page not in reached]
    print(*found, f"{count} links, {len(found)} problems", sep="\n")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
