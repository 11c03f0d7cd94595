"""The whole problem with a proof: local search, sound reduction, then search on what is left."""

from __future__ import annotations

import numpy as np

from usdrigui.model import Assignment, Indices, LayoutProblem
from usdrigui.overlap import total_cost
from usdrigui.solve.blocks import Labels, all_labels
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.reduce import reduce
from usdrigui.solve.watch import Watch


TRIES = 150


def solve_whole(problem: LayoutProblem, watch: Watch) -> Assignment:
    """Best layout over every candidate of every variable, with a lower bound (paper eq. 2-5, unreduced)."""
    labels = all_labels(problem)
    forbidden = forbidden_price(problem, labels)
    incumbent = Incumbent(problem, labels, forbidden, watch)
    incumbent.construct()
    incumbent.search(TRIES)
    watch.note("local search", cost=incumbent.cost, labels=len(labels.label), work=watch.work)
    residual = reduce(problem, labels, forbidden, watch, incumbent.improve_from)
    watch.note(
        "blocks",
        cost=incumbent.cost,
        bound=watch.bound,
        blocks=len(residual.blocks.variable),
        labels=int(residual.blocks.sizes.sum()),
        work=watch.work,
    )
    return assignment(problem, labels, labels.label[incumbent.chosen], watch, "highs")


def forbidden_price(problem: LayoutProblem, labels: Labels) -> float:
    """A finite stand-in for +inf: more than any allowed layout can cost above the sum of the least linear costs."""
    pool = labels.pool
    spread = np.maximum.reduceat(pool.cost, pool.start[:-1]) - labels.best
    copies = np.array([each.samples.shape[1] for each in problem.variables], dtype=np.float64)
    together = (copies.sum() ** 2 - np.square(copies).sum()) / 2
    overlaps = problem.overlap.weight * problem.overlap.maximum * together
    return float(1.0 + spread.sum() + overlaps + sum(each.costs.sum() for each in problem.extra))


def assignment(problem: LayoutProblem, labels: Labels, chosen: Indices, watch: Watch, method: str) -> Assignment:
    """The record of a solution, with its cost worked out by the objective itself."""
    cost = total_cost(problem, chosen)
    bound = min(watch.bound, cost)
    closed = cost - bound <= watch.settings.gap * abs(cost)
    return Assignment(
        labels=chosen,
        cost=cost,
        bound=bound,
        status="optimal" if closed else "stopped",
        in_play=max(0.0, cost - float(labels.best.sum())),
        method=method,
        steps=tuple(watch.steps),
    )
