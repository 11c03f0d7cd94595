"""The paper's own pipeline: clusters of controls in sequence, weighted random sampling (section
4.2).

Kept to be compared with: what it drops it never gets back, so it proves no more than the trivial
bound.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from usdrigui.model import Assignment, ExtraPairs, Flags, Floats, Indices, LayoutProblem, Variable
from usdrigui.overlap import pair_costs
from usdrigui.solve.assignment import assignment
from usdrigui.solve.budget import Budget
from usdrigui.solve.clusters import clusters
from usdrigui.solve.exact import solve_whole
from usdrigui.solve.label_geometry import all_labels

_NO_WEIGHT = 1e-9
"""Weight of candidates that do not move as their viewer sees them: kept when nothing else is
left."""


def solve_by_clusters(
    problem: LayoutProblem,
    budget: Budget,
    solve_cluster: Callable[[LayoutProblem, Budget], Assignment] = solve_whole,
) -> Assignment:
    """Place cluster after cluster, the largest first, each over a sample of its candidates.

    Elements placed before are fixed: what they cost a later cluster's candidates is part of those
    candidates' linear cost.  All clusters share one allowance of work and time, by their numbers of
    elements.  Raises SOLVE_INFEASIBLE when former elements leave one without a place.
    """
    settings = budget.settings
    generator = np.random.default_rng(settings.seed)
    chosen = np.full(len(problem.variables), -1, dtype=np.int64)
    placed: list[int] = []
    for cluster in clusters(problem, settings.clusters, settings.linkage):
        priced = [_with_fixed_costs(problem, at, placed, chosen) for at in cluster]
        kept = sample(
            [each.displacement for each in priced], settings.sample, generator, _allowed(priced)
        )
        part = _restricted(problem, cluster, priced, kept)
        mine = budget.part(len(cluster) / (len(problem.variables) - len(placed)))
        solution = solve_cluster(part, mine)
        budget.spend(mine.work)
        budget.note(
            "cluster",
            elements=len(cluster),
            labels=sum(map(len, kept)),
            cost=solution.cost,
            work=mine.work,
        )
        for variable, labels, label in zip(cluster, kept, solution.labels, strict=True):
            chosen[variable] = labels[label] if label >= 0 else -1
        placed += cluster
    everything = all_labels(problem)
    budget.found("paper", bound=float(everything.best.sum()))
    budget.note("paper", clusters=settings.clusters, sample=settings.sample, work=budget.work)
    return assignment(problem, everything, chosen, budget, "paper")


def sample(
    displacements: list[Floats], share: float, generator: np.random.Generator, allowed: list[Flags]
) -> list[Indices]:
    """Labels kept of each variable of a cluster, ascending: a random share of all that are allowed,
    without replacement, displacement as weight (section 4.2, vertex down-sampling); of each
    variable one at least.

    `displacements` and `allowed` hold (R,) per variable.
    """
    labels = [np.flatnonzero(each) for each in allowed]
    if share >= 1.0:
        return labels
    owner = np.repeat(np.arange(len(labels)), [len(each) for each in labels])
    weight = np.concatenate(
        [np.zeros(0), *(d[each] for d, each in zip(displacements, labels, strict=True))]
    )
    # Exponential keys: the k least are a weighted sample without replacement (Efraimidis and
    # Spirakis 2006).
    key = generator.exponential(size=len(owner)) / np.maximum(weight, _NO_WEIGHT)
    kept = np.zeros(len(owner), dtype=bool)
    kept[np.argsort(key, kind="stable")[: int(np.ceil(share * len(owner)))]] = True
    for at in range(len(labels)):
        mine = np.flatnonzero(owner == at)
        if len(mine) and not kept[mine].any():
            kept[mine[key[mine].argmin()]] = True
    return [each[kept[owner == at]] for at, each in enumerate(labels)]


def _allowed(variables: list[Variable]) -> list[Flags]:
    return [np.isfinite(each.cost) for each in variables]


def _with_fixed_costs(
    problem: LayoutProblem, at: int, placed: list[int], chosen: Indices
) -> Variable:
    """A variable whose linear costs hold what the elements already placed cost it; +inf where they
    forbid."""
    variable = problem.variables[at]
    labels = np.arange(len(variable.cost))
    cost = variable.cost.copy()
    for other in placed:
        if chosen[other] >= 0:
            cost += pair_costs(problem, at, other, labels, np.full(len(labels), chosen[other]))
    for extra in problem.extra:
        ends = {extra.first: extra.first_labels, extra.second: extra.second_labels}
        other = extra.second if extra.first == at else extra.first
        if at in ends and other in placed:
            hit = ends[other] == chosen[other]
            cost[ends[at][hit]] += extra.costs[hit]
    return replace(variable, cost=cost)


def _restricted(
    problem: LayoutProblem, cluster: list[int], variables: list[Variable], labels: list[Indices]
) -> LayoutProblem:
    """The problem of one cluster over the labels kept."""
    kept = tuple(_with_labels(each, mine) for each, mine in zip(variables, labels, strict=True))
    place = {variable: at for at, variable in enumerate(cluster)}
    extra = tuple(
        _extra_between(each, place[each.first], place[each.second], labels)
        for each in problem.extra
        if each.first in place and each.second in place
    )
    return replace(problem, variables=kept, extra=extra)


def _with_labels(variable: Variable, labels: Indices) -> Variable:
    return replace(
        variable,
        points=variable.points[labels],
        cost=variable.cost[labels],
        samples=variable.samples[labels],
        handles=variable.handles[labels],
        displacement=variable.displacement[labels],
    )


def _extra_between(extra: ExtraPairs, first: int, second: int, labels: list[Indices]) -> ExtraPairs:
    """Explicit costs in the numbering of a restricted problem."""
    sets = [(first, extra.first_labels), (second, extra.second_labels)]
    sets.sort(key=lambda each: each[0])
    at = [np.searchsorted(labels[variable], mine) for variable, mine in sets]
    known = np.ones(len(extra.costs), dtype=bool)
    for (variable, mine), place in zip(sets, at, strict=True):
        held = labels[variable]
        known &= (place < len(held)) & (np.append(held, -2)[np.minimum(place, len(held))] == mine)
    return ExtraPairs(sets[0][0], sets[1][0], at[0][known], at[1][known], extra.costs[known])
