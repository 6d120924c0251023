#!/usr/bin/env python3
"""Makes the synthetic measurements of case.toml: lengths of its moldings with a known xi, and noise.

    measure.py [--program fiberfate] [--xi 2e-3] [--noise 0.05] [--samples 8] [--seed 1] [--write]

Prints the rows of data.lengths; --write puts them into case.toml, which holds those of the default values.
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


def molded_lengths(program, molding, xi):
    """Fills one molding and gives the mean lengths at its places, m."""
    with tempfile.TemporaryDirectory() as scratch:
        words = [program, "run", str(FOLDER / molding[0]), "--out", f"{scratch}/result", "--progress", "none"]
        for change in [*molding[1:], f"law.xi={xi}"]:
            words += ["--set", change]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        summary = json.loads(pathlib.Path(scratch, "result", "summary.json").read_text(encoding="utf-8"))
    for place in (f"Loc.{number}{side}" for number in range(1, 5) for side in ("", " side")):
        for mean in ("L_N", "L_W"):
            yield place, mean, summary[f"{place.replace('.', '_').replace(' ', '_')}_{mean}_m"]


def rows(arguments, case):
    noise = random.Random(arguments.seed)
    for name, molding in zip(case["conditions"]["names"], case["conditions"]["moldings"]):
        for place, mean, length in molded_lengths(arguments.program, molding, arguments.xi):
            samples = [1e3 * length * (1 + noise.gauss(0, arguments.noise)) for _ in range(arguments.samples)]
            texts = ", ".join(f'"{sample:.3f} mm"' for sample in samples)
            yield f'  ["{name}", "{place}", "{mean}", {texts}],'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--xi", type=float, default=2e-3)
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
        file.write_text(re.sub(r"(?s)(\nlengths = \[[^\n]*\n)(.*?\n)?\]", lambda found: found[1] + measured + "\n]", text),
                        encoding="utf-8")


if __name__ == "__main__":
    main()
