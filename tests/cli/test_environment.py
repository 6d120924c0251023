"""The environment of a run changes none of its digits."""
import os

import pytest

from small_case import CASE, run, series, write_case


@pytest.mark.parametrize("value", ["1,2", "2,3", "1,2,3"])
def test_a_list_of_threads_for_nested_loops_changes_nothing(tmp_path, value):
    """Half of the contacts went missing where the second number is not the first."""
    case = write_case(tmp_path, CASE.replace('duration = "20 ms"', 'duration = "4 ms"'))
    run("run", case, "--out", tmp_path / "plain", "--threads", 1)
    run("run", case, "--out", tmp_path / "list", "--threads", 1, env={**os.environ, "OMP_NUM_THREADS": value})
    assert series(tmp_path / "list") == series(tmp_path / "plain")
