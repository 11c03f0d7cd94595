"""The symmetry of a character whose base pose is not symmetric: who mirrors whom is decided at the
neutral pose."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from usdrigui.character import Body, Floats, Indices, Record, Rig
from usdrigui.character.skinning import at_bind_pose
from usdrigui.layout.motion.owned_skin import joint_places
from usdrigui.layout.motion.trajectory import of_controls, trajectories
from usdrigui.layout.shares import MOST
from usdrigui.layout.symmetry.mirror_plane import mirrored
from usdrigui.layout.symmetry.sides_of_joints import (
    mirrored_joints,
    plane_between,
    plane_of_pairs,
)
from usdrigui.layout.symmetry.twins import paired
from usdrigui.model import MirrorPlane, Motion, Symmetry, Trajectories
from usdrigui.settings import Settings, TrajectorySettings


class NeutralPose(Record):
    """The neutral pose of a character whose base pose is another."""

    rig: Rig
    sampling: TrajectorySettings
    preferred: bool
    """Whether its symmetry counts also where the base pose mirrors as much."""

    @cached_property
    def trajectories(self) -> Trajectories:
        """Of all controls there: worked out when asked for, and once."""
        return trajectories(self.rig, self.sampling)


def neutral_pose(rig: Rig, settings: Settings) -> NeutralPose | None:
    """The pose at the controls' defaults where the base pose is another, which is preferred, else
    the bind pose of a character that rests in a pose; None for all others, and where no symmetry is
    asked for."""
    if not settings.symmetry.enabled:
        return None
    pose = settings.read.pose
    if any(pose.get(each.name, each.default) != each.default for each in rig.controls):
        return NeutralPose(rig, settings.trajectories, True)
    bound = at_bind_pose(rig.body)
    if bound is rig.body:
        return None
    return NeutralPose(replace(rig, body=bound), settings.trajectories, False)


def symmetry_at_pose(
    rig: Rig, found: Trajectories, neutral: NeutralPose | None, settings: Settings
) -> Symmetry:
    """The symmetry that the `found` trajectories have, or that of the neutral pose where it mirrors
    more of what the controls move, or is preferred and mirrors as much.

    A pose with one eye closed or one arm raised has no mirror image there: pairs would find no
    common candidate and leave the character.
    """
    mirror = mirrored(rig, found, settings)
    missed = _missed(mirror[1], found.motions)
    if neutral is not None and (missed or neutral.preferred):
        rig_there = replace(neutral.rig, up=rig.up)
        chosen = {each.control for each in (*found.motions, *found.excluded)}
        there = of_controls(rig_there, neutral.trajectories, chosen, neutral.sampling)
        other = mirrored(rig_there, there, settings)
        if other[0].normal.any() and (
            _missed(other[1], found.motions) < missed + neutral.preferred
        ):
            symmetry = paired(rig_there, there, other, settings)
            plane = _between_joints(rig.body, rig_there.body, symmetry.plane)
            if plane is None:
                plane = _between_points(symmetry, found.surface.points)
            origin = plane.projected(found.surface.points.mean(axis=0))
            return replace(symmetry, plane=replace(plane, origin=origin))
    return paired(rig, found, mirror, settings)


def with_left_of(whole: MirrorPlane, part: Symmetry) -> Symmetry:
    """The symmetry of a part, its left that of the whole character: what few controls of a face
    move, as hair does, may look back."""
    if part.plane.normal @ whole.normal > -MOST:
        return part
    plane = replace(part.plane, normal=-part.plane.normal)
    return replace(part, plane=plane, apart=-part.apart)


def _missed(partner: Indices, motions: Sequence[Motion]) -> int:
    """How often a control moves a point without a partner."""
    return sum(int((partner[each.points] < 0).sum()) for each in motions)


def _between_joints(body: Body, neutral: Body, plane: MirrorPlane) -> MirrorPlane | None:
    """The plane of the neutral pose where the joints that mirror each other there have it now."""
    twins = mirrored_joints(neutral, plane)
    side = plane.distance(joint_places(neutral))
    return plane_of_pairs(body, {i: twin for i, twin in twins.items() if side[i] > side[twin]})


def _between_points(symmetry: Symmetry, base: Floats) -> MirrorPlane:
    """The plane where most pairs of points have it at the `base` places (n, 3): what one side does
    must not tilt it."""
    side = symmetry.apart
    # Joints may bring together what is apart at the bind pose.
    apart = (base != base[symmetry.partner]).any(axis=1)
    left = np.flatnonzero((symmetry.partner >= 0) & (side > 0.0) & apart)
    if not len(left):
        return symmetry.plane
    # Pairs near the middle determine the plane badly.
    left = left[side[left] >= np.median(side[left])]
    return plane_between(base[left], base[symmetry.partner[left]])[0]
