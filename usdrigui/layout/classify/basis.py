"""Which controls are atoms: a basis of the rig's motions, chosen all at once (beyond the paper).

Rigs hold controls that repeat what others do together: visemes, emotions, both-sided copies,
duplicates.  Whether one is a repetition depends on which others are taken for granted, so that a
judgement one by one contradicts itself (A is explained by B, and B by A).  The set of atoms is the
cheapest one that explains all other controls:

    minimise    sum_i p_i a_i                p_i: what it costs that control i is an atom
    subject to  a_i + sum_k e_ik >= 1        every control is an atom or has an explanation
                e_ik <= a_j   for j in P_ik  an explanation consists of atoms
                a_i + a_j <= 1               for controls that do the same, in whatever measure
                a_i  = a_t(i)                twins alike

Explanations P_ik are generated as they are needed: for the atoms of a solution, non-negative least
squares finds which controls they explain; where that is new, the program is solved again.
Explanations end at atoms, so that they form an acyclic graph of depth one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp, nnls
from scipy.sparse import coo_array

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.ties import rounded

PARALLEL = 0.98
"""Cosine of two motions from which one repeats the other."""
_PARALLEL_ATOMS = 0.995
"""The same where both are to be atoms in any case: a smile that parts the lips is another smile."""
EXPLAINED = 0.85
"""Share of a motion's energy that a sum of others must explain."""
_PARTS = 1.8
"""Effective number of parts from which a sum is one, and not one control with some noise."""
_LISTED = 0.1
"""Least weight, relative to the largest, of a part that an explanation names."""
_ALIKE = 0.05
"""Cosine from which another motion can be a part of a sum."""
_RIDGE = 1e-4
"""Keeps the products of nearly parallel motions invertible."""
_ROUNDS = 20
"""Solutions of the program; explanations end long before."""


@dataclass(frozen=True, eq=False)
class Explanation(Record):
    """A control as a sum of atoms."""

    parts: Indices
    """(p,) motions, the one with the largest weight first."""
    weights: Floats
    """(p,) how far each atom goes, in shares of its own motion's norm; > 0."""
    share: float
    """Of the control's energy that the sum explains."""


@dataclass(frozen=True, eq=False)
class Basis(Record):
    """The atoms of a rig, and what the others consist of."""

    atoms: Flags
    """(motions,)."""
    explanations: tuple[Explanation | None, ...]
    """(motions,) None for atoms."""


def choose_basis(
    cosine: Floats, costs: Floats, twins: Indices, pairs: Sequence[tuple[int, int]] = ()
) -> Basis:
    """The cheapest set of atoms that explains all other motions.

    `cosine` (m, m) of the motions as vectors over the surface; `costs` (m,) of being an atom,
    negative for those that are to be one in any case; `twins` (m,) the mirror motion of each,
    itself or -1; `pairs` of motions of which the first repeats the second although they are not
    parallel (steps of one shape).  Deterministic; where costs tie, the earlier motion is the atom.
    """
    known = [
        (i, Explanation(np.array([j]), np.ones(1), 1.0))
        for i, j in (*pairs, *_parallel(cosine, costs))
    ]
    # Controls that are on the face in any case explain first: beside them an atom that explains
    # dear ones may not be needed.
    known += _explained(costs, costs < 0.0, cosine)
    # Ties are broken by order, by less than any difference of costs that is meant.
    ranked = costs + 1e-7 * np.arange(len(costs))
    for _ in range(_ROUNDS):
        atoms = _cheapest(ranked, twins, known)
        new = [
            (i, each)
            for i, each in _explained(costs, atoms, cosine)
            if not _is_known(i, each, known)
        ]
        if not new:
            break
        known += new
    return Basis(
        atoms,
        tuple(
            None if atoms[i] else _explanation(i, atoms, cosine, known) for i in range(len(costs))
        ),
    )


def _explained(costs: Floats, atoms: Flags, cosine: Floats) -> list[tuple[int, Explanation]]:
    """The motions that need not be atoms and that these `atoms` (m,) explain."""
    return [
        (i, each)
        for i in np.flatnonzero(costs > 0.0).tolist()
        if (each := explain(i, atoms, cosine))
    ]


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
    order = order[weights[order] > _LISTED * weights.max()]
    return Explanation(parts[order], weights[order], share)


