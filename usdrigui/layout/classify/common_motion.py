"""How much of what a control does at a point other controls do as well: what is not its own (beyond
the paper).

A sneer that lifts the brow more than the nose has its peak on the brow, where it does what the
brow's controls do.  The displacement field f_i of a control is compared with the best sum of the
others, none far beyond its own range:

    minimise |f_i - sum_k w_k f_k|    0 <= w_k <= R

Where the residual is small, the motion is not the control's own; where it is as large as the
motion, nobody else does it.  Unlike shares of displacement at each point, the sum is one for the
whole face: controls that cross in one place by chance take nothing from each other.  Counted is
what goes beyond a half, and beyond the share at the most distinctive place: in a crowd of like
controls all of a motion is common, and displacement decides as before.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import lsq_linear

from usdrigui.character import Flags, Floats, Indices
from usdrigui.layout.classify.basis import least_squares
from usdrigui.layout.motion.similarity import Similarity, rows_of
from usdrigui.layout.shares import MOST
from usdrigui.model import Trajectories
from usdrigui.ties import first_largest, steady

_RANGE = 2.0
"""Times its own range that another control may go in the sum: a tiny control scaled up explains
anything."""


def with_common_motion(
    trajectories: Trajectories, similarity: Similarity, on_face: Flags, visible: Flags
) -> Trajectories:
    """The trajectories whose motions know how common they are.

    `on_face` (motions,) are the controls of the face: only they are placed, and
    only they are others; `visible` (n,) are the points that some view sees.  A control whose joint
    owns skin stands there; it is left out.
    """
    row = rows_of(similarity.fields.places, len(trajectories.surface.points))
    motions = list(trajectories.motions)
    for index in np.flatnonzero(on_face).tolist():
        motion = motions[index]
        if not motion.of_joint:
            at = row[trajectories.surface.places[motion.points]]
            share = np.ones(len(at))
            share[at >= 0] = _shares(similarity, index, on_face, at[at >= 0])
            common = _beyond_the_best(share, motion.arc_length, visible[motion.points])
            motions[index] = replace(motion, common=common)
    return replace(trajectories, motions=tuple(motions))


def _beyond_the_best(share: Floats, length: Floats, visible: Flags) -> Floats:
    """(p,) by how much each share is above a half, and above that of the most distinctive of the
    the control's allowed places; 1 where all is common."""
    seen = length * (visible if visible.any() else 1.0)
    own = np.where(seen >= MOST * seen.max(initial=0.0), seen * (1.0 - share), -1.0)
    return np.maximum(share - max(float(share[first_largest(own)]), MOST), 0.0) / (1.0 - MOST)


def _shares(similarity: Similarity, index: int, on_face: Flags, at: Indices) -> Floats:
    """(a,) the shares of motion `index` at the rows `at` (a,) of the fields."""
    own = similarity.fields.vectors[index, at].astype(np.float64)
    parts, weights = _sum_of_others(similarity, index, on_face)
    rest = own - np.einsum("k,kai->ai", weights, similarity.fields.vectors[np.ix_(parts, at)])
    length = np.maximum(np.linalg.norm(own, axis=1), 1e-300)
    return steady(1.0 - np.minimum(np.linalg.norm(rest, axis=1) / length, 1.0))


def _sum_of_others(similarity: Similarity, index: int, on_face: Flags) -> tuple[Indices, Floats]:
    """Motions (k,) and how far each goes, in its own range, in the sum nearest to motion
    `index`."""
    cosine, norm = similarity.cosine, similarity.norm
    parts, matrix, wanted = least_squares(index, on_face, cosine)
    if not len(parts):
        return parts, np.zeros(0)
    most = _RANGE * norm[parts] / norm[index]
    answer = lsq_linear(matrix, wanted, bounds=(0.0, most), method="bvls")
    weights = answer.x * norm[index] / norm[parts]
    used = weights > 0.0
    return parts[used], weights[used]
