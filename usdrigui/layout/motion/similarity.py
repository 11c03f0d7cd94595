"""How alike the motions of controls are: in where they act, and in which way they go there."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from scipy.sparse import csr_array

from usdrigui.character import Floats, Indices, Record, Singles
from usdrigui.model import Motion, Trajectories
from usdrigui.ties import rounded

_ENTRIES = 12_000_000
"""Entries (controls times places) held at most: 150 MB; beyond, the places that move most represent
all."""


class DisplacementFields(Record):
    """What every control does at the places that any control moves, as one vector each."""

    places: Indices
    """(m,) points, one per place, ascending."""
    vectors: Singles
    """(motions, m, 3) from the minimum to the maximum of the control."""
    weights: Floats
    """(m,) area of the place: comparisons do not depend on how finely the mesh is divided."""

    def products(self, others: Singles | None = None) -> Floats:
        """(motions, motions) weighted inner products of `others` (default: the vectors) with the
        vectors."""
        first = self._sparse if others is None else csr_array(_rows(others))
        return inner_products(first, self._weighted)

    @cached_property
    def _sparse(self) -> csr_array:
        """(motions, 3 m) the vectors, row by row."""
        return csr_array(_rows(self.vectors))

    @cached_property
    def _weighted(self) -> csr_array:
        """(motions, 3 m) the same, each times the weight of its place."""
        return self._sparse.multiply(np.repeat(self.weights, 3)[None, :]).tocsr()

    def sizes(self) -> Floats:
        """(motions,) weighted squared norms of the vectors."""
        squared = np.einsum("cmi,cmi,m->c", self.vectors, self.vectors, self.weights)
        return np.asarray(squared)


class Similarity(Record):
    """Comparisons of all motions with each other; symmetric matrices (motions, motions)."""

    fields: DisplacementFields
    """What was compared."""
    norm: Floats
    """(motions,) root of the weighted squared displacement: how much a control moves."""
    cosine: Floats
    """Cosine of the motions as vectors over the whole surface: 1 parallel, -1 opposite."""
    shared: Floats
    """Cosine of the displacement lengths, in [0, 1]: 1 where both act on the same region alike."""

    @cached_property
    def direction(self) -> Floats:
        """Displacement-weighted cosine of the directions where both act; 0 where they share
        nothing."""
        return np.divide(
            self.cosine, self.shared, out=np.zeros_like(self.cosine), where=self.shared > 1e-6
        )


def displacement_fields(trajectories: Trajectories) -> DisplacementFields:
    """The displacement fields of all motions."""
    count = len(trajectories.surface.points)
    moved = np.zeros(count)
    for motion in trajectories.motions:
        moved[motion.points] += motion.arc_length / motion.arc_length.max(initial=1e-300)
    moved[~trajectories.surface.first] = 0.0
    places = _most_moved(moved, _ENTRIES // len(trajectories.motions))
    row = rows_of(places, count)
    vectors = np.zeros((len(trajectories.motions), len(places), 3), dtype=np.float32)
    for field, motion in zip(vectors, trajectories.motions, strict=True):
        at = row[motion.points]
        held = at >= 0
        field[at[held]] = motion.span[held]
    weights = trajectories.surface.areas[places]
    if not weights.any():
        weights = np.ones(len(places))
    return DisplacementFields(places, vectors, weights / float(weights.mean()))


def rows_of(places: Indices, count: int) -> Indices:
    """(count,) the place of each of `count` points among `places`, -1 where it is none of them."""
    row = np.full(count, -1, dtype=np.int64)
    row[places] = np.arange(len(places))
    return row


def similarity(fields: DisplacementFields) -> Similarity:
    """How alike the motions with these displacement fields are."""
    product = fields.products()
    norm = np.sqrt(np.maximum(np.diagonal(product), 1e-300))
    lengths = np.sqrt(np.einsum("cmi,cmi->cm", fields.vectors, fields.vectors))
    weighted = csr_array(lengths * fields.weights.astype(np.float32))
    both = inner_products(csr_array(lengths), weighted)
    scale = np.outer(norm, norm)
    return Similarity(fields, norm, product / scale, both / scale)


def bidirectional(motions: tuple[Motion, ...]) -> tuple[int, ...]:
    """Indices of the motions whose control goes to both sides of its base value."""
    return tuple(
        i
        for i, motion in enumerate(motions)
        if motion.offsets[0].any() and motion.offsets[-1].any()
    )


def inner_products(first: csr_array, second: csr_array) -> Floats:
    """(a, b) inner products of the rows of ``first`` (a, k) and ``second`` (b, k)."""
    return np.asarray((first @ second.T).toarray(), dtype=np.float64)


def _rows(vectors: Singles) -> Singles:
    """(motions, 3 m) of (motions, m, 3), of no places too."""
    return vectors.reshape(len(vectors), 3 * vectors.shape[1])


def _most_moved(moved: Floats, most: int) -> Indices:
    found = np.flatnonzero(moved > 0.0)
    if len(found) > most:
        found = np.sort(found[np.argsort(-rounded(moved[found]), kind="stable")[:most]])
    return found
