"""Choices among equals: the same whatever the last bits are."""

import chain
import makers
import numpy as np
import pytest

from usdrigui import ties
from usdrigui.layer.drawn import in_steps


@pytest.mark.parametrize("seed", range(4))
def test_of_equals_the_first_is_taken(seed):
    def noisy(values):
        return np.asarray(values) * (1.0 + 4e-16 * np.random.default_rng(seed).integers(-1, 2, len(values)))

    assert ties.first_largest(noisy([0.2, 0.7, 0.7, 0.7])) == 1
    assert ties.first_smallest(noisy([0.7, 0.2, 0.2])) == 1
    assert ties.axis_across(noisy([0.6, 0.6, 0.6])).tolist() == [1.0, 0.0, 0.0]
    assert np.argsort(ties.rounded(noisy([0.3, 0.1, 0.3, 0.1])), kind="stable").tolist() == [1, 3, 0, 2]
    nothing = 1e-17 * np.random.default_rng(seed).normal(size=3) * [1.0, 0.0, 0.0]
    assert ties.towards(np.array([-1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]) + nothing).tolist() == [1.0, 0.0, 0.0]


def test_a_clear_choice_is_left_alone():
    assert ties.first_largest(np.array([1.0, 1.0 + 1e-8])) == 1
    assert ties.towards(np.array([1.0, 0.0, 0.0]), np.array([-1e-6, 1.0, 0.0])).tolist() == [-1.0, 0.0, 0.0]
    assert ties.rounded(np.zeros(2)).tolist() == [0.0, 0.0]


def choices(rig):
    """Everything about a layout that is no number."""
    line = chain.lay_out(rig)
    return [
        (
            each.name,
            each.kind,
            each.anchor.point,
            each.anchor.on_board,
            each.mirror,
            each.axes,
            each.reason,
        )
        for each in line.layout.elements
    ]


@pytest.mark.parametrize("seed", range(2))
def test_noise_in_the_last_bits_changes_no_layout(seed):
    """A face symmetric to the last bit, and the same as another processor would pose it."""
    rng = np.random.default_rng(seed)
    turn = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]
    for face in (makers.face(17, 21), makers.moved(makers.face(17, 21), turn)):
        points = face.body.meshes[0].points
        noise = 1e-16 * np.abs(points).max() * rng.integers(-2, 3, points.shape)
        assert choices(makers.moved(face, np.eye(3), noise)) == choices(face)


def test_what_is_drawn_is_written_without_its_last_digits():
    written = in_steps(np.array([24484.791, 9.1e-13, 0.25, -5.6e-17, 1e-4]), 1e-5)
    assert written.tolist() == [24484.791, 0.0, 0.25, 0.0, 1e-4]
