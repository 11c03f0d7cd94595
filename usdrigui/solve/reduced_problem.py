"""What is left of a layout problem as one matrix: dual ascent, tests that exclude labels and pairs, triplets.

A pairwise energy is reparametrised in place: costs move between labels, pairs and triplets of labels of different
variables, and what every layout costs stays as it is.  As long as no pair and no triplet costs less than 0, the
constant and the least costs of the variables are a lower bound (T. Werner, "A linear programming approach to max-sum
problem: a review", 2007).
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from usdrigui.model import Flags, Floats, Indices, Singles

EPSILON = 1e-11
"""A cost that is not above is none."""
NEVER = 1e30
"""Stands for the cost of a pair that is excluded: infinite costs have no differences."""
LARGEST_TESTED = 1200
"""Labels whose pairs are tested, and whose matrix is swept often: tests take the cube of their number."""
ROWS = 256
"""Of a large matrix that are worked on at a time."""
MARGIN = 1e-5
"""Share of the distance to the cutoff that a pair must exceed it by: pairs are tested in single precision."""

Triplet = tuple[int, int, int]


@dataclass(frozen=True, eq=False)
class Solution:
    """What a solver proved of a reduced problem, and found."""

    bound: float
    """No layout costs less than this; the cutoff where there is none below it."""
    chosen: Indices | None
    """(variables,) labels of the best layout found below the cutoff, as indices into the problem."""
    figures: Mapping[str, float]
    """For the report."""


class ReducedProblem:
    """Labels of variables, the pairs of them that are excluded, and the reparametrised costs of both."""

    def __init__(self, owner: Indices, labels: Indices, costs: Floats, pairs: Floats, constant: float = 0.0) -> None:
        self.owner = owner
        """(n,) variable of each label, ascending; every variable has one at least."""
        self.labels = labels
        """(n,) number of each label in the problem that this one is left of."""
        self.costs = costs
        """(n,) linear costs."""
        self.pairs = pairs
        """(n, n) >= 0 above the diagonal blocks, +inf for a pair that is excluded; 0 elsewhere."""
        self.constant = constant
        self.count = int(owner[-1]) + 1 if len(owner) else 0
        self.start = np.searchsorted(owner, np.arange(self.count + 1))
        """(count + 1,) first label of each variable."""
        self.slices = [slice(low, high) for low, high in itertools.pairwise(self.start.tolist())]
        """The labels of each variable."""
        self.messages: dict[Triplet, tuple[Floats, Floats, Floats]] = {}
        """What triplets a < b < c of variables gave to their tables ab, ac, bc; a triplet costs what it did not give,
        ``-(ab[i, j] + ac[i, k] + bc[j, k])``, which is never below 0."""
        self.linked: Flags = np.zeros((self.count, self.count), dtype=bool)
        """(count, count) whether any pair of two variables costs anything."""

    def bound(self) -> float:
        """No layout costs less."""
        return self.constant + float(np.minimum.reduceat(self.costs, self.start[:-1]).sum())

    def excess(self) -> Floats:
        """(n,) how much more than the cheapest of its variable every label costs."""
        return np.asarray(self.costs - np.minimum.reduceat(self.costs, self.start[:-1])[self.owner])

    def both_ways(self) -> Floats:
        """(n, n) pair costs, the same in both orders."""
        return np.asarray(self.pairs + self.pairs.T)

    def value(self, chosen: Indices) -> float:
        """Cost of one label (index into this problem) per variable."""
        total = self.constant + self.costs[chosen].sum() + np.triu(self.pairs[np.ix_(chosen, chosen)], 1).sum()
        at = chosen - self.start[:-1]
        for (a, b, c), (ab, ac, bc) in self.messages.items():
            total -= ab[at[a], at[b]] + ac[at[a], at[c]] + bc[at[b], at[c]]
        return float(total)

    def triplet_costs(self, triplet: Triplet) -> Floats:
        """(na, nb, nc) what the labels of a triplet cost together on top of their pairs."""
        ab, ac, bc = self.messages[triplet]
        return np.asarray(np.maximum(-(ab[:, :, None] + ac[:, None, :] + bc[None]), 0.0))

    def restricted(self, alive: Flags) -> ReducedProblem:
        """The problem of the labels that are alive, at least one of every variable."""
        pairs = self.pairs[np.ix_(alive, alive)]
        part = ReducedProblem(self.owner[alive], self.labels[alive], self.costs[alive], pairs, self.constant)
        part._inherit(self, np.flatnonzero(alive))
        return part

    def refined(self, labels: Indices, parent: Indices, costs: Floats, older: Floats, pairs: Floats) -> ReducedProblem:
        """The problem of smaller blocks, with the messages of the blocks that they are part of.

        `parent` (m,) tells each block's index here.  `costs` (m,) and `pairs` (m, m) are its costs, `older` (n, n)
        the pair costs of this problem's blocks, all without messages; linear costs are above those of the parent.
        """
        mine = np.empty_like(pairs)
        for rows in np.array_split(np.arange(len(parent)), max(1, len(parent) // ROWS)):  # a matrix more would be large
            inherited, before = (each[np.ix_(parent[rows], parent)] for each in (self.pairs, older))
            np.copyto(pairs[rows[0] : rows[-1] + 1], np.inf, where=np.isinf(inherited))
            inherited[np.isinf(inherited)] = 0.0
            before[np.isinf(before)] = 0.0
            mine[rows] = inherited + pairs[rows] - before
        part = ReducedProblem(self.owner[parent], labels, self.costs[parent] + costs, mine, self.constant)
        part._inherit(self, parent)
        return part

    def _inherit(self, older: ReducedProblem, parent: Indices) -> None:
        """Take the messages of another problem; `parent` (n,) tells each label's index there."""
        self.linked = older.linked.copy()
        mine = [parent[each] - older.start[at] for at, each in enumerate(self.slices)]
        for (a, b, c), (ab, ac, bc) in older.messages.items():
            self.messages[a, b, c] = (
                ab[np.ix_(mine[a], mine[b])],
                ac[np.ix_(mine[a], mine[c])],
                bc[np.ix_(mine[b], mine[c])],
            )

    # --- reparametrisation ---------------------------------------------------------------------------

    def normalize(self) -> None:
        """Move the least cost of every table into the constant, and note which tables cost anything."""
        for a, b in itertools.combinations(range(self.count), 2):
            table = self.pairs[self.start[a] : self.start[a + 1], self.start[b] : self.start[b + 1]]
            least, most = float(table.min()), float(table.max())
            if least and np.isfinite(least):
                table -= least
                self.constant += least
            self.linked[a, b] = self.linked[b, a] = most - least > EPSILON

    def sweep(self) -> None:
        """Block-coordinate ascent of the bound: once over the variables and back.

        Sequential tree-reweighted message passing (V. Kolmogorov, "A new look at reweighted message passing", 2015):
        every variable shares its costs among the tables ahead, which pass them on.
        """
        slices = self.slices
        ahead, behind = np.triu(self.linked).sum(axis=1), np.tril(self.linked).sum(axis=1)
        portion = 1.0 / np.maximum(np.maximum(ahead, behind), 1)
        linked = self.linked[:, self.owner].astype(np.float64)
        for at in np.flatnonzero(ahead).tolist():
            mine, rest = slices[at], slice(slices[at].stop, None)
            block, share = self.pairs[mine, rest], self.costs[mine] * portion[at]
            block += share[:, None] * linked[at, rest]
            self.costs[mine] -= share * ahead[at]
            self._collect(block, np.minimum.reduce(block, axis=0), rest)
        for at in np.flatnonzero(behind)[::-1].tolist():
            mine, rest = slices[at], slice(0, slices[at].start)
            block, share = self.pairs[rest, mine], self.costs[mine] * portion[at]
            block += linked[at, rest, None] * share
            self.costs[mine] -= share * behind[at]
            self._collect(block.T, np.minimum.reduce(block, axis=1), rest)

    def _collect(self, block: Floats, least: Floats, labels: slice) -> None:
        """Move the least costs of labels against one variable from their tables to the labels."""
        least = np.where(least < np.inf, least, 0.0)  # labels that are excluded
        block -= least
        self.costs[labels] += least

    def spread(self) -> None:
        """Move all linear costs of linked variables into their tables, evenly."""
        degree = self.linked.sum(axis=1)
        share = self.costs / np.maximum(degree, 1)[self.owner]
        for at, mine in enumerate(self.slices):
            ahead = self.linked[at, self.owner[mine.stop :]]
            behind = self.linked[at, self.owner[: mine.start]]
            self.pairs[mine, mine.stop :] += share[mine, None] * ahead
            self.pairs[: mine.start, mine] += behind[:, None] * share[mine]
            if degree[at]:
                self.costs[mine] = 0.0

    # --- tests ---------------------------------------------------------------------------------------

    def label_lower_bounds(self) -> Floats:
        """(n,) no layout that uses a label costs less; +inf for a label that every layout excludes."""
        excess = self.excess()
        least = np.zeros(len(excess))
        for mine in self.slices:
            ahead, behind = self.pairs[mine, mine.stop :], self.pairs[: mine.start, mine]
            least[mine.stop :] += (ahead + excess[mine, None]).min(axis=0)
            least[: mine.start] += (behind + excess[mine]).min(axis=1)
        return np.asarray(self.bound() + excess + least)

    def exclude_pairs(self, cutoff: float) -> int:
        """Exclude the pairs of labels that no layout below the cutoff uses; how many.

        For every third variable the label counts that costs least with both.
        """
        gap = np.float32(cutoff - self.bound())
        excess, pairs = self.excess().astype(np.float32), self.both_ways().astype(np.float32)
        found = 0
        for variable, mine in enumerate(self.slices[:-1]):
            later = slice(mine.stop, None)
            total = self._pair_lower_bounds(variable, excess, pairs)
            bad = (total >= gap * np.float32(1 + MARGIN) + np.float32(EPSILON)) & np.isfinite(pairs[mine, later])
            found += int(bad.sum())
            self.pairs[mine, later][bad] = np.inf
            pairs[mine, later][bad] = np.inf
            pairs[later, mine][bad.T] = np.inf
        return found

    def _pair_lower_bounds(self, variable: int, excess: Singles, pairs: Singles) -> Singles:
        """(labels, later labels) what layouts cost above the bound that use a label of one variable and a later one."""
        mine, slices = self.slices[variable], self.slices
        later = slice(mine.stop, None)
        total = excess[mine, None] + excess[later] + pairs[mine, later]
        first = self.owner[later]
        for third, other in enumerate(slices):
            if third == variable:
                continue
            own = pairs[mine, other] + excess[other]
            least = np.full(total.shape, np.inf, dtype=np.float32)
            room = np.empty_like(least)
            for at in range(other.stop - other.start):
                np.add(own[:, at, None], pairs[other.start + at, later], out=room)
                np.minimum(least, room, out=least)
            if third > variable:
                least[:, first == third] = 0.0
            total += least
        return np.asarray(total)


def reduced(problem: ReducedProblem, cutoff: float) -> ReducedProblem | None:
    """The problem without the labels that no layout below the cutoff uses; None if one variable has none left."""
    while True:
        alive = problem.label_lower_bounds() < cutoff
        if not np.logical_or.reduceat(alive, problem.start[:-1]).all():
            return None
        if alive.all():
            return problem
        problem = problem.restricted(alive)
