"""The study rheometer: its tables, what a resumed run keeps, what is refused."""
import pytest

from small_case import column, run, series, summary

CASE = """study = "rheometer"

[run]
seed = 7

[sweep]
flows = ["shear", "uniaxial"]
rates = ["10 1/s", "40 1/s"]
replicas = 2
strain = 1.5

[fibers]
count = 12
volume_fraction = "4 %"
diameter = "19 um"
length = "0.4 mm"
rod_length = "0.1 mm"
youngs_modulus = "10 GPa"

[flow]
viscosity = "200 Pa s"
"""
TABLES = ("rheometer.csv", "curves.csv", "fits.csv")


def write(folder, *changes):
    text = CASE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "case.toml").write_text(text, encoding="utf-8")
    return str(folder / "case.toml")


def test_runs_all_points_and_replicas(tmp_path):
    done = run("run", write(tmp_path), "--out", tmp_path / "r", "--threads", 1)
    assert "viscosity over the melt's" in done.stdout and "N_p" in done.stdout
    assert column(tmp_path / "r", "point", "rheometer.csv") == [0, 0, 1, 1, 2, 2, 3, 3]
    assert column(tmp_path / "r", "replica", "rheometer.csv") == [0, 1] * 4
    assert column(tmp_path / "r", "flow", "curves.csv") == [0, 0, 2, 2]
    assert column(tmp_path / "r", "rate_per_s", "curves.csv") == [10, 40, 10, 40]
    assert column(tmp_path / "r", "strain", "curves.csv") == pytest.approx([1.5] * 4)
    viscosities = column(tmp_path / "r", "relative_viscosity", "curves.csv")
    assert all(value > 1 for value in viscosities)
    values = summary(tmp_path / "r")
    assert values["relative_viscosity"] == viscosities and values["runs_done"] == 8
    assert values["particle_number"] == column(tmp_path / "r", "particle_number", "fits.csv")
    run("report", tmp_path / "r")
    again = run("resume", tmp_path / "r")
    assert "at its end already" in again.stdout + again.stderr


def test_resumes_bitwise_wherever_it_stopped(tmp_path):
    case = write(tmp_path)
    run("run", case, "--out", tmp_path / "whole", "--threads", 2)
    run("run", case, "--out", tmp_path / "parts", "--steps", 13, "--threads", 1)
    assert summary(tmp_path / "parts")["stop_reason"] == "steps_reached"
    run("resume", tmp_path / "parts", "--steps", 700)
    assert 0 < summary(tmp_path / "parts")["runs_done"] < 8
    run("report", tmp_path / "parts")
    run("resume", tmp_path / "parts", "--steps", 301)
    run("resume", tmp_path / "parts", "--threads", 2)
    for table in TABLES:
        assert series(tmp_path / "whole", table) == series(tmp_path / "parts", table)


def test_one_replica_has_the_errors_of_its_series(tmp_path):
    case = write(tmp_path, ("replicas = 2", "replicas = 1"), ('flows = ["shear", "uniaxial"]\n', ""))
    run("run", case, "--out", tmp_path / "r")
    for name in ("relative_viscosity_error", "N1_error_Pa"):
        assert column(tmp_path / "r", name, "curves.csv") == column(tmp_path / "r", name, "rheometer.csv")
        assert all(error > 0 for error in column(tmp_path / "r", name, "curves.csv"))


def test_checks_with_an_estimate(tmp_path):
    done = run("check", write(tmp_path))
    assert "points" in done.stdout and "runs" in done.stdout


@pytest.mark.parametrize("changes, message", [
    ([('flows = ["shear", "uniaxial"]\nrates = ["10 1/s", "40 1/s"]\n', "")], "sweep.rates: not given, and no other list either"),
    ([("[flow]\n", '[flow]\nrate = "3 1/s"\n')], 'sweep.rates = ["10 1/s", "40 1/s"]: contradicts flow.rate = "3 1/s" (line'),
    ([("[flow]\n", '[flow]\ntype = "planar"\n')], 'contradicts flow.type = "planar" (line'),
    ([('"uniaxial"', '"triaxial"')], 'sweep.flows = "triaxial": there is no such flow'),
    ([('"uniaxial"', '"gradient"')], 'flows of type "gradient" have no rate'),
    ([("strain = 1.5\n", "")], "run.duration: not given"),
    ([("seed = 7", 'seed = 7\nduration = "1 s"')], "sweep.strain = 1.5: contradicts run.duration"),
    ([('"10 1/s"', '"0 1/s"')], "a melt at rest never comes to sweep.strain"),
    ([('rates = ["10 1/s", "40 1/s"]', "rates = []")], "sweep.rates = []: the list is empty"),
    ([('rates = ["10 1/s", "40 1/s"]', 'rates = ["10 1/s"]\nvolume_fractions = ["4 %", "90 %"]'),
      ('volume_fraction = "4 %"\n', "")], 'fibers.volume_fraction = "90 %"'),
    ([("replicas = 2", "replicas = 0")], "sweep.replicas = 0"),
    ([("viscosity = ", '[output]\nstress_steps = 0\n[boundary]\ny = "walls"\n[flow]\nviscosity = '), ("[flow]\n[output]", "[output]")],
     "without readings of the stress"),
])
def test_refuses_what_cannot_be_run(tmp_path, changes, message):
    done = run("check", write(tmp_path, *changes), expect=2)
    assert message in done.stderr
