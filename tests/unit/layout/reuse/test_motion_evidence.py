"""What motions say about which control is which, worked out by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from usdrigui.layout.reuse import motion_evidence as evidence
from usdrigui.layout.reuse.motion_evidence import Agreement


def test_fields_are_compared_by_direction_and_length():
    one = np.array([[3.0, 4.0, 0.0], [0.0, 0.0, 0.0]])
    found = evidence._agreement(one, np.array([[6.0, 8.0, 0.0], [-4.0, 3.0, 0.0], [3e9, 4e9, 0.0], [0.0, 0.0, 0.0]]))
    assert found.cosine == pytest.approx(np.array([[1.0, 0, 1, 0], [0, 0, 0, 0]]))
    assert found.length[0] == pytest.approx([np.log(2.0), 0.0, 3.0, 3.0])
    assert found.moving.tolist() == [[True, True, True, False], [False] * 4]


def agreement(*pairs):
    """Of controls with themselves, each of (cosine, length)."""
    cosine, length = (np.diag([float(pair[i]) for pair in pairs]) for i in (0, 1))
    return Agreement(cosine, length, np.ones(cosine.shape, dtype=bool))


def test_how_far_off_matches_are_is_told_by_the_middle_of_four_and_kept_within_limits():
    near, same = agreement(*[(0.9, 0.2), (0.8, 0.3), (0.7, 0.1), (0.95, 0.25)]), [(i, i) for i in range(4)]
    assert near._typical(same) == pytest.approx((0.15, 0.225))
    assert near._typical(same[:3]) == (0.4, 0.5)
    assert agreement(*[(1.0, 0.0)] * 4)._typical(same) == (0.005, 0.02)
    assert agreement(*[(0.0, 2.0)] * 4)._typical(same) == (0.4, 0.5)
    still = Agreement(near.cosine, near.length, np.eye(4) * [1, 1, 1, 0] > 0)
    assert still._typical(same) == (0.4, 0.5), "one of them moves nothing"


def test_what_two_makers_fields_say():
    """Parallel ones 1.8 + 12 x .4, and for what was sculpted anew 1.5 less; opposite ones no less than -4."""
    found = Agreement(np.array([[1.0, 1.0, -1.0]]), np.array([[0.0, 2.0, 0.0]]), np.ones((1, 3), dtype=bool))
    odds = found.evidence([])[0]
    assert odds[0] == pytest.approx(np.logaddexp(6.6, 5.1))
    assert odds[1] == pytest.approx(np.logaddexp(5.6, 4.1))
    assert odds[2] == -4.0
    assert Agreement(found.cosine, found.length, found.moving & [True, False, True]).evidence([])[0, 1] == 0.0


def test_copies_that_agree_say_more_and_lose_more_by_their_length():
    """Off by .1 instead of .4: (.4 / .1)^.7 times as steep; twice as even: a length costs twice as much."""
    found = agreement(*[(0.9, 0.25)] * 4)
    slope = 12.0 * 4.0**0.7
    close = 1.8 + 1.6 * np.log(4.0) - 1.0 * 0.25
    assert found.evidence([(i, i) for i in range(4)])[0, 0] == pytest.approx(np.logaddexp(close, 12 * 0.3 + 0.175))
    assert found.evidence([(i, i) for i in range(4)])[0, 1] == pytest.approx(
        max(np.logaddexp(close + 0.25 - 0.9 * slope, 12 * -0.6 + 0.3), -4.0)
    )


def at_one_point(other):
    return evidence._at_one_point(np.array([0.0, 2.0, 0.0]), np.array([other], dtype=float))[0]


def test_at_one_place_agreement_to_the_last_digit_says_most():
    assert at_one_point((0, 2, 0)) == pytest.approx(5.0 * 0.4 + 1.5 * np.log(0.3 / 0.01))
    assert at_one_point((0, 4, 0)) == pytest.approx(2.0 - 0.5 * np.log(2.0)), "half as far is not close"
    assert at_one_point((0, 2.5, 0)) == pytest.approx(2.0 - 0.5 * np.log(1.25) + 1.5 * np.log(0.3 / 0.21))
    assert at_one_point((0, -2, 0)) == -4.0
    assert at_one_point((2, 0, 0)) == pytest.approx(-3.0)
    assert at_one_point((0, 0, 0)) == 0.0


SURFACE = SimpleNamespace(
    points=np.array([[0.0, 0, 0], [0.0301, 0, 0], [0.0331, 0, 0], [0.5, 0, 0], [0.0, 0, 0]]),
    places=np.array([0, 1, 2, 3, 0]),
    areas=np.array([1.0, 1.0, 3.0, 1.0, 9.0]),
    face_size=1.0,
)
SCENE = SimpleNamespace(
    surface=SURFACE,
    motions=[
        SimpleNamespace(
            control=1,
            points=np.arange(5),
            polylines=SimpleNamespace(offsets=np.zeros((2, 5, 3))),
        )
    ],
)
"""Points in three cells of a grid of a sixtieth, the second of two points; the last is at the place of the first."""


def test_displacements_are_the_mean_over_cells_and_those_blurred_around_points():
    centre = 0.25 * 0.0301 + 0.75 * 0.0331
    second = 4.0 * np.exp(-0.5 * (centre / 0.03) ** 2)
    offsets = np.zeros((2, 5, 3))
    offsets[0, 0, 1], offsets[1, 0, 1] = -1.0, 2.0
    moving = SimpleNamespace(control=1, points=np.arange(5), polylines=SimpleNamespace(offsets=offsets))
    scene = SimpleNamespace(surface=SURFACE, motions=[moving])
    found = evidence._blurred((SimpleNamespace(controls="ab"), scene), np.array([[0.0, 0, 0]]))
    assert found == pytest.approx(np.array([[[0.0, 0, 0]], [[0.0, 3.0 / (1.0 + second), 0]]]))


def test_areas_are_never_nothing():
    scene = SimpleNamespace(areas=np.array([2.0, 0.0, 4.0]))
    assert evidence._areas(scene, np.array([0, 1])).tolist() == [2.0, 2e-6]
    assert evidence._areas(scene, np.array([1])).tolist() == [1.0]


def test_one_place_of_each_cell_is_sampled():
    assert evidence._thinned(SCENE, 1.0 / 60.0)[:, 0].tolist() == [0.0, 0.0301, 0.5]
    assert evidence._thinned(SCENE, 0.2)[:, 0].tolist() == [0.0, 0.5]


def test_what_controls_do_at_a_point_and_what_a_track_tells():
    offsets = np.array([[[0.0, 0, 1], [0, 0, 2]], [[1, 0, 0], [0, 5, 0]]])
    moving = SimpleNamespace(control=2, points=np.array([3, 5]), polylines=SimpleNamespace(offsets=offsets))
    assert evidence._at_point((moving,), 3, 5).tolist() == [[0, 0, 0], [0, 0, 0], [0, 5, -2]]
    assert not evidence._at_point((moving,), 3, 4).any()
    assert not evidence._at_point((moving,), 3, 6).any()
    track = np.array([[0.0, 0, 0], [1, 0, 0], [4, 0, 0]])
    assert evidence._displacement(SimpleNamespace(track=track, magnification=2.0)).tolist() == [2, 0, 0]
    assert evidence._displacement(SimpleNamespace(track=track, magnification=0.0)).tolist() == [4, 0, 0]
