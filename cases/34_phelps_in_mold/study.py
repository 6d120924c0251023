#!/usr/bin/env python3
"""Compares both models along the flow (thesis figures 4.10, 4.11).

    study.py [--program fiberfate] [--out results/34_phelps_in_mold]

Writes lengths.csv and models.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import argparse
import csv
import pathlib
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
MODELS = ["unbreakable length", "Phelps-Tucker"]


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


def draw(table):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    for axis, mean in zip(axes, ("L_W", "L_N")):
        for model in MODELS:
            points = [row for row in table if row["model"] == model]
            axis.plot((1, 2, 3, 4), [row[f"{mean}_mm"] for row in points], marker="o", label=model)
        axis.set(xlabel="Loc.", ylabel=f"{mean}, mm", xticks=(1, 2, 3, 4), ylim=(0, None))
    axes[0].legend()
    figure.savefig(FOLDER / "models.png", dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/34_phelps_in_mold"))
    arguments = parser.parse_args()
    folder = run(arguments.program, arguments.out, "")
    table = [{"model": MODELS[int(row["set"])], "place": f"Loc.{int(row['place']) + 1}",
              "L_N_mm": round(1e3 * row["L_N_m"], 3), "L_W_mm": round(1e3 * row["L_W_m"], 3)}
             for row in rows(folder, "places.csv")]
    write("lengths.csv", table)
    draw(table)


if __name__ == "__main__":
    main()
