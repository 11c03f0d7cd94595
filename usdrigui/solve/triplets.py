"""A tighter bound from triplets of variables.

Three elements that want two spots leave a bound by pairs below every layout: each stands half here and half there,
in every table with an entry that costs nothing.  A triplet of variables sees that two of the three must meet.  Its
least costs are passed back to its three tables (A. Globerson and T. Jaakkola, "Fixing max-product", 2007), for
the triplets that raise the bound (D. Sontag et al., "Tightening LP relaxations for MAP using message passing", 2008).
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np

from usdrigui.model import Flags, Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import ReducedProblem, Triplet, reduced

CHEAPEST = 12
"""Labels of a variable that tell which triplets raise the bound: those of least cost."""
AT_ONCE = 100
"""Triplets taken at a time."""
PASSES = 6
"""Passes over the triplets before others are looked for."""
GAIN = 1e-7
"""Least rise of the bound for which a triplet is taken."""
STALLED = 0.05
"""Share of the distance to the cutoff by which the bound must rise to go on."""


def tightened(problem: ReducedProblem, cutoff: float, budget: Budget) -> ReducedProblem | None:
    """The problem with a bound raised by triplets, without the labels that are excluded by it; None when no layout
    costs less than the cutoff."""
    problem.normalize()
    bound = problem.bound()
    while True:
        cheap = _cheapest(problem)
        for turn in range(PASSES):
            problem.spread()
            if not turn:
                new = _best_triplets(problem, cheap)
                problem.messages.update((each, _no_messages(problem, each)) for each in new)
            for triplet in problem.messages:
                _visit(problem, triplet)
            budget.spend(work_of(problem))
            kept = _swept(problem, cutoff)
            if kept is None:
                return None
            problem = kept
        budget.found("triplets", bound=min(problem.bound(), cutoff))
        rise, left = problem.bound() - bound, cutoff - problem.bound()
        if budget.stopped() or left <= 0 or (rise < STALLED * left and len(new) < AT_ONCE):
            return problem
        bound = problem.bound()


def work_of(problem: ReducedProblem) -> int:
    """Work that a pass over the triplets counts as."""
    sizes = np.diff(problem.start)
    return sum(int(sizes[a] * sizes[b] * sizes[c]) for a, b, c in problem.messages) // 16 + len(problem.costs) ** 2 // 8


def _swept(problem: ReducedProblem, cutoff: float) -> ReducedProblem | None:
    """The problem after its tables gave what they cost at least back to the labels."""
    problem.normalize()
    kept = reduced(problem, cutoff)
    if kept is None:
        return None
    kept.normalize()
    kept.sweep()
    kept.normalize()
    return kept


def _no_messages(problem: ReducedProblem, triplet: Triplet) -> tuple[Floats, Floats, Floats]:
    a, b, c = (int(problem.start[each + 1] - problem.start[each]) for each in triplet)
    return np.zeros((a, b)), np.zeros((a, c)), np.zeros((b, c))


def _visit(problem: ReducedProblem, triplet: Triplet) -> None:
    """Give each of a triplet's tables an even part of what its pairs cost at least together with a label of the third,
    and then all that is left of it."""
    a, b, c = (problem.slices[each] for each in triplet)
    tables = (problem.pairs[a, b], problem.pairs[a, c], problem.pairs[b, c])
    before = [table - message for table, message in zip(tables, problem.messages[triplet], strict=True)]
    cube = before[0][:, :, None] + before[1][:, None, :] + before[2][None]
    given = [np.zeros_like(table) for table in tables]
    for side, share in ((0, 3), (1, 2), (2, 1), (1, 1), (0, 1)):
        least = cube.min(axis=2 - side) / share
        given[side] += least
        cube -= np.expand_dims(np.where(least < np.inf, least, 0.0), 2 - side)  # what is excluded stays so
    for table, old, new in zip(tables, before, given, strict=True):
        table[...] = new
        new[...] = np.subtract(new, old, out=np.zeros_like(new), where=new < np.inf)
    problem.messages[triplet] = (given[0], given[1], given[2])


def _best_triplets(problem: ReducedProblem, cheap: list[Indices]) -> list[Triplet]:
    """New triplets that raise the bound most, at the costs as they are, all in the tables."""
    tables = {
        (a, b): problem.pairs[np.ix_(cheap[a], cheap[b])]
        for a, b in itertools.combinations(range(problem.count), 2)
        if problem.linked[a, b]
    }
    gains = []
    for a, b, c in triplets_of(problem.linked):
        if (a, b, c) in problem.messages:
            continue
        ab, ac, bc = tables[a, b], tables[a, c], tables[b, c]
        with_third = (ac[:, None, :] + bc[None]).min(axis=2)
        gains.append((float((ab + with_third).min() - ab.min() - ac.min() - bc.min()), (a, b, c)))
    gains.sort(key=lambda each: (-each[0], each[1]))
    return [triplet for gain, triplet in gains[:AT_ONCE] if gain > GAIN]


def triplets_of(linked: Flags) -> Iterator[Triplet]:
    """The triplets of variables that are linked two by two."""
    for a in range(len(linked)):
        near = a + 1 + np.flatnonzero(linked[a, a + 1 :])
        for b, c in itertools.combinations(near.tolist(), 2):
            if linked[b, c]:
                yield a, b, c


def _cheapest(problem: ReducedProblem) -> list[Indices]:
    """The few labels of every variable that the best layouts may use."""
    least = problem.label_lower_bounds()
    return [mine.start + np.argsort(least[mine], kind="stable")[:CHEAPEST] for mine in problem.slices]
