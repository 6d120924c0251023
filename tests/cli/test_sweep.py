"""Sweeps: one case, many values, one table."""
import csv
import signal
import subprocess
import time

import pytest

from small_case import PROGRAM, run, summary

CASE = """study = "orientation"
[diffusion]
name = "folgar_tucker"
C_I = 0.01
[flow]
rate = "1 1/s"
[solution]
steady = "yes"
[run]
duration = "2 s"
[output]
times = ["1 s"]
"""


@pytest.fixture(name="case")
def written_case(tmp_path):
    path = tmp_path / "turn.toml"
    path.write_text(CASE, encoding="utf-8")
    return path


def table(folder):
    with open(folder / "sweep.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_every_combination_runs_into_a_folder_and_a_row(tmp_path, case):
    out = tmp_path / "sweep"
    told = run("run", case, "--out", out, "--sweep", "diffusion.C_I=0.003,0.03", "--sweep", "solution.closure=ibof,orf")
    assert "table of 4 of 4 runs" in told.stdout
    rows = table(out)
    assert [row["run"] for row in rows] == ["1_C_I=0.003_closure=ibof", "2_C_I=0.003_closure=orf",
                                            "3_C_I=0.03_closure=ibof", "4_C_I=0.03_closure=orf"]
    assert [row["diffusion.C_I"] for row in rows] == ["0.003", "0.003", "0.03", "0.03"]
    for row in rows:
        values = summary(out / row["run"])
        assert values["closure"] == row["closure"] == row["solution.closure"]
        assert float(row["steady_A2_11"]) == values["steady_A2"][0][0]
        assert float(row["steady_decay_per_s"]) == values["steady_decay_per_s"]
        assert row["stop_reason"] == "done" and "A4" not in row
    assert float(rows[0]["steady_A2_11"]) > float(rows[2]["steady_A2_11"])


def test_a_sweep_run_equals_a_run_of_its_own(tmp_path, case):
    run("run", case, "--out", tmp_path / "sweep", "--sweep", "fibers.orientation=isotropic,[0.6, 0.3, 0.1]")
    run("run", case, "--out", tmp_path / "alone", "--set", "fibers.orientation=[0.6, 0.3, 0.1]")
    folder = tmp_path / "sweep" / "2_orientation=_0.6__0.3__0.1_"
    assert (folder / "series.csv").read_bytes() == (tmp_path / "alone" / "series.csv").read_bytes()
    assert (folder / "case.resolved.toml").read_bytes() == (tmp_path / "alone" / "case.resolved.toml").read_bytes()


def test_all_values_are_checked_before_anything_runs(tmp_path, case):
    out = tmp_path / "sweep"
    refused = run("run", case, "--out", out, "--sweep", "diffusion.C_I=0.01,-1,many", expect=2)
    assert "command line: diffusion.C_I = -1" in refused.stderr and 'diffusion.C_I = "many"' in refused.stderr
    assert not out.exists()
    refused = run("run", case, "--out", out, "--sweep", "diffusion.C_J=0.01", expect=2)
    assert "did you mean diffusion.C_I?" in refused.stderr
    refused = run("run", case, "--sweep", "diffusion.C_I", cwd=tmp_path, expect=2)
    assert "this is not a key with values" in refused.stderr
    assert not (tmp_path / "results").exists()


def test_an_existing_sweep_is_replaced_only_when_told(tmp_path, case):
    sweep = ["run", case, "--sweep", "diffusion.C_I=0.01,0.02"]
    run(*sweep, cwd=tmp_path)
    out = tmp_path / "results" / "turn_sweep"
    before = (out / "sweep.csv").read_bytes()
    assert "already holds a result" in run(*sweep, cwd=tmp_path, expect=2).stderr
    assert (out / "sweep.csv").read_bytes() == before
    run(*sweep, "--overwrite", "--set", "run.duration=3", cwd=tmp_path)
    assert [row["simulated_s"] for row in table(out)] == ["3", "3"]


def test_a_signal_ends_the_sweep_with_the_run_that_it_meets(tmp_path, case):
    out = tmp_path / "sweep"
    values = ",".join(str(0.001 + 1e-5 * i) for i in range(300))
    with subprocess.Popen([PROGRAM, "run", case, "--out", out, "--set", "solution.distribution=yes",
                           "--sweep", f"diffusion.C_I={values}"], stdout=subprocess.PIPE, text=True) as process:
        process.stdout.readline()  # the first run has ended
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=120)
    # Between two runs the signal ends the program as it ends any other.
    assert process.returncode in (4, -signal.SIGINT)
    rows = table(out)
    assert 1 <= len(rows) < 300
    # The run that the signal met has no summary: this study has no checkpoints.
    assert all((out / row["run"] / "summary.json").exists() for row in rows[:-1])
    assert {row["stop_reason"] for row in rows[:-1]} <= {"done"}
    assert rows[-1]["stop_reason"] in ("done", "signal")
