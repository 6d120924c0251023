"""The study cluster: packings that are what was asked, and that other runs start from."""
import json
import re
import signal
import subprocess
import time
from pathlib import Path

import h5py
import numpy
import pytest

from small_case import CASE, PROGRAM, column, run, summary

DOCS = Path(__file__).resolve().parents[2] / "docs" / "formats"

CLUSTER = """study = "cluster"
[fibers]
length = "0.5 mm"
diameter = "19 um"
youngs_modulus = "73 GPa"
rod_length = "0.1 mm"
volume_fraction = "8 %"
[cell]
size = "0.5 mm"
[cluster]
orientation = [0.6, 0.3, 0.1]
"""


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cluster")
    (folder / "case.toml").write_text(CLUSTER, encoding="utf-8")
    run("run", folder / "case.toml", "--out", folder / "result")
    return folder / "result"


def test_a_packing_is_what_was_asked(packed):
    values = summary(packed)
    assert values["study"] == "cluster" and values["stop_reason"] == "done"
    assert numpy.abs(numpy.array(values["A2"]) - numpy.diag([0.6, 0.3, 0.1])).max() <= 0.005
    assert values["max_overlap_diameters"] <= 0.01
    assert values["max_overlap_radii"] == pytest.approx(2 * values["max_overlap_diameters"])
    assert values["volume_fraction"] == pytest.approx(0.08, rel=0.02)
    with h5py.File(packed / "checkpoint.h5") as file:
        assert len(file["state/birth_id"]) == values["fibers"]


def test_docs_name_every_key_of_the_summary(packed):
    text = (DOCS / "summary.md").read_text(encoding="utf-8")
    keys = set(json.loads((packed / "summary.json").read_text()))
    assert keys <= set(re.findall(r"^\| `([^`]+)`", text, re.M))


def test_a_run_starts_from_a_packing(packed, tmp_path):
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    run("run", tmp_path / "case.toml", "--set", f"cluster.file={packed / 'checkpoint.h5'}", "--out", tmp_path / "r",
        "--steps", 3)
    assert column(tmp_path / "r", "fibers")[0] == summary(packed)["fibers"]
    assert column(tmp_path / "r", "a11")[0] == pytest.approx(summary(packed)["A2"][0][0], rel=1e-9)


def test_resuming_a_packing_that_is_complete_says_so(packed):
    before = (packed / "summary.json").read_bytes()
    assert "complete already" in run("resume", packed).stderr
    assert (packed / "summary.json").read_bytes() == before


def stop_while_packing(folder, *words):
    """Sends a signal to a program that packs, and returns what it said."""
    log = folder / "log.txt"
    before = log.read_text(encoding="utf-8").count("packing") if log.exists() else 0
    process = subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while not log.exists() or log.read_text(encoding="utf-8").count("packing") == before:
        time.sleep(0.01)
    time.sleep(0.3)
    process.send_signal(signal.SIGTERM)
    _, complaint = process.communicate(timeout=120)
    assert process.returncode == 4, complaint
    return complaint


def test_a_signal_stops_packing_and_resume_packs_again(tmp_path):
    text = CLUSTER.replace('"0.5 mm"', '"2.5 mm"', 1).replace('"8 %"', '"20 %"').replace('"0.5 mm"', '"1.1 mm"')
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    for words in (["run", tmp_path / "case.toml", "--out", tmp_path / "r"], ["resume", tmp_path / "r"]):
        assert "resuming will pack again" in stop_while_packing(tmp_path / "r", *words)
        assert not (tmp_path / "r" / "summary.json").exists()


def pack(tmp_path, text, name="r"):
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    run("run", tmp_path / "case.toml", "--out", tmp_path / name)
    return summary(tmp_path / name)


def test_lengths_follow_the_law_that_is_asked_for(tmp_path):
    law = '[fibers.length_distribution]\nlaw = "weibull"\nnumber_average = "0.5 mm"\nweight_average = "0.7 mm"\n[cell]'
    values = pack(tmp_path, CLUSTER.replace('length = "0.5 mm"\n', "").replace("[cell]", law))
    assert values["L_N_m"] == pytest.approx(0.5e-3, rel=0.005)
    assert values["L_W_m"] == pytest.approx(0.7e-3, rel=0.005)
    # Stratified lengths are nearer to the law than chance: a fraction of a fiber a bin, of which each holds five and more.
    assert 8 <= values["length_chi_square_bins"] <= values["fibers"] / 5
    assert values["length_chi_square"] < 0.3 * values["length_chi_square_bins"]
    assert sum(values["length_fibers"]) == values["fibers"]


