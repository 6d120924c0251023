"""Reads what the pages tell a reader to type: commands of the program, and snippets of TOML and Python."""
import re
import shlex

FENCED = re.compile(r"^```(?P<language>\w*)\n(?P<text>.*?)^```$", re.M | re.S)
INDENTED = re.compile(r"(?:^ {4}.*\n)+", re.M)
COMMAND = re.compile(r"^(?:[\w./]*/)?fiberfate (?=[a-z-])")
INLINE = re.compile(r"`fiberfate (explain [a-z_0-9.]+|[a-z]+ --help)`")


def pages(root):
    """Yields the pages whose commands a reader follows; the guides adding_*.md have a test of their own."""
    yield from (root / "README.md", root / "site/index.md")
    yield from (page for page in sorted((root / "docs").rglob("*.md")) if not page.name.startswith("adding_"))
    yield from sorted((root / "cases").glob("*/README.md"))


def snippets(page, language):
    """Returns the fenced blocks of a language."""
    return [match["text"] for match in FENCED.finditer(page.read_text(encoding="utf-8")) if match["language"] == language]


def commands(page):
    """Returns the commands in the blocks of a page as lists of words without the program's name, and those in its text."""
    text = page.read_text(encoding="utf-8")
    places = [(match.start(), match["text"]) for match in FENCED.finditer(text) if match["language"] in ("", "sh")]
    places += [(match.start(), match[0]) for match in INDENTED.finditer(text)]
    found = []
    for _, block in sorted(places):
        for line in block.replace("\\\n", " ").splitlines():
            if COMMAND.match(line.strip()):
                found += split(line)
    return found, [shlex.split(words) for words in INLINE.findall(text)]


def split(line):
    """Splits a line at && into commands, without comments."""
    parts = [[]]
    for word in shlex.split(line, comments=True):
        if word == "&&":
            parts.append([])
        else:
            parts[-1].append(word)
    return [part[1:] for part in parts]
