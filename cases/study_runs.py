"""Runs the cases of a study: several at a time, each once, and on from where an earlier attempt stopped."""
import argparse
import concurrent.futures
import csv
import json
import pathlib
import subprocess


class Run:
    """Names one run: a case with a variant and overrides, and the folder of its result."""

    def __init__(self, case, folder, overrides=None, variant=None, until=None):
        self.case = pathlib.Path(case)
        self.folder = pathlib.Path(folder)
        self.overrides = overrides or {}
        self.variant = variant
        self.until = until

    def is_done(self):
        if not (self.folder / "summary.json").exists():
            return False
        return self.summary().get("stop_reason") not in ("signal", "steps_reached")

    def command(self, program):
        if any(self.folder.glob("checkpoint*")):
            return [program, "resume", str(self.folder)]
        words = [program, "run", str(self.case), "--out", str(self.folder), "--overwrite"]
        if self.variant:
            words += ["--variant", self.variant]
        for key, value in self.overrides.items():
            words += ["--set", f"{key}={json.dumps(value)}"]
        return words

    def make(self, program, threads=None):
        """Makes the result unless it is there; stops the study when the program fails."""
        if self.is_done():
            return self
        words = self.command(program) + ["--progress", "none"]
        if threads:
            words += ["--threads", str(threads)]
        if self.until:
            words += ["--until", self.until]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        print("made", self.folder, flush=True)
        return self

    def summary(self):
        return read_summary(self.folder)


def make_all(runs, program, jobs):
    """Makes the results of all runs, `jobs` at a time on one thread each, in the order given."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(lambda run: run.make(program, threads=1), runs))


def run_variants(case, arguments, variants):
    """Makes the results of some variants of a case ("": the case as it stands), and returns their folders."""
    return [Run(case, arguments.out / (variant or "case"), variant=variant).make(arguments.program).folder
            for variant in variants]


def read_arguments(description, out, jobs=None):
    """Reads the options that most studies have; `jobs` is how many runs go on at a time, for studies of many."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser, out, jobs)
    return parser.parse_args()


def add_arguments(parser, out, jobs=None):
    """Adds these options."""
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path(out))
    if jobs:
        parser.add_argument("--jobs", type=int, default=jobs, help="runs at a time, on one thread each")


def read_summary(folder):
    """Reads summary.json."""
    return json.loads((pathlib.Path(folder) / "summary.json").read_text(encoding="utf-8"))


def read_table(path):
    """Reads a table of numbers as one dictionary a row."""
    with open(path, encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def write_table(path, rows):
    """Writes dictionaries with the same keys as a table."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
