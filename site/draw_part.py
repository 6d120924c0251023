"""Draws a part as it fills: when the melt comes to every place."""
import h5py
import numpy as np

from drawing import INK, Sheet, colour

FLAT = 0.02  # as much as this share of its greatest extent a flat part may rise


def read(folder):
    """Returns the points, the triangles and the times at which the melt came to the points."""
    with h5py.File(folder / "result.vtkhdf") as file:
        data = file["VTKHDF"]
        points = data["Points"][:]
        return points, data["Polygons/Connectivity"][:].reshape(-1, 3), data["PointData/fill_time"][-len(points):]


def seen(points):
    """Returns where points lie on the sheet's plane, and how near: flat parts from above, others at an angle."""
    extent = points.max(axis=0) - points.min(axis=0)
    order = np.argsort(-extent, kind="stable")
    x, y, z = (points[:, axis] for axis in order)
    if extent[order[2]] < FLAT * extent[order[0]]:
        return np.stack([x, y], axis=-1), z
    turn, tilt = np.radians(35), np.radians(40)
    across, back = x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)
    return np.stack([across, back * np.sin(tilt) + z * np.cos(tilt)], axis=-1), z * np.sin(tilt) - back * np.cos(tilt)


def add_scale(sheet, latest):
    """Puts the colours of the times below the part."""
    for step in range(60):
        sheet.box(170 + 5 * step, sheet.height - 32, 5.5, 10, colour("viridis", step / 59))
    words = f'text-anchor="end" fill="{INK}"', f'text-anchor="start" fill="{INK}"'
    sheet.text(162, sheet.height - 22, "melt after 0 s", words[0])
    sheet.text(478, sheet.height - 22, f"{latest:.3g} s", words[1])


def draw(folder):
    """Returns the picture and what it shows."""
    points, triangles, times = read(folder)
    flat, near = seen(points)
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = min(608 / (high[0] - low[0]), 420 / (high[1] - low[1]))
    sheet = Sheet(640, 72 + scale * (high[1] - low[1]))
    flat = scale * (flat - low) + [(640 - scale * (high[0] - low[0])) / 2, 0]
    flat[:, 1] = sheet.height - 52 - flat[:, 1]
    latest = np.nanmax(times)
    for triangle in triangles[np.argsort(near[triangles].mean(axis=1))]:
        when = times[triangle].mean()
        ink = "#e6e8eb" if np.isnan(when) else colour("viridis", when / latest)
        sheet.polygon(flat[triangle], f'fill="{ink}" stroke="{ink}" stroke-width="1.2"')
    add_scale(sheet, latest)
    return sheet, "When the melt comes to every place of the part"
