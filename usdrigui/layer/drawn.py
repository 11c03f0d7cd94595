"""What is drawn of an element: its handle, its tracks and the areas between them, as polygons.

Tracks and glyphs that are curves are ribbons: importers deform meshes, and leave curves where they
are.

Positions come in as the layout has them, in the base pose, and go out in the bind pose (see
`usdrigui.layer.skin_binding`), with the shapes and influences that make them follow the character.
numpy only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from usdrigui.character import Floats, Indices, Record
from usdrigui.character.deform import keyed
from usdrigui.following import controls_of
from usdrigui.layer.control_api import slides
from usdrigui.layer.polyline import fewest_points
from usdrigui.layer.skin_binding import AnchorBinding, JointBinding, PointShape, SkinBinding
from usdrigui.model import Element, LayoutFrame, Member
from usdrigui.model.neighbours import end_of, neighbours
from usdrigui.ties import axis_across

_INSET = 0.05
"""Of the way from a corner of an area to its middle: so far it stays away from the tracks."""
_TRACK_WIDTH = 0.22
"""Of a handle's."""
_HAIR = 0.15
"""Of a handle's width, as wide as a track is: what a track need not follow.  All shapes left out
move it by less, taken together."""
_BEND, _LONG_BEND = 0.15, 0.08
"""Of a handle's width, as wide as a track is, or of the track's length, if that is more: by so much
a drawn track may pass points of the track that it leaves out.  A straight one between both sides of
an arch passes a turn of 60 degrees by so much."""
_ARCH = 0.75
"""Half the height of a flat arch over its mean height."""
_EXACT, _FINE = 5e-7, 1e-3
"""Of the character's size, and of a handle's width, the less of both: the same for handles, which
must be on the skin.  What is small beside its character, or beside a mesh that stands far away,
needs its own measure."""
_HAIR_STEP, _EXACT_STEP, _FINE_STEP = 0.05, 3e-7, 5e-4
"""Of the same lengths: offsets and points are whole numbers of decimal steps below these, so that
they are short to write.  Of a handle only the anchor is on the skin: its dome goes as tracks do."""
_SIDES = 6
_RADIUS, _HEIGHT = 0.6, 0.4
"""Of a handle's width: a hexagon of this radius covers the circle around a handle, and its dome is
so high that it is seen from the side."""
_LIFT = 0.35
"""Of a handle's width: so far the middle of the dome is from its anchor, which the skin around it
would hide."""
_LIFT_TURN, _DOME_TURN = 4.0, 2.0
"""Weight of the direction to the viewer, beside that of the skin's normal, in the directions in
which the dome is lifted, and looks."""
_FRONT, _ASIDE = 3.0, 0.5
"""Weight of the view from the front beside the part's own in that direction, and how far that view
goes to the side of the character to which the skin looks: half of the 40 degrees or so from which a
character is turned to be seen."""
_BEHIND = -0.5
"""Skin that looks away from the viewer by more than this is seen from another side."""


class Faces(Record):
    """Polygons of some points."""

    counts: Indices
    """(f,) corners of each."""
    indices: Indices
    """(sum of counts,) point of each corner."""

    @staticmethod
    def alike(corners: Indices) -> Faces:
        """Of (f, c) corners."""
        return Faces(np.full(len(corners), corners.shape[1], dtype=np.int64), corners.ravel())


Form = tuple[Floats, Faces]
"""Points (q, 3) around a place, and the faces between them."""


class Drawn(Record):
    """One thing that is drawn of an element."""

    role: Literal["handle", "tracks"]
    points: Floats
    """(q, 3) in the bind pose."""
    faces: Faces
    """Counter-clockwise from outside; those of areas last."""
    joint_binding: JointBinding
    shapes: tuple[PointShape, ...]
    """Offsets (k, q, 3)."""
    areas: int = 0
    """How many faces are those of areas."""
    lift: float = 0.0
    """How far the middle of a handle is from its anchor in the base pose."""


