"""What the directions from which a character is drawn are called, and which go well together.

Directions are (3,) unit vectors from the character to the viewer, in root space.  Angles are
degrees: azimuth from where the face looks toward the character's own left, elevation above the
horizon.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats
from usdrigui.character.joint_tree import unit
from usdrigui.layout.symmetry.front import first_across, seen_from
from usdrigui.model import Layout

TURN = 35.0
"""Azimuth of a three-quarter view."""
_SAME = 0.5
"""Views nearer to each other than this are called alike: more than single precision loses, less
than one sees."""
_NAMES = {
    0.0: "front",
    TURN: "three-quarter, character's left",
    45.0: "three-quarter, character's left",
    90.0: "side, character's left",
    135.0: "three-quarter back, character's left",
    180.0: "back",
}
"""Of views, by azimuth; those of the other side are the character's right."""
_HIGH = 30.0
"""Elevation, up or down, from which a view with a named azimuth is one from above or below: the
directions between two axes have 45, those among three 35.3."""
_APART, _BEYOND = 20.0, 90.0
"""A companion shows something else than the layout's own view, and still what that one sees."""


def ahead_of(layout: Layout, up: Floats) -> Floats:
    """Where the face looks: level and in the mirror plane, whose normal points to the character's
    left; without a plane, the layout's own view.

    With one the view does not show it: a layout made for the side has the profile there.
    """
    frame = layout.frame
    return first_across(up, np.cross(frame.plane.normal, up), frame.view)


def camera_rows(layout: Layout, up: Floats, toward: Floats | None = None) -> Floats:
    """(3, 3) camera rows, right, up and out, for a view of a layout against `toward`, its own if
    none."""
    view = layout.frame.view if toward is None else toward
    return seen_from(unit(view), up, ahead_of(layout, up))


def turned(direction: Floats, up: Floats, degrees: float) -> Floats:
    """The direction turned about the up axis toward the character's own left, as high above the
    horizon."""
    level = direction - (direction @ up) * up
    angle = np.radians(degrees)
    around = np.cos(angle) * level + np.sin(angle) * np.cross(up, level)
    return np.asarray(around + (direction @ up) * up)


def angles(direction: Floats, ahead: Floats, up: Floats) -> tuple[float, float]:
    """Azimuth within [-180, 180] and elevation; azimuth 0 straight above and below."""
    height = float(np.clip(direction @ up, -1.0, 1.0))
    level = direction - height * up
    if np.linalg.norm(level) < 1e-6:
        return 0.0, 90.0 if height > 0.0 else -90.0
    azimuth = float(np.degrees(np.arctan2(level @ np.cross(up, ahead), level @ ahead)))
    return azimuth, float(np.degrees(np.arcsin(height)))


def caption(direction: Floats, ahead: Floats, up: Floats) -> str:
    """What a view is called: by its name where it has one, else by its angles."""
    azimuth, elevation = (round(each, 1) + 0.0 for each in angles(direction, ahead, up))
    end = "above" if elevation > 0.0 else "below"
    if abs(elevation) > 90.0 - _SAME:
        return end
    names = [name for at, name in _NAMES.items() if abs(abs(azimuth) - at) < _SAME]
    if not names or _SAME <= abs(elevation) < _HIGH:
        return f"azimuth {azimuth:g}°, elevation {elevation:g}°"  # the sum leaves no minus before 0
    name = names[0] if azimuth > 0.0 else names[0].replace("left", "right")
    return name if abs(elevation) < _SAME else f"{name}, from {end}"


def companions(direction: Floats, ahead: Floats, up: Floats) -> tuple[Floats, ...]:
    """At most two level views, front and three-quarter, that show what the layout's own view sees,
    nearest first."""
    near = []
    for azimuth in (TURN, -TURN, 0.0):
        other = turned(ahead, up, azimuth)
        apart = float(np.degrees(np.arccos(np.clip(direction @ other, -1.0, 1.0))))
        if _APART < apart < _BEYOND + _SAME:
            near.append((round(apart, 1), other))
    return tuple(other for _, other in sorted(near, key=lambda each: each[0])[:2])