def test_lengths_come_from_a_file_and_directions_too(tmp_path):
    (tmp_path / "lengths.txt").write_text("# measured, m\n0.3e-3\n0.5e-3\n", encoding="utf-8")
    (tmp_path / "directions.txt").write_text("1 0 0\n0 0 2\n", encoding="utf-8")
    text = CLUSTER.replace('length = "0.5 mm"', 'lengths = "lengths.txt"')
    values = pack(tmp_path, text.replace("orientation = [0.6, 0.3, 0.1]", 'directions = "directions.txt"'))
    assert values["L_N_m"] == pytest.approx(0.4e-3, rel=0.02)
    assert values["A2"][1][1] == pytest.approx(0, abs=0.005)


CARBON = """[[fibers.more_kinds]]
diameter = "7 um"
youngs_modulus = "230 GPa"
rod_length = "0.1 mm"
length = "0.3 mm"
volume_share = 0.5
"""


def lengths_of_kinds(folder):
    """Tells for each material its radius and the lengths of its fibers."""
    with h5py.File(folder / "checkpoint.h5") as file:
        first, rods, kinds, materials = (file["state"][name][()] for name in
                                         ("first_node", "rod_length", "material_id", "materials"))
    lengths = numpy.add.reduceat(rods, first[:-1])
    return [(material[0], lengths[kinds == kind]) for kind, material in enumerate(materials)]


def test_every_kind_has_lengths_of_its_own(tmp_path):
    glass = "[fibers.length_histogram]\nedges = [1e-4, 3e-4, 6e-4, 1e-3]\nheights = [2, 5, 3]\n"
    carbon = CARBON.replace('length = "0.3 mm"\n', "") + (
        '[fibers.more_kinds.length_distribution]\nnumber_average = "0.2 mm"\nweight_average = "0.3 mm"\n')
    values = pack(tmp_path, CLUSTER.replace('length = "0.5 mm"\n', "") + glass + carbon)
    (thick, glass_lengths), (thin, lengths) = lengths_of_kinds(tmp_path / "r")
    # A few tens of glass fibers can be off by half a fiber but for the 0.49 % by which their lengths may give way.
    assert thin ** 2 * lengths.sum() / (thick ** 2 * glass_lengths.sum()) == pytest.approx(0.5, rel=0.01)
    assert values["volume_fraction"] == pytest.approx(0.08, rel=0.007)
    bins = numpy.histogram(glass_lengths, [1e-4, 3e-4, 6e-4, 1e-3])[0]
    assert numpy.abs(bins - len(glass_lengths) * numpy.array([0.2, 0.5, 0.3])).max() <= 1
    assert lengths.mean() == pytest.approx(0.2e-3, rel=0.005)
    assert (lengths ** 2).sum() / lengths.sum() == pytest.approx(0.3e-3, rel=0.005)
    assert values["kind_L_N_m"] == pytest.approx([glass_lengths.mean(), lengths.mean()], rel=1e-9)
    assert values["kind_L_N_asked_m"][1] == 0.2e-3 and values["kind_volume_share_asked"] == pytest.approx([2 / 3, 1 / 3])
    assert values["kind_volume_share"] == pytest.approx([2 / 3, 1 / 3], rel=0.005)
    assert sum(values["kind_fibers"]) == values["fibers"] == sum(values["length_fibers"])
    named = set(re.findall(r"^\| `([^`]+)`", (DOCS / "summary.md").read_text(encoding="utf-8"), re.M))
    assert set(json.loads((tmp_path / "r" / "summary.json").read_text())) <= named


