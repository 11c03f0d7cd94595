"""The controls of a rig: blend-shape weights, joint degrees of freedom and poses."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from usdrigui.character import Body, Clip, Control, ControlKind, Drive, Floats, Joint, LeftOff
from usdrigui.character.joint_tree import Tree
from usdrigui.character.rotation import rotation_part, rotation_vectors
from usdrigui.character.skinning import base_frames, base_locals
from usdrigui.conventions.sides import twins_by_name
from usdrigui.errors import Faults, Issue, issue, listed, refuse
from usdrigui.reading.clips import State
from usdrigui.reading.joint import Turn, default_turns, posed_locals
from usdrigui.reading.pose import NamedPose, pose_drive, unwrapped
from usdrigui.reading.range import Range, Source
from usdrigui.settings import ControlSettings, JointSettings, Settings

_AXES = "xyz"
_KEY_DEGREES = 10.0
"""Between the keys of a control that moves joints on arcs."""
_SLIGHT = 1e-3
"""Share of the greatest translation, or of scale, by which an animation may move a joint
unmentioned."""


@dataclass(frozen=True)
class Draft:
    """A control before the configuration is applied."""

    name: str
    label: str
    kind: ControlKind
    source: str
    range: Range
    drive_over: Callable[[Range], Drive]
    """Its drive over a range that the configuration gives it."""


def blend_shape_drafts(
    body: Body, ranges: Sequence[Range], names: Mapping[str, str]
) -> list[Draft]:
    """One draft per token that some mesh implements; a token of several animations drives them
    all, and so do tokens with one of the `names`.  `ranges` are those of the channels."""
    by_name: dict[str, list[int]] = {}
    for index, channel in enumerate(body.channels):
        if index in body.shapes_by_channel:
            by_name.setdefault(names[channel.token], []).append(index)
    return [
        Draft(
            name,
            "",
            "blendShape",
            body.channels[indices[0]].token,
            _hull([ranges[index] for index in indices]),
            partial(_weight_drive, indices),
        )
        for name, indices in by_name.items()
    ]


def joint_drafts(
    joints: tuple[Joint, ...],
    clip: Clip | None,
    which: str,
    settings: Settings,
) -> list[Draft]:
    """Rotations of joints about their own axes, in degrees from the base pose: those that the
    configuration asks for and `which` of the others, as of ``read.joints``."""
    names, turns = joint_names(joints), _animated_turns(joints, clip)
    spans = np.stack([turns.min(axis=0), turns.max(axis=0)], axis=-1)
    drafts = []
    for index, override in enumerate(joint_settings(joints, settings.joints)):
        for axis, letter in enumerate(_AXES):
            span = _joint_range(
                override, axis, spans[index, axis], which, settings.read.joint_min_degrees
            )
            if span is not None:
                name = f"{names[index]}:r{letter}"
                label = f"{override.label} {letter}" if override and override.label else ""
                drive = partial(_turning_drive, [index], np.eye(3)[[axis]])
                drafts.append(Draft(name, label, "joint", joints[index].path, span, drive))
    return drafts


def has_limbs(body: Body) -> bool:
    """Whether the joints make a body: chains part somewhere.  The jaw and the eyes of a bust are
    none."""
    tree = Tree(body.joints, body.meshes)
    return any(len(tree.branches(joint)) > 1 for joint in range(len(body.joints)))


def default_joint_drafts(
    body: Body,
    clip: Clip | None,
    posed: Collection[int],
    configured: Mapping[str, JointSettings],
) -> list[Draft]:
    """The controls that the place of each joint in the skeleton suggests, in degrees from the base
    pose: what the clip does widens their ranges.  Joints that poses set (`posed`) and those that
    are `configured` have none."""
    names, drafts = joint_names(body.joints), []
    tree = Tree(body.joints, body.meshes)
    turns = _animated_turns(body.joints, None if tree.flat else clip)
    asked = enumerate(joint_settings(body.joints, configured))
    taken = {*posed, *(joint for joint, override in asked if override is not None)}
    for turn in default_turns(tree):
        if not taken.isdisjoint(turn.joints):
            continue
        reached = np.einsum("fji,ji->fj", turns[:, list(turn.joints)], turn.axes)
        low, high = float(reached.min()), float(reached.max())
        within = turn.range[0] <= low and high <= turn.range[1]
        evidence: Source = "default" if within else "animation"
        span = Range(min(low, turn.range[0]), 0.0, max(high, turn.range[1]), evidence)
        name, source = f"{names[turn.joints[0]]}:{turn.name}", body.joints[turn.home].path
        drive = partial(_turning_drive, turn.joints, turn.axes)
        if tree.flat:
            drive = partial(_arc_drive, tree, turn, len(body.channels))
        drafts.append(Draft(name, "", "joint", source, span, drive))
    return drafts


def ignored_motion(root: str, joints: tuple[Joint, ...], clip: Clip | None) -> tuple[Issue, ...]:
    """A note on joints that the animation translates or scales, which no joint control can do."""
    if clip is None:
        return ()
    places, rows = clip.locals[:, :, 3, :3], np.linalg.norm(clip.locals[:, :, :3, :3], axis=-1)
    size = float(np.abs(places).max(initial=0.0))
    moved = (np.ptp(places, axis=0) > _SLIGHT * size).any(axis=1) | (
        np.ptp(rows, axis=0) > _SLIGHT
    ).any(axis=1)
    names = [joints[i].name for i in np.flatnonzero(moved)]
    if not names:
        return ()
    what = f"the animation moves or scales {listed(names)}, and controls of joints turn them"
    return (issue("JOINT_MOTION_IGNORED", root, what),)


def pose_drafts(
    poses: list[NamedPose], base: State, taken: set[str]
) -> tuple[list[Draft], list[LeftOff]]:
    """A control from 0 (base pose) to 1 (the pose, or the end of the clip) for each pose that moves
    anything."""
    drafts, left_off = [], []
    for pose in poses:
        drive = pose_drive(pose, base)
        name = pose.name if pose.name not in taken else f"{pose.name}:pose"
        if len(drive.channels) or len(drive.joints):
            drafts.append(Draft(name, "", "pose", pose.name, _WHOLE, partial(_as_posed, drive)))
        else:
            left_off.append(LeftOff(name, "read", "the pose equals the base pose"))
    return drafts, left_off


_WHOLE = Range(0.0, 0.0, 1.0, "default")
"""Of a pose; and of a control whose own is refused, so that its other faults are found too."""


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
            left_off.append(LeftOff(draft.name, "config", "excluded by a setting or a correction"))
            if draft.range.maximum > draft.range.minimum:
                excluded.append(control_of(draft, draft.name, override.label, draft.range))
            continue
        span = _WHOLE
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
        controls.append(control_of(draft, name, override.label, span))
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
        one = configured[name]
        twin = one.twin or twins.get(name, "")
        other = configured.get(twin, plain)
        is_own = twin in ranged or not other.follow_twin or "none" in (one.twin, other.twin)
        if twin in names and not is_own:
            found[twin] = replace(other, minimum=one.minimum, maximum=one.maximum)
    return found


def _ranged(draft: Draft, override: ControlSettings) -> Range:
    """The draft's range after the configuration, checked."""
    span, default = draft.range, override.default
    if (override.minimum, default, override.maximum) != (None, None, None):
        minimum = span.minimum if override.minimum is None else override.minimum
        maximum = span.maximum if override.maximum is None else override.maximum
        if draft.kind != "blendShape":
            if default not in (None, span.default):
                where = f'controls."{draft.name}".default'
                raise refuse("CONFIG_VALUE", where, "joints and poses rest at 0")
            default = span.default
        elif default is None:
            default = min(max(span.default, minimum), maximum)
        span = Range(minimum, default, maximum, "config")
    if span.source == "config" and not span.minimum <= span.default <= span.maximum:
        raise refuse(
            "CONFIG_VALUE",
            f'controls."{draft.name}"',
            f"minimum {span.minimum:g}, default {span.default:g} and maximum {span.maximum:g} must"
            " ascend",
        )
    return span