def least_squares(index: int, among: Flags, cosine: Floats) -> tuple[Indices, Floats, Floats]:
    """The other motions (k,) `among` (m,) that are like motion `index`, and the matrix (k, k) and
    vector (k,) of which |A w - b| is, but for a constant, the distance of the motion from the sum
    of these with weights w.

    |sum_j w_j f_j - f|^2 by way of the products: with L L' = T + ridge, it is a constant and
    |L' w - L^-1 t|^2.
    """
    parts = np.flatnonzero(among & (cosine[index] > _ALIKE))
    parts = parts[parts != index]
    root = np.linalg.cholesky(cosine[np.ix_(parts, parts)] + _RIDGE * np.eye(len(parts)))
    return parts, np.asarray(root.T), np.asarray(np.linalg.solve(root, cosine[parts, index]))


def _parallel(cosine: Floats, costs: Floats) -> list[tuple[int, int]]:
    """Ordered pairs of parallel motions: either may repeat the other."""
    atoms = np.outer(costs < 0.0, costs < 0.0)
    parallel = cosine > np.where(atoms, _PARALLEL_ATOMS, PARALLEL)
    np.fill_diagonal(parallel, val=False)
    return [(int(i), int(j)) for i, j in np.argwhere(parallel)]


def _cheapest(costs: Floats, twins: Indices, known: Sequence[tuple[int, Explanation]]) -> Flags:
    """(m,) atoms of the cheapest basis for the explanations that are `known`."""
    count, columns = len(costs), len(costs) + len(known)
    rows: list[tuple[dict[int, float], float, float]] = []
    for i in range(count):
        covers = {i: 1.0, **{count + k: 1.0 for k, (who, _) in enumerate(known) if who == i}}
        rows.append((covers, 1.0, np.inf))
        if i < twins[i] < count:
            rows.append(({i: 1.0, int(twins[i]): -1.0}, 0.0, 0.0))
    for k, (who, each) in enumerate(known):
        rows += [({count + k: 1.0, int(part): -1.0}, -np.inf, 0.0) for part in each.parts]
        if len(each.parts) == 1 and int(twins[who]) != int(each.parts[0]):
            rows.append(({who: 1.0, int(each.parts[0]): 1.0}, -np.inf, 1.0))
    entries = [(r, c, value) for r, (row, _, _) in enumerate(rows) for c, value in row.items()]
    r, c, values = zip(*entries, strict=True)
    indices = np.array([r, c], dtype=np.intc)  # the only ones that HiGHS takes from scipy 1.13
    table = coo_array((values, tuple(indices)), shape=(len(rows), columns)).tocsr()
    limits = LinearConstraint(table, [low for _, low, _ in rows], [high for _, _, high in rows])
    answer = milp(
        np.concatenate([costs, np.full(len(known), 1e-9)]),
        integrality=np.ones(columns),
        bounds=Bounds(0.0, 1.0),
        constraints=limits,
        options={"mip_rel_gap": 0.0},
    )
    if (
        answer.x is None
    ):  # Repetitions of repetitions may exclude each other's explanations: then all stay.
        return np.ones(count, dtype=bool)
    return np.asarray(answer.x[:count] > 0.5)


def _is_known(index: int, each: Explanation, known: Sequence[tuple[int, Explanation]]) -> bool:
    """Whether an explanation by some of these parts is among those known."""
    parts = set(each.parts.tolist())
    return any(who == index and set(other.parts.tolist()) <= parts for who, other in known)


def _explanation(
    index: int, atoms: Flags, cosine: Floats, known: Sequence[tuple[int, Explanation]]
) -> Explanation:
    """The explanation of a motion that is no atom: the first atom known that it repeats, or else
    the sum."""
    single = (
        each
        for who, each in known
        if who == index and len(each.parts) == 1 and atoms[each.parts[0]]
    )
    return next(single, None) or best_sum(index, atoms, cosine)
