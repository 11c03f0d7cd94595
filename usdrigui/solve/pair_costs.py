"""Pair costs of labels or blocks, kept up to date while blocks are split and discarded.

Only pairs that can come within the cutoff distance are held.  When a block is split, its
near pairs become pairs of its halves; only those are worked out anew.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import numpy as np
from scipy.sparse import coo_array, csr_array

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.model import ExtraPairs, LayoutProblem
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import CHUNK, LabelSet, meeting, pair_bounds


class NearPairs(Record):
    """Pairs of blocks of two sets of geometries that may interact."""

    sets: tuple[int, int]
    """Indices into `LabelSet.geometries`."""
    first: Indices
    """(q,) blocks; of an earlier variable than `second`."""
    second: Indices
    costs: Floats
    """(q,) lower bounds, +inf where forbidden."""


def near_blocks(
    problem: LayoutProblem, labels: LabelSet, budget: Budget, most: float = np.inf
) -> list[NearPairs] | None:
    """All pairs of blocks of different variables, visible together, that may interact; None where
    more than `most` are to be looked at."""
    pairs = np.triu(problem.together, 1)
    found = []
    for a, b in itertools.product(range(len(labels.geometries)), repeat=2):
        one, other = labels.geometries[a], labels.geometries[b]
        mine, theirs = labels.variable[one.owner], labels.variable[other.owner]
        rows = max(1, 8 * CHUNK // max(1, len(theirs)))
        pieces = []
        for low in range(0, len(mine), rows):
            later = int(np.searchsorted(theirs, mine[low], side="right"))
            i, j = np.ix_(range(low, min(low + rows, len(mine))), range(later, len(theirs)))
            near = np.argwhere(meeting(one, i, other, j, problem)) + np.array([low, later])
            at, columns = near[pairs[mine[near[:, 0]], theirs[near[:, 1]]]].T
            most -= len(at)
            if most < 0:
                return None
            budget.spend(len(at))
            pieces.append(_evaluated(problem, labels, (a, b), at, columns))
        found.append(_joined((a, b), pieces))
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
    child = np.zeros_like(children)
    child[parent[::-1]] = np.arange(len(parent))[::-1]
    kept = children == 1
    kept[parent[~same]] = False
    found = []
    for each in older:
        same = kept[each.first] & kept[each.second]
        first, second = child[each.first[same]], child[each.second[same]]
        pieces = [NearPairs(each.sets, first, second, each.costs[same])]
        one, other = (labels.geometries[at] for at in each.sets)
        for first, second in _parts(each.first[~same], each.second[~same], children, child):
            budget.spend(len(first))
            i, j = np.searchsorted(one.owner, first), np.searchsorted(other.owner, second)
            met = meeting(one, i, other, j, problem)
            pieces.append(_evaluated(problem, labels, each.sets, i[met], j[met]))
        found.append(_joined(each.sets, pieces))
    return found


def _parts(
    first: Indices, second: Indices, children: Indices, child: Indices
) -> Iterator[tuple[Indices, Indices]]:
    """All pairs of the parts of pairs of blocks, some at a time: `children` tells how many parts a
    block has, `child` the first."""
    times = children[first] * children[second]
    ends = np.flatnonzero(np.diff(np.cumsum(times) // (32 * CHUNK))) + 1
    for part in np.split(np.arange(len(times)), ends):
        source = np.repeat(part, times[part])
        step = np.arange(len(source)) - np.repeat(np.cumsum(times[part]) - times[part], times[part])
        few = children[second[source]]
        yield child[first[source]] + step // few, child[second[source]] + step % few


def _evaluated(
    problem: LayoutProblem, labels: LabelSet, sets: tuple[int, int], i: Indices, j: Indices
) -> NearPairs:
    """Bounds of pairs of members (q,) of two geometries; those beyond the cutoff distance are left
    out."""
    one, other = (labels.geometries[each] for each in sets)
    costs, near = pair_bounds(one, i, other, j, problem)
    return NearPairs(sets, one.owner[i[near]], other.owner[j[near]], costs[near])


def _joined(sets: tuple[int, int], pieces: list[NearPairs]) -> NearPairs:
    none = NearPairs(sets, np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64), np.empty(0))
    columns = ((each.first, each.second, each.costs) for each in [none, *pieces])
    return NearPairs(sets, *(np.concatenate(each) for each in zip(*columns, strict=True)))


# --- all pairs ------------------------------------------------------------------------------------


def pair_costs(
    problem: LayoutProblem, labels: LabelSet, near: Sequence[NearPairs] = ()
) -> csr_array:
    """(n, n) costs of the pairs that cost anything, each once, the label of the earlier variable
    first; +inf where forbidden.

    Explicit pair costs (`LayoutProblem.extra`) are added where both are single candidates; for
    blocks of several zero bounds them from below.
    """
    every = _joined((0, 0), [*near, *(_explicit(labels, each) for each in problem.extra)])
    count = len(labels.cost)
    found = coo_array((every.costs, (every.first, every.second)), shape=(count, count)).tocsr()
    found.eliminate_zeros()
    return found


def _explicit(labels: LabelSet, extra: ExtraPairs) -> NearPairs:
    """Labels that explicit costs speak of, and the costs."""
    first = _label(labels, extra.first, extra.first_labels)
    second = _label(labels, extra.second, extra.second_labels)
    known = (first >= 0) & (second >= 0)
    return NearPairs((0, 0), first[known], second[known], extra.costs[known])


def _label(labels: LabelSet, variable: int, candidates: Indices) -> Indices:
    """(q,) the variable's labels that are the single candidates, or -1."""
    mine = np.arange(labels.start[variable], labels.start[variable + 1])
    place = np.full(max(labels.candidate[mine].max(initial=0), candidates.max(initial=0)) + 1, -1)
    single = mine[labels.candidate[mine] >= 0]
    place[labels.candidate[single]] = single
    return place[candidates]
