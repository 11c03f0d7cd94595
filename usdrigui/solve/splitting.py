"""Which blocks there are at first, which of a residual are split, and into what: halves, or all their labels."""

from __future__ import annotations

import numpy as np

from usdrigui.model import Flags, Indices
from usdrigui.solve.blocks import Blocks, Labels, halve, member_slack, singled, thinned, whole
from usdrigui.solve.groups import LARGEST
from usdrigui.solve.memory import planned, planned_for_pairs
from usdrigui.solve.residual import Residual
from usdrigui.solve.watch import Watch

ONE_BY_ONE = LARGEST
"""Labels up to which a problem is not cut into blocks at all."""
FIRST_LOOK = 0.25
"""Share of the work and time left that the first look at all of those may take."""
PAIRS_A_SECOND = 200_000
"""Pairs of elements that a slow machine looks at."""
FEW_LABELS = 20000
"""Labels left in blocks from which on they are looked at one by one."""
SINGLED = 0.5
"""Share of the pairs of two blocks' labels that are near, at most, when blocks are small enough to be frustrated."""


def first_blocks(labels: Labels, watch: Watch) -> Blocks:
    """A few blocks of every variable, or the labels one by one where there are few."""
    blocks = whole(labels)
    if affordable_at_once(labels, watch):
        return singled(labels, blocks)[0]
    for _ in range(3):
        blocks, _parent = halve(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
    return blocks


def affordable_at_once(labels: Labels, watch: Watch) -> bool:
    """Whether labels are few, and all pairs of elements can be looked at within the limits, should every two of
    different variables be near."""
    if len(labels.label) > ONE_BY_ONE:
        return False
    owners = np.concatenate([np.empty(0, dtype=np.int64), *(each.owner for each in labels.pool.bodies)])
    elements = np.bincount(labels.pool.variable[owners])
    pairs = int(elements.sum() ** 2 - np.square(elements).sum()) // 2
    in_time = pairs <= FIRST_LOOK * min(watch.work_left, PAIRS_A_SECOND * watch.seconds_left)
    return in_time and planned_for_pairs(pairs) <= watch.settings.memory_limit


def split(labels: Labels, residual: Residual, share: float, watch: Watch) -> tuple[Blocks, Indices] | None:
    """Smaller blocks without the labels that bounds rule out, and the residual's block that each is part of.

    Blocks are halved where that can raise the bound, within `share` of the way to the cut-off; a few frustrated ones
    become single labels.  None, with a note, when the tables of either would not fit into the memory allowed.
    """
    alive = residual.alive(watch.cut)
    rest = thinned(labels, residual.blocks, watch.cut - residual.room)
    if few_labels(labels, residual, watch):
        blocks, parent = singled(labels, rest)
    else:
        chosen = _affordable(residual, alive, share, watch)
        if chosen is None:
            needed = planned(residual, alive.astype(np.int64))
            watch.note("memory limit", blocks=len(rest.variable), mebibytes=needed)
            return None
        blocks, parent = halve(labels, rest, chosen)
    return blocks, np.flatnonzero(alive)[parent]


def few_labels(labels: Labels, residual: Residual, watch: Watch) -> bool:
    """Whether what blocks hold is frustrated, and little enough to be looked at label by label."""
    if residual.exact or not residual.frustrated(watch.cut):
        return False
    left = member_slack(labels, residual.blocks, watch.cut - residual.room) >= 0
    sizes = np.add.reduceat(left, residual.blocks.start[:-1], dtype=np.int64)
    return bool(sizes.sum() <= FEW_LABELS and SINGLED * planned(residual, sizes) <= watch.settings.memory_limit)


def _affordable(residual: Residual, alive: Flags, share: float, watch: Watch) -> Flags | None:
    """The blocks to split, fewer than wished where their tables would not fit into the memory allowed; None
    when even those of the solution alone would not."""
    for wanted in (*(share / 2**halved for halved in range(6)), 0.0):
        chosen = _worth_splitting(residual, alive, watch.cut, wanted)
        parts = alive.astype(np.int64)
        parts[np.flatnonzero(alive)[chosen]] = 2
        if planned(residual, parts) <= watch.settings.memory_limit:
            return chosen
    return None


def _worth_splitting(residual: Residual, alive: Flags, cut: float, share: float) -> Flags:
    """The blocks whose splitting can raise the bound: those of the solution, and those whose room lies within
    a share of the way from the bound to the cut-off."""
    several = residual.blocks.sizes[alive] > 1
    near = residual.room <= residual.bound + share * (cut - residual.bound)
    near[residual.pool.start[:-1] + residual.chosen] = True
    near = several & near[alive]
    return near if near.any() else several
