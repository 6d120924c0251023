#!/usr/bin/env python3
"""Asks how sharp the threshold of thesis figure 3.16 is, and on what it rests.

    study.py [--program fiberfate] [--out results/06_stress_threshold] [--seeds 3]

Runs the case at four stresses under several assumptions, each with several clusters (seeds), and writes one line for each
assumption and stress to OUT/threshold.csv. A result that is there already is not run again.
"""
import argparse
import csv
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from study_runs import Run, add_arguments, read_table  # noqa: E402

CASE = pathlib.Path(__file__).resolve().parent / "case.toml"
STRESSES = (1000, 2500, 3400, 5000)  # Pa, at 200 Pa s
VISCOSITY = 200  # Pa s

# What is assumed besides the case as it stands, one change at a time.
ASSUMPTIONS = {
    "as the case": {},
    "no friction": {"contact.friction": 0},
    "no contact": {"contact.force_constant": "0 N/m"},
    "strongest fibers (119 um)": {"breakage.critical_radius": "119 um"},
    "weak fibers (300 um)": {"breakage.critical_radius": "300 um"},
    "probability law": {"breakage.law": "probability"},
    "planar in the plane of shear": {"cluster.orientation": "planar"},
    "planar in the plane of flow and vorticity": {"cluster.orientation": [0.5, 0, 0.5]},
    "rods of 0.05 mm": {"fibers.rod_length": "0.05 mm"},
    "a fifth of the step's tolerance": {"step.tolerance": 0.001},
}


def run(program, folder, overrides):
    """Runs the case once and returns its summary and the smallest radius of curvature it ever showed, m."""
    result = Run(CASE, folder, overrides).make(program, threads=1)
    return result.summary(), min(row["min_radius_m"] for row in read_table(folder / "series.csv"))


def study(arguments):
    for name, overrides in ASSUMPTIONS.items():
        for stress in STRESSES:
            breaks, lengths, radii = [], [], []
            for seed in range(1, arguments.seeds + 1):
                folder = arguments.out / f"{'_'.join(name.split())}_{stress}_{seed}"
                chosen = {**overrides, "flow.rate": f"{stress / VISCOSITY} 1/s", "run.seed": seed}
                summary, radius = run(arguments.program, folder, chosen)
                breaks.append(summary["breaks"])
                lengths.append(summary["L_N_m"])
                radii.append(radius)
            yield {"assumption": name, "stress_Pa": stress, "breaks": " ".join(map(str, breaks)),
                   "mean_breaks": round(statistics.mean(breaks), 2), "L_N_mm": round(1e3 * statistics.mean(lengths), 3),
                   "smallest_radius_um": round(1e6 * min(radii), 1)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arguments(parser, "results/06_stress_threshold")
    parser.add_argument("--seeds", type=int, default=3)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    writer = None
    with open(arguments.out / "threshold.csv", "w", encoding="utf-8", newline="") as file:
        for row in study(arguments):
            writer = writer or csv.DictWriter(file, row)
            if file.tell() == 0:
                writer.writeheader()
            writer.writerow(row)
            file.flush()
            print(", ".join(f"{key} {value}" for key, value in row.items()), flush=True)


if __name__ == "__main__":
    main()
