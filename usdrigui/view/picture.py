"""Pictures of a layout for reports and review pages, made without a display.

`render` draws one character with its elements from several sides, `film` the same at many poses,
`contact_sheet` puts many pictures on one page.  The same input gives the same pixels.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike
from PIL import Image

from usdrigui.character import Floats, Rig, palette
from usdrigui.errors import counted
from usdrigui.model import Element, Layout, gap_of, proven
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.view import directions
from usdrigui.view.body.complexion import complexion
from usdrigui.view.body.shading import Subject, subject_of
from usdrigui.view.flat.callouts import called_out, column_width, shortened
from usdrigui.view.flat.framing import Frame, View, crowds, framed, names_height, row, trimmed
from usdrigui.view.flat.lettering import cut, width_of
from usdrigui.view.flat.marks import FORMS, form_of
from usdrigui.view.flat.pillow import painted
from usdrigui.view.flat.scene import QUIET, Label, Mark, Page, Panel, stacked
from usdrigui.view.panels import board_of, body, marks_of, on_character
from usdrigui.view.sections import Section, sections

_TITLE, _CAPTION, _LEGEND, _GAP, _EDGE = 66, 24, 42, 14, 22
"""Heights of the title above the panels, of captions and legend below, space between panels and
around, in pixels."""
_INSETS, _ENLARGED = 0.62, 3.0
"""Height of the row of insets, of that of the views, and how much larger they are at most."""
FILM = (760, 820)
"""Pixels of a picture of a film, across and down."""
_MIN_BOARD = 400
"""Width of a board beside insets, pixels."""
_SIDES = {
    "left": "character's left",
    "right": "character's right",
    "middle": "middle",
    "none": "no side",
}
"""What the colours of elements mean."""
_SHEET = 1800
"""Width of a page of many pictures, pixels."""
_BETWEEN = "   ·   "


@dataclass(frozen=True)
class Wanted:
    """What a picture is to be."""

    azimuth: float | None = None
    """Of the only view, in degrees about the up axis, from `LayoutFrame.view` toward the
    character's own left; None for the usual ones."""
    size: tuple[int, int] = (1800, 1000)
    """Width and height, pixels; it is higher where there are insets or a board."""
    labels: bool = False
    """Whether the elements on the character are named, too, in the layout's own view."""
    title: str = ""
    """By default the path of the character."""


_USUAL = Wanted()


def render(
    rig: Rig, layout: Layout, values: ArrayLike | None = None, wanted: Wanted = _USUAL
) -> Image.Image:
    """Picture of a character and its layout, RGB.

    A character in several parts has a close-up for each part, one below the other, unless there is
    to be one view alone.  ``values`` (controls,) is the pose, by
    default the layout's base pose.  By default there are the view that the layout was made for, and
    of front and three-quarter views the nearest two that show what it sees, with an inset where
    more elements meet than can be told apart.  The board has a panel of its own below, as high as
    it needs, with the names of its elements.  Raises RigUIError LAYOUT_STALE when the layout does
    not belong to the rig, POSE_VALUE for a pose that is not one.
    """
    return painted(scene(rig, layout, values, wanted))


def scene(rig: Rig, layout: Layout, values: ArrayLike | None, wanted: Wanted) -> Page:
    """The picture before it is drawn; arguments and errors as of `render`."""
    posed = evaluate(prepare(rig, layout), values)
    subject = subject_of(rig.body.meshes, posed.points, complexion(rig, layout))
    close_ups = sections(rig, layout, posed, wanted.azimuth)
    pages = []
    for number, section in enumerate(close_ups):
        # What has no handle on the character, as tongue and teeth may, needs no picture of it.
        drawn = number == 0 or on_character(section.layout)
        placed = _arranged(rig, section, subject.skin, wanted) if drawn else ()
        pages.append(_page(rig, section, subject, placed, wanted))
    return stacked(pages)


def film(rig: Rig, layout: Layout, poses: ArrayLike) -> Iterator[Image.Image]:
    """One picture from the front per row of ``poses`` (frames, controls), all framed as the base
    pose is; raises as `render`."""
    poser, colours = prepare(rig, layout), complexion(rig, layout)
    (section,), wanted = sections(rig, layout, evaluate(poser), 0.0), Wanted(0.0, FILM)
    subject = subject_of(rig.body.meshes, section.posed.points, colours)
    placed = _arranged(rig, section, subject.skin, wanted)
    for values in np.asarray(poses, dtype=np.float64):
        posed = evaluate(poser, values)
        subject = subject_of(rig.body.meshes, posed.points, colours)
        yield painted(_page(rig, replace(section, posed=posed), subject, placed, wanted))


