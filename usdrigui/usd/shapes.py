"""Blend shapes of one mesh, and the tokens that drive them."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from pxr import Sdf, Usd, UsdSkel

from usdrigui.errors import Issue, RigUIError, issue, refuse
from usdrigui.model import Body, Floats, Indices, LeftOff, Shape, Singles, Skeleton
from usdrigui.usd.arrays import check_range, integers, tokens, vectors
from usdrigui.usd.binding import why_unbound
from usdrigui.usd.skeleton import Armature, repeated

PART_FAULTS = {
    "ARRAY_TYPE",
    "INDEX_RANGE",
    "INFLUENCES_LENGTH",
    "JOINT_UNKNOWN",
    "NOT_FINITE",
    "OFFSETS_LENGTH",
    "TARGETS_LENGTH",
    "TOPOLOGY_INVALID",
}
"""Codes of what makes one mesh, shape or subset unusable and not the others
(decision 023)."""


@dataclass
class Found:
    """What reading the meshes brought up besides the meshes."""

    tokens: dict[tuple[str, str], int] = field(default_factory=dict)
    """Channel index by (token, animation path); grows by tokens that no animation lists."""
    shapeless: dict[str, str] = field(default_factory=dict)
    """Why a token got no shape from some mesh."""
    issues: list[Issue] = field(default_factory=list)
    faults: list[RigUIError] = field(default_factory=list)
    """Why parts were left off: what the character is refused for if nothing is left of it."""

    @contextlib.contextmanager
    def leaving_off(self, path: str, names: Iterable[str] = ()) -> Iterator[None]:
        """Leave off the part at `path`, and with it the shapes of these `names`, if its arrays
        cannot be right."""
        try:
            yield
        except RigUIError as error:
            if error.issue.code not in PART_FAULTS:
                raise
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
    targets: Sequence[Sdf.Path] = ()
    with found.leaving_off(path, legible_tokens(prim)):
        names, targets = _names_and_targets(prim)
    if names and binding is None:
        why = why_unbound(prim)
        found.issues.append(
            issue("MESH_UNBOUND", path, f"has {len(names)} blend shapes{why and '; '}{why}")
        )
        found.shapeless.update(dict.fromkeys(names, why or f"no Skeleton is bound to {path}"))
    if not names or binding is None:
        return ()
    found.issues.extend(repeated(names, path, "skel:blendShapes"))
    shapes = []
    for token, target in dict(zip(names, targets, strict=True)).items():
        with found.leaving_off(str(target), (token,)):
            shape = _shape(prim.GetStage(), token, target, binding.armature.record, count, found)
            if shape is not None:
                shapes.append(shape)
    return tuple(shapes)


def shape_tokens(prim: Usd.Prim) -> tuple[str, ...]:
    """The names of the blend shapes of a mesh, none where nothing is authored; raises
    ARRAY_TYPE."""
    attribute = UsdSkel.BindingAPI(prim).GetBlendShapesAttr()
    return tokens(attribute.Get(), str(prim.GetPath()), "skel:blendShapes")


def legible_tokens(prim: Usd.Prim) -> tuple[str, ...]:
    """The names of the blend shapes of a mesh; none where something else stands in their place."""
    try:
        return shape_tokens(prim)
    except RigUIError:
        return ()


def _names_and_targets(prim: Usd.Prim) -> tuple[tuple[str, ...], Sequence[Sdf.Path]]:
    """As many targets as names; raises ARRAY_TYPE and TARGETS_LENGTH."""
    names = shape_tokens(prim)
    targets = UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().GetTargets()
    if len(names) != len(targets):
        counts = f"{len(names)} skel:blendShapes but {len(targets)} skel:blendShapeTargets"
        raise refuse("TARGETS_LENGTH", str(prim.GetPath()), counts)
    return names, targets


def _shape(
    stage: Usd.Stage, token: str, target: Sdf.Path, record: Skeleton, count: int, found: Found
) -> Shape | None:
    prim, path = stage.GetPrimAtPath(target), str(target)
    if not prim or not prim.IsActive() or not prim.IsA(UsdSkel.BlendShape):
        found.issues.append(issue("TARGET_INVALID", path, f"is the target of {token!r}"))
        found.shapeless[token] = f"its target {path} is not an active BlendShape"
        return None
    offsets = _offsets(prim.GetAttribute("offsets").Get(), path, "offsets")
    indices = integers(prim.GetAttribute("pointIndices").Get(), path, "pointIndices")
    between = _inbetweens(prim, found)
    size = len(indices) or count
    for name, array in (("offsets", offsets), *((f"inbetweens:{w:g}", o) for w, o in between)):
        if len(array) not in (0, size):
            what = "pointIndices" if len(indices) else "points"
            raise refuse("OFFSETS_LENGTH", path, f"{len(array)} {name} for {size} {what}")
    if not len(offsets) and not any(len(each) for _, each in between):
        found.shapeless[token] = f"its shape {path} has no offsets"
        return None
    weights, points, table = _assembled(path, indices, offsets, between, size, count)
    return Shape(_channel(token, record, found), path, weights, points, table)


def _assembled(
    path: str,
    indices: Indices,
    offsets: Singles,
    between: list[tuple[float, Singles]],
    size: int,
    count: int,
) -> tuple[Floats, Indices, Singles]:
    """Weights, points and offsets of a Shape: rows in the order of weight, points ascending and
    unique."""
    rows = sorted([(1.0, offsets), *between], key=lambda row: row[0])
    empty = np.zeros((size, 3), dtype=np.float32)
    table = (
        np.stack([each if len(each) else empty for _, each in rows]) if between else offsets[None]
    )
    if not len(indices):
        points = np.flatnonzero(table.any(axis=(0, 2)))
        table = table if len(points) == count else table[:, points]
    else:
        points = indices
        if (points[1:] <= points[:-1]).any():
            points, table = _merged(points, table)
        if points[0] < 0 or points[-1] >= count:
            check_range(points, count, path, "pointIndices")
    return np.array([weight for weight, _ in rows]), points, table


def _merged(points: Indices, table: Singles) -> tuple[Indices, Singles]:
    """Points ascending and unique; offsets of a repeated point add up, as in UsdSkel."""
    unique, place = np.unique(points, return_inverse=True)
    merged = np.zeros((len(table), len(unique), 3), dtype=np.float32)
    for row, offsets in zip(merged, table, strict=True):
        np.add.at(row, place, offsets)
    return unique, merged


def _inbetweens(prim: Usd.Prim, found: Found) -> list[tuple[float, Singles]]:
    """Weight and offsets of each in-between that UsdSkel would use."""
    if not any(name.startswith("inbetweens:") for name in prim.GetPropertyNames()):
        return []
    path, taken, between = str(prim.GetPath()), {0.0, 1.0}, []
    for each in UsdSkel.BlendShape(prim).GetInbetweens():
        weight, name = each.GetWeight(), each.GetAttr().GetName()
        if (
            weight is None
            or not np.isfinite(weight)
            or any(abs(weight - other) < 1e-6 for other in taken)
        ):
            found.issues.append(issue("INBETWEEN_INVALID", path, f"{name} has weight {weight}"))
            continue
        taken.add(float(weight))
        between.append((float(weight), _offsets(each.GetOffsets(), path, name)))
    return between


def _offsets(values: Any, path: str, name: str) -> Singles:
    return vectors(values, path, name).astype(np.float32, copy=False)


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


def left_off_tokens(found: Found, body: Body) -> tuple[LeftOff, ...]:
    """Tokens that no mesh implements, with the reason."""
    used = {shape.channel for mesh in body.meshes for shape in mesh.binding.shapes}
    shaped = {token for (token, _), channel in found.tokens.items() if channel in used}
    names = dict.fromkeys([*(token for token, _ in found.tokens), *found.shapeless])
    return tuple(
        LeftOff(name, "read", found.shapeless.get(name, "no mesh has a shape for it"))
        for name in names
        if name not in shaped
    )
