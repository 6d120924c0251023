#!/usr/bin/env python3
"""Runs the program in hostile environments: each command must do its work, or refuse or fail in words.

    environments.py [--share 1] [--seed 1] [--jobs 2] [--only TEXT] [--figure FILE]

Closed streams, full and read-only disks, limits of memory, files and file sizes, paths of all kinds, locales, settings
of OpenMP, broken pipes, missing folders, users without rights. What ends with status 0 must have the result bitwise as
in a plain environment. Prints what must not be, and one line of figures; the exit status is 1 unless there is nothing of
it. --share 0.2 takes a fifth of the combinations, drawn with the seed.
"""
import argparse
import contextlib
import itertools
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import figure
from long_cases import CELL, GATES, changed, straight_fibers
from results import difference
from trial import PROGRAM, Trial, text

LONGEST = 120  # s
NOBODY = 65534
# The loader, and the run-time library of OpenMP, speak before the program does.
OF_THE_SYSTEM = ("error while loading shared libraries", "libgomp:", "cannot allocate memory in static TLS block")

QUICK_CELL = changed(CELL, ('duration = "60 ms"', 'duration = "2 ms"'))
QUICK_MOLD = changed(GATES, ('mesh_size = "5 mm"', 'mesh_size = "12 mm"'), ("steps = 120", "steps = 20"), ("frames = 40", "frames = 4"))


@dataclass
class Setting:
    """One environment; `{}` of a shell line is the command, and `inside` prepares the child before it."""
    kind: str
    name: str
    shell: str = "{}"
    variables: dict = field(default_factory=dict)
    inside: object = None
    folder: str = "plain"  # name of the folder to work in, below the scratch
    result: str = ""  # a name of the result folder
    breaks_pipe: bool = False
    merges: bool = False  # where the words went, nobody looks
    other_digits: bool = False  # instruction sets agree to round-off only
    disk: str = ""  # "small", "read-only": a file system of its own
    user: int = 0


def limit(what, value):
    return lambda: resource.setrlimit(what, (value, value))


def streams():
    for count in range(4):
        for closed in itertools.combinations((0, 1, 2), count):
            yield Setting("streams", "closed " + (",".join(map(str, closed)) or "none"), "{} " + " ".join(f"{n}{'<' if n == 0 else '>'}&-" for n in closed))
    for stream in (1, 2):
        yield Setting("streams", f"/dev/full at {stream}", "{} " + f"{stream}>/dev/full")
        yield Setting("streams", f"broken pipe at {stream}", "{} " + f"{stream}> >(exec true)" + "; status=$?; wait; exit $status", breaks_pipe=True)
    yield Setting("streams", "one file for both", "{} >both.txt 2>&1", merges=True)
    yield Setting("streams", "input from /dev/zero", "{} </dev/zero")
    yield Setting("streams", "a terminal", "script -qec {} /dev/null", merges=True)


def limits():
    for mib in (32, 48, 56, 57, 58, 60, 64, 80, 100, 150, 200, 300, 500, 1000):
        yield Setting("memory", f"{mib} MiB", inside=limit(resource.RLIMIT_AS, mib << 20))
    for mib in (1, 16, 64):
        yield Setting("memory", f"{mib} MiB of data", inside=limit(resource.RLIMIT_DATA, mib << 20))
    for kib in (256, 512, 1024):
        yield Setting("memory", f"stack of {kib} KiB", inside=limit(resource.RLIMIT_STACK, kib << 10))
    for count in (3, 4, 5, 6, 7, 8, 10, 12, 16, 24):
        yield Setting("files", f"{count} open files", inside=limit(resource.RLIMIT_NOFILE, count))
    for size in (0, 1, 100, 1000, 4096, 20000, 100000, 300000):
        yield Setting("file size", f"{size} bytes", inside=limit(resource.RLIMIT_FSIZE, size))
    yield Setting("processes", "no more processes", inside=limit(resource.RLIMIT_NPROC, 0), user=NOBODY)
    for mask in (0o000, 0o077, 0o777):
        yield Setting("umask", f"{mask:03o}", inside=lambda mask=mask: os.umask(mask) and None)


def ignore_signals():
    for number in (signal.SIGPIPE, signal.SIGHUP, signal.SIGINT, signal.SIGTERM, signal.SIGCHLD):
        signal.signal(number, signal.SIG_IGN)


def block_signals():
    signal.pthread_sigmask(signal.SIG_BLOCK, range(1, 32))


