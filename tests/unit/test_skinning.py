"""Both skinning methods equal `UsdSkel.SkinPoints` for joint matrices of every sort."""

import numpy as np
import pytest
from pxr import Gf, UsdSkel, Vt

from usdrigui.character import (
    Body,
    Joint,
    Rig,
    RigMesh,
    Skeleton,
    Skin,
    Topology,
)
from usdrigui.character.deform import deform, posed

COUNT, JOINTS, WIDTH = 60, 4, 3


def _rotation(rng):
    axis = Gf.Vec3d(*rng.normal(size=3))
    return np.array(Gf.Matrix3d(Gf.Rotation(axis, rng.uniform(-180, 180))))


def _linear(kind, rng, joint):
    turn = _rotation(rng)
    scales = rng.uniform(0.5, 2.0, 3)
    free = rng.normal(size=(3, 3))
    return {
        "rigid": turn,
        "uniform scale": turn * scales[0],
        "scale before rotation": np.diag(scales) @ turn,
        "scale after rotation": turn @ np.diag(scales),
        "shear": free * np.sign(np.linalg.det(free)),
        "mirrored": np.diag([-1.0, 1.0, 1.0]) @ turn,
        "one mirrored": (np.diag([-1.0, 1.0, 1.0]) if joint == 0 else np.eye(3)) @ turn,
        "one singular": (np.diag([1.0, 1.0, 0.0]) if joint == 0 else np.eye(3)) @ turn,
    }[kind]


KINDS = (
    "rigid",
    "uniform scale",
    "scale before rotation",
    "scale after rotation",
    "shear",
    "mirrored",
    "one mirrored",
    "one singular",
)


def _rig(points, matrices, joints, weights, method, geom_bind):
    """A rig whose skinning matrices are just `matrices`: bound at the origin, posed by them."""
    skin = Skin(joints, weights.astype(np.float32).astype(np.float64), method, geom_bind, rigid=False)
    none = np.zeros(0, dtype=np.int64)
    mesh = RigMesh("/R/M", points.astype(np.float64), Topology(none, none, False, ""), np.eye(4), skin)
    bones = tuple(Joint(str(i), 0, -1, np.eye(4), each, each) for i, each in enumerate(matrices))
    skeleton = Skeleton("/R/S", "", np.eye(4))
    up = np.array([0.0, 1.0, 0.0])
    body = Body((mesh,), (skeleton,), bones, (), np.zeros(0))
    return Rig("/R", up, 0.01, body, ())


@pytest.mark.parametrize("sums", ["normalised", "unnormalised"])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("method", ["classicLinear", "dualQuaternion"])
def test_skinning_equals_usdskel(method, kind, sums):
    rng = np.random.default_rng(11)
    matrices = np.tile(np.eye(4), (JOINTS, 1, 1))
    for joint in range(JOINTS):
        matrices[joint, :3, :3] = _linear(kind, rng, joint)
        matrices[joint, 3, :3] = rng.normal(size=3)
    joints = np.array([rng.permutation(JOINTS)[:WIDTH] for _ in range(COUNT)])
    weights = rng.dirichlet([1.0] * WIDTH, COUNT) * (1.0 if sums == "normalised" else rng.uniform(0.5, 1.5, (COUNT, 1)))
    points = rng.normal(size=(COUNT, 3)).astype(np.float32)
    bind = Gf.Matrix4d().SetRotate(Gf.Rotation(Gf.Vec3d(1, 2, 3), 40)) * Gf.Matrix4d().SetTranslate(Gf.Vec3d(1, 0, 2))
    expected = Vt.Vec3fArray.FromNumpy(points)
    assert UsdSkel.SkinPoints(
        method,
        bind,
        Vt.Matrix4dArray([Gf.Matrix4d(each.tolist()) for each in matrices]),
        Vt.IntArray(joints.ravel().tolist()),
        Vt.FloatArray(weights.ravel().tolist()),
        WIDTH,
        expected,
    )
    rig = _rig(points, matrices, joints, weights, method, np.array(bind))
    assert np.abs(deform(rig) - np.asarray(expected)).max() < 3e-6


def test_identical_matrices_share_one_map():
    """The short cut for a skeleton in its bind pose does not depend on how the weights are spread."""
    rng = np.random.default_rng(2)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[3, :3] = _rotation(rng), [1.0, 2.0, 3.0]
    joints = np.array([[0, 1, 2]] * COUNT)
    points = rng.normal(size=(COUNT, 3))
    weights = rng.dirichlet([1.0] * WIDTH, COUNT)
    for method in ("classicLinear", "dualQuaternion"):
        rig = _rig(points, matrix + 1e-12 * rng.normal(size=(JOINTS, 4, 4)), joints, weights, method, np.eye(4))
        (maps,) = posed(rig).maps
        assert len(maps) == 1
        assert np.allclose(points @ maps[0, :3] + maps[0, 3], points @ matrix[:3, :3] + matrix[3, :3], atol=1e-6)
