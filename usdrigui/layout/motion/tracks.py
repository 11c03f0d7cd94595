"""The geometry of elements: tracks as polylines, resampled, and enlarged where they would be too
short."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.model import Motion

_ENLARGED = 3.0
"""How many times its motion a track is drawn at most."""


def paths(motion: Motion, points: Indices) -> Floats:
    """(p, k, 3) offsets of `points` from their base positions at the motion's knots; zero where
    unmoved."""
    rows, found = rows_of(points, motion.points)
    offsets = motion.offsets[:, rows].astype(np.float64).transpose(1, 0, 2)
    return np.where(found[:, None, None], offsets, 0.0)


def arc_lengths(motion: Motion, points: Indices) -> Floats:
    """(p,) arc lengths at `points`; zero where unmoved."""
    rows, found = rows_of(points, motion.points)
    return np.where(found, motion.arc_length[rows], 0.0)


def rows_of(points: Indices, among: Indices) -> tuple[Indices, Flags]:
    """(p,) the rows of `points` (p,) `among` ascending ones, and whether they are there."""
    rows = np.minimum(np.searchsorted(among, points), len(among) - 1)
    return rows, among[rows] == points


def lengths(lines: Floats) -> Floats:
    """(...) lengths of polylines (..., k, 3)."""
    return np.asarray(np.linalg.norm(np.diff(lines, axis=-2), axis=-1).sum(axis=-1))


def magnification(long: Floats, least: float) -> Floats:
    """(p,) factors, three at most, that bring lengths `long` to at least `least`; 1 where they are
    long enough."""
    short = (long < least) & (long > 0.0)
    return np.where(short, np.minimum(least / np.where(short, long, 1.0), _ENLARGED), 1.0)


def resampled(lines: Floats, samples: int) -> Floats:
    """(p, samples, 3) points at equal steps of arc length along polylines (p, k, 3).

    Lines of no length give their first point `samples` times.
    """
    steps = np.linalg.norm(np.diff(lines, axis=1), axis=2)
    along = np.concatenate([np.zeros((len(lines), 1)), np.cumsum(steps, axis=1)], axis=1)
    targets = along[:, -1:] * np.linspace(0.0, 1.0, samples)
    piece = (targets[:, :, None] > along[:, None, 1:-1]).sum(axis=2)
    row = np.arange(len(lines))[:, None]
    length = steps[row, piece]
    share = np.divide(
        targets - along[row, piece], length, out=np.zeros_like(targets), where=length > 0.0
    )
    return np.asarray(
        lines[row, piece] + share[..., None] * (lines[row, piece + 1] - lines[row, piece])
    )


def polylines(
    motion: Motion, base: Floats, points: Indices, sources: Indices, samples: int
) -> Floats:
    """(p, samples, 3) tracks of `sources` as drawn at `points`, without magnification."""
    return base[points][:, None] + resampled(paths(motion, sources), samples)
