"""What the reduction leaves handed to toulbar2, an exact solver of cost function networks (optional)."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import Floats
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import ReducedProblem, Solution

DIGITS = 9
"""Decimals of a cost that toulbar2 keeps, at most."""
WHOLE = 15
"""Digits in all: its costs are whole numbers of 64 bits, and wrap around beyond."""
SLACK = 1e-6
"""Costs are rounded: so much is taken off its bound, more where fewer decimals are kept."""


def check_installed() -> None:
    """Raises SOLVE_EXTRA without the package."""
    try:
        import pytoulbar2  # noqa: F401
    except ImportError as error:
        raise refuse("SOLVE_EXTRA", "solve.method", "pytoulbar2 is not installed") from error


def solve_by_toulbar2(
    problem: ReducedProblem, linear: Floats, pairs: Floats, cutoff: float, budget: Budget
) -> Solution:
    """Best layout of a reduced problem that costs less than the cutoff, or the proof that there is none.

    `linear` (n,) and `pairs` (n, n) are the costs of its labels without messages.
    """
    import pytoulbar2

    least = np.minimum.reduceat(linear, problem.start[:-1])
    above, spare = linear - least[problem.owner], cutoff - float(least.sum())
    # The network holds what labels cost above the least of their variable: these numbers are small.
    digits = int(np.clip(WHOLE - np.ceil(np.log10(max(spare, 1e-6))), 0, DIGITS))
    network = pytoulbar2.CFN(2.0 * spare, digits)
    slices, tables = problem.slices, 0
    for at, mine in enumerate(slices):
        network.AddVariable(f"x{at}", range(mine.stop - mine.start))
        network.AddFunction([f"x{at}"], np.minimum(above[mine], spare).tolist())
    for a in range(problem.count):
        for b in range(a + 1, problem.count):
            costs = np.where(np.isinf(problem.pairs[slices[a], slices[b]]), np.inf, pairs[slices[a], slices[b]])
            if costs.any():
                tables += 1
                network.AddFunction([f"x{a}", f"x{b}"], np.minimum(costs, spare).ravel().tolist())
    network.Option.verbose = -1
    network.Option.showSolutions = 0
    limit = budget.seconds_left
    found = network.Solve(timeLimit=int(max(1.0, limit)) if np.isfinite(limit) else 0)
    rounding = max(SLACK, (problem.count + tables) * 10.0**-digits)
    bound = float(least.sum()) + float(network.GetDDualBound()) - rounding
    chosen = problem.start[:-1] + np.array(found[0][: problem.count], dtype=np.int64) if found else None
    return Solution(min(bound, cutoff), chosen, {"labels": len(linear), "tables": tables})
