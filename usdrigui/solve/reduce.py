"""Sound reduction: bound whole blocks of candidates, discard what cannot be in a better layout, split the rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.model import Floats, Indices, LayoutProblem
from usdrigui.solve.blocks import Blocks, Labels, Pool, block_pool, halve, keep, whole
from usdrigui.solve.bounds import Dual
from usdrigui.solve.tables import pair_tables
from usdrigui.solve.watch import Watch

STEP = "blocks"
SWEEPS = 12


@dataclass(frozen=True, eq=False)
class Residual:
    """What is left of a problem: blocks that no bound could discard, with the multipliers found."""

    blocks: Blocks
    pool: Pool
    dual: Dual
    bound: float
    """Lower bound on every solution of the unreduced problem that costs less than the cut-off."""
    excess: Floats
    """(n,) lower bound on what using an entry of the pool costs above `bound`."""

    @property
    def exact(self) -> bool:
        """Whether every block is a single label."""
        return bool(self.blocks.sizes.max(initial=1) == 1)


def reduce(problem: LayoutProblem, labels: Labels, forbidden: float, watch: Watch) -> Residual:
    """Split and discard blocks until the gap is closed, all blocks are single labels, or the budget is spent."""
    blocks = whole(labels)
    for _ in range(3):
        blocks, _parent = halve(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
    residual = _bounded(problem, labels, blocks, forbidden, watch, None, None)
    while not (watch.closed() or residual.exact or watch.stopped()):
        alive = residual.bound + residual.excess <= watch.cut
        rest = keep(residual.blocks, alive)
        blocks, parent = halve(labels, rest, _worth_splitting(rest, residual.excess[alive], watch))
        parent = np.flatnonzero(alive)[parent]
        if _planned(blocks) > watch.settings.memory_limit * 2**20:
            break
        residual = _bounded(problem, labels, blocks, forbidden, watch, residual, parent)
    return residual


def _planned(blocks: Blocks) -> float:
    """Bytes that the tables of these blocks can take at most."""
    sizes = np.bincount(blocks.variable).astype(np.float64)
    return 24 * (sizes.sum() ** 2 - np.square(sizes).sum()) / 2 * 0.5


def _worth_splitting(blocks: Blocks, excess: Floats, watch: Watch) -> Indices:
    """The blocks near the bound: splitting these can raise it."""
    several = blocks.sizes > 1
    near = several & (excess <= 0.1 * (watch.cut - watch.bound))
    return near if near.any() else several


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
    tables = pair_tables(problem, pool, candidate, watch)
    unary = [pool.cost[a:b].copy() for a, b in zip(pool.start[:-1], pool.start[1:], strict=True)]
    dual = Dual(unary, tables, forbidden)
    if older is not None and parent is not None:
        ends = zip(pool.start[:-1], pool.start[1:], older.pool.start[:-1], strict=True)
        dual.start_from(older.dual, [parent[a:b] - old for a, b, old in ends])
    for _ in range(SWEEPS):
        dual.sweep()
    bound, stars = dual.parts()
    watch.found(STEP, bound=min(bound, watch.cut))
    return Residual(blocks, pool, dual, bound, np.concatenate(stars))
