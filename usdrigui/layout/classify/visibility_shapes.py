"""Visibility shapes: controls that make parts disappear, by collapsing them or by moving them
inside.

Rigs without visibility switches hide hair, jewellery or blush that way.  They give the largest
displacements of all and mean none of them, so they are not on the face.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Flags, Floats, Indices, RigMesh
from usdrigui.character.rays import make_caster, visible_from
from usdrigui.character.surface import components, mesh_triangles, vertex_normals
from usdrigui.layout.visibility import Views
from usdrigui.model import BaseSurface, Motion, Trajectories

_COLLAPSED = 0.1
"""A part collapses when its extent shrinks below this share."""
_WHOLE = 0.8
"""Share of a part's points that move when the part moves as a whole."""
_MOST = 0.5
"""Share of what a control moves, in displacement, that must vanish."""
_STILL_SEEN = 0.05
"""Share of the points of a part that may still be seen once it has moved inside."""


def visibility_shapes(
    meshes: tuple[RigMesh, ...], trajectories: Trajectories, views: Views
) -> Flags:
    """(motions,) which controls mostly make whole parts of the surface disappear."""
    parts = components(mesh_triangles(meshes), trajectories.surface.places)
    sizes = np.bincount(parts)
    flags = np.zeros(len(trajectories.motions), dtype=bool)
    for index, motion in enumerate(trajectories.motions):
        own = parts[motion.points]
        whole = np.bincount(own, minlength=len(sizes)) >= _WHOLE * sizes
        moved = np.bincount(own, weights=motion.arc_length, minlength=len(sizes))
        if moved[whole].sum() >= _MOST * moved.sum():
            collapsed = whole & _shrunk(trajectories.surface.points, motion, own, len(sizes))
            flags[index] = moved[collapsed].sum() >= _MOST * moved.sum() or _moves_inside(
                meshes, trajectories.surface, views, motion, whole[own]
            )
    return flags


def _shrunk(base: Floats, motion: Motion, parts: Indices, count: int) -> Flags:
    """(count,) which parts the control shrinks to next to nothing; `parts` (p,) are those of its
    points."""
    before = base[motion.points]
    after = before + motion.polylines.offsets[-1]
    return np.asarray(_extents(parts, after, count) < _COLLAPSED * _extents(parts, before, count))


def _extents(parts: Indices, positions: Floats, count: int) -> Floats:
    """(count,) root mean square distance of each part's points from their middle."""
    number = np.maximum(np.bincount(parts, minlength=count), 1)
    square = np.zeros(count)
    for axis in positions.T:
        mean = np.bincount(parts, weights=axis, minlength=count) / number
        square += (
            np.bincount(parts, weights=np.square(axis - mean[parts]), minlength=count) / number
        )
    return np.asarray(np.sqrt(square), dtype=np.float64)


def _moves_inside(
    meshes: tuple[RigMesh, ...], surface: BaseSurface, views: Views, motion: Motion, inside: Flags
) -> bool:
    """Whether the points `inside` (p,) of the motion, whole parts that can be seen, move far and
    out of sight."""
    points = motion.points[inside]
    seen = views.anywhere[points]
    size = float(_extents(np.zeros(len(points), dtype=np.int64), surface.points[points], 1)[0])
    if views.caster is None or not seen.any() or float(np.median(motion.arc_length[inside])) < size:
        return False
    end = surface.points.copy()
    end[motion.points] += motion.polylines.offsets[-1]
    corners = mesh_triangles(meshes, visible_only=True)
    caster = make_caster(end[corners])
    normals = vertex_normals(end, corners, surface.places)
    still = [
        visible_from(caster, end[points[seen]], normals[points[seen]], toward)
        for toward in views.directions
    ]
    return bool(np.mean(np.any(still, axis=0)) < _STILL_SEEN)
