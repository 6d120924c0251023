#!/usr/bin/env python3
"""Kills runs of every study that runs long, resumes them, kills them again: the end must be that of one go.

    kill_runs.py [--cells 100] [--others 60] [--moldings 60] [--seed 1] [--jobs 2] [--only N] [--keep FOLDER] [--figure FILE]

Each trial runs one case to its end through one to four interruptions: SIGKILL when a share of the run is done, SIGKILL
while a file is being replaced, SIGKILL inside one system call that writes (with strace, where it is allowed), SIGTERM,
SIGINT. All files must then be bitwise those of an uninterrupted run. Prints what must not be, and one line of figures;
the exit status is 1 unless there is nothing of it.
"""
import argparse
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import figure
from long_cases import cells, moldings, others
from results import PASSING, difference, rows_of, unreadable
from trial import ITSELF, PROGRAM

LONGEST = 600  # s; a run that takes longer hangs, however busy the machine is
CALLS = ("write", "pwrite64", "rename", "fsync", "ftruncate", "truncate", "link", "unlink", "openat", "fdatasync", "mkdir")
KINDS = {"SIGKILL": 4, "SIGKILL while replacing": 3, "SIGKILL in a call": 3, "SIGTERM": 1, "SIGINT": 1}
STOPPED = 4


@dataclass
class Whole:
    """One uninterrupted run: its result, how long it took, and how often it called what writes."""
    case_file: Path
    folder: Path
    seconds: float
    rows: int
    calls: dict


@dataclass
class Story:
    """What a trial went through."""
    case: str
    group: str
    kills: list = field(default_factory=list)  # (kind, share of the run)
    fault: str = ""


def strace_works():
    if not shutil.which("strace"):
        return False
    return subprocess.run(["strace", "-o", "/dev/null", "true"], capture_output=True, check=False).returncode == 0


def count_calls(case, case_file):
    """Runs the case once more under strace and counts its calls of each kind."""
    record = case_file.parent / "calls.txt"
    command = ["strace", "-qq", "-o", str(record), "-e", "trace=" + ",".join(CALLS), PROGRAM, "run", str(case_file), "--out",
               str(case_file.parent / "counted"), *case.words(1)]
    subprocess.run(command, capture_output=True, check=True, timeout=LONGEST)
    found = re.findall(r"^(\w+)\(", record.read_text(errors="replace"), re.M)
    return {call: found.count(call) for call in CALLS if found.count(call)}


def run_whole(case, folder, traced):
    case_file, begin = case.write(folder), time.monotonic()
    subprocess.run([PROGRAM, "run", str(case_file), "--out", str(folder / "whole"), "--progress", "none", *case.words(1)], capture_output=True,
                   check=True, timeout=LONGEST)
    seconds = time.monotonic() - begin
    return Whole(case_file, folder / "whole", seconds, rows_of(folder / "whole"), count_calls(case, case_file) if traced else {})


