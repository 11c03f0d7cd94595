"""Words on pictures: names beside elements, call-outs with leader lines."""

from __future__ import annotations

import importlib.util
import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from scipy.optimize import linear_sum_assignment

from usdrigui.errors import visible
from usdrigui.model import Element, Floats
from usdrigui.view.headings import heading
from usdrigui.view.overlay import Mark, leaders

_INK, _QUIET = (52, 56, 63), (104, 110, 120)
_HALO: dict[str, Any] = {"stroke_width": 1, "stroke_fill": (238, 240, 242)}
_LARGEST, _LEAST = 12, 7
"""Sizes of names, pixels."""
CALLED = 210.0
"""Width of the longest name in a column of call-outs, pixels: longer ones would leave the face no
room."""
_CLEAR = 18.0
"""From the middle of a heading to the row below, where there is room: the air of half a line
between them."""

Named = Sequence[tuple[Element, Mark]]


_FALLBACKS = ("JP", "SC", "TC", "KR")
"""Faces of Kurinto Sans to which names turn, in this order: kanji alone look Japanese."""


def font(size: int, text: str = "") -> ImageFont.FreeTypeFont:
    """The typeface of pictures, which comes with Pillow; for a text with letters that it lacks the
    first of the package weblate-fonts, where that is installed, that has them all."""
    return _face(_number(visible(text)), size)


@cache
def _face(number: int, size: int) -> ImageFont.FreeTypeFont:
    """The typeface of Pillow, 0, or a fallback."""
    if number:
        return ImageFont.truetype(_fallbacks()[number - 1], size)
    face = ImageFont.load_default(size)
    if not isinstance(face, ImageFont.FreeTypeFont):
        raise TypeError("Pillow was built without FreeType")
    return face


@cache
def _fallbacks() -> tuple[str, ...]:
    """Files of the extra ``fonts``; none without it.  No font of the system is asked, for the same
    layout gives the same picture everywhere."""
    package = importlib.util.find_spec("weblate_fonts")
    if package is None or not package.submodule_search_locations:
        return ()
    folder = Path(package.submodule_search_locations[0], "static/weblate_fonts/kurinto/ttf")
    files = (folder / f"KurintoSans{each}-Rg.ttf" for each in _FALLBACKS)
    return tuple(str(file) for file in files if file.is_file())


@cache
def _number(text: str) -> int:
    """Which typeface draws a text: the first with all of its letters, else the usual one."""
    numbers = range(len(_fallbacks()) + 1)
    return next((each for each in numbers if all(_drawable(c, each) for c in text)), 0)


def legible(text: str) -> str:
    """The text as its typeface can show it: letters that it lacks lose their accents, kana and
    hangul are spelt as they sound, other letters by their code point; line ends are spelt out."""
    text = visible(text)
    return text if _number(text) else "".join(map(_shown, text))


def spelt_out(texts: Sequence[str]) -> tuple[str, ...]:
    """Those of the texts with wide letters (Han, kana, hangul) that no typeface here has."""
    if _fallbacks():
        return ()
    return tuple(text for text in texts if any(map(_is_wide, text)) and legible(text) != text)


def _is_wide(letter: str) -> bool:
    return unicodedata.east_asian_width(letter) in "WF" and letter.isalpha()


@cache
def _shown(letter: str) -> str:
    """A letter, or what the typeface has for it."""
    if _drawable(letter):
        return letter
    plain = unicodedata.normalize("NFKD", letter)[0]
    return plain if _drawable(plain) else _spelt(letter)


def _spelt(letter: str) -> str:
    """A letter that every typeface lacks as it sounds, where Unicode names it so."""
    called = unicodedata.name(unicodedata.normalize("NFKC", letter)[0], "")
    sound = re.fullmatch(
        r"(?:HIRAGANA LETTER|KATAKANA LETTER|HANGUL SYLLABLE) (?:SMALL )?([A-Z]+)", called
    )
    if sound is not None:
        return sound[1].lower()
    return "-" if "PROLONGED SOUND MARK" in called else f"[U+{ord(letter):04X}]"


@cache
def _drawable(letter: str, number: int = 0) -> bool:
    face = _face(number, _LARGEST)
    return bytes(face.getmask(letter)) != bytes(face.getmask("\uffff"))


def widest(names: Sequence[str]) -> float:
    """Width in pixels of the longest of the names at their largest size; 0 without names."""
    return max((font(_LARGEST, name).getlength(legible(name)) for name in names), default=0.0)


