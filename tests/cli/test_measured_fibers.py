"""Measured fibers and properties of parts: known answers from the command line, and what a user is told."""
import json
import math
from pathlib import Path

import pytest

from small_case import column, run, summary

ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "cases"
STIFFNESS = json.loads((ROOT / "tests" / "reference" / "stiffness.json").read_text(encoding="utf-8"))


def result_of(tmp_path, case, *words):
    folder = tmp_path / "result"
    run("run", case, "--out", folder, *words)
    return folder, summary(folder)


def measured(tmp_path, lists, text):
    for name, rows in lists.items():
        (tmp_path / name).write_text(rows, encoding="utf-8")
    case = tmp_path / "case.toml"
    case.write_text('study = "measurement"\n' + text, encoding="utf-8")
    return case


def test_means_of_a_short_list(tmp_path):
    case = measured(tmp_path, {"l.csv": "500\n500\n1000\n2000\n"}, '[lengths]\nfile = "l.csv"\nunit = "um"\nbins = 4\n')
    folder, values = result_of(tmp_path, case)
    assert values["L_N_m"] == pytest.approx(1e-3)
    assert values["L_W_m"] == pytest.approx((0.25 + 0.25 + 1 + 4) / 4 * 1e-3)
    assert values["measured_lengths"] == 4
    assert column(folder, "number_share", "histogram.csv") == [0, 0.5, 0.25, 0.25]
    assert column(folder, "number", "distribution.csv") == [1, 1, 1, 1]


# Bins of 1e-300 m used to hang `check`.
@pytest.mark.parametrize("width", ["1e-300", "0.1 um"])
def test_bins_that_are_too_many_are_refused(tmp_path, width):
    case = measured(tmp_path, {"l.csv": "500\n2000\n"}, f'[lengths]\nfile = "l.csv"\nunit = "um"\nbin_width = "{width}"\n'.replace('"1e-300"', "1e-300"))
    words = run("check", case, expect=2).stderr
    assert "lengths.bin_width" in words and "more than 10000 bins" in words and '"0.22 um"' in words
    run("check", case, "--set", "lengths.bin_width=0.21 um")


def test_the_correction_of_a_sampled_region(tmp_path):
    case = measured(tmp_path, {"l.csv": "length,count\n1,3\n4,1\n"},
                    '[lengths]\nfile = "l.csv"\nunit = "mm"\nnumber_column = "count"\nsample_diameter = "2 mm"\n')
    folder, values = result_of(tmp_path, case)
    short, long = 3 / (1 + 4 / (2 * math.pi)), 1 / (1 + 16 / (2 * math.pi))
    assert values["L_N_m"] == pytest.approx(1e-3 * (short + 4 * long) / (short + long))
    assert values["L_N_uncorrected_m"] == pytest.approx(1.75e-3)
    assert values["L_N_lower_m"] <= values["L_N_m"] <= values["L_N_upper_m"]
    assert column(folder, "number", "distribution.csv") == pytest.approx([short, long])


def test_angles_and_vectors_are_the_same(tmp_path):
    angles = [(90, 0), (90, 90), (30, 45), (120, -20)]
    turned = [[math.radians(a) for a in pair] for pair in angles]
    vectors = [(math.sin(t) * math.cos(f), math.sin(t) * math.sin(f), math.cos(t)) for t, f in turned]
    lists = {"a.csv": "theta,phi\n" + "".join(f"{t},{f}\n" for t, f in angles),
             "v.csv": "".join(f"{2 * x!r},{2 * y!r},{2 * z!r}\n" for x, y, z in vectors)}
    case = measured(tmp_path, lists, '[orientation]\nfile = "a.csv"\n')
    _, of_angles = result_of(tmp_path, case)
    _, of_vectors = result_of(tmp_path, case, "--overwrite", "--set", "orientation.file=" + str(tmp_path / "v.csv"), "--set",
                              "orientation.form=vectors", "--set", 'orientation.columns=["1", "2", "3"]')
    for i in range(3):
        assert of_angles["A2"][i] == pytest.approx(of_vectors["A2"][i], abs=1e-14)
    assert of_angles["A2"][0][1] == pytest.approx(sum(x * y for x, y, _ in vectors) / 4)


