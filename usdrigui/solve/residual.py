"""What is left of a problem, and what dual ascent on it proves."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from usdrigui.model import Flags, Floats, Indices, LayoutProblem
from usdrigui.solve.blocks import Blocks, Labels, Pool, block_pool
from usdrigui.solve.bounds import Dual
from usdrigui.solve.cells import Cells, Costs, inherited, no_cells
from usdrigui.solve.groups import decode
from usdrigui.solve.sweeps import swept, work_of
from usdrigui.solve.tables import NearPairs, near_blocks, pair_tables, refined
from usdrigui.solve.watch import Watch

STEP = "blocks"
"""Name of the reduction in what is told of it."""
SWEEPS = 8
"""Of dual ascent on new blocks."""
FRUSTRATED = 0.7
"""Share of the missing bound that the blocks' own solution must leave before groups are searched."""


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
    pricing: int = 0
    """Work that the last search for prices took."""

    @property
    def pool(self) -> Pool:
        """Costs and places of the blocks."""
        return self.costs.pool

    @property
    def exact(self) -> bool:
        """Whether every block is a single label."""
        return bool(self.blocks.sizes.max(initial=1) == 1)

    @property
    def priced(self) -> bool:
        """Whether spots have prices."""
        return bool(len(self.cells.count))

    def alive(self, cut: float) -> Flags:
        """(n,) the entries that solutions below the cut-off may use."""
        return self.room <= cut

    def all_keep(self, cut: float) -> bool:
        """Whether every variable keeps an entry; otherwise nothing better than the cut-off exists."""
        return bool(np.logical_or.reduceat(self.alive(cut), self.pool.start[:-1]).all())

    def frustrated(self, cut: float) -> bool:
        """Whether splitting blocks would leave most of what the bound misses."""
        return self.value - self.bound > FRUSTRATED * (cut - self.bound)

    def representatives(self, labels: Labels, chosen: Indices) -> Indices:
        """(variables,) for each block that a solution chooses its member of least linear cost."""
        found = np.empty(len(chosen), dtype=np.int64)
        for variable, at in enumerate(self.pool.start[:-1] + chosen):
            members = self.blocks.members[self.blocks.start[at] : self.blocks.start[at + 1]]
            found[variable] = members[labels.pool.cost[members].argmin()]
        return found

    def entries_of(self, chosen: Indices) -> Indices:
        """The blocks that hold some labels; those of labels that were discarded are left out."""
        at = np.flatnonzero(np.isin(self.blocks.members, chosen))
        return np.searchsorted(self.blocks.start, at, side="right") - 1


def bounded_blocks(
    problem: LayoutProblem,
    labels: Labels,
    blocks: Blocks,
    forbidden: float,
    watch: Watch,
    older: Residual | None = None,
    parent: Indices | None = None,
) -> Residual:
    """Tables of the blocks, dual ascent on them, and what it proves.

    `parent` tells for every block which one of the `older` residual it is part of; its near pairs, prices and
    multipliers are where the ascent starts.
    """
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
    swept(dual, SWEEPS)
    watch.spend(1000 + work_of(dual, SWEEPS))
    bound, excess = dual.parts()
    chosen, value = decode(dual, watch.settings.seed)
    residual = Residual(blocks, near, costs, cells, dual, bound, bound + np.concatenate(excess), chosen, value)
    # Prices that blocks did not have may be found for single labels.
    same = older is not None and older.barren and older.exact == residual.exact
    return replace(residual, barren=same, pricing=0 if older is None else older.pricing)
