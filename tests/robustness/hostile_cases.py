#!/usr/bin/env python3
"""Runs hostile but legal cases of every study: each must end in time, with sane results or with words.

    hostile_cases.py [--share 1] [--seed 1] [--jobs 2] [--only TEXT] [--keep FOLDER] [--figure FILE]

Sane: numbers are finite, shares lie in [0, 1], traces are 1, no fiber is lost, volumes and heat balance. Prints what
must not be, and one line of figures; the exit status is 1 unless there is nothing of it. --share 0.2 takes a fifth of
the cases, drawn with the seed.
"""
import argparse
import csv
import math
import random
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import h5py
import numpy

import figure
from hostile_table import BASES, all_cases
from results import summary
from trial import PROGRAM, attempt

LONGEST = 60.0  # s of processor
# What has no value in some runs, as docs/formats says: null in summary.json, empty or nan in tables.
MAY_BE_MISSING = ("min_radius", "arrival", "fill_time", "temperature", "L_N", "L_W", "radius", "rate_constant", "last_filled", "unbreakable", "modulus_ratio",
                  "elongational_viscosity")
# What no step has told yet in the first row: how fibers move, and the forces on them.
TOLD_BY_STEPS = ("drag_power", "stress_", "_power_mean", "relative_viscosity", "N1_Pa", "N2_Pa", "unanswered_force")
SHARES = ("fraction", "share")


def numbers(value, path=""):
    """Yields (path, number) of all that a summary holds."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from numbers(one, f"{path}.{key}" if path else key)
    elif isinstance(value, list):
        for one in value:
            yield from numbers(one, path)
    elif value is None or isinstance(value, (int, float)):
        yield path, value


def tensor_fault(name, tensor):
    tensor = numpy.array(tensor, dtype=float)
    if abs(numpy.trace(tensor) - 1) > 1e-9:
        return f"the trace of {name} is off by {numpy.trace(tensor) - 1:.3g}"
    least = numpy.linalg.eigvalsh(tensor).min()
    return f"the least principal value of {name} is {least:.3g}" if least < -1e-6 else None


def summary_faults(values):
    for path, number in numbers(values):
        missing = number is None or not math.isfinite(number)
        if missing and not any(word in path for word in MAY_BE_MISSING):
            yield f"{path} is {number}"
        if not missing and any(word in path for word in SHARES) and not -1e-9 <= number <= 1 + 1e-9:
            yield f"{path} is {number}"
    for name in ("A2", "A2_number", "distribution_A2"):
        if isinstance(values.get(name), list):
            yield tensor_fault(name, values[name])
    if abs(values.get("volume_error", 0)) > 1e-6:
        yield f"volume_error is {values['volume_error']:.3g}"
    if abs(values.get("heat_error", 0)) > 0.05:
        yield f"heat_error is {values['heat_error']:.3g}"
    if values.get("L_N_m") and values["L_N_m"] > values["L_W_m"] * (1 + 1e-9):
        yield f"L_N {values['L_N_m']} is more than L_W {values['L_W_m']}"


def table_faults(folder):
    for path in sorted(folder.glob("*.csv")):
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        for number, row in enumerate(rows):
            for key, word in row.items():
                is_untold = number == 0 and any(part in key for part in TOLD_BY_STEPS)
                if is_untold or any(part in key for part in MAY_BE_MISSING) or (path.name, key) == ("places.csv", "value"):
                    continue
                if not math.isfinite(float(word or "nan")):
                    yield f"{path.name}: {key} is {word!r}"


def fiber_faults(folder, values):
    """Compares the first frame of fibers with the last: none may be lost, and no length."""
    with h5py.File(folder / "result.vtkhdf") as file:
        root = file["VTKHDF"]
        counts = root["Lines/NumberOfCells"][:]
        lengths, births = root["CellData/length"][:].astype(float), root["CellData/birth_id"][:]
    first, last = slice(0, counts[0]), slice(len(lengths) - counts[-1], len(lengths))
    if set(births[first]) != set(births[last]):
        yield "fibers are lost"
    if abs(lengths[last].sum() / lengths[first].sum() - 1) > 1e-6:
        yield f"the total length changed by {lengths[last].sum() / lengths[first].sum() - 1:.3g}"
    if "breaks" in values and counts[-1] != counts[0] + values["breaks"]:
        yield f"{counts[0]} fibers became {counts[-1]} by {values['breaks']} breaks"


def faults(study, folder):
    values = summary(folder)
    yield from summary_faults(values)
    yield from table_faults(folder)
    if study in ("shear_cell", "cluster"):
        yield from fiber_faults(folder, values)


def one_run(study, changes, folder):
    folder.mkdir(parents=True)
    (folder / "case.toml").write_text(BASES[study], encoding="utf-8")
    words = [word for change in changes for word in ("--set", change)]
    threads = [] if study in ("orientation", "attrition", "properties") else ["--threads", "1"]
    trial = attempt("run", "case.toml", "--out", "r", "--progress", "none", *threads, *words, folder=folder, longest=LONGEST)
    (folder / "words.txt").write_text(trial.output + trial.errors, encoding="utf-8")
    if trial.hung:
        return "hangs", f"more than {LONGEST:g} s"
    if trial.crashed:
        return "crashes", f"status {trial.status}: {trial.errors[-300:].strip()}"
    if trial.status in (2, 3):
        return ("refused" if trial.status == 2 else "failed in words"), None if trial.errors.strip() else "without a word"
    found = [fault for fault in faults(study, folder / "r") if fault]
    return ("insane", "; ".join(found[:4])) if found else ("sane", None)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--share", type=float, default=1, help="share of the cases")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="cases whose study and name hold this text")
    parser.add_argument("--keep", type=Path, help="where results and words go")
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    cases = [case for case in all_cases() if options.only in f"{case[0]}: {case[1]}"]
    cases = sorted(random.Random(options.seed).sample(cases, max(1, round(options.share * len(cases)))))
    counts, clean = {}, True
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.jobs) as pool:
        scratch = Path(scratch)
        ends = pool.map(lambda numbered: one_run(numbered[1][0], numbered[1][2], scratch / str(numbered[0])), enumerate(cases))
        for number, ((study, name, _), (end, fault)) in enumerate(zip(cases, ends)):
            counts.setdefault(study, {}).setdefault(end, 0)
            counts[study][end] += 1
            if fault:
                clean = False
                print(f"{study}: {name}: {end}: {fault}", flush=True)
            if options.keep:
                shutil.copytree(scratch / str(number), options.keep / f"{study} {name}", dirs_exist_ok=True)
    totals = {}
    for row in counts.values():
        for end, count in row.items():
            totals[end] = totals.get(end, 0) + count
    figures = f"{len(cases)} hostile cases: " + ", ".join(f"{count} {end}" for end, count in sorted(totals.items(), key=lambda one: -one[1]))
    if options.figure:
        figure.bars(options.figure, figures, counts)
    print(f"hostile_cases, seed {options.seed}, {Path(PROGRAM).name}:\n{figures}")
    return 0 if clean else 1


if __name__ == "__main__":
    sys.exit(main())
