"""Blend shapes of one mesh, and the tokens that drive them."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from pxr import Sdf, Usd, UsdSkel

from usdrigui.character import Body, Indices, LeftOff, Shape, Singles, Skeleton
from usdrigui.conventions.sides import hints_at_twin
from usdrigui.errors import Issue, RigUIError, issue, refuse
from usdrigui.reading.skeleton import Armature, repeated, why_unbound
from usdrigui.stages.arrays import check_range, integers, tokens, vectors


@dataclass
class Found:
    """What reading the meshes brought up besides the meshes."""

    tokens: dict[tuple[str, str], int] = field(default_factory=dict)
    """Channel index by (token, animation path); grows by tokens that no animation lists."""
    numbered: dict[str, str] = field(default_factory=dict)
    """The name of the shape of a token that only adds a number to it.  A SkelAnimation has every
    token once: of *smile* on three meshes Blender's exporter makes *smile*, *smile2*, *smile3*."""
    shapeless: dict[str, str] = field(default_factory=dict)
    """Why a token got no shape from some mesh."""
    issues: list[Issue] = field(default_factory=list)
    faults: list[RigUIError] = field(default_factory=list)
    """Why parts were left off: what the character is refused for if nothing is left of it."""

    @contextlib.contextmanager
    def leaving_off(self, path: str, names: Iterable[str] = ()) -> Iterator[None]:
        """Leave off the part at `path`, a mesh, shape or subset, and with it the shapes of these
        `names`, if its arrays cannot be right: the others can be used (decision 023)."""
        try:
            yield
        except RigUIError as error:
            refusal = error.issue
            where = "" if refusal.path == path else f" {refusal.path}:"
            self.issues.append(
                issue("PART_LEFT_OFF", path, f"{refusal.code}:{where} {refusal.message}")
            )
            self.faults.append(error)
            self.shapeless.update(dict.fromkeys(names, f"{refusal.path}: {refusal.message}"))


@dataclass(frozen=True)
class Binding:
    """How a prim hangs on a Skeleton."""

    armature: Armature
    query: UsdSkel.SkinningQuery


def read_shapes(
    prim: Usd.Prim, binding: Binding | None, count: int, found: Found
) -> tuple[Shape, ...]:
    """The shapes of a mesh of `count` points, in the order of its tokens; `found` takes tokens and
    issues.

    A shape whose arrays cannot be right is left off; so are all where names and targets differ in
    number.
    """
    path = str(prim.GetPath())
    names: tuple[str, ...] = ()
    targets: list[Sdf.Path] = []
    with found.leaving_off(path, legible_tokens(prim)):
        names, targets = names_and_targets(prim)
    if names and binding is None:
        why = why_unbound(prim)
        found.issues.append(
            issue("MESH_UNBOUND", path, f"has {len(names)} blend shapes{why and '; '}{why}")
        )
        found.shapeless.update(dict.fromkeys(names, why or f"no Skeleton is bound to {path}"))
    if binding is None:
        return ()
    found.issues.extend(repeated(names, path, "skel:blendShapes"))
    shapes = []
    for token, target in dict(zip(names, targets, strict=True)).items():
        if target.name not in names and token.removeprefix(target.name).isdecimal():
            found.numbered[token] = target.name
        with found.leaving_off(str(target), (token,)):
            blend_shape = prim.GetStage().GetPrimAtPath(target)
            if not is_shape(blend_shape):
                found.issues.append(issue("TARGET_INVALID", target, f"is the target of {token!r}"))
                found.shapeless[token] = f"its target {target} is not an active BlendShape"
                continue
            shape = _shape(blend_shape, token, binding.armature.record, count, found)
            if shape is not None:
                shapes.append(shape)
    return tuple(shapes)


def shape_tokens(prim: Usd.Prim) -> tuple[str, ...]:
    """The names of the blend shapes of a mesh, none where nothing is authored; raises
    ARRAY_TYPE."""
    attribute = UsdSkel.BindingAPI(prim).GetBlendShapesAttr()
    return tokens(attribute.Get(), prim.GetPath(), "skel:blendShapes")


def legible_tokens(prim: Usd.Prim) -> tuple[str, ...]:
    """The names of the blend shapes of a mesh; none where something else stands in their place."""
    try:
        return shape_tokens(prim)
    except RigUIError:
        return ()


def names_and_targets(prim: Usd.Prim) -> tuple[tuple[str, ...], list[Sdf.Path]]:
    """As many targets as names; raises ARRAY_TYPE and TARGETS_LENGTH."""
    names = shape_tokens(prim)
    targets = UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().GetTargets()
    if len(names) != len(targets):
        counts = f"{len(names)} skel:blendShapes but {len(targets)} skel:blendShapeTargets"
        raise refuse("TARGETS_LENGTH", prim.GetPath(), counts)
    return names, list(targets)


def is_shape(prim: Usd.Prim) -> bool:
    """Whether a target is one that UsdSkel would use."""
    return bool(prim) and prim.IsActive() and prim.IsA(UsdSkel.BlendShape)


