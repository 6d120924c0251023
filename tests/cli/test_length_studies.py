"""Attrition and calibration: the thesis' numbers from the command line, and what a user is told."""
import json
import math
import shutil
from pathlib import Path

import pytest

from small_case import column, run, summary

ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "cases"
CHAPTER5 = json.loads((ROOT / "tests" / "reference" / "thesis_ch5.json").read_text(encoding="utf-8"))


def value(equation, entry=0):
    return CHAPTER5["equations"][equation][entry]["value"]


def result_of(tmp_path, name, *words):
    folder = tmp_path / "result"
    done = run("run", CASES / name / "case.toml", "--out", folder, *words)
    return folder, summary(folder), done


def test_the_four_constants_of_the_stress_law(tmp_path):
    folder, values, done = result_of(tmp_path, "21_couette_stress_law")
    assert values["alpha"] == pytest.approx(value("5.12"), rel=1e-10)
    assert values["lambda"] == pytest.approx(value("5.13"), rel=1e-9)
    assert values["beta"] == pytest.approx(value("5.16b"), rel=1e-10)
    assert values["k_0"] == pytest.approx(67821, abs=1)
    assert values["degrees_of_freedom"] == 0
    assert values["lambda_standard_error"] is None
    assert "cannot test it" in values["finding_1"]
    assert "cannot test it" in done.stderr
    assert "sigma_u" in json.dumps([text for key, text in values.items() if key.startswith("finding")])


@pytest.mark.parametrize("stresses, beta, k_0", [
    ((49584, 82749), value("5.16"), None),
    ((49584.86, 82749.23), value("5.16c"), value("5.17", 2))])
def test_the_constants_with_the_stresses_of_each_equation(tmp_path, stresses, beta, k_0):
    viscosities = [f"{stress / rate!r} poise" for stress, rate in zip(stresses, (18.326, 36.652))]
    _, values, _ = result_of(tmp_path, "21_couette_stress_law", "--set",
                             "conditions.viscosities=" + json.dumps(viscosities))
    assert values["beta"] == pytest.approx(beta, rel=1e-10)
    if k_0 is not None:
        assert values["k_0"] == pytest.approx(k_0, rel=1e-8)
        assert values["k_0"] == pytest.approx(value("5.18", 2), rel=1e-8)


@pytest.mark.parametrize("equation, entry, stress, rate_constant, beta", [
    ("5.17", 0, 49584.86, 0.0279, 1.1392), ("5.18", 0, 82749.23, 0.05, 1.1392),
    ("5.17", 1, 49584.86, 0.0279, value("5.16")), ("5.18", 1, 82749.23, 0.05, value("5.16"))])
def test_k_0_with_a_rounded_exponent(tmp_path, equation, entry, stress, rate_constant, beta):
    condition = ["50 rpm", 18.326] if rate_constant < 0.04 else ["100 rpm", 36.652]
    _, values, _ = result_of(
        tmp_path, "21_couette_stress_law", "--set", f"conditions.names={json.dumps(condition[:1])}", "--set",
        f"conditions.rates=[{condition[1]}]", "--set", f'conditions.viscosities=["{stress / condition[1]!r} poise"]',
        "--set", f'data.series=[["{condition[0]}", "k_f", "{rate_constant} 1/s"]]', "--set", f"law.beta={beta!r}",
        "--set", 'fit.free=["k_0"]', "--set", "fit.linear=[]")
    assert values["k_0"] == pytest.approx(value(equation, entry), rel=1e-10)


def test_lambda_with_a_rounded_exponent(tmp_path):
    _, values, _ = result_of(
        tmp_path, "21_couette_stress_law", "--set", 'data.series=[["50 rpm", "L_inf", "1.5 mm"]]', "--set",
        "law.alpha=1.353462", "--set", 'fit.free=["lambda"]', "--set", "fit.linear=[]")
    assert values["lambda"] == pytest.approx(value("5.13c"), rel=1e-10)


def test_the_exponent_of_the_rate_law(tmp_path):
    _, values, _ = result_of(tmp_path, "22_couette_rate_law")
    assert values["beta"] == pytest.approx(value("5.15"), rel=1e-10)
    assert values["degrees_of_freedom"] == 0


