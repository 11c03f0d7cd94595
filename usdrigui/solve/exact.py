"""The whole problem with a proof: local search, reduction by bounds, search on what is left."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import Assignment, LayoutProblem
from usdrigui.solve.assignment import assignment
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import LabelSet, all_labels
from usdrigui.solve.local_search import KnownRows, LazyRows, LocalSearch
from usdrigui.solve.pair_costs import NearPairs, pair_costs
from usdrigui.solve.partition import ONE_BY_ONE, near_one_by_one
from usdrigui.solve.reduce import Reduction
from usdrigui.solve.toulbar2 import check_installed, solve_by_toulbar2

DEARER = 0.18
"""The first layout is one of labels that cost no more than this above their variable's cheapest."""
TRIES, TRAPS = 16, 0.5
"""Of local search per variable, and how much worse it may get on the way: a crowd has many
traps."""


def solve_whole(problem: LayoutProblem, budget: Budget) -> Assignment:
    """Best layout over every candidate of every variable, with a lower bound (paper eq. 2-5,
    unreduced).

    Raises SOLVE_INFEASIBLE when no layout is allowed.
    """
    if budget.settings.method == "toulbar2":
        check_installed()
    labels = all_labels(problem)
    empty = [problem.variables[at].name for at in np.flatnonzero(np.diff(labels.start) == 0)]
    if empty:
        names = ", ".join(empty)
        message = f"no candidate and no place on the board for {names}"
        raise refuse("SOLVE_INFEASIBLE", "solve", message)
    if not problem.variables:
        budget.found("local search", cost=0.0, bound=0.0)
        return assignment(problem, labels, labels.candidate, budget, "bounds")
    least, count, method = float(labels.best.sum()), len(labels.cost), "bounds"
    # Layouts with a forbidden pair cost at least 1 more than all that are allowed.
    budget.ceiling = least + infeasible_penalty(problem, labels) - 0.5
    budget.found("linear costs", bound=least)
    labels, near, incumbent = _first_layout(problem, labels, budget)
    budget.note("local search", cost=incumbent.cost, labels=count, work=budget.work)
    left = Reduction(problem, labels, near, budget, incumbent)
    any_left = left.done()
    figures = left.figures() if any_left else {"labels": 0}
    found = {"cutoff": budget.cutoff, "cost": incumbent.cost, "bound": budget.bound}
    budget.note("reduce", **figures, **found, work=budget.work)
    if any_left and left.exact and not budget.over():
        method = _solve_reduced(left, incumbent, budget)
    return assignment(problem, labels, labels.candidate[incumbent.chosen], budget, method)


def infeasible_penalty(problem: LayoutProblem, labels: LabelSet) -> float:
    """A finite stand-in for +inf: more than any allowed layout can cost above the sum of the least
    linear costs."""
    spread = np.maximum.reduceat(labels.cost, labels.start[:-1]) - labels.best
    copies = np.array([each.samples.shape[1] for each in problem.variables], dtype=np.float64)
    together = (copies.sum() ** 2 - np.square(copies).sum()) / 2
    overlaps = problem.overlap.most * together
    allowed = [each.costs[np.isfinite(each.costs)] for each in problem.extra]
    explicit = sum(each.max(initial=0.0) for each in allowed)
    return float(1.0 + spread.sum() + overlaps + explicit)


def _first_layout(
    problem: LayoutProblem, labels: LabelSet, budget: Budget
) -> tuple[LabelSet, list[NearPairs] | None, LocalSearch]:
    """A good layout, and the labels that a better one may use, with all their near pairs where they
    are few.

    What a label costs against all others is dear to work out where there are many, so a layout of
    labels nearly as cheap as the cheapest comes first: good layouts have hardly any others.
    """
    penalty = infeasible_penalty(problem, labels)

    def search_among(some: LabelSet, rows: KnownRows | LazyRows) -> LocalSearch:
        return LocalSearch(some.start, some.cost, rows, budget, penalty, tell=True)

    first = None
    if len(labels.cost) > ONE_BY_ONE:
        few = np.flatnonzero(labels.cost - labels.best[labels.variable] <= DEARER)
        some = labels.of(few)
        rough = search_among(some, LazyRows(problem, some, budget))
        rough.construct()
        rough.search(TRIES, TRAPS)
        wanted = labels.active_below(rough.cost)
        wanted[few[rough.chosen]] = True
        first = (np.cumsum(wanted) - 1)[few[rough.chosen]]
        labels = labels.of(np.flatnonzero(wanted))
    near = near_one_by_one(problem, labels, budget)
    rows: KnownRows | LazyRows = LazyRows(problem, labels, budget)
    if near is not None:
        rows = KnownRows(pair_costs(problem, labels, near))
    incumbent = search_among(labels, rows)
    if first is None:
        incumbent.construct()
    else:
        incumbent.improve_from(first)
    incumbent.search(TRIES, TRAPS, budget.settings.work_limit / 2)
    return labels, near, incumbent


# --- what is left ---------------------------------------------------------------------------------


def _solve_reduced(left: Reduction, incumbent: LocalSearch, budget: Budget) -> str:
    """Give what is left to the solver that the settings name as soon as its program is small: until
    then triplets of variables raise the bound of many labels, variables of few are joined, as long
    as there are any to join, and triplets of them raise it again; the name of the step that had the
    last turn."""
    name = ""
    while not (budget.over() or left.small()):
        if left.joined():
            name = "joining"
        else:
            last, name = name, "triplets"
            left.tightened()
            if last:
                break
    if name:
        budget.note(name, **left.figures(), bound=budget.bound, work=budget.work)
    if not budget.over():
        _search(left, incumbent, budget)
    return budget.steps[-1].name


def _search(left: Reduction, incumbent: LocalSearch, budget: Budget) -> None:
    """Search what is left with all the work that is."""
    method, cutoff, rest = budget.settings.method, budget.cutoff, left.plain()
    if method == "toulbar2":
        found = solve_by_toulbar2(rest, cutoff, budget)
    else:
        from usdrigui.solve.milp import solve_milp

        found = solve_milp(rest, cutoff, budget, budget.settings.work_limit)
    if found.chosen is not None:
        incumbent.improve_from(left.representatives(found.chosen))
    budget.found(method, bound=found.bound)
    figures = {"labels": len(rest.linear), "pairs": rest.costly_pairs(), **found.figures}
    budget.note(method, **figures, cutoff=cutoff, bound=found.bound, work=budget.work)