class Trial:
    def __init__(self, number, options, case, whole):
        self.chance = random.Random(f"{options.seed}.{number}")
        self.case, self.whole = case, whole
        self.story = Story(case.name, case.group)
        self.result = None

    def kind(self):
        kinds = [kind for kind in KINDS if self.whole.calls or kind != "SIGKILL in a call"]
        return self.chance.choices(kinds, [KINDS[kind] for kind in kinds])[0]

    def command(self):
        threads = self.chance.choice([1, 1, 1, 2])
        words = ["resume", str(self.result)] if (self.result / "case.resolved.toml").exists() else ["run", str(self.whole.case_file), "--out", str(self.result)]
        return [PROGRAM, *words, "--progress", "none", *self.case.words(threads)]

    def share(self, begin):
        """How far the run is: rows of its series, or wall time for studies that write at the end."""
        rows = rows_of(self.result)
        if self.whole.rows and rows:
            return rows / self.whole.rows
        return min((time.monotonic() - begin) / self.whole.seconds, 0.99)

    def wait_until(self, process, wanted, begin):
        while process.poll() is None and self.share(begin) < wanted and time.monotonic() - begin < LONGEST:
            time.sleep(0.002)

    def wait_for_passing_file(self, process, longest):
        end = time.monotonic() + longest
        while process.poll() is None and time.monotonic() < end:
            if any(name.name.endswith(PASSING) for name in self.entries()):
                return
        return

    def entries(self):
        try:
            return list(self.result.iterdir())
        except OSError:
            return []

    def interrupt(self, command, kind):
        """Starts the command and interrupts it; tells its status."""
        begin, log = time.monotonic(), self.log()
        if kind == "SIGKILL in a call":
            call = self.chance.choice(sorted(self.whole.calls))
            turn = self.chance.randrange(1, self.whole.calls[call] + 1)
            command = ["strace", "-qq", "-o", "/dev/null", "-e", f"trace={call}", "-e", f"inject={call}:signal=SIGKILL:when={turn}", *command]
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")
        if kind != "SIGKILL in a call":
            now = rows_of(self.result) / max(self.whole.rows, 1)
            self.wait_until(process, self.chance.uniform(now, 1), begin)
            time.sleep(self.chance.uniform(0, 0.01))
            if kind == "SIGKILL while replacing":
                self.wait_for_passing_file(process, 0.5 * self.whole.seconds)
            where = self.share(begin)
            process.send_signal(signal.SIGKILL if kind.startswith("SIGKILL") else getattr(signal, kind))
        _, complaint = process.communicate(timeout=LONGEST)
        if kind == "SIGKILL in a call":
            where = self.share(begin)
        if process.returncode in (-signal.SIGKILL, STOPPED):
            self.story.kills.append((kind, where))
        self.judge(process.returncode, kind, complaint, has_begun=self.log() != log)
        return process.returncode

    def log(self):
        """What the program has written to its log: a line as soon as it has taken the folder."""
        try:
            return (self.result / "log.txt").read_bytes()
        except OSError:
            return b""

    def judge(self, status, kind, complaint, has_begun):
        allowed = {0, -signal.SIGKILL} if kind.startswith("SIGKILL") else {0, STOPPED}
        if status in (-signal.SIGTERM, -signal.SIGINT) and not has_begun:
            allowed.add(status)  # a signal before the program watches for it ends it as it ends any program
        if status not in allowed or ITSELF in complaint:
            self.fail(f"{kind}: status {status}: {complaint[-300:].strip()}")

    def fail(self, what):
        self.story.fault = self.story.fault or what

    def finish(self):
        for _ in range(2):  # a run that was killed before it wrote its case begins again; one that was done says so
            done = subprocess.run(self.command(), capture_output=True, text=True, errors="replace", timeout=LONGEST, check=False)
            if done.returncode != 0 or ITSELF in done.stderr:
                return self.fail(f"the last resume: status {done.returncode}: {done.stderr[-300:].strip()}")
            if (self.result / "summary.json").exists():
                break
        return self.fail(difference(self.whole.folder, self.result))

    def run(self, folder):
        self.result = folder / "result"
        folder.mkdir()
        for _ in range(self.chance.choice([1, 2, 3, 4])):
            ended = self.interrupt(self.command(), self.kind()) == 0
            self.fail(unreadable(self.result) if self.result.exists() else None)
            if ended or self.story.fault:
                break
        if not self.story.fault:
            self.finish()
        return self.story


def plan(options):
    """Deals the cases of each group to its trials in turn."""
    trials = []
    for count, group in ((options.cells, cells()), (options.others, others()), (options.moldings, moldings())):
        trials += [group[n % len(group)] for n in range(count)]
    return list(enumerate(trials))


def report(stories, options):
    clean = True
    parts = []
    for group, name in (("cell", "cells"), ("other", "clusters and process level"), ("molding", "moldings with gates")):
        mine = [story for story in stories if story.group == group]
        same = sum(not story.fault for story in mine)
        clean = clean and same == len(mine)
        parts.append(f"{same} of {len(mine)} {name}")
    kills = [(story.case, share, kind) for story in stories for kind, share in story.kills]
    figures = f"{len(kills)} interruptions, bitwise the same: " + ", ".join(parts)
    if options.figure:
        figure.dots(options.figure, figures, "share of the run at which it was interrupted", sorted(kills))
    print(f"kill_runs, seed {options.seed}, {Path(PROGRAM).name}:\n{figures}")
    return 0 if clean else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, count in (("cells", 100), ("others", 60), ("moldings", 60), ("seed", 1), ("jobs", 2)):
        parser.add_argument("--" + name, type=int, default=count)
    parser.add_argument("--only", type=int, help="repeat this trial alone")
    parser.add_argument("--keep", type=Path, help="where results that must not be go")
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    trials = [one for one in plan(options) if options.only in (None, one[0])]
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.jobs) as pool:
        folder, traced = Path(scratch), strace_works()
        cases = {case.name: case for _, case in trials}
        wholes = dict(zip(cases, pool.map(lambda case: run_whole(case, folder / case.name, traced), cases.values())))

        def one(numbered):
            number, case = numbered
            here = folder / str(number)
            story = Trial(number, options, case, wholes[case.name]).run(here)
            if story.fault:
                print(f"trial {number}, {case.name}, {[kind for kind, _ in story.kills]}: {story.fault}", flush=True)
                if options.keep:
                    shutil.copytree(here, options.keep / str(number), dirs_exist_ok=True)
            shutil.rmtree(here)
            return story

        return report(list(pool.map(one, trials)), options)


if __name__ == "__main__":
    sys.exit(main())
