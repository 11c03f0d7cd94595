"""Partial layouts: anchors that are fixed, by the configuration or by an existing layout.

Fixed anchors (``controls."name".anchor``) are kept to the point, and the rest is optimal given them
(paper section 1, partial layouts).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from usdrigui.errors import meant, refuse
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.symmetry.mirror_plane import plane_distance, reflected
from usdrigui.model import Body, Element, Floats, Indices, Layout, Rig, RigMesh, Symmetry
from usdrigui.model.levels import outer_first
from usdrigui.settings import ControlSettings

MIRROR = "mirror:"
"""In front of what ``near`` names: its mirror image."""
_SAME = 0.5
"""Earlier places of two twins mirror each other when they are nearer to it than this, in handle
widths."""


def fixed_by(
    layout: Layout, rig: Rig, controls: Mapping[str, ControlSettings]
) -> dict[str, ControlSettings]:
    """What the configuration says of controls, with every anchor of `layout` fixed.

    A place that the configuration itself gives a control is stronger.  Raises FIXED_IMPOSSIBLE
    where the layout was made for other points, CONFIG_UNKNOWN_CONTROL where it has a control that
    the rig lacks.
    """
    known = rig.control_names
    renamed = {each.rename: name for name, each in controls.items() if each.rename}
    found = dict(controls)
    placed: set[str] = set()
    for element in outer_first(layout.elements):
        for member in element.manipulator.members:
            if member.control not in known:
                where = f"{layout.character.root} element {element.name}"
                raise refuse(
                    "CONFIG_UNKNOWN_CONTROL",
                    where,
                    f"{rig.skel_root.path} has no control {member.control!r}",
                )
            name = renamed.get(member.control, member.control)
            override = found.get(name, ControlSettings())
            if name in placed:
                found[name] = _anchored_again(override, element, rig.body.meshes)
                continue
            if override.anchor or override.place:
                continue
            placed.add(name)
            found[name] = (
                replace(override, place="board")
                if element.anchor.on_board
                else _anchored(override, element, rig.body.meshes)
            )
    return found


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


def has_own_place(
    rig: Rig, base: Floats, symmetry: Symmetry, requests: Requests, width: float, control: int
) -> bool:
    """Whether a control of a pair has a place that is not the mirror image of its twin's, so that
    the two cannot be one decision: a fixed anchor, or an earlier place that was moved on one side
    only.

    `base` (n, 3) are the points of the base pose, `width` that of a handle.
    """
    twin, overrides, prior = int(symmetry.twins[control]), requests.overrides, requests.prior
    if twin >= 0 and _region(overrides[control]) != _region(overrides[twin]):
        return True
    if overrides[control].anchor:
        return not _fixed_in_mirror(rig, base, symmetry, requests, control)
    mine, other = prior.places.get(control), prior.places.get(twin)
    if mine is None or other is None or prior.cutoff_distance > 0.0:
        return False
    if mine.on_board or other.on_board:
        return mine.on_board != other.on_board
    apart = np.linalg.norm(reflected(mine.position, symmetry.plane) - other.position)
    return bool(apart > _SAME * width)


def _region(override: ControlSettings) -> tuple[str, str, float]:
    """The configured place of a control, apart from a fixed anchor."""
    return override.place, override.near.removeprefix(MIRROR), override.within


def _anchored(
    override: ControlSettings, element: Element, meshes: tuple[RigMesh, ...]
) -> ControlSettings:
    anchor = element.anchor
    mesh = next((each for each in meshes if each.path == anchor.mesh), None)
    if mesh is None or not anchor.fits(mesh.topology.hash):
        change = "is gone" if mesh is None else "has other points or faces by now"
        raise refuse("FIXED_IMPOSSIBLE", element.name, f"its mesh {anchor.mesh} {change}")
    return replace(override, anchor=f"{anchor.mesh}#{anchor.point}")


def _anchored_again(
    override: ControlSettings, element: Element, meshes: tuple[RigMesh, ...]
) -> ControlSettings:
    """The override with the anchor of the slider that the control has of its own under a coarse
    element."""
    if override.inner_anchor or element.anchor.on_board:
        return override
    return replace(override, inner_anchor=_anchored(override, element, meshes).anchor)


def _fixed_in_mirror(
    rig: Rig, base: Floats, symmetry: Symmetry, requests: Requests, control: int
) -> bool:
    """Whether both twins are fixed, and the right one exactly at the mirror partner of the left
    one."""
    twin, overrides = int(symmetry.twins[control]), requests.overrides
    if twin < 0 or not overrides[twin].anchor:
        return False
    pair = [fixed_anchor(rig, rig.controls[c].name, overrides[c].anchor) for c in (control, twin)]
    points = np.array([point for point in pair if point is not None])
    apart = plane_distance(base[points], symmetry.plane)
    left, right = points if apart[0] >= apart[1] else points[::-1]
    return bool(symmetry.partner[left] == right)
