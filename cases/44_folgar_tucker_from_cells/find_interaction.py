#!/usr/bin/env python3
"""Finds the interaction coefficient C_I of the Folgar-Tucker equation from cells of rigid fibers in steady shear.

    find_interaction.py [--program fiberfate] [--results results] [--replicas 4]

Runs the case at three concentrations and several seeds, averages A2 over the second half of each run, and finds the C_I
whose steady state has the same a11. That state comes from the distribution function itself, without a closure (study
orientation, solution.distribution = "yes"). The error is the scatter of the replicas through the slope of a11(C_I).
"""
import argparse
import csv
import json
import math
import statistics
import subprocess
from pathlib import Path

HERE = Path(__file__).parent
FRACTIONS = ("2 %", "5 %", "10 %")
LEAST, MOST = 1e-3, 0.3  # of C_I: below, a distribution function needs more harmonics than the study offers


def run(options, *words):
    done = subprocess.run([options.program, "run", *map(str, words), "--progress", "none"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(done.stderr)


def steady_components(folder):
    """Means of a11, a22 and a12 over the second half of a run."""
    with open(folder / "series.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [statistics.fmean(float(row[name]) for row in rows[len(rows) // 2:]) for name in ("a11", "a22", "a12")]


def cells(options, fraction):
    """One triple of components a replica."""
    found = []
    for seed in range(1, options.replicas + 1):
        folder = options.results / f"phi_{fraction.split()[0]}_seed_{seed}"
        if not (folder / "summary.json").exists():
            run(options, HERE / "case.toml", "--out", folder, "--overwrite", "--set", f'fibers.volume_fraction="{fraction}"',
                "--set", f"run.seed={seed}")
        found.append(steady_components(folder))
    return found


def steady_state(options, interaction):
    """The steady a11, a22, a12 of a diffusion C_I, from the distribution function."""
    folder = options.results / "steady"
    run(options, HERE / "steady.toml", "--out", folder, "--overwrite", "--set", f"diffusion.C_I={interaction:.12g}")
    a2 = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["steady_distribution_A2"]
    return [a2[0][0], a2[1][1], a2[0][1]]


def interaction_for(options, a11):
    """C_I by bisection of its logarithm: the more diffusion, the less alignment."""
    low, high = math.log(LEAST), math.log(MOST)
    if a11 >= steady_state(options, LEAST)[0]:
        return LEAST
    for _ in range(14):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if steady_state(options, math.exp(middle))[0] > a11 else (low, middle)
    return math.exp(0.5 * (low + high))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--results", type=Path, default=Path("results"))
    parser.add_argument("--replicas", type=int, default=4)
    options = parser.parse_args()
    print("phi    a11              C_I                               a22 cell / law    a12 cell / law")
    for fraction in FRACTIONS:
        replicas = cells(options, fraction)
        means = [statistics.fmean(values) for values in zip(*replicas)]
        error = statistics.stdev(values[0] for values in replicas) / math.sqrt(len(replicas))
        found = interaction_for(options, means[0])
        bounds = [interaction_for(options, means[0] + sign * error) for sign in (1, -1)]
        law = steady_state(options, found)
        told = f"below {LEAST}" if found == LEAST else f"{found:.5f} ({bounds[0]:.5f} to {bounds[1]:.5f})"
        print(f"{fraction:5s}  {means[0]:.4f} ± {error:.4f}  {told:32s}  "
              f"{means[1]:.4f} / {law[1]:.4f}   {means[2]:.4f} / {law[2]:.4f}")


if __name__ == "__main__":
    main()
