"""Draws the tables of studies that follow numbers: components, lengths, fits, moduli, histograms."""
import csv

from drawing import Chart, INK, SERIES


def table(folder, name):
    """Returns the columns of a table."""
    with (folder / name).open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {key: [float(row[place]) for row in rows[1:]] for place, key in enumerate(rows[0])}


def lines(columns, across, ups, labels):
    """Draws columns over another one: (column, factor), [(column, name, factor)], the words at the axes."""
    x = [value * across[1] for value in columns[across[0]]]
    curves = [(name, [value * factor for value in columns[key]]) for key, name, factor in ups]
    low = min(0.0, min(min(values) for _, values in curves))
    chart = Chart((min(x), max(x)), (low, max(max(values) for _, values in curves) * 1.03), labels)
    for (name, values), ink in zip(curves, SERIES):
        chart.line(list(zip(x, values)), ink)
    for (name, _), ink in reversed(list(zip(curves, SERIES))):
        chart.name(name, ink)
    return chart.sheet


def orientation(folder, _):
    """Draws the components of the orientation over the strain."""
    columns = table(folder, "series.csv")
    ups = [(key, key.upper(), 1) for key in ("a11", "a22", "a33", "a12")]
    return lines(columns, ("strain", 1), ups, ("strain", "orientation")), "Components of the orientation over the strain"


def lengths(folder, _):
    """Draws the mean lengths over time."""
    ups = [("L_N_m", "L_N", 1e3), ("L_W_m", "L_W", 1e3)]
    return lines(table(folder, "series.csv"), ("time_s", 1), ups, ("time, s", "length, mm")), "Mean lengths over time"


def modulus(folder, _):
    """Draws Young's modulus over the direction."""
    ups = [("modulus_12_Pa", "in 1-2", 1e-9), ("modulus_13_Pa", "in 1-3", 1e-9)]
    return (lines(table(folder, "modulus.csv"), ("angle_deg", 1), ups, ("angle to axis 1, degrees", "modulus, GPa")),
            "Young's modulus over the direction")


def histogram(folder, _):
    """Draws the measured lengths."""
    columns = table(folder, "histogram.csv")
    bars = [(low * 1e3, high * 1e3, share) for low, high, share in
            zip(columns["length_low_m"], columns["length_high_m"], columns["number_share"])]
    chart = Chart((0, bars[-1][1]), (0, max(bar[2] for bar in bars) * 1.05), ("length, mm", "share of fibers"))
    chart.bars(bars, SERIES[0])
    return chart.sheet, "Measured lengths, corrected for the size of the sample"


def scale_of(values):
    """Returns the factor and the words for values that are lengths of millimetres or plain numbers."""
    return (1e3, "length, mm") if max(map(abs, values)) < 0.05 else (1, "orientation")


def fits(folder, _):
    """Draws what was measured and what was fitted: over time, or one against the other where all is at one time."""
    points, curves = table(folder, "fit.csv"), table(folder, "curves.csv")
    if max(curves["time_s"]) == 0:
        return agreement(points), "What was measured, and what the fitted law predicts"
    factor, words = scale_of(points["observed"])
    top = factor * max(points["observed"] + curves["predicted"])
    low = factor * min(0.0, *points["observed"])
    chart = Chart((0, max(curves["time_s"])), (low, 1.05 * top), ("time, s", words))
    for place, key in enumerate(sorted(set(zip(curves["fit"], curves["series"])))):
        ink = SERIES[place % len(SERIES)]
        for draw, columns, column in ((chart.line, curves, "predicted"), (chart.dots, points, "observed")):
            rows = zip(columns["fit"], columns["series"], columns["time_s"], columns[column])
            draw([(time, factor * value) for fit, series, time, value in rows if (fit, series) == key], ink)
    return chart.sheet, "Measurements (dots) and the fitted law (lines)"


def agreement(points):
    """Draws predictions over observations."""
    top = 1.1 * max(points["observed"] + points["predicted"])
    chart = Chart((0, top), (0, top), ("measured", "predicted"))
    chart.line([(0, 0), (top, top)], INK)
    chart.dots(zip(points["observed"], points["predicted"]), SERIES[1])
    return chart.sheet


def rheology(folder, _):
    """Draws the relative viscosity over the rate, a colour for each flow."""
    columns = table(folder, "curves.csv")
    rates, viscosities = columns["rate_per_s"], columns["relative_viscosity"]
    chart = Chart((0, 1.05 * max(rates)), (0, 1.1 * max(viscosities)), ("rate, 1/s", "viscosity over the melt's"))
    for place, flow in enumerate(sorted(set(columns["flow"]))):
        points = [(rate, value) for kind, rate, value in zip(columns["flow"], rates, viscosities) if kind == flow]
        chart.line(points, SERIES[place % len(SERIES)])
        chart.dots(points, SERIES[place % len(SERIES)])
    return chart.sheet, "Relative viscosity over the rate, in several flows"


DRAW = {"orientation": orientation, "shear_cell": orientation, "attrition": lengths, "properties": modulus,
        "measurement": histogram, "calibration": fits, "rheometer": rheology}


def draw(folder, summary):
    """Returns the picture of a study and what it shows."""
    return DRAW[summary["study"]](folder, summary)
