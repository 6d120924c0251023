#!/usr/bin/env python3
"""Reads many damaged files, made with a seed from sound ones: lists, meshes, numbers, checkpoints, results.

    fuzz_files.py [--runs 2000] [--seed 1] [--jobs 2] [--keep FOLDER]

Each must be read, or refused or failed in words. Prints what must not be, and one line of figures; the exit status
is 1 unless there is nothing of it.
"""
import argparse
import random
import shutil
import struct
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from damage import OF_BYTES, OF_LINES, damaged
from trial import PROGRAM, Tally, attempt

CELL = """study = "shear_cell"
[run]
duration = "2 ms"
[cell]
size = "0.5 mm"
[fibers]
diameter = "19 um"
youngs_modulus = "10 GPa"
[cluster]
source = "file"
file = "{file}"
[flow]
rate = "200 1/s"
viscosity = "100 Pa s"
[output]
interval = "1 ms"
"""
FIBERS = "fiber,x_m,y_m,z_m\n" + "".join(f"{f},{1e-4 + 6e-5 * n},{1e-4 * (f + 1)},2e-4\n" for f in range(3) for n in range(4))
LENGTHS = 'study = "measurement"\n[lengths]\nfile = "{file}"\nunit = "mm"\n[statistics]\nresamples = 20\n'
NUMBERS = CELL.replace('source = "file"\nfile = "{file}"\n', "orientation_tolerance = 1\n").replace("diameter", 'lengths = "{file}"\ncount = 3\ndiameter').replace(
    'youngs_modulus = "10 GPa"', 'youngs_modulus = "10 GPa"\nrod_length = "60 um"')
PART = """study = "molding"
[part]
kind = "file"
file = "{file}"
thickness = "2 mm"
[gates]
places = [["G", "0 mm", "0 mm", "0 mm"]]
[material]
preset = "newtonian"
[machine]
flow_rate = "8 cm^3/s"
melt_temperature = "500 K"
mold_temperature = "400 K"
"""


def strip(columns=8, rows=4, size=2.5):
    """Gives points and triangles of a flat strip."""
    points = [(size * i, size * j, 0.0) for i in range(columns + 1) for j in range(rows + 1)]
    at = lambda i, j: i * (rows + 1) + j
    triangles = []
    for i in range(columns):
        for j in range(rows):
            triangles += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return points, triangles


def text_stl():
    points, triangles = strip()
    facets = ["facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in (points[k] for k in corner)) +
              "endloop\nendfacet\n" for corner in triangles]
    return ("solid strip\n" + "".join(facets) + "endsolid strip\n").encode()


def binary_stl():
    points, triangles = strip()
    facets = b"".join(struct.pack("<12fH", 0, 0, 1, *points[a], *points[b], *points[c], 0) for a, b, c in triangles)
    return b" " * 80 + struct.pack("<I", len(triangles)) + facets


def text_msh():
    points, triangles = strip()
    nodes = "".join(f"{i + 1} {x} {y} {z}\n" for i, (x, y, z) in enumerate(points))
    elements = "".join(f"{i + 1} 2 2 1 1 {a + 1} {b + 1} {c + 1}\n" for i, (a, b, c) in enumerate(triangles))
    return (f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(points)}\n{nodes}$EndNodes\n"
            f"$Elements\n{len(triangles)}\n{elements}$EndElements\n").encode()


def binary_msh():
    """Writes Gmsh's format 4.1, binary: one surface with all nodes and triangles."""
    points, triangles = strip()
    count = len(points)
    box = struct.pack("<6d", 0, 0, 0, 20, 10, 0)
    entities = struct.pack("<4Q", 0, 0, 1, 0) + struct.pack("<i", 1) + box + struct.pack("<QQ", 0, 0)
    nodes = struct.pack("<4Q", 1, count, 1, count) + struct.pack("<3iQ", 2, 1, 0, count)
    nodes += struct.pack(f"<{count}Q", *range(1, count + 1)) + b"".join(struct.pack("<3d", *point) for point in points)
    total = len(triangles)
    elements = struct.pack("<4Q", 1, total, 1, total) + struct.pack("<3iQ", 2, 1, 2, total)
    elements += b"".join(struct.pack("<4Q", i + 1, a + 1, b + 1, c + 1) for i, (a, b, c) in enumerate(triangles))
    return (b"$MeshFormat\n4.1 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Entities\n" + entities + b"\n$EndEntities\n$Nodes\n" + nodes +
            b"\n$EndNodes\n$Elements\n" + elements + b"\n$EndElements\n")


@dataclass
class Target:
    """A kind of file, and the command that reads it. `{file}` in words and case is the damaged file."""
    name: str
    sound: bytes
    words: tuple
    kinds: list = field(default_factory=lambda: OF_BYTES + OF_LINES)
    case: str = ""
    place_wanted: bool = True  # a place in a file of bytes cannot be told


