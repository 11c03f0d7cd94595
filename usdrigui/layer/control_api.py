"""The control of an element in the layer: enough for any client to show it and to drive it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from pxr import Sdf, Usd, Vt

from usdrigui.character import Body, Control, Drive, Floats, Rig
from usdrigui.layer import author
from usdrigui.stages import schema

_NOISE = 1e-6
"""Weights, rotations (radians), logarithms of scales, and translations relative to the longest
bone: what is below is noise of the file."""


def author_control_api(
    xform: Sdf.PrimSpec, body: Body, control: Control, instance: str, figures: Mapping[str, Any]
) -> None:
    """What any client needs to show a control and to drive it."""
    author.declare(
        xform,
        schema.CONTROL,
        {
            "name": "" if control.name == instance else control.name,
            "kind": control.kind,
            "label": "" if control.label == control.name else control.label,
            "source": "" if control.source == control.name else control.source,
            "unit": "degrees" if control.kind == "joint" else "weight",
            "minimum": control.minimum,
            "default": control.default,
            "maximum": control.maximum,
            **figures,
            **_driven_weights(body, control.drive),
            **_driven_joints(body, control.drive),
        },
        instance,
    )
    # Without a value: it is there for hosts that do not know the schema.
    Sdf.AttributeSpec(xform, f"rigUI:control:{instance}:value", Sdf.ValueTypeNames.Double)


def _driven_weights(body: Body, drive: Drive) -> dict[str, Any]:
    plain = is_plain(body.base_weights, drive)
    driven = np.flatnonzero(plain | ~np.isclose(drive.weights, 0.0, atol=_NOISE).all(axis=0))
    channels = [body.channels[channel] for channel in drive.channels[driven]]
    animations = list(dict.fromkeys(channel.animation for channel in channels if channel.animation))
    which = [
        animations.index(channel.animation) if channel.animation else 0 for channel in channels
    ]
    # The SkelAnimation of a character with one goes without saying.
    only = animations == list({skeleton.animation for skeleton in body.skeletons})
    found: dict[str, Any] = {
        "blendShapes": [channel.token for channel in channels],
        "animation": [] if only and len(animations) == 1 else animations,
        "blendShapeAnimations": which if any(which) else [],
    }
    if not plain:
        found |= {"keys": drive.values, "blendShapeWeights": drive.weights[:, driven].ravel()}
    return found


def is_plain(base_weights: Floats, drive: Drive) -> bool:
    """Whether the value of the control is the weight of one blend shape, neither more nor less."""
    if len(drive.joints) or len(drive.channels) != 1:
        return False
    absolute = base_weights[drive.channels[0]] + drive.weights[:, 0]
    return bool(abs(absolute - drive.values).max() < 1e-12)


def slides(body: Body, drive: Drive) -> bool:
    """Whether what does not deform slides with the control: all that it drives are weights of one
    SkelAnimation, and those are alike, so that the first of them can carry it."""
    animations = {body.channels[channel].animation for channel in drive.channels}
    return (
        len(animations) == 1 and not len(drive.joints) and not np.ptp(drive.weights, axis=1).any()
    )


def _driven_joints(body: Body, drive: Drive) -> dict[str, Any]:
    extent = max((float(np.abs(joint.rest[3, :3]).max()) for joint in body.joints), default=0.0)
    moves = felt(drive, extent)
    moved = np.flatnonzero(moves.any(axis=(0, 1, 3)))
    joints = [body.joints[joint] for joint in drive.joints[moved]]
    if not joints:
        return {}
    skeletons = list(dict.fromkeys(joint.skeleton for joint in joints))
    which = [skeletons.index(joint.skeleton) for joint in joints]
    turns, shifts, scales = (moves[:, part, moved].reshape(-1, 3) for part in range(3))
    return {
        "skeleton": [body.skeletons[skeleton].path for skeleton in skeletons],
        "joints": [joint.path for joint in joints],
        "jointSkeletons": which if any(which) else [],
        "jointRotationVectors": np.degrees(turns) if turns.any() else (),
        "jointTranslations": shifts if shifts.any() else (),
        "jointScaleFactors": np.exp(scales) if scales.any() else (),
    }


def felt(drive: Drive, size: float) -> Floats:
    """The moves of a drive without the noise of the file; that of translations is measured by a
    `size`."""
    noise = _NOISE * np.array([1.0, size, 1.0])[:, None, None]
    large = np.abs(drive.moves).max(axis=(0, 3), keepdims=True) > noise
    return np.where(large, drive.moves, 0.0)


# --- limits ---------------------------------------------------------------------------------------


def author_limits(root: Sdf.PrimSpec, rig: Rig) -> None:
    """Say the ranges of the weights where USD itself looks for them, `limits` of blendShapeWeights,
    inside the variant of a SkelRoot that holds its layout; not of a SkelAnimation elsewhere.

    USD before 25.11 cannot author them; it reads past them without a word.  Weights without a
    control of their own keep to 0 and 1.
    """
    inside = Sdf.Path(rig.path)
    for animation in dict.fromkeys(each.animation for each in rig.body.skeletons if each.animation):
        ranges, path = _weight_ranges(rig, animation), Sdf.Path(animation)
        if len(ranges) and path.HasPrefix(inside) and hasattr(Usd, "AttributeLimits"):
            spec = Sdf.CreatePrimInLayer(root.layer, path.ReplacePrefix(inside, root.path))
            weights = Sdf.AttributeSpec(spec, "blendShapeWeights", Sdf.ValueTypeNames.FloatArray)
            low, high = (Vt.FloatArray.FromNumpy(column.astype(np.float32)) for column in ranges.T)
            weights.SetInfo("limits", {"soft": {"minimum": low, "maximum": high}})


def _weight_ranges(rig: Rig, animation: str) -> Floats:
    """(weights, 2) least and largest weight of each blend shape of a SkelAnimation, in its
    order."""
    entries = [each.index for each in rig.body.channels if each.animation == animation]
    ranges = np.tile([0.0, 1.0], (max(entries, default=-1) + 1, 1))
    for control in rig.controls:
        if is_plain(rig.body.base_weights, control.drive):
            channel = rig.body.channels[control.drive.channels[0]]
            if channel.animation == animation:
                ranges[channel.index] = control.minimum, control.maximum
    return ranges
