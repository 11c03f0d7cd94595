"""Prices on crowded spots: proposed by ascent of the smoothed dual over few entries, checked over all.

What the relaxation chooses is few of the entries at any time.  So the ascent works on those in play, and now and
then settles with all others: those that would be cheaper than what is in play come into it, dear ones leave (column
generation, as for linear programs).  While it cools, cells that have become crowded get a price.
"""

from __future__ import annotations

import numpy as np

from usdrigui.model import Floats, Indices
from usdrigui.solve.ascent import Ascent
from usdrigui.solve.bounds import Dual
from usdrigui.solve.cells import Cells, Costs, bounded, cells_of
from usdrigui.solve.spots import Places, crowded
from usdrigui.solve.sweeps import Sweeps, work_of
from usdrigui.solve.watch import Watch

PHASES = 10
"""Times that the entries in play are chosen anew, at most."""
FEWEST_PHASES, PER_PHASE = 3, 100
"""The least number of phases, and entries of the pool for which there is one more."""
STEPS = 15
"""Steps of prices in a phase."""
SEARCH_EVERY = 8
"""Steps between two searches for crowded cells."""
IN_PLAY = 2000
"""Entries that the ascent works on at most."""
FEWEST = 3
"""Entries in play of a variable, at least: the cheapest."""
SOFT = 0.33
"""Softness at first, in shares of what is missing per variable and table."""
WARM = 1.0
"""The same where there are prices already: about as soft, since a third as much is missing."""
COOLER, COOLED = 0.8, 8
"""Where too many entries would be in play, the first softness is lowered by this, so many times at most."""
COOLING = 0.25
"""Share of the first softness that is left at the end."""
WIDTH = 6.0
"""Entries this many softnesses above the cheapest, for each of its variable's tables, are in play."""
SETTLING = 3
"""Sweeps after the entries in play have changed."""
SWEEPS = 100
"""Sweeps over all entries at the end, at most."""
AT_ONCE = 8
"""Sweeps between two looks at the bound."""
GAINED = 2e-3
"""Share of what is missing that a sweep must gain for another one."""
DEAR = 1.5
"""Cost, in shares of what is missing, beyond which pairs cost the ascent no more."""
EXCHANGES = 8
"""Entries taken into or out of a cell beyond its spot, once the spots have their prices."""
TINY = 1e-7


def tightened(
    costs: Costs, where: Places, dual: Dual, cells: Cells, solution: Indices, cut: float, watch: Watch
) -> tuple[Dual, Cells]:
    """A dual of the same problem with other prices, if its bound is better; else the one given.

    `solution` (variables,) are entries of the pool that a good solution chooses: they stay in play.
    """
    bound = dual.bound()
    if cut - bound <= 0 or watch.stopped():
        return dual, cells
    new, other = _proposed(costs, where, dual, cells, solution, cut - bound, watch)
    if not _raised(new, cut, watch) > bound:  # not a number proves nothing
        return dual, cells
    return new, other


def _raised(dual: Dual, cut: float, watch: Watch) -> float:
    """Sweep while that raises the bound; the bound."""
    _swept_while_worth_it(dual, cut, watch)
    dual.sweep()
    return dual.bound()


def _swept_while_worth_it(dual: Dual, cut: float, watch: Watch) -> None:
    sweeps, before = Sweeps(dual, SWEEPS), -np.inf
    for _ in range(SWEEPS // AT_ONCE):
        sweeps.go(AT_ONCE)
        watch.spend(work_of(dual, AT_ONCE))
        bound = sweeps.bound()
        if bound - before < AT_ONCE * GAINED * (cut - bound):
            break
        before = bound
    sweeps.hand_over()


def _proposed(
    costs: Costs, where: Places, dual: Dual, cells: Cells, solution: Indices, missing: float, watch: Watch
) -> tuple[Dual, Cells]:
    """A dual with other prices, likely to give a better bound than `dual` with those of `cells` once it is swept."""
    ascent = Ascent(costs, dual, cells, DEAR * missing)
    warm = len(cells.count) > 0
    softness = (WARM if warm else SOFT) * missing / (len(dual.theta) + len(dual.edges))
    excess = _first_excess(ascent, dual, solution, softness)
    for _ in range(COOLED):
        if (excess <= _width(ascent, softness)).sum() > IN_PLAY:
            softness *= COOLER
    phases = int(np.clip(len(costs.pool.cost) // PER_PHASE, FEWEST_PHASES, PHASES))
    for phase in range(phases):
        eps = softness * COOLING ** (phase / (phases - 1))
        excess[solution] = -np.inf
        ascent.play(_in_play(costs, excess, _width(ascent, eps)))
        for _ in range(SETTLING):
            ascent.sweep(eps)
        _price(ascent, where, eps, EXCHANGES if warm or 2 * phase >= phases else 0, watch)
        ascent.drop(TINY)
        excess = ascent.settle()
        watch.spend(len(excess) * len(ascent.chosen) // 12)
        if watch.stopped():
            break
    kept = ascent.price > TINY
    members = [np.flatnonzero(each) for each in ascent.member[kept]]
    other = bounded(cells_of(members, ascent.count[kept], ascent.price[kept]))
    new = costs.dual(other)
    ascent.hand_over(new)
    return new, other


def _width(ascent: Ascent, eps: float) -> float:
    """How much dearer than the cheapest entries in play may be: a variable's costs are shared out among its tables."""
    return WIDTH * eps * (1.0 + float(ascent.linked.sum(axis=1).max(initial=0)))


def _first_excess(ascent: Ascent, dual: Dual, solution: Indices, eps: float) -> Floats:
    """(n,) how much dearer the entries are than the cheapest of their variable at the prices known."""
    excess = np.concatenate([each - each.min() for each in dual.theta])
    for _ in range(SETTLING):
        excess[solution] = -np.inf
        ascent.play(_in_play(ascent.costs, excess, np.inf))
        for _sweep in range(SETTLING):
            ascent.sweep(eps)
        excess = ascent.settle()
    return excess


def _price(ascent: Ascent, where: Places, eps: float, exchanges: int, watch: Watch) -> None:
    """Look for crowded cells now and then, and change all prices step by step."""
    for step in range(STEPS):
        if step % SEARCH_EVERY == 0:
            ascent.extend(*crowded(ascent, where, eps, exchanges))
        ascent.sweep(eps, back=True)
        ascent.price_step(eps)
        watch.spend(ascent.work // 1000)
        if watch.stopped():
            return


def _in_play(costs: Costs, excess: Floats, width: float) -> Indices:
    """The entries within a width of the cheapest of their variables, a few of each variable at least."""
    pool = costs.pool
    order = np.lexsort((excess, pool.variable))
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.arange(len(order)) - pool.start[pool.variable[order]]
    wanted = np.where(rank < FEWEST, -np.inf, excess)
    most = max(IN_PLAY, int((rank < FEWEST).sum()))
    nearest = np.argsort(wanted, kind="stable")[:most]
    return np.sort(nearest[wanted[nearest] <= width])
