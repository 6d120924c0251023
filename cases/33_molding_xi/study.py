#!/usr/bin/env python3
"""Draws the average error over xi of the four plaques and of all together (thesis figures 4.2, 4.6).

    study.py [--program fiberfate] [--out results/33_molding_xi]

Writes optima.csv and errors.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import pathlib
import sys
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from study_runs import read_arguments, read_summary, read_table, run_variants, write_table  # noqa: E402


def draw(folders, names):
    figure, axis = plt.subplots(figsize=(7, 4), layout="constrained")
    for folder in folders:
        table = read_table(folder / "sweep.csv")
        for fit in sorted({row["fit"] for row in table}):
            curve = [row for row in table if row["fit"] == fit]
            apart = folder.name == "separately"
            axis.plot([row["value"] for row in curve], [row["average_error_percent"] for row in curve], marker=".",
                      color=f"C{int(fit)}" if apart else "black", label=names[int(fit)] if apart else "all together")
    axis.set(xscale="log", xlabel="xi", ylabel="average error, %", ylim=(0, None))
    axis.legend()
    figure.savefig(FOLDER / "errors.png", dpi=100)


def table(folders, names):
    for folder in folders:
        summary = read_summary(folder)
        for name in names if folder.name == "separately" else ["all together"]:
            key = "".join(c if c.isalnum() else "_" for c in name) + "_" if folder.name == "separately" else ""
            yield {"plaque": name, **{text: f"{summary[key + item]:.4g}" for text, item in (
                ("xi", "xi"), ("standard_error", "xi_standard_error"), ("lower", "xi_lower"), ("upper", "xi_upper"),
                ("least_error_at", "sweep_best_value"), ("least_error_percent", "sweep_best_error_percent"))}}


def main():
    arguments = read_arguments(__doc__, "results/33_molding_xi")
    names = tomllib.loads((FOLDER / "case.toml").read_text(encoding="utf-8"))["conditions"]["names"]
    folders = run_variants(FOLDER / "case.toml", arguments, ["separately", ""])
    write_table(FOLDER / "optima.csv", list(table(folders, names)))
    draw(folders, names)


if __name__ == "__main__":
    main()
