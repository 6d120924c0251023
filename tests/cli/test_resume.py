"""Resuming: a run that was interrupted ends bit for bit like one that was not."""
import h5py
import numpy
import pytest

from small_case import run, series, summary, write_case


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    run("run", write_case(folder), "--out", folder / "result", "--threads", 2)
    return folder / "result"


def all_datasets(path):
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
        attributes = {name: {key: file[name].attrs[key] for key in file[name].attrs} for name in ["state"]
                      if name in file}
    return found, attributes


def assert_same_state(one, other):
    """Compares the states of two checkpoints bit for bit; record/timings is about wall time and may differ."""
    first, first_attributes = all_datasets(one)
    second, second_attributes = all_datasets(other)
    assert first_attributes == second_attributes
    assert first.keys() == second.keys()
    for name in first:
        if name.startswith("state/"):
            assert numpy.array_equal(first[name], second[name]), name


def assert_same_result(one, other):
    assert series(one) == series(other)
    assert series(one, "breaks.csv") == series(other, "breaks.csv")
    assert_same_state(one / "checkpoint.h5", other / "checkpoint.h5")
    frames, _ = all_datasets(one / "result.vtkhdf")
    others, _ = all_datasets(other / "result.vtkhdf")
    assert frames.keys() == others.keys()
    for name in frames:
        equal_nan = frames[name].dtype.kind == "f"  # no stress is known before the first step
        assert numpy.array_equal(frames[name], others[name], equal_nan=equal_nan), name


@pytest.mark.parametrize("steps", [[1], [7], [20, 3, 1, 40]])
def test_resumed_run_ends_bitwise_the_same(whole, tmp_path, steps):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--steps", steps[0], "--threads", 1)
    for count in steps[1:]:
        run("resume", tmp_path / "r", "--steps", count)
        assert summary(tmp_path / "r")["stop_reason"] == "steps_reached"
    run("resume", tmp_path / "r", "--threads", 2)
    assert summary(tmp_path / "r")["stop_reason"] == "done"
    assert_same_result(whole, tmp_path / "r")


def test_until_on_an_output_time_changes_nothing(whole, tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--until", "8 ms")
    run("resume", tmp_path / "r")
    assert_same_result(whole, tmp_path / "r")


def test_summary_counts_the_whole_run(whole, tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--steps", 30)
    first = summary(tmp_path / "r")
    run("resume", tmp_path / "r")
    last = summary(tmp_path / "r")
    assert last["wall_s"] > first["wall_s"]
    assert last["timings"]["solve"] > first["timings"]["solve"]
    for key in ("steps", "breaks", "L_N_m", "L_W_m", "A2", "rejected_steps"):
        assert last[key] == summary(whole)[key], key


def test_resume_needs_no_input_file_any_more(whole, tmp_path):
    case = write_case(tmp_path)
    run("run", case, "--out", tmp_path / "r", "--steps", 10)
    (tmp_path / "fibers.csv").unlink()
    (tmp_path / "case.toml").unlink()
    run("resume", tmp_path / "r")
    assert_same_result(whole, tmp_path / "r")


def test_a_finished_run_can_be_prolonged(whole, tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r")
    before = (tmp_path / "r" / "summary.json").read_bytes()
    nothing = run("resume", tmp_path / "r")
    assert "--until" in nothing.stderr
    assert (tmp_path / "r" / "summary.json").read_bytes() == before
    run("resume", tmp_path / "r", "--until", "22 ms")
    assert summary(tmp_path / "r")["simulated_s"] == pytest.approx(0.022)
    assert len(series(tmp_path / "r")) == 1 + 23
    assert series(tmp_path / "r")[:22] == series(whole)


def damage_truncate(path):
    size = path.stat().st_size
    with open(path, "r+b") as file:
        file.truncate(size // 2)


def damage_flip(path):
    with h5py.File(path) as file:
        place = file["state/position"].id.get_chunk_info(0).byte_offset
    with open(path, "r+b") as file:
        file.seek(place + 100)
        byte = file.read(1)[0]
        file.seek(place + 100)
        file.write(bytes([byte ^ 16]))


def damage_remove(path):
    path.unlink()


def replace_dataset(path, name, values):
    """Puts a sound dataset of other numbers in place of one, which checksums do not see."""
    with h5py.File(path, "r+") as file:
        del file[name]
        file.create_dataset(name, data=values, fletcher32=True, chunks=True)


def damage_lattice(path):
    replace_dataset(path, "state/lattice", numpy.ones((2, 2)))


def damage_boundary(path):
    replace_dataset(path, "state/boundary", numpy.zeros(2, dtype="uint8"))


def damage_timings(path):
    replace_dataset(path, "record/timings", numpy.zeros(1))


@pytest.mark.parametrize("damage", [damage_truncate, damage_flip, damage_remove, damage_lattice, damage_boundary,
                                    damage_timings])
def test_a_damaged_checkpoint_falls_back_to_the_one_before(whole, tmp_path, damage):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--steps", 40)
    damage(tmp_path / "r" / "checkpoint.h5")
    resumed = run("resume", tmp_path / "r")
    assert "checkpoint.h5" in resumed.stderr and "continuing from" in resumed.stderr
    assert "checkpoint.previous.h5" in resumed.stderr
    assert_same_result(whole, tmp_path / "r")


def test_two_damaged_checkpoints_are_an_error(tmp_path):
    run("run", write_case(tmp_path), "--out", tmp_path / "r", "--steps", 40)
    damage_truncate(tmp_path / "r" / "checkpoint.h5")
    damage_truncate(tmp_path / "r" / "checkpoint.previous.h5")
    failed = run("resume", tmp_path / "r", expect=3)
    assert "checkpoint.previous.h5" in failed.stderr


def test_a_folder_without_a_result_is_bad_input(tmp_path):
    failed = run("resume", tmp_path, expect=2)
    assert "holds no result" in failed.stderr
    failed = run("resume", tmp_path / "none", expect=2)
    assert "is not a folder" in failed.stderr
