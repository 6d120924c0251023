"""Calibration in molds: known parameters come out again, coupled and not, and what a user is told of mistakes."""
import json
import re
from pathlib import Path

import pytest

from small_case import column, run, summary

CASES = Path(__file__).resolve().parents[2] / "cases"
PLAQUE = """study = "molding"
[part]
kind = "plaque"
length = "305 mm"
width = "102 mm"
thickness = "1.5 mm"
mesh_size = "20 mm"
[material]
preset = "ppgf20"
[machine]
fill_time = "1.5 s"
melt_temperature = "523.15 K"
mold_temperature = "323.15 K"
[fibers]
length = "5 mm"
[numerics]
layers = 8
steps = 60
[output]
places = [["Loc.1", "30 mm", "51 mm"], ["Loc.2", "150 mm", "51 mm"], ["Loc.3", "260 mm", "51 mm"]]
"""
COUPLED = ["fibers.coupling=informed_isotropic", "fibers.trouton_term=10"]
CASE = """study = "calibration"
[law]
name = "unbreakable_length"
lambda = 0.124
xi = 1e-3
sigma_u = "2 GPa"
d_f = "19 um"
[conditions]
names = ["long", "short"]
lengths = ["5 mm", "2 mm"]
moldings = [["plaque.toml"], ["plaque.toml", "machine.fill_time=1 s"]]
[data]
lengths = {lengths}
[fit]
free = ["xi"]
"""
SWEEP = """[sweep]
parameter = "xi"
lower = 5e-4
upper = 8e-3
count = 7
"""


def measured(tmp_path, condition, xi, *changes):
    """Fills the plaque with a known xi and gives the rows of data.lengths."""
    words = [word for change in [*changes, f"law.xi={xi}"] for word in ("--set", change)]
    run("run", tmp_path / "plaque.toml", "--out", tmp_path / "truth", "--overwrite", "--progress", "none", *words)
    values = summary(tmp_path / "truth")
    return [[condition, f"Loc.{k}", "L_N", *(values[f"Loc_{k}_L_N_m"] * off for off in (0.98, 1.02))] for k in (1, 2, 3)]


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "plaque.toml").write_text(PLAQUE, encoding="utf-8")
    return tmp_path


def write_case(folder, rows, text=CASE):
    (folder / "case.toml").write_text(text.replace("{lengths}", json.dumps(rows)), encoding="utf-8")


def test_xi_comes_out_of_two_moldings(folder):
    rows = measured(folder, "long", 3e-3) + measured(folder, "short", 3e-3, "machine.fill_time=1 s", "fibers.length=2 mm")
    write_case(folder, rows, CASE + SWEEP)
    run("run", folder / "case.toml", "--out", folder / "r")
    values = summary(folder / "r")
    # The means of the samples are exact.
    assert values["xi"] == pytest.approx(3e-3, rel=1e-6)
    assert values["xi_lower"] < 3e-3 < values["xi_upper"]
    assert values["observations"] == 12 and values["degrees_of_freedom"] == 11
    assert values["sweep_best_value"] == pytest.approx(3e-3, rel=1e-5)
    assert values["sweep_best_error_percent"] < 1e-2
    run("report", folder / "r")
    page = (folder / "r" / "report.html").read_text(encoding="utf-8")
    document = json.loads(re.search(r'id="fiberfate-document">(.*?)</script>', page, re.S).group(1))
    assert {"sweep", "lengths_0", "lengths_1", "profile_xi"} <= {section["id"] for section in document["sections"]}


def test_a_coupled_flow_is_solved_for_every_value(folder):
    rows = measured(folder, "long", 2e-3, *COUPLED) + measured(folder, "short", 2e-3, "fibers.length=2 mm")
    text = (CASE + SWEEP).replace('[["plaque.toml"], ["plaque.toml", "machine.fill_time=1 s"]]',
                                  json.dumps([["plaque.toml", *COUPLED], ["plaque.toml"]]))
    write_case(folder, rows, text.replace("[fit]", '[fit]\nscope = "separately"'))
    run("run", folder / "case.toml", "--out", folder / "r")
    values = summary(folder / "r")
    # Seven fillings and a spline between them for the coupled one; the other follows its lengths again.
    assert values["long_xi"] == pytest.approx(2e-3, rel=0.02)
    assert values["short_xi"] == pytest.approx(2e-3, rel=1e-6)
    assert column(folder / "r", "coupled", "optimum.csv") == [1, 0]
    assert column(folder / "r", "aspect_ratio", "optimum.csv") == pytest.approx([5000 / 19, 2000 / 19])
    # Lengths of the coupled plaque ask for another xi where the flow is computed without the fibers.
    text = (CASE + SWEEP).replace('"plaque.toml", "machine.fill_time=1 s"', '"plaque.toml"')
    write_case(folder, rows, text.replace("[fit]", '[fit]\nscope = "separately"'))
    run("run", folder / "case.toml", "--out", folder / "uncoupled")
    assert abs(summary(folder / "uncoupled")["long_xi"] / 2e-3 - 1) > 0.01


