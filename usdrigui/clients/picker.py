"""A layout as a flat picker beside the viewport: SVG for any tool, and the JSON of dwpicker.

Each part of a character is seen from the direction that it was laid out for, at the base pose,
over a pale picture of it.  Elements keep their places but where handles would lie on each other;
the board is below.  Parts and characters are in rows.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from importlib.resources import files
from typing import Any

import numpy as np

from usdrigui.character import Floats, Rig
from usdrigui.model import Element, Layout
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.view.body.complexion import complexion
from usdrigui.view.body.shading import Camera, Subject, subject_of
from usdrigui.view.directions import camera_rows
from usdrigui.view.flat.callouts import called_out, column_width, shortened
from usdrigui.view.flat.framing import framed
from usdrigui.view.flat.pillow import painted, png
from usdrigui.view.flat.scene import Label, Mark, Page, Panel, stacked
from usdrigui.view.panels import board_of, body, marks_of, on_character
from usdrigui.view.sections import Section, sections

_RADIUS = 11.0
"""Of a handle, in picture units."""
_LEAST = 22.0
"""Way from a handle to the end of its longest track, at least, in picture units."""
_APART = 1.1
"""Least distance of handles, in their diameters."""
_MAX_EXTENT = 900.0
"""Longer side of what is shown of a part; a larger one is shown smaller."""
_VEIL = 0.5
"""Opacity of the character, so that handles stand out from it."""
_BOARD, _BOARD_WIDTH = 1.4, 640
"""How much larger the board is than in a picture, and how wide where it is alone."""
_TITLE, _MARGIN = 30, 16
_MAX_ROW = 2.6
"""Widths of a row of parts, in heights of the tallest, before another one begins."""
_BUTTON, _BUTTON_LETTER, _BUTTON_SCALE = 18.0, 6.2, 1.8
"""Of a dwpicker file: height of a button, width of a letter on it, and how much larger the whole is
for their sake."""
_DWPICKER = [0, 12, 0]
"""Version of the dwpicker file format that is written; later ones read it and bring it up to
date."""


def picker(characters: Sequence[tuple[Rig, Layout]], *, labels: bool = False) -> Page:
    """Flatten the layouts; ``labels`` names the elements on the face as well.

    Raises RigUIError LAYOUT_STALE where a layout does not belong to its rig.
    """
    pages = [page for rig, layout in characters for page in _pages(rig, layout, labels)]
    wide = _MAX_ROW * max((page.size[1] for page in pages), default=0)
    rows: list[list[Page]] = []
    for page in pages:
        if not rows or sum(before.size[0] for before in rows[-1]) + page.size[0] > wide:
            rows.append([])
        rows[-1].append(page)
    return stacked([stacked(row, 0) for row in rows])


def to_dwpicker(page: Page, name: str, background: str = "") -> str:
    """A dwpicker file: one named button per element, which selects what is called like the
    element's controls.

    ``background`` is the path of the picture that `background_png` gives, as dwpicker is to find
    it.
    """
    width, height = (float(round(_BUTTON_SCALE * length, 2)) for length in page.size)
    behind = {
        "image.path": background,
        "image.fit": True,
        "image.width": width,
        "image.height": height,
    }
    shapes = [_shape("square", (0.0, 0.0, width, height), "#3c4046", background=True) | behind]
    placed = list(_elements(page))
    for (element, mark, _), box in zip(placed, _buttons(placed), strict=True):
        form = "rounded_rect" if element.kind == "slider" else "square"
        text = {
            "action.targets": [member.control for member in element.members],
            "text.content": element.label,
            "text.color": _ink(mark),
        }
        place = np.round(box, 2).tolist()
        shapes.append(_shape(form, place, "#{:02x}{:02x}{:02x}".format(*mark.colour)) | text)
    general = {
        "name": name,
        "version": _DWPICKER,
        "zoom_locked": False,
        "width": width,
        "height": height,
    }
    return json.dumps({"general": general, "shapes": shapes}, indent=2, ensure_ascii=False) + "\n"


def background_png(page: Page) -> bytes:
    """The characters alone as one picture of the picker's size."""
    bare = (replace(panel, marks=(), labels=(), leaders=()) for panel in page.panels)
    return png(painted(replace(page, panels=tuple(bare))))


# --- parts ----------------------------------------------------------------------------------------


def _pages(rig: Rig, layout: Layout, labels: bool) -> Iterator[Page]:
    """One page a part of a character."""
    posed = evaluate(prepare(rig, layout))
    subject = subject_of(rig.body.meshes, posed.points, complexion(rig, layout))
    for section in sections(rig, layout, posed):
        panels = []
        top, width = _TITLE if section.title else _MARGIN, _BOARD_WIDTH
        if on_character(section.layout):
            panel = _panel(section, subject, camera_rows(section.layout, rig.up), labels)
            panels.append(replace(panel, corner=(_MARGIN, top)))
            top, width = top + panel.size[1] + _MARGIN, panel.size[0]
        for board in board_of(section, rig.up, (_MARGIN, top, width), _BOARD):
            panels.append(board)
            top += board.size[1] + _MARGIN
        if section.title:
            title = (Label(section.title, (0.0, 0.5 * _TITLE), size=16),)
            panels.append(Panel((_MARGIN, 0), (width, _TITLE), labels=title, grounded=False))
        yield Page((width + 2 * _MARGIN, top), tuple(panels))


