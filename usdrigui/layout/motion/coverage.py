"""How much of the face a control moves, which separates local controls from global ones.

For a joint's control only the skin counts that the joint owns: a spine carries the head, and is not
a global control of the face.

The paper calls a control global when fewer than a tenth of the points move less than its own mean
(section 4.2), which almost never fires: even a rigid motion of the head leaves the neck behind.
Here the region that a control moves notably is measured against the regions of smaller controls.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.model import Motion
from usdrigui.ties import rounded

NOTABLE = 0.25
"""A control moves a point notably when by this share of its own peak."""
_MANY_TIMES = 2.5
"""A global control moves at least this many times the area of the median control."""


def notable_points(motions: Sequence[Motion], count: int) -> Flags:
    """(motions, count) which points each control moves notably."""
    flags = np.zeros((len(motions), count), dtype=bool)
    for row, motion in zip(flags, motions, strict=True):
        row[motion.points[motion.arc_length >= NOTABLE * motion.arc_length.max(initial=0.0)]] = True
    return flags


def shares_of_face(motions: Sequence[Motion], areas: Floats) -> Floats:
    """(motions,) share of the face that each control moves notably, weighed by `areas` (n,).

    The face is where controls of no more than the usual extent act: what whole-head controls move
    besides (neck, body) is none of it.
    """
    flags = notable_points([motion.on_own_skin() for motion in motions], len(areas))
    size = flags @ areas
    local = size <= _MANY_TIMES * float(np.median(size))
    face = np.where(flags[local].any(axis=0), areas, 0.0)
    total = float(face.sum())
    return flags @ face / total if total > 0.0 else np.zeros(len(motions))


def coverage_of_smaller(motions: Sequence[Motion], areas: Floats) -> Floats:
    """(motions,) share of the union of all smaller controls' regions that each control moves
    notably too.

    `areas` (n,) weighs the points.  Zero for a control whose region is no larger than usual in its
    rig: it takes several small controls to make a face that a large one can cover.
    """
    motions = [motion.on_own_skin() for motion in motions]
    flags = notable_points(motions, len(areas))
    size = flags @ areas
    share = np.zeros(len(motions))
    face = np.zeros(len(areas), dtype=bool)
    usual = _MANY_TIMES * float(np.median(size))
    for index in np.argsort(rounded(size), kind="stable"):
        known = float(areas[face].sum())
        if size[index] > usual and known > 0.0:
            share[index] = float(areas[_covered(motions[index], face, areas)].sum()) / known
        face |= flags[index]
    return share


def _covered(motion: Motion, face: Flags, areas: Floats) -> Indices:
    """Points of the face that a control moves notably, by its peak there.

    A shape of the whole head moves the back of it, or the shoulders, several times as far as the
    face: it moves the face evenly.  A control that hardly moves the face is
    measured by its own peak.
    """
    on_face = face[motion.points] & (areas[motion.points] > 0.0)
    here, own = motion.arc_length[on_face].max(initial=0.0), motion.arc_length.max()
    peak = here if here >= NOTABLE * own else own
    return np.asarray(
        motion.points[on_face & (motion.arc_length >= NOTABLE * peak)], dtype=np.int64
    )
