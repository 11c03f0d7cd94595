"""How wide handles are: a share of the face, and less where many controls want the same places.

Counted is where each control would keep most of its displacement.  Spread over those places by
their area, whatever the mesh's resolution, every control is one; around the place of one there are
then so many others, on average.  Handles are as wide as leaves no more than a comfortable number
within a few widths.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.character import Flags, Floats, Indices
from usdrigui.layout.face import AROUND
from usdrigui.layout.shares import KEPT, SAMPLE
from usdrigui.layout.visibility import Views
from usdrigui.model import Motion, Trajectories
from usdrigui.settings import ObjectiveSettings

_FINGER = 0.8
"""Of the usual width: a narrower handle is missed by a finger where the part fills a screen."""
_BLUR = np.linspace(0.5, 1.5, 5)
"""Shares of that distance over which the count is averaged: an area may be gathered in a few
points."""
_STEPS = 64
"""Widths tried between the least and the largest."""


def handle_width(
    trajectories: Trajectories,
    views: Views,
    placed: Flags,
    axes: Floats,
    settings: ObjectiveSettings,
    levels: bool,
) -> tuple[float, bool]:
    """Diameter of a handle in scene units, and whether there is a crowd.

    `placed` (motions,) are those of the controls that are to stand on the face, `axes` (d, 3) those
    along which places are apart: two on the screen of a flat layout.

    The largest of the widths from ``objective.handle_size_min`` to ``objective.handle_size`` at
    which no more than ``objective.max_neighbours`` controls are around one on average; the least
    where all are too wide.  A crowd is where that is too narrow for a finger, and there may be
    `levels`: it is as wide as a finger needs then, if no more than twice as many are around one.
    Invariant under rigid motion, uniform scale and the order and density of points.
    """
    points, weights = _wanted(trajectories, views.anywhere, placed)
    face = trajectories.surface.face_size
    places, finger = points @ axes.T, _FINGER * settings.handle_size * face
    width = fitting_width(places, weights, face, settings)
    if not levels or width >= finger:
        return width, False
    looser = replace(settings, max_neighbours=2.0 * settings.max_neighbours)
    return min(fitting_width(places, weights, face, looser), finger), True


def fitting_width(
    points: Floats, weights: Floats, face: float, settings: ObjectiveSettings
) -> float:
    """The same from the places (p, d) that controls want, along the character's axes, and how many
    want each (p,).

    `face` is its size; units of `face` and the width are those of `points`.
    """
    most = settings.handle_size * face
    least = min(settings.handle_size_min, settings.handle_size) * face
    if settings.max_neighbours <= 0.0 or least >= most or not len(points):
        return most
    # Pairs grow with the square: of more places those in a cell half a handle wide count as one.
    if len(points) > SAMPLE:
        points, weights = _gathered(points, weights, 0.5 * most)
    widths = np.linspace(least, most, _STEPS + 1)
    fits = np.flatnonzero(around(points, weights, AROUND * widths) <= settings.max_neighbours)
    return float(widths[fits[-1]]) if len(fits) else least


def around(points: Floats, weights: Floats, radii: Floats) -> Floats:
    """(r,) mean number of controls, itself included, within about each radius of a control.

    `points` (p, 3) are places, `weights` (p,) how many controls stand at each, in sum their number.
    """
    tree = cKDTree(points)
    pairs = tree.count_neighbors(tree, np.outer(radii, _BLUR).ravel(), weights=(weights, weights))
    return np.asarray(pairs.reshape(len(radii), -1).mean(axis=1) / weights.sum())


def _gathered(points: Floats, weights: Floats, size: float) -> tuple[Floats, Floats]:
    """Middles and weights of the cells of a grid."""
    cells = np.floor((points - points.min(axis=0)) / size).astype(np.int64)
    cell = np.unique(cells, axis=0, return_inverse=True)[1].ravel()
    total = np.bincount(cell, weights).astype(np.float64)
    middles = np.stack([np.bincount(cell, weights * axis) / total for axis in points.T], axis=1)
    return middles, total


def wanted(trajectories: Trajectories, anywhere: Flags, motion: Motion) -> tuple[Indices, Floats]:
    """Points where a control keeps most of its displacement, none where it is seen nowhere, and the
    share of each in their area."""
    surface = trajectories.surface
    seen = (anywhere & surface.first)[motion.points]
    arc = np.where(motion.stands_on(seen), motion.arc_length, 0.0)
    points = motion.points[(arc > 0.0) & (arc >= KEPT * arc.max(initial=0.0))]
    areas = surface.areas[points]
    if not areas.any():
        areas = np.ones(len(points))
    return points, areas / areas.sum()


def _wanted(trajectories: Trajectories, anywhere: Flags, placed: Flags) -> tuple[Floats, Floats]:
    """Places (p, 3) that the `placed` controls want, and how many want each (p,)."""
    total = np.zeros(len(trajectories.surface.points))
    for motion in (trajectories.motions[i] for i in np.flatnonzero(placed)):
        points, shares = wanted(trajectories, anywhere, motion)
        total[points] += shares
    chosen = np.flatnonzero(total)
    return trajectories.surface.points[chosen], total[chosen]
