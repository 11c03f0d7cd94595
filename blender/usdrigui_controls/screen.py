"""From drags in the plane of the screen to control values; numpy only, nothing of Blender.

Pixels have x to the right and y down.  The rule of drags is usdrigui's own file, put into `maths`
when the extension is built.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .maths.drag import begin_drag, drag_to, values_at

FINE = 0.1
"""How much slower the handle is than the pointer in a fine drag."""
_BEHIND = -0.05
"""Elements that face away from the viewer by more than this cosine cannot be seen."""


@dataclass(frozen=True)
class Screen:
    """A view: what is where on its pixels."""

    matrix: np.ndarray
    """(4, 4) world to clip space, for column vectors."""
    width: float
    height: float
    eye: np.ndarray
    """(3,) the viewer, or for a view without perspective the direction towards him."""
    perspective: bool

    def project(self, points):
        """(n, 2) pixels of world points (n, 3); NaN for those behind the viewer."""
        homogeneous = np.asarray(points) @ self.matrix[:, :3].T + self.matrix[:, 3]
        w = homogeneous[:, 3:]
        with np.errstate(divide="ignore", invalid="ignore"):
            clip = np.where(w > 0.0, homogeneous[:, :2] / w, np.nan)
        return (clip * (1.0, -1.0) + 1.0) * 0.5 * (self.width, self.height)

    def faces(self, placed):
        """Whether an element's front is seen."""
        toward = self.toward(placed.handle)
        farthest = _BEHIND * np.linalg.norm(toward) * np.linalg.norm(placed.normal)
        return placed.normal @ toward >= farthest

    def toward(self, point):
        """(3,) from a world point to the viewer."""
        return self.eye - point if self.perspective else self.eye

    def radius(self, placed, width):
        """Pixels that half of ``width`` scene units take at an element's handle."""
        right, _ = self.axes_at(placed.handle)
        return 0.5 * width * placed.scale / max(np.linalg.norm(right), 1e-30)

    def axes_at(self, point):
        """(3,) each, the world vectors of one pixel to the right and one upward at a world
        point."""
        w = max(self.matrix[3, :3] @ point + self.matrix[3, 3], 1e-30)
        axes = zip(self.matrix[:2, :3], (self.width, self.height), strict=True)
        return [2.0 * w / size * axis / (axis @ axis) for axis, size in axes]


def pick(screen, elements, pointer, radii, reach=8.0):
    """Index of the element whose handle is nearest to the ``pointer`` (2,), or -1.

    ``elements`` are `Placed` ones, ``radii`` their handles' pixels; a handle is caught within its
    radius, and within ``reach`` pixels however small it is drawn.  Each handle's distance counts
    from its centre, so that of two handles on one spot the pointer takes the one it is nearer to.
    """
    caught = []
    for i, placed in enumerate(elements):
        if screen.faces(placed):
            away = np.linalg.norm(screen.project(placed.handle[None])[0] - pointer)
            if away <= max(radii[i], reach):
                caught.append((away, i))
    return min(caught, default=(0.0, -1))[1]


class Grab:
    """One drag of one element, from press to release."""

    def __init__(self, screen, drawing, placed):
        tracks = [screen.project(track) for track in placed.tracks]
        self.drag = begin_drag(
            tracks,
            drawing.values,
            drawing.element.axes,
            drawing.ranges,
            drawing.base,
            placed.values,
        )
        self.at = self.drag.start

    def to(self, way):
        """(m,) member values when the pointer has gone a ``way`` (2,); within the controls'
        ranges."""
        self.at = drag_to(self.drag, self.at, way)
        return values_at(self.drag, self.at)
