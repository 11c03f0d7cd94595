"""Sound reduction: bound whole blocks of candidates, discard what cannot be in a better layout, split the rest."""

from __future__ import annotations

from dataclasses import replace

from usdrigui.model import LayoutProblem
from usdrigui.solve.blocks import Labels
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.pace import Pace
from usdrigui.solve.pricing import at_better_costs, repriced, without_prices
from usdrigui.solve.residual import STEP, Residual, bounded_blocks
from usdrigui.solve.residual_search import few_enough, grouped, likely_solution, searched
from usdrigui.solve.splitting import few_labels, first_blocks, split
from usdrigui.solve.watch import Watch

TRIES = 16
"""Attempts of large-neighbourhood search per variable once the bound rises slowly."""
HANDFUL = 100
"""Labels left up to which they are searched at once: a better layout first would save less than it takes to find."""
THINNED = 0.8
"""Share of the labels left below which they are bounded again before they are searched."""
SOLVED = 0.1
"""Share of the gap allowed within which single labels with prices count as solved: the rest is the prices' fault."""


def reduce(problem: LayoutProblem, labels: Labels, forbidden: float, watch: Watch, incumbent: Incumbent) -> Residual:
    """Split and discard blocks until the gap is closed or a limit is reached.

    `incumbent` holds the best layout known of these labels; it is improved on the way.
    """
    blocks = first_blocks(labels, watch)
    residual = bounded_blocks(problem, labels, blocks, forbidden, watch)
    pace = Pace()
    while True:
        examined = _examined(labels, residual, watch, pace, problem.overlap.radius, incumbent)
        if not examined.all_keep(watch.cut):
            watch.found(STEP, bound=watch.cut)
        if watch.closed() or watch.stopped():
            return examined
        parts = split(labels, examined, pace.share, watch)
        if parts is None:
            return examined
        smaller = bounded_blocks(problem, labels, parts[0], forbidden, watch, examined, parts[1])
        pace = pace.after(residual, examined, smaller, watch.cut)
        residual = smaller


def _examined(
    labels: Labels, residual: Residual, watch: Watch, pace: Pace, radius: float, incumbent: Incumbent
) -> Residual:
    """Tell of the bound, raise it by search where splitting no longer would, and try the blocks' solution."""
    watch.found(STEP, bound=min(residual.bound, watch.cut))
    incumbent.improve_from(residual.representatives(labels, residual.chosen))
    if watch.closed() or watch.stopped():
        return residual
    if pace.slow and not pace.searched:
        incumbent.search(TRIES * residual.pool.count)
    if few_enough(residual, watch.cut):
        alive = residual.alive(watch.cut)
        if HANDFUL < alive.sum() < THINNED * len(alive):
            return residual
        residual = _as_one_problem(labels, residual, watch, pace, radius, incumbent)
    elif residual.exact or (residual.frustrated(watch.cut) and not few_labels(labels, residual, watch)):
        residual = _by_groups(labels, residual, watch, pace, radius, incumbent)
    else:
        return residual
    incumbent.improve_from(residual.representatives(labels, residual.chosen))
    watch.found(STEP, bound=min(residual.bound, watch.cut))
    solved = residual.exact and residual.value - residual.bound < SOLVED * watch.allowed
    return replace(without_prices(residual, watch), barren=True) if solved else residual


def _as_one_problem(
    labels: Labels, residual: Residual, watch: Watch, pace: Pace, radius: float, incumbent: Incumbent
) -> Residual:
    """Better prices where there are any, and a search of all that is left."""
    if residual.alive(watch.cut).sum() > HANDFUL:
        incumbent.improve_from(residual.representatives(labels, likely_solution(residual, watch)))
    if residual.priced and pace.stuck:
        residual = repriced(residual, residual.entries_of(incumbent.chosen), radius, watch)
    return searched(at_better_costs(residual, watch), watch)


def _by_groups(
    labels: Labels, residual: Residual, watch: Watch, pace: Pace, radius: float, incumbent: Incumbent
) -> Residual:
    """Prices and groups for many entries."""
    if not residual.priced and not pace.slow:
        incumbent.search(TRIES * residual.pool.count)
    before = residual.bound
    if not residual.barren:
        residual = repriced(residual, residual.entries_of(incumbent.chosen), radius, watch)
    if residual.exact and not watch.closed():
        incumbent.improve_from(residual.representatives(labels, likely_solution(residual, watch)))
    better = residual.bound > before and not residual.barren
    return residual if better or watch.closed() else grouped(residual, watch, pace.nodes)