def drawn_parts(skin: SkinBinding, element: Element, frame: LayoutFrame) -> tuple[Drawn, Drawn]:
    """Everything to draw of one element: the handle, and the tracks with the areas between them."""
    part = element.part
    width, view = frame.handle_width_of(part), frame.view_of(part)
    # Hands that hang are seen from the side, each from its own; and all from the front.
    normal, across = element.anchor.normal, frame.plane.normal
    view = max(view, frame.plane.turned(view), key=normal.dot)
    front = frame.view + np.clip(normal @ across, -_ASIDE, _ASIDE) * across
    view = _unit(view + _FRONT * front, view)
    binding = skin.at_anchor(element)
    # Offsets are in the bind pose, of which the base pose may be many times as large.
    narrow = width / (float(np.linalg.norm(binding.track.base[:3], 2)) or 1.0)
    step, hair = min(_EXACT_STEP * skin.size, _FINE_STEP * narrow), _HAIR_STEP * narrow
    felt = _felt(binding.shapes, min(_EXACT * skin.size, _FINE * narrow))
    binding, still = (
        replace(binding, shapes=tuple(_short(shape, step) for shape in felt)),
        replace(binding, shapes=_felt(binding.shapes, _HAIR * narrow)),
    )
    lift = _LIFT * width if element.glyph is None else 0.0
    (around, faces), fine, bound = _form(element, width, view), step, binding.track
    if binding.deforms:
        # It has every shape and influence of the anchor.
        bound, centre, shapes = binding.handle, binding.rest, binding.shapes
        fine = hair if lift else step
    else:
        centre, shapes = _sliding(skin, binding, element, step)
    points = in_steps(centre + around @ bound.inverse, step)
    spread = tuple(_uniform(shape, len(around), fine) for shape in shapes)
    handle = Drawn("handle", points, faces, bound, spread, lift=lift)
    return handle, _tracks(skin, still, element, width, (step, hair))


def _short(shape: PointShape, step: float) -> PointShape:
    return replace(shape, offsets=in_steps(shape.offsets, step))


def _felt(shapes: tuple[PointShape, ...], budget: float) -> tuple[PointShape, ...]:
    """The shapes without the smallest ones, which at their knots all together move less than
    `budget`."""
    sizes = np.array([np.linalg.norm(shape.offsets, axis=-1).max(initial=0.0) for shape in shapes])
    order = np.argsort(sizes, kind="stable")
    small = set(order[np.cumsum(sizes[order]) <= budget].tolist())
    return tuple(shape for i, shape in enumerate(shapes) if i not in small)


# --- tracks and areas -----------------------------------------------------------------------------


def _tracks(
    skin: SkinBinding,
    binding: AnchorBinding,
    element: Element,
    width: float,
    steps: tuple[float, float],
) -> Drawn:
    """A spike for each member, and polygons between those that are neighbours (paper section 4.1).

    They are bound to what the element's own controls leave alone; `steps` are those of points and
    of offsets.
    """
    members = [_bent(member, element.anchor.normal, width) for member in element.members]
    spikes = [
        # Each a little narrower, so that two which begin in one place do not begin in the same
        # points.
        _spike(member.track, element.anchor.normal, _TRACK_WIDTH * width / (1.0 + 0.1 * i))
        for i, member in enumerate(members)
    ]
    areas = _areas(element)
    polygons = ((corners, Faces.alike(np.arange(len(corners))[None])) for _, corners in areas)
    positions, faces = together([*spikes, *polygons])
    values = _values_at(skin.values[controls_of(skin.rig, element)], members, areas)
    shapes = _shapes_along(skin, binding, element, values, steps[1])
    points = in_steps(binding.track.unposed(positions) - _blended(skin, shapes), steps[0])
    return Drawn("tracks", points, faces, binding.track, shapes, len(areas))


def _bent(member: Member, normal: Floats, width: float) -> Member:
    """The member with as many points of its track as its bends need: UsdSkel moves every one at
    every frame.

    They are lifted along the normal until no piece passes below a point that is left out: a piece
    that cuts a corner would lie in the skin.
    """
    # By the way to it, as the samples at in-betweens are not at equal steps.
    places = np.append(0.0, np.linalg.norm(np.diff(member.track, axis=0), axis=1)).cumsum()
    tolerance = max(_BEND * width, _LONG_BEND * float(places[-1]))
    shift = _to_the_middle(member.track, normal, tolerance)
    ends = np.array([0, len(places) - 1])
    kept = ends if shift is not None else fewest_points(member.track, tolerance)
    columns = member.track[kept].T
    pieces = np.stack([np.interp(places, places[kept], each) for each in columns], axis=1)
    above = ((member.track - pieces) * normal).sum(axis=1).max()
    moved = above * normal + (0.0 if shift is None else shift)
    return replace(member, track=member.track[kept] + moved, values=member.values[kept])


def _to_the_middle(line: Floats, normal: Floats, tolerance: float) -> Floats | None:
    """(3,) what takes the chord of an arch (k, 3) to the middle between it and the arch, seen
    against the normal.

    None if the arch passes it there by more than `tolerance`, or leaves the skin by twice as much.
    """
    chord, away = line[-1] - line[0], line - line[0]
    squared = float((chord * chord).sum())
    if squared > 0.0:
        away = away - ((away * chord).sum(axis=1) / squared)[:, None] * chord
    above = (away * normal).sum(axis=1)
    beside = away - above[:, None] * normal
    shift = _ARCH * beside.mean(axis=0)
    farthest = np.linalg.norm(beside - shift, axis=1).max()
    return shift if farthest <= tolerance and np.ptp(above) <= 2.0 * tolerance else None


