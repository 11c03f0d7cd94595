"""Sound reduction: bound whole blocks of candidates, discard what cannot be in a better layout, split the rest."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace

import numpy as np

from usdrigui.model import Flags, Floats, Indices, LayoutProblem
from usdrigui.solve import polish
from usdrigui.solve.blocks import Blocks, Labels, Pool, block_pool, halve, member_slack, singled, thinned, whole
from usdrigui.solve.bounds import Dual
from usdrigui.solve.cells import BYTES_PER_PAIR as BYTES_PER_LINK
from usdrigui.solve.cells import PAIRS, Cells, Costs, inherited, no_cells
from usdrigui.solve.crowding import tightened
from usdrigui.solve.groups import LARGEST, decode, group_gains, group_part
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.search import HELD_BYTES, Part, Search
from usdrigui.solve.spots import places
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
FEW_LABELS = 20000
"""Labels left in blocks from which on they are looked at one by one."""
SINGLED = 0.5
"""Share of the pairs of two blocks' labels that are near, at most, when blocks are small enough to be frustrated."""
THINNED = 0.8
"""Share of the labels left below which they are bounded again before they are searched."""
MOST_NODES = 10**6
FAR = 20.0
"""Spots are priced while the bound is this many allowed gaps away; nearer, groups alone are quicker."""
MOST_PRICED = 1000
"""Variables up to which spots are priced: two entries of each are in play, in tables of all their pairs."""
PRICED = 2.0
"""Times that less must be missing with prices than without for a search to go by prices."""
SOLVED = 0.1
"""Share of the gap allowed within which single labels with prices count as solved: the rest is the prices' fault."""
BYTES_PER_PAIR = 250
"""Of a near pair of blocks: itself, and in keys and tables while those of two rounds are held."""
BYTES_PER_TABLED = 105
"""Of one in near pairs and tables alone."""
SWEEPS = 8
TRIES = 16
"""Attempts of large-neighbourhood search per variable once the bound rises slowly."""


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
    barren: bool = False
    """Whether better prices were looked for in vain."""

    @property
    def pool(self) -> Pool:
        """Costs and places of the blocks."""
        return self.costs.pool

    @property
    def exact(self) -> bool:
        """Whether every block is a single label."""
        return bool(self.blocks.sizes.max(initial=1) == 1)


@dataclass(frozen=True, slots=True)
class Pace:
    """How the rounds are going, and what the next one may spend."""

    nodes: int = NODES
    """Of the search of groups."""
    share: float = NEAR
    """Of the way from the bound to the cut-off in which blocks are split."""
    stuck: bool = False
    """Whether the last round raised the bound by little."""
    searched: bool = False
    """Whether a good layout was looked for longer than at first, because the bound rose slowly."""

    @property
    def slow(self) -> bool:
        """Whether splitting raises the bound by little."""
        return self.share > NEAR

    def after(self, before: Residual, examined: Residual, split: Residual, cut: float) -> Pace:
        """The pace after a round: before it, after its searches, and after the blocks were split."""
        slow = split.bound - examined.bound <= SLOW * (cut - examined.bound)
        return Pace(
            nodes=self.nodes * 2 if examined.exact else self.nodes * 5 // 4,
            share=min(1.0, 2.0 * self.share) if slow else NEAR,
            stuck=split.bound - before.bound < SLOW * (cut - before.bound),
            searched=self.searched or self.slow,
        )


