"""A character's own animation as values of its controls, for films and for judging a layout in
motion."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Body, Clip, Control, Floats, Record, Rig
from usdrigui.character.rotation import rotation_part, rotation_vectors
from usdrigui.errors import refuse


def clip_values(rig: Rig) -> Floats:
    """(frames, controls) control values at every frame of the rig's clip.

    Shape controls take the weights of the clip, rotations of joints the components of the joint's
    rotation vector from its base; pose controls stay at their defaults, since many mixtures of
    poses would give the same frame.  Raises RigUIError ANIMATION_MISSING.
    """
    clip = rig.clip
    if clip is None or len(clip.times) < 2:
        raise refuse("ANIMATION_MISSING", rig.path, "has no animation to show")
    return np.stack([_values(rig.body, clip, control) for control in rig.controls], axis=1)


class ClipReading(Record):
    """Where the value of a control is read in a clip, for films and for pages: in the weight of the
    first of `rises`, else in the rotation of a joint."""

    rises: tuple[tuple[int, float], ...]
    """Channels, and what the weight of each gains per unit of the control."""
    joint: int
    """Index into `Body.joints`, or -1."""
    turn: Floats
    """(3,) rotation vector per unit of the control."""


def reading(control: Control) -> ClipReading | None:
    """Where a control is read; None for one that a clip does not determine."""
    drive = control.drive
    per_unit = 1.0 / float(drive.values[-1] - drive.values[0])
    rises = (drive.weights[-1] - drive.weights[0]) * per_unit
    if control.kind == "blendShape" and rises[:1].any():
        pairs = zip(drive.channels.tolist(), rises.tolist(), strict=True)
        return ClipReading(tuple(pairs), -1, np.zeros(3))
    if control.kind == "joint" and len(drive.joints) == 1:
        return ClipReading((), int(drive.joints[0]), drive.turn) if drive.turn.any() else None
    return None


def _values(body: Body, clip: Clip, control: Control) -> Floats:
    """(f,) values of one control over the clip."""
    found = reading(control)
    if found is None:
        return np.full(len(clip.times), control.default)
    if found.rises:
        channel, rise = found.rises[0]
        away = (clip.weights[:, channel] - body.base_weights[channel]) / rise
    else:
        frame = rotation_part(body.joints[found.joint].base)
        turned = rotation_vectors(rotation_part(clip.locals[:, found.joint]) @ frame.T)
        away = turned @ found.turn / (found.turn @ found.turn)
    return np.asarray(control.default + away)
