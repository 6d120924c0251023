"""Tests what the site is made with: the dialect of its pages, its links, its pictures; and what checks it."""
import pathlib
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "site"))

import drawing  # noqa: E402
import navigation  # noqa: E402
from dialect import translate  # noqa: E402
from staging import Stage  # noqa: E402


def test_a_list_and_a_table_are_parted_from_the_text_before_them():
    assert translate("Text\n- one\n- two\n") == "Text\n\n- one\n- two\n"
    assert translate("Text\n| a |\n| - |\n") == "Text\n\n| a |\n| - |\n"


def test_what_belongs_to_an_item_is_indented_by_four():
    assert translate("1. one\n\n   ```sh\n   ls\n   ```\n\nText\n") == "1. one\n\n    ```sh\n    ls\n    ```\n\nText\n"


def test_code_and_equations_stay_as_they_are():
    code = "```\nText\n- no list\n| no table |\n```\n"
    assert translate(code) == code
    assert translate("$$a\n - b$$\nText\n") == "$$a\n - b$$\n\nText\n"


@pytest.fixture
def stage(tmp_path):
    (tmp_path / "root/docs").mkdir(parents=True)
    (tmp_path / "root/cases/one").mkdir(parents=True)
    (tmp_path / "root/cases/one/README.md").write_text("# One\n")
    (tmp_path / "root/cases/one/case.toml").write_text('study = "cluster"\n')
    return Stage(tmp_path / "root", tmp_path / "pages")


@pytest.mark.parametrize("link, target", [
    ("../cases", "../cases/index.md"), ("../cases/one", "../cases/one/README.md"),
    ("../cases/one/case.toml", "../cases/one/case.toml.md"), ("https://toml.io", "https://toml.io"), ("#here", "#here"),
])
def test_links_lead_to_pages_of_the_site(stage, link, target):
    assert stage.with_links("docs/page.md", f"[words]({link})") == f"[words]({target})"


def test_links_in_code_stay_and_dead_ones_end_the_build(stage):
    assert stage.with_links("docs/page.md", "```\n[i](nothing)\n```") == "```\n[i](nothing)\n```"
    with pytest.raises(SystemExit, match="docs/page.md: nothing.md does not exist"):
        stage.with_links("docs/page.md", "[words](nothing.md)")


def test_every_page_of_the_documentation_has_a_place_in_the_navigation():
    def pages(entry):
        if isinstance(entry, str):
            return [entry]
        return [page for part in (entry.values() if isinstance(entry, dict) else entry) for page in pages(part)]
    folders = sorted(file.parent for file in (ROOT / "cases").glob("*/case.toml"))
    found = pages(navigation.navigation(ROOT, folders))
    expected = {page.relative_to(ROOT).as_posix() for page in [*(ROOT / "docs").rglob("*.md"), *(ROOT / "cases").rglob("*.md")]}
    assert expected <= set(found)
    assert len(found) == len(set(found))


def test_axes_have_round_numbers():
    assert drawing.ticks(0, 1) == pytest.approx([0, 0.2, 0.4, 0.6, 0.8, 1])
    assert drawing.ticks(0.3, 47) == pytest.approx([10, 20, 30, 40])


def check(folder):
    done = subprocess.run([sys.executable, HERE / "check_site.py", folder], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


@pytest.mark.parametrize("body, complaint", [
    ('<a href="gone.html">', "the link gone.html leads nowhere"),
    ('<a href="#gone">', "the link #gone: there is no such anchor"),
    ('<img src="https://example.org/a.png" alt="">', "https://example.org/a.png would be loaded from elsewhere"),
    ('<script src="//example.org/a.js"></script>', "//example.org/a.js would be loaded from elsewhere"),
    ('<link rel="stylesheet" href="gone.css">', "gone.css is not there"),
    ("<h1>Two</h1>", "2 first headings"),
    ("<p>fiberfate run case.toml</p>", "a command became text"),
])
def test_the_check_of_the_site_sees_what_is_wrong(tmp_path, body, complaint):
    page = "<html><head><title>One</title></head><body><h1>One</h1>{}</body></html>"
    (tmp_path / "index.html").write_text(page.format('<a href="#top" id="top">'))
    assert check(tmp_path)[0] == 0
    (tmp_path / "index.html").write_text(page.format(body))
    status, said = check(tmp_path)
    assert status == 1
    assert complaint in said
