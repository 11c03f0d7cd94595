"""The controls of a rig: blend-shape weights, joint degrees of freedom and poses."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np

from usdrigui.conventions.sides import twins_by_name
from usdrigui.errors import Faults, Issue, issue, refuse
from usdrigui.joint_tree import Tree
from usdrigui.model import (
    Channel,
    Clip,
    Control,
    ControlKind,
    Drive,
    Floats,
    Joint,
    LeftOff,
    RigMesh,
)
from usdrigui.rotation import rotation_part, rotation_vectors
from usdrigui.settings import ControlSettings, JointSettings, ReadSettings
from usdrigui.usd.joint_defaults import Turn, default_turns, posed_locals
from usdrigui.usd.ranges import Authored, Range, blend_shape_range

_AXES = "xyz"
_STILL = 1e-7
"""Radians, scene units relative to the skeleton, or logarithms of scale below which a pose moves
nothing."""

_DECIMALS = 12
"""Of radians and of logarithms of scale."""
_KEY_DEGREES = 10.0
"""Between the keys of a control that moves joints on arcs."""
_SLIGHT = 1e-3
"""Share of the greatest translation, or of scale, by which an animation may move a joint
unmentioned."""


@dataclass(frozen=True)
class State:
    """Everything a pose can set: (..., channels) weights and (..., joints, 4, 4) local
    transforms."""

    weights: Floats
    locals: Floats


@dataclass(frozen=True)
class NamedPose:
    """A pose or clip to make a control of, as keys from 0 (base pose) to 1."""

    name: str
    values: Floats
    """(k,) ascending from 0 to 1."""
    states: State
    """(k, ...) absolute."""


@dataclass(frozen=True)
class Draft:
    """A control before the configuration is applied."""

    name: str
    label: str
    kind: ControlKind
    source: str
    range: Range
    drive: Drive


def blend_shape_drafts(
    channels: tuple[Channel, ...],
    used: set[int],
    authored: Authored,
    rest: Floats,
    configured: Mapping[str, ControlSettings],
) -> list[Draft]:
    """One draft per token that some mesh implements; a token of several animations drives them
    all.  `configured` is the configuration of controls."""
    by_token: dict[str, list[int]] = {}
    for index, channel in enumerate(channels):
        if index in used:
            by_token.setdefault(channel.token, []).append(index)
    drafts = []
    configured = _with_ranges_of_twins(by_token, configured)
    for token, indices in by_token.items():
        override = configured.get(token, ControlSettings())
        span = _hull(
            [blend_shape_range(index, authored, override, float(rest[index])) for index in indices]
        )
        drafts.append(Draft(token, "", "blendShape", token, span, _weight_drive(indices, span)))
    return drafts


def joint_drafts(
    joints: tuple[Joint, ...],
    clip: Clip | None,
    named_poses: bool,
    settings: ReadSettings,
    configured: Mapping[str, JointSettings],
) -> list[Draft]:
    """Rotations of joints about their own axes, in degrees from the base pose; `configured` is what
    the configuration asks of joints."""
    names = joint_names(joints)
    spans = _animated_spans(joints, clip) if clip is not None else np.zeros((len(joints), 3, 2))
    drafts = []
    for index, joint in enumerate(joints):
        override = joint_settings(joint.path, joints, configured)
        for axis in range(3):
            span = _joint_range(override, axis, spans[index, axis], named_poses, settings)
            if span is not None:
                name = f"{names[index]}:r{_AXES[axis]}"
                label = f"{override.label} {_AXES[axis]}" if override and override.label else ""
                drafts.append(
                    Draft(
                        name, label, "joint", joint.path, span, _rotation_drive(index, axis, span)
                    )
                )
    return drafts


def default_joint_drafts(
    joints: tuple[Joint, ...], meshes: tuple[RigMesh, ...], weights: int
) -> list[Draft]:
    """The controls of a rig that joints alone drive, in degrees from the base pose; `weights` is
    its number of channels."""
    names, drafts = joint_names(joints), []
    tree = Tree(joints, meshes)
    for turn in default_turns(tree):
        span = Range(turn.range[0], 0.0, turn.range[1], "default")
        name, source = f"{names[turn.joints[0]]}:{turn.name}", joints[turn.home].path
        drafts.append(Draft(name, "", "joint", source, span, _turn_drive(tree, turn, weights)))
    return drafts


def _turn_drive(tree: Tree, turn: Turn, weights: int) -> Drive:
    low, high = turn.range
    if not tree.flat:
        values = np.array([low, high])
        turns = np.radians(values)[:, None, None] * turn.axes[None]
        still = np.zeros_like(turns)
        return Drive(
            values, _NO_INDICES, np.zeros((2, 0)), np.array(turn.joints), turns, still, still
        )
    # Joints of a flat skeleton go round the joint that turns: keys every few degrees follow their
    # arcs.
    steps = int(np.ceil((high - low) / _KEY_DEGREES))
    values = np.union1d(np.linspace(low, high, steps + 1), [0.0])
    states = State(np.zeros((len(values), weights)), posed_locals(tree, turn, values))
    base = State(np.zeros(weights), np.array([joint.base for joint in tree.joints]))
    return pose_drives([NamedPose(turn.name, values, states)], base)[0]


def ignored_motion(root: str, joints: tuple[Joint, ...], clip: Clip | None) -> tuple[Issue, ...]:
    """A note on joints that the animation translates or scales, which no joint control can do."""
    if clip is None or not joints:
        return ()
    places, rows = clip.locals[:, :, 3, :3], np.linalg.norm(clip.locals[:, :, :3, :3], axis=-1)
    size = float(np.abs(places).max(initial=0.0))
    moved = (np.ptp(places, axis=0) > _SLIGHT * size).any(axis=1) | (
        np.ptp(rows, axis=0) > _SLIGHT
    ).any(axis=1)
    names = [joints[i].path.rsplit("/", 1)[-1] for i in np.flatnonzero(moved)]
    if not names:
        return ()
    listed = ", ".join(names[:3]) + (" and more" if len(names) > 3 else "")
    return (issue("JOINT_MOTION_IGNORED", root, f"{len(names)} joints: {listed}"),)


def pose_drafts(
    poses: list[NamedPose], base: State, taken: set[str]
) -> tuple[list[Draft], list[LeftOff]]:
    """A control from 0 (base pose) to 1 (the pose, or the end of the clip) for each pose that moves
    anything."""
    drafts, left_off = [], []
    for pose, drive in zip(poses, pose_drives(poses, base), strict=True):
        name = pose.name if pose.name not in taken else f"{pose.name}:pose"
        if len(drive.channels) or len(drive.joints):
            span = Range(0.0, 0.0, 1.0, "default")
            drafts.append(Draft(name, "", "pose", pose.name, span, drive))
        else:
            left_off.append(LeftOff(name, "read", "the pose equals the base pose"))
    return drafts, left_off


_ANY_RANGE = Range(0.0, 0.0, 1.0, "default")
"""Of a control whose own is refused, so that its other faults are found too."""


def settled(
    drafts: list[Draft], configured: Mapping[str, ControlSettings], faults: Faults
) -> tuple[tuple[Control, ...], tuple[Control, ...], list[LeftOff]]:
    """The controls after ranges, names and labels of the configuration, and those that it excludes.

    Collects CONFIG_VALUE for a range that is not ascending or does not hold the default, and for a
    new name that is already taken.
    """
    controls: list[Control] = []
    excluded: list[Control] = []
    left_off: list[LeftOff] = []
    names: set[str] = set()
    configured = _with_ranges_of_twins([draft.name for draft in drafts], configured)
    for draft in drafts:
        override = configured.get(draft.name, ControlSettings())
        if override.exclude:
            left_off.append(LeftOff(draft.name, "config", "excluded by the configuration"))
            if draft.range.maximum > draft.range.minimum:
                excluded.append(_control(draft, draft.name, override.label, draft.range))
            continue
        span = _ANY_RANGE
        with faults.collected():
            span = _ranged(draft, override)
        if span.maximum <= span.minimum:
            left_off.append(
                LeftOff(draft.name, "read", f"its range is the single value {span.minimum:g}")
            )
            continue
        name = override.rename or draft.name
        if name in names:
            where = f'controls."{draft.name}".rename'
            faults.add([issue("CONFIG_VALUE", where, f"two controls would be called {name!r}")])
        names.add(name)
        controls.append(_control(draft, name, override.label, span))
    return tuple(controls), tuple(excluded), left_off


def _with_ranges_of_twins(
    names: Collection[str], configured: Mapping[str, ControlSettings]
) -> Mapping[str, ControlSettings]:
    """The configuration with a range that is set for one side of the character set for its twin by
    name too, unless that has one of its own or has none by the configuration."""
    found, plain = dict(configured), ControlSettings()
    ranged = [
        name for name, each in configured.items() if (each.minimum, each.maximum) != (None, None)
    ]
    twins = twins_by_name(names) if ranged else {}
    for name in ranged:
        one, twin = configured[name], configured[name].twin or twins.get(name, "")
        other = configured.get(twin, plain)
        is_explicit = (other.minimum, other.maximum) != (None, None) or "none" in (
            one.twin,
            other.twin,
        )
        is_explicit = is_explicit or not other.follow_twin
        if twin in names and twin != name and not is_explicit:
            found[twin] = replace(other, minimum=one.minimum, maximum=one.maximum)
    return found


def _control(draft: Draft, name: str, label: str, span: Range) -> Control:
    return Control(
        name,
        label or draft.label or name,
        draft.kind,
        draft.source,
        span.minimum,
        span.default,
        span.maximum,
        span.source,
        draft.drive if span == draft.range else _redriven(draft.drive, span),
    )


def joint_settings(
    path: str, joints: tuple[Joint, ...], configured: Mapping[str, JointSettings]
) -> JointSettings | None:
    """The configuration of a joint by its full path or, where no other joint has it, its last
    name."""
    if path in configured:
        return configured[path]
    leaf = path.rsplit("/", 1)[-1]
    if leaf in configured and sum(each.path.rsplit("/", 1)[-1] == leaf for each in joints) == 1:
        return configured[leaf]
    return None


def pose_drives(poses: list[NamedPose], base: State) -> list[Drive]:
    """What each pose adds to the base pose, on the joints and channels that it changes."""
    if not poses:
        return []
    local = np.concatenate([pose.states.locals for pose in poses])
    frame, base_frame = rotation_part(local), rotation_part(base.locals)
    # What is nearly still is the difference of numbers about one, whose last bits differ between
    # processors.
    turns = np.round(rotation_vectors(frame @ np.swapaxes(base_frame, -1, -2)), _DECIMALS) + 0.0
    shifts = local[..., 3, :3] - base.locals[..., 3, :3]
    scales = (
        np.round(_log_scales(local, frame) - _log_scales(base.locals, base_frame), _DECIMALS) + 0.0
    )
    ends = np.cumsum([len(pose.values) for pose in poses])[:-1]
    parts = zip(poses, *(np.split(table, ends) for table in (turns, shifts, scales)), strict=True)
    size = max(float(np.abs(base.locals[..., 3, :3]).max(initial=0.0)), 1e-30)
    return [
        _pose_drive(pose, base, unwrapped(turn), shift, scale, size)
        for pose, turn, shift, scale in parts
    ]


def _pose_drive(
    pose: NamedPose, base: State, turns: Floats, shifts: Floats, scales: Floats, size: float
) -> Drive:
    moving = np.flatnonzero(
        (np.abs(turns) > _STILL).any(axis=(0, 2))
        | (np.abs(shifts) > _STILL * size).any(axis=(0, 2))
        | (np.abs(scales) > _STILL).any(axis=(0, 2))
    )
    weights = pose.states.weights - base.weights
    channels = np.flatnonzero((np.abs(weights) > _STILL).any(axis=0))
    moves = (table[:, moving] for table in (turns, shifts, scales))
    return Drive(pose.values, channels, weights[:, channels], moving, *moves)


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
    diagonal = np.abs(np.diagonal(stretch, axis1=-2, axis2=-1))
    return np.asarray(np.log(np.maximum(diagonal, 1e-9)), dtype=np.float64)


# --- drives and ranges ----------------------------------------------------------------------------


_NO_INDICES = np.zeros(0, dtype=np.int64)
_NO_MOVES = np.zeros((2, 0, 3))


def _weight_drive(channels: list[int], span: Range) -> Drive:
    low, high = span.minimum - span.default, span.maximum - span.default
    weights = np.array([[low] * len(channels), [high] * len(channels)])
    values = np.array([span.minimum, span.maximum])
    return Drive(values, np.array(channels), weights, _NO_INDICES, _NO_MOVES, _NO_MOVES, _NO_MOVES)


def _rotation_drive(joint: int, axis: int, span: Range) -> Drive:
    values = np.array([span.minimum, span.maximum])
    turns = np.zeros((2, 1, 3))
    turns[:, 0, axis] = np.radians(values - span.default)
    still = np.zeros((2, 1, 3))
    return Drive(
        values,
        np.zeros(0, dtype=np.int64),
        np.zeros((2, 0)),
        np.array([joint], dtype=np.int64),
        turns,
        still,
        still,
    )


def _redriven(drive: Drive, span: Range) -> Drive:
    """A two-key drive over another range with the same slope; a pose's keys stay."""
    if len(drive.values) != 2:
        return drive
    values = np.array([span.minimum, span.maximum])
    step = drive.values[1] - drive.values[0]
    tables = []
    for table in (drive.weights, drive.rotations, drive.translations, drive.scales):
        slope = (table[1] - table[0]) / step
        tables.append((values - span.default).reshape(-1, *(1,) * (table.ndim - 1)) * slope)
    weights, turns, shifts, scales = tables
    return Drive(values, drive.channels, weights, drive.joints, turns, shifts, scales)


