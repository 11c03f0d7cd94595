"""The paper's own pipeline (section 4.2): clusters of controls in sequence, each over a weighted
random sample of its candidates.

Kept to be compared with: what it drops it never gets back, so it proves no more than the trivial
bound.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.model import Assignment, LayoutProblem
from usdrigui.overlap import pair_costs
from usdrigui.solve.assignment import assignment
from usdrigui.solve.budget import Budget
from usdrigui.solve.clusters import clusters
from usdrigui.solve.exact import solve_whole
from usdrigui.solve.label_geometry import all_labels


def solve_by_clusters(problem: LayoutProblem, budget: Budget) -> Assignment:
    """Place cluster after cluster, the largest first, each over a sample of its candidates.

    Elements placed before are fixed: they have one label in the problems of later clusters.  All
    clusters share one allowance of work and time, by their numbers of elements.  Raises
    SOLVE_INFEASIBLE when former elements leave one without a place.
    """
    settings = budget.settings
    generator = np.random.default_rng(settings.seed)
    chosen = np.full(len(problem.variables), -1, dtype=np.int64)
    placed: list[int] = []
    limits = {budget.limit}
    for cluster in clusters(problem, settings.clusters, settings.linkage):
        allowed = [_allowed(problem, at, placed, chosen) for at in cluster]
        weights = [problem.variables[at].displacement for at in cluster]
        kept = sample(weights, settings.sample, generator, allowed)
        labels = dict(zip(cluster, kept, strict=True)) | {at: chosen[[at]] for at in placed}
        part = _restricted(problem, labels, np.flatnonzero(chosen >= 0))
        mine = budget.part(len(cluster) / (len(problem.variables) - len(placed)))
        solution = solve_whole(part, mine)
        budget.spend(mine.work)
        limits.add(mine.limit)
        count, cost = sum(map(len, kept)), solution.cost
        budget.note("cluster", elements=len(cluster), labels=count, cost=cost, work=mine.work)
        chosen[cluster] = solution.labels[cluster]
        placed += cluster
    budget.limit = max(limits)
    everything = all_labels(problem)
    budget.found("paper", bound=float(everything.best.sum()))
    budget.note("paper", clusters=settings.clusters, sample=settings.sample, work=budget.work)
    return assignment(problem, everything, chosen, budget, "paper")


# --- samples --------------------------------------------------------------------------------------


def sample(
    displacements: list[Floats], share: float, generator: np.random.Generator, allowed: list[Flags]
) -> list[Indices]:
    """Labels kept of each variable of a cluster, ascending: a random share of all that are allowed,
    without replacement, displacement as weight (section 4.2, vertex down-sampling); of each
    variable one at least.

    `displacements` and `allowed` hold (R,) per variable.
    """
    labels = [np.flatnonzero(each) for each in allowed]
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


# --- the problem of a cluster ---------------------------------------------------------------------


def _allowed(problem: LayoutProblem, at: int, placed: list[int], chosen: Indices) -> Flags:
    """(R,) the candidates of a variable that no element placed before forbids."""
    allowed = np.isfinite(problem.variables[at].cost)
    labels = np.arange(len(allowed))
    for other in placed:
        fixed = np.full(len(labels), chosen[other])
        allowed &= np.isfinite(pair_costs(problem, at, other, labels, fixed))
    return allowed


def _restricted(problem: LayoutProblem, kept: dict[int, Indices], placed: Indices) -> LayoutProblem:
    """The problem in which variables have the candidates `kept` alone; those `placed` on the face
    stay on it, and those of later clusters, which have none, cost nothing."""
    variables = []
    for at, each in enumerate(problem.variables):
        is_kept = np.isin(np.arange(len(each.cost)), kept.get(at, []))
        off_face = each.off_face_cost if at in kept else 0.0
        off_face = np.inf if at in placed else off_face
        cost = np.where(is_kept, each.cost, np.inf)
        variables.append(replace(each, cost=cost, off_face_cost=off_face))
    return replace(problem, variables=tuple(variables))
