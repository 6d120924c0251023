"""Orientation: known steady states from the command line, and what a user is told."""
import math
from pathlib import Path

import pytest

from small_case import column, run, summary

CASES = Path(__file__).resolve().parents[2] / "cases"
IARD = """study = "orientation"
[diffusion]
name = "iard"
C_I = 0.02
C_M = {c_m}
[flow]
kind = "{kind}"
rate = "1 1/s"
[run]
duration = "5 s"
"""


def result_of(tmp_path, case, *words):
    tmp_path.mkdir(exist_ok=True)
    folder = tmp_path / "result"
    run("run", case, "--out", folder, *words)
    return folder, summary(folder)


def written(tmp_path, text):
    case = tmp_path / "case.toml"
    case.write_text(text, encoding="utf-8")
    return case


def trace(tensor):
    return tensor[0][0] + tensor[1][1] + tensor[2][2]


def test_steady_shear_with_and_without_closure(tmp_path):
    folder, values = result_of(tmp_path, CASES / "10_orientation_shear" / "case.toml")
    assert values["distribution_A2"][0][0] == pytest.approx(0.7271243, abs=1e-5)
    assert values["A2"][0][0] == pytest.approx(0.77691, abs=1e-4)
    assert trace(values["A2"]) == pytest.approx(1, abs=1e-14)
    assert values["projections"] == 0
    assert values["strain"] == pytest.approx(100)
    time, a11 = column(folder, "time_s"), column(folder, "a11")
    assert len(time) == 201 and time[0] == 0 and time[-1] == 100
    assert a11[0] == pytest.approx(1 / 3) and a11[-1] == values["A2"][0][0]
    assert column(folder, "distribution_a11")[-1] == values["distribution_A2"][0][0]


def test_retardation_slows_but_does_not_move_the_steady_state(tmp_path):
    case = CASES / "11_iard_rpr" / "case.toml"
    _, slow = result_of(tmp_path / "slow", case)
    _, fast = result_of(tmp_path / "fast", case, "--set", "retardation.alpha=0")
    assert slow["A2"][0][0] == pytest.approx(fast["A2"][0][0], abs=0.05)
    assert trace(slow["A2"]) == pytest.approx(1, abs=1e-14)
    early_slow = column(tmp_path / "slow" / "result", "a11")[2]
    early_fast = column(tmp_path / "fast" / "result", "a11")[2]
    assert early_slow < 0.5 < early_fast


STRONG_RETARDATION = """study = "orientation"
[diffusion]
name = "folgar_tucker"
C_I = 0.0311
[retardation]
name = "rsc"
kappa = 0.01
[flow]
kind = "shear"
rate = 1
shear_gradient = "y"
[fibers]
orientation = "isotropic"
[solution]
closure = "ibof"
tolerance = 1e-10
[run]
duration = 20000
[output]
interval = 200
"""
# That of the law without retardation, from an independent computation.
ITS_STEADY_STATE = [[0.6493761451, 0.1133462673, 0], [0.1133462673, 0.1312225654, 0], [0, 0, 0.2194012895]]


def test_strong_retardation_from_isotropic_reaches_the_steady_state(tmp_path):
    folder, values = result_of(tmp_path, written(tmp_path, STRONG_RETARDATION))
    for row, steady in zip(values["A2"], ITS_STEADY_STATE, strict=True):
        assert row == pytest.approx(steady, abs=1e-9)  # some steps' tolerance
    assert values["projections"] == 0
    # A million explicit steps did not leave the start. The processor's time is the same on a busy machine.
    assert values["steps"] < 20000 and values["cpu_s"] < 1
    # Retardation slows the approach: without it A11 is there after 20 units of strain.
    a11 = column(folder, "a11")
    assert len(a11) == 101 and a11[1] < 0.6 and a11[5] < ITS_STEADY_STATE[0][0] - 1e-3
    _, fast = result_of(tmp_path / "fast", written(tmp_path, STRONG_RETARDATION), "--set", "retardation.kappa=1",
                        "--set", "run.duration=60", "--set", "output.interval=20")
    fast_a11 = column(tmp_path / "fast" / "result", "a11")
    assert fast_a11[1] == pytest.approx(ITS_STEADY_STATE[0][0], abs=1e-3)
    assert fast["A2"][0][0] == pytest.approx(ITS_STEADY_STATE[0][0], abs=1e-9)


def test_a_table_of_gradients(tmp_path):
    folder, values = result_of(tmp_path, CASES / "12_injection_history" / "case.toml")
    time, a22 = column(folder, "time_s"), column(folder, "a22")
    behind_the_gate = [a for t, a in zip(time, a22) if t <= 0.85][-1]
    assert behind_the_gate > [a for t, a in zip(time, a22) if t <= 0.5][-1]
    assert values["shape_factor"] == pytest.approx(624 / 626)


