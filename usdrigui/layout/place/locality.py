"""Locality: a control kept near something that the configuration names, or at a proxy (paper
section 6)."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.character import Flags, Floats, Indices, Rig
from usdrigui.character.surface import mesh_triangles, surface_distances
from usdrigui.errors import listed, meant, refuse
from usdrigui.layout.face import Face
from usdrigui.layout.motion.owned_skin import joint_places
from usdrigui.layout.reuse.partial_layout import MIRROR, anchored_point
from usdrigui.layout.reuse.requests import Requests
from usdrigui.ties import first_smallest

_PROXIES = 24
"""Visible points near a hidden region among which the optimiser may choose."""


def kept_near(face: Face, control: int, requests: Requests, points: Indices, among: Flags) -> Flags:
    """Those `among` (p,) the `points` (p,) that are within the radius of what ``near`` names (paper
    section 6, localizable); the nearest one where none is.  Radii are in face sizes, along the
    surface.  Raises CONFIG_VALUE when ``near`` names nothing on the character."""
    override = requests.overrides[control]
    if not override.near or not among.any():
        return among
    apart = _distances(face, f'controls."{face.control_name(control)}".near', override.near)[points]
    radius = override.within * face.surface.face_size
    inside: Flags = among & (apart <= radius)
    if not inside.any():
        inside[first_smallest(np.where(among, apart, np.inf))] = True
    return inside


def check_near(rig: Rig, where: str, near: str) -> None:
    """Raise CONFIG_VALUE for `where` when `near` names nothing on the character."""
    name = near.removeprefix(MIRROR)
    if name.startswith("joint:"):
        _joint_position(rig, where, name.removeprefix("joint:"))
    else:
        _named_points(rig, where, name)


def proxies(face: Face, point: int) -> Indices:
    """Visible places nearest to a hidden `point`, ascending: where a hidden control can stand on
    the face."""
    surface = face.surface
    seen = np.flatnonzero(face.views.anywhere & surface.first)
    if not len(seen):
        return seen
    count = min(_PROXIES, len(seen))
    _, nearest = cKDTree(surface.points[seen]).query(surface.points[point], k=count)
    return np.sort(seen[np.atleast_1d(nearest)])


def _distances(face: Face, where: str, near: str) -> Floats:
    """(n,) how far every point is from what `near` names: along the surface, so that a lip is not
    near the other, and straight where no surface leads there (another mesh, a joint)."""
    surface = face.surface
    base, name = surface.points, near.removeprefix(MIRROR)
    joint = name.startswith("joint:")
    if joint:
        centres = _joint_position(face.rig, where, name.removeprefix("joint:"))[None]
    else:
        centres = np.array(base[_named_points(face.rig, where, name)])
    if near.startswith(MIRROR):
        centres = face.symmetry.plane.reflected(centres)
    straight, _ = cKDTree(centres).query(base)
    if joint:
        return np.asarray(straight)
    _, sources = cKDTree(base).query(centres)
    along = surface_distances(
        base,
        mesh_triangles(face.rig.body.meshes),
        surface.places,
        sources,
    )
    return np.where(np.isfinite(along), along, straight)


def _named_points(rig: Rig, where: str, near: str) -> Indices:
    body = rig.body
    if "#" in near:
        return np.array([anchored_point(rig, where, near)])
    for start, mesh in zip(body.starts, body.meshes, strict=False):
        if mesh.path == near:
            return np.arange(start, start + len(mesh.points))
        for subset in mesh.topology.subsets:
            if subset.path == near:
                return np.asarray(start + subset.points)
    meshes = [mesh.path for mesh in body.meshes]
    subsets = [subset.path for mesh in body.meshes for subset in mesh.topology.subsets]
    joints = [f"joint:{joint.name}" for joint in body.joints]
    like = meant(near, (*meshes, *subsets, *joints)) or f"; its meshes are {listed(meshes)}"
    raise refuse(
        "CONFIG_VALUE",
        where,
        f"{near!r} is not a joint:NAME, mesh, GeomSubset or MESH#POINT of {rig.path}{like}",
    )


def _joint_position(rig: Rig, where: str, name: str) -> Floats:
    """(3,) position of a joint in root space at the base pose; `name` is its path or the path's
    last part."""
    body = rig.body
    for index, joint in enumerate(body.joints):
        if name in (joint.path, joint.name):
            return np.asarray(joint_places(body)[index])
    names = [joint.name for joint in body.joints]
    like = meant(name, names) or (f"; its joints are {listed(names)}" if names else "")
    raise refuse("CONFIG_VALUE", where, f"{rig.path} has no joint {name!r}{like}")
