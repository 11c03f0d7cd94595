"""Which neighbours in a fan span a parallelogram: those at half a turn or less (paper section 3.2)."""

import numpy as np

from usdrigui.layout.element.fans import fan_order

UP = np.array([0.0, 0.0, 1.0])


def at(*degrees, lift=0.0):
    turn = np.radians(degrees)
    return np.stack([np.cos(turn), np.sin(turn), np.full(len(turn), lift)], axis=1)


def test_the_order_runs_round_and_begins_behind_the_widest_gap():
    assert fan_order(at(300, 20, 80), UP) == (0, 1, 2)
    assert fan_order(at(80, 300, 20), UP) == (1, 2, 0)


def test_fans_are_ordered_by_angle():
    normal = np.array([0.0, 0.0, 1.0])
    angles = np.radians([200.0, 10.0, 100.0, 60.0])
    tangents = np.stack([np.cos(angles), np.sin(angles), np.full(4, 0.7)], axis=1)
    assert fan_order(tangents, normal) == (1, 3, 2, 0)