def control_of(draft: Draft, name: str, label: str, span: Range) -> Control:
    """The control that a draft becomes; without a `label` it has the draft's, or its name."""
    return Control(
        name,
        label or draft.label or name,
        draft.kind,
        draft.source,
        span.minimum,
        span.default,
        span.maximum,
        span.source,
        draft.drive_over(span),
    )


def joint_settings(
    joints: tuple[Joint, ...], configured: Mapping[str, JointSettings]
) -> list[JointSettings | None]:
    """The configuration of each joint by its full path or, where no other joint has it, its last
    name."""
    names = names_in_configuration(joints)
    # Paths come last there, and win.
    found = {i: configured[name] for name, i in names.items() if name in configured}
    return [*map(found.get, range(len(joints)))]


def names_in_configuration(joints: tuple[Joint, ...]) -> dict[str, int]:
    """The names by which the configuration may speak of joints, and their indices: those of their
    controls, and their paths."""
    names = {name: i for i, name in enumerate(joint_names(joints))}
    return names | {joint.path: i for i, joint in enumerate(joints)}


# --- drives and ranges ----------------------------------------------------------------------------


_NO_INDICES = np.zeros(0, dtype=np.int64)


def _weight_drive(channels: Sequence[int], span: Range) -> Drive:
    values = np.array([span.minimum, span.maximum])
    weights = np.repeat((values - span.default)[:, None], len(channels), axis=1)
    return Drive(values, np.array(channels), weights, _NO_INDICES, np.zeros((2, 3, 0, 3)))


