#!/usr/bin/env python3
"""Runs long: millions of steps of a small cell, a long orientation, a filling in many thousand steps, long attrition.

    soak.py [--scale 1] [--only TEXT] [--figure FILE]

Nothing may drift (traces, rod lengths, fibers, volumes), memory may not grow after the first quarter of a run, and files
grow only as their rows and frames do. Prints what must not be, and one line of figures; the exit status is 1 unless there
is nothing of it. --scale 0.01 makes a hundredth of the steps.
"""
import argparse
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy

import figure
from long_cases import ATTRITION, CELL, GATES, changed, straight_fibers
from results import summary
from trial import PROGRAM

LONGEST = 7200  # s
SHORT = 4  # s; the memory of shorter runs tells nothing


@dataclass
class Soak:
    name: str
    text: str
    steps: int  # that are about to be made
    words: tuple = ()


def soaks(scale):
    steps = max(int(2_000_000 * scale), 2000)
    cell = changed(CELL, ('duration = "60 ms"', f'duration = {steps * 1e-5!r}'), ('rate = "200 1/s"', 'rate = "20 1/s"'), ('youngs_modulus = "10 GPa"', 'youngs_modulus = "73 GPa"'),
                   ('interval = "0.5 ms"\nframe_interval = "2 ms"\ncheckpoint_interval = "0.02 s"', f"interval = {steps * 1e-5 / 200!r}\nframe_interval = {steps * 1e-5 / 20!r}"),
                   ('[breakage]\nlaw = "probability"\ncheck_interval = "1 ms"', '[step]\ncontrol = "fixed"\ninitial = "10 us"'))
    seconds = max(1e6 * scale, 1000)
    orientation = f"""study = "orientation"
[diffusion]
name = "iard"
C_I = 0.0165
C_M = 0.9
[retardation]
name = "rpr"
alpha = 0.9
[flow]
rate = "1 1/s"
[run]
duration = {seconds!r}
[output]
interval = {seconds / 1000!r}
"""
    tumbling = changed(orientation, ('name = "iard"\nC_I = 0.0165\nC_M = 0.9', 'name = "jeffery"'), ('[retardation]\nname = "rpr"\nalpha = 0.9', "[fibers]\naspect_ratio = 20"))
    fine = max(int(20000 * scale), 200)
    molding = changed(GATES, ('mesh_size = "5 mm"', 'mesh_size = "10 mm"'), ("steps = 120", f"steps = {fine}"), ('checkpoint_interval = "1 ms"', 'checkpoint_interval = "1 s"'))
    attrition = changed(ATTRITION, ('duration = "20 s"', f"duration = {max(2e5 * scale, 200)!r}"), ('interval = "0.02 s"', f"interval = {max(2e5 * scale, 200) / 1000!r}"), ("bins = 800", "bins = 100"))
    return [Soak("cell", cell, steps, ("--threads", "1")), Soak("orientation", orientation, int(seconds)), Soak("tumbling orientation", tumbling, int(seconds)),
            Soak("molding", molding, fine, ("--threads", "1")), Soak("attrition", attrition, 1000)]


def resident_mib(process):
    try:
        for line in Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8").splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) / 1024
    except (OSError, ValueError):
        pass
    return None


def size_of(folder):
    total = 0
    for path in folder.glob("*"):
        try:
            total += path.stat().st_size
        except OSError:  # it was replaced meanwhile
            pass
    return total


def watch(process, result):
    """Samples memory and the size of the result while the process lives: [(seconds, MiB, bytes)]."""
    samples, begin = [], time.monotonic()
    while process.poll() is None:
        if time.monotonic() - begin > LONGEST:
            process.kill()
        memory = resident_mib(process)
        if memory:
            samples.append((time.monotonic() - begin, memory, size_of(result)))
        time.sleep(min(0.05 + 0.01 * (time.monotonic() - begin), 2))
    return samples


