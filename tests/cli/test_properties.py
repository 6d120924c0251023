"""Properties of parts: numbers that mean something, or a refusal."""
import pytest

from small_case import run

CASE = """study = "properties"
[fibers]
volume_fraction = {fraction}
aspect_ratio = {ratio}
youngs_modulus = {fiber}
poisson_ratio = {fiber_poisson}
orientation = {orientation}
[matrix]
youngs_modulus = {matrix}
poisson_ratio = {matrix_poisson}
[solution]
model = "{model}"
closure = "{closure}"
"""


@pytest.mark.parametrize("values", [
    {"fraction": 1e-9, "ratio": 0.9999999, "fiber": 1e-200, "fiber_poisson": 0.4999999999999, "orientation": "[0, 0.5, 0.5]",
     "matrix": 1, "matrix_poisson": -0.9999999999, "model": "halpin_tsai", "closure": "linear"},
    {"fraction": 0.999999, "ratio": 0.9999999, "fiber": 1e-200, "fiber_poisson": -0.9999999999,
     "orientation": "[[0.5, 0.5, 0], [0.5, 0.5, 0], [0, 0, 0]]", "matrix": 1e-100, "matrix_poisson": 0.4,
     "model": "halpin_tsai", "closure": "ibof"},
    {"fraction": 1, "ratio": 1e-9, "fiber": 4.6e-6, "fiber_poisson": 0.22, "orientation": "[0, 0.5, 0.5]", "matrix": 1e13,
     "matrix_poisson": 0.4999999999999, "model": "lielens", "closure": "ore"}], ids=["tiny", "soft", "all fibers"])
def test_a_modulus_that_is_no_number_is_refused(tmp_path, values):
    (tmp_path / "case.toml").write_text(CASE.format(**values), encoding="utf-8")
    failed = run("run", tmp_path / "case.toml", "--out", tmp_path / "r", expect=2)
    assert "the model gives" in failed.stderr
    assert not (tmp_path / "r").exists()


@pytest.mark.parametrize("orientation", ["[1, 0, 0]", "[0.5, 0.5, 0]", '"isotropic"', "[0, 0, 1]"])
@pytest.mark.parametrize("fraction", [0, 0.3, 1])
def test_degenerate_states_are_predicted(tmp_path, orientation, fraction):
    (tmp_path / "case.toml").write_text(
        CASE.format(fraction=fraction, ratio=25, fiber=73e9, fiber_poisson=0.22, orientation=orientation, matrix=1.5e9,
                    matrix_poisson=0.4, model="mori_tanaka", closure="exact"), encoding="utf-8")
    run("run", tmp_path / "case.toml", "--out", tmp_path / "r")
    table = (tmp_path / "r" / "modulus.csv").read_text(encoding="utf-8").splitlines()[1:]
    assert all(1.49e9 < float(number) < 74e9 for row in table for number in row.split(",")[1:])
