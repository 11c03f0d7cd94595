"""Handles dragged on screen: sliders, curved sliders, patches, fans, joysticks and two-way sliders."""

from __future__ import annotations

import drag_vectors
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from usdrigui.pose.drag import begin_drag, drag_to, values_at

VECTORS = drag_vectors.vectors()
ZERO_ONE = (0.0, 1.0)
EAST = np.array([[100.0, 100.0], [200.0, 100.0]])
RANGE = (0.0, 0.0, 1.0)


def taken(element, start):
    ranges = np.stack([element[name] for name in ("minimum", "default", "maximum")], axis=1)
    return begin_drag(element["tracks"], element["values"], element["axes"], ranges, element["base"], start)


@pytest.mark.parametrize("name", VECTORS)
def test_drags_on_the_vectors_that_all_clients_run(name):
    element = VECTORS[name]
    assert element["drags"]
    for path in element["drags"]:
        drag = taken(element, path["start"])
        at = drag.start
        for step in path["steps"]:
            at = drag_to(drag, at, step["to"])
            drag_vectors.check(element, step, values_at(drag, at).tolist())


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
    start = drag_vectors.values_at(element, [0.3] * len(element["axes"]))
    drag = taken(element, start)
    assert values_at(drag, drag_to(drag, drag.start, (0.0, 0.0))) == pytest.approx(start, abs=1e-6)


def test_members_that_are_not_dragged_come_back_to_the_base_pose_to_the_last_bit():
    element = {**VECTORS["fan"], "minimum": [-0.3] * 4, "base": [0.1] * 4}
    drag = taken(element, [0.7, 0.7, 0.0, 0.0])
    assert values_at(drag, drag_to(drag, drag.start, (-150.0, -100.0)))[:2].tolist() == [0.1, 0.1]


def test_refuses_records_that_do_not_fit_together():
    good = {
        "tracks": [EAST],
        "values": [ZERO_ONE],
        "axes": [[0]],
        "ranges": [RANGE],
        "base": [0],
        "current": [0],
    }
    for wrong, message in (
        ({"tracks": [], "values": []}, "track"),
        ({"values": [[0.0, 0.5, 1.0]]}, "track"),
        ({"values": [[1.0, 0.0]]}, "ascending"),
        ({"base": [0, 0]}, "one value"),
        ({"ranges": [ZERO_ONE]}, "range"),
        ({"axes": [[0], [0]]}, "one axis"),
        ({"current": [np.nan]}, "finite"),
    ):
        with pytest.raises(ValueError, match=message):
            begin_drag(**{**good, **wrong})
    drag = begin_drag(**good)
    for at, moved in (([0.0, 0.0], (0, 0)), ([0.0], (np.nan, 0))):
        with pytest.raises(ValueError, match="coordinate"):
            drag_to(drag, at, moved)
