"""Which neighbours in a fan span a parallelogram: those at half a turn or less (paper section 3.2)."""

from types import SimpleNamespace

import numpy as np
import pytest

from usdrigui.layer import drawn
from usdrigui.layout.element.fans import fan_order

UP = np.array([0.0, 0.0, 1.0])


def at(*degrees, lift=0.0):
    turn = np.radians(degrees)
    return np.stack([np.cos(turn), np.sin(turn), np.full(len(turn), lift)], axis=1)


@pytest.mark.parametrize("lift", [0.0, 0.7], ids=["in-the-plane", "out-of-it"])
@pytest.mark.parametrize(
    ("degrees", "expected"),
    [
        ((0, 60, 120), {(0, 1), (1, 2)}),
        ((120, 0, 60), {(1, 2), (2, 0)}),
        ((0, 120, 240), {(0, 1), (1, 2), (2, 0)}),
        ((0, 200), {(1, 0)}),
        ((10, 100, 150, 185), {(0, 1), (1, 2), (2, 3)}),
        ((10, 100, 150, 195), {(0, 1), (1, 2), (2, 3), (3, 0)}),
    ],
)
def test_only_neighbours_at_half_a_turn_or_less_span_a_parallelogram(degrees, expected, lift):
    tracks = [SimpleNamespace(track=np.stack([np.zeros(3), way])) for way in at(*degrees, lift=lift)]
    anchor = SimpleNamespace(position=np.zeros(3), normal=UP)
    fan = SimpleNamespace(anchor=anchor, manipulator=SimpleNamespace(members=tracks, axes=()))
    assert set(drawn._neighbours(fan)) == expected


def test_the_order_runs_round_and_begins_behind_the_widest_gap():
    assert fan_order(at(300, 20, 80), UP) == (0, 1, 2)
    assert fan_order(at(80, 300, 20), UP) == (1, 2, 0)


def test_fans_are_ordered_by_angle():
    normal = np.array([0.0, 0.0, 1.0])
    angles = np.radians([200.0, 10.0, 100.0, 60.0])
    tangents = np.stack([np.cos(angles), np.sin(angles), np.full(4, 0.7)], axis=1)
    order = fan_order(tangents, normal)
    assert order == (1, 3, 2, 0)
