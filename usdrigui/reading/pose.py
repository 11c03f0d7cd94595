"""Poses that the asset or the configuration names: frames, clips and sets of weights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from pxr import Usd, Vt

from usdrigui.character import Drive, Floats, LeftOff
from usdrigui.character.rotation import rotation_part, rotation_vectors
from usdrigui.errors import Faults, Issue, issue, meant, refuse
from usdrigui.reading.clips import Animated, State
from usdrigui.reading.range import custom_data
from usdrigui.reading.skeleton import Armature
from usdrigui.settings import PoseSettings

_LATEST = 1e15
"""No time code lies beyond."""
_STILL = 1e-6
"""Radians, scene units relative to the skeleton, or logarithms of scale below which a pose moves
nothing: turns of single precision are 2e-7 off, twice the half last bits of a quaternion's vector,
in the pose and in the base pose."""
_DECIMALS = 12
"""Of radians and of logarithms of scale."""


@dataclass(frozen=True)
class NamedPose:
    """A pose or clip to make a control of, as keys from 0 (base pose) to 1."""

    name: str
    values: Floats
    """(k,) ascending from 0 to 1."""
    states: State
    """(k, ...) absolute."""


@dataclass(frozen=True)
class Frame:
    """A time code that the asset gives a pose's name."""

    name: str
    time: float


@dataclass(frozen=True)
class FrameNames:
    """The frames that the asset names; the first one is the rest pose."""

    frames: tuple[Frame, ...] = ()
    left_off: tuple[LeftOff, ...] = ()


def read_frame_names(
    root: Usd.Prim, armatures: tuple[Armature, ...], key: str, issues: list[Issue]
) -> FrameNames:
    """Names of frames from custom data: a list with one name per authored frame, or a table of time
    codes."""
    value = custom_data(root, key) if key else None
    times = sorted({time for armature in armatures for time in armature.times})
    if value is None or not times:
        return FrameNames()
    if isinstance(value, Mapping):
        named = sorted((float(time), str(name)) for name, time in value.items() if _is_time(time))
        return FrameNames(tuple(Frame(name, time) for time, name in named))
    is_list = isinstance(value, (list, Vt.StringArray, Vt.TokenArray))
    names = [*map(str, value)] if is_list else []
    if len(names) != len(times):
        what = f"{len(names)} names in {key!r}, {len(times)} frames"
        issues.append(issue("POSES_MISMATCH", root.GetPath(), what))
    frames = tuple(Frame(name, time) for name, time in zip(names, times, strict=False))
    why = "the animation has no frame for it"
    return FrameNames(frames, tuple(LeftOff(name, "read", why) for name in names[len(times) :]))


def _is_time(value: object) -> bool:
    """Whether it is a number that can be a time code; JSON has integers of any length."""
    return isinstance(value, (int, float)) and -_LATEST < value < _LATEST


def named_poses(
    frames: tuple[Frame, ...],
    animated: Animated,
    configured: Mapping[str, PoseSettings],
    faults: Faults,
) -> list[NamedPose]:
    """The poses of the asset's frames, all but the first, and those of the configuration, which
    win.

    Collects CONFIG_VALUE for a configured pose without values or a SkelAnimation that is not
    bound, and CONFIG_UNKNOWN_CONTROL for a weight that the rig does not have.
    """
    base = animated.base
    poses = [
        _single(frame.name, base, animated.state(frame.time))
        for frame in frames[1:]
        if frame.name not in configured
    ]
    for name, pose in configured.items():
        with faults.collected():
            poses.append(_configured(name, pose, animated))
    return poses


def _single(name: str, base: State, state: State) -> NamedPose:
    """A pose of one state."""
    return NamedPose(name, np.array([0.0, 1.0]), State.stacked([base, state]))


def _configured(name: str, configured: PoseSettings, animated: Animated) -> NamedPose:
    where, base = f'poses."{name}"', animated.base
    if configured.weights:
        weights = _weighted(configured.weights, animated, f"{where}.weights")
        return _single(name, base, State(weights, base.locals))
    armatures = _animated_by(configured.animation, animated.armatures, where)
    if configured.frame is not None:
        return _single(name, base, animated.state(configured.frame, armatures))
    if len(configured.clip) != 2 or configured.clip[0] >= configured.clip[1]:
        raise refuse("CONFIG_VALUE", where, "needs a frame, a clip [first, last] or weights")
    first, last = configured.clip
    inner = {time for armature in armatures for time in armature.times if first < time < last}
    times = [first, *sorted(inner), last]
    return _clip(name, base, times, [animated.state(time, armatures) for time in times])


