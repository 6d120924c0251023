"""The manual page and the completions of shells, which scripts/manual writes from what the program says."""
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from small_case import PROGRAM

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "manual" / "write_manual.py"


@pytest.fixture(scope="module")
def manual(tmp_path_factory):
    folder = tmp_path_factory.mktemp("manual")
    subprocess.run([sys.executable, SCRIPT, shutil.which(PROGRAM) or PROGRAM, folder], check=True, timeout=60)
    return folder


def bash_completes(manual, line, folder="."):
    """Completes the last word of a command line as bash would."""
    script = f"""source '{manual / "fiberfate.bash"}'
        compopt() {{ :; }}
        COMP_WORDS=({line}); [[ '{line}' == *' ' ]] && COMP_WORDS+=("")
        COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _fiberfate; printf '%s\\n' "${{COMPREPLY[@]}}" """
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True, cwd=folder)
    assert done.stderr == ""
    return done.stdout.split()


@pytest.mark.parametrize("line, words", [
    ("fiberfate re", ["resume", "report"]),
    ("fiberfate run --unt", ["--until"]),
    ("fiberfate run case.toml --progress l", ["line", "log"]),
    ("fiberfate run case.toml --set contact.frict", ["contact.friction=", "contact.friction_law="]),
    ("fiberfate explain fibers.rod_", ["fibers.rod_length"]),
    ("fiberfate explain proper", ["properties"]),
    ("fiberfate new 36_", ["36_disc"]),
    ("fiberfate export results/r --format c", ["csv", "calculix"]),
    ("fiberfate export results/r --format ", ["vtp", "csv", "abaqus", "calculix"])])
def test_bash_completes(manual, line, words):
    assert bash_completes(manual, line) == words


def test_bash_offers_cases_and_folders(manual, tmp_path):
    (tmp_path / "case.toml").touch()
    (tmp_path / "notes.txt").touch()
    (tmp_path / "results").mkdir()
    assert bash_completes(manual, "fiberfate check ", tmp_path) == ["case.toml", "results"]
    assert bash_completes(manual, "fiberfate resume ", tmp_path) == ["results"]


@pytest.mark.parametrize("shell, name", [("bash", "fiberfate.bash"), ("zsh", "_fiberfate"), ("fish", "fiberfate.fish")])
def test_shells_read_the_completions(manual, shell, name):
    if shutil.which(shell) is None:
        pytest.skip(f"{shell} is not installed")
    subprocess.run([shell, "-n", manual / name], check=True)


def test_fish_completes(manual):
    if shutil.which("fish") is None:
        pytest.skip("fish is not installed")
    script = f"source '{manual / 'fiberfate.fish'}'; complete -C 'fiberfate explain fibers.rod_'"
    done = subprocess.run(["fish", "--no-config", "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["fibers.rod_length"]


def test_the_manual_page_shows_every_command_and_option(manual):
    groff = shutil.which("groff")
    if groff is None:
        pytest.skip("groff is not installed")
    done = subprocess.run([groff, "-man", "-ww", "-Tascii", "-P-cbou", manual / "fiberfate.1"], capture_output=True, text=True,
                          check=True)
    assert done.stderr == ""
    for word in ("fiberfate new", "fiberfate import", "--sweep KEY=VALUE,VALUE", "--steps N", "EXIT STATUS", "36_disc"):
        assert word in done.stdout, word
    assert max(map(len, done.stdout.splitlines())) <= 110
