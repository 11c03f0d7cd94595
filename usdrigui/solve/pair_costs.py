"""Pair costs of blocks of candidates, kept up to date while blocks are split and discarded.

Only pairs that can come within the reach of the overlap cost are held.  When a block is split, its
near pairs become pairs of its halves; only those are worked out anew.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.model import ExtraPairs, Flags, Floats, Indices, LayoutProblem, Record
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import LabelGeometry, LabelSet, near_pairs, pair_bounds

AT_ONCE = 1_000_000
"""Distances between geometries held at a time."""


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


def near_blocks(problem: LayoutProblem, label_set: LabelSet, budget: Budget) -> list[NearPairs]:
    """All pairs of blocks of different variables, visible together, that may interact."""
    found = []
    for a, one in enumerate(label_set.geometries):
        for b, other in enumerate(label_set.geometries):
            i, j = _near(problem, one, other)
            first, second = one.owner[i], other.owner[j]
            apart = label_set.variable[first] < label_set.variable[second]
            apart &= problem.together[label_set.variable[first], label_set.variable[second]]
            found.append(
                _evaluated(problem, label_set, (a, b), first[apart], second[apart], budget)
            )
    return found


def _near(
    problem: LayoutProblem, one: LabelGeometry, other: LabelGeometry
) -> tuple[Indices, Indices]:
    """Pairs of geometries that may interact, found a few rows at a time."""
    rows = max(1, AT_ONCE // max(len(other.owner), 1))
    pieces = [
        near_pairs(
            one,
            slice(at, min(at + rows, len(one.owner))),
            other,
            problem.overlap.reach,
            problem.separation,
        )
        for at in range(0, len(one.owner), rows)
    ]
    none = np.empty(0, dtype=np.int64)
    return np.concatenate([none, *(i for i, _ in pieces)]), np.concatenate(
        [none, *(j for _, j in pieces)]
    )


def refined(
    problem: LayoutProblem,
    label_set: LabelSet,
    older: list[NearPairs],
    parent: Indices,
    budget: Budget,
    same: Flags,
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
    return [_children(problem, label_set, pairs, children, child, kept, budget) for pairs in older]


def _children(
    problem: LayoutProblem,
    label_set: LabelSet,
    pairs: NearPairs,
    children: Indices,
    child: Indices,
    kept: Flags,
    budget: Budget,
) -> NearPairs:
    many, few = children[pairs.first], children[pairs.second]
    same = kept[pairs.first] & kept[pairs.second]
    old = NearPairs(
        pairs.sets, child[pairs.first[same]], child[pairs.second[same]], pairs.costs[same]
    )
    times = np.where(same, 0, many * few)
    split = np.flatnonzero(times)
    pieces = [old]
    for part in np.split(split, np.flatnonzero(np.diff(np.cumsum(times[split]) // AT_ONCE)) + 1):
        source = np.repeat(part, times[part])
        step = np.arange(len(source)) - np.repeat(np.cumsum(times[part]) - times[part], times[part])
        first = child[pairs.first[source]] + step // few[source]
        second = child[pairs.second[source]] + step % few[source]
        pieces.append(_evaluated(problem, label_set, pairs.sets, first, second, budget))
    return NearPairs(
        pairs.sets,
        np.concatenate([each.first for each in pieces]),
        np.concatenate([each.second for each in pieces]),
        np.concatenate([each.costs for each in pieces]),
    )


def _evaluated(
    problem: LayoutProblem,
    label_set: LabelSet,
    sets: tuple[int, int],
    first: Indices,
    second: Indices,
    budget: Budget,
) -> NearPairs:
    """Bounds of the pairs; those out of reach are left out."""
    one, other = label_set.geometries[sets[0]], label_set.geometries[sets[1]]
    i, j = np.searchsorted(one.owner, first), np.searchsorted(other.owner, second)
    budget.spend(len(i))
    costs, near = pair_bounds(one, i, other, j, problem.overlap, problem.separation)
    return NearPairs(sets, first[near], second[near], costs[near])


# --- all pairs ------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class PairCosts(Record):
    """Pairs of labels (or blocks) of different variables that cost anything, each once, in
    order."""

    count: int
    """Number of labels."""
    first: Indices
    """(q,) ascending; of an earlier variable than `second`."""
    second: Indices
    costs: Floats
    """(q,) +inf where forbidden."""

    def of_rows(self, low: int, high: int) -> tuple[Indices, Indices, Floats]:
        """The pairs whose first labels are in a range: row in it, second label, cost."""
        part = slice(*np.searchsorted(self.first, (low, high)).tolist())
        return self.first[part] - low, self.second[part], self.costs[part]

    def interacting(self, owner: Indices) -> Flags:
        """(variables, variables) which have a pair; `owner` (n,) is the variable of each label."""
        variables = int(owner[-1]) + 1 if len(owner) else 0
        found = np.zeros((variables, variables), dtype=bool)
        found[owner[self.first], owner[self.second]] = True
        return np.asarray(found | found.T)

    def among(self, labels: Indices) -> PairCosts:
        """The pairs of some labels (ascending), numbered among them."""
        place = np.full(self.count, -1, dtype=np.int64)
        place[labels] = np.arange(len(labels))
        first, second = place[self.first], place[self.second]
        held = (first >= 0) & (second >= 0)
        return PairCosts(len(labels), first[held], second[held], self.costs[held])

    def matrix(self) -> Floats:
        """(n, n) costs above the diagonal, 0 elsewhere."""
        found = np.zeros((self.count, self.count))
        found[self.first, self.second] = self.costs
        return found


def pair_costs(
    problem: LayoutProblem, label_set: LabelSet, near: list[NearPairs], candidate: Indices
) -> PairCosts:
    """Costs of all pairs of a label_set.

    `candidate` (n,) says which candidate of its variable stands behind each entry of the label_set:
    -1 for off the face, -2 for a block of several.  Explicit pair costs (`LayoutProblem.extra`) are
    added where both entries are single candidates; for blocks zero bounds them from below.
    """
    count = int(label_set.start[-1])
    explicit = [_explicit(label_set, candidate, each) for each in problem.extra]
    pieces = [(each.first, each.second, each.costs) for each in near] + explicit
    none = np.empty(0, dtype=np.int64)
    keys = np.concatenate([none, *(first * count + second for first, second, _ in pieces)])
    costs = np.concatenate([np.empty(0), *(each for _, _, each in pieces)])
    order = np.argsort(keys, kind="stable")
    keys = keys[order]
    at = np.flatnonzero(np.diff(keys, prepend=-1))
    summed = np.add.reduceat(costs[order], at) if len(at) else costs
    return PairCosts(count, keys[at] // max(count, 1), keys[at] % max(count, 1), summed)


def _explicit(
    label_set: LabelSet, candidate: Indices, extra: ExtraPairs
) -> tuple[Indices, Indices, Floats]:
    """Entries of the label_set that explicit costs speak of, and the costs."""
    first = _entry(label_set, candidate, extra.first, extra.first_labels)
    second = _entry(label_set, candidate, extra.second, extra.second_labels)
    known = (first >= 0) & (second >= 0) & (extra.costs > 0)
    return first[known], second[known], extra.costs[known]


def _entry(label_set: LabelSet, candidate: Indices, variable: int, labels: Indices) -> Indices:
    """(q,) the variable's entries that are the single candidates `labels`, or -1."""
    low, high = label_set.start[variable], label_set.start[variable + 1]
    mine = candidate[low:high]
    if not len(mine):
        return np.full(len(labels), -1, dtype=np.int64)
    order = np.argsort(mine, kind="stable")
    entry = order[np.minimum(np.searchsorted(mine[order], labels), len(mine) - 1)]
    return np.where(mine[entry] == labels, entry + low, -1)
