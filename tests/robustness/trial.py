"""Runs the program once, within limits of time and memory, and says what became of it."""
import os
import re
import resource
import signal
import subprocess
from dataclasses import dataclass

PROGRAM = os.environ.get("FIBERFATE", "fiberfate")
LONGEST = 10.0  # s; what takes longer hangs
MEMORY = 4 << 30  # bytes; sanitizers map far more, and are not limited

PLACE = re.compile(r"^(?:warning: )?(?:.*?:\d+:\d+: |command line: |fiberfate: )", re.M)
ITSELF = "error of the program itself"


@dataclass
class Trial:
    """What became of one run."""
    words: tuple
    status: int  # negative: killed by that signal
    output: str
    errors: str
    hung: bool = False

    @property
    def crashed(self):
        """The process died, a sanitizer spoke, or the program met what it does not know itself."""
        return not self.hung and (self.status < 0 or self.status not in (0, 2, 3, 4) or ITSELF in self.errors
                                  or "Sanitizer" in self.errors)

    @property
    def refused(self):
        return not self.hung and not self.crashed and self.status == 2

    @property
    def tells_place(self):
        """Every refusal begins with file:line:column, or with what the command line is about."""
        lines = [line for line in self.errors.splitlines() if line and not line.endswith("nothing was written")]
        return bool(lines) and PLACE.match(lines[0]) is not None


def limit_memory():
    if "asan" not in PROGRAM and "tsan" not in PROGRAM:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def attempt(*words, folder, longest=LONGEST, **settings):
    """Runs the program in a folder; time is that of the processor where the machine is shared, or six times as long."""
    command = [PROGRAM, *map(str, words)]
    with subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          preexec_fn=lambda: (limit_memory(), limit_time(longest)), **settings) as process:
        try:
            output, errors = process.communicate(timeout=6 * longest)
        except subprocess.TimeoutExpired:
            process.kill()
            output, errors = process.communicate()
            return Trial(words, process.returncode, text(output), text(errors), hung=True)
    hung = process.returncode == -signal.SIGXCPU
    return Trial(words, process.returncode, text(output), text(errors), hung)


def limit_time(longest):
    seconds = int(longest + 0.999)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))


def text(data):
    return data.decode("utf-8", "replace")


class Tally:
    """Counts what became of many runs, and keeps the first of each kind that must not be."""

    def __init__(self, most_kept=20):
        self.runs = self.accepted = self.placed = self.placeless = self.crashes = self.hangs = self.failures = 0
        self.kept, self.most_kept = [], most_kept

    def count(self, trial, label, place_wanted=True):
        self.runs += 1
        fault = None
        if trial.hung:
            self.hangs += 1
            fault = "hang"
        elif trial.crashed:
            self.crashes += 1
            fault = f"crash (status {trial.status})"
        elif trial.refused and (trial.tells_place or not place_wanted):
            self.placed += 1
        elif trial.refused:
            self.placeless += 1
            fault = "no place"
        elif trial.status == 0:
            self.accepted += 1
        else:
            self.failures += 1  # a run that was read, and failed or was stopped
        if fault and len(self.kept) < self.most_kept:
            self.kept.append(f"{fault}: {label}: {' '.join(map(str, trial.words))}\n    {trial.errors[:300].strip()}")
        return fault

    @property
    def clean(self):
        return self.placeless == self.crashes == self.hangs == 0

    def figure(self):
        """Gives the one line that stands for the campaign."""
        return (f"{self.runs} runs: {self.accepted} accepted, {self.placed} refused with their place, {self.failures} failed in words, "
                f"{self.placeless} refused without place, {self.crashes} crashes, {self.hangs} hangs")

    def report(self):
        for one in self.kept:
            print(one)
        print(self.figure())
        return 0 if self.clean else 1