def contact_sheet(
    images: Sequence[Image.Image], titles: Sequence[str] = (), columns: int = 2
) -> Image.Image:
    """All ``images``, one at least, on one page of `_SHEET` pixels, in rows of ``columns``, each
    over its title if there are any."""
    columns = min(columns, len(images))
    across, below = (_SHEET - _GAP * (columns + 1)) // columns, 26 if titles else 0
    cells = []
    for image, title in zip(images, titles or [""] * len(images), strict=True):
        high = max(1, round(image.height * (across / image.width)))
        body = image.resize((across, high), Image.Resampling.LANCZOS).convert("RGBA")
        label = Label(title, (2, high + 5), "la", 14)
        panel = Panel((_GAP, _GAP), (across, high + below), body, labels=(label,), grounded=False)
        cells.append(Page((across + _GAP, high + below + _GAP), (panel,)))
    starts = range(0, len(cells), columns)
    sheet = stacked([stacked(cells[start : start + columns], 0) for start in starts])
    return painted(replace(sheet, size=(_SHEET, sheet.size[1] + _GAP)))


# --- arrangement ----------------------------------------------------------------------------------


def _frames(rig: Rig, section: Section, skin: Floats) -> list[Frame]:
    """What the views of a section show: its elements and the character around them."""
    placed = tuple(on_character(section.layout))
    tracks = [track for i in placed for track in section.posed.elements[i].tracks]
    frames = []
    ahead = directions.ahead_of(section.layout, rig.up)
    for view in section.views:
        rows = directions.camera_rows(section.layout, rig.up, view)
        low, high = framed(tracks, skin, rows, section.layout.frame.handle_width)
        frames.append(Frame(rows, low, high, directions.caption(view, ahead, rig.up), placed))
    return frames


def _insets(section: Section, skin: Floats, view: Frame) -> list[Frame]:
    """Parts of a view in which more elements meet than can be told apart."""
    elements = section.posed.elements
    handles = np.array([elements[i].handle for i in view.shown]).reshape(-1, 3) @ view.rows[:2].T
    insets = []
    for crowd in crowds(handles, view.high - view.low):
        shown = tuple(view.shown[i] for i in crowd)
        tracks = [track for i in shown for track in elements[i].tracks]
        low, high = framed(tracks, skin, view.rows, section.layout.frame.handle_width)
        insets.append(Frame(view.rows, low, high, f"{view.caption}, enlarged", shown))
    return insets


def _named(frame: Frame, names: Mapping[int, str], insets: Sequence[Frame]) -> Frame:
    """The frame with the names of its elements that no inset names."""
    elsewhere = {i for inset in insets for i in inset.shown}
    shown = tuple((i, names[i]) for i in frame.shown if i not in elsewhere)
    return replace(frame, names=shown, column=column_width([name for _, name in shown]))


def _arranged(rig: Rig, section: Section, skin: Floats, wanted: Wanted) -> tuple[View, ...]:
    """The views of a section in a row, and insets into the first of them in a row below."""
    frames = _frames(rig, section, skin)
    insets = _insets(section, skin, frames[0]) if wanted.azimuth is None else []
    if wanted.labels:
        placed = frames[0].shown
        short = shortened([section.layout.elements[i].label for i in placed])
        names = dict(zip(placed, short, strict=True))
        frames[0] = _named(frames[0], names, insets)
        insets = [_named(inset, names, ()) for inset in insets]
    width, height = wanted.size[0] - 2 * _EDGE, wanted.size[1] - _TITLE - _CAPTION - _LEGEND
    first = row(frames, (_EDGE, _TITLE, width, height))
    if wanted.azimuth is None:
        first = trimmed(first)
    top, most = _TITLE + first[0].camera.height + _CAPTION, _ENLARGED * first[0].camera.scale
    return first + _inset_views(insets, (_EDGE, top, width, round(_INSETS * height)), most)


def _inset_views(
    insets: Sequence[Frame], box: tuple[int, int, int, int], most: float
) -> tuple[View, ...]:
    """The insets from a corner of the page on, each as large as it can be, in rows."""
    start, top, width, height = box
    views: list[View] = []
    left, below = start, top
    for inset in insets:
        tall = max(height, round(names_height(inset)))
        (view,) = trimmed(row([inset], (start, top, width, tall), most))
        wide = view.camera.width + 2 * inset.column
        if left + wide > start + width:
            left, top = start, below
        views.append(replace(view, corner=(left, top)))
        left, below = left + wide + _GAP, max(below, top + view.camera.height + _CAPTION)
    return tuple(views)


# --- one page -------------------------------------------------------------------------------------


