#!/usr/bin/env python3
"""Follows the guides docs/develop/adding_*.md word for word, in a scratch copy of the sources.

    follow_guides.py SOURCE BUILD NINJA

Every C++ block of a guide is a file, whose name stands above it, or what is added to one after a line that the guide
quotes. All guides go into one copy. What they touch is compiled as BUILD (a Ninja build) compiles it, the tests of the
guides are run, then their commands. A law that a command chooses (--set KEY=NAME) must be known to `explain`, to the
template of a new case, and to the report.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

BLOCK = re.compile(r"^(?P<indent> *)```(?P<language>\w+)\n(?P<text>.*?)^ *```$", re.M | re.S)
PLACE = re.compile(r"^ *`(?P<file>[^`]+)`(?: after `(?P<anchor>[^`]+)`)?\n$")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)
CHOSEN = re.compile(r"--set ([\w.]+)=([a-z_0-9]+)(?= |$)")
LAW = re.compile(r'(?:text = \{|name = )\s*"(\w+)"')
# Kernels are compiled for one instruction set, the one that every processor has.
INSTRUCTION_SET = "baseline"
OTHER_KERNEL = re.compile(r"_avx(2|512)\.cpp$")


def fail(message):
    sys.exit(f"follow_guides: {message}")


def run(words, forgiven=None, **options):
    """Runs a command and returns what it printed; stops when it fails, but for a complaint that is forgiven."""
    environment = {**os.environ, "FIBERFATE_ISA": INSTRUCTION_SET, "OMP_WAIT_POLICY": "passive"}
    done = subprocess.run(words, capture_output=True, text=True, check=False, env=environment, **options)
    if done.returncode != 0 and not (forgiven and forgiven in done.stderr):
        fail(f"status {done.returncode} of {shlex.join(map(str, words))}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def blocks(guide):
    """Yields language, file, anchor and text of a guide's blocks; file and anchor are empty where none is named."""
    page = guide.read_text(encoding="utf-8")
    for match in BLOCK.finditer(page):
        indent = match["indent"]
        text = "".join(line.removeprefix(indent) for line in match["text"].splitlines(keepends=True))
        place = PLACE.match(page[page.rfind("\n", 0, match.start() - 1) + 1:match.start()])
        yield match["language"], (place["file"] if place else ""), ((place["anchor"] or "") if place else ""), text


def apply(tree, guide):
    """Writes a guide's files; returns which they are, its commands, and the names of its laws."""
    touched, commands, laws = [], [], []
    for language, name, anchor, text in blocks(guide):
        if language == "sh":
            commands += text.splitlines()
        if language != "cpp":
            continue
        laws += LAW.findall(text)
        if not name:
            fail(f"{guide.name}: no file is named above the block\n{text}")
        path = tree / name
        if anchor:
            before = path.read_text(encoding="utf-8")
            if before.count(anchor + "\n") != 1:
                fail(f"{guide.name}: {name} does not have the line {anchor!r} once")
            text = before.replace(anchor + "\n", anchor + "\n" + text)
        elif path.exists():
            fail(f"{guide.name}: {name} exists already")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        touched.append(name)
    return touched, commands, laws


