#!/usr/bin/env python3
"""Compares the eight cases of thesis table 16: lengths at the places, and profiles across the gap, coupled and not.

    study.py [--program fiberfate] [--out results/30_plaque]

Writes table_16.csv and gap_profiles.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from study_runs import read_arguments, read_summary, read_table, run_variants, write_table  # noqa: E402

CASES = [(f"case_{number + 1}", *case) for number, case in enumerate(
    [(thickness, ratio, coupled) for coupled in ("no", "yes") for thickness, ratio in ((1.5, 104), (1.5, 355), (2, 77), (2, 269))])]


def table(folders):
    for (name, thickness, ratio, coupled), folder in zip(CASES, folders):
        summary = read_summary(folder)
        yield {"case": name[-1], "thickness_mm": thickness, "L_over_D": ratio, "coupled": coupled,
               "pressure_MPa": round(summary["greatest_sprue_pressure_Pa"] / 1e6, 2),
               **{f"Loc_{k}_mm": round(1e3 * summary[f"Loc_{k}_L_N_m"], 3) for k in (1, 2, 3, 4)}}


def draw(folders):
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.4), layout="constrained")
    for number, style, label in ((1, "-", "not coupled"), (5, "--", "coupled")):
        for place, colour in ((0, "C0"), (1, "C1"), (3, "C2")):
            points = [row for row in read_table(folders[number] / "profiles.csv") if row["place"] == place]
            height = [row["height"] for row in points]
            text = f"Loc.{place + 1}, {label}"
            axes[0].plot(height, [row["a11"] for row in points], style, color=colour, label=text)
            axes[1].plot(height, [1e3 * row["L_N_m"] for row in points], style, color=colour)
    axes[0].set(xlabel="height over the mid-plane / half gap", ylabel="A11", title="orientation, L/D 355")
    axes[1].set(xlabel="height over the mid-plane / half gap", ylabel="length, mm", title="length, L/D 355")
    axes[0].legend(fontsize=7)
    for (name, _, ratio, coupled), folder in zip(CASES, folders):
        summary = read_summary(folder)
        share = [summary[f"Loc_{k}_L_N_m"] / (19e-6 * ratio) for k in (1, 2, 3, 4)]
        axes[2].plot((1, 2, 3, 4), share, "--" if coupled == "yes" else "-", marker="o", ms=3,
                     color={104: "C0", 355: "C1", 77: "C2", 269: "C3"}[ratio], label=f"L/D {ratio}, {name[-1]}")
    axes[2].set(xlabel="Loc.", ylabel="length / length at the gates", title="along the flow, cases 1 to 8", xticks=(1, 2, 3, 4))
    axes[2].legend(fontsize=6, ncol=2)
    figure.savefig(FOLDER / "gap_profiles.png", dpi=100)


def main():
    arguments = read_arguments(__doc__, "results/30_plaque")
    folders = run_variants(FOLDER / "case.toml", arguments, ["" if name == "case_4" else name for name, *_ in CASES])
    write_table(FOLDER / "table_16.csv", list(table(folders)))
    draw(folders)


if __name__ == "__main__":
    main()
