"""Sound reduction: bound blocks of candidates, discard what no better layout uses, split."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array

from usdrigui.character import Floats, Indices
from usdrigui.model import LayoutProblem
from usdrigui.solve.budget import Budget
from usdrigui.solve.joint_labels import Joint, couples
from usdrigui.solve.label_geometry import LabelSet
from usdrigui.solve.local_search import KnownRows, LocalSearch
from usdrigui.solve.pair_costs import NearPairs, near_blocks, pair_costs, refined
from usdrigui.solve.partition import (
    block_set,
    cheapest,
    first_blocks,
    one_by_one,
    split,
)
from usdrigui.solve.reduced_problem import (
    LARGEST_TESTED,
    PlainProblem,
    ReducedProblem,
    reduced,
    undominated,
)
from usdrigui.solve.triplets import raise_bound

SWEEPS = 8
"""Of dual ascent before their improvement is measured."""
FRUSTRATED = 0.7
"""Share of the distance to the cutoff that the blocks' own solution must leave before triplets are
looked for."""
NEAR = 0.02
"""Share of the way to the cutoff in which blocks are split while the bound rises well."""
SLOW = 0.1
"""Share of the labels, or of what the bound misses, that a step must take for another to pay."""
SMALL = 500
"""Labels and pairs that cost anything, of which HiGHS closes nearly all at its root, sooner than
bounds."""
FEWER = 0.75
"""Of the labels of the last local search are left when the next one looks for a better layout."""
TRIES = 20
"""Of local search per variable where all pair costs are at hand: thousands take a second."""


class Reduction:
    """Blocks of labels, and what is left of the problem that they bound from below: what a layout
    below `budget.cutoff` may use.

    It shrinks in place: what goes must free its memory at once.
    """

    def __init__(
        self,
        problem: LayoutProblem,
        labels: LabelSet,
        near: list[NearPairs] | None,
        budget: Budget,
        incumbent: LocalSearch,
    ) -> None:
        """`near` are all pairs of labels that may interact, where they are few.  `incumbent` holds
        the best layout known of these labels; it is improved on the way."""
        self._whole, self._labels, self._budget = problem, labels, budget
        self._incumbent = incumbent
        self.blocks = first_blocks(labels, budget) if near is None else one_by_one(labels)
        self.block_set = block_set(labels, self.blocks)
        self._near = near or near_blocks(problem, self.block_set, budget) or []
        self.pairs = pair_costs(problem, self.block_set, self._near)
        """Pair costs of the problem's labels, without messages."""
        self.linear = self.block_set.cost
        """What they cost alone."""
        self._joined: Indices | None = None
        """(labels, variables) the blocks that joint labels stand for, -1 for other variables."""
        numbers, cost = np.arange(len(self.block_set.cost)), self.block_set.cost.copy()
        self.problem = ReducedProblem(self.block_set.variable, numbers, cost, self.pairs)
        """Its labels are blocks."""

    @property
    def exact(self) -> bool:
        """Whether every block is a single label."""
        return bool(self.blocks.sizes.max(initial=1) == 1)

    def representatives(self, chosen: Indices) -> Indices:
        """(variables,) the labels of least linear cost of the blocks that a solution chooses."""
        blocks = self._members()[chosen].max(axis=0)
        return np.asarray(cheapest(self._labels, self.blocks)[blocks])

    def _members(self) -> Indices:
        """(labels, variables) the block of every variable that a label stands for, or -1."""
        left = self.problem
        if self._joined is not None:
            return self._joined[left.labels]
        found = np.full((len(left.labels), left.count), -1)
        found[np.arange(len(left.labels)), left.owner] = left.labels
        return found

    def plain(self) -> PlainProblem:
        """What is left with the problem's own costs, and the pairs that bounds exclude."""
        left = self.problem
        pairs = np.where(np.isinf(left.both_ways()), np.inf, self._all_pairs())
        return PlainProblem(left.start, self.linear[left.labels], pairs)

    def small(self) -> bool:
        """Whether what is left is a program that HiGHS closes at once."""
        pairs = SMALL - len(self.problem.costs)
        return pairs >= 0 and self.plain().costly_pairs() <= pairs

    def _all_pairs(self) -> Floats:
        """(n, n) the problem's own pair costs, the same both ways."""
        pairs = self.pairs.toarray()
        return np.asarray(pairs + pairs.T)

    def figures(self) -> dict[str, int]:
        """How much is left, for the report."""
        excluded = sum(int(np.isinf(each.costs).sum()) for each in self.problem.tables)
        members = np.unique(self._members())
        return {
            "blocks": len(self.problem.labels),
            "labels": int(self.blocks.sizes[members[members >= 0]].sum()),
            "excluded_pairs": excluded,
            "triplets": len(self.problem.messages),
        }

    def done(self) -> bool:
        """Sweep, tighten, split, until all blocks are single labels or a limit is reached: then
        blocks of several may be left; whether anything is."""
        budget, share = self._budget, NEAR
        while self._swept() and (not self.exact or self._thinned()):
            frustrated = self._frustrated()
            if self.exact or budget.over():
                return True
            if frustrated and not self.tightened():
                return False
            bound = self.problem.bound()
            if not self._split(share):
                if not self.tightened():
                    return False
                if self.problem.bound() <= bound:
                    budget.reach("memory limit")
                    return True
            slow = self.problem.bound() - bound <= SLOW * (budget.cutoff - bound)
            share = min(1.0, 2.0 * share) if slow else NEAR
        return False

    # --- local search -----------------------------------------------------------------------------

    def _frustrated(self) -> bool:
        """Look for a good layout of the blocks; whether it is far above the bound."""
        left = self.problem
        first = np.array([each.start + int(left.costs[each].argmin()) for each in left.slices])
        linear, penalty = self.linear[left.labels], self._incumbent.penalty
        found = LocalSearch(left.start, linear, KnownRows(self.pairs), self._budget, penalty)
        found.improve_from(first)
        if self.exact:
            found.search(TRIES)
        self._incumbent.improve_from(self.representatives(found.chosen))
        return found.cost - left.bound() > FRUSTRATED * (self._budget.cutoff - left.bound())

    # --- bounds -----------------------------------------------------------------------------------

    def _lower_bounds(self) -> Floats:
        """(blocks,) no layout that uses a block costs less."""
        found = np.full(len(self.block_set.cost), np.inf)
        found[self.problem.labels] = self.problem.label_lower_bounds()
        return found

    def _swept(self) -> bool:
        """Raise the bound by dual ascent and take away what it excludes; whether any are left."""
        self.problem.normalize()
        left = self._reduced()
        while left and not self._budget.stopped():
            before = len(self.problem.costs)
            for _ in range(SWEEPS):
                self.problem.sweep()
                self.problem.normalize()
            self._budget.spend(1000 + SWEEPS * self.problem.entries // 32)
            left = self._reduced()
            if len(self.problem.costs) > (1.0 - SLOW) * before:
                break
        return left

    def _reduced(self) -> bool:
        """Take the blocks away that no layout below the cutoff uses; whether any are left."""
        left = reduced(self.problem, self._budget.cutoff)
        if left is None:
            self._budget.found("blocks", bound=self._budget.cutoff)
            return False
        self._budget.found("blocks", bound=min(left.bound(), self._budget.cutoff))
        self._keep(left)
        return True

    def _keep(self, left: ReducedProblem) -> None:
        """Go on with less of the problem."""
        if len(left.labels) < self.pairs.shape[0]:
            kept = np.searchsorted(self.problem.labels, left.labels)
            self.pairs = self.pairs[kept][:, kept]
        self.problem = left

    def _thinned(self) -> bool:
        """Take single labels away that others dominate, of which bounds then exclude more, in turn,
        until the rest is small; whether any are left."""
        while not self._budget.stopped() and not self.small():
            before = len(self.problem.costs)
            self._take_dominated()
            if not (self._swept() and self._excluded()):
                return False
            if len(self.problem.costs) > (1.0 - SLOW) * before:
                break
        return True

    def _take_dominated(self) -> None:
        """Take the labels away that another one can always replace."""
        left = self.problem
        if len(left.costs) > LARGEST_TESTED:
            return
        self._budget.spend(len(left.costs) * int(np.square(np.diff(left.start)).sum()) // 64)
        linear = self.linear[left.labels]
        alive = undominated(left.start, linear, self._all_pairs(), np.isinf(left.both_ways()))
        self._keep(left.restricted(alive))

    def _excluded(self) -> bool:
        """Exclude pairs by tests of pairs, and then labels; whether any are left."""
        if len(self.problem.costs) > LARGEST_TESTED:
            return True
        sizes = np.diff(self.problem.start)
        # Of each pair, the labels of the variables that both are linked to are gone through.
        self._budget.spend(int(sizes @ np.square(self.problem.linked @ sizes)) // 1024)
        self.problem.exclude_pairs(self._budget.cutoff)
        return self._reduced()

    def tightened(self) -> bool:
        """Raise the bound by triplets and take away what it excludes: of many labels until tests of
        pairs and joining gain more, else as long as it gains more than a share of what the bound
        misses; whether any are left."""
        searched = len(self.problem.costs)
        many = self.exact and searched > LARGEST_TESTED
        while not self._budget.stopped():
            before, bound = len(self.problem.costs), self.problem.bound()
            raise_bound(self.problem, self._budget)
            if not (self._reduced() and self._excluded()):
                return False
            now, labels = self.problem.bound(), len(self.problem.costs)
            if labels > LARGEST_TESTED:
                self._budget.lower_aim()
            elif many:
                return self._thinned()
            few_gone = labels > (1.0 - SLOW) * before
            if labels <= FEWER * searched or (self.exact and few_gone and not many):
                searched = labels
                self._frustrated()  # Of fewer labels a better layout is found, which excludes more.
            missed = self._budget.cost - now
            if now - bound <= (SLOW * missed if few_gone and not many else 0.0):
                break
        return True

    def joined(self) -> bool:
        """Join variables and take away what bounds then exclude; whether there are any to join."""
        left = self.problem
        found = couples(left) if len(left.costs) <= LARGEST_TESTED else []
        if found:
            joint, pairs = Joint(left, found), self._all_pairs()
            self._budget.spend(len(joint.owner) ** 2 // 32)
            self.linear = joint.alone(self.linear[left.labels], pairs)
            self.pairs = csr_array(np.triu(joint.together(pairs)))
            self._joined = joint.members(self._members())
            self.problem = joint.problem
            if self._swept():
                self._thinned()
        return bool(found)

    def _split(self, share: float) -> bool:
        """Split blocks and go on from the messages of their parents; whether memory allows it."""
        bounds = self._lower_bounds()
        parts = split(self._labels, self.blocks, self._near, bounds, share, self._budget)
        if parts is None:
            return False
        older, (blocks, parent) = self.block_set, parts
        same = (blocks.sizes > 1) | (self.blocks.sizes[parent] == 1)
        self.blocks, self.block_set = blocks, block_set(self._labels, blocks)
        self._near = refined(self._whole, self.block_set, self._near, parent, same, self._budget)
        pairs = pair_costs(self._whole, self.block_set, self._near)
        place = np.searchsorted(self.problem.labels, parent)
        more = self.block_set.cost - older.cost[parent]
        self.problem = self.problem.refined(place, more, self.pairs, pairs)
        self.pairs, self.linear = pairs, self.block_set.cost
        return True
