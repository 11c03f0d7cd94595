"""A character's own animation as values of its controls, for films and for judging a layout in
motion."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Body, Clip, Control, Floats, Rig
from usdrigui.character.clip_reading import reading
from usdrigui.character.rotation import rotation_part
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


def _values(body: Body, clip: Clip, control: Control) -> Floats:
    """(f,) values of one control over the clip."""
    found = reading(control)
    if found is None:
        return np.full(len(clip.times), control.default)
    if found.rises:
        channel, rise = found.rises[0]
        away = (clip.weights[:, channel] - body.base_weights[channel]) / rise
    else:
        away = found.turned(body, rotation_part(clip.locals[:, found.joint]))
    return np.asarray(control.default + away)
