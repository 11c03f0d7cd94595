"""Problems made for benchmarks: sizes of the paper's table, the same from a seed, handles by the rule for rigs."""

from pathlib import Path

import numpy as np
import pytest
import scripts

from usdrigui.settings import ObjectiveSettings, SolveSettings
from usdrigui.solve import solve

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "instances.py"
FACE = 2.0


@pytest.fixture(scope="module")
def instances():
    with scripts.loaded(SCRIPT) as module:
        yield module


def share(problem):
    """Handle width in face sizes."""
    return problem.separation / FACE


def test_controls_are_variables_or_mirrored_pairs(instances):
    problem = instances.face_like(1186, 26)
    copies = [each.handles.shape[1] for each in problem.variables]
    assert sum(copies) == 26
    assert set(copies) == {1, 2}


def test_a_seed_makes_one_problem(instances):
    one, same, other = (instances.face_like(1186, 26, seed) for seed in (3, 3, 4))
    assert all(np.array_equal(a.cost, b.cost) for a, b in zip(one.variables, same.variables, strict=True))
    assert not all(np.array_equal(a.cost, b.cost) for a, b in zip(one.variables, other.variables, strict=True))


def test_a_face_of_few_controls_has_handles_of_the_size_asked_for(instances):
    assert share(instances.face_like(4002, 22)) == ObjectiveSettings().handle_size


def test_handles_shrink_with_the_crowd_until_they_have_room(instances):
    """As many controls as anybody has are placed with handles above the least."""
    widths = [share(instances.face_like(4002, controls)) for controls in (22, 140, 300, 500)]
    assert np.all(np.diff(widths) < 0.0)
    assert widths[-1] > 1.2 * ObjectiveSettings().handle_size_min


@pytest.mark.parametrize(("points", "controls"), [(1186, 26), (4002, 22), (5064, 47), (5064, 142)])
def test_controls_crowd_as_on_the_most_crowded_of_real_rigs(instances, points, controls):
    """On rigs of 30 to 88 controls a share of 0.053 to 0.088 of the others stands around one (decision 034)."""
    assert 0.065 < instances.crowding(instances.face_like(points, controls), FACE) < 0.095
    crowded = instances.face_like(points, controls, scatter=instances.CROWDED)
    assert instances.crowding(crowded, FACE) > 0.12


def test_overlap_counts_in_handle_widths(instances):
    settings = ObjectiveSettings()
    for controls in (22, 80):
        problem = instances.face_like(4002, controls)
        assert problem.overlap.radius == pytest.approx(settings.overlap_radius * problem.separation)


def test_toulbar2_proves_the_same_of_a_whole_face(instances):
    """Every candidate of every control, unreduced."""
    pytest.importorskip("pytoulbar2")
    problem = instances.face_like(40_000, 22)
    assert sum(len(each.cost) for each in problem.variables) > 4_500
    theirs, ours = (solve(problem, SolveSettings(method=method)) for method in ("toulbar2", "highs"))
    assert theirs.status == ours.status == "optimal"
    assert ours.bound <= theirs.cost + 1e-6
    assert theirs.cost - 1e-6 <= ours.cost <= theirs.cost + 1e-4 * abs(theirs.cost)
