#!/usr/bin/env python3
"""Checks what the layout promises: direction of includes, file and function lengths, opening comments, names.

Usage: check_structure.py ROOT. Prints every violation as file:line: what is wrong; exits with 1 when there is any.
"""
import pathlib
import re
import sys

# What each module may include, besides itself (docs/develop/architecture.md).
ALLOWED = {
    "base": set(),
    "io": {"base"},
    "microstructure": {"base"},
    "fibers": {"microstructure", "base"},
    "packing": {"fibers", "microstructure", "base"},
    "dynamics": {"fibers", "microstructure", "base"},
    "continuum": {"microstructure", "base"},
    "molding": {"continuum", "microstructure", "base"},
    "calibration": {"base"},
    "keys": {"io", "continuum", "microstructure", "base"},
    "results": {"io", "fibers", "base"},
}
ALLOWED["studies"] = set(ALLOWED)
ALLOWED["app"] = set(ALLOWED)

# What a room of studies/ may include, besides itself and what lies in studies/ itself: fibers come from sample, and
# a calibration may fill molds, and a rheometer runs sheared cells. Nothing else of another study.
ROOMS = {"cluster": {"sample"}, "shear_cell": {"sample"}, "calibration": {"molding"},
         "rheometer": {"sample", "shear_cell"}}

LONGEST_FILE = 400
LONGEST_FUNCTION = 60
FORBIDDEN_NAMES = re.compile(r"^(utils?|common|helpers?|misc|core|manager|info)$")
INCLUDE = re.compile(r'^\s*#include\s+["<]([^">]+)[">]')
DEPENDS = re.compile(r"DEPENDS\s+([a-z\s]+?)(?:LIBRARIES|PRIVATE_LIBRARIES|\))")


def sources(root):
    for folder in ("src", "tests"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".cpp", ".hpp"):
                yield path


def check_includes(path, module, lines):
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        target = match.group(1).split("/")[0]
        if target in ALLOWED and target != module and target not in ALLOWED[module]:
            yield number, f"{module} must not include {match.group(1)}"
        if match.group(1) == "mpi.h" and module != "base" and not path.stem.endswith("exchange"):
            yield number, "MPI belongs to base and to the exchange of dynamics"


def check_rooms(parts, lines):
    """Checks what a file of studies/ includes of studies/; parts are those of its path below src/."""
    room = parts[1] if len(parts) > 2 else ""
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        target = match.group(1).split("/") if match else []
        if len(target) < 3 or target[0] != "studies" or target[1] in {room} | ROOMS.get(room, set()):
            continue
        yield number, f"{'/'.join(parts[:2]) if room else 'studies/ itself'} must not include {match.group(1)}"


def cycles(includes):
    """Yields every circle of files that include each other."""
    done, way = set(), []

    def visit(file):
        if file in way:
            yield way[way.index(file):] + [file]
            return
        if file in done:
            return
        way.append(file)
        for target in sorted(includes.get(file, ())):
            yield from visit(target)
        done.add(way.pop())

    for file in sorted(includes):
        yield from visit(file)


def check_one_way(root):
    """Checks that headers inside a module include each other one way."""
    includes = {}
    for path in sorted((root / "src").rglob("*.hpp")):
        file = path.relative_to(root / "src").as_posix()
        matches = [INCLUDE.match(line) for line in path.read_text().splitlines()]
        includes[file] = {match.group(1) for match in matches if match and (root / "src" / match.group(1)).exists()}
    for circle in cycles(includes):
        yield root / "src" / circle[0], 1, "includes run in a circle: " + " -> ".join(circle)


def check_opening(path, lines):
    if not lines or not lines[0].startswith("// "):
        yield 1, "a file opens with a // sentence that says what it is"
        return
    comment = []
    for line in lines:
        if not line.startswith("//"):
            break
        comment.append(line[2:].strip())
    paragraph = " ".join(comment).split("  ")[0]
    if "." not in paragraph:
        yield 1, "the opening sentence does not end"
    # Kernels are meant to be included once for every instruction set.
    if path.suffix == ".hpp" and not path.name.endswith(".kernel.hpp") and "#pragma once" not in lines:
        yield 1, "a header has #pragma once"


def without_text(line):
    """Takes comments, strings and characters out of a line, so that its braces are code."""
    line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])*\'', "", line)
    return line.split("//")[0]


def functions(lines):
    """Yields (first line, last line) of every block that is neither a scope nor inside a function."""
    blocks = []  # (line, is_scope)
    head = ""
    for number, line in enumerate(lines, 1):
        code = without_text(line)
        if code.lstrip().startswith("#") or '(R"' in code:
            continue
        for character in code:
            if character == "{":
                scope = re.search(r"\b(namespace|struct|class|enum|union|extern)\b", head) and "(" not in head
                inside = blocks and not blocks[-1][1]
                blocks.append((number, bool(scope) and not inside))
                head = ""
            elif character == "}" and blocks:
                begin, is_scope = blocks.pop()
                if not is_scope and all(scope for _, scope in blocks):
                    yield begin, number
                head = ""
            elif character == ";":
                head = ""
            else:
                head += character


def check_lengths(lines):
    if len(lines) > LONGEST_FILE:
        yield len(lines), f"longer than {LONGEST_FILE} lines"
    for begin, end in functions(lines):
        if end - begin + 1 > LONGEST_FUNCTION:
            yield begin, f"a function of {end - begin + 1} lines, longer than {LONGEST_FUNCTION}"


def check_names(root):
    for folder in ("src", "tests", "python", "report/src"):
        base = root / folder
        for path in sorted(base.rglob("*")) if base.exists() else []:
            if "node_modules" not in path.parts and FORBIDDEN_NAMES.match(path.stem.lower()):
                yield path, 0, "a name that says nothing: find the noun that is missing"


def check_targets(root):
    for module, allowed in ALLOWED.items():
        path = root / "src" / module / "CMakeLists.txt"
        match = DEPENDS.search(path.read_text()) if path.exists() else None
        for target in match.group(1).split() if match else []:
            if target not in allowed:
                yield path, 1, f"{module} must not depend on {target}"


def violations(root):
    for path in sources(root):
        lines = path.read_text().splitlines()
        found = list(check_opening(path, lines)) + list(check_lengths(lines))
        if path.is_relative_to(root / "src"):
            parts = path.relative_to(root / "src").parts
            found += check_includes(path, parts[0], lines)
            found += check_rooms(parts, lines) if parts[0] == "studies" else []
        yield from ((path, number, what) for number, what in found)
    yield from check_names(root)
    yield from check_targets(root)
    yield from check_one_way(root)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found = list(violations(root))
    for path, number, what in found:
        print(f"{path.relative_to(root)}:{number}: {what}")
    count = len(list(sources(root)))
    print(f"{count} source files, {len(found)} violations")
    return 1 if found or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
