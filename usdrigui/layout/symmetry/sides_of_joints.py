"""Left, right and the front of the skeleton: by the sides in names of joints and the
face on its head."""

from __future__ import annotations

import re
from collections import Counter

import numpy as np

from usdrigui.character import Floats, Joint, Rig, Skeleton
from usdrigui.conventions.sides import mirrored, side_of
from usdrigui.layout.motion.owned_skin import joint_places
from usdrigui.layout.parts.joint_regions import FACE, joint_regions, owner_of_points
from usdrigui.model import Trajectories

_PAIRS = 2
"""Least number of pairs of joints whose names have a side."""
_AGREE = 0.7
"""Share of the pairs that lie across the plane that they have in common, at least."""
_ACROSS = 0.5
"""Cosine to that plane's normal from which a pair lies across it."""
_AHEAD = 0.1
"""Least distance of the joints of a face ahead of its head, as a share of the head's extent."""
_COUNT = re.compile(r"[ _.-]*\d+$")
"""What an exporter counts the joints with."""


def plane_of_names(
    skeletons: tuple[Skeleton, ...], joints: tuple[Joint, ...]
) -> tuple[Floats, float] | None:
    """Normal (3,) to the left and offset of the plane between the joints whose names have left and
    right, at the base pose; None where too few do or they do not agree."""
    places = joint_places(skeletons, joints)
    last = [joint.name for joint in joints]
    pairs = []
    for i, other in _twins(joints, last).items():
        if side_of(last[i]) == "left" and (places[i] != places[other]).any():
            pairs.append((places[i], places[other]))
    if len(pairs) < _PAIRS:
        return None
    left, right = np.array(pairs).transpose(1, 0, 2)
    across = (left - right) / np.linalg.norm(left - right, axis=1)[:, None]
    normal = np.median(across, axis=0)
    length = float(np.linalg.norm(normal))
    if length == 0.0 or float((across @ normal >= _ACROSS * length).mean()) < _AGREE:
        return None
    normal = normal / length
    return normal, float(np.median(0.5 * (left + right) @ normal))


def _twins(joints: tuple[Joint, ...], names: list[str]) -> dict[int, int]:
    """Joints whose names are those of others with the sides swapped, to these; a number at the end,
    by which exporters count joints, may differ where the name is the only one of its kind."""
    found: dict[int, int] = {}
    for spelt in (names, [_COUNT.sub("", name) for name in names]):
        keys = [(joint.skeleton, name.lower()) for joint, name in zip(joints, spelt, strict=True)]
        counts = Counter(keys)
        alone = {key: i for i, key in enumerate(keys) if counts[key] == 1}
        for (skeleton, name), i in alone.items():
            other = alone.get((skeleton, mirrored(name)), i)
            if other != i:
                found.setdefault(i, other)
    return found


def ahead_of_head(rig: Rig, trajectories: Trajectories) -> Floats | None:
    """(3,) horizontal vector from the middle of the head to that of the joints of its face; None
    without them."""
    regions = joint_regions(rig, trajectories)
    if regions is None:
        return None
    facial = [i for i, name in enumerate(regions.of_joint) if name == FACE]
    head = np.array([name == FACE for name in (*regions.of_skin, "")])
    points = trajectories.surface.points[head[owner_of_points(rig.body.meshes)]]
    if not facial or not len(points):
        return None
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    way = joint_places(rig.body.skeletons, rig.body.joints)[facial].mean(axis=0) - middle
    level = np.asarray(way - (way @ rig.skel_root.up) * rig.skel_root.up)
    extent = float(np.ptp(points, axis=0).max())
    return level if float(np.linalg.norm(level)) >= _AHEAD * extent else None
