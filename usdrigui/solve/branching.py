"""Branch and bound on few labels, over thousands of partial layouts at a time.

A partial layout costs no less than its labels in the reparametrised problem and, of every other
variable, the least that a label costs against them.  A triplet counts once two of its variables
have a label, so that a whole layout costs what it does.  Next comes the variable with the fewest
labels below the cutoff, counted over the partial layouts at hand.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import ReducedProblem, Solution

ENTRIES = 2**19
"""Labels, of all partial layouts together, that are gone on from at a time."""
SAMPLE = 200
"""Partial layouts that tell how many there are (D. E. Knuth, "Estimating the efficiency of
backtrack programs", 1975), and which variable is next."""
ENTRIES_PER_WORK = 128
"""Labels of partial layouts that are a unit of work."""


def solve_by_branching(
    problem: ReducedProblem, cutoff: float, budget: Budget, most: int
) -> Solution:
    """Best layout that costs less than the cutoff, or the proof that there is none.

    A run that `budget` stops, or that seems to need more than `most` work, proves nothing.
    """
    search = _Search(problem, cutoff, budget)
    search.begin(sample=True)
    if search.entries > most * ENTRIES_PER_WORK:
        return Solution(-np.inf, search.chosen, {"nodes": 0})
    search.most = budget.work + 2 * most
    search.begin(sample=False)
    bound = search.cutoff if search.complete else -np.inf
    return Solution(bound, search.chosen, {"nodes": search.nodes})


class _Search:
    """What is found on the way."""

    def __init__(self, problem: ReducedProblem, cutoff: float, budget: Budget) -> None:
        self._problem, self._budget, self.cutoff = problem, budget, cutoff
        self.chosen: Indices | None = None
        self._sizes, self._sample = np.diff(problem.start), True
        self.nodes, self.entries, self.most, self.complete = 0, 0.0, np.inf, True
        # With any other labels, what is excluded comes well above the cutoff.
        self._pairs = np.minimum(problem.both_ways(), 1.0 + cutoff - problem.bound())

    def begin(self, sample: bool) -> None:
        """Search from no label on, or guess from a sample how many `entries` that takes."""
        self._sample, self.nodes = sample, 0
        left = np.zeros((1, self._problem.count), dtype=np.int64)
        rest = np.arange(self._problem.count)
        cost = np.array([self._problem.bound()])
        self._go_on(cost, self._problem.excess()[None], rest, left, 1.0)

    def _go_on(
        self, cost: Floats, above: Floats, rest: Indices, chosen: Indices, weight: float
    ) -> None:
        """From partial layouts that cost (k,), a sample of `weight` times as many: `above` is what
        labels of the `rest` of the variables cost against them, `chosen` (k, variables) the labels
        of the others, counted in each from 0."""
        if not len(rest):
            best = int(cost.argmin())
            if cost[best] < self.cutoff:
                self.cutoff = float(cost[best])
                self.chosen = self._problem.start[:-1] + chosen[best]
            return
        self.entries += weight * above.size
        self._budget.spend(1 + above.size // ENTRIES_PER_WORK)
        if self._budget.stopped() or self._budget.work > self.most:
            self.complete = False
            return
        sizes = self._sizes[rest]
        ends = np.cumsum(sizes)
        least = np.minimum.reduceat(above, ends - sizes, axis=1)
        room = self.cutoff - cost - least.sum(axis=1)
        some = slice(None, None, 1 + len(cost) // SAMPLE)
        below = above[some] - np.repeat(least[some], sizes, axis=1) < room[some, None]
        place = int(np.add.reduceat(below.sum(axis=0), ends - sizes).argmin())
        at, mine = int(rest[place]), slice(ends[place] - sizes[place], ends[place])
        which, labels = np.nonzero(above[:, mine] - least[:, [place]] < room[:, None])
        self.nodes += len(which)
        cost = cost[which] + above[which, mine.start + labels]
        above, others = np.delete(above, mine, axis=1), np.delete(rest, place)
        pairs = self._pairs[self._problem.slices[at]][:, np.isin(self._problem.owner, others)]
        order = np.argsort(cost, kind="stable")
        step, rows = 1, max(1, ENTRIES // max(1, above.shape[1]))
        if self._sample:
            step, rows = 1 + len(order) // SAMPLE, SAMPLE
        for low in range(0, len(order), rows * step):
            part = order[low : low + rows * step : step]
            now = chosen[which[part]]
            now[:, at] = labels[part]
            more = above[which[part]] + pairs[labels[part]]
            self._add_triplets(more, at, others, now)
            if self.complete:
                self._go_on(cost[part], more, others, now, weight * step)

    def _add_triplets(self, above: Floats, at: int, rest: Indices, chosen: Indices) -> None:
        """What triplets of a variable and another that have a label cost with those of the rest."""
        ends = dict(zip(rest.tolist(), np.cumsum(self._sizes[rest]).tolist(), strict=True))
        for triplet, (ab, ac, bc) in self._problem.messages.items():
            third = [each for each in triplet if each in ends]
            if at in triplet and len(third) == 1:
                mine = slice(ends[third[0]] - int(self._sizes[third[0]]), ends[third[0]])
                given = ab[:, :, None].astype(np.float64) + ac[:, None] + bc
                known = [each for each in triplet if each not in ends]
                costs = np.moveaxis(given, triplet.index(third[0]), 2)
                # Of labels that exclude each other more may be given.
                above[:, mine] -= np.minimum(costs, 0.0)[chosen[:, known[0]], chosen[:, known[1]]]
