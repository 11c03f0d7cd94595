"""A good solution of few labels: iterated local search with all pair costs at hand.

What `usdrigui.solve.local_search` does among all labels, by distances worked out as they are
needed, takes a quarter of a millisecond a try once all costs are known: thousands of tries give
bounds and tests a cutoff near the optimum.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.model import Flags, Floats, Indices, Record
from usdrigui.solve.budget import Budget
from usdrigui.solve.local_search import SAME, WORSE
from usdrigui.solve.pair_costs import PairCosts

RUNS = 12
TRIES = 20
"""Tries of a run, for every variable."""
MOST = 8
"""Rivals taken out together with a variable, at most."""
NOISE = 0.04
"""Mean cost by which a label put back may be worse than the best."""
PAYING = 1e-3
"""Added to what a variable pays when one is drawn: those that pay nothing are drawn seldom, not
never."""


@dataclass(frozen=True, eq=False)
class LabelCosts(Record):
    """Labels of variables and what they cost, alone and in pairs."""

    start: Indices
    """(variables + 1,) first label of each variable."""
    linear: Floats
    """(n,)"""
    row: Indices
    """(n + 1,) first pair of each label; every pair stands in the rows of both."""
    other: Indices
    """(q,) the other label of a pair."""
    cost: Floats
    """(q,) finite."""

    def add(self, to: Floats, label: int, sign: float = 1.0) -> None:
        """Add to (n,) costs what a label costs with every other."""
        part = slice(self.row[label], self.row[label + 1])
        to[self.other[part]] += sign * self.cost[part]

    def against(self, chosen: Indices) -> Floats:
        """(n,) what every label costs against the chosen ones."""
        found = self.linear.copy()
        for label in chosen:
            self.add(found, int(label))
        return found

    def value(self, chosen: Indices) -> float:
        """Cost of one label per variable."""
        return 0.5 * float(self.linear[chosen].sum() + self.against(chosen)[chosen].sum())


def label_costs(start: Indices, linear: Floats, pairs: PairCosts) -> LabelCosts:
    """Of labels; pairs that are excluded cost more than all else together."""
    spread = np.maximum.reduceat(linear, start[:-1]) - np.minimum.reduceat(linear, start[:-1])
    finite = pairs.costs < np.inf
    most = float(pairs.costs.max(initial=0.0, where=finite))
    costs = np.where(finite, pairs.costs, 1.0 + spread.sum() + most * len(spread))
    ends = np.concatenate([pairs.first, pairs.second])
    order = np.argsort(ends, kind="stable")
    row = np.searchsorted(ends[order], np.arange(pairs.count + 1))
    return LabelCosts(
        start,
        linear,
        row,
        np.concatenate([pairs.second, pairs.first])[order],
        np.concatenate([costs, costs])[order],
    )


def descended(costs: LabelCosts, first: Indices) -> Indices:
    """A layout after the moves of single variables that gain most, from a first one."""
    return _descended(costs, first, costs.against(first))[0]


def iterated_local_search(costs: LabelCosts, first: Indices, budget: Budget) -> Indices:
    """The best layout found in a few runs: one label (index) per variable."""
    generator = np.random.default_rng(budget.settings.seed)
    in_the_way = np.zeros((len(costs.linear), len(first)), dtype=bool)
    owner = np.repeat(np.arange(len(first)), np.diff(costs.start))
    in_the_way[np.repeat(np.arange(len(owner)), np.diff(costs.row)), owner[costs.other]] = True
    best, value = first, np.inf
    for _ in range(RUNS):
        chosen = _run(costs, first, in_the_way, generator, budget)
        new = costs.value(chosen)
        if abs(new - value) <= SAME:
            break
        if new < value:
            best, value = chosen, new
    return best


def _run(
    problem: LabelCosts,
    first: Indices,
    in_the_way: Flags,
    generator: np.random.Generator,
    budget: Budget,
) -> Indices:
    """A run; `in_the_way` (n, variables) tells which labels cost anything for some label of each
    variable."""
    least = np.minimum.reduceat(problem.linear, problem.start[:-1])
    here, costs = _descended(problem, first, problem.against(first))
    value = best_value = _value(problem, here, costs)
    best, best_costs = here, costs
    for _ in range(TRIES * len(first)):
        if budget.stopped():
            break
        budget.spend(1 + len(problem.linear) // 12)
        group = _group(in_the_way, least, here, costs, generator)
        new, new_costs = _put_back(problem, here, costs, group, generator)
        new, new_costs = _descended(problem, new, new_costs)
        new_value = _value(problem, new, new_costs)
        if new_value < value + WORSE / 2:
            here, costs, value = new, new_costs, new_value
        if value < best_value - SAME:
            best, best_costs, best_value = here, costs, value
        elif value > best_value + WORSE:
            here, costs, value = best, best_costs, best_value
    return best


def _value(problem: LabelCosts, chosen: Indices, costs: Floats) -> float:
    """Cost of a layout from what every label costs against it: pairs are counted at both ends."""
    return 0.5 * float(problem.linear[chosen].sum() + costs[chosen].sum())


def _group(
    in_the_way: Flags, least: Floats, chosen: Indices, costs: Floats, generator: np.random.Generator
) -> Indices:
    """Variables to take out together: one that pays much, and some that stand where it wants to."""
    pays = np.maximum(costs[chosen] - least, 0.0) + PAYING
    drawn = np.cumsum(pays)
    seed = int(np.searchsorted(drawn, generator.random() * drawn[-1], side="right"))
    wanted = in_the_way[chosen, seed]
    wanted[seed] = False
    rivals = generator.permutation(np.flatnonzero(wanted))
    return np.append(seed, rivals[: int(generator.integers(2, MOST + 1))])


def _put_back(
    problem: LabelCosts,
    chosen: Indices,
    costs: Floats,
    group: Indices,
    generator: np.random.Generator,
) -> tuple[Indices, Floats]:
    """The group's variables chosen anew one after another, nearly the cheapest each."""
    chosen, costs = chosen.copy(), costs.copy()
    for taken in chosen[group]:
        problem.add(costs, int(taken), -1.0)
    for variable in generator.permutation(group):
        low, high = problem.start[variable], problem.start[variable + 1]
        chosen[variable] = (
            low + (costs[low:high] + generator.exponential(NOISE, high - low)).argmin()
        )
        problem.add(costs, int(chosen[variable]))
    return chosen, costs


def _descended(problem: LabelCosts, chosen: Indices, costs: Floats) -> tuple[Indices, Floats]:
    """The solution after the moves of single variables that gain most; `costs` (n,), against the
    others chosen, are kept up to date in place."""
    chosen = chosen.copy()
    while True:
        gains = costs[chosen] - np.minimum.reduceat(costs, problem.start[:-1])
        at = int(gains.argmax())
        if gains[at] < SAME:
            return chosen, costs
        low, high = problem.start[at], problem.start[at + 1]
        new = low + int(costs[low:high].argmin())
        problem.add(costs, new)
        problem.add(costs, int(chosen[at]), -1.0)
        chosen[at] = new
