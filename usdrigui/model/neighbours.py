"""Which ends of an element's tracks are next to each other: an area is drawn between them.

numpy only: the Blender extension takes this file along as it is.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_FLAT = np.radians(2.0)
"""Two tracks closer to one line than this span no area."""
_BESIDE = 0.05
"""Of a track's length: it begins at the handle if it begins nearer than this."""


def end_of(tracks: Sequence[Floats], end: int) -> Floats:
    """An end of one of m `tracks` (k, ...): i is the last point of track i, m + i the first."""
    return np.asarray(tracks[end % len(tracks)][-1 if end < len(tracks) else 0])


def neighbours(
    tracks: Sequence[Floats],
    home: Floats,
    normal: Floats,
    across: Floats,
    axes: Collection[Collection[int]],
) -> list[tuple[int, int]]:
    """Pairs of ends, as in `end_of`, that are next to each other around the `normal` (3,) of the
    handle's place `home` (3,), at most 180 degrees apart; never the two ends of one axis.

    They go round from the direction `across` (3,), which is square to the normal.
    """
    count = len(tracks)
    away = [end_of(tracks, end) - home for end in range(2 * count)]
    ends = [
        end
        for end, each in enumerate(away)
        if end < count or np.linalg.norm(each) > _BESIDE * np.linalg.norm(away[end - count])
    ]
    along = np.array([away[end] for end in ends])
    angle = np.arctan2(along @ np.cross(normal, across), along @ across)
    order = np.argsort(angle, kind="stable")
    rounds = list(zip(order, np.roll(order, -1), strict=True))
    pairs = []
    for a, b in rounds[:1] if len(order) == 2 else rounds:
        between = (angle[b] - angle[a]) % (2.0 * np.pi)
        if len(order) == 2 and between > np.pi:
            a, b, between = b, a, 2.0 * np.pi - between
        members = {ends[a] % count, ends[b] % count}
        if _FLAT < between < np.pi - _FLAT and not any(members <= set(axis) for axis in axes):
            pairs.append((ends[a], ends[b]))
    return pairs