def shape_arrays(
    prim: Usd.Prim,
    count: int,
    issues: list[Issue],
    guard: Callable[[], AbstractContextManager[None]] = contextlib.nullcontext,
) -> tuple[Indices, list[tuple[float, Singles]]]:
    """The points that a BlendShape of a mesh of `count` points names, and its weights with their
    offsets, ascending.

    Raises ARRAY_TYPE, INDEX_RANGE, NOT_FINITE and OFFSETS_LENGTH, those of offsets inside a
    `guard`.
    """
    path = prim.GetPath()
    indices = integers(prim.GetAttribute("pointIndices").Get(), path, "pointIndices")
    check_range(indices, count, path, "pointIndices")
    expected, rows = len(indices) or count, []
    authored = [(1.0, "offsets", prim.GetAttribute("offsets").Get()), *_inbetweens(prim, issues)]
    for weight, name, values in authored:
        with guard():
            offsets = vectors(values, path, name).astype(np.float32, copy=False)
            if len(offsets) not in (0, expected):
                what = "pointIndices" if len(indices) else "points"
                counts = f"{len(offsets)} {name} for {expected} {what}"
                raise refuse("OFFSETS_LENGTH", path, counts)
            rows.append((weight, offsets))
    return indices, sorted(rows, key=lambda row: row[0])


def _shape(prim: Usd.Prim, token: str, record: Skeleton, count: int, found: Found) -> Shape | None:
    path = str(prim.GetPath())
    points, rows = shape_arrays(prim, count, found.issues)
    if not any(len(offsets) for _, offsets in rows):
        found.shapeless[token] = f"its shape {path} has no offsets"
        return None
    empty = np.zeros((len(points) or count, 3), dtype=np.float32)
    filled = [offsets if len(offsets) else empty for _, offsets in rows]
    table = np.stack(filled)
    if not len(points):
        points = np.flatnonzero(table.any(axis=(0, 2)))
        table = table if len(points) == count else table[:, points]
    elif (points[1:] <= points[:-1]).any():
        points, table = _merged(points, table)
    weights = np.array([weight for weight, _ in rows])
    return Shape(_channel(token, record, found), path, weights, points, table)


def _merged(points: Indices, table: Singles) -> tuple[Indices, Singles]:
    """Points ascending and unique; offsets of a repeated point add up, as in UsdSkel."""
    unique, place = np.unique(points, return_inverse=True)
    merged = np.zeros((len(table), len(unique), 3), dtype=np.float32)
    for row, offsets in zip(merged, table, strict=True):
        np.add.at(row, place, offsets)
    return unique, merged


def _inbetweens(prim: Usd.Prim, issues: list[Issue]) -> list[tuple[float, str, Any]]:
    """Weight, name and offsets of each in-between that UsdSkel would use."""
    if not any(name.startswith("inbetweens:") for name in prim.GetPropertyNames()):
        return []
    taken, between = [0.0, 1.0], []
    for shape in UsdSkel.BlendShape(prim).GetInbetweens():
        weight, name = shape.GetWeight(), shape.GetAttr().GetName()
        if (
            weight is None
            or not np.isfinite(weight)
            or np.abs(np.array(taken) - weight).min() < 1e-6
        ):
            issues.append(issue("INBETWEEN_INVALID", prim.GetPath(), f"{name} has weight {weight}"))
        else:
            taken.append(float(weight))
            between.append((float(weight), name, shape.GetOffsets()))
    return between


def _channel(token: str, record: Skeleton, found: Found) -> int:
    """Index of the weight that drives a token under a Skeleton; a new one if no animation lists
    it."""
    key = (token, record.animation)
    if key in found.tokens:
        return found.tokens[key]
    return found.tokens.setdefault((token, ""), len(found.tokens))


def note_tokens(prim: Usd.Prim, found: Found, reason: str) -> None:
    """Remember why the tokens of a prim got no shape from it."""
    found.shapeless.update(dict.fromkeys(legible_tokens(prim), reason))


def controls_of_tokens(found: Found) -> dict[str, str]:
    """The name of the control of each token: the token itself, or what it stands for."""
    tokens = dict.fromkeys([*(token for token, _ in found.tokens), *found.shapeless])
    plain = ((token, found.numbered.get(token, token)) for token in tokens)
    return {token: name if name in tokens else token for token, name in plain}


def left_off_tokens(found: Found, body: Body) -> tuple[LeftOff, ...]:
    """Tokens that no mesh implements, with the reason."""
    names = controls_of_tokens(found)
    used = body.shapes_by_channel
    shaped = {names[token] for (token, _), channel in found.tokens.items() if channel in used}
    reasons = {names[token]: reason for token, reason in found.shapeless.items()}

    def why(name: str) -> str:
        twins = (
            f"; {each} has no twin then" for each in sorted(shaped) if hints_at_twin(name, each)
        )
        return "".join([reasons.get(name, "no mesh has a shape for it"), *twins])

    return tuple(
        LeftOff(name, "read", why(name))
        for name in dict.fromkeys(names.values())
        if name not in shaped
    )
