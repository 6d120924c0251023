"""A disk that fills up: a clear error, and the checkpoint before is intact."""
import os
import resource
import shutil
import subprocess

import h5py
import pytest

from small_case import CASE, PROGRAM, run, write_case

LONG = CASE.replace('duration = "20 ms"', 'duration = "10 s"').replace('frame_interval = "4 ms"',
                                                                      'frame_interval = "1 ms"')


def checkpoint_is_sound(folder):
    with h5py.File(folder / "checkpoint.h5") as file:
        assert file["state/position"].shape[1] == 3
        return file["state"].attrs["time"]


def test_a_file_that_may_not_grow_stops_the_run(tmp_path):
    """The limit on the size of files stands for a full disk: it fails writes in the same way, for root too."""
    case = write_case(tmp_path, LONG)
    limit = 1 << 20
    done = subprocess.run([PROGRAM, "run", case, "--out", tmp_path / "r"], capture_output=True, text=True, timeout=300,
                          check=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
    assert done.returncode == 3, done.stderr
    assert "cannot write" in done.stderr and str(tmp_path / "r") in done.stderr
    assert "File too large" in done.stderr
    assert "HDF5-DIAG" not in done.stderr
    time = checkpoint_is_sound(tmp_path / "r")
    with h5py.File(tmp_path / "r" / "result.vtkhdf") as file:
        frames = len(file["VTKHDF/Steps/Values"])
        assert frames == file["VTKHDF/Steps"].attrs["NSteps"] > 0
    # With room again the run goes on.
    run("resume", tmp_path / "r", "--steps", 20)
    assert checkpoint_is_sound(tmp_path / "r") > time
    assert not list((tmp_path / "r").glob("*.new"))


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 3 MB; only root may mount one."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mounted = os.geteuid() == 0 and shutil.which("mount") and subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", str(folder)], capture_output=True, check=False).returncode == 0
    if not mounted:
        pytest.skip("no file system can be mounted here; the test above covers the same path")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


def test_a_full_disk_stops_the_run(tmp_path, small_disk):
    failed = run("run", write_case(tmp_path, LONG), "--out", small_disk / "r", expect=3)
    assert "the disk is full (No space left on device): make room there" in failed.stderr
    assert "fiberfate resume" in failed.stderr and "nput/output error" not in failed.stderr
    assert str(small_disk / "r") in failed.stderr
    checkpoint_is_sound(small_disk / "r")


def test_a_report_and_an_export_that_do_not_fit_say_that_the_disk_is_full(tmp_path, small_disk):
    run("run", write_case(tmp_path), "--out", small_disk / "r", "--steps", 20)
    rest = os.open(small_disk / "rest", os.O_WRONLY | os.O_CREAT)
    try:
        while os.write(rest, b"0" * 4096) > 0:
            pass
    except OSError:
        os.close(rest)
    for words in (["report", small_disk / "r"], ["export", small_disk / "r", "--format", "vtp"], ["resume", small_disk / "r"]):
        failed = run(*words, expect=3)
        assert "the disk is full (No space left on device)" in failed.stderr and str(small_disk) in failed.stderr, failed.stderr


@pytest.mark.parametrize("words", [["explain"], ["explain", "--markdown"]])
def test_output_that_does_not_fit_is_no_success(words):
    with open("/dev/full", "w", encoding="utf-8") as full:
        done = subprocess.run([PROGRAM, *words], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60, check=False)
    assert done.returncode == 3 and "the disk is full" in done.stderr, (done.returncode, done.stderr)


def test_a_checkpoint_that_does_not_fit_keeps_the_one_before(tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "r", "--steps", 10)
    before = (tmp_path / "r" / "checkpoint.h5").read_bytes()
    limit = len(before) // 2
    done = subprocess.run([PROGRAM, "resume", tmp_path / "r", "--steps", "1"], capture_output=True, text=True,
                          timeout=300, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
    assert done.returncode == 3, done.stderr
    assert "checkpoint.h5" in done.stderr and "File too large" in done.stderr
    assert (tmp_path / "r" / "checkpoint.h5").read_bytes() == before
    run("resume", tmp_path / "r", "--steps", 1)


def test_a_folder_that_cannot_be_made_is_an_error(tmp_path):
    (tmp_path / "file").write_text("not a folder")
    failed = run("run", write_case(tmp_path), "--out", tmp_path / "file" / "r", expect=2)
    assert "cannot make the folder" in failed.stderr
