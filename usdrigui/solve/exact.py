"""The whole problem with a proof: local search, sound reduction by bounds, search on what no bound decides."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import Assignment, LayoutProblem
from usdrigui.solve.assignment import assignment, forbidden_price
from usdrigui.solve.blocks import all_labels
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.reduce import reduce
from usdrigui.solve.watch import Watch

TRIES = 12
"""Attempts of large-neighbourhood search per variable before the proof begins."""


def solve_whole(problem: LayoutProblem, watch: Watch) -> Assignment:
    """Best layout over every candidate of every variable, with a lower bound (paper eq. 2-5, unreduced).

    Raises SOLVE_INFEASIBLE when no layout is allowed.
    """
    labels = all_labels(problem)
    empty = [each.name for each, best in zip(problem.variables, labels.best, strict=True) if not np.isfinite(best)]
    if empty:
        raise refuse("SOLVE_INFEASIBLE", "solve", f"no candidate and no place beside the face for {', '.join(empty)}")
    if not problem.variables:
        watch.found("local search", cost=0.0, bound=0.0)
        return assignment(problem, labels, labels.label, watch, "highs")
    forbidden = forbidden_price(problem, labels)
    watch.ceiling = float(labels.best.sum()) + forbidden
    incumbent = Incumbent(problem, labels, forbidden, watch)
    incumbent.construct()
    watch.found("linear costs", bound=float(labels.best.sum()))
    incumbent.search(TRIES * len(problem.variables))
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
