"""What is drawn of an element: its tracks, the area they span and its handle, as plain arrays.

Positions come in as the layout has them, in the base pose, and go out in the rest arrangement (see
`usdrigui.usd.carry`), with the shapes and influences that make them follow the character.  numpy only.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Literal

import numpy as np

from usdrigui.model import Control, Element, Floats, Glyph, Indices, Member, Record
from usdrigui.ties import axis_across
from usdrigui.usd.carry import Carriage, Grip, Hold, PointShape

_SIDE_SAMPLES = 7
"""Most points along one side of a spanned area."""
_FLAT = np.radians(2.0)
"""Two tracks closer to one line than this span no area."""


@dataclass(frozen=True, eq=False)
class Drawn(Record):
    """One gprim of an element."""

    role: Literal["track", "area", "handle"]
    controls: tuple[str, ...]
    """Names of the controls that it shows; none for a handle."""
    values: Floats
    """(q, len(controls)) value of each control with which the handle is at each point."""
    base_points: Floats
    """(q, 3) in root space, in the base pose."""
    points: Floats
    """(q, 3) in the rest arrangement."""
    faces: Indices
    """(f, 3) or (f, 4) point indices, counter-clockwise from outside; (0, 3) for a curve."""
    hold: Hold
    shapes: tuple[PointShape, ...]
    """Offsets (k, q, 3)."""
    glyph: Glyph | None = None
    """Of a handle that is not the usual ball: its polylines or polygons, instead of `faces`."""


def drawn_parts(carriage: Carriage, element: Element, width: float) -> tuple[Drawn, ...]:
    """Everything to draw of one element: a track per member, the area of a patch or fan, the handle.

    `width` is the diameter of the handle in scene units.
    """
    grip = carriage.grip(element)
    tracks = [_track(carriage, grip, member) for member in element.members]
    handle = _follower(carriage, grip, element, width) if grip.deforms else _slider(carriage, grip, element, width)
    return (*tracks, *_area(carriage, grip, element), handle)


# --- tracks and areas --------------------------------------------------------------------------------


def _track(carriage: Carriage, grip: Grip, member: Member) -> Drawn:
    values = np.array(member.values, dtype=np.float64)[:, None]
    return _still(carriage, grip, "track", (member.control,), values, member.track, np.zeros((0, 3), dtype=np.int64))


def _area(carriage: Carriage, grip: Grip, element: Element) -> tuple[Drawn, ...]:
    """Parallelograms between neighbouring tracks (paper section 4.1), one mesh; none for a slider."""
    pairs = [] if element.kind == "slider" else _neighbours(element)
    if not pairs:
        return ()
    names = tuple(member.control for member in element.members)
    base = np.array([carriage.value(name) for name in names])
    values, positions, faces, count = [], [], [], 0
    for a, b in pairs:
        grid = _grid(element, a, b, base)
        values.append(grid[0])
        positions.append(grid[1])
        faces.append(grid[2] + count)
        count += len(grid[0])
    first, corners = _welded(np.concatenate(values), np.concatenate(faces))
    spanned = np.concatenate(positions)[first]
    return (_still(carriage, grip, "area", names, np.concatenate(values)[first], spanned, corners),)


def _still(
    carriage: Carriage,
    grip: Grip,
    role: Literal["track", "area"],
    controls: tuple[str, ...],
    values: Floats,
    positions: Floats,
    faces: Indices,
) -> Drawn:
    """A part that its element's own controls must not move, and all others must.

    It is bound to what the own controls leave alone.  Where they turn joints, the other shapes' offsets
    turn along the track as they do at the anchor when it is there.
    """
    hold = grip.track
    others = [shape for shape in grip.shapes if shape.channel not in grip.own_channels]
    if grip.turning and others:
        settings = [dict(zip(controls, row, strict=True)) for row in values.tolist()]
        turns = carriage.maps_at(grip, settings)[:, :3] @ hold.inverse
        spread = [np.einsum("ki,qij->kqj", shape.offsets, turns) for shape in others]
    else:
        spread = [np.repeat(shape.offsets[:, None], len(values), axis=1) for shape in others]
    shapes = tuple(
        PointShape(shape.channel, shape.weights, offsets) for shape, offsets in zip(others, spread, strict=True)
    )
    points = hold.unposed(positions) - _blended(carriage, shapes)
    return Drawn(role, controls, values, np.array(positions, dtype=np.float64), points, faces, hold, shapes)


def _neighbours(element: Element) -> list[tuple[int, int]]:
    """Pairs of members whose tracks are next to each other around the normal, at most 180 degrees apart; never the
    two ends of one axis."""
    angle = _angles(element)
    order = np.argsort(angle, kind="stable")
    rounds = list(zip(order, np.roll(order, -1), strict=True))
    pairs = []
    for a, b in rounds[:1] if len(order) == 2 else rounds:
        between = (angle[b] - angle[a]) % (2.0 * np.pi)
        if len(order) == 2 and between > np.pi:
            a, b, between = b, a, 2.0 * np.pi - between
        if _FLAT < between < np.pi - _FLAT and not any(a in axis and b in axis for axis in element.axes):
            pairs.append((int(a), int(b)))
    return pairs


def _angles(element: Element) -> Floats:
    """Angle of each track's direction in the plane tangent to the skin at the anchor."""
    normal = np.array(element.anchor.normal, dtype=np.float64)
    aside = axis_across(normal)
    first = np.cross(aside, normal)
    first /= max(float(np.linalg.norm(first)), 1e-30)
    second = np.cross(normal, first)
    along = np.array([member.track[-1] - member.track[0] for member in element.members])
    return np.asarray(np.arctan2(along @ second, along @ first), dtype=np.float64)


