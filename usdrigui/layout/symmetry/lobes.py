"""Which symmetric controls act on two sides rather than in the middle (paper section 3.3, symmetric
deformations).

The paper holds the element of a symmetric control to the mirror plane.  A puff of both cheeks
hardly moves the plane: there its handle would be on the lips.  Such a control gets a handle on
each lobe; both set the same value.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Flags, Floats
from usdrigui.layout.shares import MOST
from usdrigui.model import Motion, Side, Symmetry
from usdrigui.ties import first_largest

ON_PLANE = 0.5
"""Distance from the plane, in handle widths, up to which a handle covers it."""
MIDDLE = 0.01
"""Distance from the plane, in face sizes, up to which a point lies in the middle."""
_KEPT = 0.8
"""A control expected on both sides has two lobes if it keeps less of its peak in the middle."""
ASIDE = 0.1
"""Distance from the plane, in face sizes, from which a place lies to one side of the face."""


def side_at(aside: float, most: float) -> Side:
    """The side of a place `aside` face sizes to the left; up to `most` it is in the middle."""
    return "middle" if abs(aside) <= most else "left" if aside > 0.0 else "right"


def two_lobed(motion: Motion, aside: Floats, visible: Flags, both_sides: bool | None) -> bool:
    """Whether a symmetric control's motion has two lobes off the mirror plane and little in
    between.

    `aside` (p,) are the distances of its points from the middle, in face sizes, `visible` (n,) the
    points that some view sees, `both_sides` is whether the conventions of the field expect the
    control on both sides; None where they do not know it: then whether its peak lies to one side.
    The control of a joint is on the skin that its joint owns, once.
    """
    if motion.of_joint:
        return False
    length = np.where(visible[motion.points], motion.arc_length, 0.0)
    if not length.any():
        length = motion.arc_length
    apart = np.abs(aside)
    middle = length[apart <= MIDDLE].max(initial=0.0)
    if both_sides is None:
        both_sides = bool(apart[first_largest(length)] > ASIDE)
    # Less is enough where the conventions expect it in the middle, or it is nearly there.
    least = _KEPT if both_sides else MOST
    return bool(middle < least * length.max())


def in_the_middle(symmetry: Symmetry, motion: Motion, handle_width: float) -> Flags:
    """(p,) which points that a motion moves a handle on the mirror plane covers, where a joint is
    turned about itself that is its own mirror image; none for another control."""
    own = motion.of_joint and int(symmetry.twins[motion.control]) == motion.control
    if not (own and symmetry.plane.normal.any()):
        return np.zeros(len(motion.points), dtype=bool)
    return np.abs(symmetry.apart[motion.points]) <= ON_PLANE * handle_width
