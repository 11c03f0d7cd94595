"""From labels to the record of a solution."""

from __future__ import annotations

import itertools

import numpy as np

from usdrigui.character import Indices
from usdrigui.errors import refuse
from usdrigui.model import Assignment, LayoutProblem
from usdrigui.overlap import ROUNDING, pair_costs, total_cost
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import LabelSet


def assignment(
    problem: LayoutProblem, labels: LabelSet, chosen: Indices, budget: Budget, method: str
) -> Assignment:
    """The record of a solution, its cost worked out by the objective itself.

    Raises SOLVE_INFEASIBLE when the layout has handles too near each other: either none is allowed,
    or the limits were too tight to find one.
    """
    cost = total_cost(problem, chosen)
    if not np.isfinite(cost):
        names = ", ".join(_too_near(problem, chosen))
        problem_met = f"no place apart from the others for {names}"
        if budget.limit:
            problem_met = f"no layout before the {budget.limit}: {problem_met} yet"
        raise refuse("SOLVE_INFEASIBLE", "solve", problem_met)
    # Of a bound and of the least costs it is made of: thousands of numbers are added up.
    rounding = 20 * ROUNDING * (abs(budget.bound) + float(np.abs(labels.best).sum()))
    bound = min(budget.bound - rounding, cost) if np.isfinite(budget.bound) else -np.inf
    # A bound that reaches the cost proves it at a gap of 0, too: neither what is taken off for
    # rounding nor the sums of the two costs, in other orders, keep it open.
    closed = budget.proves(cost, bound, 2 * rounding)
    return Assignment(
        labels=chosen,
        cost=cost,
        bound=bound,
        status="optimal" if closed else "stopped",
        above_unary_bound=max(0.0, cost - float(labels.best.sum())),
        method=method,
        closed_by=method if closed else budget.limit,
        steps=tuple(budget.steps),
    )


def _too_near(problem: LayoutProblem, chosen: Indices) -> list[str]:
    """Names of the variables whose handles are too near another's."""
    found = set()
    for a, b in itertools.combinations(range(len(chosen)), 2):
        if np.isinf(pair_costs(problem, a, b, chosen[[a]], chosen[[b]])).any():
            found |= {a, b}
    return [problem.variables[at].name for at in sorted(found)]
