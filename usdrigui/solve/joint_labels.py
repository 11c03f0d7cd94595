"""Two variables that are in each other's way made one, whose labels are the pairs that are left.

What a joint label costs with a label of a third variable is what both cost with it.  So bounds by
pairs, and tests of pairs, see three and four variables of the problem at a time; joined again, up
to eight.  This is the join of weighted constraints (J. Larrosa and R. Dechter, "Boosting search
with variable elimination in constraint optimization and constraint satisfaction problems", 2003),
of which bounds at once take away nearly all.
"""

from __future__ import annotations

import itertools

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.solve.reduced_problem import LARGEST_TESTED, ReducedProblem

MOST = 500
"""Labels that joining may come to, unless no two variables have so few."""

Pair = tuple[int, int]


def couples(problem: ReducedProblem) -> list[Pair]:
    """Variables to join, each once: first those with the smallest share of pairs that are left, so
    that labels become few more."""
    allowed = np.isfinite(problem.both_ways()).astype(np.float64)
    left = np.add.reduceat(np.add.reduceat(allowed, problem.start[:-1]), problem.start[:-1], axis=1)
    sizes = np.diff(problem.start)
    linked = np.argwhere(np.triu(problem.linked))
    share = (left / np.outer(sizes, sizes))[tuple(linked.T)]
    more = (left - sizes - sizes[:, None])[tuple(linked.T)]
    room = max(MOST - len(problem.costs), more.min(initial=np.inf))
    room = min(room, LARGEST_TESTED - len(problem.costs))
    found: list[Pair] = []
    for at in np.argsort(share, kind="stable").tolist():
        a, b = linked[at].tolist()
        if more[at] <= room and not {a, b} & set(itertools.chain(*found)):
            found.append((a, b))
            room -= more[at]
    return found


class Joint:
    """Labels of joined variables: each is one or two of those of another problem."""

    def __init__(self, problem: ReducedProblem, joined: list[Pair]) -> None:
        both, nothing = problem.both_ways(), len(problem.costs)
        partner, second = dict(joined), {b for _, b in joined}
        parts = []
        for a in sorted(set(range(problem.count)) - second):
            mine = problem.slices[a]
            ends = np.mgrid[mine, nothing : nothing + 1].reshape(2, -1)
            if a in partner:
                other = problem.slices[partner[a]]
                left = np.argwhere(np.isfinite(both[mine, other]))
                ends = (left + np.array([mine.start, other.start])).T
            parts.append(ends)
        self.first, self.second = np.hstack(parts)
        self.owner = np.repeat(np.arange(len(parts)), [ends.shape[1] for ends in parts])
        costs, pairs = self.alone(problem.costs, both), self.together(both)
        self.problem = ReducedProblem(
            self.owner, np.arange(len(costs)), costs, pairs, problem.constant
        )
        """What triplets cost is left out: it is not below 0."""

    def alone(self, linear: Floats, pairs: Floats) -> Floats:
        """(n,) what joint labels cost alone, from linear and pair costs of the other problem."""
        linear, pairs = np.append(linear, 0.0), np.pad(pairs, (0, 1))
        return np.asarray(linear[self.first] + linear[self.second] + pairs[self.first, self.second])

    def together(self, pairs: Floats) -> Floats:
        """(n, n) what joint labels cost together; 0 within a variable."""
        pairs, ends = np.pad(pairs, (0, 1)), (self.first, self.second)
        found = np.zeros((len(self.owner), len(self.owner)))
        for one, other in itertools.product(ends, repeat=2):
            found += pairs[np.ix_(one, other)]
        return np.where(self.owner[:, None] == self.owner, 0.0, found)

    def members(self, members: Indices) -> Indices:
        """(n, variables) of those of the other problem's labels, -1 for none."""
        members = np.pad(members, ((0, 1), (0, 0)), constant_values=-1)
        return np.asarray(np.maximum(members[self.first], members[self.second]))
