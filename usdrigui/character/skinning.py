"""Skinning as UsdSkel does it: joint matrices, influences, and the affine map of each point.

Linear skinning and dual-quaternion skinning alike give, at a fixed pose, one affine map for each
point, which is what makes blend-shape trajectories under any skin exact polylines.  numpy only.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from usdrigui.character import Body, Floats, Indices, Joint, RigMesh, Skeleton, Skin
from usdrigui.character.rotation import (
    quaternion_matrices,
    quaternion_product,
    quaternions,
    rotation_part,
)

SAME = 1e-8
"""Skinning matrices that differ by less (translations: relative to the mesh) are taken for
equal."""
_FACE_SHARE = 0.9
"""Share of the points' influence that lies on the joint that carries a face, and below it."""


def skinning_matrices(joints: tuple[Joint, ...], local: Floats) -> Floats:
    """(..., joints, 4, 4) inverse bind times pose, in skeleton space, for local transforms of that
    shape."""
    pose = local.copy()
    for i, joint in enumerate(joints):
        if joint.parent >= 0:
            pose[..., i, :, :] = local[..., i, :, :] @ pose[..., joint.parent, :, :]
    bind = np.array([joint.bind for joint in joints], dtype=np.float64).reshape(-1, 4, 4)
    return np.asarray(np.linalg.inv(bind) @ pose, dtype=np.float64)


def point_maps(body: Body, mesh: RigMesh, skinning: Floats, local: Indices | None = None) -> Floats:
    """Affine maps (1 or p, 4, 3) of the `local` points (all if None) from mesh space to root
    space."""
    if mesh.binding.skin is None:
        return mesh.binding.to_root[None, :, :3]
    skin = mesh.binding.skin
    joints, weights = (
        (skin.joints, skin.weights) if local is None else (skin.joints[local], skin.weights[local])
    )
    if skin.rigid:
        joints, weights = joints[:1], weights[:1]
    skinned = _shared_or_own_maps(
        skin, joints, weights, skinning, float(np.abs(mesh.points).max(initial=1e-30))
    )
    return _composed(
        _composed(skin.geom_bind[None, :, :3], skinned),
        skeleton_to_root(body.skeletons, body.joints, skin)[None, :, :3],
    )


def skinned(body: Body, mesh: RigMesh, points: Floats, skinning: Floats) -> Floats:
    """Blended `points` (n, 3) of a mesh in root space; linear skinning needs no map for each
    point."""
    skin = mesh.binding.skin
    if skin is None or skin.rigid or skin.method == "dualQuaternion":
        return applied(points, point_maps(body, mesh, skinning))
    to_root = skeleton_to_root(body.skeletons, body.joints, skin)
    total = np.repeat(to_root[None, 3, :3], len(points), axis=0)
    add_influences(skin, bound_points(points, skin), skinning[:, :, :3] @ to_root[:3, :3], total)
    return total


def add_influences(
    skin: Skin,
    bound: Floats,
    matrices: Floats,
    total: Floats,
    acting: NDArray[np.bool_] | None = None,
    row: Indices | None = None,
) -> None:
    """Add to `total` (p, m) the weighted images of `bound` (p, 4) under `matrices` (joints, 4, m).

    Only the `acting` joints count (all if None); local point i stands in `row[i]` (i itself if
    None).
    """
    points, weights, joints, starts = skin.by_joint
    for i, joint in enumerate(joints):
        if acting is None or acting[joint]:
            part = slice(starts[i], starts[i + 1])
            at = points[part] if row is None else row[points[part]]
            total[at] += weights[part, None] * (bound[at] @ matrices[joint])


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
        skin = body.meshes[mesh].binding.skin
        if skin is not None:
            np.add.at(share, skin.joints[local], skin.weights[local])
    total = float(share.sum())
    if not total > 0.0:
        return -1
    depth = np.zeros(len(body.joints), dtype=np.int64)
    for i, joint in enumerate(body.joints):
        depth[i] = depth[joint.parent] + 1 if joint.parent >= 0 else 0
    for i in range(len(body.joints) - 1, -1, -1):
        if body.joints[i].parent >= 0:
            share[body.joints[i].parent] += share[i]
    carrying = np.flatnonzero(share >= _FACE_SHARE * total)
    if not len(carrying):
        return int(share.argmax())
    return int(carrying[np.lexsort((carrying, -share[carrying], -depth[carrying]))[0]])


def skeleton_to_root(
    skeletons: tuple[Skeleton, ...], joints: tuple[Joint, ...], skin: Skin
) -> Floats:
    """(4, 4) from the space of the skin's Skeleton to root space."""
    return skeletons[joints[int(skin.joints[0, 0])].skeleton].to_root


def applied(points: Floats, maps: Floats) -> Floats:
    """Points (p, 3) under affine maps (1 or p, 4, 3)."""
    if len(maps) == 1:
        return np.asarray(points @ maps[0, :3] + maps[0, 3], dtype=np.float64)
    return np.asarray(np.einsum("pi,pij->pj", points, maps[:, :3]) + maps[:, 3], dtype=np.float64)


def _shared_or_own_maps(
    skin: Skin, joints: Indices, weights: Floats, skinning: Floats, size: float
) -> Floats:
    """Maps (1 or p, 4, 3) of bound points into skeleton space."""
    used = np.flatnonzero(
        np.bincount(joints.ravel(), weights=np.abs(weights).ravel(), minlength=len(skinning))
    )
    if len(used) == 0:
        return np.zeros((1, 4, 3))
    scale = np.array([1.0, 1.0, 1.0, size])[:, None]
    deviation = np.abs(skinning[used, :, :3] - skinning[used[0], :, :3]) / scale
    unit = np.abs(weights.sum(axis=1) - 1.0).max() <= 1e-6
    if unit and deviation.max() <= SAME:
        return np.asarray(skinning[used[:1], :, :3], dtype=np.float64)
    if skin.method == "dualQuaternion":
        return _dual_quaternion_maps(joints, weights, skinning)
    return _weighted(weights, joints, np.ascontiguousarray(skinning[:, :, :3]))


def _weighted(weights: Floats, joints: Indices, tables: Floats) -> Floats:
    """Sum over influences: (p, ...) of weights (p, k) times tables (joints, ...) at joints (p,
    k)."""
    flat = tables.reshape(len(tables), -1)
    total = np.zeros((len(joints), flat.shape[1]))
    for influence in range(joints.shape[1]):
        active = np.flatnonzero(weights[:, influence])
        total[active] += weights[active, influence, None] * flat[joints[active, influence]]
    return total.reshape(len(joints), *tables.shape[1:])


def _composed(first: Floats, second: Floats) -> Floats:
    """Affine maps (p, 4, 3) that apply `first`, then `second`; either may be a single one."""
    linear = first @ second[:, :3]
    linear[:, 3] += second[:, 3]
    return np.asarray(linear, dtype=np.float64)


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
    length = np.linalg.norm(blend[:, :4], axis=1, keepdims=True)
    length[length == 0.0] = 1.0
    real, dual = blend[:, :4] / length, blend[:, 4:] / length
    conjugate = real * np.array([1.0, -1.0, -1.0, -1.0])
    maps = np.empty((len(joints), 4, 3))
    maps[:, :3] = stretch @ quaternion_matrices(real)
    maps[:, 3] = 2.0 * quaternion_product(dual, conjugate)[:, 1:]
    return maps