def name_on_board(picture: Image.Image, shown: Named) -> None:
    """Write the name of each element on the board to its right, and the heading of each family
    above it.

    Names are set as large as the rows allow and cut in the middle where the next element is too
    near.
    """
    if not shown:
        return
    pen = ImageDraw.Draw(picture)
    boxes = np.array([_box(drawn) for _, drawn in shown])
    rows = np.array([_row(drawn) for _, drawn in shown])
    pitch = _pitch(boxes, rows)
    size = int(np.clip(0.8 * pitch, _LEAST, _LARGEST))
    free = np.array(
        [_room(boxes, rows, index, pitch, picture.width) for index in range(len(shown))]
    )
    wide = [font(size, each.look.label).getlength(legible(each.look.label)) for each, _ in shown]
    tight = np.array(wide) > free
    small = {element.name for (element, _), cut in zip(shown, tight, strict=True) if cut}
    for (element, _), box, y, room in zip(shown, boxes, rows, free, strict=True):
        # Twins have one size, so that they look alike.
        small_one = small & {element.name, element.manipulator.mirror}
        own = font(min(9, size) if small_one else size, element.look.label)
        place = (float(box[2]) + 9.0, float(y))
        pen.text(
            place,
            cut(legible(element.look.label), own, float(room)),
            fill=_INK,
            font=own,
            anchor="lm",
            **_HALO,
        )
    for text, x, y in _headings(shown, boxes, rows, pitch):
        pen.text((x, y), text, fill=_QUIET, font=font(size), anchor="lm", **_HALO)


def call_out(picture: Image.Image, shown: Named) -> Image.Image:
    """The picture with every element named in a column at the nearer edge, with a line to its
    handle."""
    left, right = sides(
        [float(drawn.handle[0]) for _, drawn in shown], [element.name for element, _ in shown]
    )
    on_left, on_right = ([shown[index] for index in column] for column in (left, right))
    names = _column(picture.size, on_left, True) + _column(picture.size, on_right, False)
    picture = leaders(picture, [name.line for name in names])
    pen = ImageDraw.Draw(picture)
    for name in names:
        pen.text(name.place, name.text, fill=_INK, font=name.type_, anchor=name.side)
    return picture


def sides(across: Sequence[float], names: Sequence[str]) -> tuple[list[int], list[int]]:
    """Indices of what is named in the left column, and in the right one, by how far across it
    stands."""
    centre = float(np.median(across)) if across else 0.0
    ordered = sorted(range(len(across)), key=lambda index: (across[index], names[index]))
    left = [index for index in ordered if across[index] < centre]
    right = ordered[len(left) :]
    # A crowded middle must not fill one column while the other stands empty.
    while len(right) > len(left) + 1:
        left.append(right.pop(0))
    return left, right


@dataclass(frozen=True)
class _Name:
    """A name at the edge of the picture, and the line (3, 2) to its handle."""

    text: str
    place: tuple[float, float]
    side: str
    """Anchor of the text, as Pillow calls it."""
    type_: ImageFont.FreeTypeFont
    line: Floats


def _column(size: tuple[int, int], shown: Named, left: bool) -> list[_Name]:
    """The names in the column at one edge; their lines leave it at one upright, level with the
    name, and run straight from there."""
    if not shown:
        return []
    shown = sorted(shown, key=lambda each: (float(each[1].handle[1]), each[0].name))
    free = size[1] - 34.0
    pitch = min(free / len(shown), 2.2 * _LARGEST)
    size_ = int(np.clip(pitch - 2.0, _LEAST, _LARGEST))
    types = [font(size_, element.look.label) for element, _ in shown]
    handles = np.array([drawn.handle[:2] for _, drawn in shown])
    rows = spread(handles[:, 1], pitch, 8.0, size[1] - 26.0)
    texts = [
        cut(legible(element.look.label), type_, CALLED)
        for (element, _), type_ in zip(shown, types, strict=True)
    ]
    lengths = [type_.getlength(text) for type_, text in zip(types, texts, strict=True)]
    inward, edge = (1.0, 6.0) if left else (-1.0, size[0] - 6.0)
    port = edge + inward * (max(lengths) + 10.0)
    names = []
    for y, index in zip(rows, uncrossed(handles, port, rows), strict=True):
        start = edge + inward * (lengths[index] + 4.0)
        line = np.array([[start, y], [port, y], handles[index]])
        side = "lm" if left else "rm"
        names.append(_Name(texts[index], (edge, float(y)), side, types[index], line))
    return names


