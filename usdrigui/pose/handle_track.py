"""How the drawing of an element goes with its anchor, and where a handle slides on its tracks.

These rules of the layer are here once.  Needs numpy only: the Blender extension takes this file
along as it is.

Maps act on row vectors.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def carried(points: Floats, position: Floats, anchor: Floats, carry: Floats) -> Floats:
    """(k, 3) `points` drawn about a `position` (3,), about the `anchor` (3,) where it is now;
    `carry` (3, 3) is the map of offsets of the skin there."""
    return anchor + (points - position) @ carry


def facing(normal: Floats, carry: Floats) -> Floats:
    """(3,) unit: a normal under the map of offsets `carry` (3, 3)."""
    turned = normal @ np.linalg.pinv(carry).T
    length = float(np.linalg.norm(turned))
    return turned / length if length else turned


def slid(
    values: Sequence[Floats], tracks: Sequence[Floats], base: Sequence[float], now: Sequence[float]
) -> tuple[Floats, Floats]:
    """(3,) places of a handle that slides on its tracks, one for each member: at the `base` values
    of the members, and `now`.

    The vertices of `tracks` (k, 3) are at `values` (k,), ascending.
    """
    homes = [along(at, track, value) for at, track, value in zip(values, tracks, base, strict=True)]
    moves = [
        along(at, track, value) - home
        for at, track, value, home in zip(values, tracks, now, homes, strict=True)
    ]
    return homes[0], homes[0] + sum(moves)


def along(values: Floats, track: Floats, value: float) -> Floats:
    """Point of a polyline (k, d) at a value: linear between the vertices and beyond the ends."""
    piece = piece_at(values, value)
    share = (value - values[piece]) / (values[piece + 1] - values[piece])
    return np.asarray((1.0 - share) * track[piece] + share * track[piece + 1])


def piece_at(values: Floats, value: float) -> int:
    """Index of the piece of a polyline on which a value lies, or of the nearest one."""
    return int(np.clip(np.searchsorted(values, value, side="right") - 1, 0, len(values) - 2))