def together(forms: Sequence[Form]) -> Form:
    """Several forms as one."""
    starts = np.cumsum([0, *(len(points) for points, _ in forms)])
    indices = [each.indices + start for (_, each), start in zip(forms, starts, strict=False)]
    counts = np.concatenate([each.counts for _, each in forms])
    points = np.concatenate([points for points, _ in forms])
    return points, Faces(counts, np.concatenate(indices))


def _values_at(
    base: Floats, members: Sequence[Member], areas: Sequence[tuple[list[int], Floats]]
) -> Floats:
    """(q, members) value of each control with which the handle is at each point of the members'
    spikes, and at each corner of the areas, of which -1 is the handle itself."""
    values = [member.values for member in members]
    moved = [(i, at) for i, each in enumerate(values) for at in np.repeat(each, 2)[:-1].tolist()]
    moved += [
        (end % len(values), float(end_of(values, end))) if end >= 0 else (0, base[0])
        for ends, _ in areas
        for end in ends
    ]
    rows = np.tile(base, (len(moved), 1))
    for row, (which, at) in zip(rows, moved, strict=True):
        row[which] = at
    return rows


def _shapes_along(
    skin: SkinBinding, binding: AnchorBinding, element: Element, values: Floats, step: float
) -> tuple[PointShape, ...]:
    """What moves points at which the handle is with these `values` (q, members): all shapes but
    those of the element's own controls.

    Where these turn joints, the other shapes' offsets turn along the track as they do at the anchor
    when it is there.
    """
    others = [shape for shape in binding.shapes if shape.channel not in binding.own_channels]
    if binding.turning and others:
        maps = skin.maps_at(binding.handle, controls_of(skin.rig, element), values)
        turns = maps[:, :3] @ binding.track.inverse
        spread = [np.einsum("ki,qij->kqj", shape.offsets, turns) for shape in others]
    else:
        spread = [np.repeat(shape.offsets[:, None], len(values), axis=1) for shape in others]
    return tuple(
        replace(shape, offsets=in_steps(offsets, step))
        for shape, offsets in zip(others, spread, strict=True)
    )


def _ribbon(line: Floats, normal: Floats, width: float) -> tuple[Floats, Indices]:
    """(2 k, 3) left and right of each point of a line (k, 3), across the normal; and the quads
    between them."""
    along = np.gradient(line, axis=0)
    sides = np.cross(normal, along)
    flat = np.linalg.norm(sides, axis=1) <= 1e-6 * np.linalg.norm(along, axis=1).max(initial=1e-30)
    for i in np.flatnonzero(flat):  # the line leaves the skin, or stands still
        away = along[i] if along[i].any() else normal
        sides[i] = np.cross(axis_across(away), away)
    # A line that turns back keeps its left on the left: the quad between would be a bow tie.
    turned = np.einsum("ij,ij->i", sides[1:], sides[:-1]) < 0.0
    sides[1:] *= np.where(np.cumsum(turned) % 2, -1.0, 1.0)[:, None]
    sides *= 0.5 * width / np.maximum(np.linalg.norm(sides, axis=1), 1e-30)[:, None]
    positions = np.stack([line + sides, line - sides], axis=1).reshape(-1, 3)
    left = 2 * np.arange(len(line) - 1)
    return positions, np.stack([left + 1, left + 3, left + 2, left], axis=1)


def _spike(line: Floats, normal: Floats, width: float) -> tuple[Floats, Faces]:
    """(2 k - 1, 3) a ribbon whose last two points are one: it points to where the value is
    largest."""
    positions, quads = _ribbon(line, normal, width)
    positions[-2] = line[-1]
    corners = np.concatenate([quads[:-1].ravel(), quads[-1, [0, 2, 3]]])
    return positions[:-1], Faces(np.array([4] * (len(quads) - 1) + [3]), corners)


def _areas(element: Element) -> list[tuple[list[int], Floats]]:
    """A polygon for each run of neighbouring tracks: its ends, as in `end_of`, -1 for the handle,
    and their positions (q, 3).

    They end short of the tracks: surfaces that touch in a point make a mesh no manifold, and points
    that are in one place look like a mistake.
    """
    tracks, anchor = [each.track for each in element.members], element.anchor
    across = np.cross(axis_across(anchor.normal), anchor.normal)
    polygons: list[list[int]] = []
    for a, b in neighbours(tracks, anchor.position, anchor.normal, across, element.axes):
        if polygons and polygons[-1][-1] == a:
            polygons[-1].append(b)
        else:
            polygons.append([a, b])
    if len(polygons) > 1 and polygons[-1][-1] == polygons[0][0]:
        polygons[0] = [*polygons.pop(), *polygons[0][1:]]
    rounded = [each[:-1] if each[0] == each[-1] else [-1, *each] for each in polygons]
    corners = [
        np.array([anchor.position if end < 0 else end_of(tracks, end) for end in each])
        for each in rounded
    ]
    return [
        (ends, each + _INSET * (each.mean(axis=0) - each))
        for ends, each in zip(rounded, corners, strict=True)
    ]


