"""Contradictions in the layouts of a stage: with their own parts, or with the character's.

`read_layout` refuses what nobody could read.  These layouts can be read, and would do nothing, or
not what they show; a layer written by hand has such faults.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.errors import Issue, RigUIError, issue
from usdrigui.layer.properties import (
    applied,
    array_of,
    control_instances,
    strings,
    targets,
    value_of,
)
from usdrigui.layer.read_layout import (
    base_controls,
    element_prims,
    layout_scopes,
    points_of_subset,
)
from usdrigui.reading.blend_shape import shape_tokens
from usdrigui.stages import schema
from usdrigui.stages.arrays import tokens

_FAMILY = "rigUI"
_ASTRAY = 0.25
"""A track misses its anchor where it passes it by more than this share of its length, and by a
handle's width besides: between its points a curved track cuts a corner."""


def contradictions(stage: Usd.Stage) -> tuple[Issue, ...]:
    """LAYOUT_INVALID, an error or a warning, for each element of the layouts of today's format;
    `stage` has layouts that `read_layout` reads."""
    scopes = [scope for scope in layout_scopes(stage) if schema.LAYOUT in applied(scope)]
    known = _tokens(stage) if scopes else frozenset[str]()
    return tuple(
        replace(found, character=str(scope.GetPath().GetParentPath()))
        for scope in scopes
        for found in _of_scope(scope, known)
    )


@dataclass(frozen=True)
class _Character:
    """What a layout may speak of."""

    tokens: frozenset[str]
    """Blend shapes of the meshes and SkelAnimations of its stage."""
    base: Mapping[str, float]
    """Values of controls in the base pose, by name."""
    handle_width: float


def _of_scope(scope: Usd.Prim, known: frozenset[str]) -> tuple[Issue, ...]:
    """The same of one layout, up to a property that has another type than the schema's; `known` as
    `_tokens`."""
    found: list[Issue] = []
    try:
        found.extend(_of_layout(scope, known))
    except RigUIError as error:
        found.append(error.issue)
    return tuple(found)


def _of_layout(scope: Usd.Prim, known: frozenset[str]) -> Iterator[Issue]:
    values = value_of(scope, schema.LAYOUT, "baseValues")
    names = base_controls(scope)
    base = dict(zip(names, values if len(values) else [0.0] * len(names), strict=True))
    width = float(value_of(scope, schema.LAYOUT, "handleWidth"))
    character = _Character(known, base, width)
    elements = element_prims(scope)
    for mesh in dict.fromkeys(each.GetParent() for each in elements):
        yield from _of_drawing(mesh)
    for prim in elements:
        yield from _of_subset(prim)
        for instance in control_instances(prim):
            yield from _of_drive(prim, instance, character)
            yield from _of_track(prim, instance, character)


def _tokens(stage: Usd.Stage) -> frozenset[str]:
    """The blend shapes that meshes and SkelAnimations of the stage name, but for ours."""
    found: set[str] = set()
    for prim in Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()):
        if schema.DRAWING in applied(prim):
            continue
        # The character has the issue about arrays of other types.
        with contextlib.suppress(RigUIError):
            if prim.IsA(UsdSkel.Animation):
                given = UsdSkel.Animation(prim).GetBlendShapesAttr()
                found.update(tokens(given.Get(), str(prim.GetPath()), "blendShapes"))
            elif prim.IsA(UsdGeom.Mesh):
                found.update(shape_tokens(prim))
    return frozenset(found)


def _of_drawing(mesh: Usd.Prim) -> Iterator[Issue]:
    """Whether a mesh that draws elements moves with a Skeleton."""
    if schema.DRAWING not in applied(mesh):
        yield _invalid(mesh, f"{schema.DRAWING} is missing: it draws elements")
    if not UsdSkel.BindingAPI(mesh).GetInheritedSkeleton():
        yield _invalid(mesh, "skel:skeleton is missing: nothing moves its handles")


def _of_subset(prim: Usd.Prim) -> Iterator[Issue]:
    subset = UsdGeom.Subset(prim)
    if not subset:
        return
    handle, _ = points_of_subset(prim)
    if not len(handle):
        yield _invalid(
            prim, f"no face has the role 'handle': see primvars:{schema.ROLE} of its mesh"
        )
    if subset.GetFamilyNameAttr().Get() != _FAMILY:
        found = _invalid(prim, f"familyName is not {_FAMILY!r}")
        yield replace(found, severity="warning")


def _of_drive(prim: Usd.Prim, instance: str, character: _Character) -> Iterator[Issue]:
    """Whether the targets of a control exist; the rig shows whether the control itself does."""

    def get(name: str) -> Any:
        return value_of(prim, schema.CONTROL, name, instance)

    where = f"rigUI:control:{instance}"
    shapes, joints = strings(get("blendShapes")), strings(get("joints"))
    if not shapes and not joints:
        yield _invalid(
            prim, f"{where}:blendShapes and joints are missing: the control drives nothing"
        )
    elif not len(get("keys")) and (len(shapes) != 1 or joints):
        yield _invalid(prim, f"{where}:keys are missing: without, it is one blend shape")
    own = {instance, str(get("name")), str(get("source"))}
    for token in sorted({*shapes} - character.tokens - own):
        yield _invalid(prim, f"{where}:blendShapes names {token!r}, which no mesh has")
    there = _joints(prim, instance)
    for token in sorted({*joints} - there):
        if there:
            yield _invalid(prim, f"{where}:joints names {token!r}, which its Skeleton lacks")
    if joints and not targets(prim, schema.CONTROL, "skeleton", instance):
        yield _invalid(prim, f"{where}:skeleton is missing: it moves joints")


def _joints(prim: Usd.Prim, instance: str) -> frozenset[str]:
    """The joints of the Skeletons of a control; none where they are gone, as the rig shows."""
    stage = prim.GetStage()
    skeletons = (
        UsdSkel.Skeleton(stage.GetPrimAtPath(path))
        for path in targets(prim, schema.CONTROL, "skeleton", instance)
    )
    return frozenset(
        joint
        for each in skeletons
        if each
        for joint in tokens(each.GetJointsAttr().Get(), str(each.GetPath()), "joints")
    )


def _of_track(prim: Usd.Prim, instance: str, character: _Character) -> Iterator[Issue]:
    """Whether a track passes the anchor at the value of the base pose."""

    def get(name: str) -> Any:
        return value_of(prim, schema.CONTROL, name, instance)

    track, values = array_of(get("trackPoints")), array_of(get("trackValues"))
    if not len(values):
        values = np.linspace(get("minimum"), get("maximum"), len(track))
    at = character.base.get(str(get("name")) or instance, float(get("default")))
    here = np.array([np.interp(at, values, column) for column in track.T])
    anchor = array_of(value_of(prim, schema.ANCHOR, "position"))
    away = float(np.linalg.norm(here - anchor))
    length = float(np.linalg.norm(np.diff(track, axis=0), axis=1).sum())
    if away > character.handle_width + _ASTRAY * length:
        where = f"rigUI:control:{instance}:trackPoints"
        clause = f"{where} pass rigUI:anchor:position by {away:.3g} at the base pose ({at:g})"
        yield replace(_invalid(prim, clause), severity="warning")


def _invalid(prim: Usd.Prim, message: str) -> Issue:
    return issue("LAYOUT_INVALID", str(prim.GetPath()), message)
