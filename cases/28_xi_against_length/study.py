#!/usr/bin/env python3
"""Draws the average error over xi and the optimum against L/D, coupled and not (thesis figures 4.6 to 4.9).

    study.py [--program fiberfate] [--out results/28_xi_against_length]

Writes optimum.csv and optimum.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import pathlib
import sys
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from study_runs import read_arguments, read_table, run_variants, write_table  # noqa: E402


def draw(folder, optima, names):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    sweep = read_table(folder / "sweep.csv")
    for row in optima:
        curve = [one for one in sweep if one["fit"] == row["fit"]]
        axes[0].plot([one["value"] for one in curve], [one["average_error_percent"] for one in curve],
                     "--" if row["coupled"] else "-", color=f"C{int(row['fit']) % 4}", label=names[int(row["fit"])])
    axes[0].set(xscale="log", xlabel="xi", ylabel="average error, %", ylim=(0, None))
    axes[0].legend(fontsize=8)
    for coupled, text in ((0, "not coupled"), (1, "coupled")):
        some = sorted((row for row in optima if row["coupled"] == coupled), key=lambda row: row["aspect_ratio"])
        spans = [[1e3 * (row["fitted"] - row["lower"]) for row in some], [1e3 * (row["upper"] - row["fitted"]) for row in some]]
        axes[1].errorbar([row["aspect_ratio"] for row in some], [1e3 * row["fitted"] for row in some], spans,
                         fmt="o--" if coupled else "o-", capsize=3, label=text)
    axes[1].axhline(2, color="black", lw=0.7, ls=":", label="of the fibers")
    axes[1].set(xlabel="L/D at the gates", ylabel="optimum of xi, 10$^{-3}$", ylim=(0, None))
    axes[1].legend()
    figure.savefig(FOLDER / "optimum.png", dpi=100)


def main():
    arguments = read_arguments(__doc__, "results/28_xi_against_length")
    names = tomllib.loads((FOLDER / "case.toml").read_text(encoding="utf-8"))["conditions"]["names"]
    [folder] = run_variants(FOLDER / "case.toml", arguments, [""])
    optima = read_table(folder / "optimum.csv")
    write_table(FOLDER / "optimum.csv", [{"case": names[int(row["fit"])], **{key: f"{value:.4g}" for key, value in row.items() if key != "fit"}}
                          for row in optima])
    draw(folder, optima, names)


if __name__ == "__main__":
    main()