def uncrossed(handles: Floats, port: float, rows: Floats) -> list[int]:
    """Which of the `handles` (n, 2) is named in each of the `rows` (n,), so that straight lines to
    them from the upright at `port` do not cross.

    The lines are shortest in sum: two that crossed would be shorter with their rows exchanged
    (Bekos et al. 2007).
    """
    lengths = np.hypot(handles[None, :, 0] - port, handles[None, :, 1] - rows[:, None])
    return [int(each) for each in linear_sum_assignment(np.round(lengths, 3))[1]]


def spread(wanted: Floats, pitch: float, low: float, high: float) -> Floats:
    """Ascending rows at least `pitch` apart, within [low, high] if they fit, least squares from
    those wanted.

    ``wanted`` ascends.  Subtracting the pitch makes it isotonic regression, solved by pooling
    neighbours that are out of order (Ayer et al. 1955).
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


def _box(drawn: Mark) -> Floats:
    """(4,) left, top, right and bottom of a mark with its own handle, pixels."""
    points = np.concatenate([*drawn.tracks, drawn.handle[None], *drawn.outlines])[:, :2]
    return np.concatenate([points.min(axis=0), points.max(axis=0)])


def _row(drawn: Mark) -> float:
    """Height of the middle of a mark's tracks, whatever the shape of its handle."""
    heights = np.concatenate([*drawn.tracks, drawn.handle[None]])[:, 1]
    return 0.5 * float(heights.min() + heights.max())


def _room(boxes: Floats, rows: Floats, index: int, pitch: float, width: int) -> float:
    """Pixels to the right of a mark until the next one in its row, or the edge of the picture."""
    right = float(boxes[index, 2])
    beyond = boxes[(np.abs(rows - rows[index]) < 0.5 * pitch) & (boxes[:, 0] > right), 0]
    return min(float(beyond.min(initial=float(width))), float(width)) - right - 14.0


def _pitch(boxes: Floats, rows: Floats) -> float:
    """Least step between rows of one column, pixels."""
    order = np.lexsort((rows, np.round(boxes[:, 0] / 20.0)))
    steps = np.diff(rows[order])
    same = (np.diff(np.round(boxes[order, 0] / 20.0)) == 0) & (steps > 2.0)
    return float(steps[same].min()) if same.any() else 2.0 * _LARGEST


def _headings(
    shown: Named, boxes: Floats, rows: Floats, pitch: float
) -> list[tuple[str, float, float]]:
    """Text and place of the first element of each family in each column: midway to the row above
    it."""
    found: list[tuple[str, float, float]] = []
    for column in _columns(shown, boxes, rows, pitch):
        family, above = "", -np.inf
        for index in sorted(column, key=lambda each: float(rows[each])):
            own = shown[index][0].placement
            if own.category not in ("", family):
                family = own.category
                top = float(boxes[index, 1])
                line = max(0.5 * (top - above), 0.0) if np.isfinite(above) else np.inf
                place = (
                    float(boxes[column, 0].min()) - 4.0,
                    top - min(line, max(0.5 * pitch + 4.0, _CLEAR)),
                )
                found.append((heading(family, own.part), *place))
            above = float(boxes[index, 3])
    return found


def _columns(shown: Named, boxes: Floats, rows: Floats, pitch: float) -> list[list[int]]:
    """Indices by column, from left to right; the right one of two twins in a row belongs with the
    left one."""
    columns: list[list[int]] = []
    last = -np.inf
    for index in np.argsort(boxes[:, 0], kind="stable").tolist():
        row = np.flatnonzero(
            (np.abs(rows - rows[index]) < 0.4 * pitch) & (boxes[:, 0] < boxes[index, 0] - 1.0)
        )
        mirror = shown[index][0].manipulator.mirror
        if any(shown[other][0].name == mirror for other in row.tolist()):
            continue
        if boxes[index, 0] > last + 3.0 * pitch:
            columns.append([])
            last = float(boxes[index, 0])
        columns[-1].append(index)
    return columns


def cut(name: str, type_: ImageFont.FreeTypeFont, free: float) -> str:
    """The name, with its middle left out where it is wider than `free` pixels."""
    if type_.getlength(name) <= free:
        return name
    for kept in range(len(name) - 1, 3, -1):
        short = name[: (kept + 1) // 2] + "…" + name[len(name) - kept // 2 :]
        if type_.getlength(short) <= free:
            return short
    return name[:2] + "…" + name[-2:]