def _weighted(configured: Mapping[str, float], animated: Animated, where: str) -> Floats:
    """(channels,) weights of the base pose but for those that the configuration names."""
    channels = animated.body.channels
    known = dict.fromkeys(channel.token for channel in channels)
    unknown = Faults()
    for token in sorted(configured.keys() - known.keys()):
        what = f"the asset has no weight {token!r}{meant(token, known)}"
        unknown.add([issue("CONFIG_UNKNOWN_CONTROL", where, what)])
    unknown.raise_all()
    weights = animated.base.weights.copy()
    for index, channel in enumerate(channels):
        weights[index] = configured.get(channel.token, weights[index])
    return weights


def _clip(name: str, base: State, times: list[float], states: list[State]) -> NamedPose:
    """A clip as keys: the base pose at 0, then its frames evenly in time to 1.

    A first frame that equals the base pose is not repeated.
    """
    first, last = times[0], times[-1]
    start, is_base = first, np.allclose(states[0].locals, base.locals, atol=1e-7)
    if not (is_base and np.allclose(states[0].weights, base.weights, atol=1e-7)):
        start = first - (last - first) / len(times)
        times, states = [start, *times], [base, *states]
    return NamedPose(name, (np.array(times) - start) / (last - start), State.stacked(states))


def _animated_by(
    animation: str, armatures: tuple[Armature, ...], where: str
) -> tuple[Armature, ...]:
    if not animation:
        return armatures
    bound = tuple(armature for armature in armatures if armature.record.animation == animation)
    if not bound:
        known = sorted({armature.record.animation for armature in armatures if armature.animation})
        what = f"{animation} drives no Skeleton; there are {', '.join(known) or 'none'}"
        raise refuse("CONFIG_VALUE", f"{where}.animation", what)
    return bound


# --- drives ---------------------------------------------------------------------------------------


def pose_drive(pose: NamedPose, base: State) -> Drive:
    """What a pose adds to the base pose, on the joints and channels that it changes."""
    moves = moves_from(base.locals, pose.states.locals)
    # What is nearly still is the difference of numbers about one, whose last bits differ between
    # processors.
    moves[:, ::2] = np.round(moves[:, ::2], _DECIMALS) + 0.0
    moves[:, 0] = unwrapped(moves[:, 0])
    size = max(float(np.abs(base.locals[..., 3, :3]).max(initial=0.0)), 1e-30)
    still = _STILL * np.array([1.0, size, 1.0])[:, None, None]
    moving = np.flatnonzero((np.abs(moves) > still).any(axis=(0, 1, 3)))
    weights = pose.states.weights - base.weights
    channels = np.flatnonzero((np.abs(weights) > _STILL).any(axis=0))
    return Drive(pose.values, channels, weights[:, channels], moving, moves[:, :, moving])


def moves_from(base: Floats, local: Floats) -> Floats:
    """(..., 3, joints, 3) rotation vectors, translations and logarithms of scales from local
    transforms `base` (joints, 4, 4) to `local`."""
    frame, base_frame = rotation_part(local), rotation_part(base)
    turns = rotation_vectors(frame @ np.swapaxes(base_frame, -1, -2))
    scales = _log_scales(local, frame) - _log_scales(base, base_frame)
    return np.stack([turns, local[..., 3, :3] - base[..., 3, :3], scales], axis=-3)


def unwrapped(vectors: Floats) -> Floats:
    """Rotation vectors (k, j, 3) of the same rotations, each the one nearest to its predecessor."""
    out = vectors.copy()
    for k in range(1, len(out)):
        angle = np.linalg.norm(out[k], axis=-1, keepdims=True)
        unit = np.divide(out[k], angle, out=np.zeros_like(out[k]), where=angle > 0.0)
        along = (out[k - 1] * unit).sum(axis=-1, keepdims=True)
        out[k] = unit * (angle + 2.0 * np.pi * np.round((along - angle) / (2.0 * np.pi)))
    return out


def _log_scales(local: Floats, frame: Floats) -> Floats:
    stretch = local[..., :3, :3] @ np.swapaxes(frame, -1, -2)
    return np.log(np.maximum(np.abs(np.diagonal(stretch, axis1=-2, axis2=-1)), 1e-9))
