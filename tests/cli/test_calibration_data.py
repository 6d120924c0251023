"""Calibration to other runs' results and to measured lists: what was put in comes out again."""
import math
from pathlib import Path

import pytest

from small_case import run, summary

CASES = Path(__file__).resolve().parents[2] / "cases"
RSC = """study = "calibration"
[orientation]
name = "rsc"
C_I = 0.004
kappa = 0.5
[conditions]
names = ["cell"]
rates = ["2 1/s"]
orientation = [0.4, 0.35, 0.25]
[data]
series = [["cell", "a11", "truth/series.csv"], ["cell", "a12", "truth/series.csv"]]
[fit]
free = ["C_I", "kappa"]
"""
TRUTH = """study = "orientation"
[diffusion]
name = "folgar_tucker"
C_I = 0.012
[retardation]
name = "rsc"
kappa = 0.3
[flow]
rate = "2 1/s"
[fibers]
orientation = [0.4, 0.35, 0.25]
[solution]
tolerance = 1e-11
[run]
duration = "10 s"
[output]
interval = "0.5 s"
"""
PHELPS = """study = "calibration"
[law]
name = "phelps"
C_B = 0.004
zeta = 2.5
S = 0.25
[fibers]
distribution = "start.csv"
bins = 80
[conditions]
names = ["run"]
rates = ["100 1/s"]
viscosities = ["50 Pa s"]
[data]
series = [["run", "histogram", "truth/histogram.csv", "10 s"], ["run", "L_N", "truth/series.csv"]]
[fit]
free = ["C_B", "zeta"]
"""
BROKEN = """study = "attrition"
[law]
name = "phelps"
C_B = 0.005
zeta = 3
S = 0.25
[melt]
eta_0 = "50 Pa s"
[flow]
rate = "100 1/s"
[fibers]
distribution = "start.csv"
bins = 80
[run]
duration = "10 s"
[output]
interval = "1 s"
histogram_times = ["10 s"]
histogram_bins = 20
"""
START = "length_m,number\n" + "".join(f"{0.0005 * k},{40 - 2 * k}\n" for k in range(1, 20))


def write(folder, name, text):
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def test_orientation_parameters_from_a_series_of_the_same_columns_as_a_cell_of_fibers(tmp_path):
    run("run", write(tmp_path, "truth.toml", TRUTH), "--out", tmp_path / "truth")
    run("run", write(tmp_path, "fit.toml", RSC), "--out", tmp_path / "fit")
    values = summary(tmp_path / "fit")
    assert values["C_I"] == pytest.approx(0.012, rel=1e-6)
    assert values["kappa"] == pytest.approx(0.3, rel=1e-6)


def test_a_distribution_at_the_start_and_a_histogram_at_the_end(tmp_path):
    write(tmp_path, "start.csv", START)
    run("run", write(tmp_path, "truth.toml", BROKEN), "--out", tmp_path / "truth")
    run("run", write(tmp_path, "fit.toml", PHELPS), "--out", tmp_path / "fit")
    values = summary(tmp_path / "fit")
    assert values["C_B"] == pytest.approx(0.005, rel=1e-5)
    assert values["zeta"] == pytest.approx(3, rel=1e-5)
    run("report", tmp_path / "fit")


@pytest.mark.parametrize("old, new, words", [
    ('distribution = "start.csv"', "", ["conditions.lengths: not given"]),
    ('rates = ["100 1/s"]', 'rates = ["100 1/s"]\nlengths = ["5 mm"]', ["more than one way"]),
    ('distribution = "start.csv"', 'number_average = "2 mm"', ["fibers.weight_average: not given"]),
    ('distribution = "start.csv"', 'distribution = "strat.csv"', ["strat.csv", "cannot be read"]),
    ('name = "phelps"\nC_B = 0.004\nzeta = 2.5\nS = 0.25', 'name = "constant"\nk_f = 0.1\nL_inf = "1 mm"',
     ["fit.free", "no parameter 'C_B'"])])
def test_mistakes_are_named(tmp_path, old, new, words):
    write(tmp_path, "start.csv", START)
    done = run("check", write(tmp_path, "case.toml", PHELPS.replace(old, new)), expect=2)
    for word in words:
        assert word in done.stdout + done.stderr


def test_means_have_no_histogram(tmp_path):
    case = PHELPS.replace('name = "phelps"\nC_B = 0.004\nzeta = 2.5\nS = 0.25', 'name = "constant"\nk_f = 0.1\nL_inf = "1 mm"')
    case = case.replace('free = ["C_B", "zeta"]', 'free = ["k_f"]').replace("bins = 80", 'form = "means"')
    write(tmp_path, "start.csv", START)
    done = run("check", write(tmp_path, "case.toml", case), expect=2)
    assert "fibers.form" in done.stderr and "no histogram" in done.stderr


MEASURED = """study = "calibration"
[law]
name = "constant"
k_f = "0.1 1/s"
L_inf = "2 mm"
[conditions]
names = ["rheometer"]
rates = ["20 1/s"]
viscosities = ["270 Pa s"]
lengths = ["6 mm"]
[data]
series = [["rheometer", "L_N", "lengths.csv"]]
[fit]
free = ["k_f", "L_inf"]
"""


def fit_of(folder, headings, factors, separator=","):
    """Fits a decay from 6 to 1 mm whose table has the headings, in units of so many SI units."""
    rows = [(time, 1e-3 + 5e-3 * math.exp(-0.04 * time), 1e-4) for time in range(0, 100, 10)]
    lines = [separator.join(headings)]
    lines += [separator.join(f"{value / factor:.9g}".replace(".", "," if separator == ";" else ".")
                             for value, factor in zip(row, factors)) for row in rows]
    (folder / "lengths.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "case.toml").write_text(MEASURED, encoding="utf-8")
    run("run", folder / "case.toml", "--out", folder / "r", "--overwrite")
    return summary(folder / "r")


def test_units_of_columns_are_read_from_their_headings(tmp_path):
    plain = fit_of(tmp_path, ["time_s", "L_N_m", "L_N_m_sd"], [1, 1, 1])
    assert plain["L_inf"] == pytest.approx(1e-3, rel=1e-6) and plain["k_f"] == pytest.approx(0.04, rel=1e-6)
    for headings, factors, separator in ((["time_min", "L_N_mm", "L_N_sd_um"], [60, 1e-3, 1e-6], ","),
                                         (["Time [min]", "L_N [mm]", "L_N_sd [mm]"], [60, 1e-3, 1e-3], ";"),
                                         (["time (s)", "l_n (um)"], [1, 1e-6], ",")):
        other = fit_of(tmp_path, headings, factors, separator)
        assert other["L_inf"] == pytest.approx(plain["L_inf"], rel=1e-6), headings
        assert other["k_f"] == pytest.approx(plain["k_f"], rel=1e-6), headings


def test_a_column_that_is_missing_or_impossible_is_told(tmp_path):
    with pytest.raises(AssertionError, match=r"no column is L_N in a unit of 'm': name one 'L_N_m' or 'L_N \[m\]'; its columns are 'time_s', 'length'"):
        fit_of(tmp_path, ["time_s", "length"], [1, 1])
    (tmp_path / "lengths.csv").write_text("time_s,L_N_m\n0,0.006\n5,-0.001\n", encoding="utf-8")
    refused = run("run", tmp_path / "case.toml", "--out", tmp_path / "n", expect=2)
    assert "-0.001 is no possible value of rheometer: L_N" in refused.stderr
