"""Linear costs of anchoring a control at a point, besides displacement: one function each.

A term gives one cost >= 0 per point in the units of the objective (1 is about what the typical
control loses with its whole displacement).  `linear_cost` adds them up; other packages add their
own by the entry point group ``usdrigui.terms``.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.layout.face import Face
from usdrigui.layout.place.extensions import user_linear_cost
from usdrigui.layout.shares import NOTHING
from usdrigui.layout.symmetry.lobes import ON_PLANE
from usdrigui.model import Motion
from usdrigui.settings import ObjectiveSettings, Settings

_TIE = 1e-5
"""What the character's right costs a symmetric element that stands off the plane: enough to decide
between two mirror images, negligible against any other cost."""

_BESIDE = 0.5
"""What it costs a joint's element that it stands beside the plane: more than its place there gains
in displacement, less than leaving the character."""


def linear_cost(face: Face, motion: Motion, points: Indices, settings: Settings) -> Floats:
    """(p,) sum of all linear terms at `points`, which must be among the motion's points."""
    weight, objective = settings.candidates.occlusion_weight, settings.objective
    own = occlusion(face.surface.normals, motion, points, weight)
    # A joint's control stands where the joint owns the skin, or pays for the share that is missing.
    own = own + common(face, motion, points, objective) + motion.missing(points)
    return own + user_linear_cost(face, motion, points, objective.terms)


def occlusion(normals: Floats, motion: Motion, points: Indices, weight: float) -> Floats:
    """(p,) Trajectories should run out of the surface, not into it (paper section 3.3,
    element-model occlusion).

    The weight times (1 - t.n) / 2, with the unit tangent t at the base pose, pointing away from the
    anchor, and the normal n out of `normals` (n, 3); the mean over both tangents where the anchor
    lies inside the range.
    """
    rows = np.searchsorted(motion.points, points)
    start = int(np.argmin(np.abs(motion.offsets).sum(axis=(1, 2))))  # the knot of the base pose
    cosines = []
    for neighbour in (start - 1, start + 1):
        if 0 <= neighbour < len(motion.values):
            step = motion.offsets[neighbour, rows].astype(np.float64)
            length = np.maximum(np.linalg.norm(step, axis=1), 1e-30)
            cosines.append(np.einsum("pi,pi->p", step, normals[points]) / length)
    return np.asarray(weight * 0.5 * (1.0 - np.mean(cosines, axis=0)))


def common(face: Face, motion: Motion, points: Indices, objective: ObjectiveSettings) -> Floats:
    """(p,) A control should stand where its motion is large and its own: the weight times the
    displacement, by how common that is (`usdrigui.layout.classify.common_motion`)."""
    if motion.common is None:
        return np.zeros(len(points))
    rows = np.searchsorted(motion.points, points)
    unit = displacement_unit(face, motion, objective)
    return objective.distinctive_weight * motion.common[rows] * motion.arc_length[rows] / unit


def displacement_unit(face: Face, motion: Motion, objective: ObjectiveSettings) -> float:
    """Length that counts as a displacement of one: between the rig's typical peak and the control's
    own."""
    if objective.scene_units:
        return 1.0
    share = objective.relative_displacement
    return float(face.trajectories.typical_length ** (1.0 - share) * motion.peak**share)


def off_plane(face: Face, points: Indices, weight: float, *, of_joint: bool) -> Floats:
    """(p,) An element symmetric about the mirror plane should lie on it (paper section 3.3,
    symmetric deformations): the weight times the distance in handle widths, counted from the
    nearest of `points`, so that an element with none on the plane is not driven off the face; of
    two mirror images it then takes the one on the character's left.  An element of a joint, which
    moves its own skin much alike, is more firmly held to the plane."""
    apart = face.symmetry.apart[points] / face.handle_width
    cost = weight * np.abs(apart) + np.where(apart < -NOTHING, _TIE, 0.0)
    if of_joint and weight:
        cost += _BESIDE * (np.abs(apart) > ON_PLANE)
    cost -= cost.min(initial=np.inf)
    return cost