def _ranged(draft: Draft, override: ControlSettings) -> Range:
    """The draft's range after the configuration, checked."""
    span = draft.range
    if draft.kind != "blendShape" and (override.minimum, override.maximum, override.default) != (
        None,
        None,
        None,
    ):
        minimum = span.minimum if override.minimum is None else override.minimum
        maximum = span.maximum if override.maximum is None else override.maximum
        if override.default not in (None, span.default):
            raise refuse(
                "CONFIG_VALUE", f'controls."{draft.name}".default', "joints and poses rest at 0"
            )
        span = Range(minimum, span.default, maximum, "config")
    if span.source == "config" and not span.minimum <= span.default <= span.maximum:
        raise refuse(
            "CONFIG_VALUE",
            f'controls."{draft.name}"',
            f"minimum {span.minimum:g}, default {span.default:g} and maximum {span.maximum:g} must"
            " ascend",
        )
    return span


def _hull(ranges: list[Range]) -> Range:
    if len(ranges) == 1:
        return ranges[0]
    widest = max(ranges, key=lambda each: each.maximum - each.minimum)
    return Range(
        min(each.minimum for each in ranges),
        ranges[0].default,
        max(each.maximum for each in ranges),
        widest.source,
    )


# --- joints ---------------------------------------------------------------------------------------


