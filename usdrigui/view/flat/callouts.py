"""Callouts: names beside a character, short ones in rows, with a line to each handle."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from itertools import takewhile

import numpy as np
from scipy.optimize import isotonic_regression, linear_sum_assignment

from usdrigui.character import Floats
from usdrigui.conventions import words
from usdrigui.conventions.sides import SIDES
from usdrigui.view.flat.lettering import cut, width_of
from usdrigui.view.flat.scene import Label

LARGEST, LEAST = 12, 7
"""Sizes of names."""
_MAX_WIDTH = 210.0
"""Of a column of names: a longer one would leave the character no room."""
_FAMILY = 3
"""Names that share a first word, at least, to leave it out; and they are most of all names, since
a word of a few says which they are."""
_BARE = {*SIDES, "rx", "ry", "rz", "bend", "curl", "spread", "twist"}
"""Words that alone, or with a number, do not tell what a control is for."""
_EDGE, _AIR = 6.0, 10.0
"""Between the edge of a panel and its names, and between them and where their lines turn."""


def shortened(names: Sequence[str]) -> list[str]:
    """The names without the words that those of one family, which have the first word in common,
    all begin and end with, as far as what is left of each tells what it is; a family is as it was
    where that would leave two alike."""
    short = list(names)
    first = [re.match(r"[^_.:| -]+[_.:| -]+", name) for name in names]
    families = Counter(word[0] for word in first if word)
    for word, count in families.items():
        members = [i for i, found in enumerate(first) if found and found[0] == word]
        texts = [names[i] for i in members]
        if count >= _FAMILY and 2 * count > len(names) and len(set(texts)) == count:
            starts = (at for at in _shared_words(texts) if all(_tells(text[at:]) for text in texts))
            start = max(starts, default=0)
            rest = [text[start:] for text in texts]
            end = _shared_words([text[::-1] for text in rest])[-1]
            for i, text in zip(members, rest, strict=True):
                short[i] = text[: len(text) - end]
    ambiguous = Counter(short)
    return [a if a and ambiguous[a] == 1 else b for a, b in zip(short, names, strict=True)]


def _tells(text: str) -> bool:
    return not all(word in _BARE or word.isdigit() for word in words(text))


def _shared_words(texts: Sequence[str]) -> list[int]:
    """Lengths of the whole words that the texts begin with: of none, of one and so on."""
    columns = takewhile(lambda letters: len(set(letters)) == 1, zip(*texts, strict=False))
    shared = "".join(letters[0] for letters in columns)
    return [0, *(found.end() for found in re.finditer(r"[_.:| -]+", shared))]


def column_width(names: Sequence[str]) -> int:
    """Pixels that the names take at the side of a panel; 0 without names."""
    widest = max((width_of(name, LARGEST) for name in names), default=0.0)
    return round(min(widest, _MAX_WIDTH) + _EDGE + 2.0 * _AIR) if names else 0


def called_out(
    handles: Floats, names: Sequence[str], size: tuple[int, int]
) -> tuple[tuple[Label, ...], tuple[Floats, ...]]:
    """The names of handles (n, 2) in columns at the left and right edge of a panel, each with a
    line to its handle; no line crosses another of its column."""
    labels: list[Label] = []
    leaders: list[Floats] = []
    for indices, left in zip(_columns(handles, names), (True, False), strict=True):
        if indices:
            column = _column(handles[indices], [names[i] for i in indices], size, left)
            labels += column[0]
            leaders += column[1]
    return tuple(labels), tuple(leaders)


def _columns(handles: Floats, names: Sequence[str]) -> tuple[list[int], list[int]]:
    """Indices of what is named on the left, and on the right, from above."""
    across, heights = np.round(handles.T, 3).tolist()
    centre = float(np.median(across)) if across else 0.0
    ordered = sorted(range(len(names)), key=lambda index: (across[index], names[index]))
    left = [index for index in ordered if across[index] < centre]
    right = ordered[len(left) :]
    # A crowded middle must not fill one column while the other stands empty.
    while len(right) > len(left) + 1:
        left.append(right.pop(0))

    def height(index: int) -> tuple[float, str]:
        return heights[index], names[index]

    return sorted(left, key=height), sorted(right, key=height)


def _column(
    handles: Floats, names: Sequence[str], size: tuple[int, int], left: bool
) -> tuple[list[Label], list[Floats]]:
    """The names at one edge; their lines leave it at one upright, level with the name, and run
    straight from there."""
    pitch = min((size[1] - 16.0) / len(names), 2.0 * LARGEST)
    text_size = int(np.clip(pitch - 2.0, LEAST, LARGEST))
    rows = spread(handles[:, 1], pitch, 8.0, size[1] - 8.0)
    texts = [cut(name, text_size, _MAX_WIDTH) for name in names]
    lengths = [width_of(text, text_size) for text in texts]
    inward, edge = (1.0, _EDGE) if left else (-1.0, size[0] - _EDGE)
    port = edge + inward * (max(lengths) + _AIR)
    labels, leaders = [], []
    for y, index in zip(rows, uncrossed(handles, port, rows), strict=True):
        anchor = "lm" if left else "rm"
        labels.append(Label(texts[index], (edge, float(y)), anchor, text_size))
        start = edge + inward * (lengths[index] + 4.0)
        leaders.append(np.array([[start, y], [port, y], handles[index]]))
    return labels, leaders


def uncrossed(handles: Floats, port: float, rows: Floats) -> list[int]:
    """Which of the `handles` (n, 2) is named in each of the `rows` (n,), so that straight lines to
    them from the upright at `port` do not cross.

    The lines are shortest in sum: two that crossed would be shorter with their rows exchanged
    (Bekos et al. 2007).
    """
    lengths = np.hypot(handles[None, :, 0] - port, handles[None, :, 1] - rows[:, None])
    return [int(index) for index in linear_sum_assignment(np.round(lengths, 3))[1]]


def spread(wanted: Floats, pitch: float, low: float, high: float) -> Floats:
    """Ascending rows at least `pitch` apart, within [low, high] if they fit, least squares from
    those wanted.

    ``wanted`` ascends.  Subtracting the pitch makes it isotonic regression.
    """
    steps = pitch * np.arange(len(wanted))
    level = isotonic_regression(np.clip(wanted, low, high) - steps).x
    return np.asarray(np.clip(level, low, max(low, high - steps[-1])) + steps)
