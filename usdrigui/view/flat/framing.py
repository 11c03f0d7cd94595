"""What part of a character a picture shows: one rule for pictures, pickers and the page.

The box of the elements' tracks, the character around it as far as `SURROUNDINGS`, and a margin.
The page's cameras turn; they hold the `corners` of the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.view.body.shading import Camera

SURROUNDINGS = (0.25, 0.12)
"""How far the character is shown around its elements, to the sides and up and down, in the larger
extent of their box."""
MARGIN = 1.06
"""Extent of a frame by that of what it holds."""
_MIN_EXTENT = 22.0
"""Of a frame, in handle widths: two neighbours do not fill a picture."""
_CROWD = 12
"""Elements that can be told apart where they meet; more have an inset."""
_INSET = np.array([0.28, 0.13])
"""Half of the window of an inset, in extents of the frame."""
_MAX_INSETS = 2
_GAP = 14
_NAME = 15.0
"""Height of a row of names that is read with ease, pixels."""


class Frame(Record):
    """A rectangle of a view, and what it shows."""

    rows: Floats
    """(3, 3) of the camera."""
    low: Floats
    """(2,) lower left corner along the rows' right and up, scene units."""
    high: Floats
    caption: str = ""
    shown: tuple[int, ...] = ()
    """Indices of its elements."""
    names: tuple[tuple[int, str], ...] = ()
    """Of those of them that are named."""
    column: int = 0
    """Pixels kept free on either side for the names."""


class View(Record):
    """A frame on a page."""

    frame: Frame
    camera: Camera
    corner: tuple[int, int]
    """Of its panel, which is wider than the camera's picture by two columns of names."""


def framed(
    tracks: Sequence[Floats], skin: Floats, rows: Floats, handle_width: float
) -> tuple[Floats, Floats]:
    """Corners (2,), along the rows' right and up, of the frame of some tracks (k, 3) on a
    character with the points `skin` (n, 3); of all the character where there is no track."""
    low, high = _box(_held(tracks, skin, rows) @ rows[:2].T)
    middle, half = 0.5 * (low + high), 0.5 * MARGIN * (high - low)
    half = np.maximum(half, 0.5 * _MIN_EXTENT * handle_width)
    return middle - half, middle + half


def corners(tracks: Sequence[Floats], skin: Floats, rows: Floats) -> Floats:
    """(k, 3) the outermost points of what is framed, for cameras that turn."""
    held = _held(tracks, skin, rows)
    ways = np.stack(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 3), axis=-1).reshape(-1, 3)
    return np.asarray(held[np.unique((held @ ways.T).argmax(axis=0))])


def _held(tracks: Sequence[Floats], skin: Floats, rows: Floats) -> Floats:
    """(k, 3) points of tracks and of the skin around them; all the skin where there is no track."""
    if not tracks:
        return skin
    points, across = np.concatenate(tracks), skin @ rows[:2].T
    low, high = _box(points @ rows[:2].T)
    reach = np.array(SURROUNDINGS) * (high - low).max()
    near = ((across > low - reach) & (across < high + reach)).all(axis=1)
    return np.concatenate([points, skin[near]])


def crowds(handles: Floats, extent: Floats) -> list[Indices]:
    """Indices of the handles (n, 2) of each window, in a frame of an extent (2,), in which more
    meet than can be told apart; the fullest first."""
    left = np.arange(len(handles))
    found: list[Indices] = []
    while len(left) > _CROWD and len(found) < _MAX_INSETS:
        apart = np.abs(handles[left][:, None] - handles[left])
        window: Flags = np.asarray((apart < _INSET * extent).all(axis=2))
        fullest = handles[left[window[int(np.argmax(window.sum(axis=1)))]]].mean(axis=0)
        near: Flags = np.asarray((np.abs(handles[left] - fullest) < _INSET * extent).all(axis=1))
        if np.count_nonzero(near) <= _CROWD:
            break
        found.append(left[near])
        left = left[~near]
    return found


def row(
    frames: Sequence[Frame], box: tuple[int, int, int, int], most: float = np.inf
) -> tuple[View, ...]:
    """The frames beside each other in a box (left, top, width, height) of a page, all at one scale
    of at most `most` pixels per scene unit.

    Without such a limit they are views of one thing: what is left of the width shows more of it.
    """
    if not frames:
        return ()
    left, top, width, height = box
    lows = np.array([frame.low[1] for frame in frames])
    highs = np.array([frame.high[1] for frame in frames])
    free = width - _GAP * (len(frames) - 1) - sum(2 * frame.column for frame in frames)
    wide = sum(float(frame.high[0] - frame.low[0]) for frame in frames)
    tall = float((highs - lows).max())
    scale = max(min(height / tall, max(free, 0.3 * width) / wide, most), 1e-12)
    spare = max(free - scale * wide, 0.0) / len(frames) if np.isinf(most) else 0.0
    views = []
    for frame, level in zip(frames, 0.5 * (lows + highs), strict=True):
        middle = np.array([0.5 * (frame.low[0] + frame.high[0]), level])
        across = max(int(scale * float(frame.high[0] - frame.low[0]) + spare), 1)
        camera = Camera(frame.rows, middle @ frame.rows[:2], scale, across, height)
        views.append(View(frame, camera, (left, top)))
        left += across + 2 * frame.column + _GAP
    return tuple(views)


def trimmed(views: Sequence[View]) -> tuple[View, ...]:
    """Views of a row without what is empty above and below their frames and the rows of names."""
    extent = max(float(view.frame.high[1] - view.frame.low[1]) for view in views)
    tall = max(views[0].camera.scale * extent, *(names_height(view.frame) for view in views))
    height = min(views[0].camera.height, max(round(tall), 1))
    return tuple(replace(view, camera=replace(view.camera, height=height)) for view in views)


def names_height(frame: Frame) -> float:
    """Pixels that the names of a frame take in two columns."""
    return _NAME * (len(frame.names) + 1) / 2.0


def _box(points: Floats) -> tuple[Floats, Floats]:
    return points.min(axis=0), points.max(axis=0)
