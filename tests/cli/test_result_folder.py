"""Result folders: nothing of a user's is lost, and two processes never write to one."""
import os
import signal
import subprocess
import time

import pytest

from small_case import CASE, PROGRAM, run, series, summary, write_case

BROKEN_FIBERS = "fiber,x_m,y_m,z_m\n0,0,0,0\n0,1e-4,nothing,0\n"


def contents(folder):
    """Every file below a folder with its bytes, but for the record, whose lines name processes."""
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file() and path.name != ".fiberfate"}


def late_refusal(folder):
    """A case that only the run finds wrong: one of its fibers is not of numbers."""
    case = write_case(folder)
    (folder / "fibers.csv").write_text(BROKEN_FIBERS, encoding="utf-8")
    return case


def test_a_late_refusal_leaves_the_disk_as_it_was(tmp_path):
    case = late_refusal(tmp_path)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "notes.txt").write_text("of a user\n", encoding="utf-8")
    before = contents(tmp_path)
    run("run", case, "--out", tmp_path / "mine", expect=2)
    run("run", case, "--out", tmp_path / "new" / "deep", expect=2)
    assert contents(tmp_path) == before
    assert not (tmp_path / "new").exists()
    assert not (tmp_path / "mine" / ".fiberfate").exists()


def test_check_finds_what_would_be_refused_late(tmp_path):
    refused = run("check", late_refusal(tmp_path), expect=2)
    assert "fibers.csv:3:8: 'nothing' is not a finite number" in refused.stderr


@pytest.mark.parametrize("name", ["histogram.csv", "log.txt", "series.csv", "summary.json", "report.html"])
@pytest.mark.parametrize("words", [[], ["--overwrite"]])
def test_files_that_the_program_did_not_make_are_never_replaced(tmp_path, name, words):
    case = write_case(tmp_path)
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / name).write_text("of a user\n", encoding="utf-8")
    before = contents(tmp_path)
    refused = run("run", case, "--out", tmp_path / "mine", *words, expect=2)
    assert f"mine/{name} is there already, and no record in its folder says that fiberfate made it" in refused.stderr
    assert contents(tmp_path) == before


def test_overwriting_keeps_the_old_result_until_there_is_a_new_one(tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "r", "--steps", 3)
    (tmp_path / "r" / "notes.txt").write_text("of a user\n", encoding="utf-8")
    before = contents(tmp_path / "r")
    late_refusal(tmp_path)
    run("run", case, "--out", tmp_path / "r", "--overwrite", expect=2)
    assert contents(tmp_path / "r") == before
    write_case(tmp_path)
    run("resume", tmp_path / "r", "--steps", 1)
    run("run", case, "--out", tmp_path / "r", "--overwrite", "--steps", 5)
    assert summary(tmp_path / "r")["steps"] == 5
    assert set(contents(tmp_path / "r")) == set(before)
    assert (tmp_path / "r" / "notes.txt").read_text(encoding="utf-8") == "of a user\n"


def test_a_run_that_fails_leaves_the_earlier_result_and_its_own_state_beside_it(tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "r")
    before = contents(tmp_path / "r")
    hopeless = ["--set", "step.tolerance=1e-12", "--set", "step.minimum=1 us"]
    for name in ("r.failed", "r.failed-2"):
        failed = run("run", case, "--out", tmp_path / "r", "--overwrite", *hopeless, expect=3)
        assert f"what it made is in {tmp_path / name}, and {tmp_path / 'r'} holds the earlier result again" in failed.stderr
        assert {"failure.h5", "log.txt", "case.resolved.toml", ".fiberfate"} <= set(os.listdir(tmp_path / name))
        assert contents(tmp_path / "r") == before
    run("resume", tmp_path / "r", "--until", "22 ms")


def test_a_record_that_leads_out_of_its_folder_moves_nothing(tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "r", "--steps", 1)
    (tmp_path / "mine.txt").write_text("mine", encoding="utf-8")
    with open(tmp_path / "r" / ".fiberfate", "a", encoding="utf-8") as record:
        record.write("file ../mine.txt\nfile ..\nend\n")
    run("run", case, "--out", tmp_path / "r", "--steps", 1, "--overwrite")
    assert (tmp_path / "mine.txt").read_text(encoding="utf-8") == "mine"


