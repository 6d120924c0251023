"""Exports, and the VTKHDF layout against the specification, as ParaView's reader walks it."""
import re
import xml.etree.ElementTree as xml
from pathlib import Path

import h5py
import numpy
import pytest

from small_case import column, run, series, write_case

CASES = Path(__file__).resolve().parents[2] / "cases"


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = tmp_path_factory.mktemp("export")
    run("run", write_case(folder), "--out", folder / "result")
    return folder / "result"


def read_step(file, step):
    """Reads one step as vtkHDFReader does (VTK 9.3): offsets first, then parts, then arrays."""
    root = file["VTKHDF"]
    steps = root["Steps"]
    part = steps["PartOffsets"][step]
    point = steps["PointOffsets"][step]
    count = root["NumberOfPoints"][part]
    points = root["Points"][point:point + count]
    lines = None
    for column_number, name in enumerate(["Vertices", "Lines", "Polygons", "Strips"]):
        group = root[name]
        cells = group["NumberOfCells"][part]
        cell = steps["CellOffsets"][step][column_number] + part
        offsets = group["Offsets"][cell:cell + cells + 1]
        assert len(offsets) == cells + 1 and offsets[0] == 0
        identifiers = group["NumberOfConnectivityIds"][part]
        first = steps["ConnectivityIdOffsets"][step][column_number]
        connectivity = group["Connectivity"][first:first + identifiers]
        assert len(connectivity) == identifiers == offsets[-1]
        if name == "Lines":
            lines = [connectivity[a:b] for a, b in zip(offsets[:-1], offsets[1:])]
        else:
            assert cells == 0
    data = {}
    for kind, entries in (("PointData", count), ("CellData", len(lines))):
        for name, array in root[kind].items():
            begin = steps[kind + "Offsets"][name][step]
            data[name] = array[begin:begin + entries]
            assert len(data[name]) == entries
    return points, lines, data


def test_vtkhdf_follows_the_specification(result):
    with h5py.File(result / "result.vtkhdf") as file:
        root = file["VTKHDF"]
        assert list(root.attrs["Version"]) == [2, 0]
        assert root.attrs["Type"] == b"PolyData"
        assert root.attrs.get_id("Type").get_type().get_class() == h5py.h5t.STRING
        assert not root.attrs.get_id("Type").get_type().is_variable_str()
        count = root["Steps"].attrs["NSteps"]
        assert numpy.ndim(count) == 0 and count == len(root["Steps/Values"]) == 6
        for step in range(count):
            points, lines, data = read_step(file, step)
            assert points.shape[1] == 3
            assert sorted(numpy.concatenate(lines)) == list(range(len(points)))
            for line, length in zip(lines, data["length"]):
                nodes = points[line]
                assert numpy.linalg.norm(numpy.diff(nodes, axis=0), axis=1).sum() == pytest.approx(length, rel=1e-5)
            ends = [line[end] for line in lines for end in (0, -1)]
            assert (data["curvature"][ends] == 0).all()
            assert data["relative_velocity"].shape == (len(points), 3)
        assert root["FieldData/lattice"].shape == (count, 9)
        for name, unit in {"Points": "m", "PointData/curvature": "1/m", "PointData/relative_velocity": "m/s",
                           "CellData/length": "m", "CellData/birth_id": "1", "Steps/Values": "s"}.items():
            assert root[name].attrs["unit"].decode() == unit


def test_lattice_shears_with_the_flow(result):
    with h5py.File(result / "result.vtkhdf") as file:
        times = file["VTKHDF/Steps/Values"][:]
        tilt = file["VTKHDF/FieldData/lattice"][:, 1] / 0.5e-3
        assert numpy.abs(tilt).max() <= 0.5 + 1e-9
        strain = 200 * times
        assert numpy.allclose((tilt - strain + 0.5) % 1, 0.5, atol=1e-9)


def read_vtp(path, piece="PolyData/Piece"):
    """Reads the piece and the arrays of an appended-raw VTK file."""
    raw = path.read_bytes()
    mark = raw.index(b'<AppendedData encoding="raw">')
    blob = raw[raw.index(b"_", mark) + 1:]
    tree = xml.fromstring(raw[:mark].decode() + "</VTKFile>")
    kinds = {"Float64": "<f8", "Float32": "<f4", "Int64": "<i8", "Int32": "<i4", "UInt32": "<u4", "UInt8": "u1"}
    arrays = {}
    for array in tree.iter("DataArray"):
        if array.get("format") != "appended":
            continue
        begin = int(array.get("offset"))
        size = int(numpy.frombuffer(blob[begin:begin + 8], "<u8")[0])
        values = numpy.frombuffer(blob[begin + 8:begin + 8 + size], kinds[array.get("type")])
        arrays[array.get("Name")] = values.reshape(-1, int(array.get("NumberOfComponents")))
    return tree.find(piece), arrays