def _page(
    rig: Rig, section: Section, subject: Subject, views: Sequence[View], wanted: Wanted
) -> Page:
    layout, width = section.layout, wanted.size[0]
    panels = [_panel(section, subject, view) for view in views]
    for view, panel in zip(views, tuple(panels), strict=True):
        panels.append(_caption(view.frame.caption, panel))
    top = max((panel.corner[1] + panel.size[1] for panel in panels), default=_TITLE)
    for board in board_of(section, rig.up, _board_box(views, top, width)):
        panels += [board, _caption("board", board)]
        top = max(top, board.corner[1] + board.size[1] + _CAPTION)
    name = wanted.title or rig.path.strip("/") or "character"
    heading = f"{name}: {section.title}" if section.title else name
    controls = len(layout.controls) if section.title else len(rig.controls)
    title = (
        Label(heading, (0.0, 24.0), size=25),
        Label(_numbers(controls, layout, width - 2.0 * _EDGE), (0.0, 52.0), size=14, ink=QUIET),
    )
    panels.append(Panel((_EDGE, 0), (width - 2 * _EDGE, _TITLE), labels=title, grounded=False))
    panels.append(_legend(layout.elements, (0, top), width))
    return Page((width, top + _LEGEND), tuple(panels))


def _board_box(views: Sequence[View], top: int, width: int) -> tuple[int, int, int]:
    """Left, top and width of the board: beside the insets where there is room, else below all."""
    insets = [view for view in views if view.corner[1] > _TITLE]
    if insets:
        last = insets[-1]
        left = last.corner[0] + last.camera.width + 2 * last.frame.column + _GAP
        if width - _EDGE - left >= _MIN_BOARD:
            return left, last.corner[1], width - _EDGE - left
    return _EDGE, top, width - 2 * _EDGE


def _panel(section: Section, subject: Subject, view: View) -> Panel:
    """A view with its elements and names."""
    frame, camera = view.frame, view.camera
    picture, depth = body(subject, camera)
    shift = np.array([frame.column, 0.0])
    marks = marks_of(section.layout, section.posed, frame.shown, camera, depth)
    marks = [mark.placed(1.0, shift) for mark in marks]
    size = (camera.width + 2 * frame.column, camera.height)
    names = dict(frame.names)
    called = [(mark, names[i]) for i, mark in zip(frame.shown, marks, strict=True) if i in names]
    handles = np.array([mark.handle for mark, _ in called]).reshape(-1, 2)
    labels, leaders = called_out(handles, [name for _, name in called], size)
    return Panel(view.corner, size, picture, tuple(marks), labels, leaders)


def _caption(text: str, panel: Panel) -> Panel:
    """A line below a panel."""
    (left, top), (width, height) = panel.corner, panel.size
    label = Label(cut(text, 13, float(width)), (0.5 * width, 0.5 * _CAPTION), "mm", 13, QUIET)
    return Panel((left, top + height), (width, _CAPTION), labels=(label,), grounded=False)


def _numbers(controls: int, layout: Layout, width: float) -> str:
    """What the layout of so many controls holds, in a line of so many pixels."""
    placed, proof = len(on_character(layout)), layout.proof
    board = len(layout.elements) - placed
    parts = [counted(controls, "control")]
    parts += [f"{counted(placed, 'element')} on the character"] if placed or not board else []
    parts += [f"{board} on the board"] if board else []
    parts += [f"{len(layout.left_off)} left off"] if layout.left_off else []
    if np.isfinite(proof.bound) and np.isfinite(proof.cost):
        parts.append(f"cost {proof.cost:.4g}, {proven(gap_of(proof.cost, proof.bound))}")
    while len(parts) > 1 and width_of(_BETWEEN.join(parts), 14) > width:
        parts.pop()
    return cut(_BETWEEN.join(parts), 14, width)


def _legend(elements: Sequence[Element], corner: tuple[int, int], width: int) -> Panel:
    """Colours by side and forms by kind, of what the layout holds."""
    marks, labels, x, y = [], [], _EDGE + 8.0, 0.5 * _LEGEND
    for form, colour, text, coarse in _legend_entries(elements):
        wide = 15.0 + width_of(text, 13)
        if x + wide > width - _EDGE:
            break  # a narrow page explains the colours first
        marks.append(Mark(form, colour, np.array([x, y]), 5.5 if coarse else 6.5, coarse))
        labels.append(Label(text, (x + 15.0, y), size=13, ink=QUIET))
        x += wide + 30.0
    note = "faint: hidden by the character"
    if x + width_of(note, 13) + _EDGE < width:
        labels.append(Label(note, (float(width - _EDGE), y), "rm", 13, QUIET))
    return Panel(corner, (width, _LEGEND), None, tuple(marks), tuple(labels), grounded=False)


def _legend_entries(elements: Sequence[Element]) -> list[tuple[str, palette.Colour, str, bool]]:
    """Form, colour, text and whether it has the ring of a coarse element."""
    grey, used = (128, 134, 142), {element.side for element in elements}
    entries = [
        ("slider", palette.SIDES[side], text, False)
        for side, text in _SIDES.items()
        if side in used
    ]
    forms = {form_of(element) for element in elements}
    if forms != {"slider"}:
        entries += [(form, grey, text, False) for form, text in FORMS.items() if form in forms]
    if any(element.inner for element in elements):
        entries.append(("slider", grey, "coarse: opens into finer ones", True))
    return entries