# --- handles --------------------------------------------------------------------------------------


def _form(element: Element, width: float, view: Floats) -> Form:
    """A handle in the base pose."""
    glyph, normal = element.glyph, element.anchor.normal
    if glyph is None:
        return _dome(normal, view, width)
    if glyph.form == "mesh":
        return glyph.points, Faces(glyph.counts, glyph.indices)
    lines = [
        _ribbon(glyph.points[part], normal, _TRACK_WIDTH * width)
        for part in glyph.parts
        if len(part) > 1
    ]
    return together([(points, Faces.alike(quads)) for points, quads in lines])


def _dome(normal: Floats, view: Floats, width: float) -> Form:
    """The anchor, and over it a low dome with a stem to the anchor.

    On a flat disc in the skin little can be seen: the skin around it is higher here and there.  The
    dome is lifted and turned towards the viewer, the more the farther the skin looks away.
    """
    out = _unit(normal, np.array([0.0, 0.0, 1.0]))
    viewer = view if out @ view > _BEHIND else np.zeros(3)
    middle = _LIFT * _unit(out + _LIFT_TURN * viewer, out)
    facing = _unit(out + _DOME_TURN * viewer, out)
    across = np.cross(axis_across(facing), facing)
    across /= np.linalg.norm(across)
    turns = 2.0 * np.pi * np.arange(_SIDES)[:, None] / _SIDES
    rim = middle + _RADIUS * (np.cos(turns) * across + np.sin(turns) * np.cross(facing, across))
    points = np.concatenate([np.zeros((1, 3)), [middle + _HEIGHT * facing], rim])
    first = 2 + np.arange(_SIDES)
    sides = np.stack([np.ones_like(first), first, np.roll(first, -1)], axis=1)
    return width * points, Faces.alike(np.concatenate([[[0, 3, 2]], sides]))


def _unit(direction: Floats, otherwise: Floats) -> Floats:
    length = float(np.linalg.norm(direction))
    return direction / length if length > 0.0 else otherwise


def _sliding(
    skin: SkinBinding, binding: AnchorBinding, element: Element, step: float
) -> tuple[Floats, tuple[PointShape, ...]]:
    """(3,) where the handle of an element that does not deform rests, and the shapes of its own
    controls, which take it along the tracks."""
    shapes: dict[int, PointShape] = {}
    for member in element.members:
        along = _along_track(skin, binding, member)
        if along is not None:
            shapes.setdefault(along.channel, _short(along, step))
    now = _blended(skin, tuple(shapes.values()))
    centre = binding.track.unposed(element.anchor.position[None])[0] - now
    return centre, tuple(shapes[channel] for channel in sorted(shapes))


def _along_track(skin: SkinBinding, binding: AnchorBinding, member: Member) -> PointShape | None:
    """A shape that puts the handle on its track at every weight; None where it does not slide."""
    drive = skin.control(member.control).drive
    if not slides(skin.rig.body, drive):
        return None
    channel = int(drive.channels[0])
    base = skin.value(member.control)
    driven = keyed(drive.values, drive.weights, np.append(base, member.values))[:, 0]
    weights = skin.weights[channel] + driven[1:] - driven[0]
    rests = binding.track.unposed(member.track)
    if weights[0] > weights[-1]:
        weights, rests = weights[::-1], rests[::-1]
    if not (np.diff(weights) > 1e-6).all():
        return None
    nodes = np.unique([1.0, *weights[np.minimum(abs(weights), abs(weights - 1.0)) > 1e-6]])
    rest = keyed(weights, rests, np.zeros(1))
    return PointShape(channel, nodes, keyed(weights, rests, nodes) - rest)


def _blended(skin: SkinBinding, shapes: tuple[PointShape, ...]) -> Floats:
    """Sum of the shapes' offsets in the base pose, (3,) or (q, 3); without any, a zero that fits
    either."""
    total = np.zeros(3)
    for shape in shapes:
        weight = float(skin.weights[shape.channel])
        if weight:
            total = total + shape.at(weight)
    return total


def _uniform(shape: PointShape, count: int, step: float) -> PointShape:
    """The same offset for each of `count` points; of all but the first in steps below `step`."""
    offsets = np.repeat(shape.offsets[:, None], count, axis=1)
    offsets[:, 1:] = in_steps(offsets[:, 1:], step)
    return replace(shape, offsets=offsets)


def in_steps(values: Floats, step: float) -> Floats:
    """Values rounded to whole numbers of the largest power of ten up to `step`."""
    decimals = int(np.ceil(-np.log10(max(step, 1e-300))))
    return np.round(values, decimals) + 0.0  # no -0
