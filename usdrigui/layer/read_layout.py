"""From a layer back to layouts, whoever wrote it.

Reads through composition, so that a layout in a sublayer of the asset, or one that stronger layers
have changed, is found as USD sees it.  The schema plug-in need not be registered: fallback values
come from the schema's own file.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray
from pxr import Sdf, Usd, UsdGeom

from usdrigui.character import Glyph, Indices, LeftOff
from usdrigui.errors import RigUIError, listed, refuse
from usdrigui.layer.properties import (
    applied,
    check_elements,
    chosen_point,
    control_instances,
    corrected,
    element_name,
    element_names,
    has,
    instances_applied,
    integers_of,
    invalid,
    read_anchor,
    refuse_broken,
    value_of,
)
from usdrigui.model import (
    Element,
    Layout,
    LayoutFrame,
    LayoutPart,
    Match,
    Member,
    MirrorPlane,
    Proof,
    Status,
    in_order,
    main_part,
)
from usdrigui.reading.character import metres_per_unit
from usdrigui.stages import schema
from usdrigui.stages.opening import open_stage, spec_paths
from usdrigui.stages.variant_paths import asset_selections, with_sets
from usdrigui.stages.variants import variant_path

_EVERYTHING = Usd.TraverseInstanceProxies(Usd.PrimAllPrimsPredicate)
_UNPROVEN = ("stopped", 0.0, 0.0)
"""Of a part whose proof a layer does not have."""
_FLATTENED = "Flattened_Prototype_"
"""How USD calls what the instances of a flattened stage refer to."""


def read_layout(
    source: Path | str | Sdf.Layer | Usd.Stage, *, carried: bool = False
) -> tuple[Layout, ...]:
    """All layouts that a layer or stage holds, one per character, in stage order.

    What the layer leaves out takes the schema's fallback.  `Layout.base_values` are in the
    order in which the layer names the controls (`Layout.listed`).  Of a layout to be `carried` to
    the rig of today, a point that a stronger layer chooses may be none of its mesh: it is lost.

    Raises RigUIError FILE_NOT_FOUND, FILE_NOT_USD, LAYER_MISSING, LAYER_UNREADABLE, LAYOUT_MISSING
    (no prim has RigUILayoutAPI), LAYOUT_OFF (variant selections leave all of them out),
    LAYOUT_INVALID (a property contradicts another) and LAYOUT_VERSION.
    """
    stage, name = _stage(source)
    layouts = tuple(layout_at(scope, carried=carried) for scope in layout_scopes(stage))
    if not layouts:
        raise _without(stage, name)
    return layouts


def _without(stage: Usd.Stage, name: str) -> RigUIError:
    """Why a stage has no layout: LAYOUT_OFF where a selection leaves them out, else
    LAYOUT_MISSING."""
    off = switched_off(stage)
    if not off:
        return refuse("LAYOUT_MISSING", name, f"no prim has {schema.LAYOUT}")
    places = {each: [path for path in off if off[path] == each] for each in off.values()}
    selections = [f"rigUI = {selected} on {listed(paths)}" for selected, paths in places.items()]
    return refuse("LAYOUT_OFF", name, f"is switched off, by {' and '.join(selections)}")


def switched_off(stage: Usd.Stage) -> dict[str, str]:
    """The variant that is selected instead, by each prim on which a layout is left out."""
    off: dict[str, str] = {}
    for prim in Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()):
        choice = prim.GetVariantSets().GetVariantSet(schema.VARIANTS)
        selected = choice.GetVariantSelection()
        if selected != schema.WITH and choice.HasAuthoredVariant(schema.WITH):
            off[str(prim.GetPath())] = selected
    return off


def with_corrections(stage: Usd.Stage, layouts: tuple[Layout, ...]) -> tuple[Layout, ...]:
    """The layouts of a stage; opinions of stronger layers on elements are decisions of a person.

    For those that succeed them; a check judges the composed stage, whichever layer has the opinion.
    """
    scopes = {str(scope.GetPath().GetParentPath()): scope for scope in layout_scopes(stage)}
    return tuple(_corrected(layout, scopes[layout.root]) for layout in layouts)


def _corrected(layout: Layout, scope: Usd.Prim) -> Layout:
    """The layout with those decisions; what was pinned as the mirror image of an element follows it
    again, unless somebody says more of it."""
    elements = tuple(map(corrected, layout.elements, element_prims(scope)))
    said = (new for old, new in zip(layout.elements, elements, strict=True) if new is not old)
    names = {name for each in said for name in each.controls}
    free = layout.follow(names) - names

    def following(element: Element) -> Element:
        kept = tuple(each for each in element.pinned if each != "anchor")
        return replace(element, pinned=kept)

    return replace(
        layout,
        elements=tuple(
            each if free.isdisjoint(each.controls) else following(each) for each in elements
        ),
    )


def layout_scopes(stage: Usd.Stage) -> Iterator[Usd.Prim]:
    """The prims that have layouts below them, defined or not: a layout is there even when its
    source is not."""
    return (prim for prim in _scopes(stage) if prim.IsActive())


def _scopes(stage: Usd.Stage) -> Iterator[Usd.Prim]:
    """The same, with those that are inactive; neither classes nor prototypes of a flattened stage
    are characters."""
    walk = iter(Usd.PrimRange(stage.GetPseudoRoot(), _EVERYTHING))
    for prim in walk:
        if prim.IsAbstract() or prim.GetName().startswith(_FLATTENED):
            walk.PruneChildren()
        elif any(map(schema.is_layout, applied(prim))):
            walk.PruneChildren()
            yield prim


def element_prims(scope: Usd.Prim) -> tuple[Usd.Prim, ...]:
    """The active elements of a layout: those that it lists, in that order, and the others as they
    are below it."""
    listed = [*map(scope.GetStage().GetPrimAtPath, value_of(scope, schema.LAYOUT, "elements"))]
    walk = Usd.PrimRange(scope, _EVERYTHING)
    found = dict.fromkeys([*(prim for prim in listed if prim), *walk])
    return tuple(prim for prim in found if prim.IsActive() and has(prim, schema.ELEMENT))


def layout_paths(layer: Sdf.Layer) -> tuple[Sdf.Path, ...]:
    """The scopes of the layouts that a layer itself has, with the variants that hold them."""
    named = (each for each in spec_paths(layer) if each.IsPrimPath() and each.name == schema.SCOPE)
    return tuple(each for each in named if _is_layout(layer.GetPrimAtPath(each)))


def own_layouts(stage: Usd.Stage) -> tuple[str, ...]:
    """Scopes of the layouts that the root layer of a stage authors, rather than one that it brings
    in."""
    root = stage.GetRootLayer()
    return tuple(
        str(scope.GetPath())
        for scope in layout_scopes(stage)
        if any(spec.layer == root and _is_layout(spec) for spec in scope.GetPrimStack())
    )


def composed_layouts(stage: Usd.Stage) -> dict[str, str]:
    """By SkelRoot, the file of the layout that another layer than the root layer brings in, active
    or not."""
    found: dict[str, str] = {}
    for scope in _scopes(stage):
        layer = next((spec.layer for spec in scope.GetPrimStack() if _is_layout(spec)), None)
        if layer and layer != stage.GetRootLayer():
            found[str(scope.GetPath().GetParentPath())] = str(layer.realPath or layer.identifier)
    return found


def source_of(path: Path) -> str:
    """The asset that a layout layer sublayers; empty if it has none.

    That is its first sublayer, anchored; or, where the layout itself is in a sublayer (attached to
    the asset), the file.  Raises FILE_NOT_FOUND and FILE_NOT_USD.
    """
    layer = Sdf.Layer.FindOrOpen(str(path)) if path.is_file() else None
    if layer is None:
        raise refuse(
            "FILE_NOT_USD" if path.is_file() else "FILE_NOT_FOUND", path, "is not a USD layer"
        )
    paths = list(layer.subLayerPaths)
    if paths and not layout_paths(layer) and any(_brings_layout(layer, each) for each in paths):
        return str(path)
    return str(Sdf.ComputeAssetPathRelativeToLayer(layer, paths[0])) if paths else ""


def _brings_layout(layer: Sdf.Layer, sublayer: str) -> bool:
    """Whether a sublayer is a layout without a source of its own."""
    found = Sdf.Layer.FindOrOpen(Sdf.ComputeAssetPathRelativeToLayer(layer, sublayer))
    return found is not None and not len(found.subLayerPaths) and bool(layout_paths(found))


def _is_layout(spec: Sdf.PrimSpec) -> bool:
    """Whether a layer itself marks the prim as a layout."""
    applied = spec.GetInfo("apiSchemas")
    return isinstance(applied, Sdf.TokenListOp) and any(
        map(schema.is_layout, applied.GetAppliedItems())
    )


def _stage(source: Path | str | Sdf.Layer | Usd.Stage) -> tuple[Usd.Stage, str]:
    if isinstance(source, Usd.Stage):
        return source, str(source.GetRootLayer().identifier)
    if isinstance(source, Sdf.Layer):
        return Usd.Stage.Open(source), str(source.identifier)
    return open_stage(Path(source)), str(source)


# --- records --------------------------------------------------------------------------------------


def layout_at(scope: Usd.Prim, *, carried: bool = False) -> Layout:
    """The layout of the prim with RigUILayoutAPI; raises as `read_layout`."""
    for prim in Usd.PrimRange(scope, _EVERYTHING):
        for each in filter(schema.is_later, applied(prim)):
            known = each.partition("_")[0]
            raise refuse("LAYOUT_VERSION", prim.GetPath(), f"{each}; known: {known}")

    get = partial(value_of, scope, schema.LAYOUT)
    refuse_broken(scope, schema.LAYOUT)
    proof, proofs, left_off, matches = _recorded(scope)
    parts = _parts(scope, proofs)
    widths = {part.name: part.handle_width for part in parts}
    elements = tuple(_element(prim, carried=carried) for prim in element_prims(scope))
    check_elements(scope, elements)
    listed, base = tuple(get("baseControls")), get("baseValues")
    return Layout(
        root=str(scope.GetPath().GetParentPath()),
        base_values=base if len(base) else np.zeros(len(listed)),
        listed=listed,
        variant_path=_variant_path(scope),
        matches=matches,
        elements=elements,
        left_off=left_off,
        frame=LayoutFrame(
            space=get("space"),
            view=get("viewDirection"),
            plane=MirrorPlane(get("planeOrigin"), get("planeNormal")),
            handle_width=widths[main_part(list(widths))] if parts else get("handleWidth"),
            parts=parts,
        ),
        proof=proof,
        metres_per_unit=_metres_per_unit(scope.GetStage()),
    )


def _metres_per_unit(stage: Usd.Stage) -> float:
    """Of the strongest layer that says it: a layer of opinions, which says none, means those of the
    layout that it is about."""
    layers = [each for each in stage.GetLayerStack() if each.pseudoRoot.HasInfo("metersPerUnit")]
    return (layers and metres_per_unit(layers[0])) or 0.01


def _variant_path(scope: Usd.Prim) -> str:
    """Its SkelRoot with the asset's variants that bring the layout in, from whichever layer."""
    paths = [str(spec.path) for spec in scope.GetPrimStack() if _is_layout(spec)]
    return with_sets(
        variant_path(scope.GetParent()), frozenset[str]().union(*map(asset_selections, paths))
    )


