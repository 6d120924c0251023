"""What the command cite prints for a paper."""
import re

import pytest

from small_case import run, write_case

RESULT_PARTS = ["Method", "Laws", "Values other than the defaults", "References", "BibTeX"]


@pytest.fixture(scope="module")
def cited(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cite")
    run("run", write_case(folder), "--steps", 1, "--out", folder / "result")
    return run("cite", folder / "result").stdout


def part(text, name):
    """Gives the lines below a heading, joined."""
    return " ".join(re.search(rf"(?m)^{name}\n((?:  .*\n)+)", text)[1].split())


def test_a_result_is_cited_with_its_parts(cited):
    assert re.findall(r"(?m)^(\w.*)$", cited) == RESULT_PARTS
    assert max(len(line) for line in cited.splitlines()) <= 110
    assert "Every fiber is a chain of rigid rods" in part(cited, "Method")
    assert re.search(r"Computed with fiberfate \d+\.\d+\.\d+ \[\d\], study shear_cell\.", part(cited, "Method"))


def test_laws_are_those_of_the_case_with_their_sources(cited):
    laws = part(cited, "Laws")
    assert 'breakage.law = "probability"' in laws and 'hinge.law = "elastic"' in laws
    assert "equations 3.10 to 3.12]" in laws


def test_values_are_those_that_the_case_chose(cited):
    values = part(cited, "Values other than the defaults")
    for wanted in ('flow.rate = "200 1/s"', 'fibers.diameter = "19 um"', 'cluster.source = "file"'):
        assert wanted in values
    assert "output." not in values and "contact." not in values


def test_every_mark_has_its_reference_and_every_reference_a_mark(cited):
    body, references = cited.split("\nReferences\n")
    marks = {int(number) for mark in re.findall(r"\[(\d[^\]]*)\]", " ".join(body.split()))
             for number in re.findall(r"(?:^|; )(\d+)", mark)}
    numbers = [int(number) for number in re.findall(r"(?m)^  \[(\d+)\]", references)]
    assert numbers == list(range(1, len(numbers) + 1)) and marks == set(numbers)


def test_without_a_result_the_program_is_cited(tmp_path):
    text = run("cite").stdout
    assert "[1] The fiberfate developers, fiberfate" in text and "@software{fiberfate," in text


def test_a_folder_without_a_result_is_refused(tmp_path):
    assert "holds no result" in run("cite", tmp_path, expect=2).stderr
