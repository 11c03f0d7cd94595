"""Skinning as UsdSkel does it: joint matrices, influences, and the affine map of each point.

Linear skinning and dual-quaternion skinning alike give, at a fixed pose, one affine map for each
point, which is what makes blend-shape trajectories under any skin exact polylines.
numpy and scipy only.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial.transform import Rotation

from usdrigui.character import Body, Flags, Floats, Indices, Joint, RigMesh, Skin
from usdrigui.character.record import freeze
from usdrigui.character.rotation import (
    quaternion_product,
    quaternions,
    rotation_part,
)

SAME = 1e-8
"""Skinning matrices that differ by less (translations: relative to the mesh) are taken for
equal."""
_KEPT = 8
"""Tuples of joints of which what does not change is kept: a character is asked for it by each step
of each of its controls."""
_FACE_SHARE = 0.9
"""Share of the points' influence that lies on the joint that carries a face, and below it."""


def skinning_matrices(joints: tuple[Joint, ...], local: Floats) -> Floats:
    """(..., joints, 4, 4) inverse bind times pose, in skeleton space, for local transforms of that
    shape."""
    return _inverse_binds(joints) @ in_skeleton_space(joints, local)


def in_skeleton_space(joints: tuple[Joint, ...], local: Floats) -> Floats:
    """(..., joints, 4, 4) local transforms times those of all joints above, one generation after
    the other."""
    pose, parents = local.copy(), parents_of(joints)
    for ready in _generations(joints):
        pose[..., ready, :, :] = local[..., ready, :, :] @ pose[..., parents[ready], :, :]
    return pose


@lru_cache(_KEPT)
def _generations(joints: tuple[Joint, ...]) -> tuple[Indices, ...]:
    """Those with one joint above them, those with two, and on."""
    depth = descendants(joints).sum(axis=0)
    return tuple(np.flatnonzero(depth == count) for count in range(2, 1 + depth.max(initial=0)))


@lru_cache(_KEPT)
def parents_of(joints: tuple[Joint, ...]) -> Indices:
    """(joints,) the joint above each, -1 for roots."""
    return np.asarray(freeze(np.array([joint.parent for joint in joints], dtype=np.int64)))


def under_parents(world: Floats, parents: Indices) -> Floats:
    """(joints, 4, 4) local transforms of those in skeleton space; -1 is the parent of a root."""
    local, inner = world.copy(), np.flatnonzero(parents >= 0)
    local[inner] = world[inner] @ np.linalg.inv(world[parents[inner]])
    return local


@lru_cache(_KEPT)
def bind_poses(joints: tuple[Joint, ...]) -> Floats:
    """(joints, 4, 4) bind transforms in skeleton space."""
    return np.asarray(freeze(np.array([joint.bind for joint in joints]).reshape(-1, 4, 4)))


@lru_cache(_KEPT)
def _inverse_binds(joints: tuple[Joint, ...]) -> Floats:
    return np.asarray(freeze(np.linalg.inv(bind_poses(joints))))


def at_bind_pose(body: Body) -> Body:
    """The body whose base pose is the one in which its skin was bound; `body` itself where it
    is."""
    joints = body.joints
    local = under_parents(bind_poses(joints), parents_of(joints))
    if np.allclose(local, base_locals(joints), atol=1e-4):
        return body
    turned = tuple(replace(joint, base=at) for at, joint in zip(local, joints, strict=True))
    return replace(body, joints=turned)


@lru_cache(_KEPT)
def base_locals(joints: tuple[Joint, ...]) -> Floats:
    """(joints, 4, 4) local transforms in the base pose."""
    return np.asarray(freeze(np.array([joint.base for joint in joints]).reshape(-1, 4, 4)))


@lru_cache(_KEPT)
def base_frames(joints: tuple[Joint, ...]) -> Floats:
    """(joints, 3, 3) rotations of `base_locals`."""
    return np.asarray(freeze(rotation_part(base_locals(joints))))


@lru_cache(_KEPT)
def descendants(joints: tuple[Joint, ...]) -> Flags:
    """(joints, joints) whether the second of two joints is the first or hangs below it."""
    found = np.eye(len(joints), dtype=bool)
    for i, joint in enumerate(joints):
        if joint.parent >= 0:
            found[:, i] |= found[:, joint.parent]
    return np.asarray(freeze(found))


def point_maps(
    body: Body, mesh: RigMesh, skinning: Floats, local: Indices | slice = slice(None)
) -> Floats:
    """Affine maps (1 or p, 4, 3) of the `local` points from mesh space to root space."""
    skin = mesh.skin
    if skin is None:
        return mesh.to_root[None, :, :3]
    rows = slice(1) if skin.rigid else local
    size = float(np.abs(mesh.points).max(initial=1e-30))
    skinned = _shared_or_own_maps(skin, rows, skinning, size)
    to_root = body.skeletons[body.skeleton_of(skin)].to_root
    return _composed(_composed(skin.geom_bind[None, :, :3], skinned), to_root[None, :, :3])


def bound_points(points: Floats, skin: Skin) -> Floats:
    """(n, 4) homogeneous points after geomBindTransform."""
    bound = np.ones((len(points), 4))
    bound[:, :3] = points @ skin.geom_bind[:3, :3] + skin.geom_bind[3, :3]
    return bound


