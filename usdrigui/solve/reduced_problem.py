"""What is left of a layout problem as tables of costs: dual ascent, tests that exclude labels and
pairs, triplets.

A pairwise energy is reparametrised in place: costs move between labels, pairs and triplets of
labels of different variables, and what every layout costs stays as it is.  As long as no pair and
no triplet costs less than 0, the constant and the least costs of the variables are a lower bound
(T. Werner, "A linear programming approach to max-sum problem: a review", 2007).
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial.distance import cdist

from usdrigui.character import Flags, Floats, Indices, Record, Singles

EPSILON = 1e-11
"""A cost that is not above is none."""
SAME = 1e-9
"""Costs that differ by no more are of the same layout."""
LARGEST_TESTED = 1200
"""Labels whose pairs are tested and swept often: tests take the cube of their number."""
DEAREST = 64.0
"""Cost up to which sums of two are told apart: far above any that a layout is made of."""

Triplet = tuple[int, int, int]


class PlainProblem(Record):
    """What solvers of a rest get: labels of variables with the problem's own costs, and no
    messages."""

    start: Indices
    """(variables + 1,) first label of each variable."""
    linear: Floats
    """(n,) what labels cost alone."""
    pairs: Floats
    """(n, n) costs of pairs, the same both ways, +inf for pairs that are excluded."""

    @cached_property
    def slices(self) -> list[slice]:
        """The labels of each variable."""
        return [slice(low, high) for low, high in itertools.pairwise(self.start.tolist())]

    @cached_property
    def owner(self) -> Indices:
        """(n,) variable of each label."""
        return np.repeat(np.arange(len(self.slices)), np.diff(self.start))

    @cached_property
    def least(self) -> Floats:
        """(variables,) least linear cost of each variable."""
        return np.minimum.reduceat(self.linear, self.start[:-1])

    @property
    def excess(self) -> Floats:
        """(n,) how much more than the cheapest of its variable every label costs."""
        return self.linear - self.least[self.owner]

    def value(self, chosen: Indices) -> float:
        """Cost of one label per variable; +inf with an excluded pair."""
        return float(self.linear[chosen].sum() + self.pairs[np.ix_(chosen, chosen)].sum() / 2)

    def costly_pairs(self) -> int:
        """How many pairs cost anything and are not excluded."""
        return int(((self.pairs > EPSILON) & (self.pairs < np.inf)).sum()) // 2


class Solution(Record):
    """What a solver proved of a reduced problem, and found."""

    bound: float
    """No layout costs less than this; the cutoff where there is none below it."""
    chosen: Indices | None
    """(variables,) places in the problem of the labels of the best layout below the cutoff."""
    figures: Mapping[str, float]
    """For the report."""


class Row(NamedTuple):
    """Of a linear program: ``low <= values x[columns] <= high``."""

    columns: Indices
    values: Floats
    low: float
    high: float


class Strip(NamedTuple):
    """The tables of a variable with later ones, side by side, so that one pass goes over all."""

    costs: Floats
    """(labels, q) >= 0, +inf for a pair that is excluded; changed in place."""
    mine: slice
    """The labels of the variable."""
    columns: Indices
    """(q,) labels of the later variables, ascending: all of each."""
    first: Indices
    """(tables,) column at which each begins."""
    others: Indices
    """(tables,) the later variables."""
    sizes: Indices
    """(tables,) how many labels they have."""

    def each(self, of_variables: Flags) -> Floats:
        """(q,) 1 for the columns of the variables that are flagged, 0 for others."""
        return np.repeat(of_variables[self.others], self.sizes).astype(np.float64)


def _strip(owner: Indices, mine: slice, columns: Indices, costs: Floats) -> Strip:
    first = np.flatnonzero(np.diff(owner[columns], prepend=-1))
    sizes = np.diff(np.append(first, len(columns)))
    return Strip(costs, mine, columns, first, owner[columns[first]], sizes)


def tables_of(owner: Indices, pairs: Floats | csr_array) -> list[Strip]:
    """Tables of (n, n) pair costs, the earlier variable first: of all variables where the costs are
    dense, of those that have a pair where they are sparse.  `owner` (n,) is each label's
    variable."""
    start = np.searchsorted(owner, np.arange(int(owner[-1]) + 2))
    every = np.ones((len(start), len(start)), dtype=bool)
    used = every if isinstance(pairs, np.ndarray) else interacting(owner, pairs)
    found = []
    for at, (low, high) in enumerate(itertools.pairwise(start.tolist())):
        columns = high + np.flatnonzero(used[at, owner[high:]])
        costs = pairs[low:high][:, columns]
        table = costs if isinstance(costs, np.ndarray) else costs.toarray()
        found.append(_strip(owner, slice(low, high), columns, np.ascontiguousarray(table)))
    return found


def interacting(owner: Indices, pairs: csr_array) -> Flags:
    """(variables, variables) which have a pair, the earlier one first."""
    found = np.zeros((owner[-1] + 1,) * 2, dtype=bool)
    first, second = pairs.nonzero()
    found[owner[first], owner[second]] = True
    return found


class ReducedProblem:
    """Labels of variables, excluded pairs of them, and the reparametrised costs of both."""

    def __init__(
        self,
        owner: Indices,
        labels: Indices,
        costs: Floats,
        pairs: Floats | csr_array | list[Strip],
        constant: float = 0.0,
    ) -> None:
        self.owner = owner
        """(n,) variable of each label, ascending; every variable has one at least."""
        self.labels = labels
        """(n,) number of each label in the problem that this one is left of."""
        self.costs = costs
        """(n,) linear costs."""
        self.constant = constant
        self.count = int(owner[-1]) + 1
        self.start = np.searchsorted(owner, np.arange(self.count + 1))
        """(count + 1,) first label of each variable."""
        self.slices = [slice(low, high) for low, high in itertools.pairwise(self.start.tolist())]
        """The labels of each variable."""
        self.messages: dict[Triplet, tuple[Singles, Singles, Singles]] = {}
        """What triplets a < b < c of variables gave to their tables ab, ac, bc; a triplet costs
        what it did not give, ``-(ab[i, j] + ac[i, k] + bc[j, k])``, which is never below 0."""
        self.linked: Flags = np.zeros((self.count, self.count), dtype=bool)
        """(count, count) whether any pair of two variables costs anything."""
        self.tables = pairs if isinstance(pairs, list) else tables_of(owner, pairs)
        """The pair costs: one strip per variable."""

    @property
    def entries(self) -> int:
        """Pairs that are held."""
        return sum(each.costs.size for each in self.tables)

    def bound(self) -> float:
        """No layout costs less."""
        return self.constant + float(np.minimum.reduceat(self.costs, self.start[:-1]).sum())

    def excess(self) -> Floats:
        """(n,) how much more than the cheapest of its variable every label costs."""
        return self.costs - np.minimum.reduceat(self.costs, self.start[:-1])[self.owner]

    def table(self, a: int, b: int) -> Floats:
        """(labels of a, labels of b) pair costs of two variables a < b that interact, to be
        changed in place."""
        strip = self.tables[a]
        at = int(np.searchsorted(strip.others, b))
        low = int(strip.first[at])
        return strip.costs[:, low : low + int(strip.sizes[at])]

    def both_ways(self) -> Floats:
        """(n, n) pair costs, the same in both orders; 0 within a variable."""
        found = np.zeros((len(self.costs), len(self.costs)))
        for strip in self.tables:
            found[strip.mine, strip.columns] = strip.costs
            found[strip.columns, strip.mine] = strip.costs.T
        return found

    # --- smaller problems -------------------------------------------------------------------------

    def restricted(self, alive: Flags) -> ReducedProblem:
        """The problem of the labels that are alive, at least one of every variable."""
        number = np.cumsum(alive) - 1
        owner = self.owner[alive]
        tables: list[Strip] = []
        for strip in self.tables:
            columns = alive[strip.columns]
            left = strip.costs[np.ix_(alive[strip.mine], columns)]
            mine = slice(*np.searchsorted(owner, (len(tables), len(tables) + 1)).tolist())
            tables.append(_strip(owner, mine, number[strip.columns[columns]], left))
        costs, labels = self.costs[alive], self.labels[alive]
        part = ReducedProblem(owner, labels, costs, tables, self.constant)
        part.inherit(self, np.flatnonzero(alive))
        return part

    def inherit(self, older: ReducedProblem, parent: Indices) -> None:
        """Take the messages of another problem; `parent` (n,) tells each label's index there."""
        self.linked = older.linked.copy()
        mine = [parent[each] - older.start[at] for at, each in enumerate(self.slices)]
        for (a, b, c), (ab, ac, bc) in older.messages.items():
            self.messages[a, b, c] = (
                ab[np.ix_(mine[a], mine[b])],
                ac[np.ix_(mine[a], mine[c])],
                bc[np.ix_(mine[b], mine[c])],
            )

    # --- reparametrisation ------------------------------------------------------------------------

    def normalize(self) -> None:
        """Move the least cost of tables into the constant, and note which cost anything."""
        self.linked[:] = False
        for at, strip in enumerate(self.tables):
            if not len(strip.others):
                continue
            least = np.minimum.reduceat(strip.costs.min(axis=0), strip.first)
            most = np.maximum.reduceat(strip.costs.max(axis=0), strip.first)
            self.linked[at, strip.others] = self.linked[strip.others, at] = most > least + EPSILON
            moved = finite(least)
            if moved.any():
                strip.costs[...] -= np.repeat(moved, strip.sizes)
                self.constant += float(moved.sum())

    def sweep(self) -> None:
        """Block-coordinate ascent of the bound: once over the variables and back.

        Sequential tree-reweighted message passing (V. Kolmogorov, "A new look at reweighted message
        passing", 2015): every variable shares its costs among the tables ahead, which pass them on.
        """
        ahead, behind = np.triu(self.linked).sum(axis=1), np.tril(self.linked).sum(axis=1)
        portion = 1.0 / np.maximum(np.maximum(ahead, behind), 1)
        for at in np.flatnonzero(ahead).tolist():
            strip = self.tables[at]
            share = self.costs[strip.mine] * portion[at]
            self.costs[strip.mine] -= share * ahead[at]
            strip.costs[...] += share[:, None] * strip.each(self.linked[at])
            least = finite(strip.costs.min(axis=0))
            strip.costs[...] -= least
            self.costs[strip.columns] += least
        shares = np.zeros(len(self.costs))
        for at, strip in reversed(list(enumerate(self.tables))):
            # Later variables have all that comes from behind, and have set their shares aside.
            if ahead[at]:
                strip.costs[...] += shares[strip.columns] * strip.each(self.linked[at])
                given = finite(np.minimum.reduceat(strip.costs, strip.first, axis=1))
                strip.costs[...] -= np.repeat(given, strip.sizes, axis=1)
                self.costs[strip.mine] += given.sum(axis=1)
            shares[strip.mine] = self.costs[strip.mine] * portion[at]
            self.costs[strip.mine] -= shares[strip.mine] * behind[at]

    def spread(self) -> None:
        """Move all linear costs of linked variables into their tables, evenly."""
        degree = self.linked.sum(axis=1)
        share = self.costs / np.maximum(degree, 1)[self.owner]
        for at, strip in enumerate(self.tables):
            linked = strip.each(self.linked[at])
            strip.costs[...] += share[strip.mine, None] * linked
            strip.costs[...] += share[strip.columns] * linked
        self.costs[degree[self.owner] > 0] = 0.0

    # --- tests ------------------------------------------------------------------------------------

    def label_lower_bounds(self) -> Floats:
        """(n,) no layout that uses a label costs less; +inf for one that every layout excludes."""
        excess = self.excess()
        least = np.zeros(len(excess))
        for strip in self.tables:
            if len(strip.others):
                least[strip.columns] += (strip.costs + excess[strip.mine, None]).min(axis=0)
                costs = strip.costs + excess[strip.columns]
                least[strip.mine] += np.minimum.reduceat(costs, strip.first, axis=1).sum(axis=1)
        return self.bound() + excess + least

    def exclude_pairs(self, cutoff: float) -> None:
        """Exclude the pairs of labels that no layout below the cutoff uses.

        For every third variable the label counts that costs least with both.
        """
        gap, excess, pairs = cutoff - self.bound(), self.excess(), self.both_ways()
        alone = np.minimum.reduceat(pairs + excess, self.start[:-1], axis=1)
        alone = np.minimum(alone, DEAREST)  # (labels, variables)
        for variable, mine in enumerate(self.slices[:-1]):
            later = slice(mine.stop, None)
            bad = self._pair_lower_bounds(variable, excess, pairs, alone) >= gap + EPSILON
            pairs[mine, later][bad] = np.inf
            pairs[later, mine][bad.T] = np.inf
        self.tables = tables_of(self.owner, pairs)

    def _pair_lower_bounds(
        self, variable: int, excess: Floats, pairs: Floats, alone: Floats
    ) -> Floats:
        """(labels, later labels) what layouts that use both cost above the bound.

        A third variable that only one of them is linked to costs what it costs `alone`
        (labels, variables) with that one at least.
        """
        mine = self.slices[variable]
        later = slice(mine.stop, None)
        total = excess[mine, None] + excess[later] + pairs[mine, later]
        first = self.owner[later]
        total += alone[mine].sum(axis=1)[:, None] - alone[mine][:, first]
        total += alone[later].sum(axis=1) - alone[later, variable]
        for third in np.flatnonzero(self.linked[variable]).tolist():
            close, other = np.flatnonzero(self.linked[third, first]), self.slices[third]
            with_both = pairs[later, other][close]
            least = least_sums(pairs[mine, other] + excess[other], with_both)
            total[:, close] += least - alone[mine, third, None] - alone[later, third][close]
        return total


