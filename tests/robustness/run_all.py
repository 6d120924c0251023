#!/usr/bin/env python3
"""Runs the long forms of all campaigns, one after another, and prints one line of figures each.

    run_all.py [--bin build/dev/bin/fiberfate] [--figures FOLDER] [--only NAME,NAME]

The exit status is 1 unless there is nothing that must not be. The sizes of the campaigns are those of docs/develop/
reliability.md; together they take about two hours on two cores.
"""
import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
DRAWS = {"kill_runs", "share_folder", "environments", "hostile_cases", "soak"}
CAMPAIGNS = ["fuzz_cases", "fuzz_files", "environments", "hostile_cases", "share_folder", "kill_runs", "soak"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, help="the program; not given: $FIBERFATE, or fiberfate on the path")
    parser.add_argument("--figures", type=Path, help="where the figures of the campaigns go")
    parser.add_argument("--only", default=",".join(CAMPAIGNS), help="names of campaigns")
    options = parser.parse_args()
    environment = {**os.environ, "OMP_WAIT_POLICY": "passive", "PYTHONDONTWRITEBYTECODE": "1"}
    if options.bin:
        environment["FIBERFATE"] = str(options.bin.resolve())
    clean = True
    for name in options.only.split(","):
        figure = ["--figure", str(options.figures / f"{name}.svg")] if options.figures and name in DRAWS else []
        begin = time.monotonic()
        done = subprocess.run([sys.executable, str(HERE / f"{name}.py"), *figure], env=environment, stdout=subprocess.PIPE, text=True, check=False)
        lines = done.stdout.strip().split("\n")
        clean = clean and done.returncode == 0
        print(*(f"    {line}" for line in lines[:-2]), sep="\n", end="\n" if len(lines) > 2 else "")
        print(f"{name}: {lines[-1]} ({'clean' if done.returncode == 0 else 'NOT CLEAN'}, {(time.monotonic() - begin) / 60:.1f} min)", flush=True)
    return 0 if clean else 1


if __name__ == "__main__":
    sys.exit(main())
