"""Runs: what a result folder holds, and that it is true to itself."""
import json
import os
import re
import subprocess
from pathlib import Path

import h5py
import numpy
import pytest

from small_case import CASE, FIBERS, PROGRAM, ROD_LENGTH, RODS, column, run, series, summary, write_case

DOCS = Path(__file__).resolve().parents[2] / "docs" / "formats"


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = tmp_path_factory.mktemp("run")
    case = write_case(folder)
    run("run", case, "--out", folder / "result", "--threads", 2)
    return folder / "result"


def test_folder_holds_every_file(result):
    files = {path.name for path in result.iterdir()}
    assert files == {"case.resolved.toml", "summary.json", "series.csv", "breaks.csv", "result.vtkhdf",
                     "checkpoint.h5", "checkpoint.previous.h5", "log.txt", ".fiberfate"}


def test_summary_agrees_with_the_last_row_of_the_series(result):
    values = summary(result)
    assert values["study"] == "shear_cell"
    assert values["stop_reason"] == "done"
    assert values["seed"] == 7
    assert values["threads"] == 2
    assert values["ranks"] == 1
    assert values["simulated_s"] == pytest.approx(0.02, rel=1e-12)
    for key, name in {"L_N_m": "L_N_m", "L_W_m": "L_W_m", "breaks": "breaks", "rods": "rods", "fibers": "fibers",
                      "steps": "steps", "max_overlap_radii": "max_overlap_radii", "contacts": "contacts",
                      "strain": "strain", "min_radius_m": "min_radius_m"}.items():
        assert values[key] == column(result, name)[-1], key
    for i in range(3):
        for j in range(i, 3):
            assert values["A2"][i][j] == column(result, f"a{i + 1}{j + 1}")[-1]
    assert numpy.trace(values["A2"]) == pytest.approx(1, abs=1e-12)
    assert values["segment_steps_per_s"] > 0
    assert set(values["timings"]) == {"neighbours", "loads", "solve", "update", "breakage", "output"}
    phases = sum(values["timings"].values())
    assert 0 < phases <= values["wall_s"] * 1.01
    assert values["stepping_s"] <= values["wall_s"]


def test_fibers_break_and_nothing_is_lost(result):
    values = summary(result)
    assert values["breaks"] > 0
    assert values["fibers"] == FIBERS + values["breaks"]
    assert values["rods"] == FIBERS * RODS
    assert values["L_N_m"] * values["fibers"] == pytest.approx(FIBERS * RODS * ROD_LENGTH, rel=1e-9)


def test_breaks_are_listed(result):
    values = summary(result)
    times = column(result, "time_s", "breaks.csv")
    assert len(times) == values["breaks"]
    assert times == sorted(times)
    checks = numpy.array(times) / 1e-3
    assert numpy.allclose(checks, numpy.round(checks), atol=1e-9), "breaks happen at checks only"
    parents = numpy.array(column(result, "parent_length_m", "breaks.csv"))
    children = numpy.array(column(result, "child_length_m", "breaks.csv"))
    assert (children < parents).all() and (children > 0).all()
    assert max(column(result, "radius_m", "breaks.csv")) <= 371e-6


def test_rows_stand_at_their_exact_times(result):
    times = numpy.array(column(result, "time_s"))
    assert len(times) == 21
    assert numpy.abs(times - 1e-3 * numpy.arange(21)).max() < 1e-15
    assert numpy.allclose(column(result, "strain"), 200 * times, rtol=1e-12, atol=0)


def test_rows_stand_at_the_times_that_are_chosen(tmp_path):
    case = write_case(tmp_path, CASE.replace('interval = "1 ms"\nframe', 'times = ["3.3 ms", "12 ms"]\nframe'))
    run("run", case, "--out", tmp_path / "chosen")
    assert column(tmp_path / "chosen", "time_s") == [0, 3.3e-3, 12e-3, 20e-3]
    run("run", case, "--out", tmp_path / "halves", "--until", "8 ms")
    run("resume", tmp_path / "halves")
    assert column(tmp_path / "halves", "time_s") == [0, 3.3e-3, 8e-3, 12e-3, 20e-3]
    run("run", case, "--out", tmp_path / "both", "--set", "output.interval=10 ms")
    assert column(tmp_path / "both", "time_s") == [0, 3.3e-3, 10e-3, 12e-3, 20e-3]


def test_frames_hold_what_the_series_says(result):
    with h5py.File(result / "result.vtkhdf") as file:
        steps = file["VTKHDF/Steps"]
        assert numpy.allclose(steps["Values"], 4e-3 * numpy.arange(6), atol=1e-15)
        fibers = file["VTKHDF/Lines/NumberOfCells"][:]
        rows = numpy.array(column(result, "fibers"))[::4]
        assert (fibers == rows).all()
        length = file["VTKHDF/CellData/length"][-int(fibers[-1]):]
        assert length.mean() == pytest.approx(column(result, "L_N_m")[-1], rel=1e-6)


