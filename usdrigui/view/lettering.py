"""Words on pictures: names beside elements, call-outs with leader lines."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from usdrigui.model import Element, Floats
from usdrigui.view.overlay import Mark

_INK, _RULE = (52, 56, 63), (150, 155, 163)
_LARGEST, _LEAST = 12, 7
"""Sizes of names, pixels."""

Named = Sequence[tuple[Element, Mark]]


@cache
def font(size: int) -> ImageFont.FreeTypeFont:
    """The one typeface of all pictures; it comes with Pillow."""
    face = ImageFont.load_default(size)
    if not isinstance(face, ImageFont.FreeTypeFont):
        raise TypeError("Pillow was built without FreeType")
    return face


def widest(names: Sequence[str]) -> float:
    """Width in pixels of the longest of the names at their largest size; 0 without names."""
    return max((font(_LARGEST).getlength(name) for name in names), default=0.0)


def name_beside(picture: Image.Image, shown: Named) -> None:
    """Write the name of each element beside the face to its right, as large as its neighbours allow."""
    if not shown:
        return
    pen = ImageDraw.Draw(picture)
    rights = np.array(
        [max(float(track[:, 0].max()) for track in (*drawn.tracks, drawn.handle[None])) for _, drawn in shown]
    )
    middles = np.array([float(drawn.handle[1]) for _, drawn in shown])
    type_ = font(_fitting(middles, rights))
    for (element, _), x, y in zip(shown, rights, middles, strict=True):
        pen.text((x + 9, y), element.label, fill=_INK, font=type_, anchor="lm")


def call_out(picture: Image.Image, shown: Named) -> None:
    """Name every element in a column at the nearer edge of the picture, with a line to its handle."""
    pen = ImageDraw.Draw(picture)
    centre = float(np.median([drawn.handle[0] for _, drawn in shown])) if shown else 0.0
    ordered = sorted(shown, key=lambda each: (float(each[1].handle[0]), each[0].name))
    on_left = [each for each in ordered if float(each[1].handle[0]) < centre]
    on_right = ordered[len(on_left) :]
    # A crowded middle must not fill one column while the other stands empty.
    while len(on_right) > len(on_left) + 1:
        on_left.append(on_right.pop(0))
    for column, left in ((on_left, True), (on_right, False)):
        _column(pen, picture.size, column, left)


def _column(pen: ImageDraw.ImageDraw, size: tuple[int, int], shown: Named, left: bool) -> None:
    if not shown:
        return
    shown = sorted(shown, key=lambda each: (float(each[1].handle[1]), each[0].name))
    free = size[1] - 34.0
    pitch = min(free / len(shown), _LARGEST + 6.0)
    type_ = font(int(np.clip(pitch - 2.0, _LEAST, _LARGEST)))
    rows = _spread(np.array([float(drawn.handle[1]) for _, drawn in shown]), pitch, 8.0, size[1] - 26.0)
    edge = 6.0 if left else size[0] - 6.0
    for (element, drawn), y in zip(shown, rows, strict=True):
        wide = type_.getlength(element.label)
        start = edge + wide + 4 if left else edge - wide - 4
        bend = start + (12 if left else -12)
        handle = (float(drawn.handle[0]), float(drawn.handle[1]))
        pen.line([(start, y), (bend, y), handle], fill=_RULE, width=1)
        pen.text((edge, y), element.label, fill=_INK, font=type_, anchor="lm" if left else "rm")


def _spread(wanted: Floats, pitch: float, low: float, high: float) -> Floats:
    """Ascending rows at least `pitch` apart, within [low, high] if they fit, least squares from those wanted.

    ``wanted`` ascends.  Subtracting the pitch makes it isotonic regression, solved by pooling neighbours
    that are out of order (Ayer et al. 1955).
    """
    steps = pitch * np.arange(len(wanted))
    pools: list[list[float]] = []
    for value in np.clip(wanted, low, high) - steps:
        pools.append([float(value), 1.0])
        while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
            value_, count = pools.pop()
            mean, before = pools[-1]
            pools[-1] = [(mean * before + value_ * count) / (before + count), before + count]
    level = np.repeat([mean for mean, _ in pools], [int(count) for _, count in pools])
    return np.asarray(np.clip(level, low, max(low, high - steps[-1])) + steps)


def _fitting(middles: Floats, rights: Floats) -> int:
    """Type size at which names in one column do not touch: from the least step between rows."""
    order = np.lexsort((middles, np.round(rights / 40.0)))
    steps = np.diff(middles[order])
    same = (np.diff(np.round(rights[order] / 40.0)) == 0) & (steps > 1.0)
    least = float(steps[same].min()) if same.any() else float(_LARGEST)
    return int(np.clip(least - 1.0, _LEAST, _LARGEST))
