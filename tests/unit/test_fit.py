"""The solver behind every drag, against scipy and against search by hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import lsq_linear

from usdrigui.pose.fit import bounded, fit, lines


@settings(deadline=None, max_examples=60)
@given(st.integers(0, 10_000), st.integers(1, 12), st.integers(1, 60), st.sampled_from([1e-4, 1e-2, 1.0]))
def test_bounded_least_squares_equals_scipy(seed, rows, columns, stay):
    rng = np.random.default_rng(seed)
    matrix, wanted = rng.normal(size=(rows, columns)), 3.0 * rng.normal(size=rows)
    cost = stay * rng.uniform(0.5, 2.0, columns)
    low, high = -rng.uniform(0.0, 1.0, columns), rng.uniform(0.0, 1.0, columns)
    high[::5] = low[::5] + 1e-12
    found = bounded(matrix, wanted, cost, low, high)
    whole = np.vstack([matrix, np.diag(np.sqrt(cost))])
    known = lsq_linear(whole, np.r_[wanted, np.zeros(columns)], (low, high), method="bvls", tol=1e-14)

    def energy(x):
        return 0.5 * np.square(matrix @ x - wanted).sum() + 0.5 * cost @ x**2

    assert (found >= low).all()
    assert (found <= high).all()
    assert energy(found) <= energy(known.x) * (1 + 1e-7) + 1e-9


def test_bounds_change_the_answer():
    matrix = np.array([[1.0, 1.0]])
    free = bounded(matrix, np.array([3.0]), np.full(2, 1e-6), np.full(2, -9.0), np.full(2, 9.0))
    held = bounded(matrix, np.array([3.0]), np.full(2, 1e-6), np.full(2, -9.0), np.array([1.0, 9.0]))
    assert free == pytest.approx([1.5, 1.5], abs=1e-4)
    assert held == pytest.approx([1.0, 2.0], abs=1e-4)


def bent():
    """Two paths in the plane: one with a corner at 0.5, one straight."""
    corner = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
    return lines(
        [np.array([0.0, 0.5, 1.0]), np.array([0.0, 1.0])],
        [corner, np.array([[0.0, 0.0], [0.0, -1.0]])],
        np.zeros(2),
        np.ones(2),
        np.arange(2),
    )


@pytest.mark.parametrize("goal", [(0.6, 0.0), (1.0, 0.7), (1.0, -0.5), (0.2, -0.3), (2.0, 2.0), (-1.0, 0.0)])
def test_bent_paths_are_followed_as_far_as_a_fine_search_finds(goal):
    paths, cost = bent(), np.full(2, 1e-3)
    found = fit(paths, np.array(goal), cost, np.zeros(2), np.ones(2))
    grid = np.stack(np.meshgrid(*[np.linspace(0, 1, 41)] * 2), -1).reshape(-1, 2)

    def energy(x):
        return 0.5 * np.square(paths.moved(x) - goal).sum() + 0.5 * cost @ x**2

    assert energy(found) <= min(energy(x) for x in grid) + 1e-3


def test_a_path_that_bends_at_its_start_can_be_left_either_way():
    path = lines(
        [np.array([-1.0, 0.0, 1.0])],
        [np.array([[-1.0, 0], [0, 0], [0, 1.0]])],
        np.zeros(1),
        np.ones(1),
        np.zeros(1, int),
    )
    for goal, expected in (((-0.5, 0.0), -0.5), ((0.0, 0.5), 0.5)):
        found = fit(path, np.array(goal), np.full(1, 1e-6), np.full(1, -1.0), np.ones(1))
        assert found == pytest.approx([expected], abs=1e-4)


def test_one_variable_can_lead_several_paths():
    steps = [np.array([0.0, 1.0])] * 2
    paths = lines(
        steps, [np.array([[0.0], [1.0]]), np.array([[0.0], [2.0]])], np.zeros(2), np.ones(2), np.zeros(2, int)
    )
    assert fit(paths, np.array([1.5]), np.full(1, 1e-9), np.zeros(1), np.ones(1)) == pytest.approx([0.5])


def test_beyond_their_ends_paths_go_straight_on():
    assert bent().moved(np.array([1.5, 0.0])) == pytest.approx([1.0, 2.0])
    assert bent().moved(np.array([-0.5, 2.0])) == pytest.approx([-1.0, -2.0])
