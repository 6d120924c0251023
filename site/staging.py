"""Lays out the pages of the repository for the site, so that a link that leads somewhere there leads to the same on the site."""
import pathlib
import re
import shutil

from dialect import translate

LINK = re.compile(r"(?P<head>\]\()(?P<path>[^)\s#]*)(?P<anchor>#[^)\s]*)?\)")
SHOWN_AS_IT_IS = {".png", ".svg", ".csv"}
LANGUAGES = {".cpp": "cpp", ".hpp": "cpp", ".c": "c", ".py": "python", ".toml": "toml", ".sh": "sh", ".mjs": "js"}


class Stage:
    """Copies pages from the sources into the folder that mkdocs reads, and what they lead to."""

    def __init__(self, root, pages):
        self.root, self.pages = root, pages
        self.added = set()  # pages of the repository
        self.sources = []  # pages that only show a file

    def write(self, name, text):
        """Writes a page or a file of the site."""
        path = self.pages / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def add_page(self, name):
        """Adds a page of the repository; name is its path there."""
        self.added.add(name)
        text = (self.root / name).read_text(encoding="utf-8")
        self.write(name, translate(self.with_links(name, text)))

    def with_links(self, name, text):
        """Turns links to folders and files into links to the pages of the site that show them."""
        def replace(match):
            path, anchor = match["path"], match["anchor"] or ""
            return match[0] if not path or "://" in path else f"{match['head']}{self.link_to(name, path)}{anchor})"
        parts = re.split(r"(^ *```.*?^ *```$)", text, flags=re.M | re.S)
        return "".join(part if index % 2 else LINK.sub(replace, part) for index, part in enumerate(parts))

    def link_to(self, name, path):
        """Returns the link that leads from a page to what a link of the repository leads to."""
        target = (self.root / name).parent.joinpath(path).resolve()
        if not target.exists():
            raise SystemExit(f"{name}: {path} does not exist")
        file = target.relative_to(self.root).as_posix()
        if file == "README.md":
            return path.replace("README.md", "index.md")
        if target.is_dir():
            return f"{path}/{'README.md' if (target / 'README.md').exists() else 'index.md'}"
        if target.suffix != ".md":
            return self.add_file(file, path)
        if file not in self.added and file.startswith("tests/"):
            self.add_page(file)
        return path

    def add_file(self, file, path):
        """Adds a file that a page leads to: as it is, or as a page that shows its text; returns the link to it."""
        source = self.root / file
        if source.suffix in SHOWN_AS_IT_IS:
            (self.pages / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, self.pages / file)
            return path
        if f"{file}.md" not in self.sources:
            self.sources.append(f"{file}.md")
            self.write(f"{file}.md", f"# {source.name}\n\n`{file}`\n\n{shown(source)}")
        return f"{path}.md"


def shown(file):
    """Returns a file as a block of code."""
    text = file.read_text(encoding="utf-8").rstrip("\n")
    fence = "````" if "```" in text else "```"
    return f"{fence}{LANGUAGES.get(pathlib.Path(file).suffix, 'text')}\n{text}\n{fence}\n"
