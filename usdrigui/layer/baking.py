"""From values keyed on the controls to samples of the SkelAnimations that they drive.

A control whose `rigUI:control:*:value` is authored is what that says, whatever the animation has.
In the directions in which such controls move a joint, and in every weight that one of them sets,
the samples are what these controls give together; in all others they are those of the animation.
So baking what is baked changes nothing (schemas/CONTRACT.md, docs/decisions/152).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from pxr import Gf, Sdf, Ts, Usd, UsdSkel, Vt

from usdrigui.character import Flags, Floats, Record, Rig, Skeleton
from usdrigui.character.deform import driven, moved_locals
from usdrigui.errors import Issue, issue, refuse
from usdrigui.layer import author
from usdrigui.layer.properties import control_instances, value_of
from usdrigui.layer.read_controls import read_controls
from usdrigui.layer.read_layout import element_prims, layout_scopes
from usdrigui.reading.character import read_animated
from usdrigui.reading.clips import Animated, State
from usdrigui.reading.mesh import drawable
from usdrigui.reading.pose import moves_from
from usdrigui.settings import ReadSettings
from usdrigui.stages import schema

_WEIGHTS_APART, _MOVES_APART = 1e-4, (1e-3, 1e-4, 2e-3)
"""By how much an animation may differ from the values: in weights; in radians, shares of the
longest translation, and logarithms of scales, which UsdSkel holds in half precision."""
_SAME = 1e-9
"""Directions that differ by less, in proportion, are one."""
_MADE = "usdrigui_animation"
"""Of a Skeleton without a SkelAnimation."""
BAKED = "Written by `usdrigui bake`; what it holds is made again from the controls of the shot."
_METADATA = ("timeCodesPerSecond", "framesPerSecond", "startTimeCode", "endTimeCode")


def bake(stage: Usd.Stage, settings: ReadSettings) -> Sdf.Layer:
    """A layer for the sublayers of a shot, in which its SkelAnimations do what the authored values
    of the controls say: overs with samples of what these drive, and of nothing else.

    Raises VALUES_MISSING where no value is authored, INSTANCE for an animation inside an instance,
    NOT_FINITE, and as `read_layout` and `usdrigui.reading.character.read_rigs`.
    """
    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.comment = BAKED
    read = (valued(scope, settings) for scope in layout_scopes(stage))
    found = [each for each in read if each is not None]
    if not found:
        what = "no rigUI:control:*:value of a layout has a value"
        raise refuse("VALUES_MISSING", stage.GetRootLayer().GetDisplayName(), what)
    source = stage.GetRootLayer().pseudoRoot
    for name in (*_METADATA, "defaultPrim"):
        if source.HasInfo(name):
            layer.pseudoRoot.SetInfo(name, source.GetInfo(name))
    for each in found:
        _author(layer, stage, each)
    return layer


def apart(found: Valued | None) -> Iterator[Issue]:
    """LAYOUT_VALUE for each control whose authored value the animation does not show, of what a
    layout has (`valued`)."""
    if found is None:
        return
    left = {index: found.along([index]) for index in found.reached}
    for time, state in zip(found.times, found.states(), strict=True):
        for index, value in state.authored.items():
            if index in left and found.differs(index, left[index], state):
                del left[index]
                when = f" at time {time:g}" if found.moving else ""
                what = f"is {value:g}{when}, the SkelAnimation has another"
                path = found.values[found.rig.control_names[index]].GetPath()
                yield issue("LAYOUT_VALUE", path, what)


# --- the values -----------------------------------------------------------------------------------


class _State(Record):
    """What the values make of the animation at a time."""

    authored: Mapping[int, float]
    """The values that there are, by the place of their control in `Rig.controls`."""
    weights: Floats
    """(channels,)."""
    locals: Floats
    """(joints, 4, 4)."""
    weighed: Floats
    """(channels,) what the weights gain."""
    moved: Floats
    """(3, joints, 3) rotation vectors, translations and logarithms of scales that joints gain."""


class Valued(Record):
    """A character, and the controls of its layout, some of which have a value."""

    animated: Animated
    rig: Rig
    values: Mapping[str, Usd.Attribute]
    """By the name of a control, the authored ones."""
    times: tuple[float, ...]
    moving: bool
    """Whether anything changes in time."""

    @cached_property
    def reached(self) -> list[int]:
        """The controls with a value at some time, as places in `Rig.controls`."""
        return [i for i, each in enumerate(self.rig.controls) if each.name in self.values]

    def states(self) -> Iterator[_State]:
        """What the values make of the animation at each of the times; raises NOT_FINITE."""
        known, along = list[int](), self.along([])
        for time in self.times:
            read = {i: _read(self.values[self.rig.control_names[i]], time) for i in self.reached}
            authored = {i: value for i, value in read.items() if value is not None}
            if list(authored) != known:
                known, along = list(authored), self.along([*authored])
            yield self._state(self.animated.state(time), authored, along)

    def _state(self, now: State, authored: Mapping[int, float], along: Floats) -> _State:
        """Of the animation at a time, `along` being the directions of the `authored` controls."""
        values = self.rig.defaults
        for index, value in authored.items():
            values[index] = value
        given, moved = driven(self.rig, values)
        weights = now.weights.copy()
        for index in authored:
            channels = self.rig.controls[index].drive.channels
            weights[channels] = given[channels]
        moves = moves_from(self.animated.base.locals, now.locals)
        gained = _within(along, moved - moves)
        locals_ = moved_locals(self.rig.body.joints, (moves + gained)[None])[0]
        kept = ~gained.any(axis=(0, 2))
        locals_[kept] = now.locals[kept]
        return _State(authored, weights, locals_, weights - now.weights, gained)

    def along(self, controls: Sequence[int]) -> Floats:
        """(3, joints, 3, 3) projections onto the directions in which some controls move each
        joint."""
        drives = [self.rig.controls[index].drive for index in controls]
        found = np.zeros((3, len(self.rig.body.joints), 3, 3))
        for joint in {joint for drive in drives for joint in drive.joints.tolist()}:
            moves = [each.moves[:, :, each.joints == joint] for each in drives]
            for part in range(3):
                rows = [each[:, part].reshape(-1, 3) for each in moves]
                found[part, joint] = _projection(np.concatenate(rows))
        return found

    @cached_property
    def length(self) -> float:
        """The longest translation of a joint at rest; 1 where there is none."""
        lengths = [float(np.abs(each.base[3, :3]).max()) for each in self.rig.body.joints]
        return max(lengths, default=0.0) or 1.0

    def differs(self, index: int, along: Floats, state: _State) -> bool:
        """Whether the animation shows another value of a control, which moves joints `along` some
        directions, than the layout has."""
        far = np.abs(_within(along, state.moved)).max(axis=(1, 2), initial=0.0)
        far[1] /= self.length
        shaped = np.abs(state.weighed[self.rig.controls[index].drive.channels]).max(initial=0.0)
        return bool(shaped > _WEIGHTS_APART or (far > _MOVES_APART).any())


def _within(projections: Floats, vectors: Floats) -> Floats:
    return (projections @ vectors[..., None])[..., 0]


def _projection(rows: Floats) -> Floats:
    """(3, 3) onto the span of rows (n, 3)."""
    _, sizes, axes = np.linalg.svd(rows, full_matrices=False)
    spanning = axes[sizes > _SAME * max(float(sizes[0]), _SAME)]
    return np.asarray(spanning.T @ spanning)


def valued(scope: Usd.Prim, settings: ReadSettings) -> Valued | None:
    """The controls of a layout that have a value, on their character; None where none has one.

    Raises as `usdrigui.reading.character.read_rigs`.
    """
    values: dict[str, Usd.Attribute] = {}
    prims = element_prims(scope)
    for prim in prims:
        for instance in control_instances(prim):
            attribute = prim.GetAttribute(f"rigUI:control:{instance}:value")
            if attribute and attribute.HasAuthoredValue():
                name = value_of(prim, schema.CONTROL, "name", instance) or instance
                values.setdefault(name, attribute)
    if not values:
        return None
    root = scope.GetParent()
    animated = read_animated(root, settings, drawable(root))
    rig = read_controls(scope, prims, animated.body, [])
    known = {time for each in animated.armatures for time in each.times}
    known.update(time for each in values.values() for time in _times_of(each))
    return Valued(animated, rig, values, _times(scope.GetStage(), rig, values, known), bool(known))


def _read(attribute: Usd.Attribute, time: float) -> float | None:
    """None where it has no value.  Raises NOT_FINITE for what is no number."""
    value: float | None = attribute.Get(time)
    if value is not None and not math.isfinite(value):
        raise refuse("NOT_FINITE", attribute.GetPath(), f"is {value!r} at time {time:g}")
    return value


def _times_of(attribute: Usd.Attribute) -> list[float]:
    """Time samples, or the knots of a spline and the moments before those at which it jumps."""
    if not (hasattr(attribute, "HasSpline") and attribute.HasSpline()):
        return list(attribute.GetTimeSamples())
    knots = list(attribute.GetSpline().GetKnots().values())
    jumps = [
        after.GetTime() - Usd.TimeCode.SafeStep()
        for before, after in itertools.pairwise(knots)
        if before.GetNextInterpolation() == Ts.InterpHeld or after.IsDualValued()
    ]
    return [*(each.GetTime() for each in knots), *jumps]


def _times(
    stage: Usd.Stage, rig: Rig, values: Mapping[str, Usd.Attribute], known: set[float]
) -> tuple[float, ...]:
    """Times between which what is baked is linear, joints nearly: each that is `known`, each whole
    frame, and where a value passes a key of its control."""
    if not known:
        return (0.0,)
    if stage.HasAuthoredTimeCodeRange():
        known = known | {stage.GetStartTimeCode(), stage.GetEndTimeCode()}
    times = sorted({*known, *map(float, range(math.floor(min(known)), math.ceil(max(known)) + 1))})
    found = set(times)
    for control in rig.controls:
        keys = control.drive.values[1:-1].tolist()
        if keys and control.name in values:
            read = [(time, _read(values[control.name], time)) for time in times]
            for (start, low), (end, high) in itertools.pairwise(read):
                if low is None or high is None or low == high:
                    continue
                shares = ((key - low) / (high - low) for key in keys)
                found.update(start + each * (end - start) for each in shares if 0.0 < each < 1.0)
    return tuple(sorted(found))


# --- the layer ------------------------------------------------------------------------------------


def _author(layer: Sdf.Layer, stage: Usd.Stage, found: Valued) -> None:
    """Samples of every SkelAnimation that a value reaches."""
    body = found.rig.body
    drives = [found.rig.controls[index].drive for index in found.reached]
    set_ = {channel for drive in drives for channel in drive.channels.tolist()}
    along: Flags = np.asarray(found.along(found.reached).any(axis=(2, 3)))
    states = list(found.states())
    for path in dict.fromkeys(map(_animation_of, body.skeletons)):
        own = [i for i, each in enumerate(body.skeletons) if _animation_of(each) == path]
        channels = {
            each.token: index
            for index, each in enumerate(body.channels)
            if each.animation in ("", path)
        }
        every = [i for i, each in enumerate(body.joints) if each.skeleton in own]
        moved = [i for i in every if along[:, i].any()]
        shaped = not set_.isdisjoint(channels.values())
        if not (shaped or moved):
            continue
        prim = stage.GetPrimAtPath(path)
        if prim and prim.IsInstanceProxy():
            raise refuse("INSTANCE", path, "lies inside an instance: no layer can override it")
        spec = Sdf.CreatePrimInLayer(layer, path)
        if not prim:
            spec.specifier, spec.typeName = Sdf.SpecifierDef, "SkelAnimation"
            for index in own:
                skeleton = Sdf.CreatePrimInLayer(layer, body.skeletons[index].path)
                author.apply(skeleton, ["SkelBindingAPI"])
                author.link(skeleton, "skel:animationSource", [path])
        times = found.times if found.moving else (None,)
        animation = UsdSkel.Animation(prim)
        if shaped:
            kept = {each: index for each, index in channels.items() if index in set_}
            listed = _listed(spec, "blendShapes", animation.GetBlendShapesAttr, kept)
            rows = [[float(state.weights[channels[token]]) for token in listed] for state in states]
            _sample(spec, "float[] blendShapeWeights", times, map(Vt.FloatArray, rows))
        if moved:
            joints = {body.joints[i].path: i for i in (*every, *moved)}
            parts: Flags = np.asarray(along[:, moved].any(axis=1))
            locals_ = [state.locals for state in states]
            _joints(spec, animation, joints, moved, parts, locals_, times)


def _animation_of(skeleton: Skeleton) -> str:
    return skeleton.animation or f"{skeleton.path}/{_MADE}"


def _listed(
    spec: Sdf.PrimSpec, name: str, read: Callable[[], Usd.Attribute], wanted: Iterable[str]
) -> list[str]:
    """The tokens of an animation, those that it lacks among the `wanted` added in the layer."""
    there = read().Get() if spec.specifier == Sdf.SpecifierOver else None
    listed = list(map(str, there or ()))
    missing = [each for each in wanted if each not in listed]
    if missing:
        author.put(spec, name, "token[]", [*listed, *missing], uniform=True)
    return [*listed, *missing]


def _joints(
    spec: Sdf.PrimSpec,
    animation: UsdSkel.Animation,
    joints: Mapping[str, int],
    moved: Collection[int],
    parts: Flags,
    locals_: Sequence[Floats],
    times: Sequence[float | None],
) -> None:
    """Those of the three `parts` that the `moved` among the `joints`, by token, have from their
    transforms at each time; all three where the animation lists other joints now, or lacks
    one."""
    wanted = [token for token, joint in joints.items() if joint in moved]
    listed = _listed(spec, "joints", animation.GetJointsAttr, wanted)
    names = ("quatf[] rotations", "float3[] translations", "half3[] scales")
    has = [animation.GetPrim().GetAttribute(name.split()[1]) for name in names if animation]
    whole = "joints" in spec.properties or not all(map(Usd.Attribute.HasAuthoredValue, has))
    still = np.eye(4)  # of joints that no Skeleton has
    rows = [
        [
            Gf.Matrix4d((each[joints[token]] if token in joints else still).tolist())
            for token in listed
        ]
        for each in locals_
    ]
    made = [UsdSkel.DecomposeTransforms(Vt.Matrix4dArray(each)) for each in rows]
    for part, column in enumerate((1, 0, 2)):
        if whole or parts[part]:
            _sample(spec, names[part], times, [each[column] for each in made])


def _sample(
    spec: Sdf.PrimSpec, name: str, times: Sequence[float | None], values: Iterable[Any]
) -> None:
    """One value at each time, or the default where the only time is none."""
    kind, _, attribute = name.partition(" ")
    found = Sdf.AttributeSpec(spec, attribute, Sdf.ValueTypeNames.Find(kind))
    for time, value in zip(times, values, strict=True):
        if time is None:
            found.default = value
        else:
            spec.layer.SetTimeSample(found.path, time, value)
