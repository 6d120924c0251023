"""Reports of runs that were killed: what there is is shown, and the folder stays as it was otherwise."""
import pathlib
import signal
import subprocess
import time

import pytest

from small_case import PROGRAM, run, write_case

PLAQUE = pathlib.Path(__file__).resolve().parents[2] / "cases" / "30_plaque" / "case.toml"


def kill_when(there, *words):
    """Runs the program and kills it as soon as `there` says so."""
    with subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        begin = time.monotonic()
        while process.poll() is None and not there() and time.monotonic() - begin < 120:
            time.sleep(0.002)
        alive = process.poll() is None
        process.send_signal(signal.SIGKILL)
    assert alive, "the run ended before it could be killed"


def report_of(folder):
    """Writes the report and returns its page; nothing else in the folder changes but the record."""
    before = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file() and path.name != ".fiberfate"}
    run("report", folder)
    after = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file() and path.name != ".fiberfate"}
    page = after.pop("report.html")
    assert after == before
    return page.decode("utf-8")


@pytest.mark.parametrize("interval", ["0.01 s", "300 s"], ids=["checkpoint", "no_checkpoint"])
def test_a_killed_filling_is_shown(tmp_path, interval):
    out = tmp_path / "r"
    wanted = out / ("checkpoint.h5" if interval == "0.01 s" else "result.vtkhdf")
    kill_when(lambda: wanted.exists() and (out / "result.vtkhdf").exists(), "run", PLAQUE, "--out", out, "--set",
              "numerics.steps=1200", "--set", f"output.checkpoint_interval={interval}")
    assert not (out / "summary.json").exists()
    assert (out / "checkpoint.h5").exists() == (interval == "0.01 s")
    assert "unfinished" in report_of(out)


def test_a_killed_cell_is_shown(tmp_path):
    out = tmp_path / "r"
    text = pathlib.Path(write_case(tmp_path)).read_text(encoding="utf-8").replace('duration = "20 ms"', 'duration = "10 s"')
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    kill_when(lambda: (out / "checkpoint.h5").exists() and (out / "result.vtkhdf").exists(), "run", tmp_path / "case.toml",
              "--out", out)
    assert "unfinished" in report_of(out)


def test_a_run_without_anything_to_show_says_so(tmp_path):
    out = tmp_path / "r"
    run("run", PLAQUE, "--out", out, "--steps", 1)
    for name in ("summary.json", "result.vtkhdf"):
        (out / name).unlink(missing_ok=True)
    failed = run("report", out, expect=2)
    assert "has nothing to show" in failed.stderr and "fiberfate resume" in failed.stderr


def test_a_row_that_is_half_written_is_left_out(tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r")
    series = tmp_path / "r" / "series.csv"
    series.write_bytes(series.read_bytes() + b"0.5,12")
    report_of(tmp_path / "r")
