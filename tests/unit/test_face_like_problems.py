"""Problems made for benchmarks: sizes of the paper's table, the same from a seed, handles by the rule for rigs."""

import numpy as np
import pytest
import scripts
from folders import ROOT

from usdrigui.settings import SolveSettings
from usdrigui.solve import solve

SCRIPT = ROOT / "benchmarks" / "instances.py"


@pytest.fixture(scope="module")
def instances():
    with scripts.loaded(SCRIPT) as module:
        yield module


def test_controls_are_variables_or_mirrored_pairs(instances):
    problem = instances.face_like(1186, 26)
    copies = [each.handles.shape[1] for each in problem.variables]
    assert sum(copies) == 26
    assert set(copies) == {1, 2}


def test_a_seed_makes_one_problem(instances):
    one, same, other = (instances.face_like(1186, 26, seed) for seed in (3, 3, 4))
    assert all(np.array_equal(a.cost, b.cost) for a, b in zip(one.variables, same.variables, strict=True))
    assert not all(np.array_equal(a.cost, b.cost) for a, b in zip(one.variables, other.variables, strict=True))


def test_toulbar2_proves_the_same_of_a_whole_face(instances):
    """Every candidate of every control, unreduced."""
    pytest.importorskip("pytoulbar2")
    problem = instances.face_like(40_000, 22)
    assert sum(len(each.cost) for each in problem.variables) > 4_500
    ours = solve(problem, SolveSettings())
    with scripts.loaded(SCRIPT.with_name("toulbar2.py")) as toulbar2, toulbar2.in_the_turn_of_highs():
        theirs = solve(problem, SolveSettings())
    assert theirs.status == ours.status == "optimal"
    assert ours.bound <= theirs.cost + 1e-6
    assert theirs.cost - 1e-6 <= ours.cost <= theirs.cost + 1e-4 * abs(theirs.cost)
