#!/usr/bin/env python3
"""Makes the synthetic measurements of case.toml: lengths of its moldings with a known xi, and noise.

    measure.py [--program fiberfate] [--xi 2e-3] [--noise 0.05] [--samples 8] [--seed 1] [--write]

Prints the rows of data.lengths; --write puts them into case.toml, which holds those of the default values.
"""
import pathlib
import sys
import tomllib

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from synthetic_lengths import Samples, read_arguments, summary_of, tell  # noqa: E402


def molded_lengths(program, molding, xi):
    """Fills one molding and gives the mean lengths at its places, m."""
    summary = summary_of(program, FOLDER / molding[0], [*molding[1:], f"law.xi={xi}"])
    for place in (f"Loc.{number}{side}" for number in range(1, 5) for side in ("", " side")):
        for mean in ("L_N", "L_W"):
            yield place, mean, summary[f"{place.replace('.', '_').replace(' ', '_')}_{mean}_m"]


def rows(arguments, case):
    samples = Samples(arguments)
    for name, molding in zip(case["conditions"]["names"], case["conditions"]["moldings"]):
        for place, mean, length in molded_lengths(arguments.program, molding, arguments.xi):
            texts = samples.texts(1e3 * length)
            yield f'  ["{name}", "{place}", "{mean}", {texts}],'


def main():
    arguments = read_arguments(__doc__, xi=2e-3)
    case = FOLDER / "case.toml"
    tell(rows(arguments, tomllib.loads(case.read_text(encoding="utf-8"))), case, arguments)


if __name__ == "__main__":
    main()
