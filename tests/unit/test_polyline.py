"""usdrigui.layer.polyline, against all choices of points."""

import itertools

import numpy as np
import pytest

from usdrigui.layer.polyline import _departure, fewest_points


@pytest.mark.parametrize("seed", range(12))
def test_no_other_choice_has_fewer_points_or_departs_less(seed):
    rng = np.random.default_rng(seed)
    line = np.cumsum(rng.normal(size=(8, 3)), axis=0)
    tolerance = float(rng.uniform(0.1, 2.0))

    def worst(kept):
        return max(_departure(line[a : b + 1]) for a, b in itertools.pairwise(kept))

    choices = [(0, *between, 7) for count in range(7) for between in itertools.combinations(range(1, 7), count)]
    best = min((len(kept), worst(kept)) for kept in choices if worst(kept) <= tolerance)
    found = fewest_points(line, tolerance)
    assert (len(found), worst(found)) == pytest.approx(best)


def test_a_line_that_turns_back_or_stands_still_keeps_where_it_turns():
    there_and_back = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [1, 0, 0], [0, 0, 0]])
    assert fewest_points(there_and_back, 0.1).tolist() == [0, 2, 4]
    assert fewest_points(there_and_back, 0.0).tolist() == [0, 2, 4]
    assert fewest_points(there_and_back, -1.0).tolist() == [0, 1, 2, 3, 4]
    assert fewest_points(np.zeros((5, 3)), 0.0).tolist() == [0, 4]


def test_both_directions_of_a_line_are_drawn_alike():
    turns = np.linspace(0.0, 2.0, 21)
    line = np.stack([np.cos(turns), np.sin(turns), 0.0 * turns], axis=1)
    assert fewest_points(line, 0.05).tolist() == (20 - fewest_points(line[::-1], 0.05)[::-1]).tolist()
