"""The character's mirror plane, and what it maps to what (paper section 3.3, symmetric elements).

The plane is found from the geometry, not assumed: candidate planes through the middle of the moving
region are scored by how well its mirror image meets the surface, the best is refined by fitting a
reflection to pairs of nearest points, and the far pairs (hair, clothes) are trimmed away.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.character import Flags, Floats, Indices, Record, Rig
from usdrigui.character.rays import AROUND
from usdrigui.layout.motion.trajectory import total_motion
from usdrigui.layout.shares import HARDLY_ANY, MOST, NEARLY_ALL, NOTHING, OUTLIER, SAMPLE
from usdrigui.layout.symmetry.front import moving_normals
from usdrigui.layout.symmetry.sides_of_joints import plane_of_names
from usdrigui.model import MirrorPlane, Trajectories
from usdrigui.settings import Settings
from usdrigui.ties import rounded, towards

_THINNED = 8
"""Of so many points of the sample one is looked at to choose among candidate planes."""
_FINALISTS = 6
"""Candidate planes that are fitted to an end, at least: all of them take four times as long."""
_TRIM = 0.7
"""Share of the pairs, the nearest ones, that a fit believes."""
_ACROSS_ALL = [way for way in AROUND if tuple(way) > (0.0, 0.0, 0.0)]
"""One of either direction along the axes and between them."""


def mirrored(
    rig: Rig, trajectories: Trajectories, settings: Settings
) -> tuple[MirrorPlane, Indices]:
    """Mirror plane of `rig`, and for every point (n,) the one nearest to its mirror image, or -1.

    The normal points to the character's left.  Where less than half of the moving region has a
    mirror image within ``symmetry.tolerance`` there is no symmetry: normal zero, partners -1.
    """
    mirror = settings.symmetry
    tolerance = mirror.tolerance * trajectories.surface.face_size
    plane = named = None
    if mirror.enabled and trajectories.motions:
        named = plane_of_names(rig.body)
        plane = _best(trajectories, tolerance, rig.up)
        # A robot may be as symmetric from front to back, one arm in a pose as the other.
        if named and not (plane and abs(named.normal @ plane.normal) >= NEARLY_ALL):
            plane = named
    if plane is None:
        return MirrorPlane(np.zeros(3), np.zeros(3)), np.full_like(trajectories.surface.places, -1)
    plane = _towards_left(plane, named, rig.up, trajectories)
    plane = replace(plane, origin=plane.projected(trajectories.surface.points.mean(axis=0)))
    return plane, _partners(plane, trajectories, tolerance)


# --- the plane ------------------------------------------------------------------------------------


def _best(trajectories: Trajectories, tolerance: float, up: Floats) -> MirrorPlane | None:
    """The best mirror plane of what the rig moves; None where that is next to nothing, or has
    none."""
    region, weights = _moving_region(trajectories)
    if len(region) < 4:
        return None
    # All places, not only those that move: a control of one side must not tilt the plane.
    places = trajectories.surface.points[np.unique(trajectories.surface.places)]
    sample = _thinned(region, weights)
    return _Search(tolerance, (region, weights), cKDTree(places), sample).best(up)


def _thinned(points: Floats, weights: Floats) -> Floats:
    """Fewer than twice `SAMPLE` of the points, evenly from the heaviest, in any order of them."""
    heaviest = np.lexsort((*rounded(points).T, -rounded(weights)))[: 4 * SAMPLE]
    return points[heaviest[:: max(1, len(heaviest) // SAMPLE)]]


def _moving_region(trajectories: Trajectories) -> tuple[Floats, Floats]:
    """Places (p, 3) that the rig moves, and their weights: area, so that dense regions do not
    prevail, times how many controls move them, so that the face prevails over what only a few
    controls move.
    """
    surface, count = trajectories.surface, len(trajectories.surface.points)
    moved = np.zeros(count)
    for motion in trajectories.motions:
        moved[motion.points] += np.minimum(motion.arc_length / motion.arc_length.mean(), 1.0)
    used = (surface.areas > 0.0) & (moved > 0.0)
    usual = float(np.median(surface.areas[used])) if used.any() else 0.0
    # A few huge faces (cards, cloth) must not drag the middle to themselves.
    weights = np.minimum(surface.areas, OUTLIER * usual) * moved
    chosen = np.flatnonzero(weights > 0.0)
    if not len(chosen):
        chosen = np.flatnonzero(surface.first & (moved > 0.0))
        weights = moved
    return surface.points[chosen], weights[chosen]


class _Search(Record):
    """Candidate planes, compared on a sample of what the rig moves."""

    tolerance: float
    region: tuple[Floats, Floats]
    """As of `_moving_region`."""
    tree: cKDTree
    """Of all places of the surface."""
    sample: Floats
    """(p, 3) of the region."""

    def best(self, up: Floats) -> MirrorPlane | None:
        """The best mirror plane, or None where the character has none."""
        rough = replace(self, sample=self.sample[::_THINNED])
        starts = [rough.fitted(plane, 2) for plane in self._starts()]
        finalists = [rough.fitted(plane, 12) for plane in rough.ranked(starts)[0]]
        best, equal = self.ranked(finalists)
        # Nearest points lead astray where a plane starts far from the true one.
        whole = self._whole(best[:equal]) or self._whole(best[equal:])
        # Of those that fit alike (a face as symmetric upside down) the most upright one, and of
        # these (a regular grid) the one that mirrors most.
        return min(whole, key=lambda plane: round(abs(float(plane.normal @ up)), 3), default=None)

    def _whole(self, planes: list[MirrorPlane]) -> list[MirrorPlane]:
        """The planes, fitted to an end, that mirror most of the sample to places of the surface,
        the one that mirrors most first."""
        found = self._distinct(self._polished(self.fitted(plane, 60)) for plane in planes)
        # Of the sample, the share whose mirror image meets a place of the surface.
        met = [self._apart(plane)[0] <= self.tolerance for plane in found]
        shares = np.round([each.mean() for each in met], 3)
        best = np.argsort(-shares, kind="stable")
        return [found[i] for i in best if shares[i] >= MOST]

    def ranked(self, planes: list[MirrorPlane]) -> tuple[list[MirrorPlane], int]:
        """The distinct planes, the best first: those that fit as well as the best, of which the
        number is told, and no fewer than the finalists."""
        misfits = {id(plane): self._misfit(plane) for plane in planes}
        slack = HARDLY_ANY * self.tolerance
        order = sorted(planes, key=lambda plane: round(misfits[id(plane)] / slack, 3))
        distinct = self._distinct(order)
        equal = sum(misfits[id(plane)] <= misfits[id(order[0])] + slack for plane in distinct)
        return distinct[: max(_FINALISTS, equal)], equal

    def _starts(self) -> Iterator[MirrorPlane]:
        """Candidate planes in all directions, for heads tilt and lie, and along the principal axes:
        through the moving region, and through the middle of the whole character, where a mesh
        modelled symmetric has it."""
        (region, weights), every = self.region, self.tree.data
        for normal in (*_ACROSS_ALL, *_principal(region, weights)):
            along = region @ normal
            order = np.argsort(rounded(along), kind="stable")
            share = np.cumsum(weights[order]) / weights.sum()
            # Hair on one side, of no more than the share that no fit believes, moves the middle.
            for level in (1.0 - _TRIM, MOST, _TRIM):
                yield MirrorPlane(region[order[np.searchsorted(share, level)]], normal)
        for normal in (*_ACROSS_ALL, *_principal(every, np.ones(len(every)))):
            yield MirrorPlane(every.mean(axis=0), normal)

    def _apart(self, plane: MirrorPlane) -> tuple[Floats, Indices]:
        """(p,) distance of the mirror image of each point of the sample from the nearest place, and
        that place."""
        apart, nearest = self.tree.query(plane.reflected(self.sample))
        return apart, nearest

    def _misfit(self, plane: MirrorPlane) -> float:
        """Trimmed mean distance of the mirror image from the surface's points."""
        apart = np.sort(self._apart(plane)[0])
        return float(apart[: max(1, int(_TRIM * len(apart)))].mean())

    def fitted(self, plane: MirrorPlane, rounds: int) -> MirrorPlane:
        """Alternate between nearest pairs and the reflection that fits them best, until it
        settles."""
        last = int(_TRIM * (len(self.sample) - 1))
        for _ in range(rounds):
            apart, nearest = self._apart(plane)
            near = apart <= np.partition(apart, last)[last]
            found = _between(self.sample[near], self.tree.data[nearest[near]], plane)
            if np.abs(found.normal - plane.normal).max() < 1e-12:
                return found
            plane = found
        return plane

    def _polished(self, plane: MirrorPlane) -> MirrorPlane:
        """Fit again to the pairs that meet almost exactly, where the mesh was modelled
        symmetric."""
        for share in (1.0, 0.1, 0.01, 0.001):
            apart, nearest = self._apart(plane)
            near = apart <= share * self.tolerance
            if near.mean() < 0.2:
                break
            plane = _between(self.sample[near], self.tree.data[nearest[near]], plane)
        return plane

    def _distinct(self, planes: Iterable[MirrorPlane]) -> list[MirrorPlane]:
        """The first of all planes that mirror the sample to the same places, as good as; none that
        leaves it where it is, as that of a flat sheet."""
        kept, images = list[MirrorPlane](), [self.sample]
        for plane in planes:
            image = plane.reflected(self.sample)
            if all(np.abs(image - other).max() > HARDLY_ANY * self.tolerance for other in images):
                kept.append(plane)
                images.append(image)
        return kept