def carrying_joint(body: Body, rows: Indices) -> int:
    """The deepest joint on which, with the joints below it, `_FACE_SHARE` of the influence on
    points `rows` (q,) lies.

    -1 where there is none.  By it the joint of a face is found without names.
    """
    share: Floats = np.zeros(len(body.joints))
    for row in rows.tolist():
        mesh, local = body.mesh_of(row)
        if mesh.skin is not None:
            np.add.at(share, mesh.skin.joints[local], mesh.skin.weights[local])
    total = float(share.sum())
    if not total > 0.0:
        return -1
    for i in range(len(body.joints) - 1, -1, -1):
        if body.joints[i].parent >= 0:
            share[body.joints[i].parent] += share[i]
    # Each of them lies below the one before: two that do not hold no such share both.
    carrying = np.flatnonzero(share >= _FACE_SHARE * total)
    return int(carrying[-1] if len(carrying) else share.argmax())


def applied(points: Floats, maps: Floats) -> Floats:
    """Points (p, 3) under affine maps (1 or p, 4, 3)."""
    if len(maps) == 1:
        return np.asarray(points @ maps[0, :3] + maps[0, 3])
    return np.asarray(np.einsum("pi,pij->pj", points, maps[:, :3]) + maps[:, 3])


def _shared_or_own_maps(skin: Skin, rows: Indices | slice, skinning: Floats, size: float) -> Floats:
    """Maps (1 or p, 4, 3) of the bound points `rows` into skeleton space."""
    joints, weights = skin.joints[rows], skin.weights[rows]
    used = np.flatnonzero(
        np.bincount(joints.ravel(), weights=np.abs(weights).ravel(), minlength=len(skinning))
    )
    if len(used) == 0:
        return np.zeros((1, 4, 3))
    scale = np.array([1.0, 1.0, 1.0, size])[:, None]
    deviation = np.abs(skinning[used, :, :3] - skinning[used[0], :, :3]) / scale
    unit = np.abs(weights.sum(axis=1) - 1.0).max() <= 1e-6
    if unit and deviation.max() <= SAME:
        return skinning[used[:1], :, :3]
    if skin.method == "dualQuaternion":
        return _dual_quaternion_maps(joints, weights, skinning)
    return _weighted(weights, joints, skinning[:, :, :3])


def _weighted(weights: Floats, joints: Indices, tables: Floats) -> Floats:
    """Sum over influences: (p, ...) of weights (p, k) times tables (joints, ...) at joints (p,
    k)."""
    flat, ends = tables.reshape(len(tables), -1), np.arange(0, joints.size + 1, joints.shape[1])
    shape = (len(joints), len(flat))
    total = csr_array((weights.ravel(), joints.ravel(), ends), shape=shape) @ flat
    return np.asarray(total.reshape(len(joints), *tables.shape[1:]))


def _composed(first: Floats, second: Floats) -> Floats:
    """Affine maps (p, 4, 3) that apply `first`, then `second`; either may be a single one."""
    linear = first @ second[:, :3]
    linear[:, 3] += second[:, 3]
    return linear


def _dual_quaternion_maps(joints: Indices, weights: Floats, skinning: Floats) -> Floats:
    """Dual-quaternion skinning (Kavan et al. 2007) as affine maps (p, 4, 3) into skeleton space.

    As in UsdSkel the scale and shear of the joints, if any has some, are blended linearly and act
    first; rotations and translations are blended as dual quaternions, each turned to the hemisphere
    of the joint of largest weight; a joint whose matrix is singular takes no part in them.
    """
    frame = rotation_part(skinning)
    scale = skinning[:, :3, :3] @ np.swapaxes(frame, -1, -2)
    real = quaternions(frame)
    dual = 0.5 * quaternion_product(np.insert(skinning[:, 3, :3], 0, 0.0, axis=-1), real)
    singular = np.linalg.svd(skinning[:, :3, :3], compute_uv=False)[:, -1] < 1e-5
    scale[singular], real[singular], dual[singular] = np.eye(3), 0.0, 0.0
    stretch = np.broadcast_to(np.eye(3), (len(joints), 3, 3))
    if np.abs(scale[joints[weights != 0.0]] - np.eye(3)).max(initial=0.0) > 1e-6:
        stretch = _weighted(weights, joints, scale)
    pivot = joints[np.arange(len(joints)), weights.argmax(axis=1)]
    signs = np.where(np.einsum("pki,pi->pk", real[joints], real[pivot]) < 0.0, -1.0, 1.0)
    blend = _weighted(weights * signs, joints, np.concatenate([real, dual], axis=1))
    blend[~blend[:, :4].any(axis=1), 0] = 1.0
    real, dual = np.hsplit(blend / np.linalg.norm(blend[:, :4], axis=1, keepdims=True), 2)
    conjugate = real * np.array([1.0, -1.0, -1.0, -1.0])
    maps = np.empty((len(joints), 4, 3))
    # Of the other way, for row vectors; the real part comes last there.
    maps[:, :3] = stretch @ Rotation.from_quat(np.roll(conjugate, -1, axis=1)).as_matrix()
    maps[:, 3] = 2.0 * quaternion_product(dual, conjugate)[:, 1:]
    return maps