def test_measured_lists_feed_other_studies(tmp_path):
    folder, values = result_of(tmp_path, CASES / "27_measured_fibers" / "case.toml")
    assert values["L_N_lower_m"] < 1.47e-3 < values["L_N_upper_m"] < values["L_N_uncorrected_m"]
    assert values["L_W_lower_m"] < 2.22e-3 < values["L_W_upper_m"]
    assert values["A2_lower"][0][0] < 0.601 < values["A2_upper"][0][0]
    assert values["A2_lower"][2][2] < 0.081 < values["A2_upper"][2][2]
    run("report", folder)
    run("check", folder / "case.resolved.toml")
    distribution = "fibers.distribution=" + str(folder / "distribution.csv")
    attrition = (CASES / "20_couette_length" / "case.toml").read_text(encoding="utf-8")
    case = tmp_path / "attrition.toml"
    case.write_text(attrition.replace('length = "15 mm"', "").replace('form = "means"', ""), encoding="utf-8")
    run("run", case, "--out", tmp_path / "broken", "--set", distribution)
    assert summary(tmp_path / "broken")["L_N_start_m"] == pytest.approx(values["L_N_m"], rel=1e-12)


@pytest.mark.parametrize("lists, text, words", [
    ("length\n1\n", '[lengths]\nfile = "l.csv"\n', ["lengths.unit: not given", "um"]),
    ("length\n1\n", '[lengths]\nfile = "m.csv"\nunit = "mm"\n', ["lengths.file", "no such file"]),
    ("length\n1\n", '[lengths]\nfile = "l.csv"\nunit = "kg"\n', ["lengths.unit", "dimension"]),
    ("length\n1\n", '[lengths]\nfile = "l.csv"\nunit = "mm"\ncolumn = "lenght"\n', ["did you mean 'length'"]),
    ("length\n1\n-2\n", '[lengths]\nfile = "l.csv"\nunit = "mm"\n', ["l.csv:3:1: a length is -2", "positive"]),
    ("length\n0\n", '[lengths]\nfile = "l.csv"\nunit = "mm"\n', ["no fibers but of zero length"]),
    ("length\n1,5\n", '[lengths]\nfile = "l.csv"\nunit = "mm"\n', ["l.csv:2:1: '1,5' has a decimal comma", "decimal points"]),
    ("length\nlong\n", '[lengths]\nfile = "l.csv"\nunit = "mm"\n', ["case.toml:3:8: lengths.file", "l.csv:2:1: 'long' is not a finite number"]),
    ("theta,phi\n1,2\n", '[orientation]\nfile = "l.csv"\ncut_normal = [0, 0, 1]\n', ["orientation.aspect_ratio"]),
    ("x,y\n1,2\n", '[orientation]\nfile = "l.csv"\n', ["no column 'theta'", "'x', 'y'"]),
    ("", "", ["lengths.file", "nor is orientation.file"])])
def test_faults_of_lists_are_told(tmp_path, lists, text, words):
    refused = run("check", measured(tmp_path, {"l.csv": lists}, text), expect=2)
    for word in words:
        assert word in refused.stdout + refused.stderr


COUNTER = " ,Area,Angle,Length\n1,210.5,12.0,412.0\n2,198.1,-40.5,655.0\n3,305.7,88.1,208.5\n4,150.2,3.3,1204.5\n"
SEMICOLONS = "Nr.;Länge [mm];Durchmesser\n1;0,512;0,017\n2;1,204;0,017\n\n3;0;0,018\n4;0,087;0,018\n"


def test_a_counter_is_not_taken_for_lengths(tmp_path):
    case = measured(tmp_path, {"l.csv": COUNTER}, '[lengths]\nfile = "l.csv"\nunit = "um"\n')
    refused = run("check", case, expect=2).stderr
    for words in ("lengths.column: not given", "column 1 without a name, 'Area', 'Angle', 'Length'", 'column = "Length"'):
        assert words in refused
    _, values = result_of(tmp_path, case, "--set", "lengths.column=Length")
    assert values["L_N_m"] == pytest.approx(620.0e-6, rel=1e-12)
    assert values["L_W_m"] == pytest.approx(843.976e-6, rel=1e-6)


