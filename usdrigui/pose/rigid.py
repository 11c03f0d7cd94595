"""What static elements hang on: one joint for the whole face, found without names."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.model import Indices, Rig, RigMesh
from usdrigui.skinning import carrying_joint


def on_one_joint(rig: Rig, rows: Indices) -> Rig:
    """The rig with all skinned meshes rigidly on the joint that carries the face, as in the written
    layer.

    The joint is `carrying_joint` of the points ``rows`` (q,); the rig comes back unchanged where it
    has no joints or the points no skin.
    """
    joint = carrying_joint(rig, rows)
    if joint < 0:
        return rig
    return replace(rig, meshes=tuple(_rigid(mesh, joint) for mesh in rig.meshes))


def _rigid(mesh: RigMesh, joint: int) -> RigMesh:
    if mesh.skin is None:
        return mesh
    count = len(mesh.points)
    skin = replace(
        mesh.skin, joints=np.full((count, 1), joint), weights=np.ones((count, 1)), rigid=True
    )
    return replace(mesh, skin=skin)
