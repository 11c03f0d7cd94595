"""Partial layouts: anchors that are fixed, by the configuration or by an existing layout.

Fixed anchors (``controls."name".anchor``) are kept to the point, and the rest is optimal given them
(paper section 1, partial layouts).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from usdrigui.character import Body, Indices, Rig, RigMesh
from usdrigui.errors import meant, refuse
from usdrigui.model import Element, Layout
from usdrigui.model.levels import outer_first
from usdrigui.settings import ControlSettings

MIRROR = "mirror:"
"""In front of what ``near`` names: its mirror image."""


def with_fixed(
    rig: Rig, overrides: Sequence[ControlSettings], layout: Layout
) -> tuple[ControlSettings, ...]:
    """(controls,) the `overrides` with every anchor of `layout` fixed; a place that the
    configuration itself gives a control is stronger.

    Raises FIXED_IMPOSSIBLE where the layout was made for other points, CONFIG_UNKNOWN_CONTROL where
    it has a control that the rig lacks.
    """
    index = {control.name: i for i, control in enumerate(rig.controls)}
    found, placed = list(overrides), set[int]()
    for element in outer_first(layout.elements):
        for name in (member.control for member in element.manipulator.members):
            if name not in index:
                where = f"{layout.character.root} element {element.name}"
                what = f"{rig.skel_root.path} has no control {name!r}"
                raise refuse("CONFIG_UNKNOWN_CONTROL", where, what)
            control = index[name]
            override = found[control]
            if control in placed:
                if not (override.inner_anchor or element.anchor.on_board):
                    inner = _anchor_of(element, rig.body.meshes)
                    found[control] = replace(override, inner_anchor=inner)
            elif not (override.anchor or override.place):
                placed.add(control)
                found[control] = (
                    replace(override, place="board")
                    if element.anchor.on_board
                    else replace(override, anchor=_anchor_of(element, rig.body.meshes))
                )
    return tuple(found)


def fixed_anchor(rig: Rig, name: str, anchor: str) -> int | None:
    """The point of a partial layout that ``anchor`` fixes; raises as `anchored_point`."""
    return anchored_point(rig, f'controls."{name}".anchor', anchor)


def anchored_point(rig: Rig, where: str, anchor: str) -> int | None:
    """Index into all points of the rig of ``MESH_PATH#POINT``; None for an empty text.

    Raises CONFIG_VALUE for `where` when there is no such mesh or point."""
    if not anchor:
        return None
    path, mark, number = anchor.rpartition("#")
    if not mark or not number.isdecimal():
        raise refuse("CONFIG_VALUE", where, f"{anchor!r} is not MESH_PATH#POINT")
    return point_index(rig, where, path, int(number))


def place_of(body: Body, point: int) -> str:
    """``MESH_PATH#POINT`` of a point among all points of the rig."""
    mesh, local = body.mesh_of(point)
    return f"{body.meshes[mesh].path}#{local}"


def point_index(rig: Rig, where: str, path: str, local: int) -> int:
    """Index into all points of the rig of a point of one mesh; raises CONFIG_VALUE for `where` if
    there is none."""
    for start, mesh in zip(rig.body.starts, rig.body.meshes, strict=False):
        if mesh.path == path and local < len(mesh.points):
            return int(start + local)
    counts = {mesh.path: len(mesh.points) for mesh in rig.body.meshes}
    what = (
        f"the mesh {path} has the points 0 to {counts[path] - 1}, not {local}"
        if path in counts
        else f"{rig.skel_root.path} has no mesh {path!r}{meant(path, counts)}"
    )
    raise refuse("CONFIG_VALUE", where, what)


def moves(points: Indices, name: str, override: ControlSettings, point: int) -> bool:
    """Whether a control moves the point at which it is fixed; raises FIXED_IMPOSSIBLE if it should
    but does not."""
    if point in points:
        return True
    if override.place == "proxy":
        return False
    raise refuse(
        "FIXED_IMPOSSIBLE",
        f'controls."{name}".anchor',
        f"{name} does not move the point {override.anchor}",
    )


def _anchor_of(element: Element, meshes: tuple[RigMesh, ...]) -> str:
    """Its anchor as ``MESH_PATH#POINT``; raises FIXED_IMPOSSIBLE where that is another point by
    now."""
    anchor = element.anchor
    mesh = next((each for each in meshes if each.path == anchor.mesh), None)
    if mesh is None or not anchor.fits(mesh.topology.hash):
        change = "is gone" if mesh is None else "has other points or faces by now"
        raise refuse("FIXED_IMPOSSIBLE", element.name, f"its mesh {anchor.mesh} {change}")
    return f"{anchor.mesh}#{anchor.point}"
