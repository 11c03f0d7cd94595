"""toulbar2, an exact solver of cost function networks, on what our reduction leaves: in the turn
that is HiGHS's in ours."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from contextlib import contextmanager
from unittest import mock

import numpy as np
import pytoulbar2

from usdrigui.solve import milp
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import PlainProblem, Solution

DIGITS = (15, 9)
"""Of a cost in toulbar2, in all and behind the point: costs are whole numbers of 64 bits."""
ROUNDED = 1e-6
"""Costs are rounded: so much is taken off its bound, more where fewer decimals are kept."""


@contextmanager
def in_the_turn_of_highs() -> Iterator[None]:
    """Our solver with toulbar2 for HiGHS."""
    with mock.patch.object(milp, "solve_milp", solve_by_toulbar2):
        yield


def solve_by_toulbar2(problem: PlainProblem, cutoff: float, budget: Budget, most: int) -> Solution:
    """Best layout that costs less than the cutoff, or the proof that there is none, whatever work
    that takes."""
    del budget, most
    base = float(problem.least.sum())
    spare = cutoff - base
    linear, pairs = np.minimum(problem.excess, spare), np.minimum(problem.pairs, spare)
    # The costs are above the least of each variable: these numbers are small.
    digits = int(np.clip(DIGITS[0] - np.ceil(np.log10(max(spare, 1e-6))), 0, DIGITS[1]))
    model, tables = pytoulbar2.CFN(2.0 * spare, digits), 0
    for at, mine in enumerate(problem.slices):
        model.AddVariable(f"x{at}", range(mine.stop - mine.start))
        model.AddFunction([f"x{at}"], linear[mine].tolist())
    for (a, one), (b, other) in itertools.combinations(enumerate(problem.slices), 2):
        costs = pairs[one, other]
        if costs.any():
            tables += 1
            model.AddFunction([f"x{a}", f"x{b}"], costs.ravel().tolist())
    model.Option.verbose = -1
    model.Option.showSolutions = 0
    found = model.Solve()
    rounding = max(ROUNDED, (len(problem.slices) + tables) * 10.0**-digits)
    bound = min(base + float(model.GetDDualBound()) - rounding, cutoff)
    if found is None:
        return Solution(bound, None, {})
    chosen = problem.start[:-1] + np.array(found[0][: len(problem.slices)], dtype=np.int64)
    return Solution(bound, chosen, {})
