"""The subproblems of the exact search: a few variables with their costs in one matrix, worked on by dual ascent."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from usdrigui.model import Flags, Floats, Indices
from usdrigui.solve.tables import Table

EPSILON = 1e-11
ROOT_SWEEPS = 10


def whole_part(unary: Sequence[Floats], tables: Sequence[Table], forbidden: float) -> Part:
    """The part that is the whole of a pairwise problem."""
    sizes = [len(each) for each in unary]
    start = np.concatenate([[0], np.cumsum(sizes)])
    matrix = np.zeros((start[-1], start[-1]))
    for table in tables:
        rows, columns = start[table.first] + table.rows, start[table.second] + table.columns
        matrix[np.ix_(rows, columns)] = np.minimum(table.costs, forbidden)
    owner = np.repeat(np.arange(len(sizes)), sizes)
    entries = np.concatenate([np.arange(size) for size in sizes])
    return Part(np.arange(len(sizes)), owner, entries, np.concatenate(unary), matrix)


class Part:
    """A pairwise problem over a few variables, its costs in one matrix, with the dual ascent built in.

    The matrix holds the tables of all pairs of variables above its diagonal blocks.  Multipliers are worked
    into the costs at once, so costs and matrix are always a reparametrisation of the original.
    """

    def __init__(self, variables: Indices, owner: Indices, entries: Indices, costs: Floats, matrix: Floats) -> None:
        self.variables = variables
        """(k,) names of the variables."""
        self.owner = owner
        """(n,) position of each entry's variable, ascending."""
        self.entries = entries
        """(n,) entry of the original problem."""
        self.costs = costs
        self.matrix = matrix
        self.start = np.searchsorted(owner, np.arange(len(variables) + 1))
        self.sizes = self.start[1:] - self.start[:-1]
        """(k,) number of entries of each variable."""
        self.constant = 0.0
        self.taken: dict[int, int] = {}
        """Entries of the variables that were folded into the costs."""
        self.linked: Flags = np.zeros((len(variables), len(variables)), dtype=bool)

    def settle(self) -> None:
        """Take the constants out of the tables, so that none is below 0, and note which variables are linked at all."""
        least, most = self._of_pairs(np.minimum), self._of_pairs(np.maximum)
        self.constant += float(least.sum())
        if least.any():
            self.matrix -= least[self.owner][:, self.owner]
        ahead = most - least > EPSILON
        self.linked = ahead | ahead.T

    def _of_pairs(self, extreme: np.ufunc) -> Floats:
        """(k, k) least or largest cost in the table of each pair of variables, above the diagonal."""
        found = np.zeros((len(self.sizes), len(self.owner)))
        ends = self.start.tolist()
        for at, (low, high) in enumerate(itertools.pairwise(ends[:-1])):
            extreme.reduce(self.matrix[low:high, high:], axis=0, out=found[at, high:])
        return np.asarray(extreme.reduceat(found, self.start[:-1], axis=1))

    def sweep(self) -> None:
        """One pass of dual ascent over the variables and one back (see `usdrigui.solve.bounds`).

        Afterwards as before no table has a cost below 0.
        """
        matrix, costs, start = self.matrix, self.costs, self.start.tolist()
        linked = self.linked[:, self.owner].astype(np.float64)
        ahead, behind = np.triu(self.linked).sum(axis=1), np.tril(self.linked).sum(axis=1)
        portion = 1.0 / np.maximum(np.maximum(ahead, behind), 1)
        count = len(self.sizes)
        for at in np.flatnonzero(ahead).tolist():
            low, high = start[at], start[at + 1]
            block, mine = matrix[low:high, high:], costs[low:high]
            share = (mine * portion[at])[:, None]
            block += share if ahead[at] == count - 1 - at else share * linked[at, high:]
            mine *= 1.0 - portion[at] * ahead[at]
            message = np.minimum.reduce(block, axis=0)
            block -= message
            costs[high:] += message
        for at in np.flatnonzero(behind)[::-1].tolist():
            low, high = start[at], start[at + 1]
            block, mine = matrix[:low, low:high], costs[low:high]
            share = mine * portion[at]
            block += share if behind[at] == at else linked[at, :low, None] * share
            mine *= 1.0 - portion[at] * behind[at]
            message = np.minimum.reduce(block, axis=1)
            block -= message[:, None]
            costs[:low] += message

    def bounds(self) -> tuple[float, Floats]:
        """Lower bound of the part, and per entry a lower bound on the excess of solutions that use it.

        Counts on tables without costs below 0.
        """
        least = np.minimum.reduceat(self.costs, self.start[:-1])
        excess = self.costs - least[self.owner]
        both = self.matrix + self.matrix.T
        both += excess[:, None]
        stars = excess.copy()
        for low, high in itertools.pairwise(self.start.tolist()):
            stars += np.minimum.reduce(both[low:high], axis=0)  # 0 of the own variable: its least excess
        return self.constant + float(least.sum()), stars

    def restricted(self, alive: Flags) -> Part:
        """The part with the entries that are alive, at least one of every variable.

        Variables with one entry are folded into the costs of the others.
        """
        single = np.add.reduceat(alive, self.start[:-1], dtype=np.int64) == 1
        rest = alive & ~single[self.owner]
        part = self._kept(self.variables[~single], (np.cumsum(~single) - 1)[self.owner[rest]], rest)
        if single.any():
            rows = np.flatnonzero(alive & single[self.owner])
            part.costs += self._paid(rows, rest)
            part.constant += float(self.costs[rows].sum() + self.matrix[np.ix_(rows, rows)].sum())
            names = self.variables[single].tolist()
            part.taken = self.taken | dict(zip(names, self.entries[rows].tolist(), strict=True))
        return part

    def picked(self, positions: Indices) -> Part:
        """The part of some variables alone; nothing is taken yet, and its constant is 0."""
        chosen = np.zeros(len(self.variables), dtype=bool)
        chosen[positions] = True
        mine = chosen[self.owner]
        part = self._kept(self.variables[chosen], (np.cumsum(chosen) - 1)[self.owner[mine]], mine)
        part.constant, part.taken = 0.0, {}
        return part

    def components(self) -> list[Indices]:
        """Positions of the variables of each connected component."""
        label = np.arange(len(self.variables))
        if self.linked.sum(axis=1).max(initial=0) == len(label) - 1:
            return [label]
        while True:
            reached = np.where(self.linked, label, len(label)).min(axis=1, initial=len(label))
            new = np.minimum(label, reached)
            if (new == label).all():
                return [np.flatnonzero(label == each) for each in np.flatnonzero(label == np.arange(len(label)))]
            label = new

    def value(self, chosen: Indices) -> float:
        """Cost of one entry (index into the part) per variable."""
        return self.constant + float(self.costs[chosen].sum() + np.triu(self.matrix[np.ix_(chosen, chosen)], 1).sum())

    def _paid(self, taken: Indices, alive: Flags) -> Floats:
        """What the entries that are alive cost with those that are taken, of other variables."""
        return np.asarray((self.matrix[taken] + self.matrix[:, taken].T)[:, alive].sum(axis=0))

    def _kept(self, variables: Indices, owner: Indices, alive: Flags) -> Part:
        part = Part(variables, owner, self.entries[alive], self.costs[alive], self.matrix[alive][:, alive])
        part.constant, part.taken = self.constant, self.taken
        return part
