"""An exact search of our own for what HiGHS does not close in its first turn: dense crowds.

Depth first.  A node is a smaller problem of the same kind.  Dual ascent and the tests of labels and
pairs make it smaller still; variables with one label left are folded into the costs of the others.
It branches on a variable with few labels that took part in many failures (F. Boussemart et al.,
"Boosting systematic search by weighting constraints", 2004).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import LARGEST_TESTED, ReducedProblem, Solution, reduced


class _Node(NamedTuple):
    problem: ReducedProblem
    variables: Indices
    """(count,) their numbers in the whole problem."""
    fixed: Indices
    """Labels, by their places in the whole problem, of the variables that are folded."""


class _Branch(NamedTuple):
    bound: float
    """No layout of these costs less."""
    node: _Node
    alive: Flags
    """Labels of the node that are left."""


def branch_and_bound(
    problem: ReducedProblem, linear: Floats, pairs: Floats, cutoff: float, budget: Budget, most: int
) -> Solution:
    """Best layout of a reduced problem that costs less than the cutoff, or the proof that there is
    none.

    `linear` (n,) and `pairs` (n, n) are the costs of its labels without messages, +inf for pairs
    that are excluded.  The bound of a search that ends after `most` work in all holds.
    """
    root = ReducedProblem(problem.owner, np.arange(len(linear)), linear, pairs)
    whole = _Node(root, np.arange(problem.count), np.empty(0, dtype=np.int64))
    open_ = [_Branch(problem.bound(), whole, np.ones(len(linear), dtype=bool))]
    failures, least, best, nodes = np.ones(problem.count), cutoff, None, 0
    while open_ and budget.work < most and not budget.stopped():
        branch = open_.pop()
        if branch.bound >= least:
            continue
        nodes += 1
        node = _folded(branch.node, branch.alive)
        left = _tested(node.problem, least, budget)
        if left is None:
            failures[node.variables] += 1.0 / np.diff(node.problem.start)
        elif len(left.costs) > left.count:
            open_ += _branches(node._replace(problem=left), failures)
        else:
            chosen = np.sort(np.concatenate([node.fixed, left.labels]))
            if root.value(chosen) < least:
                least, best = root.value(chosen), chosen
    bound = max(problem.bound(), min((branch.bound for branch in open_), default=cutoff))
    return Solution(min(bound, least), best, {"nodes": nodes})


def _tested(problem: ReducedProblem, cutoff: float, budget: Budget) -> ReducedProblem | None:
    """A node's problem after ascent and tests; None when no layout below the cutoff is left."""
    budget.spend(2000 + len(problem.costs) ** 2 // 16 + len(problem.costs) ** 3 // 1024)
    if not problem.count:
        return problem if problem.constant < cutoff else None
    problem.normalize()
    problem.sweep()
    problem.normalize()
    left = reduced(problem, cutoff)
    if left is None:
        return None
    if len(left.costs) <= LARGEST_TESTED:
        left.exclude_pairs(cutoff)
    return reduced(left, cutoff)


def _branches(node: _Node, failures: Floats) -> list[_Branch]:
    """The branches of a node that bounds do not close, the likeliest last."""
    left = node.problem
    sizes = np.diff(left.start)
    weights = np.where(sizes > 1, sizes / failures[node.variables], np.inf)
    mine = left.slices[int(weights.argmin())]
    bounds, numbers = left.label_lower_bounds(), np.arange(len(left.costs))
    others = left.owner != left.owner[mine.start]
    labels = mine.start + np.argsort(-bounds[mine], kind="stable")
    return [_Branch(float(bounds[each]), node, others | (numbers == each)) for each in labels]


def _folded(node: _Node, alive: Flags) -> _Node:
    """A node with the labels alive; variables with one are folded into the costs of others."""
    left = node.problem.restricted(alive)
    single = np.diff(left.start) == 1
    fixed = single[left.owner]
    costs = left.costs + left.both_ways()[fixed].sum(axis=0)
    allowed = np.logical_or.reduceat(np.isfinite(costs), left.start[:-1])
    if not (single.any() and allowed.all()):  # Excluded pairs close the second kind.
        return node._replace(problem=left)
    constant = left.constant + (left.costs[fixed].sum() + costs[fixed].sum()) / 2
    rest = ~fixed & np.isfinite(costs)
    smaller = left.of_variables(rest, costs[rest], float(constant))
    return _Node(smaller, node.variables[~single], np.concatenate([node.fixed, left.labels[fixed]]))