def test_the_stress_of_aligned_and_of_random_fibers(tmp_path):
    stressed = IARD.format(c_m=0.5, kind="uniaxial") + """
[melt]
name = "cross_wlf"
tau = 25000
n = 0.3
D1 = 5e12
D2 = 263.15
A1 = 28
[fibers]
aspect_ratio = 25
volume_fraction = 0.1
"""
    folder, values = result_of(tmp_path, written(tmp_path, stressed))
    term = 0.1 * 25**2 / (3 * math.log(math.sqrt(math.pi / 0.1)))
    assert values["fiber_term"] == pytest.approx(term)
    matrix, effective = column(folder, "viscosity_Pa_s"), column(folder, "effective_viscosity_Pa_s")
    assert effective[0] == pytest.approx(matrix[0] * (1 + term * 2 / 15))
    assert matrix[0] < effective[0] < effective[-1] < matrix[-1] * (1 + term * 2 / 3)
    # tau:D, which the informed viscosity is made to keep; D = diag(2, -1, -1)/(2 sqrt 3).
    tensile = column(folder, "stress_11_Pa")[-1] - column(folder, "stress_22_Pa")[-1]
    assert tensile / math.sqrt(3) == pytest.approx(effective[-1], rel=1e-9)
    run("report", folder)


@pytest.mark.parametrize("melt, words", [
    ('name = "newtonian"', ["melt.eta_0: not given", "fibers.fiber_term: not given"]),
    ('name = "newtonian"\neta_0 = 100\n[fibers]\nvolume_fraction = 0.1', ["fibers.aspect_ratio"]),
    ('name = "newtonian"\neta_0 = 100\n[fibers]\nvolume_fraction = 0.1\nfiber_term = 3', ["contradicts"])])
def test_faults_of_the_stress_are_told(tmp_path, melt, words):
    refused = run("check", written(tmp_path, IARD.format(c_m=0.5, kind="shear") + "[melt]\n" + melt), expect=2)
    for word in words:
        assert word in refused.stdout + refused.stderr


def test_doubtful_diffusion_is_told(tmp_path):
    doubtful = run("check", written(tmp_path, IARD.format(c_m=0.9, kind="uniaxial")))
    assert "indefinite" in doubtful.stdout + doubtful.stderr
    sound = run("check", written(tmp_path, IARD.format(c_m=0.9, kind="shear")))
    assert "indefinite" not in sound.stdout + sound.stderr


@pytest.mark.parametrize("old, new, words", [
    ("C_M = 0.9", "", ["diffusion.C_M", "iard needs it"]),
    ("C_M = 0.9", "C_M = 1.2", ["diffusion.C_M"]),
    ('rate = "1 1/s"', "", ["flow.rate"]),
    ('name = "iard"', 'name = "iarrd"', ["did you mean", "iard"]),
    ('kind = "shear"', 'kind = "mixed"', ["flow.elongation_rate"])])
def test_faults_are_told(tmp_path, old, new, words):
    case = written(tmp_path, IARD.format(c_m=0.9, kind="shear").replace(old, new))
    refused = run("check", case, expect=2)
    for word in words:
        assert word in refused.stdout + refused.stderr


def test_a_new_case_runs(tmp_path):
    run("new", "orientation", tmp_path / "fresh")
    _, values = result_of(tmp_path, tmp_path / "fresh" / "case.toml")
    assert values["diffusion"] == "folgar_tucker" and values["C_I"] == 0.01
    assert values["A2"][0][0] == pytest.approx(0.7769, abs=1e-3)


def test_the_state_that_the_case_gives_has_a4_and_its_rate(tmp_path):
    folgar_tucker = IARD.format(c_m=0, kind="shear").replace("iard", "folgar_tucker").replace("C_M = 0\n", "")
    case = written(tmp_path, folgar_tucker + '[fibers]\norientation = [0.6, 0.3, 0.1]\n[solution]\nclosure = "linear"\n')
    _, values = result_of(tmp_path, case)
    a = [0.6, 0.3, 0.1]
    assert values["A2_start"] == [[0.6, 0, 0], [0, 0.3, 0], [0, 0, 0.1]]
    # The linear closure, A_ijkl = -(d_ij d_kl + ...)/35 + (a_ij d_kl + ...)/7, by hand.
    assert values["A4_start"][0] == pytest.approx(-3 / 35 + 6 * a[0] / 7)
    assert values["A4_start"][1] == pytest.approx(-1 / 35 + (a[0] + a[1]) / 7)
    assert values["A4_start"][35] == pytest.approx(values["A4_start"][1])
    # DA/Dt in shear dv_1/dx_2 = 1: 12 is a22 - 2 a1212; 11 is 2 C_I (1 - 3 a11).
    rate = values["A2_rate_start_per_s"]
    assert rate[0][1] == pytest.approx(a[1] - 2 * values["A4_start"][35])
    assert rate[0][0] == pytest.approx(2 * 0.02 * (1 - 3 * a[0]))
    norm = math.sqrt(sum(one * one for row in values["A2_rate_per_s"] for one in row))
    assert norm == pytest.approx(values["final_rate_per_s"])
    assert len(values["A4"]) == 36


