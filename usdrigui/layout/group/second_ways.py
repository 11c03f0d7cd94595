"""Joints that do what shapes do: their elements stand behind those of the shapes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.layout.measured import Measured
from usdrigui.model import Group

_SAME = 0.8
"""Least cosine of two motions that are the same, on the skin of the joint: .94 and more where both
shapes and a joint turn an eye (eight avatars), .6 at most for any other joint and shape of thirty
characters."""


def behind_shapes(known: Measured, groups: Sequence[Group]) -> dict[str, set[str]]:
    """The group of shapes, by name, that moves the skin of a joint as every axis of the joint's own
    group does, to that group.

    An eye that shapes and a joint turn has one gaze at a time, the shapes' first: lids follow it.
    """
    fields, controls = known.similarity.fields, known.face.rig.controls
    row = {motion.control: i for i, motion in enumerate(known.face.trajectories.motions)}

    def same(joint: int, shape: int) -> bool:
        turned = fields.vectors[row[joint]]
        own = turned.any(axis=1)
        root = np.sqrt(fields.weights[own])[:, None]
        one, other = (each[own] * root for each in (turned, fields.vectors[row[shape]]))
        most = float(np.linalg.norm(one) * np.linalg.norm(other))
        return abs(float(np.vdot(one, other))) > _SAME * most

    of_kind = {"joint": list[Group](), "blendShape": list[Group](), "pose": list[Group]()}
    for group in groups:
        if not group.category:
            of_kind[controls[group.controls[0]].kind].append(group)
    found: dict[str, set[str]] = {}
    for group in of_kind["joint"]:
        for other in of_kind["blendShape"]:
            if all(any(same(i, k) for k in other.controls) for i in group.controls):
                found.setdefault(other.name, set()).add(group.name)
                break
    return found
