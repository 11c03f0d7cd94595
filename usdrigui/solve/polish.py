"""A good solution of few labels: iterated local search on one matrix of costs.

What `usdrigui.solve.local_search` does among all labels, by distances worked out as they are needed, takes a
quarter of a millisecond a try once all costs stand in a matrix: thousands of tries before the exact search
give it a cut-off near the optimum, which saves it most of its nodes.
"""

from __future__ import annotations

import itertools

import numpy as np

from usdrigui.model import Flags, Floats, Indices
from usdrigui.solve.subproblem import Part

RUNS = 12
TRIES = 20
"""Tries of a run, for every variable."""
MOST = 8
"""Rivals taken out together with a variable, at most."""
NOISE = 0.04
"""Mean cost by which a label put back may be worse than the best."""
WORSE = 0.02
"""How much worse than the best of a run a solution may be for the run to go on from it."""
SAME = 1e-9
"""Costs that differ by no more are of the same solution; when two runs end with it no others follow."""
PAYING = 1e-3
"""Added to what a variable pays when one is drawn: those that pay nothing are drawn seldom, not never."""


def polished(part: Part, seed: int) -> tuple[Indices, float]:
    """The best solution found in a few runs: one entry (index into the part) per variable, and its cost."""
    generator = np.random.default_rng(seed)
    across = part.matrix + part.matrix.T
    in_the_way = np.maximum.reduceat(across, part.start[:-1], axis=1) > 0
    least = np.minimum.reduceat(part.costs, part.start[:-1])
    best, cost = np.empty(0, dtype=np.int64), np.inf
    for _ in range(RUNS):
        chosen, value = _run(part, across, in_the_way, least, generator)
        if abs(value - cost) <= SAME:
            break
        if value < cost:
            best, cost = chosen, value
    return best, part.value(best)


def _run(
    part: Part, across: Floats, in_the_way: Flags, least: Floats, generator: np.random.Generator
) -> tuple[Indices, float]:
    """A run; `in_the_way` (n, variables) tells which entries cost anything for some entry of each variable."""
    first = np.array([low + part.costs[low:high].argmin() for low, high in itertools.pairwise(part.start)])
    here, costs = _descended(part, across, first, part.costs + across[first].sum(axis=0))
    value = best_value = _value(part, here, costs)
    best, best_costs = here, costs
    for _ in range(TRIES * len(part.variables)):
        group = _group(in_the_way, least, here, costs, generator)
        new, new_costs = _put_back(part, across, here, costs, group, generator)
        new, new_costs = _descended(part, across, new, new_costs)
        new_value = _value(part, new, new_costs)
        if new_value < value + WORSE / 2:
            here, costs, value = new, new_costs, new_value
        if value < best_value - SAME:
            best, best_costs, best_value = here, costs, value
        elif value > best_value + WORSE:
            here, costs, value = best, best_costs, best_value
    return best, best_value


def _value(part: Part, chosen: Indices, costs: Floats) -> float:
    """Cost of a solution from what every entry costs against it: pairs are counted at both ends."""
    return part.constant + 0.5 * float(part.costs[chosen].sum() + costs[chosen].sum())


def _group(in_the_way: Flags, least: Floats, chosen: Indices, costs: Floats, generator: np.random.Generator) -> Indices:
    """Variables to take out together: one that pays much, and some that stand where it wants to."""
    pays = np.maximum(costs[chosen] - least, 0.0) + PAYING
    drawn = np.cumsum(pays)
    seed = int(np.searchsorted(drawn, generator.random() * drawn[-1], side="right"))
    wanted = in_the_way[chosen, seed]
    wanted[seed] = False
    rivals = generator.permutation(np.flatnonzero(wanted))
    return np.append(seed, rivals[: int(generator.integers(2, MOST + 1))])


def _put_back(
    part: Part, across: Floats, chosen: Indices, costs: Floats, group: Indices, generator: np.random.Generator
) -> tuple[Indices, Floats]:
    """The group's variables chosen anew one after another, nearly the cheapest each."""
    chosen, costs = chosen.copy(), costs.copy()
    for taken in chosen[group]:
        costs -= across[taken]
    for variable in generator.permutation(group):
        low, high = part.start[variable], part.start[variable + 1]
        chosen[variable] = low + (costs[low:high] + generator.exponential(NOISE, high - low)).argmin()
        costs += across[chosen[variable]]
    return chosen, costs


def _descended(part: Part, across: Floats, chosen: Indices, costs: Floats) -> tuple[Indices, Floats]:
    """The solution after the moves of single variables that gain most; `costs` (n,), against the others chosen, are
    kept up to date in place."""
    chosen = chosen.copy()
    while True:
        gains = costs[chosen] - np.minimum.reduceat(costs, part.start[:-1])
        at = int(gains.argmax())
        if gains[at] < 1e-9:
            return chosen, costs
        low, high = part.start[at], part.start[at + 1]
        new = low + int(costs[low:high].argmin())
        costs += across[new]
        costs -= across[chosen[at]]
        chosen[at] = new
