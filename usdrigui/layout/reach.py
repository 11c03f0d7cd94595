"""How much of the face a control moves: what tells local controls from global ones.

The paper calls a control global when fewer than a tenth of the points move less than its own mean
(section 4.2), which almost never fires: even a rigid motion of the head leaves the neck behind.  Here a
control's *reach* is where it moves notably, and it is measured against the reach of smaller controls.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.model import Flags, Floats, Motion

NOTABLE = 0.25
"""A control moves a point notably when by this share of its own peak."""
_MANY_TIMES = 2.5
"""A global control reaches at least this many times as far as the median control."""


def reaches(motions: Sequence[Motion], count: int) -> Flags:
    """(motions, count) which points each control moves notably."""
    flags = np.zeros((len(motions), count), dtype=bool)
    for row, motion in zip(flags, motions, strict=True):
        row[motion.points[motion.arc_length >= NOTABLE * motion.arc_length.max(initial=0.0)]] = True
    return flags


def covering(motions: Sequence[Motion], areas: Floats) -> Floats:
    """(motions,) share of the joint reach of all smaller controls that each control moves notably too.

    `areas` (n,) weighs the points.  Zero for a control that reaches no further than is usual in its rig:
    it takes several small controls to make a face that a large one can cover.
    """
    flags = reaches(motions, len(areas))
    size = flags @ areas
    share = np.zeros(len(motions))
    face = np.zeros(len(areas), dtype=bool)
    usual = _MANY_TIMES * float(np.median(size)) if len(size) else 0.0
    for index in np.argsort(size, kind="stable"):
        if size[index] > usual and face.any():
            known = float(areas[face].sum())
            share[index] = float(areas[face & flags[index]].sum()) / known if known > 0.0 else 0.0
        face |= flags[index]
    return share
