#!/usr/bin/env python3
"""Writes docs/develop/validation.md from what the physics tests recorded: every exact result with the number found.

Usage: write_validation.py FOLDER. FOLDER holds the JSON that GoogleTest wrote of a run of the physics tests
(build/PRESET/validation after ctest -L physics; see tests/physics/record.hpp). Prints nothing; exits with 1, and leaves
the page as it is, when a recorded result failed or nothing was recorded.
"""
import json
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs/develop/validation.md"
HEAD = """# Validation

Exact results beside the numbers that a run of the physics tests found. `scripts/write_validation.py` makes this page from
what the tests record (`tests/physics/record.hpp`); every row is a check of its test, which states the theory and the
reason of the tolerance:

```
ctest --test-dir build/dev -L physics && python3 scripts/write_validation.py build/dev/validation
```

Where the number is an error, 0 is expected.
"""


def words(name):
    """"OfOneRodOfBeads" is "Of one rod of beads"."""
    spaced = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)
    return spaced[0] + spaced[1:].lower()


def records(path):
    """Yields (suite and test, source file, rows) of every test of one program that recorded something."""
    for suite in json.loads(path.read_text(encoding="utf-8"))["testsuites"]:
        for test in suite["testsuite"]:
            rows = [test[key].split(" | ") for key in sorted(test, key=order) if key.startswith("exact_")]
            if rows and "failures" in test:
                raise SystemExit(f"{suite['name']}.{test['name']} failed: no page is made of it")
            if rows:
                names = suite["name"].split("/")[-1], test["name"].split("/")[0]
                yield names, test["file"], rows


def order(key):
    number = key.rpartition("_")[2]
    return int(number) if number.isdigit() else -1


def source(file):
    parts = pathlib.PurePath(file).parts
    return "/".join(parts[len(parts) - 1 - parts[::-1].index("tests"):])


def sections(folder):
    """Tables by test, in the order of programs and tests; runs of one test with several parameters share a table."""
    tables = {}
    for path in sorted(folder.glob("*.json")):
        for names, file, rows in records(path):
            tables.setdefault((source(file), names), []).extend(rows)
    return tables


def main():
    tables = sections(pathlib.Path(sys.argv[1]))
    if not tables:
        raise SystemExit(f"{sys.argv[1]}: no test recorded anything; run ctest -L physics first")
    lines = [HEAD]
    for (file, (suite, test)), rows in tables.items():
        lines += [f"## {words(suite)}: {words(test).lower()}", "", f"[{file}](../../{file})", "",
                  "| | expected | found | tolerance |", "| --- | --- | --- | --- |"]
        lines += [f"| {' | '.join([name] + [short(number) for number in numbers])} |" for name, *numbers in rows] + [""]
    PAGE.write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")


def short(number):
    """Six digits are enough, and do not depend on the instruction set."""
    return f"{float(number):.6g}"


if __name__ == "__main__":
    main()
