"""Where the board is: beside the silhouette, and carried by the joint that holds most of the
face."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from usdrigui.character import Floats, Indices, Rig
from usdrigui.layout.face import Face
from usdrigui.layout.motion.owned_skin import weights_of
from usdrigui.layout.parts.joint_regions import owner_of_points


def silhouette(face: Face, middle: Floats, frame: Floats, half: float) -> float:
    """Rightmost extent of the character on the screen, no further than `half` above or below the
    middle.

    `frame` (2, 3) are right and up on the screen.
    """
    flat = face.surface.points[face.rig.body.drawn] @ frame.T
    near = flat[np.abs(flat[:, 1] - middle @ frame[1]) <= half, 0]
    return float(near.max()) if len(near) else float(middle @ frame[0])


def carriers(face: Face, middle: Floats) -> Indices:
    """(n,) all points, the best one to carry the board first: of the joint that holds most of the
    face, the point that it holds most firmly and that moves least, nearest to the middle of the
    face."""
    trajectories = face.trajectories
    total = np.zeros(len(trajectories.surface.points))
    for motion in trajectories.motions:
        total[motion.points] += motion.arc_length
    owners = owner_of_points(face.rig.body.meshes)[trajectories.face_points]
    most = int(np.bincount(owners[owners >= 0], minlength=1).argmax())
    firmness = weights_of(face.rig.body, frozenset([most]))
    apart = np.linalg.norm(trajectories.surface.points - middle, axis=1)
    unit = trajectories.surface.face_size
    keys = np.round(apart / unit, 6), np.round(total / unit, 6), -np.round(firmness, 3)
    return np.lexsort(keys)


def carrier_of(rig: Rig, controls: Collection[int], carriers: Indices) -> int:
    """The first carrier on a mesh whose SkelAnimation drives one of some controls, else the first
    of all: only there a handle can slide with them."""
    drives = [rig.controls[control].drive for control in controls]
    animations = {rig.body.channels[i].animation for drive in drives for i in drive.channels}
    skeletons = [rig.body.bound_to(mesh) for mesh in rig.body.meshes]
    slides = [i >= 0 and rig.body.skeletons[i].animation in animations for i in skeletons]
    return int(carriers[np.repeat(slides, np.diff(rig.body.starts))[carriers].argmax()])
