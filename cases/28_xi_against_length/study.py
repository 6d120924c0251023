#!/usr/bin/env python3
"""Draws the average error over xi and the optimum against L/D, coupled and not (thesis figures 4.6 to 4.9).

    study.py [--program fiberfate] [--out results/28_xi_against_length]

Writes optimum.csv and optimum.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import argparse
import csv
import pathlib
import subprocess
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent


def run(program, out, variant):
    """Runs one variant of the case ("": the case as it stands) and tells its folder."""
    folder = out / (variant or "case")
    if not (folder / "summary.json").exists():
        words = [program, "run", str(FOLDER / "case.toml"), "--out", str(folder), "--overwrite", "--progress", "none"]
        subprocess.run(words + (["--variant", variant] if variant else []), check=True)
    return folder


def rows(folder, name):
    with open(folder / name, encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def write(name, table):
    with open(FOLDER / name, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, table[0])
        writer.writeheader()
        writer.writerows(table)


def draw(folder, optima, names):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    sweep = rows(folder, "sweep.csv")
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
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/28_xi_against_length"))
    arguments = parser.parse_args()
    names = tomllib.loads((FOLDER / "case.toml").read_text(encoding="utf-8"))["conditions"]["names"]
    folder = run(arguments.program, arguments.out, "")
    optima = rows(folder, "optimum.csv")
    write("optimum.csv", [{"case": names[int(row["fit"])], **{key: f"{value:.4g}" for key, value in row.items() if key != "fit"}}
                          for row in optima])
    draw(folder, optima, names)


if __name__ == "__main__":
    main()
