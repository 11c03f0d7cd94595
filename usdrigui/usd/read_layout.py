"""From a layer back to layouts, whoever wrote it.

Reads through composition, so that a layout in a sublayer of the asset, or one that stronger layers have
changed, is found as USD sees it.  The schema plug-in need not be registered: fallback values come from
the schema's own file.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, get_args

import numpy as np
from pxr import Sdf, Usd, UsdGeom, Vt

from usdrigui.errors import refuse
from usdrigui.model import Anchor, Decision, Element, Floats, Glyph, Indices, Layout, LayoutPart, LeftOff, Member
from usdrigui.usd import author, schema
from usdrigui.usd.arrays import value_at
from usdrigui.usd.stage import open_stage

_DECIDED: Mapping[Decision, frozenset[str]] = {
    "anchor": frozenset(author.properties(schema.ANCHOR)[name].name for name in ("prim", "pointIndex")),
    "place": frozenset({author.properties(schema.ANCHOR)["carrier"].name}),
    "grouping": frozenset(author.properties(schema.ELEMENT)[name].name for name in ("controls", "elementType")),
}
"""Properties in which the decisions of a layout stand."""
_FLATTENED = "Flattened_Prototype_"
"""How USD calls what the instances of a flattened stage refer to."""


def read_layout(source: Path | str | Sdf.Layer | Usd.Stage) -> tuple[Layout, ...]:
    """All layouts that a layer or stage holds, one per character, in stage order.

    What the layer leaves out takes the schema's fallback.  `Layout.base_values` are in the order in which
    the layer names the controls (`base_controls`).

    Raises RigUIError FILE_NOT_FOUND, FILE_NOT_USD, LAYER_MISSING, LAYER_UNREADABLE, LAYOUT_MISSING (no prim has
    RigUILayoutAPI), LAYOUT_INVALID (a property contradicts another) and LAYOUT_VERSION.
    """
    stage, name = _stage(source)
    layouts = tuple(_layout(scope) for scope in layout_scopes(stage))
    if not layouts:
        raise refuse("LAYOUT_MISSING", name, f"no prim has {schema.LAYOUT}")
    return layouts


def layout_scopes(stage: Usd.Stage) -> Iterator[Usd.Prim]:
    """The prims below which layouts stand, defined or not: a layout is there even when its source is not."""
    return (prim for prim in _scopes(stage) if prim.IsActive())


def _scopes(stage: Usd.Stage) -> Iterator[Usd.Prim]:
    """The same, with those that are inactive; neither classes nor prototypes of a flattened stage are characters."""
    everything = Usd.TraverseInstanceProxies(Usd.PrimAllPrimsPredicate)
    walk = iter(Usd.PrimRange(stage.GetPseudoRoot(), everything))
    for prim in walk:
        if prim.IsAbstract() or prim.GetName().startswith(_FLATTENED):
            walk.PruneChildren()
        elif schema.LAYOUT in prim.GetPrimTypeInfo().GetAppliedAPISchemas():
            walk.PruneChildren()
            yield prim


def own_layouts(stage: Usd.Stage) -> tuple[str, ...]:
    """Scopes of the layouts that the root layer of a stage authors, rather than one that it brings in."""
    scopes = (scope.GetPath() for scope in layout_scopes(stage))
    return tuple(str(scope) for scope in scopes if _is_layout(stage.GetRootLayer().GetPrimAtPath(scope)))


def brought_layouts(stage: Usd.Stage) -> dict[str, str]:
    """By SkelRoot, the file of the layout that another layer than the root layer brings in, active or not."""
    found: dict[str, str] = {}
    for scope in _scopes(stage):
        layers = [spec.layer for spec in scope.GetPrimStack() if _is_layout(spec)]
        if layers and stage.GetRootLayer() not in layers:
            found[str(scope.GetPath().GetParentPath())] = str(layers[0].realPath or layers[0].identifier)
    return found


def base_controls(scope: Usd.Prim) -> tuple[str, ...]:
    """Names of the controls whose values `Layout.base_values` lists, of the layout at `scope`."""
    return tuple(_strings(value_of(scope, schema.LAYOUT, "baseControls")))


def source_of(path: Path) -> str:
    """The asset that a layout layer stands over; empty if it has none.

    That is its first sublayer, anchored; or, where the layout itself is in a sublayer (attached to the
    asset), the file.  Raises FILE_NOT_FOUND and FILE_NOT_USD.
    """
    layer = Sdf.Layer.FindOrOpen(str(path)) if path.is_file() else None
    if layer is None:
        raise refuse("FILE_NOT_USD" if path.is_file() else "FILE_NOT_FOUND", str(path), "is not a USD layer")
    paths = list(layer.subLayerPaths)
    if paths and not _holds_layout(layer) and any(_brings_layout(layer, each) for each in paths):
        return str(path)
    return str(Sdf.ComputeAssetPathRelativeToLayer(layer, paths[0])) if paths else ""


def _brings_layout(layer: Sdf.Layer, sublayer: str) -> bool:
    """Whether a sublayer is a layout without a source of its own."""
    found = Sdf.Layer.FindOrOpen(Sdf.ComputeAssetPathRelativeToLayer(layer, sublayer))
    return found is not None and not len(found.subLayerPaths) and _holds_layout(found)


def _holds_layout(layer: Sdf.Layer) -> bool:
    """Whether the layer itself has a layout, below whichever prim."""
    found: list[Sdf.Path] = []

    def visit(path: Sdf.Path) -> None:
        if path.IsPrimPath() and path.name == schema.SCOPE:
            found.append(path)

    layer.Traverse(Sdf.Path.absoluteRootPath, visit)
    return any(_is_layout(layer.GetPrimAtPath(each)) for each in found)


def _is_layout(spec: Sdf.PrimSpec | None) -> bool:
    """Whether a layer itself says that the prim is a layout."""
    applied = spec.GetInfo("apiSchemas") if spec is not None else None
    return isinstance(applied, Sdf.TokenListOp) and schema.LAYOUT in applied.GetAppliedItems()


def _stage(source: Path | str | Sdf.Layer | Usd.Stage) -> tuple[Usd.Stage, str]:
    if isinstance(source, Usd.Stage):
        return source, str(source.GetRootLayer().identifier)
    if isinstance(source, Sdf.Layer):
        return Usd.Stage.Open(source), str(source.identifier)
    return open_stage(Path(source)), str(source)


# --- records -----------------------------------------------------------------------------------------


def _layout(scope: Usd.Prim) -> Layout:
    def get(name: str) -> Any:
        return value_of(scope, schema.LAYOUT, name)

    def solution(name: str) -> Any:
        return value_of(scope, schema.SOLUTION, name)

    if get("version") > schema.VERSION:
        raise refuse("LAYOUT_VERSION", str(scope.GetPath()), f"version {get('version')}; known: {schema.VERSION}")
    _check_equal(scope, "baseValues", get("baseControls"), get("baseValues"))
    elements = tuple(_element(prim) for prim in scope.GetAllChildren() if _has(prim, schema.ELEMENT))
    _check_unique(scope, [element.name for element in elements])
    _check_levels(scope, elements)
    return Layout(
        root=str(scope.GetPath().GetParentPath()),
        elements=elements,
        left_off=_left_off(scope),
        handle_width=float(get("handleWidth")) or _drawn_width(scope),
        space=get("space"),
        view=_floats(get("viewDirection")),
        plane_origin=_floats(get("planeOrigin")),
        plane_normal=_floats(get("planeNormal")),
        base_values=_floats(get("baseValues")),
        method=str(solution("solver")),
        status=solution("status"),
        cost=float(solution("cost")),
        bound=float(solution("bound")),
        in_play=float(solution("inPlay")),
        weights=_weights(scope),
        parts=_parts(scope),
    )


def _parts(scope: Usd.Prim) -> tuple[LayoutPart, ...]:
    """The parts of a character; what a layer does not say of them is unknown."""
    names = _strings(value_of(scope, schema.LAYOUT, "parts"))
    widths = _floats(value_of(scope, schema.LAYOUT, "partHandleWidths"))
    views = _floats(value_of(scope, schema.LAYOUT, "partViewDirections")).reshape(-1, 3)
    proofs = [value_of(scope, schema.SOLUTION, f"part{name}") for name in ("Statuses", "Costs", "Bounds")]
    statuses, costs, bounds = proofs if len(proofs[0]) else (["stopped"] * len(names), *np.zeros((2, len(names))))
    _check_equal(scope, "rigUI:layout:parts", names, widths, views, statuses, costs, bounds)
    rows = zip(names, widths.tolist(), views, _strings(statuses), costs, bounds, strict=True)
    return tuple(
        LayoutPart(name, width, view, "optimal" if status == "optimal" else "stopped", float(cost), float(bound))
        for name, width, view, status, cost, bound in rows
    )


def _left_off(scope: Usd.Prim) -> tuple[LeftOff, ...]:
    columns = [_strings(value_of(scope, schema.LAYOUT, f"leftOff{name}")) for name in ("Controls", "Stages", "Reasons")]
    _check_equal(scope, "leftOffReasons", *columns)
    return tuple(LeftOff(*row) for row in zip(*columns, strict=True))


def _weights(scope: Usd.Prim) -> tuple[tuple[str, float], ...]:
    names = _strings(value_of(scope, schema.SOLUTION, "weightNames"))
    values = _floats(value_of(scope, schema.SOLUTION, "weightValues"))
    _check_equal(scope, "weightValues", names, values)
    return tuple(zip(names, values.tolist(), strict=True))


def _element(prim: Usd.Prim) -> Element:
    def get(name: str) -> Any:
        return value_of(prim, schema.ELEMENT, name)

    applied = _instances(prim)
    instances = _strings(get("controls")) or applied
    unknown = [instance for instance in instances if instance not in applied]
    if unknown or not instances:
        what = f"lists {unknown[0]!r}, but does not apply it" if unknown else "has no control"
        raise refuse("LAYOUT_INVALID", str(prim.GetPath()), what)
    mirror, members = (_targets(prim, schema.ELEMENT, each) for each in ("mirror", "members"))
    name = str(get("name")) or prim.GetName()
    return Element(
        name=name,
        label=str(prim.GetMetadata("displayName") or name),
        kind=get("elementType"),
        members=tuple(_member(prim, instance, len(instances)) for instance in instances),
        opposed=_pairs(prim, get("opposed"), len(instances)),
        anchor=_anchor(prim),
        side=get("side"),
        reversed=_positions(prim, get("reversed"), len(instances)),
        mirror=_element_name(prim.GetStage().GetPrimAtPath(mirror[0])) if mirror else "",
        category=str(get("family")),
        part=str(get("part")),
        reason=str(get("reason")),
        inner=tuple(_element_name(prim.GetStage().GetPrimAtPath(each)) for each in members),
        **_pinned(prim),
        **_handle(prim),
    )


def _member(prim: Usd.Prim, instance: str, count: int) -> Member:
    def get(name: str) -> Any:
        return value_of(prim, schema.CONTROL, name, instance)

    track = _track_of(prim, instance, count)
    points = _track_points(track)
    values = _floats(value_of(track, schema.TRACK, "weights"))
    if not len(values):
        values = np.linspace(get("minimum"), get("maximum"), len(points))
    _check_equal(track, "rigUI:track:weights", values, points)
    if len(points) < 2:
        raise refuse("LAYOUT_INVALID", str(track.GetPath()), "a track has two points at least")
    return Member(
        control=str(get("name")) or instance,
        values=values,
        track=points,
        arc_length=float(get("arcLength")),
        gain=float(get("gain")),
    )


def _track_of(prim: Usd.Prim, instance: str, count: int) -> Usd.Prim:
    """The track that a control names, or the only one that shows it."""
    for target in _targets(prim, schema.CONTROL, "track", instance):
        track = prim.GetStage().GetPrimAtPath(target)
        if track and _has(track, schema.TRACK):
            return track
    for child in prim.GetAllChildren():
        if _has(child, schema.TRACK):
            shown = _strings(value_of(child, schema.TRACK, "controls"))
            if shown == [instance] or (not shown and count == 1):
                return child
    raise refuse("LAYOUT_INVALID", str(prim.GetPath()), f"has no track for the control {instance!r}")


def _track_points(track: Usd.Prim) -> Floats:
    points = _floats(value_of(track, schema.TRACK, "basePoints"))
    if not len(points):
        points = _drawn_points(track)
    return points.reshape(-1, 3)


def _drawn_points(prim: Usd.Prim) -> Floats:
    """(n, 3) points of a gprim, at the earliest time if they have no default; none if it has none at all."""
    return _vectors(prim.GetAttribute("points"))


def _vectors(attribute: Usd.Attribute) -> Floats:
    """(n, 3) what an array of USD's own schemas holds; raises LAYOUT_INVALID."""
    values = value_at(attribute, Usd.TimeCode.Default()) if attribute else None
    if not isinstance(values, (Vt.Vec3fArray, Vt.Vec3dArray, Vt.Vec3hArray, type(None))):
        raise _invalid(attribute, "does not hold 3-vectors")
    points = _floats(values or ()).reshape(-1, 3)
    if not np.isfinite(points).all():
        raise _invalid(attribute, "holds NaN or infinity")
    return points


