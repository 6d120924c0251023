#!/usr/bin/env python3
"""Runs a case of the gallery, shortened, and compares a few digested numbers with its expected.toml.

    run_case.py CASE_FOLDER...            compare; exit status 1 when a number is off
    run_case.py --update CASE_FOLDER...   show the differences and write the new numbers

expected.toml holds keys of summary.json, "A2.0.0" for a component, each with [value, tolerance]. What shortens the case
is the table [short] of its variants.toml; a case without one is run whole.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

PROGRAM = os.environ.get("FIBERFATE", "fiberfate")


def variant(folder):
    variants = folder / "variants.toml"
    is_shortened = variants.exists() and "short" in tomllib.loads(variants.read_text(encoding="utf-8"))
    return ["--variant", "short"] if is_shortened else []


def run(folder):
    """Runs the shortened case and returns its summary."""
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(scratch) / "result"
        words = [PROGRAM, "run", str(folder / "case.toml"), "--out", str(out), "--progress", "none", *variant(folder)]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{folder.name}: exit status {done.returncode}\n{done.stderr}")
        return json.loads((out / "summary.json").read_text(encoding="utf-8"))


def look_up(summary, path):
    for step in path.split("."):
        summary = summary[int(step) if isinstance(summary, list) else step]
    return summary


def write_value(text, path, value):
    """Replaces the value of one key and leaves the rest of the file, comments included, as it is."""
    name = re.escape(path)
    return re.sub(rf'(?m)^("?{name}"? = \[)[^,]*', rf"\g<1>{value!r}", text)


def check(folder, update):
    """Prints what differs and tells whether nothing does."""
    file = folder / "expected.toml"
    text = file.read_text(encoding="utf-8")
    summary, same = run(folder), True
    for path, (expected, tolerance) in tomllib.loads(text).items():
        found = look_up(summary, path)
        off = abs(found - expected) > tolerance
        same = same and not off
        print(f"{folder.name}: {path}: {found!r}, expected {expected!r} within {tolerance:g}{'  <-- off' if off else ''}")
        text = write_value(text, path, found)
    if update:
        file.write_text(text, encoding="utf-8")
    return same or update


def main():
    update = "--update" in sys.argv
    folders = [pathlib.Path(word) for word in sys.argv[1:] if word != "--update"]
    if not folders:
        sys.exit(__doc__)
    sys.exit(0 if all([check(folder, update) for folder in folders]) else 1)


if __name__ == "__main__":
    main()
