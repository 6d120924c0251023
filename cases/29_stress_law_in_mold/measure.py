#!/usr/bin/env python3
"""Makes the synthetic measurements of case.toml: lengths of its moldings with the law of plaque.toml, and noise.

    measure.py [--program fiberfate] [--noise 0.05] [--samples 8] [--seed 1] [--write]

Prints the rows of data.lengths; --write puts them into case.toml.
"""
import argparse
import json
import pathlib
import random
import re
import subprocess
import tempfile
import tomllib

FOLDER = pathlib.Path(__file__).resolve().parent


def summary_of(program, molding, length):
    with tempfile.TemporaryDirectory() as scratch:
        words = [program, "run", str(FOLDER / molding[0]), "--out", f"{scratch}/result", "--progress", "none"]
        for change in [*molding[1:], f"fibers.length={length}"]:
            words += ["--set", change]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        return json.loads(pathlib.Path(scratch, "result", "summary.json").read_text(encoding="utf-8"))


def rows(arguments, case):
    noise = random.Random(arguments.seed)
    conditions = case["conditions"]
    for name, molding, length in zip(conditions["names"], conditions["moldings"], conditions["lengths"]):
        summary = summary_of(arguments.program, molding, length)
        for place in range(1, 5):
            true = 1e3 * summary[f"Loc_{place}_L_N_m"]
            samples = [true * (1 + noise.gauss(0, arguments.noise)) for _ in range(arguments.samples)]
            texts = ", ".join(f'"{sample:.4f} mm"' for sample in samples)
            yield f'  ["{name}", "Loc.{place}", "L_N", {texts}],'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--noise", type=float, default=0.05)
    parser.add_argument("--samples", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    file = FOLDER / "case.toml"
    text = file.read_text(encoding="utf-8")
    measured = "\n".join(rows(arguments, tomllib.loads(text)))
    print(measured)
    if arguments.write:
        file.write_text(re.sub(r"(?s)(\nlengths = \[[^\n]*synthetic[^\n]*\n)(.*?\n)?\]",
                               lambda found: found[1] + measured + "\n]", text), encoding="utf-8")


if __name__ == "__main__":
    main()
