"""Sound reduction: bound whole blocks of candidates, discard what cannot be in a better layout,
split the rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.model import Indices, LayoutProblem
from usdrigui.solve.budget import Budget
from usdrigui.solve.dominance import undominated
from usdrigui.solve.iterated_local_search import descended, iterated_local_search, label_costs
from usdrigui.solve.label_geometry import (
    Blocks,
    Labels,
    LabelSet,
    block_set,
    member_slack,
    selected,
)
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.pair_costs import NearPairs, PairCosts, near_blocks, pair_costs, refined
from usdrigui.solve.partition import ONE_BY_ONE, first_blocks, split
from usdrigui.solve.reduced_problem import LARGEST_TESTED, ReducedProblem, reduced, sparse_tables
from usdrigui.solve.triplets import raise_bound

STEP = "blocks"
"""Name of the reduction in what is told of it."""
SWEEPS = 8
"""Of dual ascent on new blocks."""
FRUSTRATED = 0.7
"""Share of the distance to the cutoff that the blocks' own solution must leave before triplets are
looked for."""
NEAR = 0.02
"""Share of the way to the cutoff in which blocks are split while the bound rises well."""
STALLED = 0.05
"""Share of the distance to the cutoff by which triplets must raise the bound to go on."""
SLOW = 0.1
"""Share of the labels, or of what the bound misses, by which a step must reduce them to be worth
another one."""


@dataclass(eq=False)
class Partition:
    """Blocks of candidates, and what is left of the problem that they bound from below.

    It shrinks in place: what goes must free its memory at once.
    """

    blocks: Blocks
    label_set: LabelSet
    near: list[NearPairs]
    problem: ReducedProblem
    """Its labels are blocks."""
    pairs: PairCosts
    """Of its labels, without messages."""

    @property
    def exact(self) -> bool:
        """Whether every block is a single label."""
        return bool(self.blocks.sizes.max(initial=1) == 1)

    def keep(self, left: ReducedProblem) -> None:
        """Go on with less of its problem."""
        if len(left.labels) < self.pairs.count:
            self.pairs = self.pairs.among(np.searchsorted(self.problem.labels, left.labels))
        self.problem = left

    def representatives(self, labels: Labels, chosen: Indices) -> Indices:
        """(variables,) for the block that a solution of the problem chooses its member of least
        linear cost."""
        found = np.empty(len(chosen), dtype=np.int64)
        for variable, at in enumerate(self.problem.labels[chosen]):
            members = self.blocks.members[self.blocks.start[at] : self.blocks.start[at + 1]]
            found[variable] = members[labels.label_set.cost[members].argmin()]
        return found


def reduce(
    problem: LayoutProblem, labels: Labels, budget: Budget, incumbent: Incumbent
) -> Partition | None:
    """What bounds leave of a problem: labels, and pairs of them, that a layout below
    `budget.cutoff` may use.

    None when nothing is left.  At a limit blocks of several labels may be left.  `incumbent` holds
    the best layout known of these labels; it is improved on the way.
    """
    found = _bounded(problem, labels, first_blocks(labels, budget), budget)
    share, searched = NEAR, False
    while _swept(found, budget) and (not found.exact or _thinned(found, budget)):
        chosen, value = _layout(found, budget)
        incumbent.improve_from(found.representatives(labels, chosen))
        bound = found.problem.bound()
        frustrated = value - bound > FRUSTRATED * (budget.cutoff - bound)
        if frustrated and not found.exact and not searched:
            incumbent.improve_from(_likely_layout(problem, labels, found, budget))
            searched = True
        if (frustrated or found.exact) and not _tightened(found, budget):
            break
        if found.exact or budget.closed() or budget.stopped():
            return found
        bound = found.problem.bound()
        smaller = _split(problem, labels, found, share, budget)
        if smaller is None:
            return found
        found = smaller
        slow = found.problem.bound() - bound <= SLOW * (budget.cutoff - bound)
        share = min(1.0, 2.0 * share) if slow else NEAR
    budget.found(STEP, bound=budget.cutoff)
    return None


def _bounded(
    problem: LayoutProblem,
    labels: Labels,
    blocks: Blocks,
    budget: Budget,
    older: Partition | None = None,
    parent: Indices | None = None,
) -> Partition:
    """The problem of some blocks after a few sweeps of dual ascent, from the messages of the blocks
    that they are part of: `parent` (blocks,) tells which of the `older`."""
    label_set = block_set(labels, blocks)
    candidate = np.where(blocks.sizes == 1, labels.label[blocks.members[blocks.start[:-1]]], -2)
    numbers = np.arange(len(label_set.cost))
    if older is None or parent is None:
        near = near_blocks(problem, label_set, budget)
        pairs = pair_costs(problem, label_set, near, candidate)
        tables = sparse_tables(label_set.variable, pairs)
        left = ReducedProblem(label_set.variable, numbers, label_set.cost.copy(), tables)
    else:
        same = (blocks.sizes > 1) | (older.blocks.sizes[parent] == 1)
        near = refined(problem, label_set, older.near, parent, budget, same)
        pairs = pair_costs(problem, label_set, near, candidate)
        place = np.empty(len(older.label_set.cost), dtype=np.int64)
        place[older.problem.labels] = np.arange(len(older.problem.labels))
        left = older.problem.refined(
            numbers,
            place[parent],
            label_set.cost - older.label_set.cost[parent],
            older.pairs,
            pairs,
        )
    return Partition(blocks, label_set, near, left, pairs)


def _layout(partition: Partition, budget: Budget) -> tuple[Indices, float]:
    """A good layout of the partition's blocks: one of its problem's labels per variable, and what
    it costs them."""
    left = partition.problem
    costs = label_costs(left.start, partition.label_set.cost[left.labels], partition.pairs)
    first = np.array([each.start + int(left.costs[each].argmin()) for each in left.slices])
    chosen = (
        iterated_local_search(costs, first, budget) if partition.exact else descended(costs, first)
    )
    return chosen, costs.value(chosen)


def _likely_layout(
    problem: LayoutProblem, labels: Labels, partition: Partition, budget: Budget
) -> Indices:
    """(variables,) a good layout of the labels, held in blocks, that most likely are part of
    one."""
    left = partition.problem
    room = np.full(len(partition.label_set.cost), -np.inf)
    room[left.labels] = -left.label_lower_bounds()
    slack = np.full(len(labels.label), -np.inf)
    slack[partition.blocks.members] = member_slack(labels, partition.blocks, room)
    likeliest = np.lexsort((-slack, labels.label_set.variable))[labels.label_set.start[:-1]]
    slack[likeliest] = np.inf
    kept = np.sort(np.argsort(-slack, kind="stable")[: max(ONE_BY_ONE, labels.label_set.count)])
    part = selected(labels, kept)
    pairs = pair_costs(
        problem, part.label_set, near_blocks(problem, part.label_set, budget), part.label
    )
    first = np.flatnonzero(np.isin(kept, likeliest))
    costs = label_costs(part.label_set.start, part.label_set.cost, pairs)
    return kept[iterated_local_search(costs, first, budget)]


def _swept(partition: Partition, budget: Budget) -> bool:
    """Raise the bound of a partition by dual ascent and take the blocks away that it excludes;
    whether any are left."""
    partition.problem.normalize()
    left = _reduced(partition, budget)
    while left and not budget.stopped():
        before = len(partition.problem.costs)
        for _ in range(SWEEPS):
            partition.problem.sweep()
            partition.problem.normalize()
        budget.spend(1000 + SWEEPS * partition.problem.tables.entries // 32)
        left = _reduced(partition, budget)
        if len(partition.problem.costs) > (1.0 - SLOW) * before:
            break
    return left


def _reduced(partition: Partition, budget: Budget) -> bool:
    """Take the blocks away that no layout below the cutoff uses; whether any are left."""
    left = reduced(partition.problem, budget.cutoff)
    if left is None:
        return False
    budget.found(STEP, bound=min(left.bound(), budget.cutoff))
    partition.keep(left)
    return True


def _thinned(partition: Partition, budget: Budget) -> bool:
    """Take labels away that others dominate, of which bounds then exclude more, in turn, from a
    partition of single ones; whether any are left."""
    while not budget.stopped():
        before = len(partition.problem.costs)
        _take_dominated(partition, budget)
        if not (_swept(partition, budget) and _excluded(partition, budget)):
            return False
        if len(partition.problem.costs) > (1.0 - SLOW) * before:
            break
    return True


def _take_dominated(partition: Partition, budget: Budget) -> None:
    """Take the labels away that another one can always replace."""
    left = partition.problem
    if len(left.costs) > LARGEST_TESTED:
        return
    budget.spend(len(left.costs) * int(np.square(np.diff(left.start)).sum()) // 64)
    both = partition.pairs.matrix()
    both += both.T
    linear = partition.label_set.cost[left.labels]
    alive = undominated(left.start, linear, both, np.isinf(left.both_ways()))
    partition.keep(left.restricted(alive))


def _excluded(partition: Partition, budget: Budget) -> bool:
    """Exclude pairs by tests of pairs, and then labels; whether any are left."""
    if len(partition.problem.costs) > LARGEST_TESTED:
        return True
    budget.spend(len(partition.problem.costs) ** 3 // 1024)
    partition.problem.exclude_pairs(budget.cutoff)
    return _reduced(partition, budget)


def _tightened(partition: Partition, budget: Budget) -> bool:
    """Raise the bound by triplets and take away what it excludes, as long as this gains anything;
    whether any are left."""
    while True:
        before, bound = len(partition.problem.costs), partition.problem.bound()
        raise_bound(partition.problem, budget)
        if not (_reduced(partition, budget) and _excluded(partition, budget)):
            return False
        if partition.exact:
            _take_dominated(partition, budget)
        now, labels = partition.problem.bound(), len(partition.problem.costs)
        if partition.exact and labels > LARGEST_TESTED and now > bound and not budget.stopped():
            continue  # The solvers of what is left could do nothing with so many.
        few_gone = labels > (1.0 - SLOW) * before
        if budget.stopped() or (few_gone and now - bound < STALLED * (budget.cutoff - now)):
            return True


def _split(
    problem: LayoutProblem, labels: Labels, partition: Partition, share: float, budget: Budget
) -> Partition | None:
    """The partition with smaller blocks; None when there is no memory for more."""
    left = partition.problem
    room = np.full(len(partition.label_set.cost), np.inf)
    room[left.labels] = left.label_lower_bounds()
    parts = split(labels, partition.blocks, partition.near, room, left.bound(), share, budget)
    return (
        None if parts is None else _bounded(problem, labels, parts[0], budget, partition, parts[1])
    )
