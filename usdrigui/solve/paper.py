"""The paper's own pipeline: clusters of controls in sequence, weighted random sampling (section 4.2).

Kept to be compared with: what it drops it never gets back, so it proves no more than the trivial bound.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.model import Assignment, ExtraPairs, Floats, Indices, LayoutProblem, Variable
from usdrigui.overlap import pair_costs
from usdrigui.solve.assignment import assignment
from usdrigui.solve.blocks import all_labels
from usdrigui.solve.exact import solve_whole
from usdrigui.solve.watch import Watch

PER_VARIABLE = 200
"""Candidates of a variable whose distances stand for all when clusters are compared."""


def solve_by_clusters(problem: LayoutProblem, watch: Watch) -> Assignment:
    """Place cluster after cluster, the largest first, each over a sample of its candidates, former ones fixed."""
    generator = np.random.default_rng(watch.settings.seed)
    chosen = np.full(len(problem.variables), -1, dtype=np.int64)
    placed: list[int] = []
    for cluster in clusters(problem, watch.settings.clusters):
        kept = sample(problem, cluster, watch.settings.sample, generator)
        part, labels = _restricted(problem, cluster, kept, placed, chosen)
        solution = solve_whole(part, Watch(watch.settings, stop=watch.stopped))
        for variable, mine, label in zip(cluster, labels, solution.labels, strict=True):
            chosen[variable] = mine[label] if label >= 0 else -1
        placed += cluster
    everything = all_labels(problem)
    watch.found("paper", bound=float(everything.best.sum()))
    watch.note("paper", clusters=watch.settings.clusters, sample=watch.settings.sample)
    return assignment(problem, everything, chosen, watch, "paper")


def clusters(problem: LayoutProblem, count: int) -> list[list[int]]:
    """Partition of the variables into `count` clusters, largest first: the two of least distance are merged
    until so many are left, the distance being the sum over all pairs of their candidates (section 4.2).

    Distances are estimated from evenly chosen candidates, scaled to their numbers.
    """
    members = [[at] for at in range(len(problem.variables))]
    distance = _summed_distances(problem)
    np.fill_diagonal(distance, np.inf)
    while len(members) > max(count, 1):
        a, b = sorted(divmod(int(distance.argmin()), len(members)))
        distance[a] += distance[b]
        distance[:, a] = distance[a]
        distance[a, a] = np.inf
        distance = np.delete(np.delete(distance, b, axis=0), b, axis=1)
        members[a] += members.pop(b)
    return sorted((sorted(each) for each in members), key=lambda each: (-len(each), each))


def _summed_distances(problem: LayoutProblem) -> Floats:
    """(variables, variables) sums of the distances between all candidates' handles (of copy 0)."""
    spots = [each.handles[:: max(1, -(-len(each.cost) // PER_VARIABLE)), 0] for each in problem.variables]
    found = np.zeros((len(spots), len(spots)))
    for a, one in enumerate(spots):
        for b in range(a):
            if len(one) and len(spots[b]):
                apart = np.linalg.norm(one[:, None] - spots[b][None], axis=-1).mean()
                found[a, b] = apart * len(problem.variables[a].cost) * len(problem.variables[b].cost)
    return found + found.T


def sample(problem: LayoutProblem, cluster: list[int], share: float, generator: np.random.Generator) -> list[Indices]:
    """Labels kept of each variable of a cluster: a random share of all, displacement as weight, one each at least."""
    counts = [len(problem.variables[at].cost) for at in cluster]
    if share >= 1.0:
        return [np.arange(count) for count in counts]
    owner = np.repeat(np.arange(len(cluster)), counts)
    label = np.concatenate([np.arange(count) for count in counts])
    weight = np.concatenate([np.maximum(-problem.variables[at].cost, 0.0) for at in cluster]) + 1e-9
    # Exponential keys: the k least are a weighted sample without replacement (Efraimidis and Spirakis 2006).
    key = generator.exponential(size=len(owner)) / weight
    kept = np.zeros(len(owner), dtype=bool)
    kept[np.argsort(key, kind="stable")[: int(np.ceil(share * len(owner)))]] = True
    for at in range(len(cluster)):
        mine = np.flatnonzero(owner == at)
        if len(mine) and not kept[mine].any():
            kept[mine[key[mine].argmin()]] = True
    return [label[(owner == at) & kept] for at in range(len(cluster))]


def _restricted(
    problem: LayoutProblem, cluster: list[int], kept: list[Indices], placed: list[int], chosen: Indices
) -> tuple[LayoutProblem, list[Indices]]:
    """The problem of one cluster over the labels kept, and those that the placed elements leave possible."""
    variables, labels = [], []
    for at, mine in zip(cluster, kept, strict=True):
        cost = problem.variables[at].cost[mine] + _against(problem, at, mine, placed, chosen)
        free = np.isfinite(cost)
        labels.append(mine[free])
        variables.append(_with_labels(problem.variables[at], mine[free], cost[free]))
    place = {variable: at for at, variable in enumerate(cluster)}
    extra = tuple(
        found
        for each in problem.extra
        if each.first in place and each.second in place
        for found in [_extra_between(each, place[each.first], place[each.second], labels)]
    )
    return replace(problem, variables=tuple(variables), extra=extra), labels


def _with_labels(variable: Variable, labels: Indices, cost: Floats) -> Variable:
    return replace(
        variable,
        points=variable.points[labels],
        cost=cost,
        samples=variable.samples[labels],
        handles=variable.handles[labels],
    )


def _against(problem: LayoutProblem, variable: int, labels: Indices, placed: list[int], chosen: Indices) -> Floats:
    """(q,) pair costs of a variable's labels against the elements already placed."""
    cost = np.zeros(len(labels))
    for other in placed:
        if chosen[other] < 0:
            continue
        cost += pair_costs(problem, variable, other, labels, np.full(len(labels), chosen[other]))
        for extra in problem.extra:
            ends = {extra.first: extra.first_labels, extra.second: extra.second_labels}
            if set(ends) == {variable, other}:
                hit = ends[other] == chosen[other]
                price = np.zeros(len(problem.variables[variable].cost))
                price[ends[variable][hit]] = extra.costs[hit]
                cost += price[labels]
    return cost


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
