"""The whole problem with a proof: local search, sound reduction by bounds, search on what no bound
decides."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import Assignment, Indices, LayoutProblem
from usdrigui.solve.assignment import allowed_below, assignment, forbidden_price
from usdrigui.solve.branch_and_bound import branch_and_bound
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import (
    Labels,
    all_labels,
    cheapest,
    halve,
    in_play,
    selected,
    whole,
)
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.milp import solve_milp
from usdrigui.solve.partition import affordable_at_once
from usdrigui.solve.reduce import Partition, reduce
from usdrigui.solve.reduced_problem import Solution
from usdrigui.solve.toulbar2 import check_installed, solve_by_toulbar2

HALVINGS = 6
"""The first layout is sought among the cheapest labels of 2 ** HALVINGS places of every
variable."""
TRIES = 2
"""Attempts of large-neighbourhood search per variable, and again as long as they help."""
HIGHS_SHARE = 0.01
"""Of the work allowed, before what it has not closed goes to branch and bound (decision 030)."""


def solve_whole(problem: LayoutProblem, budget: Budget) -> Assignment:
    """Best layout over every candidate of every variable, with a lower bound (paper eq. 2-5,
    unreduced).

    Raises SOLVE_INFEASIBLE when no layout is allowed.
    """
    if budget.settings.method == "toulbar2":
        check_installed()
    labels = all_labels(problem)
    empty = [
        each.name
        for each, best in zip(problem.variables, labels.best, strict=True)
        if not np.isfinite(best)
    ]
    if empty:
        raise refuse(
            "SOLVE_INFEASIBLE",
            "solve",
            f"no candidate and no place on the board for {', '.join(empty)}",
        )
    if not problem.variables:
        budget.found("local search", cost=0.0, bound=0.0)
        return assignment(problem, labels, labels.label, budget, "bounds")
    forbidden = forbidden_price(problem, labels)
    budget.ceiling = allowed_below(float(labels.best.sum()), forbidden)
    budget.found("linear costs", bound=float(labels.best.sum()))
    count, method = len(labels.label), "bounds"
    labels, incumbent = _first_layout(problem, labels, forbidden, budget)
    budget.note("local search", cost=incumbent.cost, labels=count, work=budget.work)
    left = reduce(problem, labels, budget, incumbent)
    budget.note(
        "reduce", **_figures(left), cost=incumbent.cost, bound=budget.bound, work=budget.work
    )
    if left is not None and left.exact and not budget.closed() and not budget.stopped():
        method = _solve_reduced(labels, left, incumbent, budget)
    return assignment(problem, labels, labels.label[incumbent.chosen], budget, method)


def _solve_reduced(labels: Labels, left: Partition, incumbent: Incumbent, budget: Budget) -> str:
    """Give what is left to the solver that the settings name, and to branch and bound what HiGHS
    does not close with its share of the work; the name of the last."""
    linear, pairs = left.label_set.cost[left.problem.labels], left.pairs.matrix()
    if budget.settings.method == "toulbar2":
        found = solve_by_toulbar2(left.problem, linear, pairs, budget.cutoff, budget)
        return _told("toulbar2", found, labels, left, incumbent, budget)
    share = int(HIGHS_SHARE * budget.settings.work_limit)
    found = solve_milp(left.problem, budget.cutoff, budget, share)
    method = _told("highs", found, labels, left, incumbent, budget)
    if budget.closed() or budget.stopped():
        return method
    found = branch_and_bound(left.problem, linear, pairs, budget.cutoff, budget)
    return _told("branch and bound", found, labels, left, incumbent, budget)


def _told(
    method: str,
    found: Solution,
    labels: Labels,
    left: Partition,
    incumbent: Incumbent,
    budget: Budget,
) -> str:
    """Keep what a solver found and note its figures; its name."""
    if found.chosen is not None:
        incumbent.improve_from(left.representatives(labels, found.chosen))
    budget.found(method, bound=found.bound)
    budget.note(method, **found.figures, bound=found.bound, work=budget.work)
    return method


def _figures(left: Partition | None) -> dict[str, float]:
    """What the reduction has left."""
    if left is None:
        return {"labels": 0}
    problem = left.problem
    return {
        "blocks": len(problem.labels),
        "labels": int(left.blocks.sizes[problem.labels].sum()),
        "excluded_pairs": sum(int(np.isinf(each).sum()) for each in problem.tables.strips),
        "triplets": len(problem.messages),
    }


def _first_layout(
    problem: LayoutProblem, labels: Labels, forbidden: float, budget: Budget
) -> tuple[Labels, Incumbent]:
    """A good layout, and the labels that a better one may use."""
    if affordable_at_once(labels, budget):
        incumbent = Incumbent(problem, labels, forbidden, budget)
        incumbent.construct()
    else:
        labels, chosen = _roughly(problem, labels, forbidden, budget)
        incumbent = Incumbent(problem, labels, forbidden, budget)
        incumbent.start_from(chosen)
    cost = np.inf
    while incumbent.cost < cost and not (budget.stopped() or budget.closed()):
        cost = incumbent.cost
        incumbent.search(TRIES * len(problem.variables))
    return labels, incumbent


def _roughly(
    problem: LayoutProblem, labels: Labels, forbidden: float, budget: Budget
) -> tuple[Labels, Indices]:
    """The labels that a layout better than a rough one may use, and those among them that the rough
    one chooses.

    What a label costs against all others is dear to work out where there are many, so a layout of
    few labels, far apart, comes first: it rules out most of the others by their linear costs alone.
    """
    rough = _cheapest_places(labels)
    incumbent = Incumbent(problem, selected(labels, rough), forbidden, budget)
    incumbent.construct()
    incumbent.search(TRIES * len(problem.variables))
    chosen = rough[incumbent.chosen]
    wanted = np.zeros(len(labels.label), dtype=bool)
    wanted[in_play(labels, incumbent.cost)] = True
    wanted[chosen] = True
    kept = np.flatnonzero(wanted)
    return selected(labels, kept), np.searchsorted(kept, chosen)


def _cheapest_places(labels: Labels) -> Indices:
    """The cheapest labels of some places of every variable, ascending."""
    blocks = whole(labels)
    for _ in range(HALVINGS):
        blocks, _parent = halve(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
    return np.sort(cheapest(labels, blocks))