def _turning_drive(joints: Sequence[int], axes: Floats, span: Range) -> Drive:
    """Joints that turn about `axes` (j, 3), each in its own frame, by the value in degrees."""
    values = np.array([span.minimum, span.maximum])
    moves = np.zeros((2, 3, *axes.shape))
    moves[:, 0] = np.radians(values - span.default)[:, None, None] * axes + 0.0
    return Drive(values, _NO_INDICES, np.zeros((2, 0)), np.array(joints), moves)


def _arc_drive(tree: Tree, turn: Turn, weights: int, _: Range) -> Drive:
    """Joints of a flat skeleton go round the joint that turns: keys every few degrees follow their
    arcs.  `weights` is the number of channels."""
    low, high = turn.range
    steps = int(np.ceil((high - low) / _KEY_DEGREES))
    values = np.union1d(np.linspace(low, high, steps + 1), [0.0])
    states = State(np.zeros((len(values), weights)), posed_locals(tree, turn, values))
    base = State(np.zeros(weights), base_locals(tree.joints))
    return pose_drive(NamedPose(turn.name, values, states), base)


def _as_posed(drive: Drive, _: Range) -> Drive:
    """The keys of a pose, whatever its range."""
    return drive


def _hull(ranges: list[Range]) -> Range:
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
    leaves = Counter(joint.name for joint in joints)
    names = [joint.name if leaves[joint.name] == 1 else joint.path for joint in joints]
    count = Counter(names)
    return [
        name if count[name] == 1 else f"{joint.skeleton}/{name}"
        for name, joint in zip(names, joints, strict=True)
    ]


def _animated_turns(joints: tuple[Joint, ...], clip: Clip | None) -> Floats:
    """(frames, joints, 3) rotation about each own axis at every frame of the clip, one of zeros
    without a clip, in degrees from the base pose.

    Without the noise of quaternions in single precision: some 1e-5 degrees.
    """
    if clip is None:
        return np.zeros((1, len(joints), 3))
    base = np.swapaxes(base_frames(joints), -1, -2)
    turns = unwrapped(rotation_vectors(rotation_part(clip.locals) @ base))
    return np.asarray(np.round(np.degrees(turns), 3) + 0.0)


def _joint_range(
    override: JointSettings | None,
    axis: int,
    span: Floats,
    which: str,
    least: float,
) -> Range | None:
    """The range of one joint axis, or None if it is no control."""
    if override is not None:
        if _AXES[axis] not in override.axes:
            return None
        return Range(override.minimum, 0.0, override.maximum, "config")
    if which == "none":
        return None
    if span[1] - span[0] > least:
        low, high = (float(end) if abs(end) > least else 0.0 for end in span)
        return Range(min(0.0, low), 0.0, max(0.0, high), "animation")
    if which == "all":
        return Range(JointSettings().minimum, 0.0, JointSettings().maximum, "default")
    return None
