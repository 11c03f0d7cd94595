"""Handles dragged on screen: sliders, curved sliders, patches, fans, joysticks and two-way sliders."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from usdrigui.pose.drag import LEAST, drag, held_at, pairs

ZERO_ONE = np.array([0.0, 1.0])
EAST, NORTH, WEST, SOUTH = (
    np.array([[100.0, 100.0], end], dtype=np.float64)
    for end in ((200.0, 100.0), (100.0, 0.0), (0.0, 100.0), (100.0, 200.0))
)


def one(track, values, current, pointer, base=0.0):
    return float(drag([track], [values], [base], [current], pointer)[0])


@pytest.mark.parametrize(("x", "expected"), [(150, 0.5), (100, 0.0), (400, 1.0), (-50, 0.0)])
def test_a_slider_follows_the_pointer_within_its_range(x, expected):
    assert one(EAST, ZERO_ONE, 0.2, (x, 130.0)) == pytest.approx(expected)


def test_a_slider_of_signed_range_goes_both_ways():
    track = np.array([[0.0, 100.0], [100.0, 100.0], [200.0, 100.0]])
    assert one(track, [-1.0, 0.0, 1.0], 0.0, (40.0, 90.0)) == pytest.approx(-0.6)
    assert one(track, [-1.0, 0.0, 1.0], 0.0, (180.0, 90.0)) == pytest.approx(0.8)


HAIRPIN = np.array([[0.0, 0.0], [100.0, 0.0], [110.0, 10.0], [100.0, 20.0], [0.0, 20.0]])
AT = np.linspace(0.0, 1.0, 5)


def test_a_curved_slider_does_not_jump_to_the_branch_across():
    # The pointer is a little nearer to the far branch; the handle stays on the branch it is on.
    assert one(HAIRPIN, AT, 0.1, (50.0, 11.0)) == pytest.approx(0.125)
    assert one(HAIRPIN, AT, 0.9, (50.0, 9.0)) == pytest.approx(0.875)


def test_a_curved_slider_goes_round_the_bend_step_by_step():
    value = 0.1
    for pointer in ((60, 2), (90, 0), (105, 4), (110, 10), (105, 17), (90, 20), (50, 20)):
        value = one(HAIRPIN, AT, value, pointer)
    assert value == pytest.approx(0.875)


def test_a_curved_slider_changes_branch_for_one_that_is_nearer_by_far():
    assert one(HAIRPIN, AT, 0.1, (50.0, 19.5)) == pytest.approx(0.875)


@settings(deadline=None, max_examples=40)
@given(st.floats(0, 1), st.floats(0, 1), st.floats(0.2, 2.9))
def test_a_patch_inverts_its_own_handle(u, v, angle):
    other = np.array([[100.0, 100.0], [100.0 + 80 * np.cos(angle), 100.0 - 80 * np.sin(angle)]])
    pointer = EAST[0] + u * (EAST[1] - EAST[0]) + v * (other[1] - other[0])
    found = drag([EAST, other], [ZERO_ONE, ZERO_ONE], [0, 0], [0.5, 0.5], pointer)
    assert found == pytest.approx([u, v], abs=1e-3)


def test_a_patch_goes_to_its_border_outside():
    assert drag([EAST, NORTH], [ZERO_ONE, ZERO_ONE], [0, 0], [0, 0], (300.0, 50.0)) == pytest.approx(
        [1.0, 0.5], abs=1e-3
    )


def test_curved_patches_are_inverted_too():
    bend = np.array([[100.0, 100.0], [150.0, 90.0], [180.0, 60.0]])
    values = np.array([0.0, 0.5, 1.0])
    pointer = bend[2] * 0.4 + bend[1] * 0.6 + 0.7 * (SOUTH[1] - SOUTH[0])
    assert drag([bend, SOUTH], [values, ZERO_ONE], [0, 0], [0, 0], pointer) == pytest.approx([0.7, 0.7], abs=1e-3)


def fan(*degrees):
    return [
        np.array([[0.0, 0.0], [100 * np.cos(np.radians(each)), -100 * np.sin(np.radians(each))]]) for each in degrees
    ]


def test_a_fan_takes_the_two_members_on_either_side_of_the_pointer():
    tracks = fan(10, 50, 90, 130)
    pointer = 0.6 * tracks[1][1] + 0.3 * tracks[2][1]
    found = drag(tracks, [ZERO_ONE] * 4, np.zeros(4), np.zeros(4), pointer)
    assert found == pytest.approx([0, 0.6, 0.3, 0], abs=1e-3)
    back = drag(tracks, [ZERO_ONE] * 4, np.zeros(4), found, 0.5 * tracks[3][1])
    assert back == pytest.approx([0, 0, 0, 0.5], abs=1e-3)


def test_neighbours_are_found_by_angle_whatever_the_order():
    order = [2, 0, 3, 1]
    tracks = [fan(10, 50, 90, 130)[i] for i in order]
    found = pairs(tracks, [ZERO_ONE] * 4, np.zeros(4))
    assert {frozenset((order[i], order[j])) for i, j in (pair for pair in found if len(pair) == 2)} == {
        frozenset((0, 1)),
        frozenset((1, 2)),
        frozenset((2, 3)),
    }


def test_a_joystick_sets_one_of_each_opposed_pair():
    tracks, values = [WEST, EAST, SOUTH, NORTH], [ZERO_ONE] * 4
    assert drag(tracks, values, np.zeros(4), np.zeros(4), (60.0, 30.0)) == pytest.approx([0.4, 0, 0, 0.7], abs=1e-3)
    assert drag(tracks, values, np.zeros(4), [0.4, 0, 0, 0.7], (130.0, 180.0)) == pytest.approx(
        [0, 0.3, 0.8, 0], abs=1e-3
    )


def test_a_two_way_slider_sets_one_end_and_clears_the_other():
    assert drag([WEST, EAST], [ZERO_ONE] * 2, [0, 0], [0, 0.5], (70.0, 120.0)) == pytest.approx([0.3, 0], abs=1e-3)
    assert drag([WEST, EAST], [ZERO_ONE] * 2, [0, 0], [0.3, 0.0], (160.0, 80.0)) == pytest.approx([0, 0.6], abs=1e-3)


def test_values_come_back_to_base_and_not_to_zero():
    tracks = fan(0, 90, 200)
    found = drag(tracks, [ZERO_ONE] * 3, [0.2, 0.2, 0.2], [0.2, 0.2, 0.2], (0.2 * sum(t[1] for t in tracks)) * 0)
    assert np.sum(np.abs(found - 0.2) > 1e-6) <= 2


def test_a_track_seen_from_its_end_can_still_be_dragged():
    point = np.array([[50.0, 50.0], [50.0, 50.0]])
    assert one(point, ZERO_ONE, 0.0, (50.0, 50.0 - LEAST / 2)) == pytest.approx(0.5)
    assert one(point, ZERO_ONE, 0.5, (50.0, 60.0)) == pytest.approx(0.0)
    short = np.array([[50.0, 50.0], [52.0, 50.0]])
    assert one(short, ZERO_ONE, 0.0, (50.0 + LEAST / 4, 70.0)) == pytest.approx(0.25)
    backwards = np.array([[52.0, 50.0], [50.0, 50.0]])
    assert one(backwards, ZERO_ONE, 0.0, (52.0 - LEAST / 4, 70.0)) == pytest.approx(0.25)


def test_what_is_held_is_where_dragging_nowhere_changes_nothing():
    for tracks, current in (
        ([EAST], [0.3]),
        ([EAST, NORTH], [0.2, 0.7]),
        ([WEST, EAST, SOUTH, NORTH], [0, 0.4, 0.1, 0]),
    ):
        values, base = [ZERO_ONE] * len(tracks), np.zeros(len(tracks))
        held = held_at(tracks, values, base, current)
        assert drag(tracks, values, base, current, held) == pytest.approx(current, abs=1e-4)
    assert held_at([EAST], [ZERO_ONE], [0.0], [0.3]) == pytest.approx([130.0, 100.0])


def test_refuses_records_that_do_not_fit_together():
    with pytest.raises(ValueError, match="track"):
        drag([], [], [], [], (0, 0))
    with pytest.raises(ValueError, match="track"):
        drag([EAST], [[0.0, 0.5, 1.0]], [0], [0], (0, 0))
    with pytest.raises(ValueError, match="ascending"):
        drag([EAST], [[1.0, 0.0]], [0], [0], (0, 0))
    with pytest.raises(ValueError, match="one value per member"):
        drag([EAST], [ZERO_ONE], [0, 0], [0, 0], (0, 0))
    with pytest.raises(ValueError, match="finite"):
        drag([EAST], [ZERO_ONE], [0], [0], (np.nan, 0))
    with pytest.raises(ValueError, match="one value per member"):
        held_at([EAST], [ZERO_ONE], [0, 1], [0])
