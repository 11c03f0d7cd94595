"""A tighter bound from triplets of variables.

Three elements that want two spots leave a bound by pairs below every layout: each stands half here and half there,
in every table with an entry that costs nothing.  A triplet of variables sees that two of the three must meet.  Its
least costs are passed back to its three tables (A. Globerson and T. Jaakkola, "Fixing max-product", 2007), for
the triplets that raise the bound (D. Sontag et al., "Tightening LP relaxations for MAP using message passing", 2008).
"""

from __future__ import annotations

import numpy as np

from usdrigui.model import Floats
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import EPSILON, LARGEST_TESTED, NEVER, ReducedProblem, Triplet

CHEAPEST = 8
"""Labels of a variable that tell which triplets raise the bound: those of least cost."""
AT_ONCE = 100
"""Triplets taken at a time."""
PASSES = 6
"""Passes over the triplets before others are looked for; a third where labels are many, for all that is done on the
whole matrix in each."""
STRONGEST = 1500
"""Tables whose triplets are looked at: those of the highest costs."""


def raise_bound(problem: ReducedProblem, budget: Budget) -> int:
    """Raise the bound of a problem, in place, by its triplets and those that help it most; how many are new."""
    problem.normalize()
    new = _best_triplets(problem)
    problem.messages.update((each, _no_messages(problem, each)) for each in new)
    for _ in range(PASSES if len(problem.costs) <= LARGEST_TESTED else PASSES // 3):
        problem.spread()
        for triplet in problem.messages:
            _visit(problem, triplet)
        problem.normalize()
        problem.sweep()
        budget.spend(work_of(problem))
        if budget.stopped():
            break
    problem.normalize()
    return len(new)


def work_of(problem: ReducedProblem) -> int:
    """Work that a pass over the triplets counts as."""
    sizes = np.diff(problem.start)
    return (
        sum(int(sizes[a] * sizes[b] * sizes[c]) for a, b, c in problem.messages) // 32 + len(problem.costs) ** 2 // 16
    )


def _no_messages(problem: ReducedProblem, triplet: Triplet) -> tuple[Floats, Floats, Floats]:
    a, b, c = (int(problem.start[each + 1] - problem.start[each]) for each in triplet)
    return np.zeros((a, b)), np.zeros((a, c)), np.zeros((b, c))


def _visit(problem: ReducedProblem, triplet: Triplet) -> None:
    """Give each of a triplet's tables an even part of what its pairs cost at least together with a label of the third,
    and then all that is left of it."""
    a, b, c = (problem.slices[each] for each in triplet)
    tables = (problem.pairs[a, b], problem.pairs[a, c], problem.pairs[b, c])
    ab, ac, bc = (table - message for table, message in zip(tables, problem.messages[triplet], strict=True))
    cube = ab[:, :, None] + ac[:, None, :] + bc[None]
    given = [np.zeros_like(table) for table in tables]
    for side, share in ((0, 3), (1, 2), (2, 1), (1, 1), (0, 1)):
        least = cube.min(axis=2 - side) / share
        given[side] += least
        least[np.isinf(least)] = 0.0  # what is excluded stays so
        cube -= least[_ALONG[side]]
    for table, old, new in zip(tables, (ab, ac, bc), given, strict=True):
        table[...] = new
        new[...] = np.subtract(new, old, out=np.zeros_like(new), where=new < np.inf)
    problem.messages[triplet] = (given[0], given[1], given[2])


_ALONG = ((..., None), (slice(None), None), (None,))
"""How the tables of a triplet lie in its cube."""


def _best_triplets(problem: ReducedProblem) -> list[Triplet]:
    """New triplets that raise the bound most, by the cheapest labels of their variables."""
    tables = _cheapest(problem)
    least = tables.min(axis=(2, 3))
    strength = np.triu(np.where(problem.linked, np.minimum(tables, 1.0).mean(axis=(2, 3)), 0.0))
    gains: dict[Triplet, float] = {}
    for pair in np.argsort(-strength, axis=None, kind="stable")[:STRONGEST].tolist():
        a, b = divmod(pair, problem.count)
        third = np.flatnonzero(problem.linked[a] & problem.linked[b])
        if not strength[a, b] or not len(third):
            break
        both = (tables[a, third][:, :, None] + tables[b, third][:, None]).min(axis=3)
        gain = (tables[a, b] + both).min(axis=(1, 2)) - least[a, b] - least[a, third] - least[b, third]
        for at in np.flatnonzero(gain > EPSILON):
            first, second, last = sorted((a, b, int(third[at])))
            gains[first, second, last] = float(gain[at])
    new = [each for each in gains if each not in problem.messages]
    return sorted(new, key=lambda each: (-gains[each], each))[:AT_ONCE]


def _cheapest(problem: ReducedProblem) -> Floats:
    """(variables, variables, k, k) pair costs of the few labels of every variable that the best layouts may use, with
    their even shares of what these cost alone; the same both ways."""
    bounds = problem.label_lower_bounds()
    labels = np.stack(
        [
            np.resize(mine.start + np.argsort(bounds[mine], kind="stable")[:CHEAPEST], CHEAPEST)
            for mine in problem.slices
        ]
    )
    tables = np.minimum(problem.pairs[labels[:, None, :, None], labels[None, :, None, :]], NEVER)
    share = (problem.costs / np.maximum(problem.linked.sum(axis=1), 1)[problem.owner])[labels]
    tables += tables.transpose(1, 0, 3, 2)
    tables += share[:, None, :, None] + share[None, :, None, :]
    return np.asarray(tables)
