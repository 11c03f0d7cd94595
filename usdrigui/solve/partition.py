"""Blocks of neighbouring labels: the first ones, which are split, and what is left of them."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.model import LayoutProblem
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import SEVERAL, LabelSet, bounding
from usdrigui.solve.pair_costs import NearPairs, near_blocks

ONE_BY_ONE = 6000
"""Labels up to which a problem is not cut into blocks at all."""
BYTES_PER_NEAR = 64
"""Of a pair of labels that is looked at, while it is held alone."""
BYTES_PER_PAIR = 250
"""Of a near pair of blocks: itself, and in keys while those of two rounds are held."""
BYTES_PER_ENTRY = 20
"""Of a table: its cost before and after labels go, and what is worked out of a part of it."""


class Blocks(Record):
    """A partition of some labels into blocks."""

    members: Indices
    """(n,) labels, those of one block next to each other."""
    start: Indices
    """(blocks + 1,) first member of each block."""
    variable: Indices
    """(blocks,) ascending."""

    @property
    def sizes(self) -> Indices:
        """(blocks,) number of members."""
        return np.diff(self.start)


def first_blocks(labels: LabelSet, budget: Budget) -> Blocks:
    """A few blocks of every variable."""
    blocks = blocks_of_variables(labels)
    for _ in range(3):
        finer, _parent = bisect(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
        if planned(len(finer.variable) ** 2 // 2, 0) > budget.settings.memory_limit:
            return blocks
        blocks = finer
    return blocks


def one_by_one(labels: LabelSet) -> Blocks:
    """Every label as a block of its own."""
    count = len(labels.cost)
    return Blocks(np.arange(count), np.arange(count + 1), labels.variable)


def near_one_by_one(
    problem: LayoutProblem, labels: LabelSet, budget: Budget
) -> list[NearPairs] | None:
    """All pairs of labels that may interact, where these are few enough for half of the memory and
    a quarter of the work that is left; else None."""
    memory = budget.settings.memory_limit / 2
    if len(labels.cost) > ONE_BY_ONE or planned(len(labels.cost) ** 2 // 2, 0) > memory:
        return None
    most = min(budget.work_left / 4, memory * 2**20 / BYTES_PER_NEAR)
    return near_blocks(problem, labels, budget, most)


def planned(entries: int, pairs: int) -> float:
    """MiB needed for tables of so many entries and so many near pairs of elements."""
    return (BYTES_PER_ENTRY * entries + BYTES_PER_PAIR * pairs) / 2**20


def blocks_of_variables(labels: LabelSet) -> Blocks:
    """One block per variable, with the board as a block of its own."""
    first = (np.diff(labels.variable, prepend=-1) > 0) | (labels.candidate < 0)
    start = np.append(np.flatnonzero(first), len(first))
    return Blocks(np.arange(len(first)), start, labels.variable[start[:-1]])


def bisect(labels: LabelSet, blocks: Blocks, chosen: Flags) -> tuple[Blocks, Indices]:
    """Cut the chosen blocks of more than one member in two where they are widest.

    Returns the new blocks and, for each, the block it came from.
    """
    cut = chosen & (blocks.sizes > 1)
    group = np.repeat(np.arange(len(cut)), blocks.sizes)
    order = np.lexsort((blocks.members, _along_widest(labels, blocks, cut), group))
    half = blocks.start[:-1] + (blocks.sizes + 1) // 2
    start = np.sort(np.concatenate([blocks.start, half[cut]]))
    parent = group[start[:-1]]
    return Blocks(blocks.members[order], start, blocks.variable[parent]), parent


def _along_widest(labels: LabelSet, blocks: Blocks, cut: Flags) -> Floats:
    """(members,) coordinate of the first copy along the widest direction of each block to cut."""
    key = np.zeros(len(blocks.members))
    group = np.repeat(np.arange(len(cut)), blocks.sizes)
    for geometry in reversed(labels.geometries):
        place = geometry.places(len(labels.cost))[blocks.members]
        chosen = (place >= 0) & cut[group]
        first = np.flatnonzero(np.diff(group[chosen], prepend=-1))
        if len(first):
            values = geometry.samples[:, :, place[chosen]]
            values = values.reshape(-1, values.shape[-1])
            width = np.maximum.reduceat(values, first, axis=-1)
            width -= np.minimum.reduceat(values, first, axis=-1)
            axis = np.repeat(width.argmax(axis=0), np.diff(np.append(first, values.shape[-1])))
            key[chosen] = values[axis, np.arange(len(axis))]
    return key


def block_set(labels: LabelSet, blocks: Blocks) -> LabelSet:
    """The blocks as labels: their costs and bounding geometry."""
    first, group = blocks.start[:-1], np.repeat(np.arange(len(blocks.variable)), blocks.sizes)
    geometries = [
        bounding(each, each.places(len(labels.cost))[blocks.members], group)
        for each in labels.geometries
    ]
    candidate = np.where(blocks.sizes == 1, labels.candidate[blocks.members[first]], SEVERAL)
    cost = np.minimum.reduceat(labels.cost[blocks.members], first)
    return LabelSet(labels.variables, blocks.variable, candidate, cost, tuple(geometries))


def cheapest(labels: LabelSet, blocks: Blocks) -> Indices:
    """(blocks,) the member of least linear cost of each block."""
    group = np.repeat(np.arange(len(blocks.variable)), blocks.sizes)
    order = np.lexsort((blocks.members, labels.cost[blocks.members], group))
    return blocks.members[order[blocks.start[:-1]]]


def thinned(labels: LabelSet, blocks: Blocks, slack: Floats) -> Blocks:
    """The blocks without the labels that cannot be in a better solution, those left empty left out.

    `slack` (blocks,) is how far the bound of solutions that use the block lies below the cutoff.
    """
    alive = member_slack(labels, blocks, slack) >= 0
    sizes = np.add.reduceat(alive, blocks.start[:-1], dtype=np.int64)
    start = np.concatenate([[0], np.cumsum(sizes[sizes > 0])])
    return Blocks(blocks.members[alive], start, blocks.variable[sizes > 0])


def member_slack(labels: LabelSet, blocks: Blocks, slack: Floats) -> Floats:
    """(members,) the slack of each member of the blocks, in their order.

    The bound of a block counts the cost of its cheapest member; solutions that use another member
    cost more by what that one costs more, all else being bounded for every member alike.
    """
    cost = labels.cost[blocks.members]
    least = np.repeat(np.minimum.reduceat(cost, blocks.start[:-1]), blocks.sizes)
    return np.asarray(np.repeat(slack, blocks.sizes) - (cost - least))


def split(
    labels: LabelSet,
    blocks: Blocks,
    near: list[NearPairs],
    lower_bounds: Floats,
    share: float,
    budget: Budget,
) -> tuple[Blocks, Indices] | None:
    """Smaller blocks without the labels that bounds rule out, and the block that each is part of.

    `lower_bounds` (blocks,) is the least cost of layouts that use a block.  Blocks are halved
    within `share` of the way from the least bound to the cutoff, or nearer the bound where the
    memory allowed is too small; None when nothing fits into it.
    """
    bound, cutoff = lower_bounds.min(), budget.cutoff
    alive = np.flatnonzero(lower_bounds <= cutoff)
    rest = thinned(labels, blocks, cutoff - lower_bounds)
    several = rest.sizes > 1
    linked = np.zeros((labels.variables, labels.variables), dtype=bool)
    for each in near:
        linked[blocks.variable[each.first], blocks.variable[each.second]] = True
    for nearer in range(8):
        chosen = several & (lower_bounds[alive] <= bound + share / 2**nearer * (cutoff - bound))
        chosen = chosen if chosen.any() else several
        parts = np.zeros(len(lower_bounds), dtype=np.int64)
        parts[alive] = 1 + chosen
        pairs = sum(int((parts[each.first] * parts[each.second]).sum()) for each in near)
        sizes = np.bincount(blocks.variable, parts, labels.variables)
        if planned(int(sizes @ linked @ sizes), pairs) <= budget.settings.memory_limit:
            finer, parent = bisect(labels, rest, chosen)
            return finer, alive[parent]
    return None