def _principal(points: Floats, weights: Floats) -> list[Floats]:
    """The principal axes of weighted points."""
    centred = points - np.average(points, axis=0, weights=weights)
    return [*np.linalg.eigh((centred * weights[:, None]).T @ centred)[1].T]


def _between(points: Floats, images: Floats, before: MirrorPlane) -> MirrorPlane:
    """The plane whose reflection brings `points` nearest to `images` in the least-squares sense.

    With both centred, the squared misfit of normal n is a constant plus 4 (p . n)(q . n): the
    normal is the eigenvector of least eigenvalue of the symmetric part of sum p q^T.
    """
    a, b = points.mean(axis=0), images.mean(axis=0)
    product = (points - a).T @ (images - b)
    normal = towards(np.linalg.eigh(product + product.T)[1][:, 0], before.normal)
    return MirrorPlane(0.5 * (a + b), normal)


def _towards_left(
    plane: MirrorPlane, named: MirrorPlane | None, up: Floats, trajectories: Trajectories
) -> MirrorPlane:
    """The plane with its normal to the character's left.

    What controls of skin move faces ahead.  The skin that a joint turns lies all around it: where
    that of skin faces no way clearly, the names of the joints decide.
    """
    skin = tuple(motion for motion in trajectories.motions if not motion.of_joint)
    left = np.cross(up, moving_normals(replace(trajectories, motions=skin)))
    # Faces have .19 to .5, the pieces of a robot and a head of thin sheets .01 to .04.
    if abs(plane.normal @ left) <= HARDLY_ANY * len(skin):
        every = np.cross(up, moving_normals(trajectories))
        left = every if named is None else named.normal
    return replace(plane, normal=towards(plane.normal, left))


# --- points ---------------------------------------------------------------------------------------


def _partners(plane: MirrorPlane, trajectories: Trajectories, tolerance: float) -> Indices:
    """For every point the place nearest to its mirror image; -1 where that lies beyond the
    tolerance."""
    base, places = trajectories.surface.points, trajectories.surface.places
    chosen = np.flatnonzero(trajectories.surface.first)
    motion = total_motion(trajectories.motions, len(base)).astype(np.float64)
    # Motion decides only between points that nearly touch, as closed lips do.
    unit = NOTHING * trajectories.surface.face_size / (float(np.abs(motion).max()) or 1.0)
    tree = cKDTree(np.hstack([base[chosen], unit * motion[chosen]]))
    _, nearest = tree.query(
        np.hstack([plane.reflected(base[chosen]), unit * plane.turned(motion[chosen])])
    )
    partner = np.full(len(base), -1, dtype=np.int64)
    apart = np.linalg.norm(plane.reflected(base[chosen]) - base[chosen[nearest]], axis=1)
    near: Flags = apart <= tolerance
    partner[chosen[near]] = chosen[nearest[near]]
    return partner[places]
