"""The board of a picture: elements off the character in rows, which fill their box in columns."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

import numpy as np

from usdrigui.character import Floats
from usdrigui.layout.board.board import CATEGORIES
from usdrigui.model import Element
from usdrigui.view.flat.callouts import LARGEST, shortened
from usdrigui.view.flat.lettering import cut, width_of
from usdrigui.view.flat.scene import QUIET, Label, Mark, Panel

_HEADINGS = {
    "global": "whole character",
    "hidden": "hidden",
    "interior": "inside the mouth",
    "composite": "composite",
    "viseme": "visemes",
    "emotion": "emotions",
    "combination": "combinations",
    "identity": "identity",
    "requested": "by request",
    "crowded": "no room on the face",
}
RADIUS = 4.5
"""Of a handle on a board, pixels."""
_MIN_ROWS = 5
_ROW, _SYMBOL, _GAP, _EDGE = 22.0, 42.0, 24.0, 14.0
"""Height of a row, width of the symbol before a name, between columns, and around; pixels."""


def heading(category: str, part: str) -> str:
    """What stands over the elements of a category on the board of a part of the character; a word
    that another tool wrote as it is."""
    return _HEADINGS.get(category, category).replace("face", part or "face")


def rank(category: str) -> int:
    """Place of a category on the board from top to bottom; a word that another tool wrote comes
    last."""
    return CATEGORIES.index(category) if category in CATEGORIES else len(CATEGORIES)


def board(
    elements: Sequence[tuple[Element, Mark]], box: tuple[int, int, int], scale: float = 1.0
) -> Panel:
    """A panel at a left, top and width that holds elements with a heading over each category;
    `scale` enlarges all but the width."""
    left, top, width = box
    ordered = sorted(elements, key=lambda pair: rank(pair[0].category))
    short = shortened([element.label for element, _ in ordered])
    size, symbol, height = round(scale * LARGEST), scale * _SYMBOL, scale * _ROW
    lines: list[tuple[str, Mark | None]] = []
    families = groupby(
        zip(ordered, short, strict=True), key=lambda named: (named[0][0].category, named[0][0].part)
    )
    for family, named in families:
        lines += [(heading(*family), None), *((name, mark) for (_, mark), name in named)]
    wide = max(width_of(text, size) for text, _ in lines)
    pitch = min(symbol + wide + scale * _GAP, width - 2.0 * _EDGE)
    columns = max(1, int((width - 2.0 * _EDGE) / pitch))
    # A column may leave its last row free, for no heading stands there.
    rows = max(-(-len(lines) // columns) + (columns > 1), min(_MIN_ROWS, len(lines)))
    marks, labels, slot = [], [], 0
    for text, mark in lines:
        slot += mark is None and slot % rows == rows - 1
        x, y = _EDGE + pitch * (slot // rows), _EDGE + height * (slot % rows + 0.5)
        slot += 1
        if mark is None:
            labels.append(Label(text, (x, y), size=size, ink=QUIET))
        else:
            marks.append(_symbol(mark, np.array([x, y]), np.array([symbol, height])))
            free = pitch - symbol - 10.0
            labels.append(Label(cut(text, size, free), (x + symbol + 6.0, y), size=size))
    tall = round(2.0 * _EDGE + height * rows)
    return Panel((left, top), (width, tall), None, tuple(marks), tuple(labels))


def _symbol(mark: Mark, place: Floats, room: Floats) -> Mark:
    """The mark in the middle of a room (2,) that begins at a place, as large as fits."""
    points = np.concatenate([*mark.tracks, mark.handle[None]])
    low, high = points.min(axis=0), points.max(axis=0)
    free = room - [2.0 * mark.radius, 2.0]
    share = min(1.0, float((free / np.maximum(high - low, 1e-9)).min()))
    return mark.placed(share, place + room * [0.5, 0.0] - share * 0.5 * (low + high))
