"""Runs that end between two of their steps: between checkpoint and outcome, and while a result is moved."""
import signal
import subprocess
import time

import pytest

from small_case import CASE, PROGRAM, run, series, summary, write_case

CLUSTER = """study = "cluster"
[cell]
size = "0.5 mm"
[fibers]
diameter = "19 um"
youngs_modulus = "73 GPa"
length = "0.3 mm"
rod_length = "0.1 mm"
volume_fraction = "4 %"
"""
ORIENTATION = """study = "orientation"
[diffusion]
name = "folgar_tucker"
[flow]
rate = "1 1/s"
[run]
duration = "1e5 s"
[output]
interval = "1 s"
"""
ATTRITION = """study = "attrition"
[law]
name = "durin"
C_B = 0.02
zeta = 3
S = 0.25
[melt]
eta_0 = "200 Pa s"
[flow]
rate = "100 1/s"
[fibers]
length = "10 mm"
bins = 1000
[run]
duration = "1000 s"
[output]
interval = "0.1 s"
"""
MEASUREMENT = """study = "measurement"
[lengths]
file = "lengths.csv"
unit = "um"
[statistics]
resamples = 1000000
"""
# What resuming does not bring back: the outcome of a process that was killed before it was written.
OUTCOME_OF = {"cluster": ["summary.json", "result.vtkhdf"], "shear_cell": ["summary.json"]}


def forget_the_end(result):
    """Makes a result what it is when its process was killed after the last checkpoint, before its outcome."""
    record = (result / ".fiberfate").read_text(encoding="utf-8")
    assert record.endswith("end\n")
    (result / ".fiberfate").write_text(record.removesuffix("end\n"), encoding="utf-8")


@pytest.mark.parametrize("study", ["cluster", "shear_cell"])
def test_a_kill_between_the_last_checkpoint_and_the_outcome_loses_no_outcome(tmp_path, study):
    case = write_case(tmp_path, CASE if study == "shear_cell" else CLUSTER)
    run("run", case, "--out", tmp_path / "r", "--threads", 1)
    before = summary(tmp_path / "r")
    forget_the_end(tmp_path / "r")
    for name in OUTCOME_OF[study]:
        (tmp_path / "r" / name).unlink()
    run("resume", tmp_path / "r")
    after = summary(tmp_path / "r")
    for key in ("A2", "L_N_m", "L_W_m", "fibers", "rods", "stop_reason", "volume_fraction"):
        assert before[key] == after[key], key
    assert (tmp_path / "r" / "result.vtkhdf").exists()
    kept = (tmp_path / "r" / "summary.json").read_bytes()
    run("resume", tmp_path / "r")
    assert (tmp_path / "r" / "summary.json").read_bytes() == kept, "a whole outcome stays"


@pytest.mark.parametrize("text", [ORIENTATION, ATTRITION, MEASUREMENT], ids=["orientation", "attrition", "measurement"])
def test_studies_without_checkpoints_stop_for_a_signal_and_begin_again(tmp_path, text):
    (tmp_path / "lengths.csv").write_text("length\n" + "".join(f"{100 + k}\n" for k in range(1000)), encoding="utf-8")
    process = subprocess.Popen([PROGRAM, "run", write_case(tmp_path, text), "--out", tmp_path / "r"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while not (tmp_path / "r" / "log.txt").exists():
        time.sleep(0.01)
    time.sleep(0.2)
    process.send_signal(signal.SIGTERM)
    _, words = process.communicate(timeout=300)
    assert process.returncode == 4 and "stopped; resuming begins again" in words
    process = subprocess.Popen([PROGRAM, "resume", tmp_path / "r"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    said = process.stderr.readline()
    process.kill()
    process.communicate(timeout=300)
    assert "there is no checkpoint to go on from: the run begins again" in said


def moved(result, waiting):
    """Moves a result where it waits while another one takes its place; its record stays."""
    (result / waiting).mkdir()
    for path in list(result.iterdir()):
        if path.name not in (".fiberfate", waiting):
            path.rename(result / waiting / path.name)


@pytest.mark.parametrize("waiting, record_is_new", [(".fiberfate-moving", False), (".fiberfate-replaced", True)])
@pytest.mark.parametrize("words", ["resume", "run"])
def test_a_kill_while_a_result_is_moved_away_loses_none_of_it(tmp_path, waiting, record_is_new, words):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "r", "--steps", 5)
    before = {path.name: path.read_bytes() for path in (tmp_path / "r").iterdir() if path.name not in (".fiberfate", "log.txt")}
    moved(tmp_path / "r", waiting)
    if record_is_new:
        (tmp_path / "r" / ".fiberfate").write_text("# Files\n", encoding="utf-8")
    if words == "run":
        assert "already holds a result" in run("run", case, "--out", tmp_path / "r", expect=2).stderr
        assert {name: (tmp_path / "r" / name).read_bytes() for name in before} == before
    run("resume", tmp_path / "r", "--steps", 1)
    assert summary(tmp_path / "r")["steps"] == 6
    assert not (tmp_path / "r" / waiting).exists()


def shell(line):
    return subprocess.run(["bash", "-c", line], capture_output=True, text=True, timeout=120, check=False)


def test_words_that_nobody_can_hear_end_nothing(tmp_path):
    case = write_case(tmp_path)
    assert shell(f"'{PROGRAM}' check nowhere.toml 2>/dev/full").returncode == 2
    assert shell(f"set -o pipefail; '{PROGRAM}' explain --markdown | head -1").returncode == 0
    gone = shell(f"'{PROGRAM}' run '{case}' --out '{tmp_path}/r' --steps 3 --progress line 2>&1 >/dev/null | true; exit ${{PIPESTATUS[0]}}")
    assert gone.returncode == 0 and summary(tmp_path / "r")["steps"] == 3


BESIDE = (CASE.replace('rate = "200 1/s"\nviscosity = "1000 Pa s"', 'kind = "table"\ntable = [["18 ms", "200 1/s", "1000 Pa s"], ["1 s", "100 1/s", "1000 Pa s"]]')
          .replace('interval = "1 ms"\nframe', 'interval = "6 ms"\nframe').replace('frame_interval = "4 ms"', 'frame_interval = "6 ms"'))


def test_an_output_beside_a_change_of_the_flow_is_not_lost_on_resuming(tmp_path):
    """3 x 6 ms is 18 ms and one unit of round-off: a stop between the two must not skip the row that comes next."""
    case = write_case(tmp_path, BESIDE)
    run("run", case, "--out", tmp_path / "whole", "--threads", 1)
    run("run", case, "--out", tmp_path / "r", "--threads", 1, "--steps", summary(tmp_path / "whole")["steps"] - 12)
    while summary(tmp_path / "r")["stop_reason"] != "done":
        run("resume", tmp_path / "r", "--steps", 1)
    assert series(tmp_path / "r") == series(tmp_path / "whole")
