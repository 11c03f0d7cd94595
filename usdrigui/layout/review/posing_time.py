"""A model of the seconds that a person takes for the faces of the study, by interface.

Nothing here is measured, and no constant is fitted: they are printed ones, each with the range that
its source gives.  Every control of a target face is found, pointed at, taken, dragged and let go,
once and without a slip, as in the keystroke-level model (Card, Moran and Newell 1980).  It takes
three thoughts, each with a look at the target, which stands beside the face in every interface:
which control, how far, and whether it is right.

* ``list``: names are read one after another, a look each, half of them on average; rows out of
  sight are paged to.  The eye goes from the face to the list and back.
* ``beside``: a handle is chosen among those on a copy of the face; the eye goes there and back.
* ``face``: the same, and the eye stays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Floats
from usdrigui.layout.face import Face
from usdrigui.layout.review.legibility import SCREEN_HEIGHT, first_level, on_screen
from usdrigui.model import Element

_CONTROLS = 30
"""To be set in the study's faces of one interface: 1, 2, 6, 8 and 13."""
_SECONDS = np.array(
    [
        # Thoughts, M, of .6, 1.2 and 1.35, three of them with a look each, and a button down and
        # up, BB, of .2: Kieras 2001, who puts one M to begin, one to think of a parameter, one to
        # verify.
        (2.21, 4.49, 6.35),
        (0.07, 0.23, 0.7),  # a look, with the eye's movement: Card, Moran and Newell 1983
        (0.0, 0.15, 0.157),  # a bit of choice, Hick's law: the same
        (0.12, 0.28, 1.2),  # a key, K: Kieras 2001
        (1 / 4.9, 1 / 4.3, 1 / 3.7),  # a bit of pointing, Fitts' law: Soukoreff and MacKenzie 2004
    ]
)
"""Of the fastest, the usual and the slowest person."""
_WAY = 0.7
"""Of a track that is gone along: the mean of the targets that the study draws."""
_ROW, _THUMB, _SLID = 23.0, 10.0, 54.6
"""Pixels of the list: height of a row; width of a slider's thumb, and its way, the same share of
78."""

PosingTimes = Mapping[str, Floats]
"""By interface (3,) seconds: of the fastest, the usual and the slowest person."""


def posing_times(
    face: Face, elements: Sequence[Element], handle_width: float, controls: int
) -> PosingTimes:
    """Of the elements of a part, at least one of which is on it, and the width of their handles;
    `controls` are in the list."""
    handles, _, lengths, pixels = on_screen(first_level(elements), face.views.screen)
    return predicted(handles, lengths, pixels * handle_width, controls)


def predicted(handles: Floats, tracks: Floats, width: float, rows: float) -> PosingTimes:
    """The same of handles (n, 2) of a `width`, of the lengths of their `tracks` (controls,), all in
    pixels, and of a list with a number of `rows`."""
    pages, places = np.divmod(np.arange(rows), SCREEN_HEIGHT // _ROW)
    sliding = _bits(_ROW * places[:, None], _THUMB) + np.log2(_SLID / _THUMB + 1.0)
    taking = _bits(handles, width) + np.log2(_WAY * tracks / width + 1.0).mean()
    always, look, choice, key, aim = _CONTROLS * _SECONDS
    face = always + np.log2(len(handles) + 1.0) * choice + taking * aim
    read = always + (0.5 * rows + 2.5) * look + pages.mean() * key + sliding * aim
    return {"list": read, "beside": face + 2.0 * look, "face": face}


def _bits(places: Floats, width: float) -> float:
    """Mean index of difficulty, log2(D/W + 1), from one of the places (n, d) to another one."""
    apart = cdist(places, places)
    return float(np.log2(apart / width + 1.0).sum() / max(apart.size - len(apart), 1))
