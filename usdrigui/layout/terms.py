"""Linear costs of anchoring a control at a point, besides displacement: one function each.

A term takes the `Context`, a motion and points that it moves, and returns one cost >= 0 per point in
the units of the objective (1 is about what the typical control loses with its whole displacement).
`linear_cost` adds them up; other packages add their own by the entry point group ``usdrigui.terms``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from usdrigui.layout.affinity import Affinity, affinity
from usdrigui.layout.extensions import user_linear_cost
from usdrigui.layout.fields import Fields, motion_fields, reversed_controls
from usdrigui.layout.handles import handle_width
from usdrigui.layout.precedent import NONE, Precedent
from usdrigui.layout.remarks import remarks
from usdrigui.layout.symmetry import plane_distance
from usdrigui.layout.verdicts import Verdict, verdicts
from usdrigui.layout.visibility import Views
from usdrigui.model import Floats, Indices, Layout, Motion, Rig, Symmetry, Trajectories
from usdrigui.settings import ControlSettings, Settings
from usdrigui.surface import mesh_triangles, point_areas

_MIDDLE = 1e-3
"""In handle widths: nearer to the mirror plane is on it."""
_TIE = 1e-5
"""What the character's right costs a symmetric element that stands off the plane: enough to decide between
two mirror images, nothing beside any other cost."""


@dataclass(frozen=True, eq=False)
class Context:
    """What a term may look at."""

    rig: Rig
    trajectories: Trajectories
    symmetry: Symmetry
    views: Views
    settings: Settings
    precedent: Precedent = NONE
    """An earlier layout that this one should be like."""
    standing: Layout | None = None
    """A layout that stays as it is, to which this one adds."""

    @cached_property
    def said(self) -> tuple[ControlSettings, ...]:
        """(controls,) what the configuration says about each control."""
        return remarks(self.rig, self.settings)

    @cached_property
    def areas(self) -> Floats:
        """(n,) area of the surface around each place; zero for points that are not the first of a place."""
        corners = mesh_triangles(self.rig.meshes)
        return point_areas(self.trajectories.base, corners, self.trajectories.places)

    @cached_property
    def fields(self) -> Fields:
        """The motions of all controls as one table."""
        return motion_fields(self.trajectories, self.areas)

    @cached_property
    def affinity(self) -> Affinity:
        """How alike the motions are."""
        return affinity(self.fields)

    @cached_property
    def both_ways(self) -> tuple[int, ...]:
        """Indices of the motions whose control goes to both sides of its base value."""
        return reversed_controls(self.trajectories)

    @cached_property
    def verdicts(self) -> tuple[Verdict, ...]:
        """(motions,) which controls do not belong on the face, and why."""
        return verdicts(self)

    @cached_property
    def handle_width(self) -> float:
        """Diameter of a handle in scene units."""
        return handle_width(self)


LinearTerm = Callable[[Context, Motion, Indices], Floats]


def linear_cost(context: Context, motion: Motion, points: Indices) -> Floats:
    """(p,) sum of all linear terms at `points`, which must be among the motion's points."""
    cost = np.zeros(len(points))
    for term in (occlusion, user_linear_cost):
        cost += term(context, motion, points)
    return cost


def occlusion(context: Context, motion: Motion, points: Indices) -> Floats:
    """Trajectories should run out of the surface, not into it (paper section 3.3, element-model occlusion).

    The price times (1 - t.n) / 2, with the unit tangent t at the base pose, pointing away from the
    anchor, and the normal n; the mean over both tangents where the anchor lies inside the range.
    """
    price = context.settings.candidates.occlusion_price
    rows = np.searchsorted(motion.points, points)
    normals = context.trajectories.normals[points]
    start = _base_knot(motion)
    cosines = []
    for neighbour in (start - 1, start + 1):
        if 0 <= neighbour < len(motion.values):
            step = motion.offsets[neighbour, rows].astype(np.float64)
            length = np.maximum(np.linalg.norm(step, axis=1), 1e-30)
            cosines.append(np.einsum("pi,pi->p", step, normals) / length)
    return np.asarray(price * 0.5 * (1.0 - np.mean(cosines, axis=0)), dtype=np.float64)


def off_plane(context: Context, points: Indices) -> Floats:
    """An element symmetric about the mirror plane should lie on it (paper section 3.3, symmetric
    deformations): the price times the distance in handle widths.  `layout_problem` counts from the
    nearest candidate, so that an element with none on the plane is not driven beside the face; of two mirror
    images it then takes the one on the character's left."""
    apart = plane_distance(context.trajectories.base[points], context.symmetry)
    price = context.settings.symmetry.plane_price * np.abs(apart) / context.handle_width
    return np.asarray(price + np.where(apart < -_MIDDLE * context.handle_width, _TIE, 0.0))


def _base_knot(motion: Motion) -> int:
    """Index of the knot at which the control stands at the base pose."""
    return int(np.argmin(np.abs(motion.offsets).sum(axis=(1, 2))))
