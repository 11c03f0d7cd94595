"""Good layouts early: greedy insertion, steepest descent, iterated local search.

What every label would cost against the labels chosen now is kept at hand, so that the best label of
a variable is the least of its entries.  Everything is drawn from a seeded generator and counted in
work: the same problem gives the same layout.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from scipy.sparse import csr_array

from usdrigui.character import Floats, Indices
from usdrigui.model import LayoutProblem
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import LabelSet
from usdrigui.solve.pair_costs import explicit_costs, geometry_costs, meeting
from usdrigui.solve.reduced_problem import SAME

TRIES = 10
"""Of the search per variable, each time: thousands take a second where pair costs are at hand."""
TRAPS = 0.5
"""How much worse a search among many labels may get on its way: a crowd has many traps."""
WORSE = 0.01
"""How much more than the best a layout may cost for the search to go on from it, and, in the mean,
a label put back than the cheapest."""


class LocalSearch:
    """A layout that changes, and the best one so far."""

    def __init__(
        self,
        start: Indices,
        linear: Floats,
        rows: KnownRows | LazyRows,
        budget: Budget,
        tell: bool = False,
    ) -> None:
        """`start` (variables + 1,) is the first label of each variable, `linear` (n,) what labels
        cost alone.

        With `tell` its layouts are ones of the whole problem, and the budget counts them.
        """
        self._start, self._linear, self.rows = start, linear, rows
        self._budget, self._tell = budget, tell
        self._generator = np.random.default_rng(budget.settings.seed)
        self._least = np.minimum.reduceat(linear, start[:-1])
        self._now = np.full(len(start) - 1, -1, dtype=np.int64)
        self._costs = linear.copy()
        """(n,) what every label costs, alone and against the labels chosen now."""
        self.chosen, self._best = self._now.copy(), self._costs
        """(variables,) the best layout, and (n,) what every label costs against its labels."""
        self.cost = np.inf

    def construct(self) -> None:
        """Give the variables their cheapest labels one by one, and descend."""
        self._insert(np.argsort(self._least, kind="stable"))
        self._descend()

    def improve_from(self, chosen: Indices) -> None:
        """Descend from a layout."""
        self._set(chosen)
        self._descend()

    def search(self, worse: float = WORSE, most: float = np.inf, tries: int = TRIES) -> None:
        """Iterated local search: `tries` per variable from the best layout on, and again as
        long as they help and no more than `most` work is done in all: take a few rivals out, put
        them back in another order, descend; go on from a layout `worse` than the best at most."""
        cost = np.inf
        while self.cost < cost:
            cost = self.cost
            self._set(self.chosen)
            for _ in range(tries * len(self.chosen)):
                if self._budget.over() or self._budget.work >= most:
                    return
                group = self._rivals()
                for variable in group:
                    self._place(variable, -1)
                self._insert(self._generator.permutation(group), worse)
                if self._descend() > self.cost + worse:
                    self._now, self._costs = self.chosen.copy(), self._best.copy()

    def _rivals(self) -> Indices:
        """Variables to take out together: one that pays much, and some whose labels cost its
        present label, or nearly its cheapest, anything."""
        pays = np.maximum(self._costs[self._now] - self._least, 0.0) + 1e-3
        first = int(self._generator.choice(len(pays), p=pays / pays.sum()))
        low, high = self._start[first], self._start[first + 1]
        wanted = self._linear[low:high] + self._generator.exponential(WORSE, high - low)
        near = np.zeros(len(self._linear), dtype=bool)
        for label in (self._now[first], low + wanted.argmin()):
            near[self.rows.of(int(label))[0]] = True
        others = self._generator.permutation(np.flatnonzero(near[self._now]))
        return np.append(first, others[: int(self._generator.integers(2, 9))])

    def _insert(self, order: Iterable[int], noise: float = 0.0) -> None:
        """Give the variables, in order, their cheapest labels, or nearly."""
        for variable in order:
            low, high = self._start[variable], self._start[variable + 1]
            costs = self._costs[low:high] + self._generator.exponential(noise, high - low)
            self._place(variable, low + int(costs.argmin()))

    def _descend(self) -> float:
        """Move variables while that gains; the cost of the layout, which is kept if the best."""
        self._moves()
        self._budget.spend(1 + len(self._costs) // 32)
        if self._value() < self.cost - SAME:
            self._set(self._now)
            if self._value() < self.cost - SAME:
                self.chosen, self.cost = self._now.copy(), self._value()
                self._best = self._costs.copy()
                if self._tell and self.cost < self._budget.ceiling:
                    self._budget.found("local search", self.cost)
        return self._value()

    def _moves(self) -> None:
        """Of single variables, the one that gains most first, until rounding feigns gains."""
        for _ in range(len(self._costs)):
            gains = self._costs[self._now] - np.minimum.reduceat(self._costs, self._start[:-1])
            at = int(gains.argmax())
            if gains[at] < SAME:
                return
            low, high = self._start[at], self._start[at + 1]
            self._place(at, low + int(self._costs[low:high].argmin()))

    def _value(self) -> float:
        """Cost of the layout: pairs are counted at both ends."""
        return 0.5 * float((self._linear + self._costs)[self._now].sum())

    def _set(self, chosen: Indices) -> None:
        """Choose a whole layout anew: sums that grow and shrink leave their rounding behind."""
        at, costs = zip(*(self.rows.of(int(label)) for label in chosen), strict=True)
        every = np.concatenate([np.arange(len(self._linear)), *at])
        weights = np.concatenate([self._linear, *costs])
        self._costs = np.bincount(every, weights).astype(float)
        self._now = chosen.copy()

    def _place(self, variable: int, label: int) -> None:
        """Choose a label of a variable, or none with -1."""
        for other, sign in ((int(self._now[variable]), -1.0), (label, 1.0)):
            if other >= 0:
                at, cost = self.rows.of(other)
                self._costs[at] += sign * cost
        self._now[variable] = label


class KnownRows:
    """What labels cost in pairs, all of which are at hand."""

    def __init__(self, pairs: csr_array, penalty: float = np.inf) -> None:
        self.penalty, self._both = penalty, (pairs + pairs.T).tocsr()
        self._both.data = np.minimum(self._both.data, penalty)

    def of(self, label: int) -> tuple[Indices, Floats]:
        """The labels that cost anything in a pair with `label`, and the costs: of a forbidden one
        the `penalty`."""
        part = slice(*self._both.indptr[label : label + 2])
        return self._both.indices[part], self._both.data[part]


class LazyRows:
    """Of labels too many for all pairs: those of one label are worked out when asked for."""

    def __init__(
        self, problem: LayoutProblem, labels: LabelSet, budget: Budget, penalty: float
    ) -> None:
        self._problem, self._labels, self._budget, self.penalty = problem, labels, budget, penalty
        self._explicit = KnownRows(explicit_costs(problem, labels))
        self._together = problem.together & ~np.eye(labels.variables, dtype=bool)
        self._known: dict[int, tuple[Indices, Floats]] = {}
        self._room = self._most = budget.settings.memory_limit * 2**20 // 80
        """Entries of 16 bytes that a fifth of the memory holds."""

    def of(self, label: int) -> tuple[Indices, Floats]:
        """The same as `KnownRows.of`."""
        if label not in self._known:
            found = self._evaluated(label)
            self._room -= len(found[0])
            if self._room < 0:
                self._known.clear()
                self._room = self._most
            self._known[label] = found
        return self._known[label]

    def _evaluated(self, label: int) -> tuple[Indices, Floats]:
        labels, cost = self._labels, np.zeros(len(self._labels.cost))
        together = self._together[labels.variable[label]]
        for one in labels.geometries:
            place = np.arange(*np.searchsorted(one.owner, (label, label + 1)))
            for other in labels.geometries if len(place) else ():
                at = np.flatnonzero(meeting(one, place, other, slice(None), self._problem))
                at = at[together[labels.variable[other.owner[at]]]]
                if len(at):
                    self._budget.spend(len(at))
                    mine = np.broadcast_to(place, at.shape)
                    cost[other.owner[at]] += geometry_costs(one, mine, other, at, self._problem)
        others, costs = self._explicit.of(label)
        cost[others] += costs
        found = np.flatnonzero(cost)
        return found, np.minimum(cost[found], self.penalty)
