"""The prims of an existing layout, as far as a layer over it must know them to let them follow new
shapes."""

from __future__ import annotations

from collections.abc import Iterator

from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.usd import schema
from usdrigui.usd.properties import element_name, has
from usdrigui.usd.read_layout import element_prims, layout_scopes, points_of_subset
from usdrigui.usd.reader_records import ExistingPrim, ExistingSpan
from usdrigui.usd.shapes import shape_tokens


def existing_prims(stage: Usd.Stage) -> tuple[ExistingPrim, ...]:
    """What is drawn of every layout on the stage, and how it is shaped; in stage order.

    Raises LAYOUT_INVALID.
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
        if child.IsA(UsdGeom.Subset) and child.GetName() in names:
            handle, track = points_of_subset(child)
            yield ExistingSpan(names[child.GetName()], "handle", handle)
            yield ExistingSpan(names[child.GetName()], "track", track)


def _existing(root: str, prim: Usd.Prim, spans: tuple[ExistingSpan, ...]) -> ExistingPrim:
    return ExistingPrim(
        root=root,
        path=str(prim.GetPath()),
        in_variant=any(spec.path.ContainsPrimVariantSelection() for spec in prim.GetPrimStack()),
        names=tuple(child.GetName() for child in prim.GetAllChildren()),
        spans=spans,
        shapes=shape_tokens(prim),
        targets=tuple(
            str(target)
            for target in UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().GetTargets()
        ),
    )
