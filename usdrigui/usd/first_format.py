"""Layouts of the first format, whose mark `RigUILayoutAPI` has no version: an Xform for each
element, and its tracks and its handle as gprims below it.

Nothing is written in it any more.  Its schema is no longer in schemas/, so the fallbacks stand
here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
from pxr import Usd, UsdGeom, Vt

from usdrigui.errors import refuse
from usdrigui.model import (
    Element,
    Floats,
    Glyph,
    Layout,
    LayoutCharacter,
    LayoutFrame,
    LeftOff,
    Look,
    Manipulator,
    Member,
    MirrorPlane,
    Proof,
)
from usdrigui.usd import schema
from usdrigui.usd.author import Property
from usdrigui.usd.properties import (
    applied,
    array_of,
    check_elements,
    check_equal,
    checked_glyph,
    control_instances,
    declared_value,
    element_name,
    element_names,
    has,
    integers_of,
    placement,
    read_anchor,
    strings,
    value_of,
    vectors_of,
)

TRACK, HANDLE = "RigUITrackAPI", "RigUIHandleAPI"
VERSION = 1
"""The only value of `rigUI:layout:version` that there ever was."""


def _declared(name: str, type_name: str, fallback: Any, *allowed: str) -> tuple[str, Property]:
    return name, Property(f"rigUI:{name}", type_name, fallback, allowed)


_PROPERTIES: Mapping[str, Property] = dict(
    (
        _declared("layout:version", "int", VERSION),
        _declared("layout:space", "token", "object", "object", "view"),
        _declared("layout:leftOffControls", "token[]", Vt.TokenArray()),
        _declared("layout:leftOffStages", "token[]", Vt.TokenArray()),
        _declared("layout:leftOffReasons", "string[]", Vt.StringArray()),
        _declared("solution:solver", "token", ""),
        _declared("solution:status", "token", "stopped", "optimal", "stopped"),
        _declared("solution:cost", "double", 0.0),
        _declared("solution:bound", "double", -np.inf),
        _declared("solution:inPlay", "double", 0.0),
        _declared("solution:weightNames", "token[]", Vt.TokenArray()),
        _declared("solution:weightValues", "double[]", Vt.DoubleArray()),
        _declared("element:opposed", "int2[]", Vt.Vec2iArray()),
        _declared("element:reversed", "int[]", Vt.IntArray()),
        _declared("element:family", "token", ""),
        _declared("element:reason", "string", ""),
        _declared("control:__INSTANCE_NAME__:arcLength", "double", 0.0),
        _declared("control:__INSTANCE_NAME__:gain", "double", 1.0),
        _declared("track:controls", "token[]", Vt.TokenArray()),
        _declared("track:weights", "double[]", Vt.DoubleArray()),
        _declared("track:basePoints", "point3f[]", Vt.Vec3fArray()),
        _declared("handle:adapt", "token", "deform", "deform", "static"),
        _declared("handle:glyph", "string", ""),
        _declared("handle:glyphOffsets", "vector3f[]", Vt.Vec3fArray()),
    )
)


def layout(scope: Usd.Prim) -> Layout:
    """One layout; raises LAYOUT_INVALID and LAYOUT_VERSION."""
    if _value(scope, "layout:version") > VERSION:
        version = _value(scope, "layout:version")
        raise refuse(
            "LAYOUT_VERSION",
            str(scope.GetPath()),
            f"version {version}; known: {VERSION}, {schema.LAYOUT}",
        )
    names, values = (
        value_of(scope, schema.LAYOUT, f"base{each}") for each in ("Controls", "Values")
    )
    check_equal(scope, "rigUI:layout:baseValues", names, values)
    elements = tuple(_element(prim) for prim in scope.GetAllChildren() if has(prim, schema.ELEMENT))
    check_elements(scope, elements)
    view, origin, normal = (
        array_of(value_of(scope, schema.LAYOUT, name))
        for name in ("viewDirection", "planeOrigin", "planeNormal")
    )
    return Layout(
        character=LayoutCharacter(
            root=str(scope.GetPath().GetParentPath()), base_values=array_of(values)
        ),
        elements=elements,
        left_off=_left_off(scope),
        frame=LayoutFrame(
            space=_value(scope, "layout:space"),
            view=view,
            plane=MirrorPlane(origin=origin, normal=normal),
            handle_width=float(value_of(scope, schema.LAYOUT, "handleWidth"))
            or _drawn_width(scope),
        ),
        proof=Proof(
            method=str(_value(scope, "solution:solver")),
            status=_value(scope, "solution:status"),
            cost=float(_value(scope, "solution:cost")),
            bound=float(_value(scope, "solution:bound")),
            above_unary_bound=float(_value(scope, "solution:inPlay")),
            weights=_weights(scope),
        ),
    )


def drawn_prims(element: Usd.Prim) -> tuple[tuple[Usd.Prim, Literal["handle", "track"]], ...]:
    """What is drawn of an element, and as what; an area is one of the tracks."""
    children = [(prim, set(applied(prim))) for prim in element.GetAllChildren()]
    return tuple(
        (prim, "handle" if HANDLE in apis else "track")
        for prim, apis in children
        if apis & {TRACK, HANDLE}
    )


def _value(prim: Usd.Prim, name: str, instance: str = "") -> Any:
    return declared_value(prim, _PROPERTIES[name], instance)


def _left_off(scope: Usd.Prim) -> tuple[LeftOff, ...]:
    columns = [
        strings(_value(scope, f"layout:leftOff{name}"))
        for name in ("Controls", "Stages", "Reasons")
    ]
    check_equal(scope, "rigUI:layout:leftOffReasons", *columns)
    return tuple(LeftOff(*row) for row in zip(*columns, strict=True))


def _weights(scope: Usd.Prim) -> tuple[tuple[str, float], ...]:
    names = strings(_value(scope, "solution:weightNames"))
    values = array_of(_value(scope, "solution:weightValues"))
    check_equal(scope, "rigUI:solution:weightValues", names, values)
    return tuple(zip(names, values.tolist(), strict=True))


def _element(prim: Usd.Prim) -> Element:
    def get(name: str) -> Any:
        return value_of(prim, schema.ELEMENT, name)

    instances, name = control_instances(prim), element_name(prim)
    return Element(
        name=name,
        manipulator=Manipulator(
            kind=get("elementType"),
            members=tuple(_member(prim, instance, len(instances)) for instance in instances),
            opposed=_pairs(prim, len(instances)),
            mirror=next(iter(element_names(prim, "mirror")), ""),
            reversed=_positions(prim, len(instances)),
        ),
        anchor=read_anchor(prim),
        look=Look(
            label=str(prim.GetMetadata("displayName") or name),
            side=get("side"),
            inner=element_names(prim, "members"),
            **_handle(prim),
        ),
        placement=placement(
            prim, "", str(_value(prim, "element:family")), str(_value(prim, "element:reason"))
        ),
    )


def _member(prim: Usd.Prim, instance: str, count: int) -> Member:
    track = _track_of(prim, instance, count)
    points = array_of(_value(track, "track:basePoints")).reshape(-1, 3)
    points = points if len(points) else vectors_of(track.GetAttribute("points"))
    values = array_of(_value(track, "track:weights"))
    if not len(values):
        low, high = (
            value_of(prim, schema.CONTROL, end, instance) for end in ("minimum", "maximum")
        )
        values = np.linspace(low, high, len(points))
    check_equal(track, "rigUI:track:weights", values, points)
    if len(points) < 2:
        raise refuse("LAYOUT_INVALID", str(track.GetPath()), "a track has two points at least")
    return Member(
        control=str(value_of(prim, schema.CONTROL, "name", instance)) or instance,
        values=values,
        track=points,
        arc_length=float(_value(prim, "control:__INSTANCE_NAME__:arcLength", instance)),
        magnification=float(_value(prim, "control:__INSTANCE_NAME__:gain", instance)),
    )


def _track_of(prim: Usd.Prim, instance: str, count: int) -> Usd.Prim:
    """The track that a control names, or the only one that shows it."""
    named = prim.GetRelationship(f"rigUI:control:{instance}:track")
    for target in named.GetTargets() if named else ():
        track = prim.GetStage().GetPrimAtPath(target)
        if track and has(track, TRACK):
            return track
    for child in prim.GetAllChildren():
        if has(child, TRACK):
            shown = strings(_value(child, "track:controls"))
            if shown == [instance] or (not shown and count == 1):
                return child
    raise refuse(
        "LAYOUT_INVALID", str(prim.GetPath()), f"has no track for the control {instance!r}"
    )


def _pairs(prim: Usd.Prim, count: int) -> tuple[tuple[int, int], ...]:
    pairs = tuple((int(a), int(b)) for a, b in _value(prim, "element:opposed"))
    ends = [end for pair in pairs for end in pair]
    if len(set(ends)) < len(ends) or not set(ends) <= set(range(count)):
        raise refuse(
            "LAYOUT_INVALID",
            f"{prim.GetPath()}.rigUI:element:opposed",
            f"{pairs} for {count} controls",
        )
    return pairs


def _positions(prim: Usd.Prim, count: int) -> tuple[int, ...]:
    positions = tuple(int(each) for each in _value(prim, "element:reversed"))
    if any(not 0 <= each < count for each in positions):
        raise refuse(
            "LAYOUT_INVALID",
            f"{prim.GetPath()}.rigUI:element:reversed",
            f"{positions} for {count} controls",
        )
    return positions


def _handle(prim: Usd.Prim) -> dict[str, Any]:
    """Of an element's handle: whether it deforms, and its glyph."""
    for child, role in drawn_prims(prim):
        if role == "handle":
            return {"adapt": _value(child, "handle:adapt"), "glyph": _glyph(child)}
    return {}


