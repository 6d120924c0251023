"""Memory: what check foretells is what a run takes, and what there is not is refused in words."""
import re
import resource
import subprocess

import pytest

from small_case import PROGRAM, run, summary

ATTRITION = """study = "attrition"
[law]
name = "phelps"
C_B = 0.02
zeta = 3
S = 0.25
E_f = "73 GPa"
d_f = "19 um"
[melt]
name = "newtonian"
eta_0 = "200 Pa s"
[flow]
rate = "100 1/s"
[fibers]
length = "10 mm"
bins = {bins}
[run]
duration = "0.01 s"
[output]
interval = "0.01 s"
"""

LONE_FIBER = """study = "shear_cell"
[cell]
size = "0.2 m"
[fibers]
length = "5 mm"
diameter = "19 um"
youngs_modulus = "73 GPa"
rod_length = "0.1 mm"
[cluster]
source = "fiber"
direction = [0.0, 1.0, 1.0]
[flow]
rate = "10 1/s"
viscosity = "100 Pa s"
[run]
duration = "10 ms"
"""

PLAQUE = """study = "molding"
[part]
kind = "plaque"
length = "100 mm"
width = "80 mm"
thickness = "3 mm"
mesh_size = "{mesh}"
[material]
preset = "ppgf30"
[machine]
fill_time = "1 s"
melt_temperature = "523 K"
mold_temperature = "323 K"
[fibers]
length = "5 mm"
[numerics]
steps = 60
"""


def write(folder, text):
    (folder / "case.toml").write_text(text, encoding="utf-8")
    return folder / "case.toml"


def foretold_bytes(text):
    number, unit = re.search(r"^#   memory +about ([\d.]+) (MB|GB)", text, re.MULTILINE).groups()
    return float(number) * {"MB": 1e6, "GB": 1e9}[unit]


@pytest.mark.parametrize("text", [LONE_FIBER, ATTRITION.format(bins=2000), ATTRITION.format(bins=4000), PLAQUE.format(mesh="4 mm"),
                                  PLAQUE.format(mesh="1.5 mm")], ids=["lone", "bins2000", "bins4000", "plaque", "fine"])
def test_check_foretells_the_memory_of_a_run(tmp_path, text):
    case = write(tmp_path, text)
    foretold = foretold_bytes(run("check", case).stdout)
    run("run", case, "--out", tmp_path / "r")
    assert 0.5 < foretold / summary(tmp_path / "r")["peak_memory_bytes"] < 2


def limited(limit, *words):
    """Runs the program with so much address space."""
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=60, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))


def test_more_memory_than_there_is_is_refused_before_the_run(tmp_path):
    case = write(tmp_path, ATTRITION.format(bins=16000))
    done = limited(1 << 30, "run", case, "--out", tmp_path / "r")
    assert done.returncode == 2, done.stderr
    assert re.search(r"takes about \S+ GB of memory, and about \S+ (MB|GB) are free", done.stderr), done.stderr
    assert not (tmp_path / "r").exists()
    checked = limited(1 << 30, "check", case)
    assert checked.returncode == 0 and "are free" in checked.stderr


@pytest.mark.parametrize("megabytes", [40, 60, 80, 100, 120, 150, 180, 220, 300, 400])
@pytest.mark.parametrize("text", [ATTRITION.format(bins=3000), LONE_FIBER, PLAQUE.format(mesh="3 mm")],
                         ids=["attrition", "cell", "plaque"])
def test_little_memory_ends_with_a_sentence(tmp_path, text, megabytes):
    """Below some limit the loader says it, above the program does; nothing hangs or dies without a word."""
    case = write(tmp_path, text)
    done = limited(megabytes << 20, "run", case, "--out", tmp_path / "r")
    assert done.returncode in (0, 2, 3, 127), (done.returncode, done.stderr)
    assert done.returncode == 0 or done.stderr.strip()
    assert "itself" not in done.stderr


def test_the_units_library_does_not_end_the_program_where_memory_ends(tmp_path):
    case = write(tmp_path, LONE_FIBER)
    least, enough = 0, 400 << 20
    if limited(enough, "check", case).returncode != 0:
        pytest.skip("no limit leaves room for a sanitizer's shadow memory")
    while enough - least > 64 << 10:
        middle = (least + enough) // 2
        least, enough = (least, middle) if limited(middle, "check", case).returncode == 0 else (middle, enough)
    for step in range(1, 17):
        words = limited(enough - (step * 128 << 10), "check", case).stderr
        assert "ut_scan" not in words and "UDUNITS" not in words, words


def test_steps_that_would_never_end_are_refused(tmp_path):
    case = write(tmp_path, LONE_FIBER + '[step]\ncontrol = "fixed"\ninitial = 1e-300\n')
    failed = run("run", case, "--out", tmp_path / "r", expect=2)
    assert re.search(r"step.initial = 1e-300: makes 1e\+298 steps in run.duration", failed.stderr), failed.stderr
