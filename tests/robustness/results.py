"""Compares two results bit for bit, but for what tells of time: every table, frame, last state and value."""
import json
from pathlib import Path

import h5py
import numpy

# Records of who wrote and when, and the checkpoint before the last, whose moment depends on wall time.
OF_THE_PROCESS = {".fiberfate", "log.txt", "checkpoint.previous.h5", "report.html"}
# Values of summary.json that tell of wall time, memory, threads and processes.
TIMES = {"peak_memory_bytes", "wall_s", "cpu_s", "timings", "threads", "ranks", "segment_steps_per_s", "stepping_s", "packing_s", "filling_flow_s", "filling_front_s",
         "filling_heat_s", "filling_lengths_s", "filling_orientation_s"}
# What the same file of two checkpoints may differ in.
RECORDS_OF_TIME = {"wall_s", "cpu_s", "timings"}
PASSING = (".new", ".next", ".kept")  # what writers add to names for a moment


def summary(folder):
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def rows_of(folder):
    """Counts the rows of series.csv so far; 0 where it is not there yet."""
    try:
        return max((folder / "series.csv").read_bytes().count(b"\n") - 1, 0)
    except OSError:
        return 0


def hdf5_contents(path):
    """Gives every dataset and attribute by its path."""
    found = {}

    def take(name, item):
        for key, value in item.attrs.items():
            found[f"{name}@{key}"] = value
        if isinstance(item, h5py.Dataset):
            found[name] = item[()]

    with h5py.File(path) as file:
        take("", file)
        file.visititems(take)
    return found


def same_values(one, other):
    one, other = numpy.asarray(one), numpy.asarray(other)
    if one.dtype != other.dtype or one.shape != other.shape:
        return False
    # NaN stands for "not yet" and equals itself here; -0 and 0 differ.
    return one.tobytes() == other.tobytes() if one.dtype != object else bool((one == other).all())


def hdf5_difference(one, other):
    first, second = hdf5_contents(one), hdf5_contents(other)
    if first.keys() != second.keys():
        return f"{sorted(first.keys() ^ second.keys())[:3]} are in one only"
    for name, value in first.items():
        if name.split("/")[-1].split("@")[-1] not in RECORDS_OF_TIME and not same_values(value, second[name]):
            return f"{name} differs"
    return None


def summary_difference(one, other):
    first, second = summary(one), summary(other)
    if first.keys() != second.keys():
        return f"{sorted(first.keys() ^ second.keys())[:3]} are in one only"
    differing = [key for key in first if key not in TIMES and first[key] != second[key]]
    return f"{differing[:3]} differ" if differing else None


def file_difference(one, other):
    if one.suffix in (".vtkhdf", ".h5"):
        return hdf5_difference(one, other)
    if one.name == "summary.json":
        return summary_difference(one.parent, other.parent)
    return None if one.read_bytes() == other.read_bytes() else "bytes differ"


def names(folder):
    return {path.name for path in folder.iterdir()} - OF_THE_PROCESS


def difference(one, other):
    """Says in what two results differ; None where they are the same."""
    if names(one) != names(other):
        return f"files {sorted(names(one) ^ names(other))} are in one only"
    for name in sorted(names(one)):
        found = file_difference(one / name, other / name)
        if found:
            return f"{name}: {found}"
    return None


def unreadable(folder):
    """Says what a program that looks at a result meanwhile could not read; None where all is well."""
    for name in ("result.vtkhdf", "checkpoint.h5", "checkpoint.previous.h5"):
        path = Path(folder) / name
        try:
            if path.exists():
                hdf5_contents(path)
        except (OSError, RuntimeError) as error:
            return f"{name} cannot be read: {error}"
    return None
