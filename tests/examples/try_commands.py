#!/usr/bin/env python3
"""Tries the commands and snippets of the pages as a reader would, each page in a folder of its own.

    try_commands.py SOURCE PROGRAM

`new`, `check`, `explain` and --help are run as they stand, and so is `run` where it takes a moment. Of a longer run the case is
checked with the same variants and values, each value of a sweep too; where the page goes on with its result, its short variant
is run in its place. TOML is read, and its keys must be known; Python is run on a result. Prints what was done with every
command that was not run as it stands.
"""
import concurrent.futures
import itertools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

from page_blocks import commands, pages, snippets

# The case that a page calls case.toml, as the reader's own.
READERS_CASE = {"docs/guide/first_steps.md": "00_demo", "docs/guide/case_files.md": "11_iard_rpr"}
QUICK_STUDIES = {"orientation", "attrition", "properties", "measurement"}  # packing is quick where it has no short variant
WITHOUT_PAGE = "without the HTML report"  # what `report` says in a build without it


class Page:
    """The commands of a page, and the folder in which they are tried."""

    def __init__(self, root, program, page, folder):
        self.root, self.program, self.page = root, program, page.relative_to(root).as_posix()
        self.typed, self.inline = commands(page)
        self.notes, self.failures, self.outs = [], [], set()
        self.folder = self.prepare(page, folder)

    def prepare(self, page, folder):
        """Copies the gallery into the folder of a case's page; a guide's page gets the reader's own case."""
        if page.parent.parent.name == "cases" and self.typed:
            shutil.copytree(self.root / "cases", folder / "cases", ignore=shutil.ignore_patterns("*.png", "*.svg", "__pycache__"))
            return folder / "cases" / page.parent.name
        if self.page in READERS_CASE:
            shutil.copytree(self.root / "cases" / READERS_CASE[self.page], folder, dirs_exist_ok=True)
        return folder

    def call(self, *words):
        """Runs the program; returns its output, or nothing when it failed, which is noted."""
        words = [word.replace("$PWD", str(self.folder)) for word in words]
        done = subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True, check=False)
        if done.returncode != 0 and WITHOUT_PAGE not in done.stderr:
            self.failures.append(f"{self.page}: fiberfate {' '.join(words)}: exit status {done.returncode}\n{done.stderr}")
            return ""
        return done.stdout

    def try_all(self):
        """Tries all commands in their order, then those in the text."""
        for place, words in enumerate(self.typed):
            if words[0] == "run":
                self.try_run(words, self.typed[place + 1:])
            elif words[0] in ("report", "export") and not (self.folder / words[1]).is_dir():
                self.notes.append((words, "not run: there is no short run of its case"))
            else:
                self.call(*words)
        for words in self.inline:
            self.call(*words)
        return self

    def try_run(self, words, later):
        """Checks the case of a run with every combination of its values; runs it when it is quick, or shortened when needed."""
        kept, sweeps = options_of(words)
        case = self.folder / words[1]
        if not case.exists() and (self.root / "cases" / case.parent.name).is_dir():
            self.call("new", case.parent.name)
        for values in itertools.product(*sweeps):
            resolved = self.call("check", words[1], *kept, *(word for value in values for word in ("--set", value)))
        out = words[words.index("--out") + 1] if "--out" in words else f"results/{case.resolve().parent.name}{'_sweep' if sweeps else ''}"
        if out in self.outs:
            self.failures.append(f"{self.page}: fiberfate {' '.join(words)}: {out} holds a result of the page already")
            return
        self.outs.add(out)
        is_needed = any(out in word for command in later for word in command)
        self.run(words, shortened(resolved, case.parent), out if is_needed else "")

    def run(self, words, shorter, needed):
        """Runs a case as it stands, or what shortens it when its result is needed, or not at all."""
        if shorter == []:
            self.call(*words, "--progress", "none")
        elif shorter and (needed or "--set" in shorter):
            self.call(*words, *shorter, "--progress", "none")
            self.notes.append((words, f"run with {' '.join(shorter)}"))
        else:
            self.notes.append((words, "checked"))


