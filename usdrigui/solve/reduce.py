"""Sound reduction: bound whole blocks of candidates, discard what cannot be in a better layout, split the rest."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from usdrigui.model import Flags, Floats, Indices, LayoutProblem
from usdrigui.solve import polish
from usdrigui.solve.blocks import Blocks, Labels, Pool, block_pool, halve, keep, singled, whole
from usdrigui.solve.bounds import Dual
from usdrigui.solve.cells import MOST_BYTES, Cells, inherited, no_cells
from usdrigui.solve.crowding import Costs, places, tightened
from usdrigui.solve.groups import LARGEST, decode, group_gains, group_part
from usdrigui.solve.search import HELD_BYTES, Part, Search
from usdrigui.solve.tables import NearPairs, near_blocks, pair_tables, refined
from usdrigui.solve.watch import Watch

STEP = "blocks"
NODES = 400
MEMBERS = 10
"""Variables of a group at first."""
NEAR = 0.02
SLOW = 0.1
SMALL = 0.05
FRUSTRATED = 0.7
"""Share of the missing bound that the blocks' own solution must leave before groups are searched."""
FEW_LABELS = 5000
"""Labels left in blocks from which on they are looked at one by one."""
THINNED = 0.8
"""Share of the labels left below which they are bounded again before they are searched."""
MOST_NODES = 10**6
FAR = 20.0
"""Spots are priced while the bound is this many allowed gaps away; nearer, groups alone are quicker."""
MOST_PRICED = 1000
"""Variables up to which spots are priced: two entries of each are in play, in tables of all their pairs."""
BYTES_PER_PAIR = 120
SWEEPS = 8


@dataclass(frozen=True, eq=False)
class Residual:
    """What is left of a problem: blocks that no bound could discard, with the multipliers found."""

    blocks: Blocks
    near: list[NearPairs]
    costs: Costs
    cells: Cells
    """Crowded spots and their prices; they are worked into the dual."""
    dual: Dual
    bound: float
    """Lower bound on every solution of the unreduced problem that costs less than the cut-off."""
    room: Floats
    """(n,) lower bound on the cost of solutions that use an entry of the pool."""
    chosen: Indices
    """(variables,) entries of the best solution known of the problem that the blocks bound from below."""
    value: float
    """Its cost there: at best the bound can rise to this before blocks are split."""

    @property
    def pool(self) -> Pool:
        """Costs and places of the blocks."""
        return self.costs.pool

    @property
    def exact(self) -> bool:
        """Whether every block is a single label."""
        return bool(self.blocks.sizes.max(initial=1) == 1)


