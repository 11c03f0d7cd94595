"""The layout of one maker's head carried to another maker's, whose controls have other names and other shapes.

The corresponding place is told by neither the controls nor the code under test: landmarks that were read off both
faces by hand carry every anchor over, in the front view.  A control that does not move the face there corresponds
at the nearest point at which it may stand.
"""

import numpy as np
import pytest
from laid_out_again import lay_out, read
from names_of_two_makers import NAMES
from scipy.interpolate import RBFInterpolator

from usdrigui.settings import load

pytestmark = pytest.mark.real

LANDMARKS = {
    "outer corner of the eye": ((-4.45, 3.43), (-0.0476, 1.6319)),
    "inner corner of the eye": ((-1.85, 3.26), (-0.0200, 1.6312)),
    "upper lid": ((-3.30, 4.01), (-0.0330, 1.6407)),
    "lower lid": ((-3.30, 3.04), (-0.0334, 1.6288)),
    "inner brow": ((-2.42, 6.19), (-0.0233, 1.6557)),
    "outer brow": ((-4.94, 5.98), (-0.0494, 1.6538)),
    "temple": ((-7.81, 6.81), (-0.0790, 1.6688)),
    "ear": ((-7.30, 1.49), (-0.0754, 1.6104)),
    "wing of the nose": ((-1.87, -0.08), (-0.0180, 1.5939)),
    "tip of the nose": ((0.0, 0.41), (0.0, 1.6012)),
    "below the nose": ((0.0, -1.20), (0.0, 1.5851)),
    "corner of the mouth": ((-2.53, -3.52), (-0.0275, 1.5625)),
    "upper lip": ((0.0, -2.48), (0.0, 1.5698)),
    "between the lips": ((0.0, -3.33), (0.0, 1.5634)),
    "lower lip": ((0.0, -4.39), (0.0, 1.5541)),
    "chin": ((0.0, -7.57), (0.0, 1.5217)),
    "corner of the jaw": ((-5.86, -4.71), (-0.0580, 1.5491)),
}
"""Across and up, of the character's right side or middle, in the units of either file."""


def carried_by_hand():
    """A map from the front view of one face to that of the other."""
    pairs = [
        (np.array(one) * (side, 1), np.array(other) * (side, 1))
        for one, other in LANDMARKS.values()
        for side in ((1, -1) if one[0] else (1,))
    ]
    source, target = (np.array(each) for each in zip(*pairs, strict=True))
    return RBFInterpolator(source, target, kernel="thin_plate_spline")


def place_at(face, across_and_up):
    """(3,) the foremost visible point there; the other maker's head has Z up and faces -Y."""
    base = face.surface.points
    off = np.linalg.norm(base[:, [0, 2]] - across_and_up, axis=1)
    near = np.flatnonzero(face.views.anywhere & (off < 2.0 * face.handle_width))
    return base[near[np.argmin(base[near, 1] + off[near])]]


def candidates_of(ready):
    """Where each control may stand, by name."""
    base, names = ready.face.surface.points, ready.face.rig.control_names
    return {
        names[control]: base[choice.anchors[:, copy]]
        for choice in ready.placement.choices
        for copy, controls in enumerate(choice.controls)
        for control in controls
    }


def test_nine_in_ten_of_the_mapped_controls_stand_within_some_two_handle_widths():
    shapes = {"read": {"joints": "none"}}  # A body is a part of its own.
    one, other = read("ict_face57.usdc"), read("vitruvian.usdc", load(shapes))
    _, _, theirs = lay_out(one)
    settings = load(shapes | {"solve": {"gap": 1e-2, "work_limit": 6_000_000}, "like": {"names": NAMES}})
    ready, _, ours = lay_out(other, settings, like=((one, theirs),))
    face, by_hand, allowed = ready.face, carried_by_hand(), candidates_of(ready)
    now = {member.control: element.anchor for element in ours.elements for member in element.members}
    off = {}
    for element in theirs.elements:
        for name in (member.control for member in element.members if member.control in NAMES):
            anchor = now[NAMES[name]]
            if element.anchor.on_board or anchor.on_board:
                off[name] = 0.0 if element.anchor.on_board == anchor.on_board else np.inf
                continue
            place = place_at(face, by_hand(element.anchor.position[None, :2])[0])
            spots = allowed[NAMES[name]]
            place = spots[np.argmin(np.linalg.norm(spots - place, axis=1))]
            off[name] = np.linalg.norm(anchor.position - place) / face.handle_width
    assert len(off) == len(NAMES)
    far = sorted(((distance, name) for name, distance in off.items() if distance > 2.1), reverse=True)
    assert len(far) <= len(off) / 10, far