def _glyph(handle: Usd.Prim) -> Glyph | None:
    points = array_of(_value(handle, "handle:glyphOffsets")).reshape(-1, 3)
    if not len(points):
        return None
    curve = handle.IsA(UsdGeom.BasisCurves)
    counts = integers_of(handle.GetAttribute("curveVertexCounts" if curve else "faceVertexCounts"))
    indices = (
        np.arange(counts.sum()) if curve else integers_of(handle.GetAttribute("faceVertexIndices"))
    )
    name = str(_value(handle, "handle:glyph"))
    return checked_glyph(handle, Glyph(name, "curve" if curve else "mesh", points, counts, indices))


def _drawn_width(scope: Usd.Prim) -> float:
    """Width of the first handle drawn, for layers without a handle width."""
    for prim in Usd.PrimRange(scope, Usd.TraverseInstanceProxies(Usd.PrimAllPrimsPredicate)):
        if has(prim, HANDLE):
            points = _extent_or_points(prim)
            if len(points):
                return float(np.ptp(points, axis=0).max())
    return 0.0


def _extent_or_points(prim: Usd.Prim) -> Floats:
    extent = vectors_of(UsdGeom.Boundable(prim).GetExtentAttr())
    return extent if len(extent) else vectors_of(prim.GetAttribute("points"))
