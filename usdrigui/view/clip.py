"""A character's own animation as values of its controls, for films and for judging a layout in
motion."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import Clip, Control, Floats, Joint, Rig
from usdrigui.rotation import rotation_part, rotation_vectors


def clip_values(rig: Rig, count: int = 0) -> Floats:
    """(frames, controls) control values at `count` frames spread over the rig's clip; 0 for every
    frame.

    Shape controls take the weights of the clip, rotations of joints the components of the joint's
    rotation vector from its base; pose controls stay at their defaults, since many mixtures of
    poses would give the same frame.  Raises RigUIError ANIMATION_MISSING.
    """
    clip = rig.skel_root.clip
    if clip is None or len(clip.times) < 2:
        raise refuse("ANIMATION_MISSING", rig.skel_root.path, "has no animation to show")
    last = len(clip.times) - 1
    steps = (
        np.arange(last + 1)
        if count <= 0
        else np.unique(np.linspace(0, last, count).round().astype(int))
    )
    values = np.stack([_values(rig.body.joints, clip, control) for control in rig.controls], axis=1)
    return np.asarray(values[steps], dtype=np.float64)


def _values(joints: tuple[Joint, ...], clip: Clip, control: Control) -> Floats:
    """(f,) values of one control over the clip."""
    drive = control.drive
    per_unit = 1.0 / float(drive.values[-1] - drive.values[0])
    if control.kind == "blendShape" and len(drive.channels):
        rise = float(drive.weights[-1, 0] - drive.weights[0, 0]) * per_unit
        if rise:
            return np.asarray(clip.weights[:, drive.channels[0]] / rise)
    if control.kind == "joint" and len(drive.joints) == 1:
        turn = (drive.rotations[-1, 0] - drive.rotations[0, 0]) * per_unit
        if turn.any():
            joint = int(drive.joints[0])
            frame = rotation_part(joints[joint].base)
            turned = rotation_vectors(rotation_part(clip.locals[:, joint]) @ frame.T)
            return np.asarray(control.default + turned @ turn / (turn @ turn))
    return np.full(len(clip.times), control.default)
