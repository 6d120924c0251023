#!/usr/bin/env python3
"""Compares gates that are open all at once with gates in sequence: sprue pressure and front (thesis figures 4.15 to 4.17).

    study.py [--program fiberfate] [--out results/32_tailgate]

Writes gates.csv, pressure.png and fronts.png beside itself. A result that is there already is not run again. Needs matplotlib.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import h5py  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent))
from study_runs import read_arguments, read_summary, read_table, run_variants, write_table  # noqa: E402

CASES = [("", "all at once"), ("sequence", "in sequence")]


def draw_pressure(folders):
    figure, axis = plt.subplots(figsize=(7, 3.6), layout="constrained")
    for folder, (_, text) in zip(folders, CASES):
        series = read_table(folder / "series.csv")
        axis.plot([row["time_s"] for row in series], [1e-6 * row["sprue_pressure_Pa"] for row in series], label=text)
    axis.set(xlabel="time, s", ylabel="pressure at the sprue, MPa")
    axis.legend()
    figure.savefig(FOLDER / "pressure.png", dpi=100)


def draw_fronts(folders):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    for axis, folder, (_, text) in zip(axes, folders, CASES):
        with h5py.File(folder / "result.vtkhdf") as file:
            root = file["VTKHDF"]
            points, triangles = root["Points"][:], root["Polygons/Connectivity"][:].reshape(-1, 3)
            fill_time = root["PointData/fill_time"][-len(points):]
        part = axis.tricontourf(points[:, 0], points[:, 1], triangles, fill_time, levels=16)
        axis.tricontour(points[:, 0], points[:, 1], triangles, fill_time, levels=16, colors="white", linewidths=0.4)
        axis.set(aspect="equal", title=text, xlabel="x, m", ylabel="y, m")
    figure.colorbar(part, ax=axes, label="front arrives, s")
    figure.savefig(FOLDER / "fronts.png", dpi=80)


def table(folders):
    for folder, (_, text) in zip(folders, CASES):
        summary = read_summary(folder)
        yield {"gates": text, "filled_s": round(summary["simulated_s"], 3),
               "greatest_pressure_MPa": round(summary["greatest_sprue_pressure_Pa"] / 1e6, 2),
               "weld_line_nodes": summary["weld_line_nodes"],
               **{f"{place}_{mean}_mm": round(1e3 * summary[f"{place}_{mean}_m"], 3)
                  for place in ("P1", "P2", "P3") for mean in ("L_N", "L_W")}}


def main():
    arguments = read_arguments(__doc__, "results/32_tailgate")
    folders = run_variants(FOLDER / "case.toml", arguments, [variant for variant, _ in CASES])
    write_table(FOLDER / "gates.csv", list(table(folders)))
    draw_pressure(folders)
    draw_fronts(folders)


if __name__ == "__main__":
    main()
