"""A residual's bound raised by search: of all that is left as one problem, or of groups of its variables."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np

from usdrigui.model import Indices
from usdrigui.solve import polish
from usdrigui.solve.groups import LARGEST, group_gains, group_part
from usdrigui.solve.residual import STEP, Residual
from usdrigui.solve.search import Search
from usdrigui.solve.subproblem import Part
from usdrigui.solve.watch import Watch

MOST_NODES = 10**6
"""Of a search of all that is left."""
MEMBERS = 10
"""Variables of a group at first."""
SMALL = 0.05
"""Share of what is missing below which clashes of blocks are not worth a larger group."""


def few_enough(residual: Residual, cut: float) -> bool:
    """Whether single labels are left, and few enough to be searched as one problem."""
    return residual.exact and bool(residual.alive(cut).sum() <= LARGEST)


def searched(residual: Residual, watch: Watch) -> Residual:
    """The residual of single labels with what a search of all of them as one problem proves and finds."""
    part = _left(residual, watch)
    if part is None:
        return residual

    def proved(bound: float) -> None:
        watch.found(STEP, bound=min(bound, watch.cut))

    found = Search(watch, MOST_NODES).deepen(part, watch.cut, watch.cut - residual.bound, proved)
    bound = max(residual.bound, found.bound)
    residual = replace(residual, bound=bound, room=np.maximum(residual.room, bound))
    if not np.isfinite(found.cost):
        return residual
    chosen = np.array([found.chosen[variable] for variable in range(len(residual.chosen))])
    return replace(residual, chosen=chosen, value=found.cost)


def _left(residual: Residual, watch: Watch) -> Part | None:
    """All that may be in a better solution as one problem; None if some variable has nothing left."""
    if not residual.all_keep(watch.cut):
        return None
    alive = residual.alive(watch.cut)
    ends = list(itertools.pairwise(residual.pool.start))
    part = group_part(residual.dual, tuple(range(len(ends))), [alive[low:high] for low, high in ends])
    part.constant = residual.dual.constant
    return part


def grouped(residual: Residual, watch: Watch, nodes: int) -> Residual:
    """The residual with the bound raised by groups of variables."""
    dual = residual.dual
    found = group_gains(
        dual, residual.bound, residual.chosen, watch.cut, watch, nodes, MEMBERS, 0.0 if residual.exact else SMALL
    )
    total = residual.bound + float(found.gain.sum())
    _, excess = dual.parts(found.member)
    own = np.array([found.gain[each] if each >= 0 else 0.0 for each in found.member])
    room = np.concatenate([each + (total - mine) for each, mine in zip(excess, own, strict=True)])
    return replace(
        residual,
        bound=total,
        room=np.maximum(np.maximum(residual.room, room), total),
        chosen=found.chosen,
        value=dual.cost(found.chosen),
    )


def likely_solution(residual: Residual, watch: Watch) -> Indices:
    """(variables,) entries of a good solution at true costs, by local search among the single labels most likely."""
    variable, start = residual.pool.variable, residual.pool.start
    order = np.lexsort((residual.room, variable))
    first = np.zeros(len(order), dtype=bool)
    first[order[start[:-1]]] = True
    likely = np.argsort(np.where(first, -np.inf, residual.room), kind="stable")[: max(LARGEST, residual.pool.count)]
    part = residual.costs.part(np.sort(likely))
    watch.spend(polish.RUNS * polish.TRIES * len(part.variables) * len(part.costs) // 12)
    chosen, _value = polish.polished(part, watch.settings.seed)
    return part.entries[chosen]
