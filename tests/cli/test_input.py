"""Bad input: every key misspelt, of the wrong type or unit, out of range; contradictions; broken files.

Every message names file, line and remedy, the exit status is 2, and nothing is written.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = os.environ.get("FIBERFATE", "fiberfate")
CASES = Path(__file__).resolve().parents[2] / "cases"

CASE = """study = "shear_cell"

[cell]
size = "0.5 mm"

[fibers]
count = 10
length = "0.25 mm"
diameter = "19 um"
youngs_modulus = "73 GPa"
rod_length = "0.1 mm"

[flow]
rate = "10 1/s"
viscosity = "200 Pa s"

[run]
duration = "1 s"
"""


def call(*words, folder, expect):
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=120, check=False, cwd=folder)
    assert done.returncode == expect, f"{words}: status {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done


def refuse(folder, text, *words, command="run"):
    """Runs a case that must be refused, and returns the lines of the message."""
    (folder / "case.toml").write_text(text, encoding="utf-8")
    before = sorted(folder.rglob("*"))
    done = call(command, "case.toml", *words, folder=folder, expect=2)
    assert done.stdout == ""
    assert sorted(folder.rglob("*")) == before, "something was written"
    return done.stderr.splitlines()


def read_keys():
    """Reads the table of keys: study, table, key, unit, default, range, in the order of the documentation."""
    done = subprocess.run([PROGRAM, "explain", "--markdown"], capture_output=True, text=True, timeout=60, check=True)
    keys, study, table = [], None, None
    for line in done.stdout.splitlines():
        if line.startswith("## "):
            study = line[3:]
        elif line.startswith("### ["):
            table = line[4:]
        elif line.startswith("| `"):
            key, unit, default, bounds = re.split(r"(?<!\\)\|", line)[1:5]
            keys.append((study, table, key.strip(" `"), unit.strip(), default.strip(), bounds.strip()))
    return keys


KEYS = read_keys()
STUDIES = sorted({study for study, *_ in KEYS})


def named(table, separator=""):
    """Names a table by its heading, "[fibers]" or "[[fibers.more_kinds]]"; messages number those that may be repeated."""
    name = table.strip("[]")
    for repeated in {other.strip("[]") for _, other, *_ in KEYS if other.startswith("[[")} if separator else ():
        name = re.sub(rf"^{repeated}(?=\.|$)", repeated + separator, name)
    return name


def case_of_all(study, write):
    """Makes a case of every key of a study that `write` gives a value; returns it with the line of each key."""
    lines, places, table = [f'study = "{study}"'], {}, None
    for of_study, of_table, key, *facts in KEYS:
        value = write(key, *facts) if of_study == study else None
        if value is None:
            continue
        if of_table != table:
            table = of_table
            lines.append(table)
        lines.append(value)
        places[f"{named(table, '.1')}.{key}"] = len(lines)
    return "\n".join(lines) + "\n", places


def complaints_at(messages, place, key):
    return [line for line in messages if line.startswith(f"case.toml:{place}:") and f" {key}" in line]


def expect_one_each(messages, places, *fragments):
    for key, place in places.items():
        found = complaints_at(messages, place, key)
        assert len(found) == 1, f"{key}: {found}"
        assert all(fragment in found[0] for fragment in fragments), found[0]


@pytest.mark.parametrize("study", STUDIES)
def test_every_misspelt_key_is_found_and_corrected(tmp_path, study):
    text, places = case_of_all(study, lambda key, *_: f"{key}x = 1")
    messages = refuse(tmp_path, text)
    expect_one_each(messages, {key + "x": place for key, place in places.items()}, f"unknown key in study {study}: did you mean ")
    suggested = [line for line in messages for key in places if line.endswith(f"did you mean {key}?")]
    assert len(suggested) >= 0.9 * len(places)


@pytest.mark.parametrize("study", STUDIES)
def test_every_key_of_the_wrong_type_is_found(tmp_path, study):
    text, places = case_of_all(study, lambda key, *_: f"{key} = true")
    expect_one_each(refuse(tmp_path, text), places, "= true: ")


@pytest.mark.parametrize("study", STUDIES)
def test_every_quantity_of_the_wrong_unit_is_found(tmp_path, study):
    text, places = case_of_all(
        study, lambda key, unit, default, bounds: f'{key} = "1 mol"' if unit and not default.startswith("`[") else None)
    messages = refuse(tmp_path, text)
    for key, place in places.items():
        found = complaints_at(messages, place, key)
        assert len(found) == 1 and ("does not have the dimension" in found[0] or "is not a" in found[0]), (key, found)
    assert sum("does not have the dimension" in line for line in messages) >= len(places) // 2


@pytest.mark.parametrize("study", STUDIES)
@pytest.mark.parametrize("value", ["nan", "inf", "-inf", "1e999"])
def test_no_quantity_takes_what_is_not_finite(tmp_path, study, value):
    text, places = case_of_all(study, lambda key, unit, *_: f"{key} = {value}" if unit else None)
    messages = refuse(tmp_path, text)
    for key, place in places.items():
        assert len(complaints_at(messages, place, key)) == 1, key


@pytest.mark.parametrize("study", STUDIES)
def test_every_key_out_of_range_is_found(tmp_path, study):
    text, places = case_of_all(study, lambda key, unit, default, bounds: f"{key} = {-10**15}" if bounds else None)
    messages = refuse(tmp_path, text)
    for key, place in places.items():
        found = complaints_at(messages, place, key)
        assert len(found) == 1, (key, found)
        assert "out of range: give " in found[0] or "is not a list" in found[0], found[0]
    assert sum("out of range" in line for line in messages) >= len(places) // 2


@pytest.mark.parametrize("study", STUDIES)
def test_every_key_explains_itself(tmp_path, study):
    for of_study, table, key, *_ in KEYS:
        if of_study == study:
            name = f"{named(table)}.{key}"
            done = call("explain", name, folder=tmp_path, expect=0)
            assert done.stdout.startswith(f"{name} ("), done.stdout


def edit(old, new, text=CASE):
    assert old in text
    return text.replace(old, new)


EXACT = {
    "unquoted": (
        edit('length = "0.25 mm"', "length = 0.25 mm"),
        ['case.toml:8:10: length = 0.25 mm: the value is not in quotes: write length = "0.25 mm"']),
    "decimal comma": (
        edit('rate = "10 1/s"', "rate = 1,5"),
        ["case.toml:14:8: rate = 1,5: a number has a decimal comma: write rate = 1.5"]),
    "twice": (
        edit("count = 10", "count = 10\ncount = 11"),
        ["case.toml:8:9: count is given twice, first in line 7: keep one of the two"]),
    "bare number in another unit": (
        edit('"19 um"', "19"),
        ["case.toml:9:12: fibers.diameter = 19: out of range: give 100 nm to 1 mm (a number without unit is in m)"]),
    "longer than is sensible": (
        edit('"0.25 mm"', '"2.5 m"'),
        ['case.toml:8:10: fibers.length = "2.5 m": out of range: give 1 um to 100 mm']),
    "no fibers": (
        edit("count = 10", "count = 0"),
        ["case.toml:7:9: fibers.count = 0: out of range: give 1 to 10000000"]),
    "half a fiber": (
        edit("count = 10", "count = 10.5"),
        ["case.toml:7:9: fibers.count = 10.5: a number is not a whole number: give digits without quotes, point or unit"]),
    "wrong unit": (
        edit('"200 Pa s"', '"200 Pa"'),
        ["case.toml:15:13: flow.viscosity = \"200 Pa\": 'Pa' does not have the dimension of 'Pa s': give a number with a "
         'unit in quotes, such as "1 Pa s"']),
    "unknown unit": (
        edit('"200 Pa s"', '"200 poises3x"'),
        ["case.toml:15:13: flow.viscosity = \"200 poises3x\": 'poises3x' is not a unit: give a number with a unit in quotes, "
         'such as "1 Pa s"']),
    "count, fraction and cell": (
        edit("count = 10", 'count = 10\nvolume_fraction = "5 %"'),
        ['case.toml:8:19: fibers.volume_fraction = "5 %": contradicts fibers.count = 10 (line 7) and cell.size = "0.5 mm" '
         "(line 4): remove all but two of number, fraction and cell; the third follows from them"]),
    "two fractions": (
        edit("count = 10", 'volume_fraction = "5 %"\nweight_fraction = "10 %"\ndensity = 2550') + "[matrix]\ndensity = 905\n",
        ['case.toml:8:19: fibers.weight_fraction = "10 %": contradicts fibers.volume_fraction = "5 %" (line 7) and cell.size '
         '= "0.5 mm" (line 4): remove all but two of number, fraction and cell; the third follows from them']),
    "weight without densities": (
        edit("count = 10", 'weight_fraction = "10 %"'),
        ['case.toml:6:1: fibers.density: not given; fibers.weight_fraction needs it: add density = "2550 kg/m3" under [fibers]',
         'case.toml:1:1: matrix.density: not given; fibers.weight_fraction needs it: add density = "905 kg/m3" under [matrix]',
         "2 errors; nothing was written"]),
    "neither count nor fraction": (
        edit("count = 10\n", ""),
        ["case.toml:6:1: fibers.count: not given, and no fraction either: add count, volume_fraction or weight_fraction under "
         "[fibers]"]),
    "rod shorter than thick": (
        edit('"0.1 mm"', '"10 um"'),
        ['case.toml:11:14: fibers.rod_length = "10 um": a rod is shorter than it is thick, fibers.diameter = "19 um" (line 9): '
         "give at least one diameter; about five is usual"]),
    "choice": (
        CASE + '[breakage]\nlaw = "fixd"\n',
        ['case.toml:20:7: breakage.law = "fixd": not one of the choices: did you mean "fixed"? The choices are "none", '
         '"fixed", "probability" or "strength"']),
    "key of another table": (
        edit("count = 10", 'count = 10\norientation = "planar"'),
        ['case.toml:8:1: fibers.orientation = "planar": unknown key in study shear_cell: did you mean cluster.orientation?']),
    "table for a key": (
        CASE + "[fibers.density]\nvalue = 3\n",
        ["case.toml:19:1: [fibers.density]: this is a key, not a table: write density = value under [fibers]"]),
    "tensor": (
        CASE + "[cluster]\norientation = [0.6, 0.3, 0.2]\n",
        ["case.toml:20:15: cluster.orientation = [0.6, 0.3, 0.2]: the trace of the orientation tensor is 1.1, not 1: "
         "the nearest possible tensor is [0.5667, 0.2667, 0.1667]"]),
    "single fiber": (
        CASE + '[cluster]\nsource = "fiber"\ndirection = [0.0, 0.0, 0.0]\n',
        ['case.toml:7:9: fibers.count = 10: contradicts cluster.source = "fiber" (line 20): remove it, or give 1',
         "case.toml:21:13: cluster.direction = [0.0, 0.0, 0.0]: has no length: give components that are not all zero",
         "2 errors; nothing was written"]),
    "flow table": (
        edit('rate = "10 1/s"\nviscosity = "200 Pa s"', 'kind = "table"\ntable = [["1 s", 5, 200], ["1 s", "9 m", 200]]'),
        ["case.toml:15:35: flow.table = \"9 m\": rate: 'm' does not have the dimension of '1/s': give a number with a unit in "
         'quotes, such as "1 1/s"',
        ]),
    "no study": (
        edit('study = "shear_cell"\n', ""),
        ["case.toml:1:1: study: not given, so nothing else can be checked: add study = "]),
    "misspelt study": (
        edit('"shear_cell"', '"shear-cell"'),
        ['case.toml:1:9: study = "shear-cell": there is no such study, so nothing else can be checked: did you mean '
         '"shear_cell"?']),
}


@pytest.mark.parametrize("name", [name for name in EXACT if name not in ("flow table", "no study")])
def test_messages_word_for_word(tmp_path, name):
    text, expected = EXACT[name]
    assert refuse(tmp_path, text) == expected


def test_the_message_of_a_table_points_at_the_cell(tmp_path):
    text, expected = EXACT["flow table"]
    assert refuse(tmp_path, text) == expected[:1]


def test_the_message_of_a_wrong_row_points_at_the_row(tmp_path):
    text = edit('rate = "10 1/s"\nviscosity = "200 Pa s"', 'kind = "table"\ntable = [["2 s", 5, 200],\n  ["1 s", 5, 200]]')
    assert refuse(tmp_path, text) == [
        'case.toml:16:3: flow.table = ["1 s", 5, 200]: the end time of row 2 is not later than that of row 1: sort the rows by end time']


def test_a_case_without_a_study_is_told_the_studies(tmp_path):
    text, expected = EXACT["no study"]
    messages = refuse(tmp_path, text)
    assert len(messages) == 1 and messages[0].startswith(expected[0]) and '"shear_cell"' in messages[0]


def test_overrides_are_checked_like_the_file(tmp_path):
    assert refuse(tmp_path, CASE, "--set", "fibers.diameter=19 s") == [
        "command line: fibers.diameter = \"19 s\": 's' does not have the dimension of 'm': give a number with a unit in quotes, "
        'such as "1 um"']
    assert refuse(tmp_path, CASE, "--set", "fibers.diametre=19 um") == [
        'command line: fibers.diametre = "19 um": unknown key in study shear_cell: did you mean fibers.diameter?']
    assert refuse(tmp_path, CASE, "--set", "fibers.diameter") == [
        "command line: --set fibers.diameter: this is not an assignment: write --set key=value, for example --set "
        'fibers.length="2 mm"']
    assert refuse(tmp_path, CASE, "--until", "3 m") == [
        "command line: --until = 3 m: 'm' does not have the dimension of 's': give a quantity such as \"1.5 s\""]


VARIANTS = """[dense]
"fibers.count" = 7
"flow.rate" = "3 1/s"
[wrong]
"fibers.diametre" = "19 um"
"""


def test_a_variant_replaces_values_and_overrides_come_on_top(tmp_path):
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    (tmp_path / "variants.toml").write_text(VARIANTS, encoding="utf-8")
    done = call("check", "case.toml", "--set", "flow.rate=4 1/s", "--variant", "dense", folder=tmp_path, expect=0)
    assert "\ncount = 7\n" in done.stdout and "\nrate = 4.0  # 1/s\n" in done.stdout


def test_variants_are_checked_like_the_case(tmp_path):
    no_file = refuse(tmp_path, CASE, "--variant", "dense")
    assert no_file == ["case.toml: there is no variant dense: variants are the tables of a file variants.toml beside the case; "
                       "here is none"]
    (tmp_path / "variants.toml").write_text(VARIANTS, encoding="utf-8")
    assert refuse(tmp_path, CASE, "--variant", "dens") == [
        "./variants.toml: there is no variant dens: did you mean dense?"]
    assert refuse(tmp_path, CASE, "--variant", "other_one") == [
        "./variants.toml: there is no variant other_one: the variants are dense, wrong"]
    assert refuse(tmp_path, CASE, "--variant", "wrong") == [
        './variants.toml:5:1: fibers.diametre = "19 um": unknown key in study shear_cell: did you mean fibers.diameter?']


def test_a_later_override_wins(tmp_path):
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    done = call("check", "case.toml", "--set", "fibers.count=3", "--set", "fibers.count=4", folder=tmp_path, expect=0)
    assert "\ncount = 4\n" in done.stdout


def test_missing_files_and_folders(tmp_path):
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    done = call("run", "csae.toml", folder=tmp_path, expect=2)
    assert done.stderr == "csae.toml: cannot be read (No such file or directory): did you mean 'case.toml'?\n"
    done = call("run", ".", folder=tmp_path, expect=2)
    assert done.stderr == ".: is a folder, not a case file: give 'case.toml'\n"
    messages = refuse(tmp_path, CASE + '[cluster]\nsource = "file"\nfile = "gone.h5"\n')
    assert messages[-1] == (f'case.toml:21:8: cluster.file = "gone.h5": there is no such file: check the path; it means '
                            f"'{tmp_path}/gone.h5'")


def test_files_cut_off_anywhere_are_refused_or_whole(tmp_path):
    """A case cut off at any byte is either refused with status 2 or, past the last required key, still a case."""
    done = call("new", "shear_cell", "template", folder=tmp_path, expect=0)
    assert "template/case.toml" in done.stdout
    whole = (tmp_path / "template" / "case.toml").read_bytes()
    last_required = whole.index(b"viscosity =")
    for end in range(0, last_required, 397):
        (tmp_path / "case.toml").write_bytes(whole[:end])
        done = call("check", "case.toml", folder=tmp_path, expect=2)
        assert done.stderr.startswith("case.toml"), done.stderr


def test_bytes_that_are_no_text_are_refused(tmp_path):
    (tmp_path / "case.toml").write_bytes(bytes(range(256)) * 4)
    done = call("check", "case.toml", folder=tmp_path, expect=2)
    assert done.stderr.startswith("case.toml:1:1: is not a text file")


@pytest.mark.parametrize("line", ["k = " + "[" * 6000, "k = " + "{a=" * 10000 + "1" + "}" * 10000, "a" + ".a" * 20000 + " = 1", "[a" + ".a" * 20000 + "]",
                                  "k = " + "x" * 300000, "k = [" + "1.5, " * 56000, "k = {" + "a = 1, " * 40000 + "}", "x" * 100000],
                         ids=["brackets", "tables", "dotted key", "dotted table", "word", "open list", "inline table", "bare word"])
def test_hostile_lines_are_refused_with_their_place(tmp_path, line):
    (tmp_path / "case.toml").write_text(CASE + line + "\n", encoding="utf-8")
    done = subprocess.run([PROGRAM, "check", "case.toml"], capture_output=True, text=True, timeout=60, check=False, cwd=tmp_path)
    assert done.returncode == 2, done.stderr[:500]
    assert done.stderr.startswith("case.toml:19:") and len(done.stderr) < 2000, done.stderr[:500]


def test_a_long_list_is_read(tmp_path):
    text = 'study = "orientation"\n[flow]\nkind = "table"\ntable = [' + ", ".join(f"[{k}, 1.5]" for k in range(30000)) + "]\n"
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    done = subprocess.run([PROGRAM, "check", "case.toml"], capture_output=True, text=True, timeout=60, check=False, cwd=tmp_path)
    assert done.returncode in (0, 2) and "program itself" not in done.stderr


@pytest.mark.parametrize("end", ["\0", "\r", "\x1b[31m", "\x7f"])
def test_what_is_no_text_is_refused_with_its_place(tmp_path, end):
    (tmp_path / "case.toml").write_bytes((CASE + "x" + end + "y = 1\n").encode())
    assert call("check", "case.toml", folder=tmp_path, expect=2).stderr.startswith("case.toml:19:2: ")


def test_what_is_no_file_is_refused_at_once(tmp_path):
    os.mkfifo(tmp_path / "pipe.toml")
    os.symlink("loop.toml", tmp_path / "loop.toml")
    for path, words in (("/dev/zero", "is a pipe or a device"), ("pipe.toml", "is a pipe or a device"), ("loop.toml", "symbolic links"),
                        ("x" * 300, "name too long"), (b"\xff\xfe.toml", "cannot be read")):
        done = subprocess.run([PROGRAM.encode(), b"check", os.fsencode(path)], capture_output=True, timeout=60, check=False, cwd=tmp_path)
        assert done.returncode == 2 and words.encode().lower() in done.stderr.lower(), done.stderr
    for name in ("pipe.toml", "loop.toml", "x" * 300):
        messages = refuse(tmp_path, CASE + f'[cluster]\nsource = "file"\nfile = "{name}"\n')
        assert messages[-1].startswith("case.toml:21:8: cluster.file"), messages


@pytest.mark.parametrize("old, new, words", [
    ('rate = "10 1/s"', 'rate = "20 s"', "'s' is the reciprocal of '1/s', and is not converted into it"),
    ('duration = "1 s"', 'duration = "50 Hz"', "'Hz' is the reciprocal of 's'"),
    ('diameter = "19 um"', 'diameter = "50000 1/m"', "'1/m' is the reciprocal of 'm'"),
    ('rate = "10 1/s"', 'rate = "30 rpm"', "'rpm' counts turns or angles"),
    ('length = "0.25 mm"', 'length = "0,25 mm"', "decimal comma"),
    ('length = "0.25 mm"', 'length = "1 000 um"', "two numbers"),
    ("count = 10", "volume_fraction = 20", "volume_fraction = 20: out of range; it means 2000 %"),
    ("count = 10", "weight_fraction = 20", "weight_fraction = 20: out of range; it means 2000 %"),
    ("[run]", '[breakage]\ncheck_interval = "1e-300 s"\n[run]', "makes 1e+300 checks in run.duration")])
def test_numbers_are_read_as_they_are_meant_or_not_at_all(tmp_path, old, new, words):
    assert any(words in line for line in refuse(tmp_path, edit(old, new)))


def test_typographic_signs_are_read(tmp_path):
    text = edit('rate = "10 1/s"', 'rate = "10\u00a0s⁻¹"').replace('"19 um"', '"19\u202fµm"')
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    shown = call("check", "case.toml", folder=tmp_path, expect=0).stdout
    assert "rate = 10.0  # 1/s\n" in shown and "diameter = 1.9e-05  # m\n" in shown


def test_a_topic_that_is_none_is_not_guessed(tmp_path):
    done = call("explain", "packing", folder=tmp_path, expect=2)
    assert "no study, table or key 'packing'" in done.stderr and "spacing" not in done.stderr
    assert "did you mean 'friction'?" in call("explain", "fricton", folder=tmp_path, expect=2).stderr


def test_unknown_commands_and_options(tmp_path):
    done = call("chekc", "case.toml", folder=tmp_path, expect=2)
    assert done.stderr == "fiberfate: unknown command 'chekc': did you mean 'check'?\n"
    done = call("run", "case.toml", "--thread", "2", folder=tmp_path, expect=2)
    assert done.stderr == "fiberfate: unknown option '--thread': did you mean '--threads'?\n"
    done = call("explain", "fibers.lenght", folder=tmp_path, expect=2)
    assert done.stderr == "there is no study, table or key 'fibers.lenght': did you mean 'fibers.length'?\n"
    done = call("new", "couete_43wt", folder=tmp_path, expect=2)
    assert "neither a study nor a case of the gallery" in done.stderr
    assert call(folder=tmp_path, expect=2).stderr.startswith("fiberfate predicts")


def test_help_and_version(tmp_path):
    assert re.fullmatch(r"fiberfate \d+\.\d+\.\d+\n", call("--version", folder=tmp_path, expect=0).stdout)
    commands = ["new", "check", "run", "resume", "report", "export", "import", "explain", "cite"]
    overview = call("--help", folder=tmp_path, expect=0).stdout
    for command in commands:
        assert f"\n  {command} " in overview
        assert "Example" in call(command, "--help", folder=tmp_path, expect=0).stdout


def test_new_never_overwrites_unless_told(tmp_path):
    call("new", "shear_cell", "mine", folder=tmp_path, expect=0)
    case = tmp_path / "mine" / "case.toml"
    case.write_text("mine", encoding="utf-8")
    done = call("new", "shear_cell", "mine", folder=tmp_path, expect=2)
    assert done.stderr == "mine/case.toml: exists already: give another folder, or --overwrite\n"
    assert case.read_text(encoding="utf-8") == "mine"
    call("new", "shear_cell", "mine", "--overwrite", folder=tmp_path, expect=0)
    assert case.read_text(encoding="utf-8") != "mine"


def test_new_copies_the_gallery_from_inside_the_program(tmp_path):
    call("new", "couette_30wt", folder=tmp_path, expect=0)
    done = call("check", "05_couette_30wt/case.toml", folder=tmp_path, expect=0)
    assert re.search(r"# +fibers +628\n", done.stdout)
    assert re.search(r"# +volume fraction +13\.19 %\n", done.stdout)
    assert (tmp_path / "05_couette_30wt" / "README.md").exists()


def test_tables_that_are_repeated_without_end_are_refused_at_once(tmp_path):
    (tmp_path / "case.toml").write_text(CASE + '[[fibers.more_kinds]]\nlength = "1 mm"\n' * 5000, encoding="utf-8")
    done = call("check", "case.toml", folder=tmp_path, expect=2)
    assert done.stderr == "[[fibers.more_kinds]] stands 5000 times: give it at most 500 times\n"


def test_the_time_to_stop_is_not_empty(tmp_path):
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    assert "--until: ''" in call("run", "case.toml", "--until", "", folder=tmp_path, expect=2).stderr


def test_new_copies_a_case_whole(tmp_path):
    call("new", "04_couette_43wt", "mine", folder=tmp_path, expect=0)
    case, copy = CASES / "04_couette_43wt", tmp_path / "mine"
    names = {file.name for file in case.iterdir()}
    assert {file.name for file in copy.iterdir()} == names | {"study_runs.py", "fiber_frames.py"}
    for name in names - {"README.md"}:
        assert (copy / name).read_bytes() == (case / name).read_bytes(), name
    assert "](../" not in (copy / "README.md").read_text(encoding="utf-8")
    assert os.access(copy / "study.py", os.X_OK)
    subprocess.run([sys.executable, "-c", "import fiber_frames, study_runs"], cwd=copy, timeout=60, check=True)


def gallery():
    """Lists the cases of the gallery, from the help of the command new."""
    done = subprocess.run([PROGRAM, "new", "--help"], capture_output=True, text=True, timeout=60, check=True)
    return re.search(r"Gallery: (.*)", done.stdout).group(1).split(", ")


def without_estimates(text):
    """Leaves out the lines that a trial on the machine foretells, and what the process takes at the moment."""
    return re.sub(r"(?m)^#   (memory|wall time) .*$", "", text)


@pytest.mark.parametrize("case", ["shear_cell", "cluster"] + gallery())
def test_the_resolved_case_reads_back_to_itself(tmp_path, case):
    call("new", case, folder=tmp_path, expect=0)
    first = call("check", f"{case}/case.toml", folder=tmp_path, expect=0)
    (tmp_path / case / "resolved.toml").write_text(first.stdout, encoding="utf-8")
    again = call("check", f"{case}/resolved.toml", folder=tmp_path, expect=0)
    assert without_estimates(again.stdout) == without_estimates(first.stdout)


def test_check_warns_of_keys_that_nothing_reads(tmp_path):
    (tmp_path / "case.toml").write_text(CASE + "[breakage]\nexponent = 3\n", encoding="utf-8")
    done = call("check", "case.toml", folder=tmp_path, expect=0)
    assert done.stderr == ('warning: case.toml:20:12: breakage.exponent = 3: has no effect: it is read by breakage.law = "probability" or '
                           '"strength" only\n')
