"""Poses that the asset or the configuration names: frames, clips and sets of weights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from pxr import Usd, Vt

from usdrigui.errors import Faults, Issue, issue, meant, refuse
from usdrigui.model import Channel, Joint, LeftOff
from usdrigui.settings import PoseSettings
from usdrigui.usd.controls import NamedPose, State
from usdrigui.usd.ranges import custom_data
from usdrigui.usd.skeleton import Armature, locals_at, weights_at

_LATEST = 1e15
"""No time code lies beyond."""


@dataclass(frozen=True)
class Frame:
    """A time code that the asset gives a pose's name."""

    name: str
    time: float


@dataclass(frozen=True)
class FrameNames:
    """The frames that the asset names; the first one is the rest pose."""

    frames: tuple[Frame, ...]
    left_off: tuple[LeftOff, ...]
    issues: tuple[Issue, ...]


def read_frame_names(root: Usd.Prim, armatures: tuple[Armature, ...], key: str) -> FrameNames:
    """Names of frames from custom data: a list with one name per authored frame, or a table of time
    codes."""
    value = custom_data(root, key) if key else None
    times = sorted({time for armature in armatures for time in armature.times})
    if value is None or not times:
        return FrameNames((), (), ())
    if isinstance(value, Mapping):
        named = sorted((float(time), str(name)) for name, time in value.items() if _is_time(time))
        return FrameNames(tuple(Frame(name, time) for time, name in named), (), ())
    names = (
        [str(name) for name in value]
        if isinstance(value, (list, Vt.StringArray, Vt.TokenArray))
        else []
    )
    frames = tuple(Frame(name, time) for name, time in zip(names, times, strict=False))
    lost = tuple(
        LeftOff(name, "read", "the animation has no frame for it") for name in names[len(times) :]
    )
    issues: tuple[Issue, ...] = ()
    if len(names) != len(times):
        issues = (
            issue(
                "POSES_MISMATCH",
                str(root.GetPath()),
                f"{len(names)} names in {key!r}, {len(times)} frames",
            ),
        )
    return FrameNames(frames, lost, issues)


def _is_time(value: object) -> bool:
    """Whether it is a number that can be a time code; JSON has integers of any length."""
    return isinstance(value, (int, float)) and -_LATEST < value < _LATEST


def named_poses(
    frames: tuple[Frame, ...],
    armatures: tuple[Armature, ...],
    joints: tuple[Joint, ...],
    channels: tuple[Channel, ...],
    base: State,
    configured: Mapping[str, PoseSettings],
    faults: Faults,
) -> list[NamedPose]:
    """The poses of the asset's frames, all but the first, and those of the configuration, which
    win.

    Collects CONFIG_VALUE for a configured pose without values or a SkelAnimation that is not
    bound, and CONFIG_UNKNOWN_CONTROL for a weight that the rig does not have.
    """
    source = _Source(armatures, joints, channels, base)
    poses = [
        NamedPose(frame.name, np.array([0.0, 1.0]), source.keys([frame.time]))
        for frame in frames[1:]
        if frame.name not in configured
    ]
    for name, each in configured.items():
        with faults.collected():
            poses.append(_configured(name, each, source))
    return poses


class _Source:
    """Absolute states from which poses are made, each read once."""

    def __init__(
        self,
        armatures: tuple[Armature, ...],
        joints: tuple[Joint, ...],
        channels: tuple[Channel, ...],
        base: State,
    ) -> None:
        self.armatures, self.joints, self.channels, self.base = armatures, joints, channels, base

    def keys(self, times: list[float], armatures: tuple[Armature, ...] | None = None) -> State:
        """The base pose followed by the animation at `times`; what `armatures` leaves out stays at
        the base."""
        states = [self.base, *(self._at(time, armatures or self.armatures) for time in times)]
        return State(
            np.stack([each.weights for each in states]), np.stack([each.locals for each in states])
        )

    def weighted(self, weights: Mapping[int, float]) -> State:
        """The base pose followed by absolute weights of channels."""
        posed = self.base.weights.copy()
        for channel, weight in weights.items():
            posed[channel] = weight
        return State(np.stack([self.base.weights, posed]), np.stack([self.base.locals] * 2))

    def _at(self, time: float, armatures: tuple[Armature, ...]) -> State:
        weights, local = self.base.weights.copy(), self.base.locals.copy()
        animations = {each.record.animation for each in armatures}
        here = np.array(
            [channel.animation in animations and channel.index >= 0 for channel in self.channels],
            bool,
        )
        weights[here] = weights_at(self.armatures, self.channels, time)[here]
        for armature in armatures:
            part = slice(armature.first, armature.first + len(armature.joint_names))
            rest = np.array([joint.rest for joint in self.joints[part]]).reshape(-1, 4, 4)
            local[part] = locals_at(armature.query, time, rest)
        return State(weights, local)


def _configured(name: str, configured: PoseSettings, source: _Source) -> NamedPose:
    where = f'poses."{name}"'
    if configured.weights:
        by_token: dict[str, list[int]] = {}
        for index, channel in enumerate(source.channels):
            by_token.setdefault(channel.token, []).append(index)
        unknown = Faults()
        for token in sorted(set(configured.weights) - set(by_token)):
            what = f"the asset has no weight {token!r}{meant(token, by_token)}"
            unknown.add([issue("CONFIG_UNKNOWN_CONTROL", f"{where}.weights", what)])
        unknown.raise_all()
        chosen = {
            index: weight
            for token, weight in configured.weights.items()
            for index in by_token[token]
        }
        return NamedPose(name, np.array([0.0, 1.0]), source.weighted(chosen))
    armatures = _animated_by(configured.animation, source.armatures, where)
    if configured.frame is not None:
        return NamedPose(name, np.array([0.0, 1.0]), source.keys([configured.frame], armatures))
    return _clip(name, configured, source, armatures, where)


def _clip(
    name: str,
    configured: PoseSettings,
    source: _Source,
    armatures: tuple[Armature, ...],
    where: str,
) -> NamedPose:
    """A clip as keys: the base pose at 0, then its frames evenly in time to 1.

    A first frame that equals the base pose is not repeated.
    """
    if len(configured.clip) != 2 or configured.clip[0] >= configured.clip[1]:
        raise refuse("CONFIG_VALUE", where, "needs a frame, a clip [first, last] or weights")
    first, last = configured.clip
    inner = {time for armature in armatures for time in armature.times if first < time < last}
    times = [first, *sorted(inner), last]
    states = source.keys(times, armatures)
    if np.allclose(states.locals[1], states.locals[0], atol=1e-7) and np.allclose(
        states.weights[1], states.weights[0], atol=1e-7
    ):
        states, start = State(states.weights[1:], states.locals[1:]), first
    else:
        start = first - (last - first) / len(times)
    spread = np.array(times if len(states.weights) == len(times) else [start, *times])
    return NamedPose(name, (spread - start) / (last - start), states)


def _animated_by(
    animation: str, armatures: tuple[Armature, ...], where: str
) -> tuple[Armature, ...]:
    if not animation:
        return armatures
    bound = tuple(armature for armature in armatures if armature.record.animation == animation)
    if not bound:
        known = ", ".join(
            sorted({armature.record.animation for armature in armatures if armature.animation})
        )
        raise refuse(
            "CONFIG_VALUE",
            f"{where}.animation",
            f"{animation} drives no Skeleton; there are {known or 'none'}",
        )
    return bound
