"""Visibility shapes: controls that make parts disappear, by collapsing them or by hiding them inside.

Rigs without visibility switches hide hair, jewellery or blush that way.  They give the largest
displacements of all and mean none of them, so they are laid out beside the face.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from usdrigui.model import Flags, Floats, Indices, Motion
from usdrigui.rays import make_caster, visible_from
from usdrigui.surface import components, mesh_triangles, vertex_normals

if TYPE_CHECKING:
    from usdrigui.layout.terms import Context

_COLLAPSED = 0.1
"""A part collapses when its extent shrinks below this share."""
_WHOLE = 0.8
"""Share of a part's points that move when the part moves as a whole."""
_MOST = 0.5
"""Share of what a control moves, in displacement, that must vanish."""


def vanishing(context: Context) -> Flags:
    """(motions,) which controls mostly make whole parts of the surface disappear."""
    trajectories = context.trajectories
    corners = mesh_triangles(context.rig.meshes)
    parts = components(corners, trajectories.places)
    sizes = np.bincount(parts)
    flags = np.zeros(len(trajectories.motions), dtype=bool)
    for index, motion in enumerate(trajectories.motions):
        flags[index] = _vanishes(context, motion, parts, sizes)
    return flags


def _vanishes(context: Context, motion: Motion, parts: Indices, sizes: Indices) -> bool:
    own = parts[motion.points]
    whole = np.bincount(own, minlength=len(sizes)) >= _WHOLE * sizes
    moved = np.bincount(own, weights=motion.arc_length, minlength=len(sizes))
    if moved[whole].sum() < _MOST * moved.sum():
        return False
    before = context.trajectories.base[motion.points]
    after = before + motion.offsets[-1]
    shrunk = _extents(own, after, len(sizes)) < _COLLAPSED * _extents(own, before, len(sizes))
    if moved[whole & shrunk].sum() >= _MOST * moved.sum():
        return True
    return _sinks(context, motion, parts, whole)


def _extents(parts: Indices, positions: Floats, count: int) -> Floats:
    """(count,) root mean square distance of each part's points from their middle."""
    number = np.maximum(np.bincount(parts, minlength=count), 1)
    square = np.zeros(count)
    for axis in positions.T:
        mean = np.bincount(parts, weights=axis, minlength=count) / number
        square += np.bincount(parts, weights=np.square(axis - mean[parts]), minlength=count) / number
    return np.asarray(np.sqrt(square), dtype=np.float64)


def _sinks(context: Context, motion: Motion, parts: Indices, whole: Flags) -> bool:
    """Whether whole parts that could be seen move far and can no longer be seen."""
    views, trajectories = context.views, context.trajectories
    inside = whole[parts[motion.points]]
    points = motion.points[inside]
    seen = views.anywhere[points]
    size = float(_extents(np.zeros(len(points), dtype=np.int64), trajectories.base[points], 1)[0])
    if views.caster is None or not seen.any() or float(np.median(motion.arc_length[inside])) < size:
        return False
    end = trajectories.base.copy()
    end[motion.points] += motion.offsets[-1]
    corners = mesh_triangles(context.rig.meshes, visible_only=True)
    caster, normals = make_caster(end[corners]), vertex_normals(end, corners, trajectories.places)
    still = [visible_from(caster, end[points[seen]], normals[points[seen]], toward) for toward in views.directions]
    return bool(np.mean(np.any(still, axis=0)) < 0.05)
