"""Signals: SIGTERM and SIGINT stop in good order, SIGKILL at any moment loses only the time since a checkpoint."""
import random
import signal
import subprocess
import time

import h5py
import pytest

from small_case import CASE, PROGRAM, run, series, summary, write_case
from test_resume import assert_same_result

LONG = CASE.replace('duration = "20 ms"', 'duration = "150 ms"').replace('frame_interval = "4 ms"',
                                                                        'frame_interval = "2 ms"')


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    begin = time.monotonic()
    run("run", write_case(folder, LONG), "--out", folder / "result", "--threads", 1)
    return folder / "result", time.monotonic() - begin


def start(*words):
    return subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for(path, seconds=60):
    end = time.monotonic() + seconds
    while not path.exists():
        assert time.monotonic() < end, f"{path} did not appear"
        time.sleep(0.005)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_stops_after_a_checkpoint(whole, tmp_path, number):
    result = tmp_path / "r"
    case = write_case(tmp_path, LONG.replace('checkpoint_interval = "0.02 s"', 'checkpoint_interval = "1 h"'))
    process = start("run", case, "--out", result, "--threads", 1)
    wait_for(result / "checkpoint.h5")
    time.sleep(0.3 * whole[1])
    process.send_signal(number)
    _, complaint = process.communicate(timeout=60)
    assert process.returncode == 4, complaint
    assert summary(result)["stop_reason"] == "signal"
    assert 0 < summary(result)["simulated_s"] < 0.15
    with h5py.File(result / "checkpoint.h5") as file:
        assert file["state"].attrs["time"] == summary(result)["simulated_s"]
    run("resume", result, "--threads", 1)
    assert_same_result(whole[0], result)


def test_kills_at_random_moments_lose_nothing_for_good(whole, tmp_path):
    moments = random.Random(11)
    result = tmp_path / "r"
    process = start("run", write_case(tmp_path, LONG), "--out", result, "--threads", 1)
    wait_for(result / "checkpoint.h5")
    kills = 0
    while kills < 8:
        time.sleep(moments.uniform(0, 0.25) * whole[1])
        process.kill()
        process.communicate()
        if process.returncode == 0:
            break
        kills += 1
        # Whatever was being written, the frames that are there can be read.
        if (result / "result.vtkhdf").exists():
            with h5py.File(result / "result.vtkhdf") as file:
                assert len(file["VTKHDF/Steps/Values"]) == file["VTKHDF/Steps"].attrs["NSteps"] > 0
        process = start("resume", result, "--threads", 1)
    _, complaint = process.communicate(timeout=120)
    assert kills > 0
    assert process.returncode == 0, complaint
    assert_same_result(whole[0], result)


def test_a_kill_before_the_first_checkpoint_starts_over(whole, tmp_path):
    result = tmp_path / "r"
    run("run", write_case(tmp_path, LONG), "--out", result, "--steps", 1, "--threads", 1)
    (result / "checkpoint.h5").unlink()
    (result / "checkpoint.previous.h5").unlink()
    (result / "checkpoint.h5.new").write_bytes(b"torn")
    (result / "result.vtkhdf.next").write_bytes(b"torn")
    run("resume", result, "--threads", 1)
    assert_same_result(whole[0], result)
    assert series(result) == series(whole[0])
