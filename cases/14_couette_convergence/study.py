#!/usr/bin/env python3
"""Asks what the Couette study rests on: steps, rods, cell, check interval, contact law.

    study.py [--program fiberfate] [--out results/14_couette_convergence] [--jobs 2] [--replicas 5]

Runs the case under several numerical assumptions, each from the same clusters (seeds), and writes OUT/convergence.csv:
for each assumption the mean over the clusters of what is observed at the end, and its standard error. A result that is
there already is not run again. The reference, a fixed step of a twentieth, takes most of the time.
"""
import argparse
import math
import pathlib
import re
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from fiber_frames import hinge_radii  # noqa: E402
from study_runs import Run, add_arguments, make_all, read_table, write_table  # noqa: E402

CASE = pathlib.Path(__file__).resolve().parent / "case.toml"

# What is assumed besides the case as it stands, one change at a time.
ASSUMPTIONS = {
    "as the case": {},
    "reference: step of 15 us": {"step.control": "fixed", "step.initial": "15 us"},
    "step of 50 us": {"step.control": "fixed", "step.initial": "50 us"},
    "step of 100 us": {"step.control": "fixed", "step.initial": "100 us"},
    "step of 200 us": {"step.control": "fixed", "step.initial": "200 us"},
    "a fifth of the step's tolerance": {"step.tolerance": 0.001},
    "four times the step's tolerance": {"step.tolerance": 0.02, "step.maximum": "1 ms"},
    "two sweeps a step": {"contact.sweeps": 2},
    "rods of 0.05 mm": {"fibers.rod_length": "0.05 mm"},
    "rods of 0.2 mm": {"fibers.rod_length": "0.2 mm"},
    "100 fibers": {"fibers.count": 100, "cell.size": "0.6962 mm"},
    "1000 fibers": {"fibers.count": 1000, "cell.size": "1.5 mm"},
    "breakage checked every 0.1 ms": {"breakage.check_interval": "0.1 ms"},
    "breakage checked every 10 ms": {"breakage.check_interval": "10 ms"},
    "contact ramp of 0.5 um": {"contact.ramp": "0.5 um"},
    "contact up to 2.5 radii": {"contact.cutoff": 2.5},
    "no friction": {"contact.friction": 0},
    "probability law": {"breakage.law": "probability"},
    "probability law, every 0.1 ms": {"breakage.law": "probability", "breakage.check_interval": "0.1 ms"},
    "probability law, every 10 ms": {"breakage.law": "probability", "breakage.check_interval": "10 ms"},
    "strength law": {"breakage.law": "strength"},
}


def run_of(arguments, name, overrides, seed):
    folder = arguments.out / f"{re.sub('[^a-zA-Z0-9.]+', '_', name)}_{seed}"
    return Run(CASE, folder, {**overrides, "run.seed": seed})


def observe(run):
    """Returns what a run ends with, lengths in mm."""
    series = read_table(run.folder / "series.csv")
    summary = run.summary()
    radii = hinge_radii(run.folder, frame=-1)
    half = series[len(series) // 4]
    return {
        "L_N_0.5s_mm": 1e3 * half["L_N_m"],
        "L_N_mm": 1e3 * summary["L_N_m"],
        "L_W_mm": 1e3 * summary["L_W_m"],
        "a11": summary["A2"][0][0],
        "a12": summary["A2"][0][1],
        "contacts_per_fiber": statistics.mean(row["contacts_per_fiber"] for row in series[-5:]),
        "hinges_below_0.4mm": float((radii < 0.4e-3).mean()),
        "hinges_below_1mm": float((radii < 1e-3).mean()),
        "hinges_below_3mm": float((radii < 3e-3).mean()),
        "largest_overlap_radii": max(row["max_overlap_radii"] for row in series),
        "mean_step_us": 1e6 * summary["simulated_s"] / summary["steps"],
    }


def mean_and_error(values):
    """Returns a mean and its standard error as text."""
    error = statistics.stdev(values) / len(values) ** 0.5 if len(values) > 1 else math.nan
    return f"{statistics.mean(values):.4g}", f"{error:.2g}"


def summarise(name, observed, of_the_case):
    """Makes a row: means over the clusters, and how they differ from the case in the same clusters."""
    row = {"assumption": name, "clusters": len(observed)}
    for key in observed[0]:
        row[key], row[f"{key}_error"] = mean_and_error([one[key] for one in observed])
    for key in ("L_N_0.5s_mm", "L_N_mm", "a11"):
        changes = [one[key] - same[key] for one, same in zip(observed, of_the_case)]
        row[f"{key}_change"], row[f"{key}_change_error"] = mean_and_error(changes)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser, "results/14_couette_convergence", jobs=2)
    parser.add_argument("--replicas", type=int, default=5)
    arguments = parser.parse_args()
    chosen = ASSUMPTIONS
    # The cheap ones first.
    ordered = sorted(chosen, key=lambda name: name.startswith("reference"))
    runs = {name: [run_of(arguments, name, chosen[name], seed + 1) for seed in range(arguments.replicas)]
            for name in ordered}
    make_all([run for group in runs.values() for run in group], arguments.program, arguments.jobs)
    observed = {name: [observe(run) for run in runs[name]] for name in chosen}
    of_the_case = observed.get("as the case") or next(iter(observed.values()))
    rows = [summarise(name, observed[name], of_the_case) for name in chosen]
    write_table(arguments.out / "convergence.csv", rows)


if __name__ == "__main__":
    main()
