"""Visibility shapes: controls that make parts disappear by collapsing them.

Rigs without visibility switches hide hair, jewellery or blush that way.  They give the largest
displacements of all and mean none of them, so they are not on the face.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.layout.shares import HARDLY_ANY, NEARLY_ALL
from usdrigui.model import Trajectories


def visibility_shapes(parts: Indices, trajectories: Trajectories) -> Flags:
    """(motions,) which controls mostly make whole `parts` (n,) of the surface disappear: nearly all
    points of a part move, and hardly any of its extent is left."""
    sizes = np.bincount(parts)
    flags = np.zeros(len(trajectories.motions), dtype=bool)
    for index, motion in enumerate(trajectories.motions):
        own = parts[motion.points]
        whole = np.bincount(own, minlength=len(sizes)) >= NEARLY_ALL * sizes
        moved = np.bincount(own, weights=motion.arc_length, minlength=len(sizes))
        before = trajectories.surface.points[motion.points]
        extents = _extents(own, before, len(sizes))
        shrunk = _extents(own, before + motion.offsets[-1], len(sizes)) < HARDLY_ANY * extents
        flags[index] = 2.0 * moved[whole & shrunk].sum() >= moved.sum()
    return flags


def _extents(parts: Indices, positions: Floats, count: int) -> Floats:
    """(count,) root mean square distance of each part's points from their middle."""
    number = np.maximum(np.bincount(parts, minlength=count), 1)
    square = np.zeros(count)
    for axis in positions.T:
        mean = np.bincount(parts, weights=axis, minlength=count) / number
        square += (
            np.bincount(parts, weights=np.square(axis - mean[parts]), minlength=count) / number
        )
    return np.sqrt(square)
