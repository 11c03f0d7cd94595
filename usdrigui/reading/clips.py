"""Authored animation: the state of a character at any time, its clip, and SkelAnimations frame by
frame."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from pxr import Usd, UsdSkel
from scipy.spatial.transform import Rotation

from usdrigui.character import Body, Channel, Clip, Floats, Performance
from usdrigui.character.skinning import base_locals
from usdrigui.errors import Issue, RigUIError, issue, refuse
from usdrigui.reading.skeleton import Armature, locals_at
from usdrigui.stages.arrays import check_finite, floats, quaternions, tokens
from usdrigui.stages.opening import open_stage

_CLIP_BYTES = 128 * 1024 * 1024
"""Memory that a clip may take."""
MOST_FRAMES = 4096
"""Frames kept of one animation, evenly spread over its length."""
_LONGEST = 1e5
"""Time codes of the longest stage that is played without a clip."""


@dataclass(frozen=True)
class State:
    """Everything a pose can set: (..., channels) weights and (..., joints, 4, 4) local
    transforms."""

    weights: Floats
    locals: Floats

    @classmethod
    def stacked(cls, states: Sequence[State]) -> State:
        """Several of them as one, in their order."""
        weights = np.stack([state.weights for state in states])
        return cls(weights, np.stack([state.locals for state in states]))


@dataclass(frozen=True)
class Animated:
    """What poses a character, and whom to ask for its poses."""

    armatures: tuple[Armature, ...]
    body: Body

    @cached_property
    def base(self) -> State:
        """The base pose."""
        return State(self.body.base_weights, base_locals(self.body.joints))

    def state(self, time: float, armatures: tuple[Armature, ...] = ()) -> State:
        """The animation of `armatures`, all if none are given, at a time code; the rest stays in
        the base pose.

        Raises ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE for weights.
        """
        weights, local = self.base.weights.copy(), self.base.locals.copy()
        authored = weights_at(self.armatures, self.body.channels, time)
        for armature in armatures or self.armatures:
            part = slice(armature.first, armature.first + len(armature.joint_names))
            rest = np.array([joint.rest for joint in self.body.joints[part]]).reshape(-1, 4, 4)
            local[part] = locals_at(armature, time, rest)
            for index, channel in enumerate(self.body.channels):
                if channel.index >= 0 and channel.animation == armature.record.animation:
                    weights[index] = authored[index]
        return State(weights, local)


def read_clip(animated: Animated, rate: float, issues: list[Issue]) -> Clip | None:
    """The authored animation, or None where nothing has more than one time sample.

    Raises ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE.
    """
    armatures, body = animated.armatures, animated.body
    times = sorted({time for armature in armatures for time in armature.times})
    if len(times) < 2:
        return None
    most = max(2, _CLIP_BYTES // (128 * len(body.joints) + 8 * len(body.channels) + 1))
    if len(times) > most:
        path, what = armatures[0].record.animation, f"{most} of {len(times)} frames kept"
        issues.append(issue("CLIP_THINNED", path, what))
        times = [times[i] for i in np.linspace(0, len(times) - 1, most).round().astype(int)]
    return _sampled(animated, times, rate)


def read_still(animated: Animated, rate: float) -> Clip | None:
    """The one frame that USD evaluates where nothing moves; None where it cannot be shown."""
    time = min((time for armature in animated.armatures for time in armature.times), default=0.0)
    try:
        return _sampled(animated, [time], rate)
    except RigUIError:
        return None


def _sampled(animated: Animated, times: list[float], rate: float) -> Clip:
    """Weights and joints at each of `times`, which USD holds before the first and after the
    last."""
    states = State.stacked([animated.state(time) for time in times])
    if not np.isfinite(states.locals).all():
        raise refuse(
            "NOT_FINITE",
            animated.armatures[0].record.animation,
            "the animation holds NaN or infinity",
        )
    return Clip(np.array(times, dtype=np.float64), states.weights, states.locals, rate)


def weights_at(
    armatures: tuple[Armature, ...], channels: tuple[Channel, ...], time: float | None
) -> Floats:
    """(channels,) authored weights at a time code; None for the default value.

    Raises ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE.
    """
    tables = {armature.record.animation: _weights(armature, time) for armature in armatures}
    values = [
        (
            tables[each.animation][each.index]
            if each.index >= 0 and len(tables[each.animation])
            else 0.0
        )
        for each in channels
    ]
    return np.array(values, dtype=np.float64)


def _weights(armature: Armature, time: float | None) -> Floats:
    """Weights of the animation's tokens; empty where none are authored."""
    if armature.animation is None or not armature.tokens:
        return np.zeros(0)
    code = Usd.TimeCode.Default() if time is None else Usd.TimeCode(time)
    animation = UsdSkel.Animation(armature.animation.GetPrim())
    return checked_weights(animation, armature.record.animation, len(armature.tokens), code)


