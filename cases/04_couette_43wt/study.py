#!/usr/bin/env python3
"""Makes the runs behind thesis figures 3.21 to 3.32, at both concentrations, and their tables and figures.

    study.py [--program fiberfate] [--out results/couette] [--jobs 2] [--only long table_4 ramp empirical] [--tables]

Needs python3-h5py, and python3-matplotlib for the figures. Results that are there already are not run again, and a run
that was stopped is continued. Tables and figures go beside this script.
"""
import argparse
import csv
import pathlib
import sys

import numpy as np
from figures import draw

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from fiber_frames import count_frames, fiber_lengths, frame_times, hinge_radii  # noqa: E402
from study_runs import Run, add_arguments, make_all, read_table  # noqa: E402

CASES = {"43wt": HERE / "case.toml", "30wt": HERE.parent / "05_couette_30wt" / "case.toml"}
LAWS = ("fixed", "ramp", "probability")
CONSTANTS = (250, 500, 750)  # A, N/m
RADII = (200, 250, 300)  # um
SHORT = {"run.duration": "5 s", "output.interval": "50 ms", "output.frame_interval": "5 s",
         "output.histogram_times": []}


def long_runs(out):
    """The whole experiment: 150 s with the fixed criterion, with the ramp, with ramp and probability."""
    return {f"{weight}_{law}": Run(case, out / f"{weight}_{law}", variant=None if law == "fixed" else law)
            for weight, case in CASES.items() for law in LAWS}


def short_runs(out, prefix, pairs, variant=None):
    """Five seconds at 30 % by weight with some force constants and critical radii."""
    runs = {}
    for constant, radius in pairs:
        name = f"{prefix}_{constant}_{radius}"
        overrides = {**SHORT, "contact.force_constant": f"{constant} N/m", "breakage.critical_radius": f"{radius} um"}
        runs[name] = Run(CASES["30wt"], out / name, overrides, variant)
    return runs


def parts(out):
    return {"long": long_runs(out),
            "table_4": short_runs(out, "table_4", [(a, r) for a in CONSTANTS for r in RADII]),
            "ramp": short_runs(out, "ramp", [(500, r) for r in RADII], "ramp"),
            "empirical": short_runs(out, "empirical", [(1665, 300)])}


def write_columns(name, header, rows):
    with open(HERE / name, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        writer.writerows(rows)


def at_times(series, key, times):
    """Reads a column at some times; empty beyond the end of a run."""
    known = [row["time_s"] for row in series]
    return [f"{np.interp(t, known, [row[key] for row in series]):.6g}" if t <= known[-1] + 1e-9 else "" for t in times]


def tabulate_lengths(name, runs, times):
    """L_N and L_W in m against time, a column a run."""
    columns = {"time_s": times}
    for run_name, run in runs.items():
        series = read_table(run.folder / "series.csv")
        columns[f"{run_name}_L_N_m"] = at_times(series, "L_N_m", times)
        columns[f"{run_name}_L_W_m"] = at_times(series, "L_W_m", times)
    write_columns(name, columns, zip(*columns.values()))


def tabulate_break_radii(runs, until=60, width=25e-6):
    """Shares of the breaks in the first minute by the radius at which they came (figure 3.30)."""
    edges = np.arange(100e-6, 500e-6 + width / 2, width)
    columns = {"radius_from_m": [f"{e:.4g}" for e in edges[:-1]]}
    for name, run in runs.items():
        with open(run.folder / "breaks.csv", encoding="utf-8") as file:
            radii = [float(row["radius_m"]) for row in csv.DictReader(file) if float(row["time_s"]) <= until]
        counts, _ = np.histogram(radii, edges)
        columns[name] = counts
    write_columns("break_radii.csv", columns, zip(*columns.values()))


def tabulate_near_critical(runs):
    """Hinges within 50 um of the radius at which breakage begins, against time (figure 3.31)."""
    columns = {}
    for name, run in runs.items():
        begins = 450e-6 if name.endswith("probability") else 300e-6
        low, high = (begins - 50e-6, begins) if name.endswith("probability") else (begins, begins + 50e-6)
        counts = []
        for frame in range(count_frames(run.folder)):
            radii = hinge_radii(run.folder, frame)
            counts.append(int(((radii >= low) & (radii < high)).sum()))
        columns[name] = dict(zip((round(t, 6) for t in frame_times(run.folder)), counts))
    times = sorted(set().union(*columns.values()))
    write_columns("near_critical.csv", ["time_s", *columns],
                [[t, *(columns[name].get(t, "") for name in columns)] for t in times])


def tabulate_final_lengths(runs, width=0.1e-3):
    """Fibers by length at the end (figure 3.32)."""
    edges = np.arange(0, 2.5e-3 + width / 2, width)
    columns = {"length_up_to_m": [f"{e:.4g}" for e in edges[1:]]}
    for name, run in runs.items():
        # Lengths are whole numbers of rods: a bin holds the fibers of one such number.
        lengths = fiber_lengths(run.folder, -1)
        columns[name], _ = np.histogram(lengths - 0.5 * width, edges)
    write_columns("final_lengths.csv", columns, zip(*columns.values()))


def tabulate(groups):
    if groups.get("long"):
        tabulate_lengths("lengths.csv", groups["long"], [0, 0.05, 0.1, 0.2, 0.5, 1, 2, 3, 5, 7, *range(10, 151, 5)])
        tabulate_break_radii(groups["long"])
        tabulate_near_critical(groups["long"])
        tabulate_final_lengths(groups["long"])
    early = {name: run for part in ("table_4", "ramp", "empirical") for name, run in groups.get(part, {}).items()}
    if early:
        tabulate_lengths("table_4.csv", early, [0, 0.05, 0.1, 0.2, 0.5, *np.arange(1, 5.1, 0.5)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser, "results/couette", jobs=2)
    parser.add_argument("--only", nargs="+", choices=("long", "table_4", "ramp", "empirical"))
    parser.add_argument("--tables", action="store_true", help="run nothing: tables and figures of what there is, unfinished too")
    arguments = parser.parse_args()
    groups = parts(arguments.out)
    if arguments.only:
        groups = {name: groups[name] for name in arguments.only}
    if arguments.tables:
        groups = {part: {name: run for name, run in runs.items() if (run.folder / "breaks.csv").exists()}
                  for part, runs in groups.items()}
    else:
        make_all([run for runs in groups.values() for run in runs.values()], arguments.program, arguments.jobs)
    tabulate(groups)
    draw(HERE)


if __name__ == "__main__":
    main()
