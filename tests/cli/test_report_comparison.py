"""Comparisons: several results of one study on one page, and what is refused."""
import json
import re
from pathlib import Path

import pytest

from small_case import column, run, summary

ORIENTATION = """study = "orientation"

[diffusion]
name = "folgar_tucker"
C_I = 0.01

[flow]
rate = "1 1/s"

[run]
duration = "10 s"

[output]
interval = "1 s"
"""
MEASUREMENT = 'study = "measurement"\n[lengths]\nfile = "l.csv"\nunit = "mm"\nbins = 4\n'


def document(page):
    text = Path(page).read_text(encoding="utf-8")
    return json.loads(re.search(r'id="fiberfate-document">(.*?)</script>', text, re.S).group(1))


def section(found, name):
    return next(one for one in found["sections"] if one["id"] == name)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    (folder / "case.toml").write_text(ORIENTATION, encoding="utf-8")
    for name, constant in (("weak", 0.001), ("strong", 0.1)):
        run("run", folder / "case.toml", "--out", folder / name, "--set", f"diffusion.C_I={constant}")
    (folder / "l.csv").write_text("length\n1\n2\n2\n3\n", encoding="utf-8")
    (folder / "list.toml").write_text(MEASUREMENT, encoding="utf-8")
    for name, seed, samples in (("first", 1, 100), ("second", 2, 100), ("other", 1, 200)):
        run("run", folder / "list.toml", "--out", folder / name, "--set", f"statistics.seed={seed}", "--set",
            f"statistics.resamples={samples}")
    return folder


def test_every_chart_has_a_line_a_run(results):
    told = run("report", results / "weak", results / "strong").stdout
    page = results / "comparison.html"
    assert told == f"comparison in {page}\n"
    found = document(page)
    assert found["study"] == "orientation" and found["case"] == "2 runs compared"
    chart = section(found, "components_a_11")
    assert chart["title"] == "Orientation tensor: a_11"
    assert [one["label"] for one in chart["series"]] == ["weak", "strong"]
    for one, name in zip(chart["series"], ("weak", "strong")):
        assert one["values"] == column(results / name, "a11")
        assert one["x"] == column(results / name, "time_s")
    assert [one["colour"] for one in chart["series"]] == [0, 1]


def test_what_differs_and_results_stand_side_by_side(results):
    run("report", results / "weak", results / "strong", "--out", results / "page.html")
    found = document(results / "page.html")
    assert section(found, "differences")["rows"] == [{"label": "diffusion.C_I", "values": [0.001, 0.1]}]
    outcome = section(found, "outcome")
    assert outcome["runs"] == ["weak", "strong"]
    steps = next(row for row in outcome["rows"] if row["label"] == "Steps")
    assert steps["values"] == [summary(results / name)["steps"] for name in ("weak", "strong")]
    first = next(row for row in outcome["rows"] if row["label"] == "Orientation at the end, a_11")
    assert first["values"] == [summary(results / name)["A2"][0][0] for name in ("weak", "strong")]


def test_replicas_are_one_line_with_a_band(results):
    run("report", results / "first", results / "second", results / "other", "--out", results / "lists.html")
    found = document(results / "lists.html")
    assert section(found, "differences")["runs"] == ["first, second", "other"]
    bars = section(found, "by_number")
    assert [one["label"] for one in bars["series"]] == ["first, second", "other"]
    assert bars["series"][0]["low"] == bars["series"][0]["high"] == bars["series"][0]["values"]
    assert section(found, "by_number")["series"][0]["x"] == section(found, "by_number")["series"][1]["x"]
    lengths = next(row for row in section(found, "outcome")["rows"] if row["label"] == "L_N")
    assert lengths["values"] == pytest.approx([2e-3, 2e-3]) and lengths["low"][0] == lengths["high"][0]
    assert lengths["low"][1] is None


def test_folders_of_one_name_are_told_apart(results, tmp_path):
    for place in ("a", "b"):
        run("run", results / "case.toml", "--out", tmp_path / place / "result", "--set", f"flow.rate={1 if place == 'a' else 2}")
    run("report", tmp_path / "a" / "result", tmp_path / "b" / "result", "--out", tmp_path / "page.html")
    assert section(document(tmp_path / "page.html"), "differences")["runs"] == ["a/result", "b/result"]
    run("report", tmp_path / "a" / "result/", tmp_path / "b" / "result", cwd=tmp_path)
    assert (tmp_path / "comparison.html").exists()


def test_one_report_may_be_written_elsewhere(results, tmp_path):
    told = run("report", results / "weak", "--out", tmp_path / "weak.html").stdout
    assert told == f"report in {tmp_path / 'weak.html'}\n"
    assert document(tmp_path / "weak.html")["case"] == "weak" and not (results / "weak" / "report.html").exists()


def test_studies_are_not_mixed(results):
    refused = run("report", results / "weak", results / "first", expect=2).stderr
    assert f"{results / 'weak'} holds a result of the study orientation, {results / 'first'} one of measurement" in refused
    assert "compare results of one study" in refused


def test_a_folder_is_named_once(results):
    refused = run("report", results / "weak", f"{results / 'weak'}/", expect=2).stderr
    assert "is given twice" in refused


def test_files_of_the_user_stay(results, tmp_path):
    (tmp_path / "mine.html").write_text("mine", encoding="utf-8")
    refused = run("report", results / "weak", results / "strong", "--out", tmp_path / "mine.html", expect=2).stderr
    assert "fiberfate did not make it" in refused and (tmp_path / "mine.html").read_text() == "mine"
    assert "is a folder" in run("report", results / "weak", results / "strong", "--out", tmp_path, expect=2).stderr
    pages = ("report", results / "weak", results / "strong", "--out", tmp_path / "page.html")
    run(*pages)
    assert "add --overwrite" in run(*pages, expect=2).stderr
    run(*pages, "--overwrite")


def test_a_folder_without_a_result_is_told(results, tmp_path):
    refused = run("report", results / "weak", tmp_path, expect=2).stderr
    assert str(tmp_path) in refused