def _panel(section: Section, subject: Subject, rows: Floats, labels: bool) -> Panel:
    """What is seen of a part, with its handles kept apart."""
    layout, posed, placed = section.layout, section.posed, on_character(section.layout)
    skin = subject.skin
    tracks = [track for i in placed for track in posed.elements[i].tracks]
    low, high = framed(tracks, skin, rows, layout.frame.handle_width)
    scale = min(2.0 * _RADIUS / layout.frame.handle_width, _MAX_EXTENT / float((high - low).max()))
    width, height = (max(round(scale * float(length)), 1) for length in high - low)
    camera = Camera(rows, 0.5 * (low + high) @ rows[:2], scale, width, height)
    names = shortened([layout.elements[i].label for i in placed]) if labels else []
    column = column_width(names)
    size = (width + 2 * column, height)
    marks = _apart(marks_of(layout, posed, placed, camera), np.array([column, 0.0]))
    handles = np.array([mark.handle for mark in marks[: len(names)]]).reshape(-1, 2)
    called = called_out(handles, names, size)
    picture = body(subject, camera)[0]
    picture.putalpha(picture.getchannel("A").point([round(_VEIL * a) for a in range(256)]))
    return Panel((0, 0), size, picture, tuple(marks), *called)


def _apart(marks: Sequence[Mark], shift: Floats) -> list[Mark]:
    """The marks with handles of one size, none on another; tracks go with their handles, and none
    is so short that its handle hides it, but for those that point straight at the viewer."""
    handles = np.array([mark.handle for mark in marks])
    moves = spread(handles, np.full(handles.shape, 2.0 * _APART * _RADIUS)) - handles + shift
    return [
        replace(mark, radius=_RADIUS).placed(scale, move + (1.0 - scale) * mark.handle)
        for mark, move, scale in zip(marks, moves, map(_enlarged, marks), strict=True)
    ]


def _enlarged(mark: Mark) -> float:
    """How much longer the tracks of a mark are drawn than they are seen."""
    ways = np.linalg.norm(np.concatenate(mark.tracks) - mark.handle, axis=1)
    return max(1.0, _LEAST / float(ways.max(initial=1.0)))


# --- rectangles that do not overlap ---------------------------------------------------------------


def spread(centres: Floats, sizes: Floats) -> Floats:
    """(n, 2) centres of rectangles of ``sizes`` (n, 2), none of which overlaps another.

    One after another from the middle out, each stays or moves, left, right, up or down, no further
    than to where it just touches one of those before it.
    """
    at = centres.astype(np.float64)
    # To a thousandth, as places are in single precision: a last bit must not say what goes first,
    # or which way it goes.
    away = np.round(np.linalg.norm(at - np.median(at, axis=0), axis=1), 3)
    order = np.lexsort((*np.round(at.T, 3), away))
    for k, index in enumerate(order):
        apart = at[order[:k]] - at[index]
        least = 0.5 * (sizes[order[:k]] + sizes[index])
        beside = np.concatenate([apart - least, apart + least])
        moves = np.concatenate([np.zeros((1, 2)), *(beside * axis for axis in np.eye(2))])
        over = (np.abs(apart - moves[:, None]) < least - 1e-6).all(axis=2).any(axis=1)
        length = np.where(over, np.inf, np.abs(moves).sum(axis=1))
        at[index] += moves[np.argmin(np.round(length, 3))]
    return at


# --- dwpicker -------------------------------------------------------------------------------------


Placed = tuple[Element, Mark, Floats]
"""An element with its mark, and where its handle is on the page."""


def _elements(page: Page) -> Iterator[Placed]:
    for panel in page.panels:
        for mark in panel.marks:
            if mark.element is not None:
                yield mark.element, mark, mark.handle + panel.corner


def _buttons(placed: Sequence[Placed]) -> Floats:
    """(n, 4) left, top, width and height of a named button per element, none of which overlaps
    another."""
    if not placed:
        return np.zeros((0, 4))
    letters = [len(element.label) for element, _, _ in placed]
    sizes = np.array([[max(_BUTTON, _BUTTON_LETTER * n + 10.0), _BUTTON] for n in letters])
    handles = np.array([handle for _, _, handle in placed])
    centres = spread(_BUTTON_SCALE * handles, sizes + 2.0)
    return np.concatenate([centres - 0.5 * sizes, sizes], axis=1)


def _ink(mark: Mark) -> str:
    """What is read on the colour of an element."""
    red, green, blue = mark.colour
    return "#16181b" if 0.299 * red + 0.587 * green + 0.114 * blue > 130.0 else "#ffffff"


def _shape(
    form: str, place: Sequence[float], colour: str, *, background: bool = False
) -> dict[str, Any]:
    """One shape with every key that the format asks for (dwpicker_shape.json)."""
    left, top, width, height = place
    usual: dict[str, Any] = json.loads((files(__package__) / "dwpicker_shape.json").read_bytes())
    return usual | {
        "background": background,
        "shape": form,
        "shape.left": left,
        "shape.top": top,
        "shape.width": width,
        "shape.height": height,
        "border": not background,
        **dict.fromkeys(("bgcolor.normal", "bgcolor.hovered", "bgcolor.clicked"), colour),
    }