def growth(samples):
    """How much memory is more late in a run than in its first half; begin and end, which prepare and gather, aside."""
    if not samples or samples[-1][0] < SHORT:
        return 0.0
    early, late = ([memory for when, memory, _ in samples if low <= when / samples[-1][0] <= high] for low, high in ((0.1, 0.5), (0.8, 0.95)))
    return sorted(late)[len(late) // 2] - max(early) if early and late else 0.0


def trace_drift(values):
    return abs(float(numpy.trace(numpy.array(values["A2"]))) - 1)


def rod_drift(result):
    """How far the largest distance between nodes is from the length that its rod has, and had at the start."""
    with h5py.File(result / "checkpoint.h5") as file:
        state = file["state"]
        nodes, lengths = state["position"][:], state["rod_length"][:]
    apart = numpy.linalg.norm(numpy.diff(nodes, axis=0), axis=1)
    rods = lengths[:-1] > 0
    return max(float(numpy.abs(apart[rods] / lengths[:-1][rods] - 1).max()), float(numpy.abs(lengths[lengths > 0] / 60e-6 - 1).max()))


def faults(soak, result, samples):
    values = summary(result)
    if "A2" in values and trace_drift(values) > 1e-12:
        yield f"the trace drifted by {trace_drift(values):.2g}"
    if soak.name == "cell" and (rod_drift(result) > 1e-9 or values["fibers"] != 3):
        yield f"{values['fibers']} fibers, rods off by {rod_drift(result):.2g}"
    if abs(values.get("volume_error", 0)) > 1e-9:
        yield f"volume_error {values['volume_error']:.2g}"
    if abs(values.get("total_length_change", 0)) > 1e-9:
        yield f"the total length changed by {values['total_length_change']:.2g}"
    if growth(samples) > 4:
        yield f"memory grew by {growth(samples):.1f} MiB"
    half = max((size for when, _, size in samples if when <= 0.5 * samples[-1][0]), default=0)
    if half and size_of(result) > 2.5 * half + (2 << 20):
        yield f"files grew from {half} bytes at half the run to {size_of(result)}"


def run(soak, folder):
    (folder / "fibers.csv").write_text(straight_fibers(fibers=3, rods=5, rod_length=60e-6), encoding="utf-8")
    (folder / "case.toml").write_text(soak.text, encoding="utf-8")
    result = folder / "result"
    with open(folder / "words.txt", "w", encoding="utf-8") as words:
        process = subprocess.Popen([PROGRAM, "run", "case.toml", "--out", "result", "--progress", "none", *soak.words], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=words, stderr=words)
        samples = watch(process, result)
    if process.returncode != 0:
        return samples, [f"status {process.returncode}: {(folder / 'words.txt').read_text()[-300:]}"], {}
    return samples, list(faults(soak, result, samples)), {**summary(result), "rod_drift": rod_drift(result) if soak.name == "cell" else 0}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scale", type=float, default=1)
    parser.add_argument("--only", default="", help="runs whose name holds this text")
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    curves, parts, clean = {}, [], True
    for soak in soaks(options.scale):
        if options.only not in soak.name:
            continue
        with tempfile.TemporaryDirectory() as scratch:
            samples, found, values = run(soak, Path(scratch))
        for fault in found:
            print(f"{soak.name}: {fault}", flush=True)
        clean = clean and not found
        if samples:
            curves[soak.name] = [(when / samples[-1][0], memory) for when, memory, _ in samples]
        drift = f", trace off by {trace_drift(values):.1g}" if "A2" in values else f", total length off by {abs(values.get('total_length_change', 0)):.1g}"
        drift += f", rods by {values['rod_drift']:.1g}" if values.get("rod_drift") else ""
        parts.append(f"{soak.name} {values.get('steps', 0)} steps{drift}, memory {growth(samples):+.1f} MiB")
    figures = "; ".join(parts)
    if options.figure:
        figure.curves(options.figure, "Memory over long runs", "share of the run", "MiB", curves)
    print(f"soak, {Path(PROGRAM).name}:\n{figures}")
    return 0 if clean else 1


if __name__ == "__main__":
    sys.exit(main())
