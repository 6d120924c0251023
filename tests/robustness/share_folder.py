#!/usr/bin/env python3
"""Lets two processes meet in one result folder: exactly one works, the other names it, and the result is right.

    share_folder.py [--pairs 30] [--seed 1] [--jobs 1] [--figure FILE]

Pairs: two resumes at once, a resume during a run, a resume or --overwrite during a resume, --overwrite during a run, two
runs at once. The first of a pair may be held (SIGSTOP) while the second comes, so that they meet on a busy machine too.
Prints what must not be, and one line of figures; the exit status is 1 unless there is nothing of it.
"""
import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import figure
from long_cases import cells, moldings
from results import difference, rows_of
from trial import ITSELF, PROGRAM

LONGEST = 600  # s
# What the first process does, and the second one; {case} and {out} as in their commands.
RUN, RESUME = ["run", "{case}", "--out", "{out}"], ["resume", "{out}"]
OVERWRITE = [*RUN, "--overwrite"]
KINDS = {"two resumes at once": (RESUME, RESUME), "resume during a run": (RUN, RESUME), "resume during a resume": (RESUME, RESUME),
         "--overwrite during a run": (RUN, OVERWRITE), "--overwrite during a resume": (RESUME, OVERWRITE), "two runs at once": (RUN, RUN)}


def start(words, case_file, out):
    command = [PROGRAM, *(word.format(case=case_file, out=out) for word in words), "--progress", "none", "--threads", "1"]
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")


def stopped_at(share, whole, case_file, out):
    """Makes a result that was killed when a share of its rows was there."""
    process = start(RUN, case_file, out)
    while process.poll() is None and rows_of(out) < share * rows_of(whole):
        time.sleep(0.005)
    process.kill()
    process.communicate(timeout=LONGEST)


def wait_for_rows(process, out, count):
    end = time.monotonic() + LONGEST
    while process.poll() is None and rows_of(out) < count and time.monotonic() < end:
        time.sleep(0.002)


def meet(kind, whole, case_file, out, chance):
    """Lets two processes meet and gives both as [(process, words)], the one that came first, first."""
    first_words, second_words = KINDS[kind]
    if first_words is RESUME:
        stopped_at(chance.uniform(0.1, 0.4), whole, case_file, out)
    first = start(first_words, case_file, out)
    if "at once" in kind:
        second = start(second_words, case_file, out)
        return [(process, process.communicate(timeout=LONGEST)[1]) for process in (first, second)]
    wait_for_rows(first, out, rows_of(out) + 1 + chance.uniform(0, 0.3) * rows_of(whole))
    held = first.poll() is None
    if held:
        first.send_signal(signal.SIGSTOP)
    second = start(second_words, case_file, out)
    refusal = second.communicate(timeout=LONGEST)[1]
    if held:
        first.send_signal(signal.SIGCONT)
    return [(first, first.communicate(timeout=LONGEST)[1]), (second, refusal)]


def fault_of(kind, ends):
    statuses = sorted(process.returncode for process, _ in ends)
    if statuses != [0, 2]:
        return f"statuses {statuses}: {[words[-200:] for _, words in ends]}"
    (worker, said), (loser, refusal) = sorted(ends, key=lambda end: end[0].returncode)
    if ITSELF in said + refusal:
        return "an error of the program itself"
    if f"is being written to by process {worker.pid} on {os.uname().nodename}, since 2" in refusal:
        return None
    # Of two runs that begin at once, the later may come when the earlier has its first files.
    return None if kind == "two runs at once" and "already holds a result" in refusal else f"the refusal names nobody: {refusal[-200:]}"


def run_whole(case, folder):
    case_file, whole = case.write(folder), folder / "whole"
    process = start(RUN, case_file, whole)
    complaint = process.communicate(timeout=LONGEST)[1]
    assert process.returncode == 0, complaint
    return case_file, whole


def one_pair(number, seed, cases, folder):
    chance = random.Random(f"{seed}.{number}")
    kind = list(KINDS)[number % len(KINDS)]
    name = list(cases)[number // len(KINDS) % len(cases)]
    case_file, whole = cases[name]
    out = folder / str(number)
    ends = meet(kind, whole, case_file, out, chance)
    fault = fault_of(kind, ends) or difference(whole, out)
    shutil.rmtree(out)
    return kind, name, fault


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, count in (("pairs", 30), ("seed", 1), ("jobs", 1)):
        parser.add_argument("--" + name, type=int, default=count)
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    counts, clean = {}, 0
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.jobs) as pool:
        folder, cases = Path(scratch), {}
        for case in (moldings()[0], cells()[0], cells()[3])[:-(-options.pairs // len(KINDS))]:
            cases[case.name] = run_whole(case, folder / case.name)
        for number, (kind, name, fault) in enumerate(pool.map(lambda n: one_pair(n, options.seed, cases, folder), range(options.pairs))):
            counts.setdefault(kind, {}).setdefault("wrong" if fault else "one works, the other names it, result right", 0)
            counts[kind]["wrong" if fault else "one works, the other names it, result right"] += 1
            clean += not fault
            if fault:
                print(f"pair {number}, {kind}, {name}: {fault}", flush=True)
    figures = f"{options.pairs} pairs in one folder: in {clean} one worked, the other named it, and the result was bitwise right"
    if options.figure:
        figure.bars(options.figure, figures, counts)
    print(f"share_folder, seed {options.seed}, {Path(PROGRAM).name}:\n{figures}")
    return 0 if clean == options.pairs else 1


if __name__ == "__main__":
    sys.exit(main())
