#!/usr/bin/env python3
"""Draws the length distributions at the places (thesis figure 4.12), and tells both means by both weights (figure 4.13).

    study.py [--program fiberfate] [--out results/31_length_classes]

Writes means.csv and distributions.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from study_runs import read_arguments, read_table, run_variants, write_table  # noqa: E402


def draw(folder):
    figure, axes = plt.subplots(2, 2, figsize=(9, 5.5), layout="constrained", sharex=True, sharey=True)
    table = [row for row in read_table(folder / "histogram.csv") if row["set"] == 0]
    for place, axis in enumerate(axes.flat):
        for number, text in ((-1, "at the gates"), (place, f"Loc.{place + 1}")):
            bins = [row for row in table if row["place"] == number]
            edges = [1e3 * row["length_low_m"] for row in bins] + [1e3 * bins[-1]["length_high_m"]]
            axis.stairs([100 * row["length_share"] for row in bins], edges, label=text, fill=number >= 0, alpha=0.7)
        axis.legend(fontsize=8)
    figure.supxlabel("length, mm")
    figure.supylabel("share of the fiber length, %")
    figure.savefig(FOLDER / "distributions.png", dpi=100)


def main():
    arguments = read_arguments(__doc__, "results/31_length_classes")
    table = []
    for variant, weight in (("", "length"), ("by_number", "number")):
        [folder] = run_variants(FOLDER / "case.toml", arguments, [variant])
        for row in read_table(folder / "places.csv"):
            table.append({"weight": weight, "place": f"Loc.{int(row['place']) + 1}", "L_N_mm": round(1e3 * row["L_N_m"], 3),
                          "L_W_mm": round(1e3 * row["L_W_m"], 3)})
        if variant == "":
            draw(folder)
    write_table(FOLDER / "means.csv", table)


if __name__ == "__main__":
    main()