def _parts(scope: Usd.Prim, proofs: Sequence[Any]) -> tuple[LayoutPart, ...]:
    """The parts of a character; proofs that the layer lacks are unknown."""
    instances = instances_applied(scope, schema.PART)
    proofs = proofs if len(proofs) == len(instances) else [_UNPROVEN] * len(instances)
    return tuple(_part(scope, *each) for each in zip(instances, proofs, strict=True))


def _part(scope: Usd.Prim, instance: str, proof: Any) -> LayoutPart:
    get = partial(value_of, scope, schema.PART, instance=instance)
    refuse_broken(scope, schema.PART, instance)
    name = get("name") or instance
    return LayoutPart(name, get("handleWidth"), get("viewDirection"), *proof)


def _recorded(
    scope: Usd.Prim,
) -> tuple[Proof, list[Any], tuple[LeftOff, ...], tuple[Match, ...]]:
    """How the layout was found, with the proofs of its parts, and what was left off, by the layer;
    nothing of a layout made by hand.  Raises LAYOUT_INVALID."""
    text = scope.GetCustomDataByKey(schema.NOTES)
    if not isinstance(text, str):  # that of an earlier version is none
        return Proof(), [], (), ()
    try:
        found = json.loads(text)
        proof = msgspec.convert(found["proof"], Proof)
        if not np.isfinite([proof.cost, proof.above_unary_bound]).all():
            raise ValueError("a cost is not finite")
        return (
            proof,
            msgspec.convert(found["parts"], list[tuple[Status, float, float]]),
            msgspec.convert(found["leftOff"], tuple[LeftOff, ...]),
            msgspec.convert(found["matches"], tuple[Match, ...]),
        )
    except (KeyError, TypeError, ValueError, msgspec.ValidationError) as error:
        what = f"customData {schema.NOTES} is no record of usdrigui: {error}"
        raise invalid(scope, what) from None


