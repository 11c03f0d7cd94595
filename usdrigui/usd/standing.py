"""The prims of a layout that stands, as far as a layer over it must know them to let them follow new shapes."""

from __future__ import annotations

from collections.abc import Iterator

from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.usd import schema
from usdrigui.usd.arrays import vector_count
from usdrigui.usd.read_layout import layout_scopes, value_of
from usdrigui.usd.reader_records import StandingPrim
from usdrigui.usd.shapes import shape_tokens


def standing_prims(stage: Usd.Stage) -> tuple[StandingPrim, ...]:
    """What is drawn of every element of every layout on the stage, and how it is shaped; in stage order.

    Raises ARRAY_TYPE and LAYOUT_INVALID.
    """
    return tuple(
        _standing(root, element, prim)
        for scope in layout_scopes(stage)
        for root in [str(scope.GetPath().GetParentPath())]
        for element in scope.GetAllChildren()
        if schema.ELEMENT in _applied(element)
        for prim in _drawn(element)
    )


def _drawn(element: Usd.Prim) -> Iterator[Usd.Prim]:
    for prim in element.GetAllChildren():
        if {schema.TRACK, schema.HANDLE} & set(_applied(prim)):
            yield prim


def _standing(root: str, element: Usd.Prim, prim: Usd.Prim) -> StandingPrim:
    path, points = str(prim.GetPath()), UsdGeom.PointBased(prim).GetPointsAttr()
    return StandingPrim(
        root=root,
        path=path,
        element=str(value_of(element, schema.ELEMENT, "name") or element.GetName()),
        role="handle" if schema.HANDLE in _applied(prim) else "area" if prim.IsA(UsdGeom.Mesh) else "track",
        controls=tuple(str(each) for each in value_of(prim, schema.TRACK, "controls")),
        points=vector_count(points.Get(), path, "points") if points else 0,
        shapes=shape_tokens(prim),
        targets=tuple(str(target) for target in UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().GetTargets()),
    )


def _applied(prim: Usd.Prim) -> list[str]:
    return [str(name) for name in prim.GetPrimTypeInfo().GetAppliedAPISchemas()]