def options_of(words):
    """Returns the variants and values of a run as `check` takes them, and for each sweep its values as KEY=VALUE."""
    kept, sweeps = [], []
    for option, value in zip(words, words[1:]):
        if option in ("--variant", "--set"):
            kept += [option, value]
        elif option == "--sweep":
            key, _, values = value.partition("=")
            sweeps.append([f"{key}={one}" for one in re.split(r",(?![^\[]*\])", values)])
    return kept, sweeps


def shortened(resolved, folder):
    """Returns the options that shorten a run: none where it takes a moment, None where nothing does."""
    study = re.search(r'^study = "(\w+)"', resolved, re.M)
    study = study[1] if study else ""
    if study == "calibration":
        return None if "[[" in resolved_value(resolved, "moldings") else ["--set", "fit.profiles=none"]
    variants = folder / "variants.toml"
    if variants.exists() and "[short]" in variants.read_text(encoding="utf-8"):
        return [] if study in QUICK_STUDIES else ["--variant", "short"]
    return ["--steps", "5"] if study in ("shear_cell", "rheometer", "molding") else []


def resolved_value(resolved, key):
    """Returns the value of a key of a resolved case as it stands there, or nothing."""
    found = re.search(rf"^{key} = (.*)$", resolved, re.M)
    return found[1] if found else ""


def key_names(table, above=""):
    """Yields the keys of a case."""
    for key, value in table.items():
        if isinstance(value, dict):
            yield from key_names(value, f"{above}{key}.")
        elif above + key != "study":
            yield above + key


def try_toml(root, program, page, folder):
    """Reads the TOML of a page; its keys must be known, and a whole case must pass its check beside that of 33_molding_xi."""
    trial = Page(root, program, page, folder)
    for text in snippets(page, "toml"):
        table = tomllib.loads(text)
        for key in key_names(table):
            trial.call("explain", key)
        if "study" in table:
            shutil.copytree(root / "cases/33_molding_xi", folder / "snippet")
            (folder / "snippet/case.toml").write_text(text, encoding="utf-8")
            trial.call("check", "snippet/case.toml")
    return trial.failures


def try_python(root, program, page, folder):
    """Runs the Python of a page beside a folder `result` and its report."""
    trial = Page(root, program, page, folder)
    blocks = snippets(page, "python")
    if not blocks:
        return []
    trial.call("run", str(root / "cases/01_jeffery_orbit/case.toml"), "--variant", "short", "--out", "result", "--progress", "none")
    trial.call("report", "result")
    if not (folder / "result/report.html").exists():
        blocks = [block for block in blocks if "report.html" not in block]
    for block in blocks:
        place = folder / "result" if "report.html" in block else folder
        done = subprocess.run([sys.executable, "-c", block], cwd=place, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            trial.failures.append(f"{trial.page}: {block}\n{done.stderr}")
    return trial.failures


def try_page(root, program, page):
    """Tries all of a page; returns the trial with what failed."""
    with tempfile.TemporaryDirectory() as scratch:
        folders = [pathlib.Path(scratch) / name for name in ("commands", "toml", "python")]
        for folder in folders:
            folder.mkdir()
        trial = Page(root, program, page, folders[0]).try_all()
        trial.failures += try_toml(root, program, page, folders[1]) + try_python(root, program, page, folders[2])
        return trial


def main():
    root, program = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        trials = list(pool.map(lambda page: try_page(root, program, page), pages(root)))
    for trial in trials:
        for words, note in trial.notes:
            print(f"{trial.page}: fiberfate {' '.join(words)}: {note}")
    failures = [failure for trial in trials for failure in trial.failures]
    print(*failures, sep="\n", end="\n" if failures else "")
    count = sum(len(trial.typed) + len(trial.inline) for trial in trials)
    notes = [note for trial in trials for _, note in trial.notes]
    only_checked = sum(note == "checked" for note in notes)
    print(f"{count} commands: {count - len(notes)} run as they stand, {len(notes) - only_checked} shortened or not at all, "
          f"{only_checked} checked; {len(failures)} failures")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
