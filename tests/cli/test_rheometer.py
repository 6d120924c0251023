"""The study rheometer: its tables, what a resumed run keeps, what is refused."""
import pathlib
import re
import subprocess

import pytest

from small_case import PROGRAM, column, run, series, summary

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
DOCS = pathlib.Path(__file__).parents[2] / "docs" / "formats"


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
    again = run("resume", tmp_path / "r")
    assert "at its end already" in again.stdout + again.stderr


def test_resumes_bitwise_wherever_it_stopped(tmp_path):
    case = write(tmp_path)
    run("run", case, "--out", tmp_path / "whole", "--threads", 2)
    run("run", case, "--out", tmp_path / "parts", "--steps", 13, "--threads", 1)
    assert summary(tmp_path / "parts")["stop_reason"] == "steps_reached"
    run("resume", tmp_path / "parts", "--steps", 700)
    assert 0 < summary(tmp_path / "parts")["runs_done"] < 8
    run("resume", tmp_path / "parts", "--steps", 301)
    run("resume", tmp_path / "parts", "--threads", 2)
    for table in TABLES:
        assert series(tmp_path / "whole", table) == series(tmp_path / "parts", table)


def named_in(words):
    """Names what a cell of a table of the docs names: "`a11` … `a23`" the ends only."""
    return re.findall(r"`([^`…]+)`", words)


def test_docs_name_every_column_and_key(tmp_path):
    run("run", write(tmp_path), "--out", tmp_path / "r")
    cells = re.findall(r"^\| ([^|]+) \|", (DOCS / "rheometer.md").read_text(encoding="utf-8"), re.M)
    documented = {name for cell in cells for name in named_in(cell)}
    between = re.compile(r"a[123]{2}([123]{2})?|stress_[123]{2}_Pa|.*_(error|lower|upper)")  # told by their ends
    for table in TABLES:
        missing = {name for name in series(tmp_path / "r", table)[0] if name not in documented and not between.fullmatch(name)}
        assert not missing
    page = (DOCS / "summary.md").read_text(encoding="utf-8")
    missing = {key for key in summary(tmp_path / "r") if f"`{key}`" not in page and not between.fullmatch(key)}
    assert missing <= {"particle_number_dinh_armstrong"}


@pytest.mark.parametrize("changes", [[], [('flows = ["shear", "uniaxial"]\n', 'volume_fractions = ["2 %", "4 %"]\n'),
                                          ('volume_fraction = "4 %"\n', "")]], ids=["flows", "fractions"])
def test_report_opens_before_and_after_the_end(tmp_path, changes):
    case = write(tmp_path, *changes)
    for steps in (["--steps", 5], ["--steps", 700], []):
        run("run", case, "--out", tmp_path / "r", "--overwrite", *steps)
        tried = subprocess.run([PROGRAM, "report", tmp_path / "r"], capture_output=True, text=True, timeout=300, check=False)
        if "without the HTML report" in tried.stderr:
            pytest.skip("this program was built without the report")
        assert tried.returncode == 0, tried.stderr
    page = (tmp_path / "r" / "report.html").read_text(encoding="utf-8")
    assert "Rheology of fibers in melt" in page and "Relative viscosity" in page


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
