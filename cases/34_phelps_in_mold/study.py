#!/usr/bin/env python3
"""Compares both models along the flow (thesis figures 4.10, 4.11).

    study.py [--program fiberfate] [--out results/34_phelps_in_mold]

Writes lengths.csv and models.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from study_runs import read_arguments, read_table, run_variants, write_table  # noqa: E402

MODELS = ["unbreakable length", "Phelps-Tucker"]


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
    arguments = read_arguments(__doc__, "results/34_phelps_in_mold")
    [folder] = run_variants(FOLDER / "case.toml", arguments, [""])
    table = [{"model": MODELS[int(row["set"])], "place": f"Loc.{int(row['place']) + 1}",
              "L_N_mm": round(1e3 * row["L_N_m"], 3), "L_W_mm": round(1e3 * row["L_W_m"], 3)}
             for row in read_table(folder / "places.csv")]
    write_table(FOLDER / "lengths.csv", table)
    draw(table)


if __name__ == "__main__":
    main()
