"""Pair costs of labels or blocks, kept up to date while blocks are split and discarded.

Only pairs that can come within the cutoff distance are held.  When a block is split, its
near pairs become pairs of its halves; only those are worked out anew.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array

from usdrigui.model import ExtraPairs, Flags, Floats, Indices, LayoutProblem, Record
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import CHUNK, LabelSet, meeting, pair_bounds


@dataclass(frozen=True, eq=False)
class NearPairs(Record):
    """Pairs of blocks of two sets of geometries that may interact."""

    sets: tuple[int, int]
    """Indices into `LabelSet.geometries`."""
    first: Indices
    """(q,) blocks; of an earlier variable than `second`."""
    second: Indices
    costs: Floats
    """(q,) lower bounds, +inf where forbidden."""


def near_blocks(problem: LayoutProblem, labels: LabelSet, budget: Budget) -> list[NearPairs]:
    """All pairs of blocks of different variables, visible together, that may interact."""
    count = len(labels.start) - 1
    pairs = problem.together & np.triu(np.ones((count, count), dtype=bool), 1)
    found = []
    for a, one in enumerate(labels.geometries):
        for b, other in enumerate(labels.geometries):
            rows = max(1, 32 * CHUNK // len(other.owner))
            pieces = []
            for low in range(0, len(one.owner), rows):
                i, j = np.ix_(range(low, min(low + rows, len(one.owner))), range(len(other.owner)))
                near = meeting(one, i, other, j, problem)
                near &= pairs[labels.variable[one.owner[i]], labels.variable[other.owner[j]]]
                rows_at, columns = np.nonzero(near)
                first, second = one.owner[rows_at + low], other.owner[columns]
                pieces.append(_evaluated(problem, labels, (a, b), first, second, budget))
            found.append(_joined(pieces))
    return found


def refined(
    problem: LayoutProblem,
    labels: LabelSet,
    older: list[NearPairs],
    parent: Indices,
    same: Flags,
    budget: Budget,
) -> list[NearPairs]:
    """The near pairs after blocks were split or discarded; `parent` (n,) tells each block's old
    number.

    `same` (n,) tells for which blocks the costs of the old one will do: not for a single label that
    is left of several, whose costs must be exact.
    """
    ends = [each.max(initial=-1) for pairs in older for each in (pairs.first, pairs.second)]
    children = np.bincount(parent, minlength=int(max(ends, default=-1)) + 1)
    child = np.full(len(children), -1, dtype=np.int64)
    child[parent[::-1]] = np.arange(len(parent))[::-1]
    kept = children == 1
    kept[parent[~same]] = False
    return [_children(problem, labels, pairs, children, child, kept, budget) for pairs in older]


def _children(
    problem: LayoutProblem,
    labels: LabelSet,
    pairs: NearPairs,
    children: Indices,
    child: Indices,
    kept: Flags,
    budget: Budget,
) -> NearPairs:
    """The pairs of the parts of blocks: `children` tells how many each has, `child` the first."""
    few = children[pairs.second]
    same = kept[pairs.first] & kept[pairs.second]
    times = np.where(same, 0, children[pairs.first] * few)
    split = np.flatnonzero(times)
    old = NearPairs(
        pairs.sets, child[pairs.first[same]], child[pairs.second[same]], pairs.costs[same]
    )
    pieces = [old]
    for part in np.split(
        split, np.flatnonzero(np.diff(np.cumsum(times[split]) // (32 * CHUNK))) + 1
    ):
        source = np.repeat(part, times[part])
        step = np.arange(len(source)) - np.repeat(np.cumsum(times[part]) - times[part], times[part])
        first = child[pairs.first[source]] + step // few[source]
        second = child[pairs.second[source]] + step % few[source]
        pieces.append(_evaluated(problem, labels, pairs.sets, first, second, budget))
    return _joined(pieces)


def _evaluated(
    problem: LayoutProblem,
    labels: LabelSet,
    sets: tuple[int, int],
    first: Indices,
    second: Indices,
    budget: Budget,
) -> NearPairs:
    """Bounds of the pairs; those beyond the cutoff distance are left out."""
    one, other = (labels.geometries[each] for each in sets)
    i, j = np.searchsorted(one.owner, first), np.searchsorted(other.owner, second)
    budget.spend(len(i))
    close = np.flatnonzero(meeting(one, i, other, j, problem))
    costs, near = pair_bounds(one, i[close], other, j[close], problem)
    close = close[near]
    return NearPairs(sets, first[close], second[close], costs[near])


def _joined(pieces: list[NearPairs]) -> NearPairs:
    return NearPairs(
        pieces[0].sets,
        np.concatenate([each.first for each in pieces]),
        np.concatenate([each.second for each in pieces]),
        np.concatenate([each.costs for each in pieces]),
    )


# --- all pairs ------------------------------------------------------------------------------------


def pair_costs(
    problem: LayoutProblem, labels: LabelSet, near: Sequence[NearPairs] = ()
) -> csr_array:
    """(n, n) costs of the pairs that cost anything, each once, the label of the earlier variable
    first; +inf where forbidden.

    Explicit pair costs (`LayoutProblem.extra`) are added where both are single candidates; for
    blocks of several zero bounds them from below.
    """
    pieces = [(each.first, each.second, each.costs) for each in near]
    pieces += [_explicit(labels, each) for each in problem.extra]
    none = np.empty(0, dtype=np.int64)
    first = np.concatenate([none, *(each for each, _, _ in pieces)])
    second = np.concatenate([none, *(each for _, each, _ in pieces)])
    costs = np.concatenate([np.empty(0), *(each for _, _, each in pieces)])
    count = len(labels.cost)
    found = coo_array((costs, (first, second)), shape=(count, count)).tocsr()
    found.eliminate_zeros()
    return found


def _explicit(labels: LabelSet, extra: ExtraPairs) -> tuple[Indices, Indices, Floats]:
    """Labels that explicit costs speak of, and the costs."""
    first = _label(labels, extra.first, extra.first_labels)
    second = _label(labels, extra.second, extra.second_labels)
    known = (first >= 0) & (second >= 0)
    return first[known], second[known], extra.costs[known]


def _label(labels: LabelSet, variable: int, candidates: Indices) -> Indices:
    """(q,) the variable's labels that are the single candidates, or -1."""
    mine = np.arange(labels.start[variable], labels.start[variable + 1])
    place = np.full(max(labels.candidate[mine].max(initial=0), candidates.max(initial=0)) + 1, -1)
    single = mine[labels.candidate[mine] >= 0]
    place[labels.candidate[single]] = single
    return place[candidates]
