#!/usr/bin/env python3
"""Draws the length distributions at the places (thesis figure 4.12), and tells both means by both weights (figure 4.13).

    study.py [--program fiberfate] [--out results/31_length_classes]

Writes means.csv and distributions.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import argparse
import csv
import pathlib
import subprocess

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


def draw(folder):
    figure, axes = plt.subplots(2, 2, figsize=(9, 5.5), layout="constrained", sharex=True, sharey=True)
    table = [row for row in rows(folder, "histogram.csv") if row["set"] == 0]
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
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/31_length_classes"))
    arguments = parser.parse_args()
    table = []
    for variant, weight in (("", "length"), ("by_number", "number")):
        folder = run(arguments.program, arguments.out, variant)
        for row in rows(folder, "places.csv"):
            table.append({"weight": weight, "place": f"Loc.{int(row['place']) + 1}", "L_N_mm": round(1e3 * row["L_N_m"], 3),
                          "L_W_mm": round(1e3 * row["L_W_m"], 3)})
        if variant == "":
            draw(folder)
    write("means.csv", table)


if __name__ == "__main__":
    main()
