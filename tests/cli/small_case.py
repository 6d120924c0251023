"""Makes a small case of the study shear_cell that runs in a second or two and breaks fibers."""
import csv
import json
import os
import subprocess

import numpy

# Threads of tests that run beside each other must not spin against one another.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

PROGRAM = os.environ.get("FIBERFATE", "fiberfate")
FIBERS = 40
RODS = 12
ROD_LENGTH = 60e-6

CASE = """study = "shear_cell"

[run]
duration = "20 ms"
seed = 7

[cell]
size = "0.5 mm"

[fibers]
diameter = "19 um"
youngs_modulus = "10 GPa"

[cluster]
source = "file"
file = "fibers.csv"

[flow]
rate = "200 1/s"
viscosity = "1000 Pa s"

[breakage]
law = "probability"
check_interval = "1 ms"

[output]
interval = "1 ms"
frame_interval = "4 ms"
checkpoint_interval = "0.02 s"
"""


def write_fibers(path, fibers=FIBERS, rods=RODS, rod_length=ROD_LENGTH, cell=0.5e-3, seed=3):
    """Writes straight fibers that lie anywhere in the cell."""
    random = numpy.random.default_rng(seed)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["fiber", "x_m", "y_m", "z_m"])
        for fiber in range(fibers):
            direction = random.normal(size=3)
            direction /= numpy.linalg.norm(direction)
            begin = random.uniform(0, cell, 3)
            for node in range(rods + 1):
                writer.writerow([fiber, *(begin + node * rod_length * direction)])


def write_case(folder, text=CASE, **fibers):
    write_fibers(folder / "fibers.csv", **fibers)
    (folder / "case.toml").write_text(text, encoding="utf-8")
    return str(folder / "case.toml")


LONGEST = 1200  # seconds that a run may take before it counts as hanging: sanitizers and busy machines are slow


def run(*words, expect=0, **options):
    """Runs the program and returns what it did; `expect` is its exit status."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=LONGEST, check=False, **options)
    assert done.returncode == expect, f"{words}: status {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done


def summary(folder):
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def series(folder, name="series.csv"):
    """Reads a table as lists of text, so that a comparison is one of digits."""
    with open(folder / name, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def column(folder, name, table="series.csv"):
    rows = series(folder, table)
    place = rows[0].index(name)
    return [float(row[place]) for row in rows[1:]]
