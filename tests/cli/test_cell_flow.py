"""Cells in any flow: what runs, what is refused with what would work, and what a resumed run keeps."""
import math

import pytest

from small_case import column, run, series, summary
from test_resume import assert_same_result

CASE = """study = "shear_cell"

[run]
duration = "60 ms"
seed = 7

[fibers]
count = 30
volume_fraction = "6 %"
diameter = "19 um"
length = "0.6 mm"
rod_length = "0.1 mm"
youngs_modulus = "10 GPa"

[flow]
{flow}
viscosity = "200 Pa s"

[breakage]
law = "fixed"

[output]
interval = "5 ms"
frame_interval = "20 ms"
"""


def write(folder, flow, **changes):
    text = CASE.format(flow=flow)
    for old, new in changes.values():
        assert old in text
        text = text.replace(old, new)
    (folder / "case.toml").write_text(text, encoding="utf-8")
    return str(folder / "case.toml")


UNIAXIAL = 'type = "uniaxial"\nrate = "40 1/s"'


def test_resumes_bitwise_in_elongation_across_changes_of_basis(tmp_path):
    case = write(tmp_path, UNIAXIAL)
    run("run", case, "--out", tmp_path / "whole", "--threads", 2)
    assert column(tmp_path / "whole", "hencky_strain")[-1] == pytest.approx(2.4)
    assert column(tmp_path / "whole", "a11")[-1] > 0.9
    run("run", case, "--out", tmp_path / "parts", "--steps", 37, "--threads", 1)
    run("resume", tmp_path / "parts", "--steps", 11)
    run("resume", tmp_path / "parts", "--threads", 2)
    assert_same_result(tmp_path / "whole", tmp_path / "parts")
    assert summary(tmp_path / "whole")["relative_viscosity_mean"] == summary(tmp_path / "parts")["relative_viscosity_mean"]


@pytest.mark.parametrize("flow", ['type = "planar"\nrate = "20 1/s"', 'type = "biaxial"\nrate = "-20 1/s"',
                                  'type = "mixed"\nalpha = -0.5\nrate = "20 1/s"',
                                  'type = "mixed"\nalpha = 0.5\nrate = "20 1/s"',
                                  'type = "gradient"\ngradient = [[6, 20, 0, 0, -6, 0, 0, 0, 0]]'])
def test_every_type_runs_and_adds_up(tmp_path, flow):
    run("run", write(tmp_path, flow), "--out", tmp_path / "r")
    for pair in ("11", "22", "33", "12", "13", "23"):
        total = column(tmp_path / "r", f"stress_{pair}_Pa")[-1]
        causes = [column(tmp_path / "r", f"stress_{cause}_{pair}_Pa")[-1]
                  for cause in ("drag", "tension", "bending", "contact", "friction")]
        assert sum(causes) == pytest.approx(total, abs=1e-9 * sum(map(abs, causes)))
    assert column(tmp_path / "r", "relative_viscosity")[-1] > 1


def test_oscillation_comes_back_every_period(tmp_path):
    case = write(tmp_path, 'type = "shear"\nkind = "oscillation"\nrate = "50 1/s"\nperiod = "20 ms"')
    run("run", case, "--out", tmp_path / "r")
    times, strains = column(tmp_path / "r", "time_s"), column(tmp_path / "r", "strain")
    for time, strain in zip(times, strains):
        expected = 50 * 0.02 / (2 * math.pi) * math.sin(2 * math.pi * time / 0.02)
        assert strain == pytest.approx(expected, abs=1e-12)
    run("resume", tmp_path / "r", "--until", "100 ms")
    assert abs(column(tmp_path / "r", "strain")[-1]) < 1e-12


REFUSED = {
    "volume": ('type = "gradient"\ngradient = [[1, 0, 0, 0, 1, 0, 0, 0, 1]]', "changes the volume"),
    "vortex": ('type = "gradient"\ngradient = [[1, 9, 0, -9, 1, 0, 0, 0, -2]]', "no lattice comes back to itself"),
    "shear across": ('type = "gradient"\ngradient = [[0, 0, 9, 0, 0, 0, 0, 0, 0]]', "a box would be flat at"),
    "no gradient": ('type = "gradient"', "flow.gradient"),
    "no period": ('kind = "oscillation"\nrate = "1 1/s"', "flow.period"),
    "thin": ('type = "gradient"\ngradient = [[0.02, 20, 0, 0, -0.02, 0, 0, 0, 0]]', "take a cell of at least"),
    "empty row": ('type = "gradient"\nkind = "table"\ngradient_table = [[]]', "gradient_table"),
    "short row": ('kind = "table"\ntable = [["1 s", "2 1/s"]]', "table"),
    "alpha": ('type = "mixed"\nalpha = 2\nrate = "1 1/s"', "alpha"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refuses_with_what_would_work(tmp_path, name):
    flow, words = REFUSED[name]
    told = run("check", write(tmp_path, flow), expect=2).stderr
    assert words in told, told
    assert "case.toml:" in told, told


def test_refuses_walls_in_an_elongation(tmp_path):
    case = write(tmp_path, UNIAXIAL, walls=("[breakage]", '[boundary]\ny = "walls"\n\n[breakage]'))
    told = run("check", case, expect=2).stderr
    assert "walls stand in a flow" in told and "periodic" in told


def test_a_state_made_for_another_flow_is_refused_in_words(tmp_path):
    run("run", write(tmp_path, 'rate = "20 1/s"'), "--out", tmp_path / "sheared", "--until", "5 ms")
    cluster = '[cluster]\nsource = "file"\nfile = "sheared/checkpoint.h5"\n\n[breakage]'
    text = CASE.format(flow=UNIAXIAL).replace("[breakage]", cluster)
    text = text.replace("count = 30\n", "").replace('volume_fraction = "6 %"\n', "").replace('length = "0.6 mm"\n', "")
    (tmp_path / "next.toml").write_text(text.replace('rod_length = "0.1 mm"\n', ""), encoding="utf-8")
    told = run("run", tmp_path / "next.toml", "--out", tmp_path / "r", expect=2).stderr
    assert "made" in told or "flat" in told, told
    assert "generate" in told, told


def test_no_stress_is_read_where_none_is_wanted(tmp_path):
    case = write(tmp_path, UNIAXIAL, out=("[output]\n", "[output]\nstress_steps = 0\n"))
    run("run", case, "--out", tmp_path / "r")
    rows = series(tmp_path / "r")
    assert rows[-1][rows[0].index("stress_11_Pa")] == "nan"
    assert "relative_viscosity_mean" not in summary(tmp_path / "r")
