"""A layout in the units and with the up axis that its character has today."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from usdrigui.character import Floats
from usdrigui.character.joint_tree import unit
from usdrigui.layout.symmetry.sides_of_joints import ONE_WAY
from usdrigui.model import Element, Layout


def up_of(layout: Layout) -> Floats | None:
    """(3,) unit up direction that a layout was made for; None where its view is from above or
    aside.

    The layout's view and the left of the character give that direction up to the tilt of the view,
    unless they go one way.
    """
    left = _left(layout.elements, layout.frame.plane.normal)
    up = np.cross(layout.frame.view, unit(left))
    length = float(np.linalg.norm(up))
    ahead = np.sum([each.anchor.normal for each in layout.elements], axis=0)
    if layout.frame.view @ ahead <= ONE_WAY * np.linalg.norm(ahead) or length < ONE_WAY:
        return None
    axis = int(np.abs(up).argmax())
    return np.asarray(np.sign(up[axis]) * np.eye(3)[axis])


def other_up(layout: Layout, up: Floats) -> Floats | None:
    """(3,) the up direction that a layout was made for, where that is another than `up`."""
    before = up_of(layout)
    return None if before is None or abs(before @ up) > ONE_WAY else before


def turn_between(before: Floats, after: Floats) -> Floats:
    """(3, 3) the least rotation from one up direction to another; none where either is zero."""
    if not (np.any(before) and np.any(after)):
        return np.eye(3)
    return np.asarray(Rotation.align_vectors(after, before)[0].as_matrix())


def in_world(layout: Layout, metres: float, up: Floats) -> Layout:
    """The layout as it would be on a character with a unit of `metres` and the up direction `up`
    (3,); itself where that is so."""
    before, scale = other_up(layout, up), (layout.metres_per_unit or metres) / metres
    if scale == 1.0 and before is None:
        return layout
    turn = np.eye(3) if before is None else turn_between(before, up)
    frame, plane = layout.frame, layout.frame.plane
    parts = tuple(
        replace(each, handle_width=scale * each.handle_width, view=turn @ each.view)
        for each in frame.parts
    )
    return replace(
        layout,
        metres_per_unit=metres,
        elements=tuple(_moved(each, scale, turn) for each in layout.elements),
        frame=replace(
            frame,
            view=turn @ frame.view,
            plane=replace(plane, origin=scale * turn @ plane.origin, normal=turn @ plane.normal),
            handle_width=scale * frame.handle_width,
            parts=parts,
        ),
    )


def _moved(element: Element, scale: float, turn: Floats) -> Element:
    anchor = element.anchor
    x, y, z = (scale * turn @ np.array(element.pinned_position)).tolist()
    members = tuple(
        replace(
            m,
            track=scale * m.track @ turn.T,
            arc_length=scale * m.arc_length,
            peak=scale * m.peak,
        )
        for m in element.members
    )
    return replace(
        element,
        members=members,
        anchor=replace(
            anchor, position=scale * turn @ anchor.position, normal=turn @ anchor.normal
        ),
        pinned_position=(x, y, z),
    )


def _left(elements: tuple[Element, ...], plane_normal: Floats) -> Floats:
    """(3,) to the left of the character: the plane's normal, else from the elements of the right
    to those of the left; 0 where it is unknown."""
    if plane_normal.any():
        return plane_normal
    left, right = (
        [each.anchor.position for each in elements if each.side == side]
        for side in ("left", "right")
    )
    return np.mean(left, axis=0) - np.mean(right, axis=0) if left and right else np.zeros(3)
