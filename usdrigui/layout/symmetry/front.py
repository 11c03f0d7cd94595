"""Which way the face looks, and from which directions a layout is judged (paper section 3.3,
occlusion)."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats
from usdrigui.model import Trajectories
from usdrigui.ties import axis_across, towards

_THREE_QUARTER = np.radians(40.0)


def front(up: Floats, trajectories: Trajectories, plane_normal: Floats) -> Floats:
    """(3,) unit direction from the face to the viewer: horizontal, in the mirror plane where there
    is one.

    A face moves most where it looks, so the normals of the moving surface, averaged over what each
    control moves, sum up to the front.
    """
    outward = _moving_normals(trajectories)
    if plane_normal.any():
        ahead = np.cross(plane_normal, up)
        if np.linalg.norm(ahead) > 1e-6:
            return towards(ahead / np.linalg.norm(ahead), outward)
    level = outward - (outward @ up) * up
    length = float(np.linalg.norm(level))
    if length > 1e-9:
        return level / length
    side = np.cross(up, axis_across(up))
    return side / np.linalg.norm(side)


def front_of(up: Floats, trajectories: Trajectories, plane_normal: Floats) -> Floats:
    """The same where the sides of the plane are known: its normal (3,) points to the character's
    left."""
    ahead = np.cross(plane_normal, up)
    length = float(np.linalg.norm(ahead))
    return ahead / length if length > 1e-6 else front(up, trajectories, plane_normal)


def three_quarter(ahead: Floats, up: Floats) -> tuple[Floats, Floats]:
    """The two directions 40 degrees to the left and to the right of `ahead` about `up`."""
    side = np.cross(up, ahead)
    cos, sin = np.cos(_THREE_QUARTER), np.sin(_THREE_QUARTER)
    return cos * ahead + sin * side, cos * ahead - sin * side


def _moving_normals(trajectories: Trajectories) -> Floats:
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