def test_the_interaction_coefficient_of_each_speed(tmp_path):
    _, values, _ = result_of(tmp_path, "23_couette_interaction")
    assert values["50_rpm_lambda"] == pytest.approx(value("5.1"), rel=1e-10)
    assert values["100_rpm_lambda"] == pytest.approx(value("5.2"), rel=1e-10)


def test_rate_constants_and_final_lengths_from_the_curves(tmp_path):
    _, values, _ = result_of(tmp_path, "24_couette_curves")
    assert values["50_rpm_k_f"] == pytest.approx(0.0279, rel=1e-9)
    assert values["100_rpm_k_f"] == pytest.approx(0.05, rel=1e-9)
    assert values["50_rpm_L_inf"] == pytest.approx(1.5e-3, rel=1e-9)
    assert values["100_rpm_L_inf"] == pytest.approx(0.75e-3, rel=1e-9)
    assert values["50_rpm_degrees_of_freedom"] == 11


def test_lengths_over_time_are_equation_5_7(tmp_path):
    folder, values, _ = result_of(tmp_path, "20_couette_length", "--set", "flow.kind=constant", "--set",
                                  'flow.rate="18.326 1/s"', "--set", 'melt.eta_0="2705.719578740587 poise"')
    times, lengths = column(folder, "time_s"), column(folder, "L_W_m")
    for point in CHAPTER5["length_curves_eq5_7"]:
        assert lengths[times.index(point["t"])] == pytest.approx(1e-3 * point["L50"], rel=1e-9)
    assert values["unbreakable_length_m"] == pytest.approx(1.5e-3, rel=1e-9)
    assert values["rate_constant_per_s"] == pytest.approx(0.0279, rel=1e-6)


def test_the_speed_of_the_rheometer_gives_the_rate(tmp_path):
    _, values, _ = result_of(tmp_path, "20_couette_length")
    assert values["rate_per_s"] == pytest.approx(50 * CHAPTER5["derived"]["gdot_per_rpm"], rel=1e-12)


def test_the_unit_trap_is_warned_of(tmp_path):
    folder, values, done = result_of(tmp_path, "21_couette_stress_law", "--set", 'law.sigma_u="2e10 Pa"')
    assert "dyn/cm^2" in done.stderr
    assert values["lambda"] == pytest.approx(value("5.13") * 10 ** -values["alpha"], rel=1e-8)


def test_a_combination_that_data_do_not_tell_is_named(tmp_path):
    _, values, done = result_of(tmp_path, "21_couette_stress_law", "--set",
                                'fit.free=["lambda", "alpha", "k_0", "beta", "sigma_u"]')
    named = [text for key, text in values.items() if key.startswith("finding") and "changes no prediction" in text]
    assert len(named) == 1
    assert "sigma_u" in named[0] and "lambda" in named[0] and "k_0" in named[0]
    assert values["sigma_u_standard_error"] is None


def test_the_sweep_finds_xi(tmp_path):
    folder, values, _ = result_of(tmp_path, "25_xi_sweep")
    assert values["xi_lower"] < 1.5e-3 < values["xi_upper"]
    assert values["xi_profile_lower"] < 1.5e-3 < values["xi_profile_upper"]
    assert values["xi_bootstrap_lower"] < 1.5e-3 < values["xi_bootstrap_upper"]
    assert values["lambda_lower"] < 0.06 < values["lambda_upper"]
    assert values["sweep_best_value"] == pytest.approx(1.5e-3, rel=0.15)
    errors = column(folder, "average_error_percent", "sweep.csv")
    assert min(errors) >= values["sweep_best_error_percent"]
    assert errors[0] > 2 * min(errors) and errors[-1] > 2 * min(errors)


def test_orientation_parameters_come_back(tmp_path):
    _, values, _ = result_of(tmp_path, "26_rsc_from_shear")
    assert values["C_I_lower"] < 0.01 < values["C_I_upper"]
    assert values["kappa_lower"] < 0.2 < values["kappa_upper"]
    assert values["noise_scale"] == pytest.approx(1, abs=0.4)


