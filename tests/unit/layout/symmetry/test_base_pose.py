"""A base pose that is not symmetric: pairs are still pairs, and stand on the face."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS


def pose(rig, **values):
    return np.array([values.get(control.name, control.default) for control in rig.controls])


@pytest.fixture(scope="module")
def rig():
    return makers.face()


def apart(face):
    """Distance of each point's partner from its exact mirror image."""
    points = face.surface.points
    return np.linalg.norm(face.symmetry.plane.reflected(points) - points[face.symmetry.partner], axis=1)


@pytest.mark.parametrize(("rig", "share"), [(makers.face(), 1.0), (makers.face(81, 101), 0.05)])
def test_a_one_sided_pose_keeps_partners_and_twins(rig, share):
    """Also where the mesh is so fine that every point of the pose still meets a mirror image, another one."""
    rest, one_sided = chain.face_of(rig), chain.face_of(rig, base_values=pose(rig, smile_L=share, brow_L=share))
    assert np.array_equal(one_sided.symmetry.partner, rest.symmetry.partner)
    assert np.array_equal(one_sided.symmetry.twins, rest.symmetry.twins)
    moved = np.linalg.norm(one_sided.trajectories.surface.points - rest.trajectories.surface.points, axis=1)
    assert apart(one_sided)[moved.argmax()] == pytest.approx(moved.max(), rel=1e-3)
    assert apart(one_sided)[moved == 0.0].min() < 1e-9


def test_pairs_stand_on_the_face_at_a_one_sided_pose(rig):
    values = pose(rig, smile_L=1.0)
    rest, line = chain.lay_out(rig), chain.lay_out(rig, base_values=values)
    assert not any(element.anchor.on_board for element in line.layout.elements)
    assert {element.name for element in line.layout.elements} == {element.name for element in rest.layout.elements}
    left, right = chain.by_name(line)["smile_L"].anchor, chain.by_name(line)["smile_R"].anchor
    assert line.face.symmetry.partner[left.point] == right.point


def test_the_plane_is_that_of_the_pose(rig):
    """A rigid motion of the whole face carries the plane along; the partners stay."""
    rig = makers.face_with(aside=np.tile([0.3, 0.0, 0.0], (len(POINTS), 1)))
    rest, aside = chain.face_of(rig), chain.face_of(rig, base_values=pose(rig, aside=1.0))
    assert abs(
        (aside.symmetry.plane.origin - rest.symmetry.plane.origin) @ rest.symmetry.plane.normal
    ) == pytest.approx(0.3, abs=1e-6)
    assert np.array_equal(aside.symmetry.partner, rest.symmetry.partner)
    assert apart(aside).max() < 1e-6