def test_threads_change_nothing(result, tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "one", "--threads", 1)
    assert series(tmp_path / "one") == series(result)
    assert series(tmp_path / "one", "breaks.csv") == series(result, "breaks.csv")


def test_resolved_case_runs_to_the_same_end(result, tmp_path):
    run("run", result / "case.resolved.toml", "--out", tmp_path / "again")
    assert series(tmp_path / "again") == series(result)


def test_a_result_is_not_overwritten_unless_told_to(result, tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "r", "--steps", 2)
    (tmp_path / "r" / "notes.txt").write_text("mine")
    before = (tmp_path / "r" / "summary.json").read_bytes()
    refused = run("run", case, "--out", tmp_path / "r", expect=2)
    assert "already holds a result" in refused.stderr
    assert "--overwrite" in refused.stderr
    assert (tmp_path / "r" / "summary.json").read_bytes() == before
    run("run", case, "--out", tmp_path / "r", "--steps", 3, "--overwrite")
    assert summary(tmp_path / "r")["steps"] == 3
    assert (tmp_path / "r" / "notes.txt").read_text() == "mine"


def test_steps_and_until_stop_early(tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "steps", "--steps", 5)
    assert summary(tmp_path / "steps")["stop_reason"] == "steps_reached"
    assert summary(tmp_path / "steps")["steps"] == 5
    run("run", case, "--out", tmp_path / "until", "--until", "2.5 ms")
    assert summary(tmp_path / "until")["stop_reason"] == "time_reached"
    assert summary(tmp_path / "until")["simulated_s"] == 2.5e-3
    assert column(tmp_path / "until", "time_s")[-1] == 2.5e-3


def test_the_last_lines_say_what_came_out_and_what_to_do_next(tmp_path):
    case = write_case(tmp_path)
    folder = tmp_path / "my result"
    stopped = run("run", case, "--out", folder, "--steps", 5)
    headline, step = stopped.stdout.splitlines()
    found = summary(folder)
    assert headline.startswith(f"L_N {1e3 * found['L_N_m']:.4g} mm, L_W {1e3 * found['L_W_m']:.4g} mm, a_11 ")
    assert step == f"stopped after the steps of --steps; go on: fiberfate resume '{folder}'"
    until = run("resume", folder, "--until", "2 ms").stdout.splitlines()[-1]
    assert until == f"stopped at the time of --until; go on: fiberfate resume '{folder}'"
    done = run("resume", folder).stdout.splitlines()
    assert done[0].endswith(f"{summary(folder)['breaks']} breaks after 0.02 s")
    assert done[-1] == f"result in {folder}; look at it: fiberfate report '{folder}'"
    assert done[0] in (folder / "log.txt").read_text(encoding="utf-8")


def test_a_changed_case_starts_from_saved_fibers(tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "slow", "--until", "2 ms")
    refused = run("resume", tmp_path / "slow", "--set", "flow.rate=400", expect=2)
    assert f"fiberfate run {tmp_path / 'slow' / 'case.resolved.toml'}" in refused.stderr
    assert "cluster.file=checkpoint.h5" in refused.stderr
    run("run", tmp_path / "slow" / "case.resolved.toml", "--out", tmp_path / "fast", "--steps", 1, "--set", "flow.rate=400",
        "--set", "cluster.source=file", "--set", "cluster.file=checkpoint.h5")
    assert column(tmp_path / "fast", "L_N_m")[0] == pytest.approx(column(tmp_path / "slow", "L_N_m")[-1], rel=1e-12)


def test_default_folder_is_named_after_the_case(tmp_path):
    write_case(tmp_path)
    (tmp_path / "case.toml").rename(tmp_path / "shear.toml")
    run("run", "shear.toml", "--steps", 1, cwd=tmp_path)
    assert (tmp_path / "results" / "shear" / "summary.json").exists()


def test_a_file_that_holds_no_fibers_leaves_nothing(tmp_path):
    case = write_case(tmp_path)
    (tmp_path / "fibers.csv").write_text("fiber,x_m,y_m,z_m\n0,0,0,0\n0,1e-4,zero,0\n")
    failed = run("run", case, "--out", tmp_path / "r", expect=2)
    assert "fibers.csv:3:8: 'zero' is not a finite number" in failed.stderr
    assert not (tmp_path / "r").exists()