def _anchor(prim: Usd.Prim) -> Anchor:
    def get(name: str) -> Any:
        return value_of(prim, schema.ANCHOR, name)

    on_face = _targets(prim, schema.ANCHOR, "prim")
    targets = on_face or _targets(prim, schema.ANCHOR, "carrier")
    if on_face and get("pointIndex") < 0:
        raise refuse("LAYOUT_INVALID", str(prim.GetPath()), "stands on a mesh, but rigUI:anchor:pointIndex is missing")
    return Anchor(
        mesh=str(targets[0]) if targets else "",
        point=int(get("pointIndex")),
        point_count=int(get("pointCount")),
        topology_hash=str(get("topologyHash")),
        position=_floats(get("position")),
        normal=_floats(get("normal")),
        on_board=not on_face,
    )


def _handle(prim: Usd.Prim) -> dict[str, Any]:
    """What an element's handle says: whether it deforms, and its glyph."""
    for child in prim.GetAllChildren():
        if _has(child, schema.HANDLE):
            return {"adapt": value_of(child, schema.HANDLE, "adapt"), "glyph": _glyph(child)}
    return {"adapt": author.properties(schema.HANDLE)["adapt"].fallback}


def _glyph(handle: Usd.Prim) -> Glyph | None:
    """The custom shape of a handle; None for the usual one."""
    points = _floats(value_of(handle, schema.HANDLE, "glyphOffsets")).reshape(-1, 3)
    if not len(points):
        return None
    curve = handle.IsA(UsdGeom.BasisCurves)
    counts = _indices(handle, "curveVertexCounts" if curve else "faceVertexCounts")
    indices = np.arange(counts.sum()) if curve else _indices(handle, "faceVertexIndices")
    least, most = indices.min(initial=0), indices.max(initial=-1)
    if counts.min(initial=0) < 0 or counts.sum() != len(indices) or least < 0 or most >= len(points):
        raise refuse("LAYOUT_INVALID", f"{handle.GetPath()}.rigUI:handle:glyphOffsets", "do not fit what is drawn")
    name = str(value_of(handle, schema.HANDLE, "glyph"))
    return Glyph(name, "curve" if curve else "mesh", points, counts, indices)


