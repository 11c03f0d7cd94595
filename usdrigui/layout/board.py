"""The board beside the face: a tidy grid for what does not belong on it (paper section 3.3, global
deformations).

It stands in the plane of the layout's own view, to the right of the silhouette at its own height, in
columns no taller than the face; rows are grouped under the families' headings.  It is attached to the
most head-like joint, so that it goes along with the head and with nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

import numpy as np

from usdrigui.layout.glyphs import fitted_glyph
from usdrigui.layout.names import common_label
from usdrigui.layout.terms import Context
from usdrigui.layout.visibility import screen
from usdrigui.model import Anchor, Element, Floats, Group, Indices, Member, Side

FAMILIES = ("global", "hidden", "composite", "requested", "crowded")
"""Headings, from top to bottom."""

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
class Board:
    """One element that stands beside the face."""

    group: Group
    controls: tuple[int, ...]
    family: str
    reason: str


def beside_elements(context: Context, board: list[Board]) -> list[Element]:
    """Elements of the board, in the reading order of its rows."""
    if not board:
        return []
    rows = _rows(context, board)
    carrier = _carrier(context)
    width, height = context.handle_width, _TALL * context.trajectories.face_size
    middle = _face_middle(context)
    frame = screen(context.views)
    columns = _columns(rows, max(1, int(height / (_ROW * width))))
    left = _silhouette(context, middle, frame, 0.5 * height) + _MARGIN * width
    left = max([left, *(_right_end(context, each, frame) for each in _standing(context))])
    elements = []
    for column in columns:
        cells = _cell_widths(context, [row for _, row in column])
        for line, row in column:
            for cell, entry in enumerate(row):
                across = left + (sum(cells[:cell]) + _TRACK * _start(context, entry)) * width
                down = 0.5 * height - (line + 0.5) * _ROW * width
                place = middle + frame[0] * (across - middle @ frame[0]) + frame[1] * down
                elements.append(_element(context, entry, row, place, frame, carrier))
        left += sum(cells) * width
    return elements


def _standing(context: Context) -> list[Element]:
    """The elements of a board that stands already."""
    elements = context.standing.elements if context.standing is not None else ()
    return [element for element in elements if element.anchor.beside]


def _right_end(context: Context, element: Element, frame: Floats) -> float:
    """Where a standing element, its label included, ends across the screen, and a column may begin."""
    across = max(float((member.track @ frame[0]).max()) for member in element.members)
    return across + (2.0 + _LETTER * len(element.label)) * context.handle_width


def _cell_widths(context: Context, rows: list[tuple[Board, ...]]) -> list[float]:
    """Widths of the cells of a column, in handle widths: sliders with the longest label below each other.

    A lone element's label may run on over the cells to its right.
    """
    count = max(len(row) for row in rows)
    widths = [_TRACK + 2.0] * count
    for cell in range(count):
        for row in rows:
            if len(row) > cell + 1 or (len(row) == count and cell == count - 1):
                widths[cell] = max(widths[cell], _width(context, row[cell]))
    lone = max((_width(context, row[0]) for row in rows if len(row) == 1), default=0.0)
    widths[-1] += max(0.0, lone - sum(widths))
    return widths


def _width(context: Context, entry: Board) -> float:
    label = common_label([context.rig.controls[control].label for control in entry.controls])
    return _TRACK + 2.0 + _LETTER * len(label)


def _rows(context: Context, board: list[Board]) -> list[tuple[Board, ...]]:
    """Rows of one element or of a pair, sorted by family and then by name."""
    names = context.rig.controls
    ranked = sorted(board, key=lambda each: (FAMILIES.index(each.family), each.group.name.lower(), each.group.name))
    rows = []
    for _, members in groupby(ranked, key=lambda each: (each.family, each.group.name)):
        rows.append(tuple(sorted(members, key=lambda each: names[each.controls[0]].name)))
    return rows


def _columns(rows: list[tuple[Board, ...]], most: int) -> list[list[tuple[int, tuple[Board, ...]]]]:
    """Rows with their line numbers, column by column; a heading takes a line above each family."""
    columns: list[list[tuple[int, tuple[Board, ...]]]] = [[]]
    line, family = 0, ""
    for row in rows:
        tall = _lines(row)
        heading = 1 if row[0].family != family or line == 0 else 0
        if line and line + heading + tall > most:
            columns.append([])
            line, heading = 0, 1
        columns[-1].append((line + heading, row))
        line += heading + tall
        family = row[0].family
    return columns


def _lines(row: tuple[Board, ...]) -> int:
    """Lines that a row takes: a joystick needs room above and below."""
    return 3 if any(each.group.kind != "slider" for each in row) else 1


def _element(
    context: Context, entry: Board, row: tuple[Board, ...], place: Floats, frame: Floats, carrier: int
) -> Element:
    if entry.group.kind != "slider":
        place = place - frame[1] * _ROW * context.handle_width
    names = ["_".join(context.rig.controls[control].name for control in each.controls) for each in row]
    own = row.index(entry)
    anchor, side = _anchor(context, carrier, place), _side(context, entry, own)
    members = tuple(
        _member(context, control, place, direction, len(entry.controls) == 1)
        for control, direction in zip(entry.controls, _directions(entry.group, frame), strict=True)
    )
    return Element(
        name=names[own],
        label=common_label([context.rig.controls[control].label for control in entry.controls]),
        kind=entry.group.kind,
        members=members,
        opposed=entry.group.opposed,
        anchor=anchor,
        side=side,
        mirror=names[1 - own] if len(row) == 2 else "",
        family=entry.family,
        reason=entry.reason,
        adapt=context.settings.output.adapt,
        glyph=fitted_glyph(context, entry.controls, anchor, members, side == "right"),
        reversed=tuple(m for m, each in enumerate(entry.controls) if len(row) == 2 and context.symmetry.reversed[each]),
    )


def _start(context: Context, entry: Board) -> float:
    """Where the handle rests along its cell's slider, from 0 to 1."""
    if len(entry.controls) > 1:
        return 0.5
    subject = context.rig.controls[entry.controls[0]]
    return (subject.default - subject.minimum) / (subject.maximum - subject.minimum)