@pytest.mark.parametrize("change, complaint", [
    (('diameter = "7 um"', 'diameter = "7 GPa"'), "13:12: fibers.more_kinds.1.diameter = \"7 GPa\": 'GPa' does not have"),
    (('diameter = "7 um"\n', ""),
     "12:1: fibers.more_kinds.1.diameter: not given: add diameter = \"19 um\" under [[fibers.more_kinds]]"),
    (("rod_length", "rod_lenght"), "did you mean fibers.more_kinds.1.rod_length?"),
    (('length = "0.3 mm"\n', ""), "12:1: fibers.more_kinds.1.length: not given; fibers need a length"),
    (('"0.3 mm"', '"5 um"'), "16:10: fibers.more_kinds.1.length = \"5 um\": fibers are shorter than they are thick, "
                             "fibers.more_kinds.1.diameter = \"7 um\" (line 13)"),
    (('"0.3 mm"', '"0.3 mm"\nlengths = ["1 mm"]'),
     "17:11: fibers.more_kinds.1.lengths = [\"1 mm\"]: contradicts fibers.more_kinds.1.length"),
    (("[[fibers.more_kinds]]", "[fibers.more_kinds]"),
     "there may be several of this table: write [[fibers.more_kinds]], with two brackets"),
    (("[[fibers.more_kinds]]", "[[fibers.more_kind]]"),
     "unknown table in study cluster: did you mean [[fibers.more_kinds]]?"),
    (('"7 um"', '"200 um"'),
     "cell.size = \"0.5 mm\": the cell is hardly wider than a fiber, fibers.more_kinds.1.diameter"),
])
def test_faults_of_a_further_kind_are_told_at_their_own_keys(tmp_path, change, complaint):
    (tmp_path / "case.toml").write_text(CLUSTER + CARBON.replace(*change), encoding="utf-8")
    assert complaint in run("check", tmp_path / "case.toml", expect=2).stderr


def test_kinds_are_no_key(tmp_path):
    (tmp_path / "case.toml").write_text(CLUSTER, encoding="utf-8")
    one = run("check", tmp_path / "case.toml", "--set", "fibers.more_kinds=1", expect=2)
    assert "write [[fibers.more_kinds]] and its keys below, once for each" in one.stderr


def test_two_kinds_of_fibers_start_a_run(tmp_path):
    values = pack(tmp_path, CLUSTER + CARBON)
    shear = CASE + CARBON
    (tmp_path / "shear.toml").write_text(shear, encoding="utf-8")
    run("run", tmp_path / "shear.toml", "--set", "cluster.file=r/checkpoint.h5", "--out", tmp_path / "s", "--steps", 2)
    assert summary(tmp_path / "s")["volume_fraction"] == pytest.approx(values["volume_fraction"], rel=1e-9)


def test_a_cluster_of_overlapping_fibers_relaxes(tmp_path):
    rows = ["fiber,x_m,y_m,z_m"]
    for fiber, z in enumerate((0.2e-3, 0.218e-3)):  # crossing, 1 um too near
        rows += [f"{fiber},{(0.1 + 0.1 * k) * 1e-3 if fiber == 0 else 0.2e-3},"
                 f"{(0.1 + 0.1 * k) * 1e-3 if fiber else 0.2e-3},{z}" for k in range(3)]
    (tmp_path / "fibers.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    text = ('study = "cluster"\n[fibers]\ndiameter = "19 um"\nyoungs_modulus = "73 GPa"\n[cell]\nsize = "0.5 mm"\n'
            '[cluster]\nsource = "file"\nfile = "fibers.csv"\n')
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    assert "nothing would be done" in run("run", tmp_path / "case.toml", "--out", tmp_path / "n", expect=2).stderr
    values = pack(tmp_path, text + '[relaxation]\nduration = "50 ms"\n')
    assert values["relaxation_end"] == "met" and values["relaxation_s"] > 0
    assert values["max_overlap_diameters"] < 0.01
    assert values["relaxation_orientation_drift"] < 0.01


def test_relaxing_straightens_until_no_hinge_is_sharper_than_wanted(tmp_path):
    turn = numpy.linspace(0, 1, 6)
    rows = ["fiber,x_m,y_m,z_m"] + [f"0,{0.1e-3 + 0.3e-3 * numpy.sin(a)},{0.2e-3 + 0.3e-3 * numpy.cos(a)},2e-4" for a in turn]
    (tmp_path / "fibers.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    text = ('study = "cluster"\n[fibers]\ndiameter = "10 um"\nyoungs_modulus = "10 GPa"\n[cell]\nsize = "1 mm"\n'
            '[cluster]\nsource = "file"\nfile = "fibers.csv"\n'
            '[relaxation]\nduration = "1 s"\nrate = 0\nminimum_radius = "0.6 mm"\norientation_bound = 0.9\n')
    values = pack(tmp_path, text)
    assert values["relaxation_end"] == "met" and values["min_radius_m"] >= 0.6e-3
    short = pack(tmp_path, text.replace('"1 s"', '"1 us"'), "short")
    assert short["relaxation_end"] == "time_over" and short["min_radius_m"] < 0.6e-3