@pytest.mark.parametrize("closure", ["ibof", "orf", "exact"])
def test_a_short_run_finds_the_steady_state_of_a_long_one(tmp_path, closure):
    words = ("--set", "diffusion.name=iard", "--set", "diffusion.C_M=0.3", "--set", f"solution.closure={closure}",
             "--set", "solution.distribution=no")
    case = CASES / "10_orientation_shear" / "case.toml"
    _, long = result_of(tmp_path / "long", case, *words, "--set", "run.duration=300 s")
    _, short = result_of(tmp_path / "short", case, *words, "--set", "run.duration=1 ms", "--set", "solution.steady=yes")
    assert short["steady"] == "found" and short["steady_decay_per_s"] > 0
    for found, followed in zip(short["steady_A2"], long["A2"], strict=True):
        assert found == pytest.approx(followed, abs=1e-6)
    assert short["steady_A4"] == pytest.approx(long["A4"], abs=1e-6)


def test_the_steady_distribution_is_found_beside(tmp_path):
    folder, values = result_of(tmp_path, CASES / "10_orientation_shear" / "case.toml", "--set", "solution.steady=yes",
                               "--set", "run.duration=1 s")
    assert values["steady_distribution_A2"][0][0] == pytest.approx(0.7271243, abs=1e-6)
    assert values["steady_A2"][0][0] == pytest.approx(0.77691, abs=1e-4)
    run("report", folder)
    assert "Steady orientation" in (folder / "report.html").read_text(encoding="utf-8")


TUMBLING = """study = "orientation"
[fibers]
orientation = [[0.5, 0, 0], [0, 0.3, 0], [0, 0, 0.2]]
aspect_ratio = 5
[diffusion]
name = "jeffery"
[flow]
rate = "1 1/s"
[run]
duration = "1e7 s"
[output]
interval = "1e7 s"
"""


def test_a_span_that_cannot_be_followed_is_told_with_the_keys_that_help(tmp_path):
    refused = run("run", written(tmp_path, TUMBLING), "--out", tmp_path / "r", expect=3)
    assert "cannot be followed from 0 s to 1e+07 s, 1e+07 units of strain, in 1000000 steps within the tolerance" in refused.stderr
    assert "raise solution.tolerance or lower run.duration" in refused.stderr


def test_a_start_that_the_harmonics_do_not_resolve_has_a_place(tmp_path):
    case = written(tmp_path, TUMBLING.replace("[[0.5, 0, 0], [0, 0.3, 0], [0, 0, 0.2]]", "[[0.9, 0, 0], [0, 0.05, 0], [0, 0, 0.05]]"))
    refused = run("check", case, "--set", "solution.distribution=yes", "--set", "solution.degree=8", expect=2)
    assert "case.toml:3:15: fibers.orientation" in refused.stderr and "raise solution.degree" in refused.stderr


def test_where_there_is_no_steady_state_the_run_says_why(tmp_path):
    case = written(tmp_path, IARD.format(c_m=0.5, kind="shear"))
    _, values = result_of(tmp_path, case, "--set", "diffusion.C_I=0", "--set", "solution.steady=yes",
                          "--set", "solution.closure=exact")
    assert values["steady"].startswith("there is no steady orientation") and "steady_A2" not in values
    refused = run("check", case, "--set", "flow.rate=0", "--set", "solution.steady=yes", expect=2)
    assert "solution.steady = yes: nothing deforms" in refused.stderr.replace('"', "")


def test_rows_stand_at_the_times_that_are_chosen(tmp_path):
    case = written(tmp_path, IARD.format(c_m=0.5, kind="shear"))
    folder, _ = result_of(tmp_path, case, "--set", 'output.times=["100 ms", "3 s"]')
    assert column(folder, "time_s") == [0, 0.1, 3, 5]
    folder, _ = result_of(tmp_path / "both", case, "--set", 'output.times=["100 ms"]', "--set", "output.interval=2 s")
    assert column(folder, "time_s") == [0, 0.1, 2, 4, 5]
    refused = run("check", case, "--set", 'output.times=["6 s"]', expect=2)
    assert "output.times" in refused.stderr and "6 s comes after the end, run.duration" in refused.stderr