def variables():
    for name in ("HOME", "PATH", "USER", "TMPDIR", "TERM", "SHELL"):
        yield Setting("variables", "no " + name, f"env -u {name} {{}}")
    yield Setting("variables", "none at all", "env -i {}")
    for name, value in (("TMPDIR", "/nowhere"), ("TMPDIR", "/dev/null"), ("HOME", "/nowhere"), ("HOME", ""), ("TERM", "dumb"), ("TERM", "nonsense"),
                        ("TZ", "nonsense"), ("TZ", "Asia/Kolkata"), ("COLUMNS", "-1"), ("FIBERFATE_X", "y" * 100000)):
        yield Setting("variables", f"{name}={value[:20]}", variables={name: value})
    for value in ("C", "POSIX", "C.UTF-8", "de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "tr_TR.UTF-8", "ar_EG", "zh_CN.GB18030", "ja_JP.EUC-JP", "nonsense", "", "\xff"):
        for name in ("LANG", "LC_ALL", "LC_NUMERIC"):
            yield Setting("locale", f"{name}={value!r}", variables={name: value})
    for value in ("0", "-1", "nonsense", "1", "3", "1000", "99999999999999999999", "1,2,3", ""):
        yield Setting("openmp", f"OMP_NUM_THREADS={value[:12]}", variables={"OMP_NUM_THREADS": value})
    for name, value in (("OMP_DYNAMIC", "true"), ("OMP_NESTED", "true"), ("OMP_SCHEDULE", "nonsense"), ("OMP_PROC_BIND", "true"), ("OMP_PLACES", "{99}"),
                        ("OMP_STACKSIZE", "16"), ("OMP_STACKSIZE", "100G"), ("OMP_THREAD_LIMIT", "1"), ("OMP_WAIT_POLICY", "active"),
                        ("OMP_MAX_ACTIVE_LEVELS", "0"), ("GOMP_SPINCOUNT", "infinity"), ("OMP_DISPLAY_ENV", "true")):
        yield Setting("openmp", f"{name}={value}", variables={name: value})
    for value in ("baseline", "avx2", "avx512", "", "foo", "AVX2", "avx512 "):
        yield Setting("isa", f"FIBERFATE_ISA={value!r}", variables={"FIBERFATE_ISA": value}, other_digits=value in ("baseline", "avx2"))
    for name, value in (("OMPI_COMM_WORLD_SIZE", "1"), ("OMPI_COMM_WORLD_SIZE", "2"), ("PMI_SIZE", "4"), ("PMI_SIZE", "x"), ("HDF5_USE_FILE_LOCKING", "TRUE"),
                        ("HDF5_USE_FILE_LOCKING", "FALSE"), ("UDUNITS2_XML_PATH", "/nowhere"), ("HDF5_DISABLE_VERSION_CHECK", "2")):
        yield Setting("libraries", f"{name}={value}", variables={name: value})
    yield Setting("signals", "ignored", inside=ignore_signals)
    yield Setting("signals", "blocked", inside=block_signals)


def folders():
    for name, title in (("with space", "a space"), ("-dash", "a dash"), ("quote'\"s", "quotes"), ("new\nline", "a line break"), ("tab\there", "a tab"),
                        ("%s%n%d", "percents"), ("{}", "braces"), ("$HOME", "a dollar"), ("ü ñ 漢字 🧵", "letters of the world"), ("\udcff\udcfe", "no UTF-8"), ("x" * 250, "250 letters"),
                        ("/".join(["y" * 200] * 15), "3000 letters"), ("case.toml", "the case's name"), ("a=b,c;d", "signs"), ("*", "a star"), ("\x1b[31m", "an escape")):
        yield Setting("paths", title, folder=name)
    yield Setting("paths", "a link", "ln -sfn . here && cd here/here && {}")
    yield Setting("paths", "a folder that is gone", "mkdir -p gone && cd gone && rmdir ../gone && {}")
    for name, title in (("loop/x", "a loop of links"), ("dangling", "a link to nowhere"), ("/dev/null", "/dev/null"), ("a_file", "a file"), ("a" * 256, "a name that is too long"),
                          ("b/" * 2100, "a path that is too long"), ("/proc/x", "/proc"), ("deep/er/and/deeper", "folders to make")):
        yield Setting("results", title, "ln -sfn loop loop; ln -sfn nowhere dangling; echo > a_file; {}", result=name)
    yield Setting("users", "nobody, in a folder of root", user=NOBODY)
    for disk in ("small", "full", "read-only"):
        yield Setting("disks", disk, disk=disk)


def all_settings():
    return [*streams(), *limits(), *variables(), *folders()]


COMMANDS = {
    "cell": ["run", "CASE", "--out", "RESULT", "--threads", "1"], "cell on two threads": ["run", "CASE", "--out", "RESULT", "--threads", "2"],
    "molding": ["run", "MOLD", "--out", "RESULT", "--threads", "1"], "check": ["check", "CASE"], "explain": ["explain", "--markdown"],
    "resume": ["resume", "DONE", "--until", "3 ms"], "report": ["report", "DONE"], "export": ["export", "DONE", "--format", "vtp", "--out", "exported"],
    "new": ["new", "cluster", "fresh"], "refused": ["check", "nowhere.toml"],
}
# Kinds that touch every command; the others are tried with a cell, and some with another command, drawn with the seed.
WIDE = {"streams", "disks"}


class Scene:
    """Where the combinations of one campaign work, and what a plain environment gives."""

    def __init__(self, folder):
        self.folder = folder
        folder.chmod(0o755)
        self.inputs = folder / "inputs"
        self.inputs.mkdir()
        (self.inputs / "fibers.csv").write_text(straight_fibers(fibers=10, rods=5), encoding="utf-8")
        (self.inputs / "case.toml").write_text(QUICK_CELL, encoding="utf-8")
        (self.inputs / "mold.toml").write_text(QUICK_MOLD, encoding="utf-8")
        self.plain, self.printed = {}, {}
        for command in ("cell", "molding", "check", "explain"):
            done = run(self.words(command, self.inputs, {"RESULT": str(folder / command)}), Setting("plain", ""), self.inputs)
            assert done.status == 0, done.errors
            self.plain[command], self.printed[command] = folder / command, done.output
        self.plain["cell on two threads"] = self.plain["cell"]

    def words(self, command, here, names):
        inputs = {"CASE": "case.toml", "MOLD": "mold.toml", "DONE": "done", "RESULT": "r"}
        if here != self.inputs:  # a case that names its file by the same path everywhere has the same result
            inputs.update({"CASE": str(self.inputs / "case.toml"), "MOLD": str(self.inputs / "mold.toml")})
        return [{**inputs, **names}.get(word, word) for word in COMMANDS[command]]

    def done_kib(self):
        return sum(path.stat().st_size for path in self.plain["cell"].iterdir()) // 1024 + 40


def prepared(setting):
    def prepare():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if setting.user:
            os.setgroups([])
            os.setgid(setting.user)
            os.setuid(setting.user)
        if setting.inside:
            setting.inside()
    return prepare


def run(words, setting, folder):
    """Runs the program, through a shell where the setting is a line of it."""
    variables = {**os.environ, "LC_ALL": "C.UTF-8", **setting.variables}
    encoded = {os.fsencode(key): value.encode("latin-1") if value == "\xff" else os.fsencode(value) for key, value in variables.items()}
    command = [PROGRAM, *words]
    if setting.shell != "{}":
        line = shlex.join(command)
        command = ["bash", "-c", setting.shell.replace("{}", shlex.quote(line) if setting.shell.startswith("script") else line)]
    with subprocess.Popen(command, cwd=folder, env=encoded, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          preexec_fn=prepared(setting), start_new_session=True) as process:
        try:
            output, errors = process.communicate(timeout=LONGEST)
            hung = False
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, errors = process.communicate()
            hung = True
    status = process.returncode
    if setting.shell != "{}" and 128 < status < 128 + 65:  # how a shell tells of a signal
        status = 128 - status
    return Trial(tuple(words), status, text(output), text(errors), hung)


@contextlib.contextmanager
def disk_at(folder, setting, scene):
    """Mounts a file system of its own for a hostile disk, with a result on it; only root may."""
    if not setting.disk:
        yield
        return
    folder.mkdir()
    size = scene.done_kib() + (60 if setting.disk == "small" else 16)
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "tmpfs", str(folder)], check=True)
    try:
        shutil.copytree(scene.plain["cell"], folder / "done")
        if setting.disk == "full":
            with contextlib.suppress(OSError), open(folder / "filler", "wb", buffering=0) as file:
                while file.write(b"x" * 1024):
                    pass
        if setting.disk == "read-only":
            subprocess.run(["mount", "-o", "remount,ro", str(folder)], check=True)
        yield
    finally:
        subprocess.run(["umount", str(folder)], check=True)


