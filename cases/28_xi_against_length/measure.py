#!/usr/bin/env python3
"""Makes the synthetic measurements of case.toml: L_N and L_W of distributions that break class by class with one xi.

    measure.py [--program fiberfate] [--xi 2e-3] [--noise 0.05] [--samples 8] [--seed 1] [--write]

The fibers at the gates are log-normal with the L_N and L_W of thesis table 16, in 24 classes of length; what is measured is
L_N and L_W of all of them. Prints the rows of data.lengths; --write puts them into case.toml.
"""
import json
import math
import pathlib
import re
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from synthetic_lengths import Samples, read_arguments, summary_of, tell  # noqa: E402

DIAMETER = 0.019  # mm
PLAQUES = {(104, 355): "1.5 mm", (77, 269): "2 mm"}  # L/D of L_N and L_W, thickness


def classes(number_average, weight_average, count=24):
    """Gives classes [length in mm, number] with these means: log-normal numbers n, for which L_W/L_N = exp(s^2)."""
    def means(spread, centre):
        lengths = [0.1 * (30 / 0.1) ** (i / (count - 1)) for i in range(count)]
        numbers = [math.exp(-0.5 * ((math.log(length) - centre) / spread) ** 2) for length in lengths]
        first, second = (sum(n * length**k for n, length in zip(numbers, lengths)) for k in (1, 2))
        return first / sum(numbers), second / first, list(zip(lengths, numbers))

    spread, centre = math.sqrt(math.log(weight_average / number_average)), 0.0
    for _ in range(200):  # the ends of the range cut the law off a little: correct for it
        found_number, found_weight, pairs = means(spread, centre)
        centre += 0.5 * math.log(number_average / found_number)
        spread *= (weight_average / number_average / (found_weight / found_number)) ** 0.2
    assert abs(found_number / number_average - 1) < 1e-3 and abs(found_weight / weight_average - 1) < 1e-3
    return [[f"{length:.6g} mm", float(f"{number:.6g}")] for length, number in pairs]


def molded_lengths(arguments, ratios, thickness):
    """Fills the plaque with a distribution and gives both mean lengths at its places, m."""
    with tempfile.TemporaryDirectory() as scratch:
        text = (FOLDER / "plaque.toml").read_text(encoding="utf-8")
        distribution = json.dumps(classes(*(DIAMETER * ratio for ratio in ratios)))
        case = pathlib.Path(scratch, "distribution.toml")
        case.write_text(re.sub(r'(?m)^length = "1.976 mm"$', f"distribution = {distribution}", text), encoding="utf-8")
        return summary_of(arguments.program, case, [f"part.thickness={thickness}", f"law.xi={arguments.xi}"])


def rows(arguments):
    samples = Samples(arguments)
    for ratios, thickness in PLAQUES.items():
        summary = molded_lengths(arguments, ratios, thickness)
        for ratio, mean in zip(ratios, ("L_N", "L_W")):
            for place in range(1, 5):
                texts = samples.texts(1e3 * summary[f"Loc_{place}_{mean}_m"])
                for coupled in ("", " coupled"):
                    yield f'  ["L/D {ratio}{coupled}", "Loc.{place}", "{mean}", {texts}],'


def main():
    arguments = read_arguments(__doc__, xi=2e-3)
    tell(rows(arguments), FOLDER / "case.toml", arguments)


if __name__ == "__main__":
    main()
