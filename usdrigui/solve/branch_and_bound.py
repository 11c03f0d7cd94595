"""An exact search of our own for what HiGHS does not close with its share of the work: dense
crowds.

Depth first.  A node is a smaller problem of the same kind.  Dual ascent, the tests of labels and
pairs, and dominance make it smaller still; variables with one label left are folded into the costs
of the others.  It branches on a variable with few labels that took part in many failures (F.
Boussemart et al., "Boosting systematic search by weighting constraints", 2004).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from usdrigui.model import Flags, Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.dominance import undominated
from usdrigui.solve.reduced_problem import ReducedProblem, Solution, reduced


class _Node(NamedTuple):
    problem: ReducedProblem
    variables: Indices
    """(count,) their numbers in the whole problem."""
    fixed: Indices
    """Labels, by their places in the whole problem, of the variables that are folded."""


class _Branch(NamedTuple):
    node: _Node
    alive: Flags
    """Labels of the node that are left."""
    bound: float
    """No layout of these costs less."""


def branch_and_bound(
    problem: ReducedProblem, linear: Floats, pairs: Floats, cutoff: float, budget: Budget
) -> Solution:
    """Best layout of a reduced problem that costs less than the cutoff, or the proof that there is
    none.

    `linear` (n,) and `pairs` (n, n) are the costs of its labels without messages.  The bound of a
    search that `budget` stops holds.
    """
    return _Search(problem, linear, pairs, cutoff, budget).solved()


class _Search:
    """Nodes that are open, and which variables made others fail."""

    def __init__(
        self, problem: ReducedProblem, linear: Floats, pairs: Floats, cutoff: float, budget: Budget
    ) -> None:
        self._whole, self._cutoff, self._budget = problem, cutoff, budget
        self._linear, self._pairs = linear, pairs + pairs.T
        without_messages = np.where(np.isinf(problem.matrix()), np.inf, pairs)
        self._root = ReducedProblem(problem.owner, np.arange(len(linear)), linear, without_messages)
        self._failures = np.ones(problem.count)
        self._best: Indices | None = None
        self._nodes = 0

    def solved(self) -> Solution:
        """Search all layouts below the cutoff."""
        cutoff, bound = self._cutoff, self._whole.bound()
        everything = np.ones(len(self._linear), dtype=bool)
        whole = _Node(self._root, np.arange(self._whole.count), np.empty(0, dtype=np.int64))
        open_ = [_Branch(whole, everything, bound)]
        while open_ and not self._budget.stopped():
            branch = open_.pop()
            if branch.bound < self._cutoff:
                self._nodes += 1
                open_ += self._branches(_folded(branch.node, branch.alive))
        bound = max(bound, min((branch.bound for branch in open_), default=self._cutoff))
        figures = {"labels": len(self._linear), "nodes": self._nodes, "cutoff": cutoff}
        return Solution(min(bound, self._cutoff), self._best, figures)

    def _branches(self, node: _Node) -> list[_Branch]:
        """The branches of a node that bounds do not close, the likeliest last; a layout that is
        found is kept."""
        left = self._tested(node)
        if left is None:
            np.add.at(self._failures, node.variables, 1.0 / np.diff(node.problem.start))
            return []
        sizes = np.diff(left.start)
        if (sizes <= 1).all():
            self._keep(node, left)
            return []
        weights = np.where(sizes > 1, sizes / self._failures[node.variables], np.inf)
        mine = left.slices[int(weights.argmin())]
        bounds = left.label_lower_bounds()
        found = []
        for label in range(mine.start, mine.stop):
            alive = np.ones(len(left.costs), dtype=bool)
            alive[mine] = False
            alive[label] = True
            found.append(_Branch(node._replace(problem=left), alive, float(bounds[label])))
        return sorted(found, key=lambda each: -each.bound)

    def _tested(self, node: _Node) -> ReducedProblem | None:
        """The problem of a node after ascent, tests and dominance; None when no layout below the
        cutoff is left."""
        problem = node.problem
        self._budget.spend(50 + len(problem.costs) ** 2 // 16 + len(problem.costs) ** 3 // 1024)
        if not problem.count:
            return problem if problem.constant < self._cutoff else None
        problem.normalize()
        problem.sweep()
        problem.normalize()
        left = reduced(problem, self._cutoff)
        if left is None:
            return None
        left.exclude_pairs(self._cutoff)
        left = reduced(left, self._cutoff)
        return None if left is None else left.restricted(self._undominated(left, node.fixed))

    def _undominated(self, left: ReducedProblem, fixed: Indices) -> Flags:
        mine = left.labels
        linear = self._linear[mine] + self._pairs[np.ix_(mine, fixed)].sum(axis=1)
        return undominated(
            left.start, linear, self._pairs[np.ix_(mine, mine)], np.isinf(left.both_ways())
        )

    def _keep(self, node: _Node, left: ReducedProblem) -> None:
        """Remember a layout below the cutoff, which becomes the next one."""
        chosen = np.sort(np.concatenate([node.fixed, left.labels]))
        cost = float(self._linear[chosen].sum() + self._pairs[np.ix_(chosen, chosen)].sum() / 2)
        if cost < self._cutoff:
            self._cutoff, self._best = cost, chosen


def _folded(node: _Node, alive: Flags) -> _Node:
    """A node with the labels that are alive; variables with one are folded into the costs of the
    others."""
    left = node.problem.restricted(alive)
    single = np.diff(left.start) == 1
    fixed = single[left.owner]
    costs = left.costs + left.costs_with(fixed)
    allowed = np.logical_or.reduceat(np.isfinite(costs), left.start[:-1])
    if not (single.any() and allowed.all()):  # Excluded pairs close the second kind.
        return node._replace(problem=left)
    constant = left.constant + (left.costs[fixed].sum() + costs[fixed].sum()) / 2
    rest = ~fixed & np.isfinite(costs)
    smaller = left.of_variables(rest, costs[rest], float(constant))
    return _Node(smaller, node.variables[~single], np.concatenate([node.fixed, left.labels[fixed]]))