def _indices(prim: Usd.Prim, name: str) -> Indices:
    attribute = prim.GetAttribute(name)
    values = attribute.Get() if attribute else None
    return np.array(values if isinstance(values, Vt.IntArray) else (), dtype=np.int64)


def _drawn_width(scope: Usd.Prim) -> float:
    """Width of the first handle drawn, for layers that do not say it."""
    for prim in Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate):
        if _has(prim, schema.HANDLE):
            extent = _vectors(UsdGeom.Boundable(prim).GetExtentAttr())
            points = extent if len(extent) else _drawn_points(prim)
            if len(points):
                return float(np.ptp(points, axis=0).max())
    return 0.0


# --- properties --------------------------------------------------------------------------------------


def _applied(prim: Usd.Prim) -> list[str]:
    return [str(name) for name in prim.GetPrimTypeInfo().GetAppliedAPISchemas()]


def _has(prim: Usd.Prim, api: str) -> bool:
    return api in _applied(prim)


def _instances(prim: Usd.Prim) -> list[str]:
    """Controls in the order in which they are applied, for layers that do not list them."""
    prefix = f"{schema.CONTROL}:"
    return [name.removeprefix(prefix) for name in _applied(prim) if name.startswith(prefix)]


def value_of(prim: Usd.Prim, api: str, name: str, instance: str = "") -> Any:
    """Value of a property of one of our schemas, or its fallback.

    Raises LAYOUT_INVALID for a value of another type or outside the allowed ones.
    """
    declared = author.properties(api)[name]
    attribute = prim.GetAttribute(declared.name.replace("__INSTANCE_NAME__", instance))
    value = attribute.Get() if attribute else None
    if value is None:
        return declared.fallback
    # A crate may hold a value that is not of the type named beside it.
    named = attribute.GetTypeName() == Sdf.ValueTypeNames.Find(declared.type_name)
    if not named or not isinstance(value, type(declared.fallback)):
        raise _invalid(attribute, f"is {attribute.GetTypeName()}, not {declared.type_name}")
    if declared.allowed and value not in declared.allowed:
        raise _invalid(attribute, f"is {value!r}, not one of {', '.join(declared.allowed)}")
    if declared.type_name not in ("token", "string", "token[]", "string[]") and np.isnan(value).any():
        raise _invalid(attribute, "holds NaN")
    return value


