#!/usr/bin/env python3
"""Measures a build: the Couette case from three of its states, and every Google Benchmark program; prints one table.

Usage: run_benchmarks.py --bin BIN --out OUT [--quick]. With --quick it only shows that it works. OUT receives
the numbers as JSON: whole_runs.json and one file a program.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE = ROOT / "cases" / "04_couette_43wt" / "case.toml"
STEPS = 300
# States of the case that are measured: its packing, and later moments, which the error control's own steps reach.
MOMENTS = {"dense": None, "1.5 s": 1.5, "8 s": 8.0}
# A step of one size, so that runs do the same work whatever the error control of the day would choose.
FIXED_STEP = ["step.control=fixed", "step.initial=1e-4 s", "output.interval=10 s", "output.frame_interval=1000 s"]
PHASES = ["neighbours", "loads", "solve", "update", "breakage"]


# With --quick: a small cell of the same fibers, soon after its packing.
QUICK = {"name": "couette 60 x 25", "steps": 5, "moments": {"dense": None, "10 ms": 0.01}, "sample": ["fibers.count=60", "cell.size=0.6 mm"]}
WHOLE = {"name": "couette 1000 x 25", "steps": STEPS, "moments": MOMENTS, "sample": []}


def settings(changes):
    """Gives the words of the command line that change keys."""
    return [word for change in changes for word in ("--set", change)]


def run(command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def make_states(program, folder, extent):
    """Runs the case and keeps its folder at every moment; what an earlier call has made is kept."""
    last = None
    for name, moment in extent["moments"].items():
        state = folder / name.replace(" ", "_")
        if not (state / "done").exists():
            shutil.rmtree(state, ignore_errors=True)
            if last is None:
                run([program, "run", CASE, "--out", state, "--steps", 1, *settings(extent["sample"])])
            else:
                shutil.copytree(last, state, ignore=shutil.ignore_patterns("done"))
                run([program, "resume", state, "--until", f"{moment} s"])
            (state / "done").touch()
        last = state
        yield name, state


def measure(program, state, scratch, threads, extent):
    """Makes some steps of one size from the fibers of a state and returns what the program says of them."""
    shutil.rmtree(scratch, ignore_errors=True)
    changes = [*FIXED_STEP, *extent["sample"][1:], "cluster.source=file",
               f"cluster.file={(state / 'checkpoint.h5').resolve()}"]
    run([program, "run", CASE, "--out", scratch, "--threads", threads, "--steps", extent["steps"], *settings(changes)])
    found = json.loads((scratch / "summary.json").read_text())
    found["simulated_s_per_wall_s"] = found["segment_steps_per_s"] / found["rods"] * 1e-4
    return found


def whole_runs(program, out, extent):
    """Steps the 1000 × 25 Couette case from each of its states, on one thread and on two."""
    summaries = {}
    for name, state in make_states(program, out / "states", extent):
        for threads in (1, 2):
            summaries[f"{extent['name']}, {name}, {threads} thread"] = measure(program, state, out / "couette", threads, extent)
    (out / "whole_runs.json").write_text(json.dumps(summaries, indent=2) + "\n")
    return summaries


SMALL_ROD = """study = "shear_cell"
[fibers]
length = "3 mm"
diameter = "100 um"
youngs_modulus = "50 GPa"
rod_length = "150 um"
[cluster]
source = "fiber"
direction = [0.0, 1.0, 0.05]
[flow]
rate = "1 1/s"
viscosity = "1 Pa s"
[run]
duration = "300 s"
[output]
interval = "0.5 s"
frame_interval = "50 s"
"""


def twenty_rods(program, out):
    """Steps one fiber of twenty rods on one thread and on two while every core has other work, and tells the wall
    seconds of each: small work must not wait for a second thread. The two take turns, and the lesser time counts."""
    case = out / "twenty_rods.toml"
    case.write_text(SMALL_ROD)
    others = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(os.cpu_count())]
    try:
        seconds = {1: [], 2: []}
        for _ in range(3):
            for threads, found in seconds.items():
                begin = time.monotonic()
                run([program, "run", case, "--out", out / "twenty_rods", "--overwrite", "--threads", threads])
                found.append(time.monotonic() - begin)
    finally:
        for other in others:
            other.kill()
            other.wait()
    least = {threads: min(found) for threads, found in seconds.items()}
    (out / "twenty_rods.json").write_text(json.dumps(least) + "\n")
    print(f"\ntwenty rods while every core has other work: {least[1]:.2f} s on one thread, {least[2]:.2f} s on two")


def print_runs(summaries, steps):
    heading = f"whole run, {steps} steps of 1e-4 s"
    print(f"\n{heading:<36}{'Mrod-steps/s':>13}{'of cpu':>8}{'s/wall s':>10}{'MiB':>6}  ns a rod-step: {'  '.join(PHASES)}")
    for name, summary in summaries.items():
        work = summary["rods"] * steps
        shares = "  ".join(f"{summary['timings'][phase] / work * 1e9:>{len(phase)}.0f}" for phase in PHASES)
        rate = summary["segment_steps_per_s"] / 1e6
        print(f"{name:<36}{rate:>13.2f}{work / summary['cpu_s'] / 1e6:>8.2f}{summary['simulated_s_per_wall_s']:>10.4f}"
              f"{summary['peak_memory_bytes'] / 2**20:>6.0f}{'':>17}{shares}")


def print_programs(programs, out):
    print(f"\n{'kernel':<60}{'time':>14}{'Mitems/s':>12}")
    for program in programs:
        path = out / f"{program.name}.json"
        run([program, f"--benchmark_out={path}", "--benchmark_out_format=json"])
        for entry in json.loads(path.read_text())["benchmarks"]:
            rate = f"{entry['items_per_second'] / 1e6:.3f}" if "items_per_second" in entry else ""
            print(f"{entry['name']:<60}{entry['real_time']:>11.3f} {entry['time_unit']}{rate:>12}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--quick", action="store_true", help="only show that the benchmarks work")
    options = parser.parse_args()
    extent = QUICK if options.quick else WHOLE
    options.out.mkdir(parents=True, exist_ok=True)
    print_runs(whole_runs(options.bin / "fiberfate", options.out, extent), extent["steps"])
    if options.quick:
        return
    twenty_rods(options.bin / "fiberfate", options.out)
    print_programs(sorted(options.bin.glob("*_bench")), options.out)


if __name__ == "__main__":
    main()
