"""The whole problem with a proof: local search, reduction by bounds, search on what is left."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Indices
from usdrigui.errors import refuse
from usdrigui.model import Assignment, LayoutProblem
from usdrigui.solve.assignment import assignment
from usdrigui.solve.budget import Budget
from usdrigui.solve.cheap_labels import cheap_labels
from usdrigui.solve.label_geometry import LabelSet, all_labels
from usdrigui.solve.local_search import TRAPS, KnownRows, LazyRows, LocalSearch
from usdrigui.solve.reduce import SLOW, Reduction

FEW = 80
"""Labels a variable that the first bounds are worked out for: of tens of thousands they leave a
part, sooner than tables of all."""


def solve_whole(problem: LayoutProblem, budget: Budget) -> Assignment:
    """Best layout over every candidate of every variable, with a lower bound (paper eq. 2-5,
    unreduced).

    Raises SOLVE_INFEASIBLE when no layout is allowed.
    """
    labels = all_labels(problem)
    empty = [problem.variables[at].name for at in np.flatnonzero(np.diff(labels.start) == 0)]
    if empty:
        names = ", ".join(empty)
        message = f"no candidate and no place on the board for {names}"
        raise refuse("SOLVE_INFEASIBLE", "solve", message)
    if not problem.variables:
        budget.found("local search", cost=0.0, bound=0.0)
        return assignment(problem, labels, labels.candidate, budget, "bounds")
    least, penalty, method = float(labels.best.sum()), infeasible_penalty(problem, labels), "bounds"
    # Layouts with a forbidden pair cost at least 1 more than all that are allowed.
    budget.ceiling = least + penalty - 0.5
    budget.found("linear costs", bound=least)
    alive, chosen = np.ones(len(labels.cost), dtype=bool), np.empty(0, dtype=np.int64)
    most: float = FEW * len(problem.variables)
    wide = False
    while True:
        taken = cheap_labels(problem, labels, alive, chosen, most, budget)
        best = np.searchsorted(taken.place, chosen)
        incumbent = _layout_of(taken.labels, KnownRows(taken.pairs, penalty), best, budget)
        if most == np.inf and not wide and taken.stands.any():
            every, best = LazyRows(problem, labels, budget, penalty), taken.place[incumbent.chosen]
            chosen, wide = _layout_of(labels, every, best, budget).chosen, True
            continue  # Their labels are taken, too.
        budget.note("local search", cost=incumbent.cost, labels=len(taken.place), work=budget.work)
        left = Reduction(taken, budget, incumbent)
        any_left = left.done() and (most < np.inf or left.exact or left.tightened())
        figures = left.figures() if any_left else {"labels": 0}
        budget.note(
            "reduce",
            **figures,
            cutoff=budget.cutoff,
            cost=incumbent.cost,
            bound=budget.bound,
            work=budget.work,
        )
        if any_left and left.exact and not budget.over():
            method = _solve_reduced(left, incumbent, budget)
        chosen = taken.place[incumbent.chosen]
        if not any_left or left.exact or budget.over():
            break
        opened = taken.opened(labels, left.problem.labels, left.spare())
        if most == np.inf and opened.sum() > (1.0 - SLOW) * alive.sum():
            budget.reach(taken.limit)
            break
        alive, most = opened, np.inf
    return assignment(problem, labels, labels.candidate[chosen], budget, method)


def infeasible_penalty(problem: LayoutProblem, labels: LabelSet) -> float:
    """A finite stand-in for +inf: more than any allowed layout can cost above the sum of the least
    linear costs."""
    spread = np.maximum.reduceat(labels.cost, labels.start[:-1]) - labels.best
    copies = np.array([each.samples.shape[1] for each in problem.variables], dtype=np.float64)
    overlaps = problem.overlap.most * ((copies.sum() ** 2 - np.square(copies).sum()) / 2)
    allowed = [each.costs[np.isfinite(each.costs)] for each in problem.extra]
    explicit = sum(each.max(initial=0.0) for each in allowed)
    return float(1.0 + spread.sum() + overlaps + explicit)


def _layout_of(
    labels: LabelSet, rows: KnownRows | LazyRows, chosen: Indices, budget: Budget
) -> LocalSearch:
    """A good layout of some labels, from one of them on (variables,), if there is any yet."""
    found = LocalSearch(labels.start, labels.cost, rows, budget, tell=True)
    if len(chosen):
        found.improve_from(chosen)
    else:
        found.construct()
    found.search(TRAPS, budget.settings.work_limit / 2)
    return found


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
    from usdrigui.solve.milp import solve_milp

    method, cutoff, rest = "highs", budget.cutoff, left.plain()
    found = solve_milp(rest, cutoff, budget)
    if found.chosen is not None:
        incumbent.improve_from(left.representatives(found.chosen))
    budget.found(method, bound=found.bound)
    figures = {"labels": len(rest.linear), "pairs": rest.costly_pairs(), **found.figures}
    budget.note(method, **figures, cutoff=cutoff, bound=found.bound, work=budget.work)