def _invalid(attribute: Usd.Attribute, message: str) -> Exception:
    return refuse("LAYOUT_INVALID", str(attribute.GetPath()), message)


def _targets(prim: Usd.Prim, api: str, name: str, instance: str = "") -> list[Sdf.Path]:
    declared = author.properties(api)[name]
    relationship = prim.GetRelationship(declared.name.replace("__INSTANCE_NAME__", instance))
    return list(relationship.GetTargets()) if relationship else []


def _element_name(prim: Usd.Prim) -> str:
    return (str(value_of(prim, schema.ELEMENT, "name")) or prim.GetName()) if prim else ""


def _pairs(prim: Usd.Prim, values: Any, count: int) -> tuple[tuple[int, int], ...]:
    pairs = tuple((int(a), int(b)) for a, b in values)
    ends = [end for pair in pairs for end in pair]
    if len(set(ends)) < len(ends) or not set(ends) <= set(range(count)):
        raise refuse("LAYOUT_INVALID", f"{prim.GetPath()}.rigUI:element:opposed", f"{pairs} for {count} controls")
    return pairs


def _positions(prim: Usd.Prim, values: Any, count: int) -> tuple[int, ...]:
    positions = tuple(int(each) for each in values)
    if any(not 0 <= each < count for each in positions):
        raise refuse("LAYOUT_INVALID", f"{prim.GetPath()}.rigUI:element:reversed", f"{positions} for {count} controls")
    return positions