def reduce(
    problem: LayoutProblem, labels: Labels, forbidden: float, watch: Watch, improve: Callable[[Indices], None]
) -> Residual:
    """Split and discard blocks until the gap is closed or a limit is reached.

    `improve` is handed labels (pool indices, one per variable) that may be near a better layout.
    """
    blocks = whole(labels)
    for _ in range(3):
        blocks, _parent = halve(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
    residual = _bounded(problem, labels, blocks, forbidden, watch, None, None)
    nodes, share = NODES, NEAR
    while True:
        residual = _examined(labels, residual, watch, nodes, problem.overlap.radius, improve)
        alive = residual.room <= watch.cut
        if not _all_keep(residual, alive):
            watch.found(STEP, bound=watch.cut)
        if watch.closed() or watch.stopped():
            return residual
        nodes = nodes * 5 // 4 if residual.blocks.sizes[alive].max() > 1 else nodes * 2
        rest = keep(residual.blocks, alive)
        if _few_labels(residual, alive, watch):
            blocks, parent = singled(labels, rest)
        else:
            chosen = _affordable(residual, alive, share, watch)
            if chosen is None:
                needed = _planned(residual, alive.astype(np.int64))
                watch.note("memory limit", blocks=len(rest.variable), mebibytes=needed)
                return residual
            blocks, parent = halve(labels, rest, chosen)
        before = residual.bound
        residual = _bounded(problem, labels, blocks, forbidden, watch, residual, np.flatnonzero(alive)[parent])
        share = NEAR if residual.bound - before > SLOW * (watch.cut - before) else min(1.0, 2.0 * share)


def _examined(
    labels: Labels, residual: Residual, watch: Watch, nodes: int, radius: float, improve: Callable[[Indices], None]
) -> Residual:
    """Tell of the bound, raise it by search where splitting no longer would, and try the blocks' solution."""
    watch.found(STEP, bound=min(residual.bound, watch.cut))
    improve(_representatives(labels, residual))
    if watch.closed() or watch.stopped():
        return residual
    alive = residual.room <= watch.cut
    if residual.exact and alive.sum() <= LARGEST:
        if alive.sum() < THINNED * len(alive):
            return residual
        residual = _polished(_without_prices(residual, watch), watch)
        improve(_representatives(labels, residual))
        residual = _searched(residual, watch)
    elif residual.exact or (_frustrated(residual, watch) and not _few_labels(residual, alive, watch)):
        residual = _repriced(residual, radius, watch)
        if not watch.closed():
            residual = _grouped(residual, watch, nodes)
    else:
        return residual
    improve(_representatives(labels, residual))
    watch.found(STEP, bound=min(residual.bound, watch.cut))
    return residual


def _frustrated(residual: Residual, watch: Watch) -> bool:
    """Whether splitting blocks would leave most of what the bound misses."""
    return residual.value - residual.bound > FRUSTRATED * (watch.cut - residual.bound)


def _few_labels(residual: Residual, alive: Flags, watch: Watch) -> bool:
    """Whether what blocks hold is frustrated, and little enough to be looked at label by label."""
    sizes = np.where(alive, residual.blocks.sizes, 0)
    few = not residual.exact and _frustrated(residual, watch) and sizes.sum() <= FEW_LABELS
    return bool(few and _planned(residual, sizes) <= watch.settings.memory_limit)


def _polished(residual: Residual, watch: Watch) -> Residual:
    """The residual of single labels with a better solution, if a local search among them finds one."""
    part = _left(residual, watch)
    if part is None:
        return residual
    watch.spend(polish.RUNS * polish.TRIES * len(part.variables) * len(part.costs) // 4)
    chosen, value = polish.polished(part, watch.settings.seed)
    if value >= residual.value:
        return residual
    return replace(residual, chosen=part.entries[chosen], value=value)


def _searched(residual: Residual, watch: Watch) -> Residual:
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
    alive = residual.room <= watch.cut
    if not _all_keep(residual, alive):
        return None
    ends = list(itertools.pairwise(residual.pool.start))
    return group_part(residual.dual, tuple(range(len(ends))), [alive[low:high] for low, high in ends])


def _all_keep(residual: Residual, alive: Flags) -> bool:
    """Whether every variable keeps an entry; otherwise nothing better than the cut-off exists."""
    return bool(np.logical_or.reduceat(alive, residual.pool.start[:-1]).all())


def _representatives(labels: Labels, residual: Residual) -> Indices:
    """(variables,) for each block of the solution its member of least linear cost."""
    blocks = residual.blocks
    found = np.empty(len(residual.chosen), dtype=np.int64)
    for variable, at in enumerate(residual.pool.start[:-1] + residual.chosen):
        members = blocks.members[blocks.start[at] : blocks.start[at + 1]]
        found[variable] = members[labels.pool.cost[members].argmin()]
    return found


def _affordable(residual: Residual, alive: Flags, share: float, watch: Watch) -> Flags | None:
    """The blocks to split, fewer than wished where their tables would not fit into the memory allowed; None
    when even those of the solution alone would not."""
    for wanted in (share, 0.25 * share, 0.0):
        chosen = _worth_splitting(residual, alive, watch.cut, wanted)
        parts = alive.astype(np.int64)
        parts[np.flatnonzero(alive)[chosen]] = 2
        if _planned(residual, parts) <= watch.settings.memory_limit:
            return chosen
    return None


def _planned(residual: Residual, parts: Indices) -> float:
    """MiB needed when every block is replaced by so many parts: near pairs, their keys while sorted, and the
    tables of two rounds in both directions; the matrices of a search; and the pairs of cells."""
    pairs = sum(int((parts[each.first] * parts[each.second]).sum()) for each in residual.near)
    return (BYTES_PER_PAIR * pairs + HELD_BYTES + MOST_BYTES) / 2**20


def _worth_splitting(residual: Residual, alive: Flags, cut: float, share: float) -> Flags:
    """The blocks whose splitting can raise the bound: those of the solution, and those whose room lies within
    a share of the way from the bound to the cut-off."""
    several = residual.blocks.sizes[alive] > 1
    near = residual.room <= residual.bound + share * (cut - residual.bound)
    near[residual.pool.start[:-1] + residual.chosen] = True
    near = several & near[alive]
    return near if near.any() else several


def _repriced(residual: Residual, radius: float, watch: Watch) -> Residual:
    """The residual with better prices; single labels lose theirs where none better are found."""
    far = watch.cut - residual.bound > FAR * watch.allowed and residual.pool.count <= MOST_PRICED
    better = _priced(residual, radius, watch) if far else residual
    return _without_prices(residual, watch) if residual.exact and better is residual else better


def _priced(residual: Residual, radius: float, watch: Watch) -> Residual:
    """The residual with the bound raised by prices on crowded spots."""
    where = places(residual.pool, radius)
    dual, cells = tightened(residual.costs, where, residual.dual, residual.cells, watch.cut, watch)
    bound, excess = dual.parts()
    if bound <= residual.bound:
        return residual
    chosen, value = decode(dual, watch.settings.seed)
    watch.found(STEP, bound=min(bound, watch.cut))
    room = np.maximum(residual.room, bound + np.concatenate(excess))
    return replace(residual, cells=cells, dual=dual, bound=bound, room=room, chosen=chosen, value=value)


def _without_prices(residual: Residual, watch: Watch) -> Residual:
    """The residual at its true costs: prices that are not quite right would leave a gap for ever."""
    if not len(residual.cells.count):
        return residual
    dual = residual.costs.dual(no_cells())
    dual.start_from(residual.dual, [np.arange(len(each)) for each in dual.theta])
    for _ in range(2 * SWEEPS):
        dual.sweep()
    bound, excess = dual.parts()
    chosen, value = decode(dual, watch.settings.seed)
    room = np.maximum(residual.room, bound + np.concatenate(excess))
    bound = max(bound, residual.bound)
    return replace(residual, cells=no_cells(), dual=dual, bound=bound, room=room, chosen=chosen, value=value)


def _grouped(residual: Residual, watch: Watch, nodes: int) -> Residual:
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


def _bounded(
    problem: LayoutProblem,
    labels: Labels,
    blocks: Blocks,
    forbidden: float,
    watch: Watch,
    older: Residual | None,
    parent: Indices | None,
) -> Residual:
    """Tables of the blocks, dual ascent on them, and what it proves."""
    pool = block_pool(labels, blocks)
    candidate = np.where(blocks.sizes == 1, labels.label[blocks.members[blocks.start[:-1]]], -2)
    if older is None or parent is None:
        near = near_blocks(problem, pool, watch)
    else:
        near = refined(problem, pool, older.near, parent, watch)
    costs = Costs(pool, pool.cost, tuple(pair_tables(problem, pool, near, candidate)), forbidden)
    cells = inherited(older.cells, parent) if older is not None and parent is not None else no_cells()
    dual = costs.dual(cells)
    if older is not None and parent is not None:
        ends = zip(pool.start[:-1], pool.start[1:], older.pool.start[:-1], strict=True)
        dual.start_from(older.dual, [parent[a:b] - old for a, b, old in ends])
    for _ in range(SWEEPS):
        dual.sweep()
    watch.spend(1000 + SWEEPS * (dual.size // 16 + 64 * len(dual.edges)))
    bound, excess = dual.parts()
    chosen, value = decode(dual, watch.settings.seed)
    return Residual(blocks, near, costs, cells, dual, bound, bound + np.concatenate(excess), chosen, value)