def reduced(problem: ReducedProblem, cutoff: float) -> ReducedProblem | None:
    """The problem of the labels that layouts below the cutoff may use; None if there are none."""
    while True:
        alive = problem.label_lower_bounds() < cutoff
        if not np.logical_or.reduceat(alive, problem.start[:-1]).all():
            return None
        if alive.all():
            return problem
        problem = problem.restricted(alive)


def undominated(start: Indices, linear: Floats, pairs: Floats, excluded: Flags) -> Flags:
    """(n,) labels that no other label of their variable can always replace at no more cost
    (dead-end elimination).

    Label r of a variable goes when for some label s of it

        linear_s - linear_r + sum_u max_t (c_st - c_rt) <= 0,

    u over the other variables, t over the labels of u that a layout with r may use: whatever the
    others choose, s costs no more (J. Desmet et al., 1992; R. F. Goldstein, 1994).  A layout below
    the cutoff stays below it, so it still uses nothing that bounds exclude.

    `start` (variables + 1,) is the first label of each variable; `linear` (n,) and `pairs` (n, n),
    the same both ways, are what labels cost before any reparametrisation; `excluded` (n, n) are the
    pairs that no layout below the cutoff uses.  Of labels that can replace each other one is kept.
    """
    alive = np.ones(len(linear), dtype=bool)
    owner = np.repeat(np.arange(len(start) - 1), np.diff(start))
    for low, high in itertools.pairwise(start.tolist()):
        others = np.flatnonzero(alive)
        first = np.flatnonzero(np.diff(owner[others], prepend=-1))
        costs = np.minimum(pairs[low:high, others], 1e30)  # infinite costs have no differences
        # No replacement need pay for a pair that is excluded.
        used = np.where(excluded[low:high, others], np.inf, costs)
        own, mine = linear[low:high], alive[low:high]
        rivals = _cheaper_in_mean(own, used, costs, first)
        order = np.argsort(-own, kind="stable")
        for label in order[rivals[order].any(axis=1)]:
            better = np.flatnonzero(mine & rivals[label])
            more = np.maximum.reduceat(costs[better] - used[label], first, axis=1).sum(axis=1)
            mine[label] = not (own[better] - own[label] + more <= 0).any()
    return alive


