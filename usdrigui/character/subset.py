"""A rig cut down to a few of its points, and the joints that carry these, so that they can be posed
quickly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.character import Control, Drive, Flags, Indices, Rig, RigMesh, Shape


def subset(rig: Rig, points: Indices) -> tuple[Rig, Indices]:
    """The rig with only ``points`` (q,) of its meshes, and the row (q,) of each in what remains.

    Controls and channels keep their places; meshes without any of the points, joints that carry
    none of them, what controls do elsewhere, faces and the clip are left out.  Points may repeat
    and come in any order.
    """
    starts = rig.body.starts
    kept, rows = np.unique(np.asarray(points, dtype=np.int64), return_inverse=True)
    meshes = []
    for index, mesh in enumerate(rig.body.meshes):
        local = kept[(kept >= starts[index]) & (kept < starts[index + 1])] - starts[index]
        if len(local):
            meshes.append(_part(mesh, local))
    body = replace(rig.body, meshes=tuple(meshes))
    return _with_drives(replace(rig, clip=None, body=body)), rows.astype(np.int64)


def _with_drives(rig: Rig) -> Rig:
    """The rig with only the joints that its meshes' points hang on, and what its controls do to
    these points."""
    body = rig.body
    kept = np.zeros(len(body.joints), dtype=bool)
    for mesh in body.meshes:
        skin = mesh.skin
        if skin is not None:
            # Weightless influences name joints too, and so the skeleton that the skin is on.
            kept[np.unique(skin.joints)] = True
    for i in range(len(body.joints) - 1, -1, -1):
        if kept[i] and body.joints[i].parent >= 0:
            kept[body.joints[i].parent] = True
    place = np.where(kept, np.cumsum(kept) - 1, -1)
    joints = tuple(
        replace(joint, parent=int(place[joint.parent]) if joint.parent >= 0 else -1)
        for joint, stays in zip(body.joints, kept.tolist(), strict=True)
        if stays
    )
    meshes = tuple(_renumbered(mesh, place) for mesh in body.meshes)
    acting = np.zeros(len(body.channels), dtype=bool)
    acting[[shape.channel for mesh in meshes for shape in mesh.shapes]] = True
    controls = tuple(_acting(control, acting, place) for control in rig.controls)
    body = replace(body, joints=joints, meshes=meshes)
    return replace(rig, body=body, controls=controls)


def _renumbered(mesh: RigMesh, place: Indices) -> RigMesh:
    """The mesh with its skin on joints by their new `place` (joints,)."""
    skin = mesh.skin
    if skin is None:
        return mesh
    return replace(mesh, skin=replace(skin, joints=place[skin.joints]))


def _acting(control: Control, acting: Flags, place: Indices) -> Control:
    """The control with its ``acting`` (channels,) and the joints whose ``place`` (joints,) is not
    -1."""
    drive = control.drive
    stays, weighs = place[drive.joints] >= 0, acting[drive.channels]
    if stays.all() and weighs.all() and not len(drive.joints):
        return control
    kept = Drive(
        drive.values,
        drive.channels[weighs],
        drive.weights[:, weighs],
        place[drive.joints[stays]],
        drive.rotations[:, stays],
        drive.translations[:, stays],
        drive.scales[:, stays],
    )
    return replace(control, drive=kept)


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
