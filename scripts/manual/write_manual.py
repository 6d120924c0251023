"""Writes the manual page and the completions of bash, zsh and fish from what the program says of itself:
write_manual.py PROGRAM FOLDER."""
import re
import subprocess
import sys
from pathlib import Path

import command_line
import completions
from man_page import man_page


def listed_after(text, title):
    """Reads a list of names: "Studies: shear_cell, cluster"."""
    return re.search(rf"^{title}: (.*)$", text, re.MULTILINE)[1].split(", ")


def main(program, folder):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    commands = command_line.read_commands(program)
    new = next(command for command in commands if command.name == "new")
    values = completions.Values(command_line.read_keys(program), listed_after(new.footer, "Studies"),
                                listed_after(new.footer, "Gallery"))
    said = command_line.read_help(program)
    overview = said[: next(i for i, line in enumerate(said) if line.startswith("Usage:"))]
    statuses = [status.split(" ", 1) for status in listed_after("\n".join(said).rstrip("."), "Exit status")]
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    texts = {"fiberfate.1": man_page(commands, overview, statuses, version), "fiberfate.bash": completions.bash(commands, values),
             "_fiberfate": completions.zsh(commands, values), "fiberfate.fish": completions.fish(commands, values)}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
