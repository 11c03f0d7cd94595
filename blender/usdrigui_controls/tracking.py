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


@dataclass(frozen=True)
class Drawing:
    """An element's figures as arrays, in root space at the base pose."""

    values: tuple
    """Per member, (k,) ascending control values."""
    tracks: tuple
    """Per member, (k, 3)."""
    areas: tuple
    """(n, 3) each."""
    triangles: tuple
    """(t, 3) each."""
    position: np.ndarray
    normal: np.ndarray
    follows: bool
    enlarged: bool
    base: np.ndarray
    """(members,) values in the base pose."""
    ranges: np.ndarray
    """(members, 3) minimum, default and maximum."""
    axes: tuple
    """Positions of the members of each axis: one, or the two ends of a signed axis."""


@dataclass(frozen=True)
class AnchorFrame:
    """An element's anchor in the application at this moment."""

    point: np.ndarray | None
    """(3,) the deformed anchor, in world space; None for an element that hangs rigidly."""
    own: np.ndarray
    """(3,) what the element's own blend shapes add to the anchor now, before skinning."""
    now: np.ndarray
    """(4, 4) from before skinning to the world, as it is."""
    still: np.ndarray
    """(4, 4) the same with the element's own joints in the base pose."""
    rest: np.ndarray
    """(4, 4) from root space in the base pose to before skinning."""


@dataclass(frozen=True)
class Placed:
    """One element in world space."""

    tracks: tuple
    areas: tuple
    handle: np.ndarray
    normal: np.ndarray
    scale: float
    """World length of one scene unit at the anchor."""


def drawing_of(element, controls):
    """`Drawing` of a `layout.Element`; ``controls`` maps names to `layout.Control`."""
    mine = [controls[member.control] for member in element.members]
    return Drawing(
        values=tuple(np.array(member.values) for member in element.members),
        tracks=tuple(np.array(member.track) for member in element.members),
        areas=tuple(np.array(area.points).reshape(-1, 3) for area in element.areas),
        triangles=tuple(
            np.array(area.triangles, dtype=np.int32).reshape(-1, 3) for area in element.areas
        ),
        position=np.array(element.position),
        normal=np.array(element.normal),
        follows=element.follows,
        enlarged=any(abs(member.magnification - 1.0) > 1e-6 for member in element.members),
        base=np.array([control.base for control in mine]),
        ranges=np.array([(control.minimum, control.default, control.maximum) for control in mine]),
        axes=element.axes or tuple((i,) for i in range(len(mine))),
    )


def place(drawing, site, values):
    """`Placed` element at member ``values`` (m,)."""
    whole = site.still @ site.rest
    linear = whole[:3, :3]
    if site.point is None:
        anchor = linear @ drawing.position + whole[:3, 3]
    else:
        before = np.linalg.pinv(site.now[:3, :3]) @ (site.point - site.now[:3, 3]) - site.own
        anchor = site.still[:3, :3] @ before + site.still[:3, 3]
    tracks, areas = (
        tuple(carried(each, drawing.position, anchor, linear.T) for each in lines)
        for lines in (drawing.tracks, drawing.areas)
    )
    handle = site.point
    if handle is None or drawing.enlarged:
        handle = slid(drawing.values, tracks, drawing.base, values)[1]
    scale = float(np.cbrt(abs(np.linalg.det(linear))))
    return Placed(tracks, areas, handle, facing(drawing.normal, linear.T), scale)
