"""Which way the face looks, and from which directions a layout is judged (paper section 3.3,
occlusion)."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats
from usdrigui.character.joint_tree import unit
from usdrigui.layout.shares import NOTHING
from usdrigui.model import Trajectories
from usdrigui.ties import axis_across

_THREE_QUARTER = np.radians(40.0)


def front(up: Floats, trajectories: Trajectories, plane_normal: Floats) -> Floats:
    """(3,) unit direction from the face to the viewer: horizontal, in the mirror plane where its
    normal, which points to the character's left, is given.

    A face moves most where it looks, so the normals of the moving surface, averaged over what each
    control moves, sum up to the front.
    """
    return first_across(up, np.cross(plane_normal, up), moving_normals(trajectories))


def first_across(direction: Floats, *ways: Floats) -> Floats:
    """(3,) unit vector: the first of `ways` (3,) that does not run along the unit vector
    `direction`, made perpendicular to it; any if all do."""
    for way in (*ways, axis_across(direction)):
        across = way - (way @ direction) * direction
        if np.linalg.norm(across) > NOTHING:
            break
    return unit(across)


def seen_from(toward: Floats, up: Floats, ahead: Floats) -> Floats:
    """(3, 3) rows: unit vectors to the right, up and out for a viewer in the direction `toward`.

    Where that is straight up or down, the side away from `ahead` is up, as on a table.
    """
    aside = np.cross(toward, axis_across(toward))
    for way in (up, -np.sign(up @ toward) * ahead, aside):
        right = np.cross(way, toward)
        if np.linalg.norm(right) > NOTHING:
            break
    right = unit(right)
    return np.stack([right, np.cross(toward, right), toward])


def three_quarter(ahead: Floats, up: Floats) -> tuple[Floats, Floats]:
    """The two directions 40 degrees to the left and to the right of `ahead` about `up`."""
    side = np.cross(up, ahead)
    cos, sin = np.cos(_THREE_QUARTER), np.sin(_THREE_QUARTER)
    return cos * ahead + sin * side, cos * ahead - sin * side


def moving_normals(trajectories: Trajectories) -> Floats:
    """Sum over the controls of the mean normal of what each moves, by area.

    Every control has one vote, and casts it as far as its region faces one way: what moves the
    whole head moves normals that cancel, and the hair or the open neck must not outvote the face.
    """
    votes = np.zeros(3)
    for motion in trajectories.motions:
        weight = trajectories.surface.areas[motion.points] * np.minimum(
            motion.arc_length / motion.arc_length.mean(), 1.0
        )
        total = float(weight.sum())
        if total > 0.0:
            votes += weight @ trajectories.surface.normals[motion.points] / total
    return votes
