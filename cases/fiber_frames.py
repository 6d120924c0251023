"""Reads the fibers of the frames of a result."""
import pathlib

import h5py
import numpy as np


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
