"""Partial layouts: anchors that are fixed, by the configuration or by an existing layout.

Fixed anchors (``controls."name".anchor``) are kept to the point, and the rest is optimal given them
(paper section 1, partial layouts).
"""

from __future__ import annotations

from usdrigui.character import Body, Indices, Rig
from usdrigui.errors import meant, refuse
from usdrigui.settings import ControlSettings

MIRROR = "mirror:"
"""In front of what ``near`` names: its mirror image."""


def fixed_anchor(rig: Rig, name: str, anchor: str) -> int:
    """The point of a partial layout that ``anchor`` fixes; raises as `anchored_point`."""
    return anchored_point(rig, f'controls."{name}".anchor', anchor)


def anchored_point(rig: Rig, where: str, anchor: str) -> int:
    """Index into all points of the rig of ``MESH_PATH#POINT``.

    Raises CONFIG_VALUE for `where` when there is no such mesh or point."""
    path, mark, number = anchor.rpartition("#")
    if not mark or not number.isdecimal():
        raise refuse("CONFIG_VALUE", where, f"{anchor!r} is not MESH_PATH#POINT")
    local = int(number)
    if (point := rig.body.point_of(path, local)) >= 0:
        return point
    meshes = rig.body.by_path
    what = (
        f"the mesh {path} has the points 0 to {len(meshes[path].points) - 1}, not {local}"
        if path in meshes
        else f"{rig.path} has no mesh {path!r}{meant(path, meshes)}"
    )
    raise refuse("CONFIG_VALUE", where, what)


def place_of(body: Body, point: int) -> str:
    """``MESH_PATH#POINT`` of a point among all points of the rig."""
    mesh, local = body.mesh_of(point)
    return f"{mesh.path}#{local}"


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
