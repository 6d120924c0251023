"""Import of the published program's input decks."""
import re
import shutil
import tomllib
from pathlib import Path

import h5py
import pytest

from small_case import column, run, series, summary

DECKS = Path(__file__).parent / "legacy"
DOCS = Path(__file__).resolve().parents[2] / "docs" / "formats"


def resolved(folder):
    """Runs an imported case for one step and returns all of its keys in SI."""
    run("run", folder / "case.toml", "--out", folder / "result", "--steps", 1)
    return tomllib.loads((folder / "result" / "case.resolved.toml").read_text(encoding="utf-8"))


def test_every_key_of_a_shear_deck_is_mapped(tmp_path):
    done = run("import", DECKS / "shear", tmp_path / "case")
    case = resolved(tmp_path / "case")
    assert case["study"] == "shear_cell"
    assert case["fibers"]["youngs_modulus"] == 73e9
    assert case["fibers"]["diameter"] == pytest.approx(19e-6)
    assert case["cell"]["size"] == [5e-4, 4e-4, 3e-4]
    assert case["boundary"]["y"] == "periodic"
    assert case["flow"]["kind"] == "constant"
    assert case["flow"]["rate"] == 16.65
    assert case["flow"]["viscosity"] == 200
    assert case["contact"]["force_constant"] == 500
    assert case["contact"]["friction"] == 0.25
    assert case["contact"]["wall_friction"] == 0.25
    assert case["contact"]["cutoff"] == 2
    assert case["breakage"]["law"] == "fixed"
    assert case["breakage"]["critical_radius"] == 250e-6
    assert case["breakage"]["check_interval"] == pytest.approx(5e-4)
    assert case["step"]["initial"] == 1e-6
    assert case["run"]["duration"] == pytest.approx(0.02)
    assert case["output"]["interval"] == pytest.approx(1e-3)
    assert case["drag"]["law"] == "beads"
    for key in ["recover_simulation", "nbr_neighbors", "epsilon_dot", "ratio_displ_max", "printVelocities",
                "coo_velocity", "coo_omega"]:
        assert re.search(rf"^{key} .*not used: \S", done.stdout, re.M), key
    assert re.search(r"^is_stationary +1 fibers +not used", done.stdout, re.M)


def test_fibers_arrive_node_by_node(tmp_path):
    run("import", DECKS / "shear", tmp_path / "case")
    rows = series(tmp_path / "case", "fibers.csv")
    assert rows[0] == ["fiber", "x_m", "y_m", "z_m"]
    assert [row[0] for row in rows[1:]] == ["0"] * 3 + ["1"] * 2 + ["2"] * 4
    assert [float(number) for number in rows[-1][1:]] == [4.0e-4, 2.5e-4, 0.8e-4]
    resolved(tmp_path / "case")
    assert summary(tmp_path / "case" / "result")["rods"] == 2 + 1 + 3
    assert column(tmp_path / "case" / "result", "L_N_m")[0] == pytest.approx((2e-4 + 1e-4 + 1.54843e-4) / 3, rel=1e-4)


def test_a_deck_with_walls_and_a_table(tmp_path):
    done = run("import", DECKS / "walls_table", tmp_path / "case")
    case = resolved(tmp_path / "case")
    assert case["flow"]["kind"] == "table"
    assert case["flow"]["table"] == [[0.005, 10.0, 300.0], [0.010, 15.0, 150.0]]
    assert case["boundary"]["y"] == "walls"
    assert case["contact"]["wall_friction"] == 0
    assert case["breakage"]["law"] == "none"
    assert case["drag"]["law"] == "ellipsoid"
    assert re.search(r"^gamma_dot +99 +not used: flow case 1848", done.stdout, re.M)
    with h5py.File(tmp_path / "case" / "result" / "checkpoint.h5") as file:
        assert list(file["state/boundary"]) == [0, 1, 0]


def test_fibers_between_walls_are_where_that_program_has_them(tmp_path):
    """Its walls stand half a box from the mean of the rods' middles, wherever the positions are."""
    deck = tmp_path / "deck"
    shutil.copytree(DECKS / "walls_table", deck)
    done = run("import", deck, tmp_path / "case")
    nodes = [[float(number) for number in row] for row in series(tmp_path / "case", "fibers.csv")[1:]]
    middles = [0.5 * (a[2] + b[2]) for a, b in zip(nodes, nodes[1:]) if a[0] == b[0]]
    assert sum(middles) / len(middles) == pytest.approx(2e-4, abs=1e-12)
    assert re.search(r"^Initial_Positions.txt .*moved by \S+ m in y", done.stdout, re.M)
    assert [node[1] for node in nodes[:3]] == [1e-4, 2e-4, 3e-4]


def test_a_deck_that_continues_a_run_says_what_is_imported(tmp_path):
    deck = broken(tmp_path, "Fibers.in", "recover_simulation = .false.", "recover_simulation = .true.")
    done = run("import", deck, tmp_path / "case")
    assert re.search(r"^recover_simulation .*own last frame", done.stdout, re.M)


def test_the_notes_cover_exactly_the_documented_keys(tmp_path):
    run("import", DECKS / "shear", tmp_path / "case")
    notes = (tmp_path / "case" / "import.txt").read_text(encoding="utf-8").splitlines()[1:]
    noted = {line.split()[0] for line in notes} - {"Initial_Positions.txt"}
    documented = set(re.findall(r"^\| `(\w+)`", (DOCS / "legacy.md").read_text(encoding="utf-8"), re.M))
    assert noted == documented, noted ^ documented


