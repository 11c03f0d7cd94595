"""Solvers of `usdrigui.model.LayoutProblem`; knows nothing of rigs or USD.

Importing this package loads no solver library: each method is imported when it is asked for.
"""

from __future__ import annotations

from collections.abc import Callable

from usdrigui.model import Assignment, LayoutProblem
from usdrigui.settings import SolveSettings
from usdrigui.solve.budget import Budget, Progress

__all__ = ["Progress", "solve"]


def solve(
    problem: LayoutProblem,
    settings: SolveSettings,
    progress: Callable[[Progress], None] | None = None,
    stop: Callable[[], bool] | None = None,
) -> Assignment:
    """Choose a label for every variable by the method that the settings name.

    `progress` receives every better layout or bound; `stop` is asked now and then, and when it
    says true the best layout so far comes back with its honest gap.  Raises RigUIError
    SOLVE_INFEASIBLE when no layout is allowed.
    """
    budget = Budget(settings, progress, stop)
    if settings.method == "paper":
        from usdrigui.solve.paper import solve_by_clusters

        return solve_by_clusters(problem, budget)
    from usdrigui.solve.exact import solve_whole

    return solve_whole(problem, budget)