def _cheaper_in_mean(own: Floats, used: Floats, costs: Floats, first: Indices) -> Flags:
    """(n, n) which labels (columns) of a variable can replace which (rows) at no more cost in the
    mean over what these may be used with of each other variable: a mean is no more than the largest
    of `undominated`, and one product gives all, which leaves few to be tried."""
    allowed = used < np.inf
    met = np.add.reduceat(allowed, first, axis=1, dtype=np.float64)
    share = allowed / np.repeat(np.maximum(met, 1.0), np.diff(first, append=costs.shape[1]), axis=1)
    mean = own + share @ np.minimum(costs, DEAREST).T
    found = mean <= mean.diagonal()[:, None] + SAME
    np.fill_diagonal(found, False)
    return np.asarray(found)


def least_sums(one: Floats, other: Floats) -> Floats:
    """(x, y) of (x, t) and (y, t) costs: the least sum of two for any t, none counted above
    DEAREST.

    The least sum is the one farthest below what none exceeds: a largest difference, which scipy
    finds in half the time that all sums take.
    """
    most = 2.0 * DEAREST
    rounding = 4.0 * most * np.finfo(np.float64).eps
    one, other = np.minimum(one, DEAREST), np.minimum(other, DEAREST)
    return np.asarray(most - rounding - cdist(most - one, other, "chebyshev"))


def finite(costs: Floats) -> Floats:
    """Costs to be moved: nothing of what is excluded, which stays so."""
    return np.where(costs < np.inf, costs, 0.0)