def lasting(printed):
    """Leaves out what `check` foretells, which follows the speed of the machine."""
    return [line for line in printed.split("\n") if not line.startswith("#")]


def fault_of(trial, setting, command, result, scene):
    """Says what must not be; None where all is well."""
    spoiled = {int(n) for n in re.findall(r"(\d)(?:>&-|>/dev/full|> >)", setting.shell)}
    if trial.hung:
        return "hangs"
    if any(words in trial.errors for words in OF_THE_SYSTEM):
        return None
    if trial.status == -signal.SIGPIPE and setting.breaks_pipe:
        return None
    if trial.crashed:
        return f"status {trial.status}: {trial.errors[-300:].strip()}"
    if command == "refused" and trial.status not in (2, 3):
        return f"status {trial.status} for a case that is not there"
    if trial.status != 0:
        return None if trial.errors.strip() or 2 in spoiled or setting.merges else f"status {trial.status} without a word"
    if command in ("check", "explain") and "1>/dev/full" in setting.shell:
        return "status 0 though nothing could be printed"
    if command in ("check", "explain") and setting.shell == "{}" and lasting(trial.output) != lasting(scene.printed[command]):
        return "prints something else"
    computes = command in ("cell", "cell on two threads", "molding") and not setting.other_digits
    return difference(scene.plain[command], result) if computes else None