class Build:
    """How an existing build compiles and links, applied to another copy of its sources."""

    def __init__(self, source, build, tree, ninja):
        self.source, self.build, self.tree, self.ninja = source, build, tree, ninja
        entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
        self.commands = {pathlib.Path(one["file"]): shlex.split(one["command"]) for one in entries}

    def moved(self, path):
        return self.tree / path.relative_to(self.source) if path.is_relative_to(self.source) and not \
            path.is_relative_to(self.build) else path

    def includes(self, path, known):
        """Returns the files of the tree that a file includes, directly or not."""
        if path not in known:
            known[path] = set()
            for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
                for root in (self.tree / "src", self.tree / "tests"):
                    if (root / name).exists():
                        known[path] |= {root / name} | self.includes(root / name, known)
        return known[path]

    def outdated(self, touched):
        """Returns the sources that touched files concern, tests only where they are touched themselves."""
        known, found = {}, {path for path in touched if path.suffix == ".cpp"}
        for file in self.commands:
            path = self.moved(file)
            is_ours = path.is_relative_to(self.tree / "src") or path.is_relative_to(self.build / "src")
            if is_ours and not OTHER_KERNEL.search(path.name) and path.exists() and self.includes(path, known) & touched:
                found.add(path)
        return sorted(found)

    def command_for(self, path):
        """Returns the command that compiles a source, or for a new one its nearest neighbour's, and that source."""
        for file, words in self.commands.items():
            if self.moved(file) == path:
                return words, file
        def nearness(file):
            return len(os.path.commonpath([self.moved(file), path])), file.suffix == path.suffix
        file = max((one for one in self.commands if one.is_relative_to(self.source / path.relative_to(self.tree).parts[0])),
                   key=nearness)
        return self.commands[file], file

    def compile(self, path):
        """Compiles a source and returns its object."""
        words, file = self.command_for(path)
        name = path.relative_to(self.tree if path.is_relative_to(self.tree) else self.build)
        target = self.tree / "objects" / f"{name}.o"
        target.parent.mkdir(parents=True, exist_ok=True)
        words = [self.in_tree(word) for word in words]
        words[words.index("-o") + 1] = str(target)
        words[words.index("-c") + 1] = str(path)
        run(words, cwd=self.build)
        return target

    def in_tree(self, word):
        for folder in ("src", "tests"):
            word = word.replace(f"-I{self.source}/{folder}", f"-I{self.tree}/{folder}")
        return word.replace(f'"{self.source}"', f'"{self.tree}"')

    def link(self, program, objects, replace_sources):
        """Links a program of the build with other objects, which go before the libraries that have older ones."""
        line = run([self.ninja, "-t", "commands", f"bin/{program}"], cwd=self.build).splitlines()[-1]
        words = shlex.split(line.split("&&")[1])
        place = words.index("-o")
        if replace_sources:
            words = [word for word in words if not word.endswith(".cpp.o")]
            place = words.index("-o")
        words[place + 1] = str(self.tree / program)
        words[place:place] = [str(one) for one in objects]
        run(words, cwd=self.build)
        return self.tree / program


def copy(source, build, tree):
    shutil.rmtree(tree, ignore_errors=True)
    for folder in ("src", "tests/unit", "tests/reference", "tests/physics", "docs/develop", "cases"):
        shutil.copytree(source / folder, tree / folder, ignore=shutil.ignore_patterns("__pycache__"))


def check_law(program, tree, command, key, name):
    """Checks that `explain`, the template and the report of a run know the law that the run chose."""
    words = shlex.split(command)
    case = next(word for word in words if word.endswith(".toml"))
    study = re.search(r'^study = "(\w+)"', (tree / case).read_text(encoding="utf-8"), re.M)[1]
    run([program, "new", study, f"template_{name}"], cwd=tree)
    places = {f"explain {key}": run([program, "explain", key], cwd=tree),
              f"the template of {study}": (tree / f"template_{name}" / "case.toml").read_text(encoding="utf-8")}
    result = tree / words[words.index("--out") + 1]
    run([program, "report", result], forgiven="without the HTML report", cwd=tree)
    if (result / "report.html").exists():
        places["the report"] = (result / "report.html").read_text(encoding="utf-8")
    for place, text in places.items():
        if f'"{name}"' not in text:
            fail(f"{place} does not know {key} = \"{name}\"")


def main():
    source, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    tree = build / "guides"
    copy(source, build, tree)
    touched, commands, laws = set(), [], []
    for guide in sorted((tree / "docs/develop").glob("adding_*.md")):
        files, lines, names = apply(tree, guide)
        touched |= {tree / name for name in files}
        commands += lines
        laws += names
        print(f"{guide.name}: {len(files)} blocks, {len(lines)} commands, {len(names)} laws")
    maker = Build(source, build, tree, sys.argv[3])
    outdated = maker.outdated(touched)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = dict(zip(outdated, pool.map(maker.compile, outdated)))
    print(f"{len(outdated)} sources compiled")
    tests = [one for path, one in objects.items() if path.is_relative_to(tree / "tests")]
    library = [one for one in objects.values() if one not in tests]
    below_app = [one for path, one in objects.items() if one in library and not path.is_relative_to(tree / "src/app")]
    print(run([maker.link("unit_studies", tests + below_app, True)]).splitlines()[-1])
    program = maker.link("fiberfate", library, False)
    for command in commands:
        words = shlex.split(command)
        if words[0] != "fiberfate":
            fail(f"what is {command!r}?")
        run([program, *words[1:]], cwd=tree)
        for key, name in CHOSEN.findall(command):
            if name in laws:
                check_law(program, tree, command, key, name)
                laws.remove(name)
                print(f'{key} = "{name}" runs; explain, the template and the report know it')
    if laws:
        fail(f"no command chooses {', '.join(laws)}")


if __name__ == "__main__":
    main()
