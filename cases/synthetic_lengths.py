"""Makes synthetic measurements of lengths in moldings, and puts them into data.lengths of a case."""
import argparse
import json
import pathlib
import random
import re
import subprocess
import tempfile


def read_arguments(description, xi=None):
    """Reads the options of a script that measures; `xi` is the true value where the script lets it be chosen."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="fiberfate")
    if xi is not None:
        parser.add_argument("--xi", type=float, default=xi)
    parser.add_argument("--noise", type=float, default=0.05)
    parser.add_argument("--samples", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--write", action="store_true")
    return parser.parse_args()


def summary_of(program, case, changes):
    """Runs a case with changes ("key=value") in a folder of its own and returns its summary."""
    with tempfile.TemporaryDirectory() as scratch:
        words = [program, "run", str(case), "--out", f"{scratch}/result", "--progress", "none"]
        for change in changes:
            words += ["--set", change]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        return json.loads(pathlib.Path(scratch, "result", "summary.json").read_text(encoding="utf-8"))


class Samples:
    """Draws samples of a length with relative normal noise."""

    def __init__(self, arguments):
        self.noise = random.Random(arguments.seed)
        self.arguments = arguments

    def texts(self, length, digits=3):
        """Returns samples of a length in mm as they stand in a case."""
        samples = [length * (1 + self.noise.gauss(0, self.arguments.noise)) for _ in range(self.arguments.samples)]
        return ", ".join(f'"{sample:.{digits}f} mm"' for sample in samples)


def tell(rows, case, arguments):
    """Prints rows of data.lengths; with --write, puts them into the case in place of its synthetic ones."""
    measured = "\n".join(rows)
    print(measured)
    if arguments.write:
        text = case.read_text(encoding="utf-8")
        case.write_text(re.sub(r"(?s)(\nlengths = \[[^\n]*synthetic[^\n]*\n)(.*?\n)?\]",
                               lambda found: found[1] + measured + "\n]", text), encoding="utf-8")
