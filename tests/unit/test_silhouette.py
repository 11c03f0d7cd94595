"""Outlines of painted triangles: where they run, what they leave out, and that they are always the same."""

from __future__ import annotations

import numpy as np
import pytest

from usdrigui.view.silhouette import silhouette

LOW, HIGH = np.array([0.0, 0.0]), np.array([10.0, 10.0])


def squares(*boxes):
    """Points and triangles of axis-parallel squares (left, top, right, bottom)."""
    points, corners = [], []
    for left, top, right, bottom in boxes:
        start = len(points)
        points += [(left, top), (right, top), (right, bottom), (left, bottom)]
        corners += [(start, start + 1, start + 2), (start, start + 2, start + 3)]
    return np.array(points, dtype=np.float64), np.array(corners)


def area(loop):
    x, y = loop.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def test_a_square_comes_back_with_few_vertices():
    (loop,) = silhouette(*squares((2, 3, 6, 9)), LOW, HIGH)
    assert len(loop) < 20
    assert loop.min(axis=0) == pytest.approx([2.0, 3.0], abs=0.06)
    assert loop.max(axis=0) == pytest.approx([6.0, 9.0], abs=0.06)
    assert area(loop) == pytest.approx(24.0, rel=0.02)


def test_a_frame_has_a_hole_and_two_pieces_two_outlines():
    frame = squares((1, 1, 9, 3), (1, 7, 9, 9), (1, 1, 3, 9), (7, 1, 9, 9))
    assert sorted(area(loop) for loop in silhouette(*frame, LOW, HIGH)) == pytest.approx([16.0, 64.0], rel=0.03)
    assert len(silhouette(*squares((1, 1, 4, 4), (6, 6, 9, 9)), LOW, HIGH)) == 2


def test_squares_that_meet_at_a_corner_stay_closed_outlines():
    loops = silhouette(*squares((1, 1, 5, 5), (5, 5, 9, 9)), LOW, HIGH)
    assert sum(area(loop) for loop in loops) == pytest.approx(32.0, rel=0.04)


def test_specks_and_what_lies_outside_are_left_out():
    assert len(silhouette(*squares((2, 2, 6, 6), (8, 8, 8.1, 8.1)), LOW, HIGH)) == 1
    assert silhouette(*squares((20, 20, 30, 30)), LOW, HIGH) == ()
    assert silhouette(np.zeros((0, 2)), np.zeros((0, 3), dtype=np.int64), LOW, HIGH) == ()


def test_the_rectangle_cuts_and_unposed_points_do_not_spoil_it():
    points, corners = squares((5, 5, 50, 50), (1, 1, 2, 2))
    points[4:] = np.nan
    (loop,) = silhouette(points, corners, LOW, HIGH)
    assert loop.max(axis=0) == pytest.approx([10.0, 10.0], abs=0.06)


def test_the_same_triangles_in_another_order_give_the_same_outline():
    points, corners = squares((1, 2, 5, 8), (4, 3, 9, 6))
    one, other = silhouette(points, corners, LOW, HIGH), silhouette(points, corners[::-1], LOW, HIGH)
    assert all((a == b).all() for a, b in zip(one, other, strict=True))
