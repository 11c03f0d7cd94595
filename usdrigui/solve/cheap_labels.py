"""The labels that are looked at one by one, and one for all others of a variable.

Tables of all pairs of tens of thousands of labels do not fit into memory.  Nearly all labels of
good layouts cost little more than the cheapest of their variable, so as many of the cheapest are
taken as fit.  Of the others of a variable one stands for all: it costs what the cheapest of them
costs, and nothing in pairs, so no layout costs less than one of what is taken.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.model import LayoutProblem
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import LabelSet
from usdrigui.solve.pair_costs import pair_costs

BYTES_PER_PAIR = 60
"""Allowed for each pair of labels, whether it costs anything or not: runs on 85 753 points and 65
controls take half of it."""


class CheapLabels(Record):
    """Labels taken of all that a better layout may use."""

    labels: LabelSet
    """Those taken, and of each variable's others the cheapest."""
    place: Indices
    """(n,) their numbers among all labels."""
    stands: Flags
    """(n,) which of them stand for others, too."""
    pairs: csr_array
    """(n, n) what pairs cost, each once."""
    limit: str
    """What kept their number down: ``memory limit`` or ``work limit``."""

    @property
    def least_pairs(self) -> csr_array:
        """(n, n) what pairs cost at least, whichever label one that stands for others is."""
        every = self.pairs.tocoo()
        alone = ~(self.stands[every.row] | self.stands[every.col])
        entries = every.data[alone], (every.row[alone], every.col[alone])
        return csr_array(entries, shape=every.shape)

    def opened(self, every: LabelSet, left: Indices, spare: Floats) -> Flags:
        """Which of all labels (`every`) may be in a layout below the cutoff, when of these the ones
        that are `left` (q,) may be, and layouts that use them stay `spare` (q,) below it.

        Layouts that use another than the one that stands for it cost more by what that costs more.
        """
        most = np.full(every.variables, -np.inf)
        stands = self.stands[left]
        at = left[stands]
        most[self.labels.variable[at]] = self.labels.cost[at] + spare[stands]
        alive = every.cost <= most[every.variable]
        alive[self.place] = False
        alive[self.place[left]] = True
        return alive


def cheap_labels(
    problem: LayoutProblem,
    every: LabelSet,
    alive: Flags,
    wanted: Indices,
    most: float,
    budget: Budget,
) -> CheapLabels:
    """The cheapest of the labels that are `alive` (n,), and `wanted` ones: `most` at most, as many
    as have room in the memory, and as have their pairs worked out in a quarter of the work left."""
    room, limit = np.sqrt(budget.settings.memory_limit * 2**21 / BYTES_PER_PAIR), "memory limit"
    most = int(min(most, room))
    above = np.where(alive, every.cost - every.best[every.variable], np.inf)
    order = np.argsort(above, kind="stable")[: int(alive.sum())]
    while True:
        taken = alive & (every.candidate < 0)  # With the board there is a layout.
        taken[wanted] = True
        taken[order[:most]] = True
        # Of each variable's others the cheapest: the first in the order of costs.
        others = order[~taken[order]]
        first = np.unique(every.variable[others], return_index=True)[1]
        stands = np.zeros(len(taken), dtype=bool)
        stands[others[first]] = True
        place = np.flatnonzero(taken | stands)
        labels = every.of(place)
        work = budget.work_left / 4 if most > every.variables else np.inf
        pairs = pair_costs(problem, labels, budget, work)
        if pairs is not None:
            return CheapLabels(labels, place, stands[place], pairs, limit)
        most, limit = min(most, len(order)) // 2, "work limit"