def complaint(folder):
    done = run("run", folder / "case.toml", "--out", folder / "r", expect=2)
    assert not (folder / "r").exists()
    return done.stderr


ROWS = [["long", "Loc.1", "L_N", "4 mm"], ["short", "Loc.2", "L_N", "1.5 mm"]]


@pytest.mark.parametrize("old, new, told", [
    ('"machine.fill_time=1 s"', '"machine.fil_time=1 s"', r"case\.toml:11:12: conditions\.moldings = .*machine\.fil_time = .*did you mean"),
    ('["plaque.toml"]', '["plaqe.toml"]', r"case\.toml:11:12: conditions\.moldings = .*plaqe\.toml"),
    ('["plaque.toml"]', '["plaque.toml", "thick"]', r"conditions\.moldings = .*thick"),
    ('["plaque.toml"], ["plaque.toml", "machine.fill_time=1 s"]', '["plaque.toml"], ["plaque.toml"], ["plaque.toml"]', "3 entries for 2 conditions"),
    ('name = "unbreakable_length"', 'name = "phelps"', r"law\."),
    ('names = ["long", "short"]', 'names = ["long", "brief"]', r"data\.lengths = .*there is no condition 'short'.*conditions\.names are long, brief"),
    ("[fit]", 'series = [["long", "L_N", "1.5 mm"]]\n[fit]', "give what was measured in data.lengths"),
    ('lengths = ["5 mm", "2 mm"]', 'lengths = ["5 mm", "2 mm"]\nrates = ["5 1/s"]', r"conditions\.rates = .*whose flow is computed"),
    ('["plaque.toml"]', '["plaque.toml", "fibers.coupling=informed_isotropic"]', r"fit\.free = .*the flow of 'long' feels the fibers.*leave one parameter free and sweep that"),
])
def test_mistakes_are_explained(folder, old, new, told):
    assert old in CASE
    write_case(folder, ROWS, CASE.replace(old, new, 1))
    assert re.search(told, complaint(folder)), complaint(folder)


def test_wrong_places_and_rows_are_explained(folder):
    write_case(folder, [["long", "Loc.9", "L_N", "4 mm"], *ROWS])
    assert re.search(r"case\.toml:13:11: data\.lengths = .*'long' has no place \"Loc\.9\": did you mean \"Loc\.1\"\?", complaint(folder))
    write_case(folder, [["long", "Loc.1", "L_M", "4 mm"]])
    assert "not a condition, a place, L_N or L_W, and at least one length" in complaint(folder)
    write_case(folder, [["long", "Loc.1", "L_N", "4 kg"]])
    assert '"4 kg": ' in complaint(folder)
    write_case(folder, [])
    assert re.search(r"data\.lengths = \[\]: nothing is given that was measured", complaint(folder))


def test_a_coupled_search_begins_where_the_flow_is_computed(folder):
    text = CASE.replace('["plaque.toml"]', '["plaque.toml", "fibers.coupling=informed_isotropic"]', 1) + SWEEP
    write_case(folder, ROWS, text.replace("xi = 1e-3", "xi = 1e-4"))
    told = r"case\.toml:5:6: law\.xi = 1e-4: not between sweep\.lower = 5e-4 \(line \d+\) and sweep\.upper = 8e-3 .*begin between them"
    assert re.search(told, complaint(folder)), complaint(folder)


def test_a_molding_that_does_not_fill_is_explained(folder):
    write_case(folder, [["long", "Loc.3", "L_N", "4 mm"], ["short", "Loc.3", "L_N", "1 mm"]],
               CASE.replace('["plaque.toml"]', '["plaque.toml", "machine.pressure_limit=10 MPa"]', 1))
    assert re.search(r"no melt comes to \"Loc\.\d\": the filling ended \(short_shot\)", complaint(folder))
    other = (CASES / "25_xi_sweep" / "case.toml").as_posix()
    write_case(folder, ROWS, CASE.replace('["plaque.toml"]', f'["{other}"]', 1))
    assert 'study = "calibration": only cases of the study "molding" belong here: name one' in complaint(folder)


def test_four_parameters_come_out_of_six_moldings(tmp_path):
    run("run", CASES / "29_stress_law_in_mold" / "case.toml", "--out", tmp_path / "r", "--progress", "none")
    values = summary(tmp_path / "r")
    for name, true in (("lambda", 4.4e-3), ("alpha", 0.8), ("k_0", 4.3e5), ("beta", 1.2)):
        assert values[f"{name}_lower"] < true < values[f"{name}_upper"], name
    assert values["alpha_standard_error"] < 0.05 and values["beta_standard_error"] < 0.03
    assert values["noise_scale"] == pytest.approx(1, abs=3 / (2 * 188) ** 0.5)
    assert "hardly told apart" in values["finding_1"]