def checked_weights(
    animation: UsdSkel.Animation, path: object, count: int, code: Usd.TimeCode
) -> Floats:
    """(count,) weights of an animation at a time code, or none where none are authored.

    Raises ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE for the animation at `path`.
    """
    authored = floats(animation.GetBlendShapeWeightsAttr().Get(code), path, "blendShapeWeights")
    if len(authored) not in (0, count):
        counts = f"{count} blendShapes but {len(authored)} blendShapeWeights"
        when = "" if code.IsDefault() else f" at time {code.GetValue():g}"
        raise refuse("ANIMATION_LENGTH", path, f"{counts}{when}")
    check_finite(authored, path, "blendShapeWeights")
    return np.asarray(authored, dtype=np.float64)


# --- of any character -----------------------------------------------------------------------------


def read_performances(path: Path) -> tuple[Performance, ...]:
    """The animations of a file that have more than one time sample, in stage order.

    Raises ANIMATION_MISSING where there is none, ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE, and
    as `open_stage`.
    """
    stage = open_stage(path)
    prims = [
        prim
        for prim in Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies())
        if prim.IsA(UsdSkel.Animation)
    ]
    moving = [UsdSkel.Animation(prim) for prim in prims if len(_authored_times(prim)) > 1]
    if not moving:
        what = f"{len(prims)} SkelAnimations, none with" if prims else "no SkelAnimation with"
        raise refuse("ANIMATION_MISSING", path, f"has {what} more than one time sample")
    return tuple(_performance(path, animation) for animation in moving)


def _authored_times(prim: Usd.Prim) -> list[float]:
    animation = UsdSkel.Animation(prim)
    attributes = (animation.GetBlendShapeWeightsAttr(), animation.GetRotationsAttr())
    return sorted({time for attribute in attributes for time in attribute.GetTimeSamples()})


def _performance(path: Path, animation: UsdSkel.Animation) -> Performance:
    times, where = _authored_times(animation.GetPrim()), str(animation.GetPath())
    length = times[-1] - times[0]
    if not np.isfinite(length):
        raise refuse(
            "NOT_FINITE", where, f"its time samples reach from {times[0]:g} to {times[-1]:g}"
        )
    frames = np.linspace(times[0], times[-1], max(2, int(min(MOST_FRAMES - 1, length)) + 1))
    names = tokens(animation.GetBlendShapesAttr().Get(), where, "blendShapes")
    joints = tokens(animation.GetJointsAttr().Get(), where, "joints")
    return Performance(
        source=path.name,
        path=where,
        times=frames,
        tokens=names,
        weights=_table(animation.GetBlendShapeWeightsAttr(), frames, len(names)),
        joints=joints,
        rotations=_turns(_table(animation.GetRotationsAttr(), frames, len(joints), 4)),
    )


def _table(attribute: Usd.Attribute, frames: Floats, width: int, parts: int = 1) -> Floats:
    """(frames, width) values, or (frames, width, 4) quaternions, real part first; zero where
    nothing is authored."""
    table = np.zeros((len(frames), width, parts))
    where, read = attribute.GetPath(), floats if parts == 1 else quaternions
    for row, time in enumerate(frames.tolist()):
        values = attribute.Get(time)
        if values is None or not width:
            break
        numbers = read(values, attribute.GetPrimPath(), attribute.GetName())
        if len(numbers) != width:
            raise refuse(
                "ANIMATION_LENGTH",
                where,
                f"{len(numbers)} values for {width} names at time {time:g}",
            )
        table[row] = numbers.reshape(width, parts)
    if not np.isfinite(table).all():
        raise refuse("NOT_FINITE", where, "the animation holds NaN or infinity")
    return table[..., 0] if parts == 1 else table


def _turns(quaternions: Floats) -> Floats:
    """(frames, joints, 3, 3) rotations; the identity for a quaternion of no length."""
    imaginary_first = np.roll(quaternions, -1, axis=-1).reshape(-1, 4)
    imaginary_first[~imaginary_first.any(axis=1), 3] = 1.0
    turned = Rotation.from_quat(imaginary_first).inv().as_matrix()  # for row vectors
    return np.asarray(turned.reshape(*quaternions.shape[:2], 3, 3))


def time_codes(stage: Usd.Stage) -> tuple[float, float, float] | None:
    """First and last time code of a stage and how many make a second; None without a range that can
    be played."""
    first, last = float(stage.GetStartTimeCode()), float(stage.GetEndTimeCode())
    rate = float(stage.GetTimeCodesPerSecond())
    playable = 0.0 < last - first < _LONGEST and 0.0 < rate < math.inf
    return (first, last, rate) if stage.HasAuthoredTimeCodeRange() and playable else None
