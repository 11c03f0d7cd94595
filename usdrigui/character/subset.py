"""A rig cut down to a few of its points, so that they can be posed quickly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.character import Indices, Rig, RigMesh, Shape


def subset(rig: Rig, points: Indices) -> tuple[Rig, Indices]:
    """The rig with only ``points`` (q,) of its meshes, and the row (q,) of each in what remains.

    Controls, channels and joints keep their places; meshes without any of the points and faces are
    left out.  Points may repeat and come in any order.
    """
    starts = rig.body.starts
    kept, rows = np.unique(np.asarray(points, dtype=np.int64), return_inverse=True)
    meshes = []
    for index, mesh in enumerate(rig.body.meshes):
        local = kept[(kept >= starts[index]) & (kept < starts[index + 1])] - starts[index]
        if len(local):
            meshes.append(_part(mesh, local))
    return replace(rig, body=replace(rig.body, meshes=tuple(meshes))), rows.astype(np.int64)


def _part(mesh: RigMesh, kept: Indices) -> RigMesh:
    """The `kept` local points (ascending) of a mesh, without faces."""
    skin = mesh.skin
    if skin is not None:
        skin = replace(skin, joints=skin.joints[kept], weights=skin.weights[kept])
    shapes = tuple(
        shape for shape in (_shape_part(each, kept) for each in mesh.shapes) if len(shape.points)
    )
    none = np.zeros(0, dtype=np.int64)
    return replace(
        mesh,
        points=mesh.points[kept],
        topology=replace(mesh.topology, face_counts=none, face_indices=none),
        skin=skin,
        shapes=shapes,
        colours=None,
        texturing=None,
    )


def _shape_part(shape: Shape, kept: Indices) -> Shape:
    _, local, row = np.intersect1d(kept, shape.points, assume_unique=True, return_indices=True)
    return replace(shape, points=local.astype(np.int64), offsets=shape.offsets[:, row])
