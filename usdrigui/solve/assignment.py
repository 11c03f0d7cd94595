"""From labels to the record of a solution, and the prices that stand in for infinity."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import GAP_FLOOR, Assignment, Indices, LayoutProblem
from usdrigui.overlap import total_cost
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import Labels

SAFETY = 2e-11
"""Share of a bound, and of the least costs it is made of, taken off for rounding."""


def forbidden_price(problem: LayoutProblem, labels: Labels) -> float:
    """A finite stand-in for +inf: more than any allowed layout can cost above the sum of the least
    linear costs."""
    label_set = labels.label_set
    spread = np.maximum.reduceat(label_set.cost, label_set.start[:-1]) - labels.best
    copies = np.array([each.samples.shape[1] for each in problem.variables], dtype=np.float64)
    together = (copies.sum() ** 2 - np.square(copies).sum()) / 2
    overlaps = problem.overlap.weight * problem.overlap.maximum * together
    explicit = sum(
        each.costs.max(initial=0.0, where=np.isfinite(each.costs)) for each in problem.extra
    )
    return float(1.0 + spread.sum() + overlaps + explicit)


def allowed_below(least: float, forbidden: float) -> float:
    """What every allowed layout costs less than and every other one more, clear of rounding: the
    two are 1 apart.

    `least` is the sum of the least linear costs.
    """
    return least + forbidden - 0.5


def assignment(
    problem: LayoutProblem, labels: Labels, chosen: Indices, budget: Budget, method: str
) -> Assignment:
    """The record of a solution, its cost worked out by the objective itself.

    Raises SOLVE_INFEASIBLE when the layout has handles too near each other: either none is allowed,
    or the limits were too tight to find one.
    """
    cost = total_cost(problem, chosen)
    if not np.isfinite(cost):
        raise refuse(
            "SOLVE_INFEASIBLE",
            "solve",
            f"no place apart from the others for {_stuck(problem, chosen)}",
        )
    rounding = SAFETY * (abs(budget.bound) + float(np.abs(labels.best).sum()))
    bound = min(budget.bound - rounding, cost) if np.isfinite(budget.bound) else -np.inf
    # A bound that reaches the cost proves it at a gap of 0, too: neither what is taken off for
    # rounding nor the sums of the two costs, in other orders, keep it open.
    closed = cost - bound <= budget.settings.gap * max(abs(cost), GAP_FLOOR) + 2 * rounding
    return Assignment(
        labels=chosen,
        cost=cost,
        bound=bound,
        status="optimal" if closed else "stopped",
        in_play=max(0.0, cost - float(labels.best.sum())),
        method=method,
        closed_by=method if closed else budget.limit,
        steps=tuple(budget.steps),
    )


def _stuck(problem: LayoutProblem, chosen: Indices) -> str:
    """Names of the variables whose handles are too near another's."""
    names = []
    for at, variable in enumerate(problem.variables):
        others = [
            other
            for other in range(len(chosen))
            if other != at and _clash(problem, (at, other), (int(chosen[at]), int(chosen[other])))
        ]
        if others:
            names.append(variable.name)
    return ", ".join(names)


def _clash(problem: LayoutProblem, pair: tuple[int, int], labels: tuple[int, int]) -> bool:
    if min(labels) < 0 or not problem.together[pair]:
        return False
    one, other = (
        problem.variables[at].handles[label] for at, label in zip(pair, labels, strict=True)
    )
    return bool((np.linalg.norm(one[:, None] - other[None], axis=-1) < problem.separation).any())
