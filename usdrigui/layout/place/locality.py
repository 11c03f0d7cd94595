"""Locality: a control kept near something that the configuration names, or at a proxy (paper section 6)."""

from __future__ import annotations

import re

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.errors import refuse
from usdrigui.layout.face import Face
from usdrigui.layout.reuse.partial_layout import MIRROR, point_index
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.symmetry.mirror_plane import reflected
from usdrigui.model import Flags, Floats, Indices, Rig
from usdrigui.ties import first_smallest

_PROXIES = 24
"""Visible points near a hidden region among which the optimiser may choose."""


def kept_near(
    face: Face, control: int, requests: Requests, points: Indices, among: Flags, default_radius: float
) -> Flags:
    """Those `among` (p,) the `points` (p,) that are within the radius of what ``near`` names (paper section 6,
    localizable); the nearest one where none is.  Radii are in face sizes.  Raises CONFIG_VALUE when ``near`` names
    nothing on the character."""
    override = requests.overrides[control]
    if not override.near or not among.any():
        return among
    centres = _centres(face, f'controls."{face.control_name(control)}".near', override.near.removeprefix(MIRROR))
    if override.near.startswith(MIRROR):
        centres = reflected(centres, face.symmetry)
    apart, _ = cKDTree(centres).query(face.trajectories.base[points])
    radius = (override.within or default_radius) * face.trajectories.face_size
    inside: Flags = among & (apart <= radius)
    if not inside.any():
        inside[first_smallest(np.where(among, apart, np.inf))] = True
    return inside


def proxies(face: Face, point: int) -> Indices:
    """Visible places nearest to a hidden `point`, ascending: where a hidden control can stand on the face."""
    places = face.trajectories.places
    seen = np.flatnonzero(face.views.anywhere & (places == np.arange(len(places))))
    if not len(seen):
        return seen
    count = min(_PROXIES, len(seen))
    _, nearest = cKDTree(face.trajectories.base[seen]).query(face.trajectories.base[point], k=count)
    return np.sort(seen[np.atleast_1d(nearest)])


def _centres(face: Face, where: str, near: str) -> Floats:
    rig = face.rig
    if near.startswith("joint:"):
        return _joint_position(rig, where, near.removeprefix("joint:"))[None]
    if match := re.fullmatch(r"(.+)\.point\[(\d+)\]", near):
        return np.array(face.trajectories.base[[point_index(rig, where, match[1], int(match[2]))]])
    for start, mesh in zip(rig.starts, rig.meshes, strict=False):
        if mesh.path == near:
            return np.array(face.trajectories.base[start : start + len(mesh.points)])
        for subset in mesh.subsets:
            if subset.path == near:
                return np.array(face.trajectories.base[start + subset.points])
    raise refuse("CONFIG_VALUE", where, f"{near!r} is no joint:NAME, mesh, GeomSubset or MESH.point[i] of {rig.root}")


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
