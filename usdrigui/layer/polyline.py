"""Polylines with as few points as their bends need.  numpy only."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.overlap import segment_distances

_DIGITS = 6
"""Departures are compared with the tolerance to so many digits: no last bit of a processor
decides."""


def fewest_points(line: Floats, tolerance: float) -> Indices:
    """Ascending indices of the fewest points of a line (k, 3), its ends among them, between which
    straight pieces pass every point left out by `tolerance` at most (Imai and Iri 1988).

    Of several such choices, the one whose largest departure is least.  All points with a tolerance
    below zero.
    """
    unit = tolerance if tolerance > 0.0 else 1.0
    best = [(0, 0.0, 0, [0])]
    for last in range(1, len(line)):
        ways = []
        for first, (pieces, worst, _, kept) in enumerate(best):
            departure = round(_departure(line[first : last + 1]) / unit, _DIGITS)
            if departure <= tolerance / unit or last - first == 1:
                ways.append((pieces + 1, max(worst, departure), first, [*kept, last]))
        best.append(min(ways))
    return np.array(best[-1][3], dtype=np.int64)


def _departure(line: Floats) -> float:
    """The largest distance of points of a line from the straight piece between its ends."""
    start, end = line[[0, -1]][:, None, :, None]
    return float(segment_distances(line.T[None], start, end).max())