@pytest.mark.parametrize("keys", ['unit = "mm"', "", 'column = "Länge"', 'column = "Länge [mm]"\nunit = "mm"'])
def test_semicolons_and_decimal_commas_are_read(tmp_path, keys):
    case = measured(tmp_path, {"l.csv": SEMICOLONS}, f'[lengths]\nfile = "l.csv"\n{keys}\n')
    folder, values = result_of(tmp_path, case)
    assert values["L_N_m"] == pytest.approx(0.601e-3, rel=1e-12)
    assert values["L_W_m"] == pytest.approx(0.95359e-3, rel=1e-5)
    assert values["measured_lengths"] == 3 and values["lengths_column"] == "Länge [mm]"
    assert values["left_out_empty_lines"] == 1 and values["left_out_zero_lengths"] == 1
    told = "1 empty line and 1 row of zero length are left out"
    assert told in (folder / "log.txt").read_text(encoding="utf-8")
    run("report", folder)
    assert told in (folder / "report.html").read_text(encoding="utf-8")
    assert told in run("check", case).stdout


def test_the_unit_of_a_heading_is_not_contradicted(tmp_path):
    case = measured(tmp_path, {"l.csv": SEMICOLONS}, '[lengths]\nfile = "l.csv"\nunit = "um"\n')
    assert "'um' contradicts the heading 'Länge [mm]'" in run("check", case, expect=2).stderr


@pytest.mark.parametrize("column", ["", 'column = "Length"\n'])
def test_part_of_a_number_is_not_taken_for_it(tmp_path, column):
    case = measured(tmp_path, {"l.csv": "Length, mm\n1,204\n3,512\n2,087\n"}, f'[lengths]\nfile = "l.csv"\nunit = "mm"\n{column}')
    assert "decimal comma" in run("check", case, expect=2).stderr


def test_lists_in_other_encodings_and_with_tabs_are_read(tmp_path):
    case = measured(tmp_path, {"l.csv": ""}, '[lengths]\nfile = "l.csv"\n')
    for text in ("Länge [mm]\tLabel\r\n1,5\ta 1\r\n2,25\tb 2\r\n".encode("latin-1"), "\ufeffLength (mm);Label\n1,5;a\n2,25;b\n".encode()):
        (tmp_path / "l.csv").write_bytes(text)
        assert result_of(tmp_path, case, "--overwrite")[1]["L_N_m"] == pytest.approx(1.875e-3, rel=1e-12)


PROPERTIES = """study = "properties"
[fibers]
volume_fraction = {fraction}
aspect_ratio = {ratio}
orientation = "aligned"
youngs_modulus = {fiber}
poisson_ratio = {fiber_nu}
[matrix]
youngs_modulus = {matrix}
poisson_ratio = {matrix_nu}
[solution]
model = "{model}"
"""


def written(tmp_path, **values):
    usual = {"fraction": 0.2, "ratio": 25, "fiber": '"73 GPa"', "fiber_nu": 0.22, "matrix": '"1.5 GPa"',
             "matrix_nu": 0.4, "model": "mori_tanaka"}
    case = tmp_path / "case.toml"
    case.write_text(PROPERTIES.format(**{**usual, **values}), encoding="utf-8")
    return case


@pytest.mark.parametrize("model", ["halpin_tsai", "mori_tanaka", "lielens"])
def test_models_without_fibers_give_the_matrix(tmp_path, model):
    _, values = result_of(tmp_path, written(tmp_path, fraction=0, model=model))
    assert values["E_1_Pa"] == pytest.approx(1.5e9, rel=1e-12)
    assert values["nu_23"] == pytest.approx(0.4, rel=1e-12)
    assert values["thermal_expansion_per_K"][0][0] == pytest.approx(1e-4, rel=1e-12)


MODELS = {"halpin": "halpin_tsai", "mori": "mori_tanaka", "lielens": "lielens"}
CONSTANTS = ["E_1_Pa", "E_2_Pa", "E_3_Pa", "G_23_Pa", "G_31_Pa", "G_12_Pa", "nu_23", "nu_31", "nu_12"]


