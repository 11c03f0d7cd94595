"""How points move under controls, and what mirrors what."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np

from usdrigui.character.record import Flags, Floats, Indices, Record, Singles
from usdrigui.character.rig import LeftOff
from usdrigui.errors import Issue

_STANDS = 0.75
"""A control of a joint is where the joint owns this share of the most that it owns anywhere."""
_OWN = 0.3
"""What a joint owns by this share of the most that it owns anywhere is its own skin."""


class BaseSurface(Record):
    """The surface of all meshes in the base pose."""

    points: Floats
    """(n, 3) in root space."""
    normals: Floats
    """(n, 3) unit, outward; zero where undefined."""
    places: Indices
    """(n,) index of the first point at the same position: points split at seams share one place."""
    areas: Floats
    """(n,) area of the surface around each place; zero for points that are not the first of a
    place."""
    face_size: float
    """Height along `Rig.up` of the region moved by the local controls: the unit of handle
    sizes."""

    @cached_property
    def first(self) -> Flags:
        """(n,) which points are the first of a place."""
        return np.asarray(self.places == np.arange(len(self.places)))

    def swept(self, motion: Motion) -> Floats:
        """(p,) area times distance at each point that a control moves."""
        return self.areas[motion.points] * motion.arc_length


class Trajectories(Record):
    """Trajectories of every point under every control, at the base pose."""

    surface: BaseSurface
    motions: tuple[Motion, ...]
    """One per control that moves something; others are left off."""
    excluded: tuple[Motion, ...]
    """Motions of `Rig.excluded`, whose `control` counts on behind `Rig.controls`: part of the
    yardstick for whole-face controls."""
    typical_length: float
    """Median over local controls of the largest arc length (design: l0), the unit of
    displacement."""
    left_off: tuple[LeftOff, ...]
    """Controls that move nothing."""
    issues: tuple[Issue, ...]
    """Of tiny and duplicate ones, which are kept."""

    @property
    def face_points(self) -> Indices:
        """Points that controls move notably."""
        moved = np.zeros(len(self.surface.points), dtype=bool)
        for motion in self.motions:
            moved[motion.points[motion.arc_length >= 0.5 * motion.arc_length.max()]] = True
        return np.flatnonzero(moved)

    @property
    def middle(self) -> Floats:
        """(3,) middle of the region that moves notably."""
        points = self.surface.points[self.face_points]
        return np.asarray(0.5 * (points.min(axis=0) + points.max(axis=0)))

    def motion_of(self, control: int) -> Motion:
        """The motion of a control, which must move something."""
        return next(each for each in self.motions if each.control == control)


class Motion(Record):
    """The trajectories of all points that one control moves (paper: d_j)."""

    control: int
    """Index into `Rig.controls`."""
    points: Indices
    """(p,) points that move, ascending."""
    values: Floats
    """(k,) ascending control values of the knots; includes minimum, default and maximum."""
    offsets: Singles
    """(k, p, 3) at each knot position minus base position, in root space; zero at the default."""
    arc_length: Floats
    """(p,) length of each trajectory from minimum to maximum."""
    owned: Floats | None = None
    """(p,) how much of each point the joint of the control owns, in [0, 1]; None where the control
    is where it moves most."""
    common: Floats | None = None
    """(p,) how common the displacement of each point is, from 0 (its own) to 1 (other controls make
    all of it as well); None where that does not count."""

    @property
    def span(self) -> Singles:
        """(p, 3) the way from the least value to the greatest."""
        return np.asarray(self.offsets[-1] - self.offsets[0])

    @property
    def of_joint(self) -> bool:
        """Whether it is that of a joint that owns skin."""
        return self.owned is not None

    @property
    def peak(self) -> float:
        """Largest arc length at the control's allowed places."""
        return float(self.arc_length[self.stands_on()].max(initial=0.0))

    def stands_on(self, among: Flags | None = None, share: float = _STANDS) -> Flags:
        """(p,) the control's allowed places: those that its joint owns most, by a
        `share` of the most, or all.

        `among` (p,) are the points that count; none of them is of the joint where its skin is
        hidden: then all may.
        """
        owned = self.owned
        among = np.ones(len(self.points), dtype=bool) if among is None else among
        if owned is None or not among.any() or float(owned[among].max()) <= 0.0:
            return among
        return among & (owned >= share * float(owned[among].max()))

    def missing(self, points: Indices) -> Floats:
        """(q,) the share that is missing at each of `points`, of those that move, of what the joint
        of the control owns where it may stand; zero for other controls."""
        if self.owned is None:
            return np.zeros(len(points))
        owned = self.owned[np.searchsorted(self.points, points)]
        return 1.0 - np.minimum(owned / max(_STANDS * float(owned.max()), 1e-300), 1.0)

    def on_own_skin(self) -> Motion:
        """The motion of the skin that the joint of the control owns, by how much it owns of each
        point, and so the same for every axis of the joint; the whole motion where no joint does."""
        owned = self.owned
        if owned is None:
            return self
        own = owned >= _OWN * float(owned.max(initial=0.0))
        return replace(self.of(own), arc_length=owned[own])

    def of(self, some: Flags) -> Motion:
        """The motion of `some` (p,) of its points."""
        return replace(
            self,
            points=self.points[some],
            offsets=self.offsets[:, some],
            arc_length=self.arc_length[some],
            owned=None if self.owned is None else self.owned[some],
            common=None if self.common is None else self.common[some],
        )


class MirrorPlane(Record):
    """The plane of symmetry."""

    origin: Floats
    """(3,) in root space."""
    normal: Floats
    """(3,) unit, points to the character's left; zero when there is no symmetry."""

    def distance(self, points: Floats) -> Floats:
        """(...) signed distance of `points` (..., 3) from the plane, positive on the character's
        left."""
        return np.asarray((points - self.origin) @ self.normal)

    def aside(self, copies: Floats) -> Floats:
        """(c,) how far on the left each copy of an element at `copies` (c, 3) is: one alone from
        the plane, a pair from the middle of both, as in a pose both may stand on one side."""
        apart = self.distance(copies)
        return apart - apart.mean() if len(copies) == 2 else apart

    def reflected(self, points: Floats) -> Floats:
        """(..., 3) mirror images of `points`."""
        return points - 2.0 * self.distance(points)[..., None] * self.normal

    def turned(self, directions: Floats) -> Floats:
        """(..., 3) mirror images of `directions`."""
        return directions - 2.0 * (directions @ self.normal)[..., None] * self.normal

    def projected(self, points: Floats) -> Floats:
        """(..., 3) nearest points of the plane; `points` themselves without one."""
        return points - self.distance(points)[..., None] * self.normal


class Symmetry(Record):
    """The mirror plane of the character and what it maps to what."""

    plane: MirrorPlane
    partner: Indices
    """(n,) nearest point to the mirror image; -1 where that lies beyond the tolerance and beyond
    three quarters of the spacing of points there."""
    apart: Floats
    """(n,) signed distance of each point from the plane, positive on the character's left, at the
    pose that mirrors: the middle of a trunk that is twisted at rest is no plane."""
    twins: Indices
    """(controls,) index of the twin control; its own index if self-symmetric; -1 if neither."""
    sources: tuple[str, ...]
    """(controls,) how each twin was decided: ``config``, ``geometry``, ``name`` or empty."""
    reversed: Flags
    """(controls,) True where the mirror image is the twin going the other way: one rises as the
    other falls."""
