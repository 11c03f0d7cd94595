"""Which controls are atoms: a basis of the rig's motions, chosen all at once (beyond the paper).

Rigs hold controls that repeat what others do together: visemes, emotions, both-sided copies,
duplicates.  Whether one is a repetition depends on which others are taken for granted, so that a
judgement one by one contradicts itself (A is explained by B, and B by A).  At first all are atoms.
The dearest goes first: a control, with its twin, is an atom no more if those that are left explain
it and all that it helped to explain.  So explanations end at atoms, and none of the atoms that may
go can.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.optimize import nnls

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.layout.shares import HARDLY_ANY
from usdrigui.ties import rounded

PARALLEL = 0.99
"""Cosine of two motions from which one repeats the other: a smile that parts the lips is another
smile."""
EXPLAINED = 0.92
"""Share of a motion's energy that a sum of others must explain: what was mixed from others is
nearly all explained, and nine tenths of any shape of a mouth are where a rig has dozens."""
_PARTS = 1.8
"""Effective number of parts from which a sum is one, and not one control with some noise."""
_RIDGE = 1e-4
"""Keeps the products of nearly parallel motions invertible."""


class Explanation(Record):
    """A control as a sum of atoms."""

    parts: Indices
    """(p,) motions, the one with the largest weight first."""
    weights: Floats
    """(p,) how far each atom goes, in shares of its own motion's norm; > 0."""
    share: float
    """Of the control's energy that the sum explains."""


class Basis(Record):
    """The atoms of a rig, and what the others consist of."""

    atoms: Flags
    """(motions,)."""
    explanations: Mapping[int, Explanation]
    """Of every other motion."""


def choose_basis(cosine: Floats, costs: Floats, twins: Indices) -> Basis:
    """A cheap set of atoms that explains all other motions.

    `cosine` (m, m) of the motions as vectors over the surface; `costs` (m,) of being an atom,
    0 or less for those that are to be one in any case; `twins` (m,) the mirror motion of each,
    itself or -1.  Where costs tie, the earlier motion is the atom.
    """
    atoms = np.ones(len(costs), dtype=bool)
    found: dict[int, Explanation] = {}
    for i in sorted(range(len(costs)), key=lambda motion: (-costs[motion], -motion)):
        pair = {i, int(twins[i])} - {-1}
        rest = atoms.copy()
        rest[list(pair)] = False
        helped = {k for k, explained in found.items() if pair & set(explained.parts.tolist())}
        again = {k: _explanation(k, rest, cosine, costs) for k in pair | helped if rest.any()}
        if again and all(again.values()):
            atoms = rest
            found |= {k: explained for k, explained in again.items() if explained is not None}
    return Basis(atoms, found)


def _explanation(index: int, atoms: Flags, cosine: Floats, costs: Floats) -> Explanation | None:
    """A motion as the first atom that it repeats, or as a sum of several."""
    parallel = atoms & (cosine[index] > PARALLEL)
    if parallel.any():
        return Explanation(np.flatnonzero(parallel)[:1], np.ones(1), 1.0)
    return explain(index, atoms, cosine) if costs[index] > 0.0 else None


def explain(index: int, atoms: Flags, cosine: Floats) -> Explanation | None:
    """Motion `index` as a non-negative sum of the other `atoms` (m,); None where none of them
    explains enough."""
    found = best_sum(index, atoms, cosine)
    squares = np.square(found.weights)
    effective = float(squares.sum() ** 2 / max(float(np.square(squares).sum()), 1e-300))
    return found if found.share >= EXPLAINED and effective >= _PARTS else None


def best_sum(index: int, atoms: Flags, cosine: Floats) -> Explanation:
    """The non-negative sum of the other `atoms` (m,) nearest to motion `index`, in the norm of the
    motions."""
    parts, matrix, wanted = least_squares(index, atoms, cosine)
    if not len(parts):
        return Explanation(parts, np.zeros(0), 0.0)
    table, target = cosine[np.ix_(parts, parts)], cosine[parts, index]
    try:
        weights, _ = nnls(matrix, wanted)
    except RuntimeError:  # Too many steps: no few of them explain it.
        return Explanation(parts[:0], np.zeros(0), 0.0)
    share = float(2.0 * weights @ target - weights @ table @ weights)
    order = np.argsort(-rounded(weights), kind="stable")
    order = order[weights[order] > HARDLY_ANY * weights.max()]
    return Explanation(parts[order], weights[order], share)


def least_squares(index: int, among: Flags, cosine: Floats) -> tuple[Indices, Floats, Floats]:
    """The other motions (k,) `among` (m,) that are like motion `index`, and the matrix (k, k) and
    vector (k,) of which |A w - b| is, but for a constant, the distance of the motion from the sum
    of these with weights w.

    |sum_j w_j f_j - f|^2 by way of the products: with L L' = T + ridge, it is a constant and
    |L' w - L^-1 t|^2.
    """
    parts = np.flatnonzero(among & (cosine[index] > 0.0))
    parts = parts[parts != index]
    root = np.linalg.cholesky(cosine[np.ix_(parts, parts)] + _RIDGE * np.eye(len(parts)))
    return parts, np.asarray(root.T), np.asarray(np.linalg.solve(root, cosine[parts, index]))
