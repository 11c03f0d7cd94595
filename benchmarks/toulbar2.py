"""What the reduction leaves handed to toulbar2, an exact solver of cost function networks
(optional).

It runs in a process of its own: it answers no request to stop, so the process is ended instead.
"""

from __future__ import annotations

import io
import itertools
import subprocess
import sys
import tempfile
from contextlib import suppress

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.errors import refuse
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import PlainProblem, Solution

DIGITS = (15, 9)
"""Of a cost in toulbar2, in all and behind the point: costs are whole numbers of 64 bits."""
ROUNDED = 1e-6
"""Costs are rounded: so much is taken off its bound, more where fewer decimals are kept."""


def check_installed() -> None:
    """Raises SOLVE_EXTRA without the package."""
    try:
        import pytoulbar2  # noqa: F401
    except ImportError as error:
        raise refuse("SOLVE_EXTRA", "solve.method", "pytoulbar2 is not installed") from error


def solve_by_toulbar2(problem: PlainProblem, cutoff: float, budget: Budget) -> Solution:
    """Best layout that costs less than the cutoff, or the proof that there is none.

    A run that `budget` stops proves and finds nothing.
    """
    base = float(problem.least.sum())
    spare = cutoff - base
    above = np.minimum(problem.excess, spare)
    answer = _asked((problem.start, above, np.minimum(problem.pairs, spare), spare), budget)
    if answer is None:
        return Solution(-np.inf, None, {})
    bound, chosen, rounding = answer
    bound += base - max(ROUNDED, rounding)
    return Solution(min(bound, cutoff), None if chosen is None else problem.start[:-1] + chosen, {})


Network = tuple[Indices, Floats, Floats, float]
"""First label of each variable, (n,) and (n, n) costs, and what no layout of interest costs."""
Answer = tuple[float, Indices | None, float]
"""Lower bound, label of each variable, and what rounding may have added to the bound."""


def _asked(network: Network, budget: Budget) -> Answer | None:
    """The answer of toulbar2 in a process that ends when the run is to stop; None then."""
    command, pipe = [sys.executable, "-m", __name__], subprocess.PIPE
    with tempfile.TemporaryFile() as question:
        np.savez(question, *network)
        question.seek(0)
        with subprocess.Popen(command, stdin=question, stdout=pipe, start_new_session=True) as run:
            while not budget.stopped():
                with suppress(subprocess.TimeoutExpired):
                    answer = np.load(io.BytesIO(run.communicate(timeout=0.1)[0]))
                    bound, chosen, rounding = (answer[name] for name in answer.files)
                    return float(bound), chosen if len(chosen) else None, float(rounding)
            run.kill()
    return None


def _solved(network: Network) -> tuple[float, Indices, float]:
    """The same by toulbar2 in this process; no labels where no layout is found."""
    import pytoulbar2

    start, linear, pairs, spare = network
    # The costs are above the least of each variable: these numbers are small.
    digits = int(np.clip(DIGITS[0] - np.ceil(np.log10(max(spare, 1e-6))), 0, DIGITS[1]))
    model = pytoulbar2.CFN(2.0 * spare, digits)
    slices = [slice(low, high) for low, high in itertools.pairwise(start)]
    tables = 0
    for at, mine in enumerate(slices):
        model.AddVariable(f"x{at}", range(mine.stop - mine.start))
        model.AddFunction([f"x{at}"], linear[mine].tolist())
        for before in range(at):
            costs = pairs[slices[before], mine]
            if costs.any():
                tables += 1
                model.AddFunction([f"x{before}", f"x{at}"], costs.ravel().tolist())
    model.Option.verbose = -1
    model.Option.showSolutions = 0
    found = model.Solve()
    chosen = np.array([] if found is None else found[0][: len(slices)], dtype=np.int64)
    return float(model.GetDDualBound()), chosen, (len(slices) + tables) * 10.0**-digits


if __name__ == "__main__":
    asked = np.load(sys.stdin.buffer)
    *tables, limit = (asked[name] for name in asked.files)
    np.savez(sys.stdout.buffer, *_solved((*tables, float(limit))))