def test_relaxing_ends_before_orientation_leaves_its_bound(tmp_path):
    text = CLUSTER.replace("[cluster]", '[relaxation]\nduration = "2 s"\nrate = "10 1/s"\nminimum_radius = "900 m"\n'
                           "orientation_bound = 0.02\n[cluster]").replace('"8 %"', '"25 %"')
    values = pack(tmp_path, text)  # fibers of this length must bend there
    assert values["relaxation_end"] == "orientation_bound"
    assert 0.005 < values["relaxation_orientation_drift"] <= 0.02


@pytest.mark.parametrize("change, complaint", [
    (('length = "0.5 mm"', 'length = "10 um"'), "fibers are shorter than they are thick, fibers.diameter = \"19 um\" (line 4)"),
    (('length = "0.5 mm"', 'lengths = ["0.5 mm", "15 um"]'), "1 of 2 fibers are shorter than they are thick"),
    (('length = "0.5 mm"', 'lengths = "nowhere.txt"'), "nowhere.txt: cannot be read (No such file or directory): check the path"),
    (('length = "0.5 mm"', 'lengths = "empty.txt"'), "empty.txt:1:1: holds no numbers: give one number a line"),
    (('length = "0.5 mm"', 'lengths = "nan.txt"'), "nan.txt:2:1: 'nan' is not a finite number"),
    (('length = "0.5 mm"', 'lengths = "."'), "is a folder, not a file"),
    (('length = "0.5 mm"', "length_histogram = {edges = [1e-3, 2e-3, 15e-4], heights = [1, 2]}"),
     "fibers.length_histogram.edges = [1e-3, 2e-3, 15e-4]: the edges of a length histogram do not rise from 0 or above"),
    (('length = "0.5 mm"', "length_histogram = {edges = [1e-3, 2e-3], heights = [0]}"),
     "fibers.length_histogram.heights = [0]: all heights of a length histogram are 0"),
    (("[cell]", "[fibers.length_histogram]\nedges = [1e-3, 2e-3, 15e-4]\nheights = [1, 2]\n[cell]"),
     "contradicts fibers.length = \"0.5 mm\""),
    (("[0.6, 0.3, 0.1]", '"isotropic"\ndirections = [[1, 0, 0], [0, 0, 0]]'), "12:26: cluster.directions = [0, 0, 0]: the direction"),
    (("[cluster]", '[cluster]\nstart = "bundles"\nbundle_fibers = 1000'),
     "cluster.bundle_fibers = 1000: 1 bundles cannot have the orientation that is asked for"),
    (('volume_fraction = "8 %"', "count = 2"), "fibers.count = 2: 2 fibers cannot have this orientation"),
    (('"8 %"', '"75 %"'), "with cluster.orientation = [0.6, 0.3, 0.1] (line 11) they fill at most"),
    (("[0.6, 0.3, 0.1]", "[0.8, 0.3, -0.1]"), "the nearest possible tensor is [0.75, 0.25, 0]"),
    (("[0.6, 0.3, 0.1]", "[0.6, 0.3, 0.2]"), "the nearest possible tensor is [0.5667, 0.2667, 0.1667]"),
    (('size = "0.5 mm"', 'size = "15 um"'), "give edges of at least 4 diameters"),
])
def test_what_cannot_be_is_refused_with_what_could(tmp_path, change, complaint):
    (tmp_path / "case.toml").write_text(CLUSTER.replace(*change), encoding="utf-8")
    (tmp_path / "empty.txt").touch()
    (tmp_path / "nan.txt").write_text("0.5e-3\nnan\n", encoding="utf-8")
    assert complaint in run("check", tmp_path / "case.toml", expect=2).stderr