def _element(prim: Usd.Prim, *, carried: bool) -> Element:
    get = partial(value_of, prim, schema.ELEMENT)
    instances, name = control_instances(prim), element_name(prim)
    free = chosen_point(prim) if carried else ()
    x, y, z = get("pinnedPosition").tolist()
    for api in (schema.ELEMENT, schema.ANCHOR, schema.HANDLE):
        refuse_broken(prim, api, free=free)
    return Element(
        name=name,
        kind=get("elementType"),
        members=tuple(_member(prim, instance) for instance in instances),
        opposed=_opposed(prim, instances),
        mirror=next(iter(element_names(prim, "mirror")), ""),
        reversed=tuple(
            i
            for i, each in enumerate(instances)
            if value_of(prim, schema.CONTROL, "mirrorReversed", each)
        ),
        anchor=read_anchor(prim),
        label=str(prim.GetMetadata("displayName") or prim.GetName()),
        side=get("side"),
        adapt=value_of(prim, schema.HANDLE, "adapt"),
        glyph=_glyph(prim),
        inner=element_names(prim, "members"),
        part=value_of(prim.GetParent(), schema.DRAWING, "part"),
        category=get("category"),
        reason=prim.GetDocumentation() if prim.HasAuthoredDocumentation() else "",
        pinned=in_order(get("pinned")),
        pinned_position=(x, y, z),
    )


