#!/usr/bin/env python3
"""Sets what `check` foretells, time and memory, beside what the run then takes; prints one table.

Usage: estimates.py --program build/release/bin/fiberfate [NAME...]. A case is a folder of cases/, shortened where a whole
one would take too long. Exit status 1 when one is off by more than a factor of two; times below 0.2 s and memory below
40 MB count as those: who waits for that sees no difference.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEAST_SECONDS, LEAST_BYTES = 0.2, 40e6
# Name: the folder of cases/ and what is changed.
CASES = {
    "one rigid fiber": ("01_jeffery_orbit", []),
    "one fiber of 25 rods": ("02_segmentation", ["run.duration=60"]),
    "138 short fibers": ("03_table_2", []),
    "138 short fibers, fixed step": ("03_table_2", ["step.control=fixed", "step.initial=1e-5"]),
    "222 fibers, 21 %": ("00_demo", ["run.duration=0.2"]),
    "64 fibers, 21 %": ("04_couette_43wt", ["fibers.count=64", "cell.size=0.6 mm", "run.duration=0.5",
                                            "output.histogram_times=[]"]),
    "64 fibers, 13 %": ("05_couette_30wt", ["fibers.count=64", "cell.size=0.7 mm", "run.duration=0.5",
                                            "output.histogram_times=[]"]),
    "long fibers, 2 %": ("06_stress_threshold", ["cell.size=1.2 mm", "run.duration=0.3"]),
    "packing, 5 %": ("07_cluster_figure_3_7", []),
    "packing, bundles": ("08_pellets", []),
    "packing, two kinds": ("09_glass_and_carbon", []),
    "tensor and distribution": ("10_orientation_shear", []),
    "sharp distribution": ("10_orientation_shear", ["solution.degree=80", "run.duration=50 s"]),
    "tensor, slow law": ("11_iard_rpr", []),
    "tensor, fine output": ("11_iard_rpr", ["output.interval=0.002"]),
    "stiffness": ("13_injected_plate_stiffness", []),
    "lengths": ("20_couette_length", []),
    "lengths, 800 bins": ("20_couette_length", ["law.name=phelps", "fibers.form=distribution", "fibers.bins=800",
                                               "output.interval=0.05"]),
    "fit to curves": ("24_couette_curves", []),
    "fit with bootstrap": ("25_xi_sweep", []),
    "fit of a tensor": ("26_rsc_from_shear", []),
    "measured fibers": ("27_measured_fibers", []),
    "fit in molds": ("33_molding_xi", []),
    "four constants in molds": ("29_stress_law_in_mold", []),
    "plaque": ("30_plaque", []),
    "length classes": ("31_length_classes", []),
    "tailgate": ("32_tailgate", ["short"]),
    "bins in a mold": ("34_phelps_in_mold", []),
    "strip": ("35_strip", []),
    "disc": ("36_disc", []),
}


def changes_of(changes):
    words = []
    for change in changes:
        words += ["--variant", change] if "=" not in change else ["--set", change]
    return words


def read_seconds(text):
    """Reads "about 3.2 s", "less than 0.1 s" or "about 5 min"."""
    number, unit = re.search(r"([\d.e+-]+) (s|min|h|days|years)\b", text).groups()
    return float(number) * {"s": 1, "min": 60, "h": 3600, "days": 86400, "years": 3.156e7}[unit]


def read_bytes(text):
    number, unit = re.search(r"about ([\d.]+) (MB|GB)", text).groups()
    return float(number) * {"MB": 1e6, "GB": 1e9}[unit]


def fact(text, name):
    return re.search(rf"^#   {name} +(.*)$", text, re.MULTILINE).group(1)


def measure(program, name):
    """Runs a case after its check; `program` is a list of words."""
    folder, changes = CASES[name]
    case = str(ROOT / "cases" / folder / "case.toml")
    begin = time.monotonic()
    check = subprocess.run([*program, "check", case, *changes_of(changes)], capture_output=True, text=True, check=False)
    checking = time.monotonic() - begin
    if check.returncode != 0:
        sys.exit(f"{name}: {check.stderr}")
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(scratch) / "r"
        begin = time.monotonic()
        run = subprocess.run([*program, "run", case, "--out", str(out), "--progress", "none", *changes_of(changes)],
                             capture_output=True, text=True, check=False)
        wall = time.monotonic() - begin
        if run.returncode != 0:
            sys.exit(f"{name}: {run.stderr}")
        memory = json.loads((out / "summary.json").read_text())["peak_memory_bytes"]
    return {"checking": checking, "seconds": (read_seconds(fact(check.stdout, "wall time")), wall),
            "bytes": (read_bytes(fact(check.stdout, "memory")), memory)}


def ratio(pair, least):
    foretold, taken = (max(value, least) for value in pair)
    return foretold / taken


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--prefix", default="", help="a command that runs the program: 'taskset -c 0'")
    parser.add_argument("names", nargs="*", help="; ".join(CASES))
    options = parser.parse_args()
    print(f"{'case':<30}{'check':>7}{'foretold':>10}{'taken':>9}{'ratio':>7}{'MB foretold':>13}{'taken':>8}{'ratio':>7}")
    off = []
    for name in options.names or CASES:
        found = measure([*options.prefix.split(), options.program], name)
        times, sizes = ratio(found["seconds"], LEAST_SECONDS), ratio(found["bytes"], LEAST_BYTES)
        print(f"{name:<30}{found['checking']:>6.2f}s{found['seconds'][0]:>9.3g}s{found['seconds'][1]:>8.3g}s{times:>7.2f}"
              f"{found['bytes'][0] / 1e6:>13.0f}{found['bytes'][1] / 1e6:>8.0f}{sizes:>7.2f}", flush=True)
        off += [name] if not (0.5 <= times <= 2 and 0.5 <= sizes <= 2) else []
    if off:
        sys.exit(f"off by more than a factor of two: {', '.join(off)}")


if __name__ == "__main__":
    main()
