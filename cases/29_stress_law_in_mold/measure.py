#!/usr/bin/env python3
"""Makes the synthetic measurements of case.toml: lengths of its moldings with the law of plaque.toml, and noise.

    measure.py [--program fiberfate] [--noise 0.05] [--samples 8] [--seed 1] [--write]

Prints the rows of data.lengths; --write puts them into case.toml.
"""
import pathlib
import sys
import tomllib

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from synthetic_lengths import Samples, read_arguments, summary_of, tell  # noqa: E402


def rows(arguments, case):
    samples = Samples(arguments)
    conditions = case["conditions"]
    for name, molding, length in zip(conditions["names"], conditions["moldings"], conditions["lengths"]):
        summary = summary_of(arguments.program, FOLDER / molding[0], [*molding[1:], f"fibers.length={length}"])
        for place in range(1, 5):
            texts = samples.texts(1e3 * summary[f"Loc_{place}_L_N_m"], digits=4)
            yield f'  ["{name}", "Loc.{place}", "L_N", {texts}],'


def main():
    arguments = read_arguments(__doc__)
    case = FOLDER / "case.toml"
    tell(rows(arguments, tomllib.loads(case.read_text(encoding="utf-8"))), case, arguments)


if __name__ == "__main__":
    main()
