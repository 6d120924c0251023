"""Runs the cases of a study: several at a time, each once, and on from where an earlier attempt stopped."""
import concurrent.futures
import csv
import json
import pathlib
import subprocess

import h5py
import numpy as np


class Run:
    """Names one run: a case with a variant and overrides, and the folder of its result."""

    def __init__(self, case, folder, overrides=None, variant=None, until=None):
        self.case = pathlib.Path(case)
        self.folder = pathlib.Path(folder)
        self.overrides = overrides or {}
        self.variant = variant
        self.until = until

    def is_done(self):
        summary = self.folder / "summary.json"
        if not summary.exists():
            return False
        return json.loads(summary.read_text(encoding="utf-8"))["stop_reason"] in ("done", "time_reached")

    def command(self, program):
        if any(self.folder.glob("checkpoint*")):
            return [program, "resume", str(self.folder)]
        words = [program, "run", str(self.case), "--out", str(self.folder), "--overwrite"]
        if self.variant:
            words += ["--variant", self.variant]
        for key, value in self.overrides.items():
            words += ["--set", f"{key}={json.dumps(value)}"]
        return words

    def make(self, program, threads=1):
        """Makes the result unless it is there; stops the study when the program fails."""
        if self.is_done():
            return self
        words = self.command(program) + ["--threads", str(threads), "--progress", "none"]
        if self.until:
            words += ["--until", self.until]
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
        print("made", self.folder, flush=True)
        return self

    def summary(self):
        return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))


def make_all(runs, program, jobs):
    """Makes the results of all runs, `jobs` at a time on one thread each, in the order given."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(lambda run: run.make(program), runs))


def add_arguments(parser, out):
    """Adds the options that every study has."""
    parser.add_argument("--program", default="fiberfate")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path(out))
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time, on one thread each")


def read_series(folder):
    """Reads series.csv as one dictionary of numbers a row."""
    with open(pathlib.Path(folder) / "series.csv", encoding="utf-8") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def count_frames(folder):
    """Counts the frames of a result."""
    with h5py.File(pathlib.Path(folder) / "result.vtkhdf") as file:
        return len(file["VTKHDF/NumberOfPoints"])


def frame_times(folder):
    """Returns the times of the frames, s."""
    with h5py.File(pathlib.Path(folder) / "result.vtkhdf") as file:
        return file["VTKHDF/Steps/Values"][:]


def fibers_of(folder, frame):
    """Returns the nodes of every fiber of a frame, m."""
    with h5py.File(pathlib.Path(folder) / "result.vtkhdf") as file:
        data = file["VTKHDF"]
        frame = range(len(data["NumberOfPoints"]))[frame]
        first = int(data["NumberOfPoints"][:frame].sum())
        points = data["Points"][first : first + int(data["NumberOfPoints"][frame])]
        begin = int(data["Lines/NumberOfCells"][:frame].sum()) + frame
        offsets = data["Lines/Offsets"][begin : begin + int(data["Lines/NumberOfCells"][frame]) + 1]
    return [points[a:b] for a, b in zip(offsets[:-1], offsets[1:])]


def hinge_radii(folder, frame):
    """Returns the radii of curvature of all hinges of a frame, m: of the circle through three neighbouring nodes."""
    radii = []
    for nodes in fibers_of(folder, frame):
        before = nodes[1:-1] - nodes[:-2]
        after = nodes[2:] - nodes[1:-1]
        across = np.linalg.norm(np.cross(before, after), axis=1)
        sides = np.prod([np.linalg.norm(side, axis=1) for side in (before, after, before + after)], axis=0)
        with np.errstate(divide="ignore"):
            radii.append(sides / (2 * across))
    return np.concatenate(radii)


def fiber_lengths(folder, frame):
    """Returns the lengths of all fibers of a frame, m."""
    return np.array([np.linalg.norm(np.diff(nodes, axis=0), axis=1).sum() for nodes in fibers_of(folder, frame)])
