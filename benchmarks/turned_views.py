"""The views from which handles are looked for: a part's own, its mirror image where that is another
one, each also turned to either side; numpy only, so that it serves Blender's Python too."""

import numpy as np

TURNS = (0.0, 40.0, -40.0)
"""Degrees about the up axis."""


def bases(view, up, across):
    """(3, 3) right, up and towards the viewer as columns, of each of the views; `view` and `up` are
    unit vectors (3,), `across` the normal of the mirror plane, or zero."""
    views = [view, view - 2.0 * (view @ across) * across][: 1 + (abs(view @ across) > 1e-6)]
    return [_basis(each, up, turn) for turn in np.radians(TURNS) for each in views]


def _basis(view, up, turn):
    """The view turned about the up axis; about another where the part is seen from above."""
    axis = up if abs(view @ up) < 0.9 else np.cross(up, np.roll(up, 1))
    right = np.cross(axis, view)
    right /= np.linalg.norm(right)
    look = view * np.cos(turn) + right * np.sin(turn)
    above = np.cross(view, right)
    return np.stack([np.cross(above, look), above, look], axis=1)
