"""What a program's --help says: its commands, their options and arguments, and examples."""
import re
import subprocess
from dataclasses import dataclass, field


@dataclass
class Option:
    """An option with all of its names, or a positional argument with one."""

    names: list[str]
    value: str  # "DIR", "N"; empty for a flag
    text: str


@dataclass
class Command:
    """One command: `fiberfate run`."""

    name: str
    summary: str
    arguments: list[Option] = field(default_factory=list)
    options: list[Option] = field(default_factory=list)
    footer: str = ""


def read_help(program, *words):
    """Gives the lines that the program says of itself or of a command."""
    done = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True, timeout=60)
    return done.stdout.splitlines()


def block(lines, title):
    """Gives the lines below a heading, up to the next empty one."""
    if title not in lines:
        return []
    begin = lines.index(title) + 1
    end = next((i for i in range(begin, len(lines)) if not lines[i].strip()), len(lines))
    return lines[begin:end]


def rows(lines):
    """Splits lines of "  left   right" into pairs; lines that only continue the right side join it."""
    found = []
    for line in lines:
        left, right = line[:30].strip(), line[30:].strip()
        if line[29:30].strip():  # the left side is longer than its column
            left, right = line.strip(), ""
        if left:
            found.append([left, right])
        else:
            found[-1][1] = f"{found[-1][1]} {right}".strip()
    return found


def option_of(left, right):
    """Makes an option of "--steps N" and its text."""
    first, _, rest = left.partition(" ")
    # What CLI11 adds of ranges and of whether an option is needed is no name of a value.
    value = re.sub(r":.*|\bREQUIRED\b|\.\.\.", "", rest).strip()
    return Option(first.split(","), value, right)


def read_command(program, name, summary):
    lines = read_help(program, name)
    command = Command(name, summary)
    command.arguments = [option_of(*row) for row in rows(block(lines, "Positionals:"))]
    command.options = [option_of(*row) for row in rows(block(lines, "Options:"))]
    begin = lines.index("Options:") + 1 + len(block(lines, "Options:"))
    command.footer = "\n".join(lines[begin:]).strip()
    return command


def read_commands(program):
    """Reads all commands of the program."""
    return [read_command(program, *row) for row in rows(block(read_help(program), "Subcommands:"))]


def read_keys(program):
    """Lists the keys of all studies: "contact.friction"."""
    done = subprocess.run([program, "explain", "--markdown"], capture_output=True, text=True, check=True, timeout=60)
    keys, table = set(), ""
    for line in done.stdout.splitlines():
        if heading := re.match(r"### \[+(.*?)\]+$", line):
            table = heading[1]
        elif key := re.match(r"\| `([A-Za-z_0-9]+)` \|", line):
            keys.add(f"{table}.{key[1]}")
    return sorted(keys)