def test_a_case_is_not_overwritten_unless_told_to(tmp_path):
    run("import", DECKS / "shear", tmp_path / "case")
    failed = run("import", DECKS / "shear", tmp_path / "case", expect=2)
    assert "exists already" in failed.stderr
    run("import", DECKS / "shear", tmp_path / "case", "--overwrite")


def broken(tmp_path, file, old, new):
    """Copies the shear deck with one change."""
    deck = tmp_path / "deck"
    shutil.copytree(DECKS / "shear", deck)
    text = (deck / file).read_text(encoding="utf-8")
    assert old in text
    (deck / file).write_text(text.replace(old, new), encoding="utf-8")
    return deck


@pytest.mark.parametrize("old, new, message", [
    ("fric_coeff   = 0.25d0", "frik_coeff = 0.25d0", r"Fibers\.in:4: frik_coeff = 0.25d0: .*did you mean fric_coeff\?"),
    ("E_Young      = 7.3D10", "E_Young = stiff", r"Fibers\.in:6: E_Young = stiff: a number should stand here"),
    ("is_fric_wall = T", "is_fric_wall = maybe", r"Fibers\.in:5: is_fric_wall = maybe: a truth value should stand here"),
    ("r_fiber      = 9.5d-6", "", r"Fibers\.in: r_fiber: Fibers\.in does not give it"),
    ("r_fiber      = 9.5d-6", "r_fiber = 0", r"Fibers\.in:9: r_fiber = 0: it is not positive"),
    ("flow_case    = 1\n", "flow_case = 7\n", r"Fibers\.in:15: flow_case = 7: only 1 .* and 1848"),
    ("TensorOrBeads = 2", "TensorOrBeads = 3", r"Fibers\.in:26: TensorOrBeads = 3: only 1 .* and 2"),
    ("box_size(3)  = 3.0d-4,", "", r"box_size = .*only 2 of 3 components"),
    ("coo_omega    = 0 0 0\n/", "coo_omega = 0 0 0", r"Fibers\.in:\d+: the namelist &input has no end"),
    ("&input", "&output", r"Fibers\.in:1: there is no namelist &input"),
])
def test_what_is_wrong_in_the_namelist_is_named(tmp_path, old, new, message):
    deck = broken(tmp_path, "Fibers.in", old, new)
    failed = run("import", deck, tmp_path / "case", expect=2)
    assert re.search(message, failed.stderr), failed.stderr
    assert not (tmp_path / "case").exists()


@pytest.mark.parametrize("old, new, message", [
    ("F  3.0d-4  1.0d-4  1.5d-4", "F  3.0d-4  1.0d-4", r"Initial_Positions\.txt:7: .* should stand here"),
    ("F  2.0d-4", "F  two", r"Initial_Positions\.txt:4: 'two' is not a number; x of node 2 of fiber 1"),
    ("T  4.0d-4  2.5d-4  0.8d-4\n", "", r"Initial_Positions\.txt:\d+: the file ends where .*node 4 of fiber 3"),
    ("3\n3\n", "2\n3\n", r"Initial_Positions\.txt:9: '4' stands after the last row"),
    ("3\n3\n", "-3\n3\n", r"Initial_Positions\.txt:1: '-3' is not a count; the number of fibers"),
])
def test_what_is_wrong_in_the_positions_is_named(tmp_path, old, new, message):
    deck = broken(tmp_path, "Initial_Positions.txt", old, new)
    failed = run("import", deck, tmp_path / "case", expect=2)
    assert re.search(message, failed.stderr), failed.stderr
    assert not (tmp_path / "case").exists()


@pytest.mark.parametrize("name", ["Fibers.in", "Initial_Positions.txt"])
def test_a_missing_file_is_named(tmp_path, name):
    deck = tmp_path / "deck"
    shutil.copytree(DECKS / "shear", deck)
    (deck / name).unlink()
    failed = run("import", deck, tmp_path / "case", expect=2)
    assert name in failed.stderr and "No such file" in failed.stderr


def test_a_table_that_is_missing_or_truncated_is_named(tmp_path):
    deck = tmp_path / "deck"
    shutil.copytree(DECKS / "walls_table", deck)
    (deck / "DynamicParameters.in").write_text("2\n0.005 10 300\n", encoding="utf-8")
    failed = run("import", deck, tmp_path / "case", expect=2)
    assert re.search(r"DynamicParameters\.in:\d: the file ends where the end time of row 2", failed.stderr)
    (deck / "DynamicParameters.in").unlink()
    failed = run("import", deck, tmp_path / "case", expect=2)
    assert "DynamicParameters.in" in failed.stderr


@pytest.mark.parametrize("line, boundary", [("isPeriodicY = .false.", "walls"), ("isPeriodicY = .true.", "periodic"), ("", "periodic")])
def test_the_boundary_in_y_is_that_of_the_deck(tmp_path, line, boundary):
    shutil.copytree(DECKS / "shear", tmp_path / "deck")
    deck = tmp_path / "deck" / "Fibers.in"
    text = re.sub(r"distanceFactor *= *2.0", "distanceFactor = 8.0", deck.read_text(encoding="utf-8"))
    deck.write_text(text.replace("\n/", f"\n{line}\n/", 1), encoding="utf-8")
    done = run("import", tmp_path / "deck", tmp_path / "case")
    case = resolved(tmp_path / "case")
    assert case["boundary"]["y"] == boundary
    assert ("the deck has no isPeriodicY" in done.stdout) == (line == "")
    # The radius of that program's list is not the reach of its force.
    assert case["contact"]["cutoff"] == 2
    assert re.search(r"^distanceFactor +8.0 +not used: \S", done.stdout, re.M)