def _grid(element: Element, a: int, b: int, base: Floats) -> tuple[Floats, Floats, Indices]:
    """Values (q, members), positions (q, 3) and quads of the area that two tracks span."""
    rows, columns = (_thinned(len(element.members[i].values)) for i in (a, b))
    one, other = element.members[a], element.members[b]
    values = np.tile(base, (len(rows) * len(columns), 1))
    values[:, a] = np.repeat(one.values[rows], len(columns))
    values[:, b] = np.tile(other.values[columns], len(rows))
    away = other.track[columns] - _on_track(other, base[b])
    positions = (one.track[rows][:, None] + away[None]).reshape(-1, 3)
    index = np.arange(len(values)).reshape(len(rows), len(columns))
    # The second track lies counter-clockwise of the first, so this order faces along the normal.
    quads = np.stack([index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]], axis=-1).reshape(-1, 4)
    return values, positions, quads


def _welded(values: Floats, faces: Indices) -> tuple[Indices, Indices]:
    """First of all points with the same values (q, members), in their order, and the faces with these alone.

    Neighbouring areas share the points of the track between them.
    """
    _, first, same = np.unique(values, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return first[order], rank[same.ravel()][faces]


def _thinned(count: int) -> Indices:
    return np.unique(np.linspace(0, count - 1, min(count, _SIDE_SAMPLES)).round().astype(np.int64))


def _on_track(member: Member, value: float) -> Floats:
    """(3,) drawn position at a control value; the nearest end beyond the ends."""
    return np.array([np.interp(value, member.values, member.track[:, axis]) for axis in range(3)])


# --- handles -----------------------------------------------------------------------------------------


def _follower(carriage: Carriage, grip: Grip, element: Element, width: float) -> Drawn:
    """The handle of an element on the skin: it has every shape and influence of the anchor."""
    around, faces = _form(element, width)
    points = grip.rest + around @ grip.handle.inverse
    shapes = tuple(_uniform(shape, len(around)) for shape in grip.shapes)
    base_points = (points + _blended(carriage, shapes)) @ grip.handle.base[:3] + grip.handle.base[3]
    values = np.zeros((len(around), 0))
    return Drawn("handle", (), values, base_points, points, faces, grip.handle, shapes, element.glyph)


def _form(element: Element, width: float) -> tuple[Floats, Indices]:
    """Points (q, 3) around a handle's centre in the base pose, and the faces of the usual ball."""
    if element.glyph is not None:
        return element.glyph.points, np.zeros((0, 3), dtype=np.int64)
    ball, faces = _ball()
    return 0.5 * width * ball, faces


def _slider(carriage: Carriage, grip: Grip, element: Element, width: float) -> Drawn:
    """The handle of an element that does not deform: its own controls' shapes take it along the tracks."""
    around, faces = _form(element, width)
    shapes: dict[int, PointShape] = {}
    for member in element.members:
        along = _along_track(carriage, grip, member)
        if along is not None:
            shapes.setdefault(along.channel, along)
    now = _blended(carriage, tuple(shapes.values()))
    centre = grip.track.unposed(element.anchor.position[None])[0] - now
    points = centre + around @ grip.track.inverse
    base_points = around + element.anchor.position
    spread = tuple(_uniform(shapes[channel], len(around)) for channel in sorted(shapes))
    values = np.zeros((len(around), 0))
    return Drawn("handle", (), values, base_points, points, faces, grip.track, spread, element.glyph)


def _along_track(carriage: Carriage, grip: Grip, member: Member) -> PointShape | None:
    """A shape that puts the handle on its track at every weight; None unless one weight is all that is driven."""
    control = carriage.control(member.control)
    drive = control.drive
    if len(drive.channels) != 1 or len(drive.joints):
        return None
    channel = int(drive.channels[0])
    base = carriage.value(member.control)
    weights = carriage.weights[channel] + _driven(control, member.values) - _driven(control, np.array([base]))
    rests = grip.track.unposed(member.track)
    if weights[0] > weights[-1]:
        weights, rests = weights[::-1], rests[::-1]
    if not (np.diff(weights) > 1e-6).all():
        return None
    nodes = np.array(sorted({1.0, *(float(w) for w in weights if min(abs(w), abs(w - 1.0)) > 1e-6)}))
    return PointShape(channel, nodes, _extended(weights, rests, nodes) - _extended(weights, rests, np.zeros(1)))


def _driven(control: Control, values: Floats) -> Floats:
    """Weight of a control's only channel at its values."""
    return _extended(control.drive.values, control.drive.weights, values)[:, 0]


def _extended(keys: Floats, rows: Floats, at: Floats) -> Floats:
    """Rows (k, c) at `at` (m,), linear between `keys` (k,) and extrapolated beyond them."""
    i = np.clip(np.searchsorted(keys, at, side="right") - 1, 0, len(keys) - 2)
    share = ((at - keys[i]) / (keys[i + 1] - keys[i]))[:, None]
    return np.asarray((1.0 - share) * rows[i] + share * rows[i + 1], dtype=np.float64)


def _blended(carriage: Carriage, shapes: tuple[PointShape, ...]) -> Floats:
    """Sum of the shapes' offsets in the base pose, (3,) or (q, 3); without any, a zero that fits either."""
    total = np.zeros(3)
    for shape in shapes:
        weight = float(carriage.weights[shape.channel])
        if weight:
            total = total + shape.at(weight)
    return total


def _uniform(shape: PointShape, count: int) -> PointShape:
    """The same offset for each of `count` points."""
    return PointShape(shape.channel, shape.weights, np.repeat(shape.offsets[:, None], count, axis=1))


@functools.cache
def _ball() -> tuple[Floats, Indices]:
    """A unit icosahedron about the origin: 12 points whose mean is the centre, and 20 triangles."""
    golden = (1.0 + 5.0**0.5) / 2.0
    corners = [(0.0, s, t * golden) for s in (-1.0, 1.0) for t in (-1.0, 1.0)]
    points = np.array([np.roll(corner, turn) for turn in range(3) for corner in corners])
    return points / np.linalg.norm(points[0]), _hull(points)


def _hull(points: Floats) -> Indices:
    """Triangles of the icosahedron: all triples of corners one edge apart, turned outwards."""
    near = np.linalg.norm(points[:, None] - points[None], axis=2) < 2.1
    faces = []
    for a in range(12):
        for b in range(a + 1, 12):
            for c in range(b + 1, 12):
                if near[a, b] and near[b, c] and near[a, c]:
                    outwards = np.linalg.det(points[[a, b, c]]) > 0.0
                    faces.append((a, b, c) if outwards else (a, c, b))
    return np.array(faces, dtype=np.int64)