def joint_names(joints: tuple[Joint, ...]) -> list[str]:
    """The last name of each joint, or its whole path where that is not unique."""
    leaves = [joint.path.rsplit("/", 1)[-1] for joint in joints]
    paths = [joint.path for joint in joints]
    names = [
        leaf if leaves.count(leaf) == 1 else path for leaf, path in zip(leaves, paths, strict=True)
    ]
    return [
        name if names.count(name) == 1 else f"{joint.skeleton}/{name}"
        for name, joint in zip(names, joints, strict=True)
    ]


def _animated_spans(joints: tuple[Joint, ...], clip: Clip) -> Floats:
    """(joints, 3, 2) least and greatest rotation about each own axis, in degrees from the base
    pose.

    Without the noise of quaternions in single precision: some 1e-5 degrees.
    """
    base = rotation_part(np.array([joint.base for joint in joints]).reshape(-1, 4, 4))
    turns = unwrapped(rotation_vectors(rotation_part(clip.locals) @ np.swapaxes(base, -1, -2)))
    spans = np.stack([turns.min(axis=0), turns.max(axis=0)], axis=-1)
    return np.asarray(np.round(np.degrees(spans), 3) + 0.0, dtype=np.float64)


def _joint_range(
    override: JointSettings | None,
    axis: int,
    span: Floats,
    named_poses: bool,
    settings: ReadSettings,
) -> Range | None:
    """The range of one joint axis, or None if it is no control."""
    if override is not None:
        if _AXES[axis] not in override.axes:
            return None
        return Range(override.minimum, 0.0, override.maximum, "config")
    which = settings.joints
    if which == "none" or (which == "auto" and named_poses):
        return None
    least = settings.joint_min_degrees
    if span[1] - span[0] > least:
        low, high = (float(end) if abs(end) > least else 0.0 for end in span)
        return Range(min(0.0, low), 0.0, max(0.0, high), "animation")
    if which == "all":
        return Range(JointSettings().minimum, 0.0, JointSettings().maximum, "default")
    return None


def unknown_joints(joints: tuple[Joint, ...], configured: Mapping[str, JointSettings]) -> set[str]:
    """Names in ``[joints]`` that fit no joint."""
    return {
        name
        for name, override in configured.items()
        if not any(joint_settings(joint.path, joints, {name: override}) for joint in joints)
    }


def unknown_names(
    drafts: list[Draft], left_off: list[LeftOff], configured: Mapping[str, ControlSettings]
) -> set[str]:
    """Names in ``[controls]`` that neither a draft nor something left off bears."""
    return set(configured) - {draft.name for draft in drafts} - {each.control for each in left_off}
