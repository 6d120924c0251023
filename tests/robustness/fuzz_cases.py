#!/usr/bin/env python3
"""Checks many malformed cases, made from the gallery's with a seed: each must be accepted, or refused with its place.

    fuzz_cases.py [--runs 10000] [--seed 1] [--jobs 2] [--keep FOLDER]

Prints what must not be, and one line of figures; the exit status is 1 unless there is nothing of it. Run N of a
seed is the same wherever and after whatever it runs: `--only N` repeats it.
"""
import argparse
import random
import re
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from damage import NASTY_NUMBERS, OF_BYTES, OF_LINES, damaged
from trial import PROGRAM, Tally, attempt

CASES = Path(__file__).resolve().parents[2] / "cases"
UNITS = ["", "um", "mm", "m", "s", "1/s", "Hz", "rpm", "Pa s", "MPa", "degC", "C", "K", "%", "degree", "parsnips", "kg/m^3", "m @ 5", "2 m", "s⁻¹", "µm"]
VALUES = NASTY_NUMBERS + ['"text"', '""', "[]", "[[]]", "{}", "[1, 2, 3]", '["a", 1]', "1979-05-27", "false", '"' + "x" * 5000 + '"', "[" * 70 + "]" * 70]


def change_value(text, chance):
    """Gives one key another value, of a nasty kind."""
    lines = text.split("\n")
    keys = [i for i, line in enumerate(lines) if re.match(r"\s*[\w.]+\s*=", line)]
    if not keys:
        return text
    i = chance.choice(keys)
    key = lines[i].split("=")[0]
    number = chance.choice(NASTY_NUMBERS + ["1", "20", "0.5", "1e6"])
    lines[i] = f"{key}= " + chance.choice([chance.choice(VALUES), f'"{number} {chance.choice(UNITS)}"'])
    return "\n".join(lines)


def misspell_key(text, chance):
    names = list(re.finditer(r"^\s*\[*([\w.]+)", text, re.M))
    if not names:
        return text
    name = chance.choice(names)
    at = chance.randrange(name.start(1), name.end(1))
    return text[:at] + chance.choice(["", "x", ".", "_", text[at] * 2]) + text[at + 1:]


def nest_deep(text, chance):
    depth = chance.choice([65, 1000, 10000])
    deep = chance.choice(["k = " + "[" * depth, "k = " + "{a=" * depth + "1" + "}" * depth, "[a" + ".a" * depth + "]", "a" + ".a" * depth + " = 1"])
    lines = text.split("\n")
    lines.insert(chance.randrange(len(lines) + 1), deep)
    return "\n".join(lines)


def write_long_line(text, chance):
    size = chance.choice([1000, 36000, 300000])
    long = chance.choice(["key = " + "x" * size, "k = [" + "1.5, " * (size // 5) + "2]", "k = [" + "1.5, " * (size // 5), 'k = "' + "x" * size,
                          "x" * size, "# " + "x" * size, "k = {" + "a=1, " * (size // 5) + "}"])
    return text + "\n" + long + "\n"


def mix_cases(text, chance, others):
    lines, other = text.split("\n"), chance.choice(others).split("\n")
    at, begin = chance.randrange(len(lines) + 1), chance.randrange(len(other))
    return "\n".join(lines[:at] + other[begin:begin + chance.choice([1, 5, 50])] + lines[at:])


def malformed(base, others, chance):
    """Makes one case out of one of the gallery."""
    data = base
    for _ in range(chance.choice([1, 1, 2])):
        kind = chance.randrange(10)
        if kind < 4:
            data = chance.choice([change_value, change_value, misspell_key])(data, chance)
        elif kind == 4:
            data = chance.choice([nest_deep, write_long_line])(data, chance)
        elif kind == 5:
            data = mix_cases(data, chance, others)
        else:
            return damaged(data.encode(), chance, OF_BYTES + OF_LINES)
    return data.encode()


def one_run(number, seed, gallery, folder):
    chance = random.Random(f"{seed}.{number}")
    case = chance.choice(sorted(gallery))
    path = folder / case / f"fuzzed_{number}.toml"
    path.write_bytes(malformed(gallery[case], sorted(gallery.values()), chance))
    trial = attempt("check", path.name, folder=path.parent)
    return trial, path, case


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=10000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", type=int, help="repeat this run alone and keep its case")
    parser.add_argument("--keep", type=Path, help="where cases that must not be go")
    options = parser.parse_args()
    gallery = {path.parent.name: path.read_text(encoding="utf-8") for path in sorted(CASES.glob("*/case.toml"))}
    tally = Tally()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "cases"
        shutil.copytree(CASES, folder)
        numbers = [options.only] if options.only is not None else range(options.runs)
        with ThreadPoolExecutor(options.jobs) as pool:
            for trial, path, case in pool.map(lambda n: one_run(n, options.seed, gallery, folder), numbers):
                fault = tally.count(trial, case)
                if options.only is not None:
                    print(trial.output + trial.errors)
                if (fault or options.only is not None) and options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(path, options.keep)
                path.unlink()
    print(f"fuzz_cases, seed {options.seed}, {Path(PROGRAM).name}:")
    return tally.report()


if __name__ == "__main__":
    sys.exit(main())