def reduce(problem: LayoutProblem, labels: Labels, forbidden: float, watch: Watch, incumbent: Incumbent) -> Residual:
    """Split and discard blocks until the gap is closed or a limit is reached.

    `incumbent` holds the best layout known of these labels; it is improved on the way.
    """
    blocks = whole(labels)
    for _ in range(3):
        blocks, _parent = halve(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
    residual = _bounded(problem, labels, blocks, forbidden, watch, None, None)
    pace = Pace()
    while True:
        before = residual
        residual = _examined(labels, residual, watch, pace, problem.overlap.radius, incumbent)
        alive = residual.room <= watch.cut
        if not _all_keep(residual, alive):
            watch.found(STEP, bound=watch.cut)
        if watch.closed() or watch.stopped():
            return residual
        rest = thinned(labels, residual.blocks, watch.cut - residual.room)
        if _few_labels(labels, residual, watch):
            blocks, parent = singled(labels, rest)
        else:
            chosen = _affordable(residual, alive, pace.share, watch)
            if chosen is None:
                needed = _planned(residual, alive.astype(np.int64))
                watch.note("memory limit", blocks=len(rest.variable), mebibytes=needed)
                return residual
            blocks, parent = halve(labels, rest, chosen)
        examined = residual
        residual = _bounded(problem, labels, blocks, forbidden, watch, residual, np.flatnonzero(alive)[parent])
        pace = pace.after(before, examined, residual, watch.cut)


def _examined(
    labels: Labels, residual: Residual, watch: Watch, pace: Pace, radius: float, incumbent: Incumbent
) -> Residual:
    """Tell of the bound, raise it by search where splitting no longer would, and try the blocks' solution."""
    watch.found(STEP, bound=min(residual.bound, watch.cut))
    incumbent.improve_from(_representatives(labels, residual, residual.chosen))
    if watch.closed() or watch.stopped():
        return residual
    if pace.slow and not pace.searched:
        incumbent.search(TRIES * residual.pool.count)
    alive = residual.room <= watch.cut
    if residual.exact and alive.sum() <= LARGEST:
        if alive.sum() < THINNED * len(alive):
            return residual
        incumbent.improve_from(_representatives(labels, residual, _polished(residual, watch)))
        if len(residual.cells.count) and pace.stuck:
            residual = _repriced(residual, _entries_of(residual, incumbent.chosen), radius, watch)
        residual = _searched(_at_better_costs(residual, watch), watch)
    elif residual.exact or (_frustrated(residual, watch) and not _few_labels(labels, residual, watch)):
        residual = _crowded(labels, residual, watch, pace, radius, incumbent)
    else:
        return residual
    incumbent.improve_from(_representatives(labels, residual, residual.chosen))
    watch.found(STEP, bound=min(residual.bound, watch.cut))
    solved = residual.exact and residual.value - residual.bound < SOLVED * watch.allowed
    return replace(_without_prices(residual, watch), barren=True) if solved else residual


def _crowded(
    labels: Labels, residual: Residual, watch: Watch, pace: Pace, radius: float, incumbent: Incumbent
) -> Residual:
    """Prices and groups for many entries."""
    first = not len(residual.cells.count)
    if (first or pace.stuck) and not residual.barren:
        residual = _repriced(residual, _entries_of(residual, incumbent.chosen), radius, watch)
    if residual.exact and not watch.closed():
        incumbent.improve_from(_representatives(labels, residual, _polished(residual, watch)))
    return residual if watch.closed() else _grouped(residual, watch, pace.nodes)


def _frustrated(residual: Residual, watch: Watch) -> bool:
    """Whether splitting blocks would leave most of what the bound misses."""
    return residual.value - residual.bound > FRUSTRATED * (watch.cut - residual.bound)


def _few_labels(labels: Labels, residual: Residual, watch: Watch) -> bool:
    """Whether what blocks hold is frustrated, and little enough to be looked at label by label."""
    if residual.exact or not _frustrated(residual, watch):
        return False
    left = member_slack(labels, residual.blocks, watch.cut - residual.room) >= 0
    sizes = np.add.reduceat(left, residual.blocks.start[:-1], dtype=np.int64)
    return bool(sizes.sum() <= FEW_LABELS and SINGLED * _planned(residual, sizes) <= watch.settings.memory_limit)


def _polished(residual: Residual, watch: Watch) -> Indices:
    """(variables,) entries of a good solution at true costs, by local search among the single labels most likely."""
    variable, start = residual.pool.variable, residual.pool.start
    order = np.lexsort((residual.room, variable))
    first = np.zeros(len(order), dtype=bool)
    first[order[start[:-1]]] = True
    likely = np.argsort(np.where(first, -np.inf, residual.room), kind="stable")[: max(LARGEST, residual.pool.count)]
    part = residual.costs.part(np.sort(likely))
    watch.spend(polish.RUNS * polish.TRIES * len(part.variables) * len(part.costs) // 4)
    chosen, _value = polish.polished(part, watch.settings.seed)
    return part.entries[chosen]


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
    part = group_part(residual.dual, tuple(range(len(ends))), [alive[low:high] for low, high in ends])
    part.constant = residual.dual.constant
    return part


def _all_keep(residual: Residual, alive: Flags) -> bool:
    """Whether every variable keeps an entry; otherwise nothing better than the cut-off exists."""
    return bool(np.logical_or.reduceat(alive, residual.pool.start[:-1]).all())


def _representatives(labels: Labels, residual: Residual, chosen: Indices) -> Indices:
    """(variables,) for each block that a solution chooses its member of least linear cost."""
    blocks = residual.blocks
    found = np.empty(len(chosen), dtype=np.int64)
    for variable, at in enumerate(residual.pool.start[:-1] + chosen):
        members = blocks.members[blocks.start[at] : blocks.start[at + 1]]
        found[variable] = members[labels.pool.cost[members].argmin()]
    return found


def _entries_of(residual: Residual, chosen: Indices) -> Indices:
    """The blocks that hold some labels; those of labels that were discarded are left out."""
    at = np.flatnonzero(np.isin(residual.blocks.members, chosen))
    return np.searchsorted(residual.blocks.start, at, side="right") - 1


def _affordable(residual: Residual, alive: Flags, share: float, watch: Watch) -> Flags | None:
    """The blocks to split, fewer than wished where their tables would not fit into the memory allowed; None
    when even those of the solution alone would not."""
    for wanted in (*(share / 2**halved for halved in range(6)), 0.0):
        chosen = _worth_splitting(residual, alive, watch.cut, wanted)
        parts = alive.astype(np.int64)
        parts[np.flatnonzero(alive)[chosen]] = 2
        if _planned(residual, parts) <= watch.settings.memory_limit:
            return chosen
    return None


def _planned(residual: Residual, parts: Indices) -> float:
    """MiB needed when every block is replaced by so many parts: near pairs, their keys while sorted, the tables of
    two rounds in both directions, and the matrices of a search."""
    pairs = sum(int((parts[each.first] * parts[each.second]).sum()) for each in residual.near)
    return max(BYTES_PER_PAIR * pairs, BYTES_PER_TABLED * pairs + HELD_BYTES) / 2**20


def _planned_for_prices(residual: Residual) -> float:
    """MiB needed to price the residual's entries: its own tables, and those of all pairs that prices may link."""
    pairs = sum(len(each.first) for each in residual.near)
    links = min(PAIRS, len(residual.pool.cost) ** 2 // 2)
    return (BYTES_PER_TABLED * pairs + BYTES_PER_LINK * links + HELD_BYTES) / 2**20


def _worth_splitting(residual: Residual, alive: Flags, cut: float, share: float) -> Flags:
    """The blocks whose splitting can raise the bound: those of the solution, and those whose room lies within
    a share of the way from the bound to the cut-off."""
    several = residual.blocks.sizes[alive] > 1
    near = residual.room <= residual.bound + share * (cut - residual.bound)
    near[residual.pool.start[:-1] + residual.chosen] = True
    near = several & near[alive]
    return near if near.any() else several


def _repriced(residual: Residual, solution: Indices, radius: float, watch: Watch) -> Residual:
    """The residual with better prices, if it is worth while to look for them and any are found."""
    few = residual.pool.count <= MOST_PRICED and _planned_for_prices(residual) <= watch.settings.memory_limit
    far = few and watch.cut - residual.bound > FAR * watch.allowed
    return _priced(residual, solution, radius, watch) if far else residual


def _priced(residual: Residual, solution: Indices, radius: float, watch: Watch) -> Residual:
    """The residual with the bound raised by prices on crowded spots."""
    where = places(residual.pool, radius)
    dual, cells = tightened(residual.costs, where, residual.dual, residual.cells, solution, watch.cut, watch)
    bound, excess = dual.parts()
    barren = bound - residual.bound < SLOW * (watch.cut - residual.bound)
    if bound <= residual.bound:
        return replace(residual, barren=barren)
    chosen, value = decode(dual, watch.settings.seed)
    watch.found(STEP, bound=min(bound, watch.cut))
    room = np.maximum(residual.room, bound + np.concatenate(excess))
    return replace(residual, cells=cells, dual=dual, bound=bound, room=room, chosen=chosen, value=value, barren=barren)


def _at_better_costs(residual: Residual, watch: Watch) -> Residual:
    """The residual at its true costs, unless prices save a search most of the way from the bound to the cut-off."""
    true = _without_prices(residual, watch)
    return residual if watch.cut - true.bound > PRICED * (watch.cut - residual.bound) else true


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
        same = (blocks.sizes > 1) | (older.blocks.sizes[parent] == 1)
        near = refined(problem, pool, older.near, parent, watch, same)
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
    residual = Residual(blocks, near, costs, cells, dual, bound, bound + np.concatenate(excess), chosen, value)
    # Prices that blocks did not have may be found for single labels.
    same = older is not None and older.barren and older.exact == residual.exact
    return replace(residual, barren=same)
