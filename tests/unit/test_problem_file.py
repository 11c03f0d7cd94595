"""The benchmarks' file of a layout problem."""

from dataclasses import fields, replace

import numpy as np
import pytest
import scripts
from folders import ROOT
from layout_problems import random_problem

from usdrigui.overlap import total_cost

SCRIPT = ROOT / "benchmarks" / "problem_file.py"


@pytest.mark.parametrize("seed", [3, 8, 21])
def test_saved_problem_is_the_problem(seed, tmp_path):
    problem = random_problem(seed)
    problem = replace(problem, variables=tuple(replace(v, states=frozenset({0, 3})) for v in problem.variables))
    with scripts.loaded(SCRIPT) as files:
        files.save_problem(tmp_path / "a.npz", problem)
        again = files.load_problem(tmp_path / "a.npz")
        files.save_problem(tmp_path / "b.npz", again)
    for one, other in zip(problem.variables, again.variables, strict=True):
        assert all(np.array_equal(getattr(one, each.name), getattr(other, each.name)) for each in fields(one))
    assert len(again.extra) == len(problem.extra)
    labels = np.zeros(len(problem.variables), dtype=np.int64)
    assert total_cost(again, labels) == total_cost(problem, labels)
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()


def test_files_of_another_version_are_refused(tmp_path):
    np.savez(tmp_path / "other.npz", version=np.array(99))
    with scripts.loaded(SCRIPT) as files, pytest.raises(ValueError, match="version 99"):
        files.load_problem(tmp_path / "other.npz")