def test_progress_in_a_pipe_is_plain_lines(tmp_path):
    case = write_case(tmp_path, CASE.replace('duration = "20 ms"', 'duration = "2 s"'))
    done = run("run", case, "--out", tmp_path / "r", "--until", "10 ms", "--progress", "line")
    assert "\x1b[K" in done.stderr, "the line renews itself"
    assert re.search(r"of 0\.01 s, .*L_N .* mm, L_W .* mm, step .* s \(\w+\)", done.stderr)
    quiet = run("run", case, "--out", tmp_path / "q", "--until", "1 ms")
    assert "\x1b" not in quiet.stderr


def test_a_failing_simulation_leaves_its_state(tmp_path):
    text = CASE + '\n[step]\nminimum = "9e-4 s"\nmaximum = "1e-3 s"\ninitial = "1e-3 s"\ntolerance = 1e-9\n'
    failed = run("run", write_case(tmp_path, text), "--out", tmp_path / "r", expect=3)
    assert re.search(r"fiber \d+, step \d+, time .* s, largest force .* N", failed.stderr)
    assert "failure.h5" in failed.stderr
    with h5py.File(tmp_path / "r" / "failure.h5") as file:
        assert file["state/position"].shape == (FIBERS * (RODS + 1), 3)


def documented_in(page, heading):
    """Names the first column of the tables below one heading of a page."""
    section = page.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return set(re.findall(r"^\| `([^`]+)`", section, re.M))


def test_docs_name_every_summary_key_and_series_column(result):
    text = (DOCS / "summary.md").read_text(encoding="utf-8")
    documented = set(re.findall(r"^\| `([^`]+)`", text, re.M))
    common_and_own = set(json.loads((result / "summary.json").read_text()))
    assert common_and_own <= documented, common_and_own - documented
    text = (DOCS / "series.md").read_text(encoding="utf-8")
    for table, columns in (("series.csv", series(result)[0]), ("breaks.csv", series(result, "breaks.csv")[0])):
        documented = documented_in(text, f"{table} of the study shear_cell")
        assert set(columns) == documented, set(columns) ^ documented


def test_report_opens_as_one_file(result):
    tried = subprocess.run([PROGRAM, "report", result], capture_output=True, text=True, timeout=300, check=False)
    if "without the HTML report" in tried.stderr:
        pytest.skip("this program was built without the report")
    done = run("report", result)
    assert "report.html" in done.stdout
    page = (result / "report.html").read_text(encoding="utf-8")
    assert "Fibers in a sheared cell" in page and "Mean fiber lengths" in page


@pytest.mark.parametrize("words, complaint", [
    (["--steps", "0"], "--steps: 0 is not a whole number of at least 1"),
    (["--until", "-1 s"], "--until = -1 s: is not a time after the start: give more than 0 s"),
    (["--until", "0 s"], "--until = 0 s: is not a time after the start")])
def test_limits_that_stop_before_the_start_are_refused_in_words(tmp_path, words, complaint):
    refused = run("run", write_case(tmp_path), "--out", tmp_path / "r", *words, expect=2)
    assert complaint in refused.stderr and len(refused.stderr) < 300
    assert not (tmp_path / "r").exists()


@pytest.mark.parametrize("variable, value, complaint", [
    ("FIBERFATE_ISA", "foo", "FIBERFATE_ISA = foo: there is no such instruction set: give one of baseline, avx2, avx512"),
    ("OMPI_COMM_WORLD_SIZE", "2", "started as one of 2 processes, which would all do the same"),
    ("PMI_SIZE", "3", "started as one of 3 processes")])
def test_what_the_environment_asks_in_vain_is_refused(tmp_path, variable, value, complaint):
    refused = run("run", write_case(tmp_path), "--out", tmp_path / "r", expect=2, env={**os.environ, variable: value})
    assert complaint in refused.stderr
    assert not (tmp_path / "r").exists()


def test_options_that_a_study_does_not_act_on_are_refused(tmp_path):
    case = tmp_path / "properties.toml"
    case.write_text('study = "properties"\n[fibers]\nvolume_fraction = 0.1\naspect_ratio = 20\n', encoding="utf-8")
    refused = run("run", case, "--out", tmp_path / "r", "--threads", 2, "--until", "1 s", "--steps", 3, expect=2)
    for complaint in ("--threads: the study properties runs on one thread", "--until: the study properties always runs to its end",
                      "--steps: the study properties does not count steps"):
        assert complaint in refused.stderr
    assert not (tmp_path / "r").exists()
    run("run", case, "--out", tmp_path / "r")
    absent = {"A2_number", "L_N_m", "fibers", "rods", "breaks", "seed", "steps", "simulated_s", "timings", "max_overlap_radii"}
    assert not absent & set(summary(tmp_path / "r"))
