"""The board: a tidy grid beside the face for elements off the face (paper section 3.3,
global deformations).

It lies in the plane of the layout's own view, to the right of the silhouette at its own height,
in columns no taller than the face; rows are grouped by category.  It is attached to the most
head-like joint, so that it follows the head and nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import groupby
from typing import Literal

import numpy as np

from usdrigui.character import Control, Floats, Indices, Record
from usdrigui.layout.board.board_place import carrier_of, carriers, silhouette
from usdrigui.layout.face import Face
from usdrigui.layout.glyph_fitting import fitted_glyph
from usdrigui.layout.names import common_label
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.symmetry.lobes import ASIDE, side_at
from usdrigui.model import Element, Group, Member, Side

CATEGORIES = (
    "global", "hidden", "interior", "composite", "viseme",
    "emotion", "combination", "identity", "requested", "crowded",
)  # fmt: skip
"""Headings, from top to bottom."""

Adapt = Literal["deform", "static"]
"""How an element follows the face."""

_TRACK = 4.0
"""Length of a slider, in handle widths."""
_ROW = 2.4
"""Height of a row; at least what keeps two handles apart."""
_LETTER = 0.72
"""Width of a letter of a label."""
_MARGIN = 3.0
"""Least distance from the silhouette."""
_TALL = 1.1
"""Greatest height of a column, in face sizes."""


@dataclass(frozen=True)
class BoardEntry:
    """One element of the board."""

    group: Group
    name: str
    controls: tuple[int, ...]
    category: str
    reason: str


def board_elements(
    face: Face, board: list[BoardEntry], requests: Requests, adapt: Adapt
) -> list[Element]:
    """Elements of the board, in the reading order of its rows."""
    if not board:
        return []
    rows = _rows(face, board)
    width, height = face.handle_width, _TALL * face.surface.face_size
    middle = face.symmetry.plane.projected(face.trajectories.middle)
    frame = face.views.screen
    columns = _columns(rows, max(1, int(height / (_ROW * width))))
    left = silhouette(face, middle, frame, 0.5 * height) + _MARGIN * width
    others = _boards(requests, middle @ frame[1], 0.5 * height, frame[1])
    left = max([left, *(_right_end(each, frame, width) for each in others)])
    drawing = _Drawing(face, requests, frame, carriers(face, middle), adapt)
    elements = []
    for column in columns:
        cells = _cell_widths(face.rig.controls, [row for _, row in column])
        for line, row in column:
            down = 0.5 * height - (line + 0.5) * _ROW * width
            for cell, entry in enumerate(row):
                across = (
                    left + (sum(cells[:cell]) + _TRACK * _start(face.rig.controls, entry)) * width
                )
                place = middle + frame[0] * (across - middle @ frame[0]) + frame[1] * down
                elements.append(_element(drawing, entry, row, place))
        left += sum(cells) * width
    return elements


def _boards(requests: Requests, middle: float, half: float, up: Floats) -> list[Element]:
    """The elements of a board that exists already, and of the boards of other parts as high as this
    one."""
    near = [
        each
        for each in requests.neighbours
        if abs(float(each.anchor.position @ up) - middle) <= half
    ]
    return [element for element in (*requests.existing_elements, *near) if element.anchor.on_board]


def _right_end(element: Element, frame: Floats, width: float) -> float:
    """Where an existing element, its label included, ends across the screen, and a column may
    begin."""
    across = max(float((member.track @ frame[0]).max()) for member in element.members)
    return across + (2.0 + _LETTER * len(element.label)) * width


def _cell_widths(controls: tuple[Control, ...], rows: list[tuple[BoardEntry, ...]]) -> list[float]:
    """Widths of the cells of a column, in handle widths: sliders with the longest label below each
    other.

    A lone element's label may run on over the cells to its right.
    """
    lone = max((_width(controls, *row) for row in rows if len(row) == 1), default=0.0)
    pairs = [row for row in rows if len(row) > 1]
    widths = [
        max(_width(controls, each) for each in cell) for cell in zip(*pairs, strict=False)
    ] or [lone]
    widths[-1] += max(0.0, lone - sum(widths))
    return widths


def _width(controls: tuple[Control, ...], entry: BoardEntry) -> float:
    return _TRACK + 2.0 + _LETTER * len(_label(controls, entry))


def _label(controls: tuple[Control, ...], entry: BoardEntry) -> str:
    return common_label([controls[control].label for control in entry.controls])


def _rows(face: Face, board: list[BoardEntry]) -> list[tuple[BoardEntry, ...]]:
    """Rows of one element or of a pair, the left one first, sorted by category and then by name."""
    ranked = sorted(
        board,
        key=lambda each: (
            CATEGORIES.index(each.category),
            each.group.name.lower(),
            each.group.name,
            # In many languages the word for left comes after that for right.
            -round(_aside(face, each), 1),
            face.rig.controls[each.controls[0]].name,
        ),
    )
    rows = groupby(ranked, key=lambda each: (each.category, each.group.name))
    return [tuple(members) for _, members in rows]


def _columns(
    rows: list[tuple[BoardEntry, ...]], most: int
) -> list[list[tuple[int, tuple[BoardEntry, ...]]]]:
    """Rows with their line numbers, column by column; a heading takes a line above each
    category."""
    columns: list[list[tuple[int, tuple[BoardEntry, ...]]]] = [[]]
    line, category = 0, ""
    for row in rows:
        # A joystick needs room above and below.
        tall = 3 if any(each.group.kind != "slider" for each in row) else 1
        heading = 1 if row[0].category != category else 0
        if line and line + heading + tall > most:
            columns.append([])
            line, heading = 0, 1
        columns[-1].append((line + heading, row))
        line += heading + tall
        category = row[0].category
    return columns


class _Drawing(Record):
    """What all elements of a board are drawn with."""

    face: Face
    requests: Requests
    frame: Floats
    """(2, 3) right and up."""
    carriers: Indices
    """(n,) the points whose joint influences the board may take, the best one first."""
    adapt: Adapt


def _element(
    drawing: _Drawing, entry: BoardEntry, row: tuple[BoardEntry, ...], place: Floats
) -> Element:
    face, requests, group = drawing.face, drawing.requests, entry.group
    if group.kind != "slider":
        place = place - drawing.frame[1] * _ROW * face.handle_width
    other = row[1 - row.index(entry)].name if len(row) == 2 else ""
    toward, side = face.views.directions[0], _side(face, entry, row)
    carrier = carrier_of(face.rig, entry.controls, drawing.carriers)
    anchor = replace(face.anchor(carrier), position=place, normal=toward, on_board=True)
    length = _TRACK * face.handle_width * (1.0 if len(entry.controls) == 1 else 0.5)
    members = tuple(
        _member(face, control, place, length, direction)
        for control, direction in zip(
            entry.controls, _directions(group, drawing.frame), strict=True
        )
    )
    overrides = [requests.overrides[control] for control in entry.controls]
    flipped = face.symmetry.reversed
    return Element(
        name=entry.name,
        kind=group.kind,
        members=members,
        opposed=group.opposed,
        mirror=other,
        reversed=tuple(m for m, each in enumerate(entry.controls) if other and flipped[each]),
        anchor=anchor,
        label=_label(face.rig.controls, entry),
        side=side,
        adapt=drawing.adapt,
        glyph=fitted_glyph(face, overrides, anchor, members, side == "right"),
        category=entry.category,
        reason=entry.reason,
    )


def _start(controls: tuple[Control, ...], entry: BoardEntry) -> float:
    """Where the handle rests along its cell's slider, from 0 to 1."""
    if len(entry.controls) > 1:
        return 0.5
    control = controls[entry.controls[0]]
    return (control.default - control.minimum) / (control.maximum - control.minimum)


