#!/usr/bin/env python3
"""Checks that every page of the documentation can be reached: links lead to files and headings that exist.

Usage: check_links.py ROOT. Prints every dead link as file:line: what is wrong, and every page of docs/ that no other page
links to; exits with 1 when there is any.
"""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.*)$", re.MULTILINE)


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


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found, reached, count = [], set(), 0
    for page in pages(root):
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
