"""Where an element is at a pose: the rules of the layer, from what the application says of its
anchor.

A track follows the skin under every control but those of its own element; a handle lies on the
deformed anchor, or slides along its track where the element hangs rigidly or its track is enlarged.
How tracks go with the anchor and where a handle slides is usdrigui's own file, put into `maths`
when the extension is packed.  numpy only, positions in world space, 4x4 matrices for column
vectors.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .maths.handle_track import carried, facing, slid
from .maths.neighbours import end_of, neighbours


@dataclass(frozen=True)
class Drawing:
    """An element with its figures as arrays, in root space at the base pose."""

    element: object
    """The `layout.Element`."""
    values: tuple
    """Per member, (k,) ascending control values."""
    tracks: tuple
    """Per member, (k, 3)."""
    area: np.ndarray
    """(3 t, 3) corners of the triangles that a patch or fan spans."""
    base: np.ndarray
    """(members,) values in the base pose."""
    ranges: np.ndarray
    """(members, 3) minimum, default and maximum."""


@dataclass(frozen=True)
class Placed:
    """One element in world space."""

    tracks: tuple
    area: np.ndarray
    handle: np.ndarray
    normal: np.ndarray
    scale: float
    """World length of one scene unit at the anchor."""
    values: tuple
    """Of the members."""


def drawing_of(element, controls):
    """`Drawing` of a `layout.Element`; ``controls`` maps names to `layout.Control`."""
    mine = [controls[member.control] for member in element.members]
    tracks = tuple(np.array(member.track) for member in element.members)
    return Drawing(
        element,
        values=tuple(np.array(member.values) for member in element.members),
        tracks=tracks,
        area=_area(element, tracks),
        base=np.array([control.base for control in mine]),
        ranges=np.array([(control.minimum, control.default, control.maximum) for control in mine]),
    )


def _area(element, tracks):
    """(3 t, 3) triangles between the handle and the ends of neighbouring tracks."""
    home, normal = np.array(element.position), np.array(element.normal)
    across = np.cross(np.eye(3)[np.argmin(np.abs(normal))], normal)
    pairs = neighbours(tracks, home, normal, across, element.axes)
    found = [(home, *(end_of(tracks, end) for end in pair)) for pair in pairs]
    return np.array(found).reshape(-1, 3)


def place(drawing, point, anchor, skin, values):
    """`Placed` element at member ``values`` (m,).

    ``point`` (3,) is the deformed anchor in the world, ``anchor`` where it would be with the
    element's own controls in the base pose, both None for an element that hangs rigidly; ``skin``
    (4, 4) is the map of the skin there with these controls so, from root space in the base pose to
    the world.
    """
    linear, element = skin[:3, :3], drawing.element
    if anchor is None:
        anchor = linear @ element.position + skin[:3, 3]
    *tracks, area = (
        carried(each, element.position, anchor, linear.T)
        for each in (*drawing.tracks, drawing.area)
    )
    handle = point
    enlarged = any(abs(member.magnification - 1.0) > 1e-6 for member in element.members)
    if handle is None or enlarged:
        handle = slid(drawing.values, tracks, drawing.base, values)[1]
    scale = np.cbrt(abs(np.linalg.det(linear)))
    normal = facing(element.normal, linear.T)
    return Placed(tuple(tracks), area, handle, normal, scale, values)