def test_phelps_beside_another_law(tmp_path):
    folder, values, _ = result_of(
        tmp_path, "20_couette_length", "--set", "fibers.form=distribution", "--set", "compare.name=phelps", "--set",
        "compare.C_B=0.005", "--set", "compare.zeta=3", "--set", "compare.S=0.25")
    assert abs(values["total_length_change"]) < 1e-12
    assert abs(values["compared_total_length_change"]) < 1e-12
    lengths = column(folder, "compared_L_W_m")
    assert all(later <= earlier * (1 + 1e-14) for earlier, later in zip(lengths, lengths[1:]))
    shares = column(folder, "number_share", "histogram.csv")
    assert math.fsum(shares) == pytest.approx(2, rel=1e-9)


def test_a_measured_series_may_be_another_runs_result(tmp_path):
    case = tmp_path / "case"
    shutil.copytree(CASES / "20_couette_length", case)
    run("run", case / "case.toml", "--out", case / "slow")
    fitted = (CASES / "24_couette_curves" / "case.toml").read_text(encoding="utf-8")
    fitted = fitted.replace('["50 rpm", "L_W", "curve_50rpm.csv"]', '["50 rpm", "L_W", "slow/series.csv"]')
    fitted = fitted.replace('["100 rpm", "L_W", "curve_100rpm.csv"],', "")
    (case / "fit.toml").write_text(fitted, encoding="utf-8")
    run("run", case / "fit.toml", "--out", case / "fit")
    assert summary(case / "fit")["50_rpm_k_f"] == pytest.approx(0.0279, rel=1e-4)


@pytest.mark.parametrize("override, message", [
    ('fit.free=["lamda"]', "the law stress_induced has no parameter 'lamda': did you mean 'lambda'?"),
    ('data.series=[["50rpm", "L_inf", "1 mm"]]', "data.series = [\"50rpm\", \"L_inf\", \"1 mm\"]: there is no condition '50rpm'"),
    ('data.series=[["50 rpm", "L_W", "absent.csv"]]', "absent.csv"),
    ('data.series=[["50 rpm", "a11", "absent.csv"]]', "a11 does not belong to an attrition law"),
    ('conditions.rates=["1 1/s", "2 1/s", "3 1/s"]', "3 entries for 2 conditions"),
    ('law.name="stress"', "not one of the choices"),
    ('law.d_f="19 s"', "d_f")])
def test_mistakes_are_named(tmp_path, override, message):
    done = run("check", CASES / "21_couette_stress_law" / "case.toml", "--set", override, expect=2)
    assert message in done.stdout + done.stderr


@pytest.mark.parametrize("name", ["20_couette_length", "21_couette_stress_law", "23_couette_interaction", "25_xi_sweep"])
def test_reports_are_written(tmp_path, name):
    folder, _, _ = result_of(tmp_path, name)
    run("report", folder)
    assert (folder / "report.html").stat().st_size > 10000
    run("check", folder / "case.resolved.toml")


def test_rows_and_histograms_stand_at_the_times_that_are_chosen(tmp_path):
    times = ["--set", 'output.times=["1 s", "40 s"]', "--set", 'output.histogram_times=["0.9 s"]', "--set",
             "fibers.form=distribution", "--set", "run.duration=60 s"]
    folder, _, _ = result_of(tmp_path, "20_couette_length", *times, "--set", "output.interval=0.3 s")
    # 3 · 0.3 is not 0.9: the histogram counts at the time that was asked for.
    assert column(folder, "time_s", "histogram.csv")[0] == 0.9
    assert {0.9, 1, 40, 60} <= set(column(folder, "time_s")) and len(column(folder, "time_s")) == 203
    alone = CASES / "20_couette_length" / "case.toml"
    refused = run("check", alone, "--set", 'output.times=["1 h"]', expect=2)
    assert "comes after the end" in refused.stderr


def test_a_file_of_lengths_that_cannot_be_read_is_the_only_fault(tmp_path):
    (tmp_path / "numbers.txt").write_text("1e-3 1\n2e-3 x\n", encoding="utf-8")
    (tmp_path / "case.toml").write_text("""study = "attrition"
[law]
name = "unbreakable_length"
lambda = 0.1
xi = 1e-3
sigma_u = "2 GPa"
d_f = "19 um"
[melt]
eta_0 = "200 Pa s"
[flow]
rate = "100 1/s"
[fibers]
distribution = "numbers.txt"
[run]
duration = "1 s"
""", encoding="utf-8")
    refused = run("check", tmp_path / "case.toml", expect=2)
    assert len(refused.stderr.splitlines()) == 1 and "numbers.txt:2:6: 'x' is not a finite number" in refused.stderr