def _directions(group: Group, frame: Floats) -> list[Floats]:
    """Directions in which the members' tracks run on the board: axes to the right, then up, their
    opposites to the other side; the members of a fan spread over the half circle."""
    found: list[Floats] = [frame[0]] * len(group.controls)
    for number, axis in enumerate(group.axes):
        angle = np.pi * number / len(group.axes)
        direction = np.cos(angle) * frame[0] + np.sin(angle) * frame[1]
        found[axis[-1]] = direction
        if len(axis) == 2:
            found[axis[0]] = -direction
    return found


def _member(face: Face, control: int, place: Floats, length: float, direction: Floats) -> Member:
    """A straight track through `place`, where the handle is at the base value; to one side
    only where the control goes to one side only."""
    ours = face.rig.controls[control]
    values = np.unique([ours.minimum, ours.default, ours.maximum])
    share = (values - ours.default) / (values[-1] - values[0])
    peak = float(face.trajectories.motion_of(control).arc_length.max())
    track = place + length * share[:, None] * direction
    return Member(ours.name, values, track, peak, length / peak, peak)


def _side(face: Face, entry: BoardEntry, row: tuple[BoardEntry, ...]) -> Side:
    """The side of a pair's element; of another one, which may have lost its pair, that on which
    it acts."""
    if not face.symmetry.plane.normal.any():
        return "none"
    if len(row) == 2:
        return "left" if entry is row[0] else "right"
    return side_at(_aside(face, entry), ASIDE)


def _aside(face: Face, entry: BoardEntry) -> float:
    """How far to the left the entry's first control acts, in face sizes."""
    motion = face.trajectories.motion_of(entry.controls[0])
    return np.average(face.aside[motion.points], weights=motion.arc_length)
