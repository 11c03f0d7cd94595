"""Handles dragged on screen: sliders, curved sliders, patches, fans, joysticks and two-way sliders."""

import json

import numpy as np
import pytest
from folders import ROOT
from hypothesis import given, settings, strategies as st

from usdrigui.pose.drag import Axis, End, begin_drag, drag_to, values_at

SUITE = ROOT / "schemas" / "conformance"
VECTORS = {each["element"]: each for each in json.loads((SUITE / "drags.json").read_text("utf-8"))["questions"]}
ZERO_ONE = (0.0, 1.0)
EAST = np.array([[100.0, 100.0], [200.0, 100.0]])
RANGE = (0.0, 0.0, 1.0)


def taken(element, start):
    ranges = np.stack([element[name] for name in ("minimum", "default", "maximum")], axis=1)
    return begin_drag(element["tracks"], element["values"], element["axes"], ranges, element["base"], start)


@settings(deadline=None, max_examples=40)
@given(st.floats(0, 1), st.floats(0, 1), st.floats(0.2, 2.9))
def test_a_patch_inverts_its_own_handle(u, v, angle):
    other = np.array([[100.0, 100.0], [100.0 + 80 * np.cos(angle), 100.0 - 80 * np.sin(angle)]])
    drag = begin_drag([EAST, other], [ZERO_ONE] * 2, [[0], [1]], [RANGE] * 2, [0, 0], [0.5, 0.5])
    moved = (u - 0.5) * (EAST[1] - EAST[0]) + (v - 0.5) * (other[1] - other[0])
    assert values_at(drag, drag_to(drag, drag.start, moved)) == pytest.approx([u, v], abs=1e-3)


@pytest.mark.parametrize("name", [name for name, element in VECTORS.items() if len(element["axes"]) < 3])
def test_dragging_nowhere_changes_nothing(name):
    element = VECTORS[name]
    if name != "both ends set before":
        drag = taken(element, element["start"])
        assert values_at(drag, drag_to(drag, drag.start, (0.0, 0.0))) == pytest.approx(element["start"], abs=1e-6)


def test_members_that_are_not_dragged_come_back_to_the_base_pose_to_the_last_bit():
    element = {**VECTORS["fan"], "minimum": [-0.3] * 4, "base": [0.1] * 4}
    drag = taken(element, [0.7, 0.7, 0.0, 0.0])
    assert values_at(drag, drag_to(drag, drag.start, (-150.0, -100.0)))[:2].tolist() == [0.1, 0.1]


def test_a_track_that_is_partly_behind_the_viewer_is_refused():
    with pytest.raises(ValueError, match="behind"):
        begin_drag([[(0.0, 0.0), (np.nan, 0.0)]], [ZERO_ONE], [[0]], [RANGE], [0], [0])


def test_a_value_keeps_to_its_range_and_meets_the_base_pose_to_the_last_bit():
    end = End(0, -1.0, 100.0, 1100.0, 400.0)
    assert [end.value(at) for at in (0.5, 0.0, -0.5, -1.0, -1.4)] == [100.0, 100.0, 600.0, 1100.0, 1100.0]
    assert end.value(-0.3 - 5e-13) == 400.0 != end.value(-0.3 - 5e-12)
    assert [end.share(value) for value in (0.0, 100.0, 350.0, 1100.0, 1500.0)] == [0.0, 0.0, 0.25, 1.0, 1.0]
    assert End(0, 1.0, 2.0, 2.0, 2.0).share(3.0) == 0.0, "a range without length"


def test_the_arms_of_an_axis_part_where_the_base_pose_is():
    axis = Axis((), np.array([-1.0, 0.0, 0.5, 1.0]), np.zeros((4, 2)), 0.5)
    assert [arm.at.tolist() for arm in axis.arms()] == [[-1.0, 0.0, 0.5], [0.5, 1.0]]
    assert [arm.at.tolist() for arm in Axis((), axis.at, axis.points, -1.0).arms()] == [axis.at.tolist()]


@pytest.mark.parametrize(("x", "branch"), [(67.5, 1), (68.5, 3)])
def test_a_handle_leaves_its_branch_for_one_that_is_twice_as_near_and_four_pixels_besides(x, branch):
    """Down, across and up again, 100 pixels apart: at x = 68 it is 68 pixels from one and 32 from the other."""
    track = np.array([[0.0, 0], [0, 400], [100, 400], [100, 0]])
    drag = begin_drag([track], [(0.0, 1.0, 2.0, 3.0)], [[0]], [(0.0, 0.0, 3.0)], [0], [0.5])
    (value,) = values_at(drag, drag_to(drag, drag.start, (x, 0.0)))
    assert value == pytest.approx(0.5 if branch == 1 else 2.5, abs=1e-3)


def test_a_handle_falls_short_of_the_pointer_by_a_hair_on_a_short_track():
    """Where the range is 6 pixels long, by .02^2 / (6^2 + .02^2) of its way."""
    drag = begin_drag([[(0.0, 0.0), (6.0, 0.0)]], [ZERO_ONE], [[0]], [RANGE], [0], [0])
    assert drag_to(drag, drag.start, (3.0, 0.0))[0] == pytest.approx(0.5 * (1.0 - 0.0004 / 36.0004), abs=1e-9)
