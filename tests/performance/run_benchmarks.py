#!/usr/bin/env python3
"""Measures a build: whole runs of the Couette case and every Google Benchmark program; prints one table.

Usage: run_benchmarks.py --bin BIN --out OUT. OUT receives the numbers as JSON: whole_runs.json and one file a program.
"""
import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASE = ROOT / "cases" / "04_couette_43wt" / "case.toml"
STEPS = 300
# A step of one size, so that runs do the same work whatever the error control of the day would choose.
OVERRIDES = ["step.control=fixed", "step.initial=1e-4 s", "output.interval=1 s", "output.frame_interval=1 s"]
PHASES = ["neighbours", "loads", "solve", "update", "breakage"]


def run(command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def whole_runs(program, out):
    """Steps the 1000 × 25 Couette case from its packing, on one thread and then on two."""
    result = out / "couette"
    overrides = [word for override in OVERRIDES for word in ("--set", override)]
    summaries = {}
    run([program, "run", CASE, "--out", result, "--overwrite", "--threads", 1, "--steps", STEPS, *overrides])
    summaries["couette 1000 x 25, 1 thread"] = json.loads((result / "summary.json").read_text())
    run([program, "resume", result, "--threads", 2, "--steps", STEPS])
    summaries["couette 1000 x 25, 2 threads"] = json.loads((result / "summary.json").read_text())
    (out / "whole_runs.json").write_text(json.dumps(summaries, indent=2) + "\n")
    return summaries


def print_runs(summaries):
    print(f"\n{'whole run, 300 steps of 1e-4 s':<32}{'Mrod-steps/s':>13}{'memory MiB':>12}  ns a rod-step: {'  '.join(PHASES)}")
    for name, summary in summaries.items():
        work = summary["rods"] * STEPS
        shares = "  ".join(f"{summary['timings'][phase] / work * 1e9:>{len(phase)}.0f}" for phase in PHASES)
        rate = summary["segment_steps_per_s"] / 1e6
        print(f"{name:<32}{rate:>13.2f}{summary['peak_memory_bytes'] / 2**20:>12.0f}{'':>17}{shares}")


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
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    print_runs(whole_runs(options.bin / "fiberfate", options.out))
    print_programs(sorted(options.bin.glob("*_bench")), options.out)


if __name__ == "__main__":
    main()
