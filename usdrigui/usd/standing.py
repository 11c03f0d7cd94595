"""The prims of a layout that stands, as far as a layer over it must know them to let them follow new shapes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.usd import author, schema
from usdrigui.usd.child import StandingPrim
from usdrigui.usd.read_layout import layout_scopes


def standing_prims(stage: Usd.Stage) -> tuple[StandingPrim, ...]:
    """What is drawn of every element of every layout on the stage, and how it is shaped; in stage order."""
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
    binding = UsdSkel.BindingAPI(prim)
    points = UsdGeom.PointBased(prim).GetPointsAttr()
    return StandingPrim(
        root=root,
        path=str(prim.GetPath()),
        element=str(_told(element, schema.ELEMENT, "name") or element.GetName()),
        role="handle" if schema.HANDLE in _applied(prim) else "area" if prim.IsA(UsdGeom.Mesh) else "track",
        controls=tuple(str(each) for each in _told(prim, schema.TRACK, "controls") or ()),
        points=len(points.Get() or ()) if points else 0,
        shapes=tuple(str(token) for token in binding.GetBlendShapesAttr().Get() or ()),
        targets=tuple(str(target) for target in binding.GetBlendShapeTargetsRel().GetTargets()),
    )


def _told(prim: Usd.Prim, api: str, name: str) -> Any:
    attribute = prim.GetAttribute(author.properties(api)[name].name)
    return attribute.Get() if attribute else None


def _applied(prim: Usd.Prim) -> list[str]:
    return [str(name) for name in prim.GetPrimTypeInfo().GetAppliedAPISchemas()]
