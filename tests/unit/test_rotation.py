"""Rotations agree with USD's own and with each other."""

import numpy as np
from hypothesis import given, settings, strategies as st
from hypothesis.extra.numpy import arrays
from pxr import Gf

from usdrigui.character.rotation import (
    rotation_part,
    rotation_vectors,
    rotations,
)

vectors = arrays(np.float64, (3,), elements=st.floats(-1.8, 1.8))


@settings(deadline=None)
@given(vectors)
def test_vectors_turn_as_in_usd(vector):
    angle = float(np.linalg.norm(vector))
    axis = Gf.Vec3d(*vector.tolist()) if angle > 1e-8 else Gf.Vec3d(1, 0, 0)
    expected = np.array(Gf.Matrix3d(Gf.Rotation(axis, np.degrees(angle))))
    assert np.allclose(rotations(vector), expected, atol=1e-7)


@settings(deadline=None)
@given(vectors)
def test_vectors_come_back(vector):
    angle = np.linalg.norm(vector)
    shortest = vector if angle <= np.pi else vector * (1.0 - 2.0 * np.pi / angle)
    assert np.allclose(rotation_vectors(rotations(vector)), shortest, atol=1e-6)


def test_half_turns_about_every_axis():
    turns = np.pi * np.eye(3)
    assert np.allclose(rotations(turns)[0], np.diag([1.0, -1.0, -1.0]), atol=1e-12)
    assert np.allclose(np.abs(rotation_vectors(rotations(turns))), turns, atol=1e-7)


def test_rotation_part_of_a_sheared_matrix_is_a_rotation():
    rng = np.random.default_rng(0)
    local = np.tile(np.eye(4), (50, 1, 1))
    local[:, :3, :3] = rng.normal(size=(50, 3, 3))
    part = rotation_part(local)
    assert np.allclose(part @ np.swapaxes(part, -1, -2), np.eye(3), atol=1e-12)
    assert np.allclose(np.linalg.det(part), 1.0)
