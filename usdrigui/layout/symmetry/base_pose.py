"""The symmetry of a character whose base pose is not symmetric: who mirrors whom is decided at the
neutral pose."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.character import Floats, Rig
from usdrigui.layout.motion.similarity import DisplacementFields, displacement_fields
from usdrigui.layout.motion.trajectory import of_controls, trajectories as find_trajectories
from usdrigui.layout.parts.joint_regions import FACE
from usdrigui.layout.symmetry.mirror_plane import find_symmetry
from usdrigui.layout.symmetry.sides_of_joints import plane_between
from usdrigui.layout.symmetry.twins import paired
from usdrigui.model import BaseSurface, Symmetry, Trajectories
from usdrigui.settings import Settings, TrajectorySettings


def symmetry_at_pose(
    rig: Rig, trajectories: Trajectories, fields: DisplacementFields, settings: Settings
) -> Symmetry:
    """`find_symmetry`, but for a base pose of its own with the partners and twins of the neutral
    pose: that at the controls' defaults, and of a character that rests in a pose its bind pose,
    if that mirrors more of what the controls move.

    A pose with one eye closed or one arm raised has no mirror image there: pairs would find no
    common candidate and leave the character. `fields` are those of `trajectories`.
    """
    pose = settings.read.pose
    if all(pose.get(each.name, each.default) == each.default for each in rig.controls):
        found = find_symmetry(rig, trajectories, fields, settings)
        return _or_at_bind_pose(rig, trajectories, found, settings)
    neutral = _same_controls(rig, trajectories, settings.trajectories)
    symmetry = find_symmetry(rig, neutral, displacement_fields(neutral), settings)
    if not symmetry.plane.normal.any():
        return find_symmetry(rig, trajectories, fields, settings)
    return _at_pose(symmetry, neutral.surface, trajectories.surface.points)


def symmetry_of_part(
    rig: Rig, trajectories: Trajectories, of_whole: tuple[str, Symmetry], settings: Settings
) -> Symmetry:
    """The symmetry of one part, whose name is given with the symmetry `of_whole` the character: a
    face has a plane of its own, a hand by itself is nearly symmetric about its middle finger."""
    (part, whole), fields = of_whole, displacement_fields(trajectories)
    if part == FACE or not whole.plane.normal.any():
        own = symmetry_at_pose(rig, trajectories, fields, settings)
        if own.plane.normal.any():
            return own
    return paired(rig, trajectories.motions, (fields, whole.plane, whole.partner), settings)


def _or_at_bind_pose(
    rig: Rig, trajectories: Trajectories, found: Symmetry, settings: Settings
) -> Symmetry:
    """What was found, or what the skeleton's bind pose shows where that mirrors more of what the
    controls move: a character may rest in a pose of its own."""
    moved = np.concatenate([each.points for each in trajectories.motions] or [np.zeros(0, int)])
    bound = _bound(rig) if settings.symmetry.enabled else None
    if bound is None or (found.partner[moved] >= 0).all():
        return found
    neutral = _same_controls(bound, trajectories, settings.trajectories)
    symmetry = find_symmetry(bound, neutral, displacement_fields(neutral), settings)
    if (symmetry.partner[moved] >= 0).sum() <= (found.partner[moved] >= 0).sum():
        return found
    return _at_pose(symmetry, neutral.surface, trajectories.surface.points)


def _bound(rig: Rig) -> Rig | None:
    """The rig in its bind pose; None where that is its base pose, or has no inverse."""
    joints = rig.body.joints
    try:
        local = [
            (
                joint.bind @ np.linalg.inv(joints[joint.parent].bind)
                if joint.parent >= 0
                else joint.bind
            )
            for joint in joints
        ]
    except np.linalg.LinAlgError:
        return None
    if all(np.allclose(at, joint.base, atol=1e-4) for at, joint in zip(local, joints, strict=True)):
        return None
    turned = tuple(replace(joint, base=at) for at, joint in zip(local, joints, strict=True))
    return replace(rig, body=replace(rig.body, joints=turned))


def _same_controls(
    rig: Rig, trajectories: Trajectories, sampling: TrajectorySettings
) -> Trajectories:
    """Trajectories of the same controls at the defaults of all."""
    neutral = find_trajectories(rig, sampling)
    own, excluded = (
        frozenset(each.control for each in of)
        for of in (trajectories.motions, trajectories.excluded)
    )
    return of_controls(rig, neutral, (own, excluded), sampling)


def _at_pose(symmetry: Symmetry, surface: BaseSurface, base: Floats) -> Symmetry:
    """The same partners with the plane where most pairs now have it: what one side does must not
    tilt it."""
    side = symmetry.plane.distance(surface.points)
    # Joints may bring together what is apart at the bind pose.
    apart = (base != base[symmetry.partner]).any(axis=1)
    left = np.flatnonzero((symmetry.partner >= 0) & (side > 0.0) & apart)
    if not len(left):
        return symmetry
    # Pairs near the middle determine the plane badly.
    left = left[side[left] >= np.median(side[left])]
    plane, _ = plane_between(base[left], base[symmetry.partner[left]])
    return replace(symmetry, plane=replace(plane, origin=plane.projected(base.mean(axis=0))))