def _member(prim: Usd.Prim, instance: str) -> Member:
    get = partial(value_of, prim, schema.CONTROL, instance=instance)
    refuse_broken(prim, schema.CONTROL, instance)
    points, values = get("trackPoints"), get("trackValues")
    if not len(values):
        values = np.linspace(get("minimum"), get("maximum"), len(points))
    return Member(
        control=get("name") or instance,
        values=values,
        track=points,
        arc_length=get("arcLength"),
        magnification=get("magnification"),
        peak=get("peak"),
        attribute=f"{prim.GetPath()}.rigUI:control:{instance}:value",
    )


def _opposed(prim: Usd.Prim, instances: list[str]) -> tuple[tuple[int, int], ...]:
    """(negative, positive) positions, as the positive ends name the negative ones."""
    named = [value_of(prim, schema.CONTROL, "opposes", each) for each in instances]
    unknown = [each for each in named if each and each not in instances]
    pairs = [] if unknown else [(instances.index(each), i) for i, each in enumerate(named) if each]
    ends = [end for pair in pairs for end in pair]
    if unknown or len(set(ends)) < len(ends):
        raise invalid(prim, f"rigUI:control:*:opposes makes no pairs of {instances}")
    return tuple(pairs)


def _glyph(prim: Usd.Prim) -> Glyph | None:
    """The custom shape of a handle; None for the usual one.  Raises LAYOUT_INVALID."""
    get = partial(value_of, prim, schema.HANDLE)
    points = get("glyphOffsets").reshape(-1, 3)
    if not len(points):
        return None
    counts, indices = get("glyphCounts"), get("glyphIndices")
    if get("glyphType") == "curve":
        indices = np.arange(len(points), dtype=np.int64)
    if counts.sum() != len(indices):
        raise invalid(prim, "rigUI:handle:glyphOffsets do not fit what is drawn")
    return Glyph(get("glyph"), get("glyphType"), points, counts, indices)


def points_by_role(prim: Usd.Prim, *wanted: str) -> Indices:
    """Indices, ascending, of the points that a GeomSubset draws in some of `schema.ROLES`.

    Raises LAYOUT_INVALID.
    """
    return points_of(faces_by_role(prim, *wanted))


def points_of(faces: Iterable[Indices]) -> Indices:
    """Indices, ascending, of the points of some faces."""
    return np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *faces]))


def faces_by_role(prim: Usd.Prim, *wanted: str) -> list[Indices]:
    """The points of each face, ascending, that a GeomSubset draws in some of `schema.ROLES`.

    Raises LAYOUT_INVALID.
    """
    mesh = UsdGeom.Mesh(prim.GetParent())
    counts, corners = (
        integers_of(each)
        for each in (mesh.GetFaceVertexCountsAttr(), mesh.GetFaceVertexIndicesAttr())
    )
    faces = np.sort(integers_of(UsdGeom.Subset(prim).GetIndicesAttr()))
    if counts.sum() != len(corners) or ((faces < 0) | (faces >= len(counts))).any():
        raise invalid(prim, "its faces are not those of its mesh")
    faces = faces[np.isin(face_roles(prim.GetParent(), len(counts))[faces], wanted)]
    ends = np.cumsum(counts)
    return [corners[ends[face] - counts[face] : ends[face]] for face in faces]


def face_roles(mesh: Usd.Prim, count: int) -> NDArray[np.str_]:
    """(count,) what each face of a mesh is drawn for, as `schema.ROLES`; nothing where it does not
    say.  Raises LAYOUT_INVALID."""
    primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar(schema.ROLE)
    roles = np.array(value_of(mesh, schema.DRAWING, "role"), dtype=np.str_)
    if primvar and primvar.IsIndexed():  # USD 24.11 does not flatten tokens
        indices = np.array(primvar.GetIndices(), dtype=np.int64)
        if ((indices < 0) | (indices >= len(roles))).any():
            raise invalid(primvar.GetAttr(), "has indices beyond its values")
        roles = roles[indices]
    if len(roles) not in (0, 1, count):
        raise invalid(primvar.GetAttr(), f"has {len(roles)} roles for {count} faces")
    return np.broadcast_to(roles, count) if len(roles) else np.full(count, "", dtype=np.str_)
