"""What the configuration says about a control's place: near something, at a point, or at a proxy."""

from __future__ import annotations

import re

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.errors import refuse
from usdrigui.layout.terms import Context
from usdrigui.model import Floats, Indices, Rig
from usdrigui.settings import ControlSettings

_PROXIES = 24
"""Visible points near a hidden region among which the optimiser may choose."""


def kept_near(context: Context, name: str, said: ControlSettings, points: Indices) -> Indices:
    """Those of `points` within the radius of what ``near`` names (paper section 6, localizable); the
    nearest one where none is.  Raises CONFIG_VALUE when ``near`` names nothing on the character."""
    if not said.near or not len(points):
        return points
    centres = _centres(context, f'controls."{name}".near', said.near)
    apart, _ = cKDTree(centres).query(context.trajectories.base[points])
    radius = (said.within or context.settings.candidates.near_radius) * context.trajectories.face_size
    inside = apart <= radius
    return points[inside] if inside.any() else points[[int(np.argmin(apart))]]


def fixed_anchor(rig: Rig, name: str, said: ControlSettings) -> int | None:
    """The point of a partial layout that ``anchor`` fixes, as ``MESH_PATH#POINT``.

    Raises CONFIG_VALUE when there is no such mesh or point."""
    if not said.anchor:
        return None
    where = f'controls."{name}".anchor'
    path, mark, number = said.anchor.rpartition("#")
    if not mark or not number.isdigit():
        raise refuse("CONFIG_VALUE", where, f"{said.anchor!r} is not MESH_PATH#POINT")
    return _point(rig, where, path, int(number))


def proxies(context: Context, point: int) -> Indices:
    """Visible places nearest to a hidden `point`, ascending: where a hidden control can stand on the face."""
    places = context.trajectories.places
    seen = np.flatnonzero(context.views.anywhere & (places == np.arange(len(places))))
    if not len(seen):
        return seen
    count = min(_PROXIES, len(seen))
    _, nearest = cKDTree(context.trajectories.base[seen]).query(context.trajectories.base[point], k=count)
    return np.sort(seen[np.atleast_1d(nearest)])


def _centres(context: Context, where: str, near: str) -> Floats:
    rig = context.rig
    if near.startswith("joint:"):
        return _joint_position(rig, where, near.removeprefix("joint:"))[None]
    if match := re.fullmatch(r"(.+)\.point\[(\d+)\]", near):
        return np.array(context.trajectories.base[[_point(rig, where, match[1], int(match[2]))]])
    for start, mesh in zip(rig.starts, rig.meshes, strict=False):
        if mesh.path == near:
            return np.array(context.trajectories.base[start : start + len(mesh.points)])
        for subset in mesh.subsets:
            if subset.path == near:
                return np.array(context.trajectories.base[start + subset.points])
    raise refuse("CONFIG_VALUE", where, f"{near!r} is no joint:NAME, mesh, GeomSubset or MESH.point[i] of {rig.root}")


def _point(rig: Rig, where: str, path: str, local: int) -> int:
    for start, mesh in zip(rig.starts, rig.meshes, strict=False):
        if mesh.path == path and local < len(mesh.points):
            return int(start + local)
    raise refuse("CONFIG_VALUE", where, f"there is no point {local} on a mesh {path!r}")


def _joint_position(rig: Rig, where: str, name: str) -> Floats:
    """(3,) position of a joint in root space at the base pose; `name` is its path or the path's last part."""
    for index, joint in enumerate(rig.joints):
        if name in (joint.path, joint.path.rpartition("/")[2]):
            matrix, at = np.eye(4), index
            while at >= 0:
                matrix = matrix @ rig.joints[at].base
                at = rig.joints[at].parent
            return np.asarray((matrix @ rig.skeletons[joint.skeleton].to_root)[3, :3], dtype=np.float64)
    raise refuse("CONFIG_VALUE", where, f"there is no joint {name!r}")
