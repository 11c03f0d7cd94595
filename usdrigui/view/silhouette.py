"""The outline of a character against its background, as polygons, for flat pictures.

The visible triangles are painted into a mask, whose borders are followed and simplified.  The same
input gives the same polygons.
"""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import label

from usdrigui.model import Flags, Floats, Indices

_FINENESS = 480
"""Pixels along the longer side of the mask."""
_SPECK = 0.0015
"""Pieces and holes smaller than this share of the mask are left out."""
_TOLERANCE = 0.45
"""How far a polygon may leave the followed border, pixels."""


def silhouette(flat: Floats, corners: Indices, low: Floats, high: Floats) -> tuple[Floats, ...]:
    """Closed polygons (k, 2) around what triangles ``corners`` (t, 3) of points ``flat`` (n, 2)
    cover of a rectangle.

    Holes are polygons too: fill by the even-odd rule.  Positions are in the units of ``flat``; none
    come back where nothing is covered.
    """
    size = np.asarray(high, dtype=np.float64) - low
    pixel = float(size.max()) / _FINENESS
    if not pixel > 0.0 or not len(corners):
        return ()
    mask = _without_specks(
        _painted((flat - low) / pixel, corners, np.ceil(size / pixel).astype(int))
    )
    loops = (_simplified(_softened(loop)) for loop in _borders(mask))
    return tuple(low + pixel * loop for loop in loops if len(loop) > 2)


def _painted(at: Floats, corners: Indices, size: Indices) -> Flags:
    """(height, width) pixels that triangles of points `at` (n, 2) cover."""
    mask = Image.new("1", (int(size[0]), int(size[1])))
    pen = ImageDraw.Draw(mask)
    corners = corners[np.isfinite(at[corners]).all(axis=(1, 2))]
    placed = at[corners]
    within = (placed.max(axis=1) >= 0.0).all(axis=1) & (placed.min(axis=1) <= size).all(axis=1)
    for triangle in np.unique(np.round(placed[within], 1).reshape(-1, 6), axis=0).tolist():
        pen.polygon(triangle, fill=1)
    return np.array(mask, dtype=bool)


def _without_specks(mask: Flags) -> Flags:
    """The mask without small pieces and small holes."""
    for wanted in (True, False):
        pieces, count = label(mask == wanted)
        areas = np.bincount(pieces.ravel(), minlength=count + 1)
        small = areas < _SPECK * mask.size
        small[0] = False
        mask = np.where(small[pieces], not wanted, mask)
    return np.asarray(mask)


def _borders(mask: Flags) -> list[Floats]:
    """Closed loops (k, 2) of pixel corners around the set pixels, which lie on the right of each
    step."""
    inside = np.pad(mask, 1)
    nexts: dict[tuple[int, int], list[tuple[int, int]]] = {}
    # Per side of a pixel: where its neighbour is, and from which to which corner the border goes
    # there.
    sides = (
        ((-1, 0), (0, 0), (1, 0)),
        ((0, 1), (1, 0), (1, 1)),
        ((1, 0), (1, 1), (0, 1)),
        ((0, -1), (0, 1), (0, 0)),
    )
    for (down, right), start, end in sides:
        rows, columns = np.nonzero(inside & ~np.roll(inside, (-down, -right), axis=(0, 1)))
        for row, column in zip((rows - 1).tolist(), (columns - 1).tolist(), strict=True):
            nexts.setdefault((column + start[0], row + start[1]), []).append(
                (column + end[0], row + end[1])
            )
    loops = []
    for start in sorted(nexts):
        while nexts[start]:
            loop, at = [start], nexts[start].pop()
            while at != start:
                loop.append(at)
                at = nexts[at].pop()
            loops.append(np.array(loop, dtype=np.float64))
    return loops


def _softened(loop: Floats) -> Floats:
    """A closed loop without the steps of the pixels."""
    for _ in range(3):
        loop = 0.25 * np.roll(loop, 1, axis=0) + 0.5 * loop + 0.25 * np.roll(loop, -1, axis=0)
    return loop


def _simplified(loop: Floats) -> Floats:
    """A closed loop with the vertices that matter (Douglas and Peucker 1973), from two far ends."""
    far = int(np.argmax(np.linalg.norm(loop - loop[0], axis=1)))
    closed = np.concatenate([loop, loop[:1]])
    kept, spans = {0, far}, [(0, far), (far, len(loop))]
    while spans:
        start, end = spans.pop()
        if end - start < 2:
            continue
        away = _distances(closed[start + 1 : end], closed[start], closed[end])
        worst = int(np.argmax(away))
        if away[worst] > _TOLERANCE:
            middle = start + 1 + worst
            kept.add(middle)
            spans += [(start, middle), (middle, end)]
    return loop[sorted(kept)]


def _distances(points: Floats, start: Floats, end: Floats) -> Floats:
    """(k,) distances of points (k, 2) from a segment."""
    along = end - start
    share = np.clip((points - start) @ along / max(float(along @ along), 1e-30), 0.0, 1.0)
    return np.asarray(np.linalg.norm(points - start - share[:, None] * along, axis=1))
