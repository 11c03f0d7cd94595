"""Meshes that controls move and nobody sees: what their controls are laid out on the board for."""

from __future__ import annotations

from pxr import Usd, UsdGeom

from usdrigui.errors import Issue, issue
from usdrigui.model import RigMesh


def hidden_issues(
    stage: Usd.Stage, meshes: tuple[RigMesh, ...], time: Usd.TimeCode
) -> tuple[Issue, ...]:
    """One for each mesh that is not drawn and has what no drawn mesh has: blend shapes, or being
    deformed at all.

    Hidden stand-ins for what is drawn share its blend shapes, and are nothing to wonder at.
    """
    shown = [
        mesh
        for mesh in meshes
        if mesh.display.visible and (mesh.binding.shapes or mesh.binding.skin is not None)
    ]
    seen = {shape.channel for mesh in shown for shape in mesh.binding.shapes}
    found = []
    for mesh in meshes:
        own = sum(shape.channel not in seen for shape in mesh.binding.shapes)
        if mesh.display.visible or not (own or (mesh.binding.skin is not None and not shown)):
            continue
        what = (
            f"{own} of its blend shapes are on no mesh that is drawn"
            if own
            else "no mesh that is drawn deforms"
        )
        found.append(
            issue("MESH_HIDDEN", mesh.path, f"{_why(stage.GetPrimAtPath(mesh.path), time)}; {what}")
        )
    return tuple(found)


def _why(prim: Usd.Prim, time: Usd.TimeCode) -> str:
    """Why a mesh is not drawn."""
    image = UsdGeom.Imageable(prim)
    if image.ComputeVisibility(time) != UsdGeom.Tokens.invisible:
        return f"has the purpose {image.ComputePurpose()}"
    at = prim
    while at and UsdGeom.Imageable(at).GetVisibilityAttr().Get(time) != UsdGeom.Tokens.invisible:
        at = at.GetParent()
    return "is invisible" if not at or at == prim else f"is invisible, as {at.GetPath()} is"
