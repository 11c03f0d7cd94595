"""Which blocks there are at first, which are split, and into what: halves, or all their labels."""

from __future__ import annotations

import numpy as np

from usdrigui.model import Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import (
    Blocks,
    Labels,
    halve,
    member_slack,
    singled,
    thinned,
    whole,
)
from usdrigui.solve.pair_costs import NearPairs

ONE_BY_ONE = 2500
"""Labels up to which a problem is not cut into blocks at all."""
FIRST_LOOK = 0.25
"""Share of the work and time left that the first look at all of those may take."""
PAIRS_A_SECOND = 200_000
"""Pairs of elements that a slow machine looks at."""
BYTES_PER_PAIR = 250
"""Of a near pair of blocks: itself, and in keys while those of two rounds are held."""
BYTES_PER_ENTRY = 20
"""Of a table: its cost before and after labels go, and what is worked out of a part of it."""


def first_blocks(labels: Labels, budget: Budget) -> Blocks:
    """A few blocks of every variable, or the labels one by one where there are few."""
    blocks = whole(labels)
    if affordable_at_once(labels, budget):
        return singled(labels, blocks)[0]
    for _ in range(3):
        finer, _parent = halve(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
        if planned(len(finer.variable) ** 2 // 2, 0) > budget.settings.memory_limit:
            return blocks
        blocks = finer
    return blocks


def affordable_at_once(labels: Labels, budget: Budget) -> bool:
    """Whether labels are few, and all pairs of elements can be looked at within the limits, should
    every two of different variables be near."""
    if len(labels.label) > ONE_BY_ONE:
        return False
    owners = np.concatenate(
        [np.empty(0, dtype=np.int64), *(each.owner for each in labels.label_set.geometries)]
    )
    elements = np.bincount(labels.label_set.variable[owners])
    pairs = int(elements.sum() ** 2 - np.square(elements).sum()) // 2
    in_time = pairs <= FIRST_LOOK * min(budget.work_left, PAIRS_A_SECOND * budget.seconds_left)
    return in_time and planned(len(labels.label) ** 2 // 2, pairs) <= budget.settings.memory_limit


def planned(entries: int, pairs: int) -> float:
    """MiB needed for tables of so many entries and so many near pairs of elements."""
    return (BYTES_PER_ENTRY * entries + BYTES_PER_PAIR * pairs) / 2**20


def split(
    labels: Labels,
    blocks: Blocks,
    near: list[NearPairs],
    room: Floats,
    bound: float,
    share: float,
    budget: Budget,
) -> tuple[Blocks, Indices] | None:
    """Smaller blocks without the labels that bounds rule out, and the block that each is part of.

    `room` (blocks,) is the least cost of layouts that use a block, `bound` that of all.  Blocks are
    halved within `share` of the way from the bound to the cutoff; `share` 0 asks for all labels one
    by one, if they are few enough. None, with a note, when neither fits into the memory allowed.
    """
    slack = budget.cutoff - room
    alive = room <= budget.cutoff
    rest = thinned(labels, blocks, slack)
    left = np.add.reduceat(
        member_slack(labels, blocks, slack) >= 0, blocks.start[:-1], dtype=np.int64
    )
    if share == 0 and _planned(near, blocks.variable, left) <= budget.settings.memory_limit:
        finer, parent = singled(labels, rest)
        return finer, np.flatnonzero(alive)[parent]
    several = rest.sizes > 1
    for wanted in ((share or 1.0) / 2**halved for halved in range(8)):
        chosen = several & (room[alive] <= bound + wanted * (budget.cutoff - bound))
        chosen = chosen if chosen.any() else several
        parts = alive.astype(np.int64)
        parts[np.flatnonzero(alive)[chosen]] = 2
        if _planned(near, blocks.variable, parts) <= budget.settings.memory_limit:
            finer, parent = halve(labels, rest, chosen)
            return finer, np.flatnonzero(alive)[parent]
    budget.reach("memory limit")
    return None


def _planned(near: list[NearPairs], variable: Indices, parts: Indices) -> float:
    """MiB needed when every block is replaced by so many parts; `variable` (blocks,) they are
    of."""
    pairs = sum(int((parts[each.first] * parts[each.second]).sum()) for each in near)
    sizes = np.bincount(variable, weights=parts).astype(np.int64)
    used = np.zeros((len(sizes), len(sizes)), dtype=bool)
    for each in near:
        used[variable[each.first], variable[each.second]] = True
    return planned(int(np.outer(sizes, sizes)[used].sum()), pairs)