def test_a_report_does_not_wait_for_a_pipe(tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--steps", 1)
    os.mkfifo(tmp_path / "pipe")
    assert "fiberfate did not make it" in run("report", tmp_path / "r", "--out", tmp_path / "pipe", expect=2).stderr


def test_a_link_to_a_folder_stays_a_link(tmp_path):
    case = write_case(tmp_path)
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "elsewhere")
    for _ in range(2):
        run("run", case, "--out", tmp_path / "link", "--steps", 2, "--overwrite")
        assert (tmp_path / "link").is_symlink()
        assert summary(tmp_path / "elsewhere")["steps"] == 2


def start(*words):
    return subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for(path, seconds=120):
    end = time.monotonic() + seconds
    while not path.exists() and time.monotonic() < end:
        time.sleep(0.02)
    assert path.exists()


def test_only_one_process_writes_to_a_folder_and_a_killed_one_leaves_no_lock(tmp_path):
    long = CASE.replace('duration = "20 ms"', 'duration = "1000 s"')
    first = start("run", write_case(tmp_path, long), "--out", tmp_path / "r", "--threads", 1)
    try:
        wait_for(tmp_path / "r" / "checkpoint.h5")
        for words in (["resume", tmp_path / "r"], ["run", tmp_path / "case.toml", "--out", tmp_path / "r", "--overwrite"]):
            refused = run(*words, expect=2)
            assert f"is being written to by process {first.pid} on {os.uname().nodename}, since 2" in refused.stderr
        assert first.poll() is None
    finally:
        first.send_signal(signal.SIGKILL)
        first.wait()
    run("resume", tmp_path / "r", "--steps", 2)


def test_a_case_that_was_edited_after_the_start_is_refused(tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--steps", 3)
    resolved = tmp_path / "r" / "case.resolved.toml"
    text = resolved.read_text(encoding="utf-8")
    resolved.write_text(text.replace("rate = 200", "rate = 300"), encoding="utf-8")
    refused = run("resume", tmp_path / "r", expect=2)
    assert "case.resolved.toml was changed after the run began" in refused.stderr
    resolved.write_text(text, encoding="utf-8")
    run("resume", tmp_path / "r", "--steps", 1)


def test_bytes_that_changed_inside_a_table_are_found(tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--until", "8 ms")
    table = tmp_path / "r" / "series.csv"
    text = table.read_text(encoding="utf-8")
    second = text.index("\n", text.index("\n") + 1) + 1
    table.write_text(text[:second] + "9" + text[second + 1:], encoding="utf-8")
    refused = run("resume", tmp_path / "r", expect=3)
    assert "series.csv: its rows are not those that the checkpoint knows" in refused.stderr


def test_a_damaged_checkpoint_never_pushes_the_sound_one_out(tmp_path):
    rare = CASE.replace('checkpoint_interval = "0.02 s"', 'checkpoint_interval = "1000 s"')  # at the start and the end
    run("run", write_case(tmp_path, rare), "--out", tmp_path / "r", "--until", "8 ms")
    newest, previous = tmp_path / "r" / "checkpoint.h5", tmp_path / "r" / "checkpoint.previous.h5"
    sound = previous.read_bytes()
    newest.write_bytes(newest.read_bytes()[:1000])
    # A resume that ends at once has read a checkpoint and not yet replaced one.
    done = start("resume", tmp_path / "r", "--steps", 1)
    assert done.wait(timeout=120) == 0
    assert previous.read_bytes() == sound
    run("resume", tmp_path / "r")


def test_closed_streams_do_not_become_files_of_the_result(tmp_path):
    case = write_case(tmp_path)
    subprocess.run(["bash", "-c", f"'{PROGRAM}' run '{case}' --out '{tmp_path}/r' --steps 3 --progress line >&- 2>&-"], check=True)
    table = series(tmp_path / "r")
    assert len(table) > 1
    assert "\x1b" not in (tmp_path / "r" / "series.csv").read_text(encoding="utf-8")
