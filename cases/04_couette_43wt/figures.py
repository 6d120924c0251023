"""Draws the figures of the Couette study from the tables beside this script; needs python3-matplotlib."""
import csv

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "fiberfate"  # the same figure is the same file
from matplotlib import pyplot as plt  # noqa: E402

LABELS = {"fixed": "fixed, 300 µm", "ramp": "with the ramp", "probability": "ramp and probability, to 450 µm"}
WEIGHTS = {"43wt": "43 % by weight", "30wt": "30 % by weight"}


def read(path):
    """Reads a table as columns of numbers; empty cells become None."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {key: [float(row[key]) if row[key] else None for row in rows] for key in (rows[0] if rows else [])}


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def curves(axes, x, y, label, **style):
    known = [(a, b) for a, b in zip(x, y) if a is not None and b is not None]
    if known:
        axes.plot(*zip(*known), label=label, **style)


def draw_lengths(here):
    """L_N and L_W against time (figures 3.26, 3.28)."""
    table = read(here / "lengths.csv")
    figure, panels = plt.subplots(1, 2, figsize=(9, 3.6), sharey=True)
    for axes, (weight, title) in zip(panels, WEIGHTS.items()):
        for i, (law, label) in enumerate(LABELS.items()):
            for length, dashes in (("L_N", "-"), ("L_W", "--")):
                values = table.get(f"{weight}_{law}_{length}_m")
                if values:
                    curves(axes, table["time_s"], [v and 1e3 * v for v in values], f"{length}, {label}", ls=dashes,
                           color=f"C{i}")
        axes.set(title=title, xlabel="time (s)", xlim=(0, None), ylim=(0, 2.6))
    panels[0].set_ylabel("fiber length (mm)")
    for axes in panels:
        axes.legend(fontsize=7)
    save(figure, here / "lengths.svg")


def draw_table_4(here):
    """L_N against time by force constant and critical radius (figures 3.21 to 3.23, 3.25)."""
    table = read(here / "table_4.csv")
    figure, panels = plt.subplots(1, 3, figsize=(11, 3.4), sharey=True)
    for axes, radius in zip(panels, (200, 250, 300)):
        for i, constant in enumerate((250, 500, 750, 1665)):
            values = table.get(f"table_4_{constant}_{radius}_L_N_m") or table.get(f"empirical_{constant}_{radius}_L_N_m")
            if values:
                curves(axes, table["time_s"], [v and 1e3 * v for v in values], f"A = {constant} N/m", color=f"C{i}")
        values = table.get(f"ramp_500_{radius}_L_N_m")
        if values:
            curves(axes, table["time_s"], [v and 1e3 * v for v in values], "A = 500 N/m, ramp", color="C1", ls="--")
        axes.set(title=f"critical radius {radius} µm", xlabel="time (s)")
        axes.legend(fontsize=7)
    panels[0].set_ylabel("number-average length (mm)")
    save(figure, here / "table_4.svg")


def draw_bars(here, name, x_key, x_scale, x_label, y_label):
    table = read(here / f"{name}.csv")
    x = [x_scale * value for value in table[x_key]]
    figure, panels = plt.subplots(1, 2, figsize=(9, 3.2))
    for axes, (weight, title) in zip(panels, WEIGHTS.items()):
        for law, label in LABELS.items():
            if f"{weight}_{law}" in table:
                axes.step(x, table[f"{weight}_{law}"], where="mid", label=label)
        axes.set(title=title, xlabel=x_label, ylabel=y_label)
    for axes in panels:
        axes.legend(fontsize=7)
    save(figure, here / f"{name}.svg")


def draw_near_critical(here):
    """Hinges about to break against time (figure 3.31)."""
    table = read(here / "near_critical.csv")
    figure, panels = plt.subplots(1, 2, figsize=(9, 3.2))
    for axes, (weight, title) in zip(panels, WEIGHTS.items()):
        for law, label in LABELS.items():
            curves(axes, table["time_s"], table.get(f"{weight}_{law}", []), label)
        axes.set(title=title, xlabel="time (s)", ylabel="hinges within 50 µm", xlim=(0, None))
    for axes in panels:
        axes.legend(fontsize=7)
    save(figure, here / "near_critical.svg")


def draw(here):
    if (here / "table_4.csv").exists():
        draw_table_4(here)
    if (here / "lengths.csv").exists():
        draw_lengths(here)
        draw_bars(here, "break_radii", "radius_from_m", 1e6, "radius at which a hinge broke, from (µm)", "breaks in 60 s")
        draw_bars(here, "final_lengths", "length_up_to_m", 1e3, "length (mm)", "fibers at the end")
        draw_near_critical(here)
