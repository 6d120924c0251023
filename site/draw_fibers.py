"""Draws the fibers at the end of a run, seen across the cell."""
import sys

import numpy as np

from drawing import Sheet, colour

MOST_FIBERS = 400  # the nearest ones hide those behind them
MOST_NODES = 26  # of one fiber


def seen(points):
    """Returns where points lie on a plane that looks along z and a little from above and the side, and how deep behind it."""
    turn, tilt = np.radians(20), np.radians(15)
    x, y, z = points[..., 0], points[..., 1], points[..., 2]
    across, back = x * np.cos(turn) + z * np.sin(turn), z * np.cos(turn) - x * np.sin(turn)
    return np.stack([across, y * np.cos(tilt) + back * np.sin(tilt)], axis=-1), back * np.cos(tilt) - y * np.sin(tilt)


def thinned(nodes):
    """Leaves out nodes of a long chain."""
    keep = np.unique(np.linspace(0, len(nodes) - 1, min(len(nodes), MOST_NODES)).round().astype(int))
    return nodes[keep]


def draw(root, folder, summary):
    """Returns the picture and what it shows; root holds cases/fiber_frames.py."""
    sys.path.insert(0, str(root / "cases"))
    from fiber_frames import fibers_of, frame_times
    chains = [thinned(nodes) for nodes in fibers_of(folder, -1)]
    places = [seen(nodes) for nodes in chains]
    depth = np.array([deep.mean() for _, deep in places])
    order = np.argsort(depth)[:MOST_FIBERS][::-1]
    flat = np.concatenate([places[one][0] for one in order])
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = 608 / (high[0] - low[0])
    sheet = Sheet(640, 32 + scale * (high[1] - low[1]))
    nearest, farthest = depth[order].min(), depth[order].max()
    for one in order:
        along = np.abs(chains[one][-1] - chains[one][0])
        fog = 0.75 * (depth[one] - nearest) / max(farthest - nearest, 1e-12)
        points = 16 + scale * (places[one][0] - low)
        points[:, 1] = sheet.height - points[:, 1]
        ink = colour("tide", 1 - along[0] / max(np.linalg.norm(along), 1e-30), fog)
        sheet.path(points, f'fill="none" stroke="{ink}" stroke-width="3"')
    time = frame_times(folder)[-1]
    when = f"after {time:.3g} s" if summary["study"] == "shear_cell" else "as they are packed"
    return sheet, f"{len(chains)} fibers {when}; yellow ones lie along the flow, blue ones across it"
