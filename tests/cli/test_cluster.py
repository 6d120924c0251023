"""The study cluster: packings that are what was asked, and that other runs start from."""
import json
import re
import signal
import subprocess
import time
from pathlib import Path

import h5py
import numpy
import pytest

from small_case import CASE, PROGRAM, column, run, summary

DOCS = Path(__file__).resolve().parents[2] / "docs" / "formats"

CLUSTER = """study = "cluster"
[fibers]
length = "0.5 mm"
diameter = "19 um"
youngs_modulus = "73 GPa"
rod_length = "0.1 mm"
volume_fraction = "8 %"
[cell]
size = "0.5 mm"
[cluster]
orientation = [0.6, 0.3, 0.1]
"""


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cluster")
    (folder / "case.toml").write_text(CLUSTER, encoding="utf-8")
    run("run", folder / "case.toml", "--out", folder / "result")
    return folder / "result"


def test_a_packing_is_what_was_asked(packed):
    values = summary(packed)
    assert values["study"] == "cluster" and values["stop_reason"] == "done"
    assert numpy.abs(numpy.array(values["A2"]) - numpy.diag([0.6, 0.3, 0.1])).max() <= 0.005
    assert values["max_overlap_diameters"] <= 0.01
    assert values["max_overlap_radii"] == pytest.approx(2 * values["max_overlap_diameters"])
    assert values["volume_fraction"] == pytest.approx(0.08, rel=0.02)
    with h5py.File(packed / "checkpoint.h5") as file:
        assert len(file["state/birth_id"]) == values["fibers"]


def test_docs_name_every_key_of_the_summary(packed):
    text = (DOCS / "summary.md").read_text(encoding="utf-8")
    keys = set(json.loads((packed / "summary.json").read_text()))
    assert keys <= set(re.findall(r"^\| `([^`]+)`", text, re.M))


def test_a_run_starts_from_a_packing(packed, tmp_path):
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    run("run", tmp_path / "case.toml", "--set", f"cluster.file={packed / 'checkpoint.h5'}", "--out", tmp_path / "r",
        "--steps", 3)
    assert column(tmp_path / "r", "fibers")[0] == summary(packed)["fibers"]
    assert column(tmp_path / "r", "a11")[0] == pytest.approx(summary(packed)["A2"][0][0], rel=1e-9)


def test_resuming_a_packing_that_is_complete_says_so(packed):
    before = (packed / "summary.json").read_bytes()
    assert "complete already" in run("resume", packed).stderr
    assert (packed / "summary.json").read_bytes() == before


def test_a_signal_stops_packing_and_resume_packs_again(tmp_path):
    text = CLUSTER.replace('"0.5 mm"', '"2.5 mm"', 1).replace('"8 %"', '"20 %"').replace('"0.5 mm"', '"1.1 mm"')
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    process = subprocess.Popen([PROGRAM, "run", tmp_path / "case.toml", "--out", tmp_path / "r"],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while not (tmp_path / "r" / "log.txt").exists():
        time.sleep(0.01)
    time.sleep(0.3)
    process.send_signal(signal.SIGTERM)
    _, complaint = process.communicate(timeout=120)
    assert process.returncode == 4, complaint
    assert "resuming will pack again" in complaint
    assert not (tmp_path / "r" / "summary.json").exists()
    # The same folder serves a smaller request, so that the test stays short.
    resolved = tmp_path / "r" / "case.resolved.toml"
    resolved.write_text(re.sub(r"(?m)^volume_fraction = .*$", "volume_fraction = 0.005", resolved.read_text()))
    run("resume", tmp_path / "r")
    assert summary(tmp_path / "r")["volume_fraction"] == pytest.approx(0.005, rel=0.05)
