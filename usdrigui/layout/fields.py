"""The motions of all controls as one table of vectors: what comparisons between controls work on."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import csr_array

from usdrigui.model import Floats, Indices, Record, Singles, Trajectories

_MOST = 12_000_000
"""Entries (controls times places) held at most: 150 MB; beyond, the places that move most stand for all."""


@dataclass(frozen=True, eq=False)
class Fields(Record):
    """What every control does at the places that any control moves, as one vector each."""

    places: Indices
    """(m,) points, one per place, ascending."""
    vectors: Singles
    """(motions, m, 3) from the minimum to the maximum of the control."""
    weights: Floats
    """(m,) area of the place: comparisons do not depend on how finely the mesh is divided."""

    def products(self, others: Singles | None = None) -> Floats:
        """(motions, motions) weighted inner products of `others` (default: the vectors) with the vectors."""
        # Most controls leave most places alone: sparse products are several times faster than dense ones.
        first = self._sparse if others is None else csr_array(_rows(others))
        weighted = self._sparse.multiply(np.repeat(self.weights, 3)[None, :]).tocsr()
        return np.asarray((first @ weighted.T).toarray(), dtype=np.float64)

    @cached_property
    def _sparse(self) -> csr_array:
        """(motions, 3 m) the vectors, row by row."""
        return csr_array(_rows(self.vectors))

    def sizes(self) -> Floats:
        """(motions,) weighted squared norms of the vectors."""
        squared = np.einsum("cmi,cmi,m->c", self.vectors, self.vectors, self.weights)
        return np.asarray(squared, dtype=np.float64)


def motion_fields(trajectories: Trajectories, areas: Floats) -> Fields:
    """`Fields` of all motions; `areas` (n,) as from `surface.point_areas` over places."""
    count = len(trajectories.base)
    moved = np.zeros(count)
    for motion in trajectories.motions:
        moved[motion.points] += motion.arc_length / motion.arc_length.max(initial=1e-300)
    moved[trajectories.places != np.arange(count)] = 0.0
    places = _most_moved(moved, max(1, _MOST // max(1, len(trajectories.motions))))
    row = np.full(count, -1, dtype=np.int64)
    row[places] = np.arange(len(places))
    vectors = np.zeros((len(trajectories.motions), len(places), 3), dtype=np.float32)
    for field, motion in zip(vectors, trajectories.motions, strict=True):
        at = row[motion.points]
        held = at >= 0
        field[at[held]] = (motion.offsets[-1] - motion.offsets[0])[held]
    weights = areas[places]
    if not weights.any():
        weights = np.ones(len(places))
    return Fields(places, vectors, weights / max(float(weights.mean()), 1e-300))


def reversed_controls(trajectories: Trajectories) -> tuple[int, ...]:
    """Indices of the motions whose control goes to both sides of its base value."""
    return tuple(
        i for i, motion in enumerate(trajectories.motions) if motion.offsets[0].any() and motion.offsets[-1].any()
    )


def _rows(vectors: Singles) -> Singles:
    """(motions, 3 m) of (motions, m, 3), of no places too."""
    return vectors.reshape(len(vectors), 3 * vectors.shape[1])


def _most_moved(moved: Floats, most: int) -> Indices:
    found = np.flatnonzero(moved > 0.0)
    if len(found) > most:
        found = np.sort(found[np.argsort(-moved[found], kind="stable")[:most]])
    return found