def text_targets():
    lists = {"commas": "length,count\n" + "".join(f"{0.1 * k + 0.2:.3f},{k}\n" for k in range(1, 30)),
             "semicolons": "Nr.;Länge [mm];Durchmesser\n" + "".join(f"{k};{0.1 * k:.3f};0,017\n".replace(".", ",") for k in range(1, 30)),
             "tabs": "name\tLength [mm]\n" + "".join(f"a {k}\t{0.1 * k:.3f}\n" for k in range(1, 30))}
    column = {"commas": 'column = "length"\n'}
    targets = [Target(f"list with {name}", text.encode(), ("check", "case.toml"), case=LENGTHS.replace("[stat", column.get(name, "") + "[stat"))
               for name, text in lists.items()]
    return targets + [
        Target("numbers", "".join(f"{2e-4 + 1e-6 * k}\n" for k in range(50)).encode(), ("check", "case.toml"), case=NUMBERS),
        Target("fibers.csv", FIBERS.encode(), ("run", "case.toml", "--out", "r", "--steps", "1"), case=CELL),
        Target("part.stl", text_stl(), ("check", "case.toml"), case=PART, place_wanted=False),
        Target("part.msh", text_msh(), ("check", "case.toml"), case=PART, place_wanted=False)]


def byte_targets(result):
    files = {path.name: path.read_bytes() for path in result.iterdir() if path.is_file()}
    targets = [Target("part.stl", binary_stl(), ("check", "case.toml"), OF_BYTES, PART, False),
               Target("part.msh", binary_msh(), ("check", "case.toml"), OF_BYTES, PART, False),
               Target("checkpoint.h5", files["checkpoint.h5"], ("run", "case.toml", "--out", "r", "--steps", "1"), OF_BYTES, CELL, False),
               Target("result.vtkhdf", files["result.vtkhdf"], ("run", "case.toml", "--out", "r", "--steps", "1"), OF_BYTES, CELL, False)]
    for name in ("checkpoint.h5", "case.resolved.toml", "series.csv"):
        targets.append(Target("result/" + name, files[name], ("resume", "result", "--until", "3 ms"), place_wanted=False))
    for name in ("result.vtkhdf", "summary.json", "series.csv", "case.resolved.toml"):
        targets.append(Target("result/" + name, files[name], ("report", "result"), place_wanted=False))
    return targets + [Target("result/result.vtkhdf", files["result.vtkhdf"], ("export", "result", "--format", "vtp"), OF_BYTES, place_wanted=False)]


def one_run(number, seed, targets, folder, result):
    chance = random.Random(f"{seed}.{number}")
    target = chance.choice(targets)
    here = folder / str(number)
    here.mkdir()
    if target.name.startswith("result/"):
        shutil.copytree(result, here / "result")
    name = target.name if "." in target.name else "list.csv"
    (here / name).write_bytes(damaged(target.sound, chance, target.kinds))
    if target.case:
        (here / "case.toml").write_text(target.case.replace("{file}", name), encoding="utf-8")
    return attempt(*target.words, folder=here), target, here


def sound_result(folder):
    """Runs a cell whose result is damaged later, and makes sure that every sound file is read."""
    (folder / "fibers.csv").write_text(FIBERS, encoding="utf-8")
    (folder / "case.toml").write_text(CELL.replace("{file}", "fibers.csv"), encoding="utf-8")
    trial = attempt("run", "case.toml", "--out", "result", folder=folder, longest=60)
    assert trial.status == 0, trial.errors
    return folder / "result"


def require_sound(targets, folder, result):
    for i, target in enumerate(targets):
        undamaged = Target(target.name, target.sound, target.words, [lambda data, chance: data], target.case)
        trial, _, _ = one_run(f"sound{i}", 0, [undamaged], folder, result)
        assert trial.status == 0, f"{target.name} is refused sound: {trial.words}\n{trial.errors}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=Path, help="where damaged files that must not be go")
    options = parser.parse_args()
    tally = Tally()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        result = sound_result(folder)
        targets = text_targets() + byte_targets(result)
        require_sound(targets, folder, result)
        with ThreadPoolExecutor(options.jobs) as pool:
            runs = pool.map(lambda n: one_run(n, options.seed, targets, folder, result), range(options.runs))
            for trial, target, here in runs:
                fault = tally.count(trial, f"{target.name}, run {here.name}", target.place_wanted)
                if fault and options.keep:
                    shutil.copytree(here, options.keep / here.name, dirs_exist_ok=True)
                shutil.rmtree(here)
    print(f"fuzz_files, seed {options.seed}, {Path(PROGRAM).name}:")
    return tally.report()


if __name__ == "__main__":
    sys.exit(main())