def label(row):
    return f"{row['model']}-{row['vf']}-{row['aspect']}"


def assert_reference(values, prefix, row):
    for name, expected in zip(CONSTANTS, row["eng"]):
        assert values[prefix + name] == pytest.approx(expected * (1e9 if name.endswith("Pa") else 1), rel=1e-9)
    for i in range(3):
        assert values[prefix + "thermal_expansion_per_K"][i][i] == pytest.approx(1e-6 * row["alpha"][i], rel=1e-9)
    assert values[prefix + "stiffness_Pa"] == pytest.approx([1e9 * c for c in row["C"]], rel=1e-9, abs=1)


@pytest.mark.parametrize("row", STIFFNESS["UD"][::6], ids=label)
def test_aligned_fibers_are_those_of_the_reference(tmp_path, row):
    case = written(tmp_path, fraction=row["vf"], ratio=row["aspect"], model=MODELS[row["model"]])
    assert_reference(result_of(tmp_path, case)[1], "aligned_", row)


@pytest.mark.parametrize("row", STIFFNESS["averaged"][::3], ids=label)
def test_averages_over_orientation_are_those_of_the_reference(tmp_path, row):
    case = written(tmp_path, fraction=row["vf"], ratio=row["aspect"], model=MODELS[row["model"]])
    second = [row["A2"][3 * i:3 * i + 3] for i in range(3)]
    _, values = result_of(tmp_path, case, "--set", "fibers.orientation=" + json.dumps(second), "--set",
                          "solution.closure=" + row["closure"].lower())
    assert_reference(values, "", row)


def test_long_aligned_fibers_obey_the_rule_of_mixtures(tmp_path):
    folder, values = result_of(tmp_path, written(tmp_path, ratio=1e6))
    # Different Poisson's ratios add a term of their difference squared, 18 MPa here (Hill 1964).
    assert values["E_1_Pa"] == pytest.approx(0.2 * 73e9 + 0.8 * 1.5e9, abs=25e6)
    assert column(folder, "modulus_12_Pa", "modulus.csv")[0] == pytest.approx(values["E_1_Pa"], rel=1e-12)
    assert column(folder, "modulus_13_Pa", "modulus.csv")[36] == pytest.approx(values["E_3_Pa"], rel=1e-12)
    run("report", folder)


def test_a_weight_fraction_becomes_a_volume_fraction(tmp_path):
    folder, values = result_of(tmp_path, CASES / "13_injected_plate_stiffness" / "case.toml")
    assert values["volume_fraction"] == pytest.approx(0.4 / 2550 / (0.4 / 2550 + 0.6 / 905), rel=1e-12)
    assert values["E_3_Pa"] < values["E_2_Pa"] < values["E_1_Pa"] < values["aligned_E_1_Pa"]
    run("check", folder / "case.resolved.toml")


@pytest.mark.parametrize("old, new, words", [
    ("volume_fraction = 0.2", "", ["fibers.volume_fraction: not given"]),
    ("volume_fraction = 0.2", "volume_fraction = 0.2\nweight_fraction = 0.4", ["contradicts fibers.weight_fraction"]),
    ("volume_fraction = 0.2", "volume_fraction = 1.2", ["fibers.volume_fraction = 1.2: out of range"]),
    ("aspect_ratio = 25", "", ["fibers.aspect_ratio: not given"]),
    ("aspect_ratio = 25", 'aspect_ratio = 25\nlength = "1 mm"', ["more than one way"]),
    ("poisson_ratio = 0.4", "poisson_ratio = 0.5", ["matrix.poisson_ratio = 0.5: out of range"]),
    ('youngs_modulus = "1.5 GPa"', 'youngs_modulus = "1.5 GPA"', ["matrix.youngs_modulus"]),
    ('model = "mori_tanaka"', 'model = "mori-tanaka"', ["did you mean", "mori_tanaka"])])
def test_faults_of_properties_are_told(tmp_path, old, new, words):
    case = written(tmp_path)
    case.write_text(case.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
    refused = run("check", case, expect=2)
    for word in words:
        assert word in refused.stdout + refused.stderr
