"""Where a point of an earlier version of a character is on that of today."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.character import Flags, Floats, Indices, Record, Rig
from usdrigui.layout.shares import HARDLY_ANY
from usdrigui.model import Anchor, Correction, Motion, Trajectories
from usdrigui.ties import first_smallest


def moved(motion: Motion) -> Flags:
    """(p,) which of its points a motion moves enough for its handle to be carried there."""
    return motion.arc_length >= HARDLY_ANY * motion.peak


class Today(Record):
    """A rig, its points and its motions."""

    rig: Rig
    points: Floats
    """(n, 3) in the pose in which places are compared."""
    trajectories: Trajectories

    def moved_by_all(self, controls: Sequence[str]) -> Indices:
        """Points that every one of these controls has `moved`; none where one of them moves
        nothing."""
        names = self.rig.control_names
        motions = {names[each.control]: each for each in self.trajectories.motions}
        found = np.arange(len(self.points))
        for name in controls:
            motion = motions.get(name)
            far = motion.points[moved(motion)] if motion is not None else found[:0]
            found = np.intersect1d(found, far)
        return found


def point_named(rig: Rig, hint: Anchor | Correction) -> int:
    """The point that an anchor names, or the one of this mesh and number; -1 where the mesh is gone
    or is known to have other points or faces."""
    point = rig.body.point_of(hint.mesh, hint.point)
    if point < 0 or isinstance(hint, Correction):
        return point
    mesh, _ = rig.body.mesh_of(point)
    return point if hint.fits(mesh.topology.hash) else -1


def carried(
    hint: Anchor | Correction,
    position: Sequence[float] | Floats,
    controls: Sequence[str],
    today: Today,
) -> tuple[int, float]:
    """The point of today's rig for one that lay at `position` (3,), and how far it is from there.

    That is the point that an anchor names, if the mesh is the same, else the nearest that all the
    controls move; of several as near the one that a correction names.  -1 where there is none.
    """
    places, same = today.moved_by_all(controls), point_named(today.rig, hint)
    if isinstance(hint, Anchor) and same >= 0 and same in places:
        return same, 0.0
    if not len(places) or not np.isfinite(position).all():
        return -1, np.inf
    apart = np.linalg.norm(today.points[places] - position, axis=1)
    nearest = first_smallest(apart)
    named = np.flatnonzero(places == same)
    if len(named) and apart[named[0]] <= apart[nearest] * (1.0 + 1e-3):
        nearest = int(named[0])
    return int(places[nearest]), float(apart[nearest])
