"""The paper's own pipeline: clusters of controls in sequence, weighted random sampling (section
4.2).

Kept to be compared with: what it drops it never gets back, so it proves no more than the trivial
bound.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from usdrigui.model import Assignment, Flags, Floats, Indices, LayoutProblem, Variable
from usdrigui.overlap import pair_costs
from usdrigui.solve.assignment import assignment
from usdrigui.solve.budget import Budget
from usdrigui.solve.clusters import clusters
from usdrigui.solve.exact import solve_whole
from usdrigui.solve.label_geometry import all_labels


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
        variables = [_with_fixed_costs(problem, at, placed, chosen) for at in cluster]
        allowed = [np.isfinite(each.cost) for each in variables]
        weights = [each.displacement for each in variables]
        kept = sample(weights, settings.sample, generator, allowed)
        mine = budget.part(len(cluster) / (len(problem.variables) - len(placed)))
        solution = solve_cluster(_restricted(problem, cluster, variables, kept), mine)
        budget.spend(mine.work)
        count = sum(map(len, kept))
        budget.note(
            "cluster", elements=len(cluster), labels=count, cost=solution.cost, work=mine.work
        )
        chosen[cluster] = solution.labels
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
    # Exponential keys: the k least are a weighted sample without replacement (Efraimidis and
    # Spirakis 2006).  Candidates that do not move are kept when nothing else is left.
    keys = [
        generator.exponential(size=len(mine)) / np.maximum(each[mine], 1e-9)
        for each, mine in zip(displacements, labels, strict=True)
    ]
    every = np.sort(np.concatenate([np.zeros(0), *keys]))
    most = every[: int(np.ceil(share * len(every)))].max(initial=0.0)
    kept = (key <= max(most, key.min(initial=np.inf)) for key in keys)
    return [mine[each] for mine, each in zip(labels, kept, strict=True)]


def _with_fixed_costs(
    problem: LayoutProblem, at: int, placed: list[int], chosen: Indices
) -> Variable:
    """A variable whose linear costs hold what the elements placed before cost it."""
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
    """The problem of one cluster, in which the labels that are not kept cost +inf."""
    kept = []
    for each, mine in zip(variables, labels, strict=True):
        cost = np.full(len(each.cost), np.inf)
        cost[mine] = each.cost[mine]
        kept.append(replace(each, cost=cost))
    place = {variable: at for at, variable in enumerate(cluster)}
    extra = [
        replace(each, first=place[each.first], second=place[each.second])
        for each in problem.extra
        if each.first in place and each.second in place
    ]
    return replace(problem, variables=tuple(kept), extra=tuple(extra))
