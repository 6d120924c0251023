"""Turns the Markdown of the repository's pages into that of Python-Markdown, which wants more blank lines and deeper indents."""
import re

ITEM = re.compile(r"^(?P<indent> *)(?P<marker>[-*+]|\d+\.) +(?=\S)")
ROW = re.compile(r"^\s*\|")
FENCE = re.compile(r"^\s*```")
INDENT = 4  # of what belongs to an item of a list


class Translator:
    """Reads a page line by line; knows whether it is in code, in an equation, in a list, in a table."""

    def __init__(self):
        self.lines = []
        self.fenced = self.in_equation = self.in_table = False
        self.item_width = 0  # of the indent and marker of the item that is read; 0: in no list

    def part(self):
        """Makes sure that a blank line stands before what comes."""
        if self.lines and self.lines[-1].strip():
            self.lines.append("")

    def indented(self, line):
        """Gives a line that belongs to an item of a list the indent that Python-Markdown asks for."""
        width = len(line) - len(line.lstrip())
        if not self.item_width or not line.strip():
            return line
        return " " * (INDENT - self.item_width) + line if width >= self.item_width else line

    def leave_list(self, line):
        """Ends the list at a line that stands at the margin after a blank one."""
        width = len(line) - len(line.lstrip())
        if line.strip() and width < self.item_width and not self.lines[-1].strip():
            self.item_width = 0

    def read_text(self, line):
        """Reads a line that is neither code nor part of an equation."""
        item = ITEM.match(line)
        if not item:
            self.leave_list(line)
        if item and not item["indent"]:
            if not self.item_width:
                self.part()
            self.item_width = min(item.end(), INDENT)
            self.lines.append(line)
            return
        if ROW.match(line) and not self.in_table:
            self.part()
        self.in_table = bool(ROW.match(line))
        self.lines.append(self.indented(line))

    def read(self, line):
        """Reads the next line of the page."""
        if FENCE.match(line):
            if not self.fenced:
                self.leave_list(line)
            self.fenced = not self.fenced
            self.lines.append(self.indented(line))
        elif self.fenced:
            self.lines.append(self.indented(line))
        elif self.in_equation or line.startswith("$$"):
            self.read_equation(line)
        else:
            self.read_text(line)

    def read_equation(self, line):
        """Reads a line of an equation that stands by itself, and parts it from what stands around it."""
        if not self.in_equation:
            self.part()
        body = line.strip()
        ends = body.endswith("$$") and (self.in_equation or len(body) > 2)
        self.lines.append(line)
        self.in_equation = not ends
        if ends:
            self.lines.append("")


def translate(text):
    """Returns a page in the dialect of Python-Markdown."""
    translator = Translator()
    for line in text.splitlines():
        translator.read(line)
    return "\n".join(translator.lines) + "\n"
