"""What the layer says about a control: enough for any client to show it and to drive it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from pxr import Sdf, Usd, Vt

from usdrigui.model import Control, Flags, Floats, Rig, RigMesh
from usdrigui.usd import author, schema


def author_control_api(
    xform: Sdf.PrimSpec, rig: Rig, control: Control, instance: str, figures: Mapping[str, Any]
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
            "minimum": control.minimum,
            "default": control.default,
            "maximum": control.maximum,
            "mesh": _deformed_meshes(rig, control),
            **figures,
            **_driven_weights(rig, control),
            **_driven_joints(rig, control),
        },
        instance,
    )


def _driven_weights(rig: Rig, control: Control) -> dict[str, Any]:
    drive = control.drive
    channels = [rig.channels[channel] for channel in drive.channels]
    animations = list(dict.fromkeys(channel.animation for channel in channels if channel.animation))
    which = [animations.index(channel.animation) if channel.animation else 0 for channel in channels]
    found: dict[str, Any] = {
        "blendShapes": [channel.token for channel in channels],
        "animation": animations,
        "blendShapeAnimations": which if any(which) else [],
    }
    if not _is_plain(rig, control):
        found |= {"keys": drive.values, "blendShapeWeights": drive.weights.ravel()}
    return found


def _is_plain(rig: Rig, control: Control) -> bool:
    """Whether the value of the control is the weight of one blend shape, neither more nor less."""
    drive = control.drive
    if len(drive.joints) or len(drive.channels) != 1:
        return False
    absolute = rig.base_weights[drive.channels[0]] + drive.weights[:, 0]
    return bool(abs(absolute - drive.values).max() < 1e-12)


def _driven_joints(rig: Rig, control: Control) -> dict[str, Any]:
    drive = control.drive
    joints = [rig.joints[joint] for joint in drive.joints]
    if not joints:
        return {}
    skeletons = list(dict.fromkeys(joint.skeleton for joint in joints))
    which = [skeletons.index(joint.skeleton) for joint in joints]
    found: dict[str, Any] = {
        "skeleton": [rig.skeletons[skeleton].path for skeleton in skeletons],
        "joints": [joint.path for joint in joints],
        "jointSkeletons": which if any(which) else [],
        "jointRotations": drive.rotations.reshape(-1, 3),
    }
    if drive.translations.any():
        found["jointTranslations"] = drive.translations.reshape(-1, 3)
    if drive.scales.any():
        found["jointScales"] = drive.scales.reshape(-1, 3)
    return found


def _deformed_meshes(rig: Rig, control: Control) -> list[str]:
    """Paths of the meshes that the control's shapes or joints reach."""
    channels = set(control.drive.channels.tolist())
    turning = np.zeros(len(rig.joints), dtype=np.bool_)
    turning[control.drive.joints] = True
    for i, joint in enumerate(rig.joints if turning.any() else ()):
        turning[i] |= joint.parent >= 0 and turning[joint.parent]
    return [mesh.path for mesh in rig.meshes if _has_shape(mesh, channels) or _is_skinned_to(mesh, turning)]


def _has_shape(mesh: RigMesh, channels: set[int]) -> bool:
    return any(shape.channel in channels for shape in mesh.shapes)


def _is_skinned_to(mesh: RigMesh, joints: Flags) -> bool:
    if mesh.skin is None or not joints.any():
        return False
    return bool((joints[mesh.skin.joints] & (mesh.skin.weights != 0.0)).any())


# --- limits ------------------------------------------------------------------------------------------


def author_limits(layer: Sdf.Layer, rig: Rig) -> None:
    """Say the ranges of the weights where USD itself looks for them: `limits` of blendShapeWeights.

    USD before 25.11 cannot author them; it reads past them without a word.  Weights without a control of
    their own keep to 0 and 1.
    """
    if not hasattr(Usd, "AttributeLimits"):
        return
    for skeleton in rig.skeletons:
        ranges = _weight_ranges(rig, skeleton.animation) if skeleton.animation else np.zeros((0, 2))
        if len(ranges):
            spec = Sdf.CreatePrimInLayer(layer, skeleton.animation)
            if "blendShapeWeights" not in spec.properties:
                weights = Sdf.AttributeSpec(spec, "blendShapeWeights", Sdf.ValueTypeNames.FloatArray)
                low, high = (Vt.FloatArray.FromNumpy(column.astype(np.float32)) for column in ranges.T)
                weights.SetInfo("limits", {"soft": {"minimum": low, "maximum": high}})


def _weight_ranges(rig: Rig, animation: str) -> Floats:
    """(weights, 2) least and largest weight of each blend shape of a SkelAnimation, in its order."""
    own = {i: channel.index for i, channel in enumerate(rig.channels) if channel.animation == animation}
    ranges = np.tile([0.0, 1.0], (max(own.values(), default=-1) + 1, 1))
    for control in rig.controls:
        if _is_plain(rig, control) and int(control.drive.channels[0]) in own:
            ranges[own[int(control.drive.channels[0])]] = control.minimum, control.maximum
    return ranges