def _pinned(prim: Usd.Prim) -> dict[str, Any]:
    """The decisions of a person: those on record, or those that a layer says that is stronger than the defining one.

    Such a layer need not say where its anchor is; then nobody knows it, should the mesh get other points.
    """
    values = value_of(prim, schema.ELEMENT, "pinned")
    unknown = sorted(set(_strings(values)) - set(get_args(Decision)))
    if unknown:
        raise refuse("LAYOUT_INVALID", f"{prim.GetPath()}.rigUI:element:pinned", f"{unknown[0]!r} is no decision")
    said = _said_above(prim)
    found = set(values)
    if author.properties(schema.ELEMENT)["pinned"].name not in said:
        found |= {decision for decision, names in _DECIDED.items() if said & names}
    place = _floats(value_of(prim, schema.ELEMENT, "pinnedPosition"))
    if said & _DECIDED["anchor"]:
        known = author.properties(schema.ANCHOR)["position"].name in said
        place = _floats(value_of(prim, schema.ANCHOR, "position")) if known else np.full(3, np.nan)
    return {
        "pinned": tuple(each for each in get_args(Decision) if each in found),
        "pinned_position": tuple(place.tolist()),
    }


def _said_above(prim: Usd.Prim) -> set[str]:
    """Properties of which a layer stronger than the one that defines the prim has an opinion."""
    stack = prim.GetPrimStack()
    defining = next((number for number, spec in enumerate(stack) if spec.specifier == Sdf.SpecifierDef), len(stack))
    return {str(each) for spec in stack[:defining] for each in spec.properties.keys()}  # noqa: SIM118 (a view of Sdf)


def _check_equal(prim: Usd.Prim, name: str, *columns: Any) -> None:
    lengths = [len(column) for column in columns]
    if len(set(lengths)) > 1:
        raise refuse("LAYOUT_INVALID", f"{prim.GetPath()}.{name}", f"lengths {lengths} should be equal")


def _check_unique(scope: Usd.Prim, names: list[str]) -> None:
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise refuse("LAYOUT_INVALID", str(scope.GetPath()), f"two elements are called {twice[0]!r}")


def _check_levels(scope: Usd.Prim, elements: tuple[Element, ...]) -> None:
    known, coarse = {element.name for element in elements}, {element.name for element in elements if element.inner}
    for element in elements:
        for name in element.inner:
            if name not in known or name in coarse:
                what = "is coarse itself" if name in coarse else "is no element of the layout"
                raise refuse("LAYOUT_INVALID", str(scope.GetPath()), f"{name!r}, a member of {element.name!r}, {what}")


def _strings(values: Any) -> list[str]:
    return [str(value) for value in values]


def _floats(values: Any) -> Floats:
    return np.array(values, dtype=np.float64)
