"""The prims of existing layouts, as far as a layer over them must know them to let them follow new
shapes, and the characters that have no layout."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace

from pxr import Usd, UsdGeom

from usdrigui.errors import Issue, issue
from usdrigui.layer.properties import element_name, has
from usdrigui.layer.read_layout import element_prims, layout_scopes, points_by_role, switched_off
from usdrigui.model import ExistingPrim, ExistingSpan
from usdrigui.reading.blend_shape import names_and_targets
from usdrigui.reading.character import skel_roots
from usdrigui.stages import schema


def existing_prims(stage: Usd.Stage) -> tuple[ExistingPrim, ...]:
    """What is drawn of every layout on the stage, and how it is shaped; in stage order.

    Raises LAYOUT_INVALID, and TARGETS_LENGTH for a mesh whose shapes nobody could tell apart.
    """
    return tuple(prim for scope in layout_scopes(stage) for prim in _of_scope(scope))


def _of_scope(scope: Usd.Prim) -> Iterator[ExistingPrim]:
    root = str(scope.GetPath().GetParentPath())
    names = {element.GetName(): element_name(element) for element in element_prims(scope)}
    for mesh in Usd.PrimRange(scope, Usd.TraverseInstanceProxies(Usd.PrimAllPrimsPredicate)):
        if has(mesh, schema.DRAWING):
            yield _existing(root, mesh, tuple(_spans(mesh, names)))


def _spans(mesh: Usd.Prim, names: dict[str, str]) -> Iterator[ExistingSpan]:
    for child in mesh.GetAllChildren():
        name = names.get(child.GetName(), "")
        if name and child.IsA(UsdGeom.Subset):
            yield ExistingSpan(name, "handle", points_by_role(child, "handle"))
            yield ExistingSpan(name, "track", points_by_role(child, "track", "area", ""))


def _existing(root: str, prim: Usd.Prim, spans: tuple[ExistingSpan, ...]) -> ExistingPrim:
    shapes, targets = names_and_targets(prim)
    return ExistingPrim(
        root=root,
        path=str(prim.GetPath()),
        in_variant=any(spec.path.ContainsPrimVariantSelection() for spec in prim.GetPrimStack()),
        names=tuple(prim.GetAllChildrenNames()),
        spans=spans,
        shapes=shapes,
        targets=tuple(map(str, targets)),
    )


# --- characters without one -----------------------------------------------------------------------


_BINDINGS = ("skel:blendShapes", "primvars:skel:jointIndices")
"""Attributes by which a mesh is moved."""


def without_layout(stage: Usd.Stage, laid_out: Collection[str], wanted: str) -> tuple[Issue, ...]:
    """LAYOUT_OFF or LAYOUT_NONE for each SkelRoot, or the one `wanted`, that something animates and
    that is not `laid_out`."""
    roots = [str(root.GetPath()) for root in skel_roots(stage, wanted) if _is_animated(root)]
    off = switched_off(stage)
    return tuple(_bare(root, off) for root in roots if root not in laid_out)


def _bare(root: str, off: Mapping[str, str]) -> Issue:
    """That a character has no layout, or has one that is switched off on it or above it."""
    for where, selected in off.items():
        if f"{root}/".startswith(f"{where}/"):
            what = f"its layout is switched off, by rigUI = {selected} on {where}"
            return replace(issue("LAYOUT_OFF", root, what, root), severity="info")
    return issue("LAYOUT_NONE", root, "has no layout; other characters of the stage have one", root)


def _is_animated(root: Usd.Prim) -> bool:
    """Whether joints or blend shapes move a mesh below it; a prop without either is no
    character."""
    return any(
        attribute.HasAuthoredValue()
        for prim in Usd.PrimRange(root, Usd.TraverseInstanceProxies())
        if prim.IsA(UsdGeom.Mesh)
        for attribute in map(prim.GetAttribute, _BINDINGS)
    )
