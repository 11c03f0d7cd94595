"""A residual with prices on crowded spots, or without them, whichever serves its bound better."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.model import Indices
from usdrigui.solve.cells import no_cells
from usdrigui.solve.crowding import tightened
from usdrigui.solve.groups import decode
from usdrigui.solve.memory import planned_for_prices
from usdrigui.solve.pace import SLOW
from usdrigui.solve.residual import STEP, SWEEPS, Residual
from usdrigui.solve.spots import places
from usdrigui.solve.sweeps import swept
from usdrigui.solve.watch import Watch

FAR = 20.0
"""Spots are priced while the bound is this many allowed gaps away; nearer, groups alone are quicker."""
MOST_PRICED = 1000
"""Variables up to which spots are priced: two entries of each are in play, in tables of all their pairs."""
PRICED = 2.0
"""Times that less must be missing with prices than without for a search to go by prices."""
WORTH_STARTING = 0.6
"""Share of the work of the last search for prices that must be left for another: prices are good for little before
they have cooled."""


def repriced(residual: Residual, solution: Indices, radius: float, watch: Watch) -> Residual:
    """The residual with better prices, if it is worth while to look for them and any are found."""
    few = residual.pool.count <= MOST_PRICED and planned_for_prices(residual) <= watch.settings.memory_limit
    far = few and watch.cut - residual.bound > FAR * watch.allowed
    enough = watch.work_left >= WORTH_STARTING * residual.pricing
    return _priced(residual, solution, radius, watch) if far and enough else residual


def at_better_costs(residual: Residual, watch: Watch) -> Residual:
    """The residual at its true costs, unless prices save a search most of the way from the bound to the cut-off."""
    true = without_prices(residual, watch)
    return residual if watch.cut - true.bound > PRICED * (watch.cut - residual.bound) else true


def without_prices(residual: Residual, watch: Watch) -> Residual:
    """The residual at its true costs: prices that are not quite right would leave a gap for ever."""
    if not residual.priced:
        return residual
    dual = residual.costs.dual(no_cells())
    dual.start_from(residual.dual, [np.arange(len(each)) for each in dual.theta])
    swept(dual, 2 * SWEEPS)
    bound, excess = dual.parts()
    chosen, value = decode(dual, watch.settings.seed)
    room = np.maximum(residual.room, bound + np.concatenate(excess))
    return replace(residual, cells=no_cells(), dual=dual, bound=bound, room=room, chosen=chosen, value=value)


def _priced(residual: Residual, solution: Indices, radius: float, watch: Watch) -> Residual:
    """The residual with the bound raised by prices on crowded spots."""
    where, before = places(residual.pool, radius), watch.work
    dual, cells = tightened(residual.costs, where, residual.dual, residual.cells, solution, watch.cut, watch)
    bound, excess = dual.parts()
    barren = bound - residual.bound < SLOW * (watch.cut - residual.bound)
    residual = replace(residual, barren=barren, pricing=watch.work - before)
    if not bound > residual.bound:
        return residual
    chosen, value = decode(dual, watch.settings.seed)
    watch.found(STEP, bound=min(bound, watch.cut))
    room = np.maximum(residual.room, bound + np.concatenate(excess))
    return replace(residual, cells=cells, dual=dual, bound=bound, room=room, chosen=chosen, value=value)
