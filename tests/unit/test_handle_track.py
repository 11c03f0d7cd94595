"""How drawings go with their anchors and handles slide on tracks, worked out by hand."""

import numpy as np
import pytest

from usdrigui.pose.handle_track import along, carried, facing, slid

KNOTS = np.array([0.0, 1.0, 3.0])
CORNER = np.array([[0.0, 0, 0], [2, 0, 0], [2, 4, 0]])


@pytest.mark.parametrize(
    ("value", "place"),
    [
        (-1, (-2, 0, 0)),
        (0, (0, 0, 0)),
        (0.5, (1, 0, 0)),
        (1, (2, 0, 0)),
        (2, (2, 2, 0)),
        (3, (2, 4, 0)),
        (4, (2, 6, 0)),
    ],
)
def test_a_point_goes_along_its_track_and_straight_on_beyond_both_ends(value, place):
    assert along(KNOTS, CORNER, value) == pytest.approx(place)


def test_a_handle_adds_its_members_moves_to_where_the_first_stands():
    """The first from 0 to 1 (two to the right), the second from 1 to 2 (two up)."""
    for values, places in (
        (([0.0, 1.0], [1.0, 2.0]), [(0, 0, 0), (2, 2, 0)]),
        (([1.0, 0.0], [1.0, 0.5]), [(2, 0, 0), (3, 0, 0)]),
    ):
        assert np.array(slid([KNOTS, KNOTS], [CORNER, CORNER], *values)) == pytest.approx(np.array(places))


def test_a_normal_stays_across_its_skin_when_that_is_stretched():
    """A slope of 45 degrees, twice as high: its normal (0, -1, 1) becomes (0, -1, 0.5)."""
    stretched = np.diag([1.0, 1.0, 2.0])
    assert facing(np.array([0.0, -3.0, 3.0]), stretched) == pytest.approx(np.array([0.0, -2.0, 1.0]) / np.sqrt(5.0))
    assert facing(np.array([0.0, 0.0, 2.0]), np.zeros((3, 3))) == pytest.approx((0, 0, 0)), "nothing is left of it"


def test_what_is_drawn_about_a_place_goes_with_its_anchor():
    turn = np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    points = carried(np.array([[3.0, 1, 0]]), np.array([1.0, 1, 0]), np.array([5.0, 5, 5]), turn)
    assert points == pytest.approx(np.array([[5.0, 7, 5]]))
