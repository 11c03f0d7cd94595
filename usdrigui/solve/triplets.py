"""A tighter bound from triplets of variables.

Three elements that want two spots leave a bound by pairs below every layout: each stands half here
and half there, in every table with an entry that costs nothing.  A triplet of variables sees that
two of the three must meet.  Its least costs are passed back to its three tables (A. Globerson and
T. Jaakkola, "Fixing max-product", 2007), for the triplets that raise the bound (D. Sontag et al.,
"Tightening LP relaxations for MAP using message passing", 2008).
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import (
    DEAREST,
    EPSILON,
    LARGEST_TESTED,
    ReducedProblem,
    Triplet,
    finite,
    least_sums,
)

CHEAPEST = 8
"""Labels of a variable that tell which triplets raise the bound: those of least cost."""
AT_ONCE = 10
"""Triplets taken at a time at least."""
SWEPT = 400
"""Entries that every pass sweeps, for each unit of work of a triplet, that let one be taken: where
sweeps are dear they are shared by many."""
PASSES = 24
"""Passes over the triplets before others are looked for; a third where labels are many, for all
that is done on the whole matrix in each."""
VISITS = ((0, 3), (1, 2), (2, 1), (1, 1), (0, 1))
"""Tables of a triplet, one after another, each given one of so many parts."""


def raise_bound(problem: ReducedProblem, budget: Budget) -> None:
    """Raise the bound of a problem, in place, by its triplets and those that help it most."""
    problem.normalize()
    sizes = np.diff(problem.start)
    for triplet in _best_triplets(problem):
        a, b, c = sizes[list(triplet)].tolist()
        ab, ac, bc = (np.zeros(shape, dtype=np.float32) for shape in ((a, b), (a, c), (b, c)))
        problem.messages[triplet] = ab, ac, bc
    cubes = sum(int(sizes[list(each)].prod()) for each in problem.messages)
    work = len(VISITS) * cubes // 1500 + 200 * len(problem.messages) + problem.entries // 24
    for turn in range(PASSES if len(problem.costs) <= LARGEST_TESTED else PASSES // 3):
        problem.spread()
        for first, triplet in enumerate(problem.messages, turn):
            _visit(problem, triplet, first)
        problem.normalize()
        problem.sweep()
        budget.spend(work)
        if budget.stopped():
            break
    problem.normalize()


def _visit(problem: ReducedProblem, triplet: Triplet, first: int) -> None:
    """Give each of a triplet's tables, from the `first` on, an even part of what its pairs cost at
    least together with a label of the third: the last one all that is left of it."""
    a, b, c = triplet
    tables = (problem.table(a, b), problem.table(a, c), problem.table(b, c))
    messages = problem.messages[triplet]
    before = [table - message for table, message in zip(tables, messages, strict=True)]
    left, given = [each.copy() for each in before], [np.zeros_like(each) for each in before]
    for at, share in VISITS:
        side, (ab, ac, bc) = (first + at) % 3, left
        one, other = ((ac, bc), (ab, bc.T), (ab.T, ac.T))[side]
        least = (least_sums(one, other) + left[side]) / share
        given[side] += least
        left[side] -= finite(least)
    for table, message, old, new in zip(tables, messages, before, given, strict=True):
        moved = np.subtract(new, old, out=np.zeros_like(new), where=new < np.inf)
        # In single precision, which halves their memory, no message is larger than it was.
        message[...] = moved - np.finfo(np.float32).eps * np.abs(moved)
        table[...] = np.where(new < np.inf, old + message, np.inf)


def _best_triplets(problem: ReducedProblem) -> list[Triplet]:
    """New triplets that raise the bound most, by the cheapest labels of their variables."""
    tables = _cheapest(problem)
    least = tables.min(axis=(2, 3))
    rank: dict[Triplet, float] = {}
    sizes = np.diff(problem.start)
    for a, b in np.argwhere(np.triu(problem.linked)).tolist():
        third = b + 1 + np.flatnonzero(problem.linked[a, b + 1 :] & problem.linked[b, b + 1 :])
        both = (tables[a, third][:, :, None] + tables[b, third][:, None]).min(axis=3)
        gains = (
            (tables[a, b] + both).min(axis=(1, 2)) - least[a, b] - least[a, third] - least[b, third]
        )
        gains[gains <= EPSILON] = 0.0
        for c, gain in zip(third.tolist(), gains.tolist(), strict=True):
            if (a, b, c) not in problem.messages:
                rank[a, b, c] = -gain / int(sizes[[a, b, c]].prod())
    # The work of one of them in a pass, as `raise_bound` counts it.
    each = 200 + int(sizes.mean()) ** 3 // 300
    return sorted(rank, key=rank.__getitem__)[: max(AT_ONCE, problem.entries // (SWEPT * each))]


def _cheapest(problem: ReducedProblem) -> Floats:
    """(variables, variables, k, k) pair costs of the few labels of every variable that the best
    layouts may use, with their even shares of what these cost alone; the same both ways."""
    bounds = problem.label_lower_bounds()
    ranked = (mine.start + np.argsort(bounds[mine], kind="stable") for mine in problem.slices)
    labels = np.stack([np.resize(each[:CHEAPEST], CHEAPEST) for each in ranked])
    tables = np.zeros((problem.count, problem.count, CHEAPEST, CHEAPEST))
    place = labels - problem.start[:-1, None]
    for a, b in np.argwhere(np.triu(problem.linked)).tolist():
        tables[a, b] = np.minimum(problem.table(a, b)[np.ix_(place[a], place[b])], DEAREST)
    share = (problem.costs / np.maximum(problem.linked.sum(axis=1), 1)[problem.owner])[labels]
    tables += tables.transpose(1, 0, 3, 2)
    tables += share[:, None, :, None] + share[None, :, None, :]
    return tables
