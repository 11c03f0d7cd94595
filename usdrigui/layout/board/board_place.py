"""Where the board is: beside the silhouette, and carried by the joint that holds most of the
face."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Body, Floats, Indices, Skin
from usdrigui.layout.face import Face
from usdrigui.ties import first_largest


def silhouette(face: Face, middle: Floats, frame: Floats, half: float) -> float:
    """Rightmost extent of the character on the screen, no further than `half` above or below the
    middle.

    `frame` (2, 3) are right and up on the screen.
    """
    flat = face.surface.points[face.rig.body.drawn] @ frame.T
    near = flat[np.abs(flat[:, 1] - middle @ frame[1]) <= half, 0]
    return float(near.max()) if len(near) else float(middle @ frame[0])


def anchor_point(face: Face, middle: Floats) -> int:
    """The point whose joint influences the board takes: of the joint that holds most of the face,
    the point that it holds most firmly and that moves least, nearest to the middle of the face."""
    trajectories = face.trajectories
    total = np.zeros(len(trajectories.surface.points))
    for motion in trajectories.motions:
        total[motion.points] += motion.arc_length
    firmness = _firmness(face.rig.body, trajectories.face_points)
    apart = np.linalg.norm(trajectories.surface.points - middle, axis=1)
    unit = trajectories.surface.face_size
    order = np.lexsort(
        (np.round(apart / unit, 6), np.round(total / unit, 6), -np.round(firmness, 3))
    )
    return int(order[0])


def _firmness(body: Body, face_points: Indices) -> Floats:
    """(n,) weight of the joint that holds most of the face; 1 throughout without skins."""
    if not body.joints:
        return np.ones(sum(len(mesh.points) for mesh in body.meshes))
    tables = [_joint_weights(mesh.skin, len(mesh.points), len(body.joints)) for mesh in body.meshes]
    face = np.zeros(sum(map(len, tables)), dtype=bool)
    face[face_points] = True
    parts = (
        face[start : start + len(table)] for start, table in zip(body.starts, tables, strict=False)
    )
    totals = sum(table[part].sum(axis=0) for table, part in zip(tables, parts, strict=True))
    strongest = first_largest(totals)
    return np.concatenate([table[:, strongest] for table in tables])


def _joint_weights(skin: Skin | None, points: int, joints: int) -> Floats:
    """(points, joints) influence of every joint on every point of a mesh."""
    found = np.zeros((points, joints))
    if skin is not None:
        rows = np.repeat(np.arange(points), skin.joints.shape[1])
        np.add.at(found, (rows, skin.joints.ravel()), skin.weights.ravel())
    return found
