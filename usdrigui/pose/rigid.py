"""What static elements hang on: one joint for the whole face, found without names."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.model import Floats, Indices, Rig, RigMesh

_FACE_SHARE = 0.9
"""Share of the anchors' influence that must lie on the joint and below it."""


def on_one_joint(rig: Rig, rows: Indices) -> Rig:
    """The rig with all skinned meshes rigidly on the joint that carries the face, as in the written layer.

    It is the deepest joint that, with the joints below it, has 90 % of the influence on the points
    ``rows`` (q,); the rig comes back unchanged where it has no joints or the points no skin.
    """
    joint = _face_joint(rig, rows)
    if joint < 0:
        return rig
    return replace(rig, meshes=tuple(_rigid(mesh, joint) for mesh in rig.meshes))


def _face_joint(rig: Rig, rows: Indices) -> int:
    share: Floats = np.zeros(len(rig.joints))
    for row in rows.tolist():
        mesh, local = rig.mesh_of(row)
        skin = rig.meshes[mesh].skin
        if skin is not None:
            np.add.at(share, skin.joints[local], skin.weights[local])
    total = float(share.sum())
    if not total > 0.0:
        return -1
    depth = np.zeros(len(rig.joints), dtype=np.int64)
    for i, joint in enumerate(rig.joints):
        depth[i] = depth[joint.parent] + 1 if joint.parent >= 0 else 0
    for i in range(len(rig.joints) - 1, -1, -1):
        if rig.joints[i].parent >= 0:
            share[rig.joints[i].parent] += share[i]
    carrying = np.flatnonzero(share >= _FACE_SHARE * total)
    if not len(carrying):
        return int(share.argmax())
    return int(carrying[np.lexsort((carrying, -share[carrying], -depth[carrying]))[0]])


def _rigid(mesh: RigMesh, joint: int) -> RigMesh:
    if mesh.skin is None:
        return mesh
    count = len(mesh.points)
    skin = replace(mesh.skin, joints=np.full((count, 1), joint), weights=np.ones((count, 1)), rigid=True)
    return replace(mesh, skin=skin)