def one_run(number, setting, command, scene):
    here = scene.folder / str(number)
    if setting.folder == "plain":
        here.mkdir()
    else:
        here = here / setting.folder
        here.mkdir(parents=True)
    here.chmod(0o777 if setting.user and setting.inside else 0o755)
    with disk_at(here / "disk", setting, scene):
        base = here / "disk" if setting.disk else here
        if not setting.disk and command in ("resume", "report", "export"):
            shutil.copytree(scene.plain["cell"], here / "done")
        names = {"RESULT": setting.result or str(base / "r"), "DONE": str(base / "done")}
        trial = run(scene.words(command, here, names), setting, here)
        found = fault_of(trial, setting, command, here / names["RESULT"], scene)
        if not found and trial.status == 0 and setting.kind == "paths" and command == "cell":
            again = run(["resume", names["RESULT"], "--until", "3 ms"], setting, here)
            found = f"cannot be resumed: {again.errors[-300:]}" if again.status != 0 else None
    shutil.rmtree(scene.folder / str(number), ignore_errors=True)
    return trial, found


def combinations(options):
    chance = random.Random(options.seed)
    others = [name for name in COMMANDS if name != "cell"]
    found = []
    for setting in all_settings():
        if setting.disk and os.geteuid() != 0:
            continue
        drawn = [chance.choice(others)] if chance.random() < 0.4 else []
        for command in COMMANDS if setting.kind in WIDE else ["cell", *drawn]:
            if options.only in f"{setting.kind}: {setting.name}: {command}":
                found.append((setting, command))
    order = {id(one): n for n, one in enumerate(found)}
    return sorted(chance.sample(found, max(1, round(options.share * len(found)))), key=lambda one: order[id(one)])


def end_of(trial):
    if any(words in trial.errors for words in OF_THE_SYSTEM):
        return "stopped by the system"
    return {0: "done", 2: "refused", 3: "failed in words"}.get(trial.status, "ended by the broken pipe" if trial.status == -signal.SIGPIPE else "other")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--share", type=float, default=1, help="share of the combinations")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="combinations whose words hold this text")
    parser.add_argument("--figure", type=Path)
    options = parser.parse_args()
    found, counts, faults = combinations(options), {}, 0
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.jobs) as pool:
        scene = Scene(Path(scratch))
        ends = pool.map(lambda numbered: one_run(numbered[0], *numbered[1], scene), enumerate(found))
        for (setting, command), (trial, fault) in zip(found, ends):
            row = counts.setdefault(setting.kind, {})
            row["faults" if fault else end_of(trial)] = row.get("faults" if fault else end_of(trial), 0) + 1
            if fault or options.only:
                print(f"{setting.kind}: {setting.name}: {command}: status {trial.status}: {fault or trial.errors.strip()[:200]}", flush=True)
            faults += bool(fault)
    totals = {}
    for row in counts.values():
        for end, count in row.items():
            totals[end] = totals.get(end, 0) + count
    figures = f"{len(found)} hostile environments: {faults} faults; " + ", ".join(f"{count} {end}" for end, count in sorted(totals.items(), key=lambda one: -one[1]))
    if options.figure:
        figure.bars(options.figure, figures, counts)
    print(f"environments, seed {options.seed}, {Path(PROGRAM).name}:\n{figures}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