def _directions(group: Group, frame: Floats) -> list[Floats]:
    """Directions in which the members' tracks run on the board: axes to the right, then up, their opposites
    to the other side; the members of a fan spread over the half circle."""
    count = len(group.controls)
    found: list[Floats] = [frame[0]] * count
    for number, axis in enumerate(group.axes):
        angle = np.pi * number / max(len(group.axes), 2)
        direction = np.cos(angle) * frame[0] + np.sin(angle) * frame[1]
        found[axis[-1]] = direction
        if len(axis) == 2:
            found[axis[0]] = -direction
    return found


def _member(context: Context, control: int, place: Floats, direction: Floats, alone: bool) -> Member:
    """A straight track through `place`, where the control stands at its base value, as long as the board's
    sliders; to one side only where the control goes to one side only."""
    motion = context.trajectories.motion_of(control)
    subject = context.rig.controls[control]
    values = np.unique([subject.minimum, subject.default, subject.maximum])
    length = _TRACK * context.handle_width * (1.0 if alone else 0.5)
    share = (values - subject.default) / (values[-1] - values[0])
    track = place + length * share[:, None] * direction
    true = float(motion.arc_length.max())
    return Member(subject.name, values, track, true, length / true)


def _anchor(context: Context, carrier: int, place: Floats) -> Anchor:
    index, local = context.rig.mesh_of(carrier)
    mesh = context.rig.meshes[index]
    return Anchor(mesh.path, local, len(mesh.points), mesh.topology_hash, place, context.views.directions[0], True)


def _side(context: Context, entry: Board, own: int) -> Side:
    if not context.symmetry.normal.any():
        return "none"
    if not entry.group.images:
        return "middle"
    return "left" if own == 0 else "right"


# --- where the board stands --------------------------------------------------------------------------


def _face_points(context: Context) -> Indices:
    """Points that local controls move notably."""
    moved = np.zeros(len(context.trajectories.base), dtype=bool)
    for motion in context.trajectories.motions:
        moved[motion.points[motion.arc_length >= 0.5 * motion.arc_length.max()]] = True
    return np.flatnonzero(moved)


def _face_middle(context: Context) -> Floats:
    """Middle of the moving region, on the mirror plane where there is one."""
    points = context.trajectories.base[_face_points(context)]
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    if context.symmetry.normal.any():
        middle = middle - ((middle - context.symmetry.origin) @ context.symmetry.normal) * context.symmetry.normal
    return np.asarray(middle, dtype=np.float64)


def _silhouette(context: Context, middle: Floats, frame: Floats, half: float) -> float:
    """Rightmost extent of the character on the screen at the heights of the board."""
    drawn = np.concatenate([np.full(len(mesh.points), mesh.visible) for mesh in context.rig.meshes])
    flat = context.trajectories.base[drawn] @ frame.T
    beside = flat[np.abs(flat[:, 1] - middle @ frame[1]) <= half, 0]
    return float(beside.max()) if len(beside) else float(middle @ frame[0])


def _carrier(context: Context) -> int:
    """The point whose joint influences the board takes: of the joint that holds most of the face, the point
    that it holds most firmly and that moves least, nearest to the middle of the face."""
    base = context.trajectories.base
    total = np.zeros(len(base))
    for motion in context.trajectories.motions:
        total[motion.points] += motion.arc_length
    firmness = _firmness(context)
    apart = np.linalg.norm(base - _face_middle(context), axis=1)
    unit = context.trajectories.face_size
    order = np.lexsort((np.round(apart / unit, 6), np.round(total / unit, 6), -np.round(firmness, 3)))
    return int(order[0])


def _firmness(context: Context) -> Floats:
    """(n,) weight of the joint that holds most of the face; 1 throughout without skins."""
    face = np.zeros(len(context.trajectories.base), dtype=bool)
    face[_face_points(context)] = True
    tables = []
    for start, mesh in zip(context.rig.starts, context.rig.meshes, strict=False):
        held = np.zeros((len(mesh.points), len(context.rig.joints)))
        if mesh.skin is not None:
            rows = np.repeat(np.arange(len(mesh.points)), mesh.skin.joints.shape[1])
            np.add.at(held, (rows, mesh.skin.joints.ravel()), mesh.skin.weights.ravel())
        tables.append((face[start : start + len(mesh.points)], held))
    if not context.rig.joints:
        return np.ones(len(face))
    totals = sum(held[on_face].sum(axis=0) for on_face, held in tables)
    chosen = int(np.argmax(totals))
    return np.concatenate([held[:, chosen] for _, held in tables])