def test_vtp_series_holds_the_same_fibers(result):
    run("export", result, "--format", "vtp")
    out = result / "export_vtp"
    collection = xml.parse(out / "fibers.pvd").getroot()
    members = collection.findall("Collection/DataSet")
    with h5py.File(result / "result.vtkhdf") as file:
        assert [float(member.get("timestep")) for member in members] == list(file["VTKHDF/Steps/Values"])
        for step, member in enumerate(members):
            points, lines, data = read_step(file, step)
            piece, arrays = read_vtp(out / member.get("file"))
            assert int(piece.get("NumberOfPoints")) == len(points)
            assert int(piece.get("NumberOfLines")) == len(lines)
            assert (arrays["Points"] == points).all()
            assert (arrays["offsets"][:, 0] == numpy.cumsum([len(line) for line in lines])).all()
            assert (arrays["connectivity"][:, 0] == numpy.arange(len(points))).all()
            assert (arrays["birth_id"][:, 0] == data["birth_id"]).all()


def test_layers_and_properties_are_exported_with_the_frames(tmp_path):
    run("run", CASES / "30_plaque" / "case.toml", "--set", "part.mesh_size=8 mm", "--progress", "none", "--out", tmp_path / "r")
    run("export", tmp_path / "r", "--format", "vtp", "--out", tmp_path / "vtp")
    assert {"part.pvd", "layers.vtu"} <= {file.name for file in (tmp_path / "vtp").iterdir()}
    piece, arrays = read_vtp(tmp_path / "vtp" / "layers.vtu", "UnstructuredGrid/Piece")
    with h5py.File(tmp_path / "r" / "layers.vtkhdf") as file:
        grid = file["VTKHDF"]
        assert int(piece.get("NumberOfPoints")) == grid["NumberOfPoints"][0]
        assert int(piece.get("NumberOfCells")) == grid["NumberOfCells"][0]
        assert (arrays["Points"] == grid["Points"][:]).all()
        assert (arrays["connectivity"][:, 0] == grid["Connectivity"][:]).all()
        assert (arrays["offsets"][:, 0] == grid["Offsets"][1:]).all()
        assert (arrays["types"][:, 0] == grid["Types"][:]).all()
        assert set(grid["PointData"]) == set(arrays) - {"Points", "connectivity", "offsets", "types"}
        for name, values in grid["PointData"].items():
            assert numpy.array_equal(arrays[name], numpy.reshape(values, arrays[name].shape), equal_nan=True), name


@pytest.mark.parametrize("name, kind", [("frames.csv", "csv"), ("fibers.pvd", "vtp")])
def test_exports_replace_only_what_was_exported(result, tmp_path, name, kind):
    out = tmp_path / "out"
    out.mkdir()
    (out / name).write_text("mine", encoding="utf-8")
    refused = run("export", result, "--format", kind, "--out", out, expect=2)
    assert f"{out / name} is there already, and no record in its folder says that fiberfate made it" in refused.stderr
    assert [(file.name, file.read_text(encoding="utf-8")) for file in out.iterdir()] == [(name, "mine")]
    (out / name).unlink()
    run("export", result, "--format", kind, "--out", out)
    first = (out / name).read_bytes()
    run("export", result, "--format", kind, "--out", out)
    assert (out / name).read_bytes() == first


def test_csv_holds_every_node_and_can_be_read_again(result, tmp_path):
    run("export", result, "--format", "csv", "--out", tmp_path / "csv")
    assert column(tmp_path / "csv", "time_s", "frames.csv")[-1] == pytest.approx(0.02)
    with h5py.File(result / "result.vtkhdf") as file:
        points, lines, _ = read_step(file, 5)
    assert column(tmp_path / "csv", "x_m", "fibers_00005.csv") == list(points[:, 0])
    assert len(set(column(tmp_path / "csv", "fiber", "fibers_00005.csv"))) == len(lines)
    case = write_case(tmp_path)
    (tmp_path / "csv" / "fibers_00005.csv").rename(tmp_path / "fibers.csv")
    run("run", case, "--out", tmp_path / "again", "--steps", 1)
    assert column(tmp_path / "again", "L_N_m")[0] == pytest.approx(column(result, "L_N_m")[-1], rel=1e-9)


@pytest.mark.parametrize("name", ["checkpoint.h5", "result.vtkhdf"])
def test_results_start_new_runs(result, tmp_path, name):
    case = write_case(tmp_path)
    run("run", case, "--set", f"cluster.file={result / name}", "--out", tmp_path / "again", "--steps", 1)
    assert series(tmp_path / "again")[1][0] == "0"
    assert column(tmp_path / "again", "L_W_m")[0] == pytest.approx(column(result, "L_W_m")[-1], rel=1e-9)


def test_unknown_format_names_the_known_ones(result):
    failed = run("export", result, "--format", "vtpp", expect=2)
    assert re.search(r"unknown export format 'vtpp': did you mean vtp\?", failed.stderr)
    assert not (result / "export_vtpp").exists()
