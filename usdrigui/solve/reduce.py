"""Sound reduction: what no better layout uses is discarded by bounds."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array

from usdrigui.character import Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.cheap_labels import CheapLabels
from usdrigui.solve.joint_labels import Joint, couples
from usdrigui.solve.local_search import TRAPS, KnownRows, LocalSearch
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
SLOW = 0.1
"""Share of the labels, or of what the bound misses, that a step must take for another to pay."""
SMALL = 500
"""Labels and pairs that cost anything, of which HiGHS closes nearly all at its root, sooner than
bounds."""
HARD = 1 / 6
"""Of all work is done where many labels are left after it: a crowd, whose first layouts may be half
a hundredth too dear.  A long search gets as much of the work that is left, at most."""
LONG = 320
"""Tries of it per variable: with a quarter of them layouts end a thousandth dearer (decision
033)."""


class Reduction:
    """What is left of the problem of some labels: those that a layout below `budget.cutoff` may
    use.

    It shrinks in place: what goes must free its memory at once.
    """

    def __init__(self, taken: CheapLabels, budget: Budget, incumbent: LocalSearch) -> None:
        """`incumbent` holds the best layout known of these labels; it is improved on the way."""
        self._stands, self._budget, self._incumbent = taken.stands, budget, incumbent
        self.pairs = taken.least_pairs
        """Pair costs of the problem's labels, without messages."""
        self.linear = taken.labels.cost
        """What they cost alone."""
        self._joined: Indices | None = None
        """(labels, variables) what joint labels stand for, -1 for other variables."""
        numbers, cost = np.arange(len(self.linear)), self.linear.copy()
        self.problem = ReducedProblem(taken.labels.variable, numbers, cost, self.pairs)

    @property
    def exact(self) -> bool:
        """Whether every label that is left is one alone."""
        return self._joined is not None or not self._stands[self.problem.labels].any()

    def spare(self) -> Floats:
        """(n,) how far layouts that use what is left stay below the cutoff, at most."""
        return self._budget.cutoff - self.problem.label_lower_bounds()

    def representatives(self, chosen: Indices) -> Indices:
        """(variables,) the labels that a solution chooses."""
        return np.asarray(self._members()[chosen].max(axis=0))

    def _members(self) -> Indices:
        """(labels, variables) the label of every variable that one stands for, or -1."""
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
        return {
            "labels": len(self.problem.labels),
            "excluded_pairs": excluded,
            "triplets": len(self.problem.messages),
        }

    def done(self) -> bool:
        """Sweep, and where no label stands for others thin out and look for a better layout;
        whether anything is left."""
        if not self._swept() or (self.exact and not self._thinned()):
            return False
        if self.exact:
            self._search()
        return True

    # --- local search -----------------------------------------------------------------------------

    def _search(self) -> None:
        """Look for a better layout of what is left."""
        left = self.problem
        first = np.array([each.start + int(left.costs[each].argmin()) for each in left.slices])
        rows = KnownRows(self.pairs, self._incumbent.rows.penalty)
        found = LocalSearch(left.start, self.linear[left.labels], rows, self._budget)
        found.improve_from(first)
        found.search()
        self._incumbent.improve_from(self.representatives(found.chosen))

    # --- bounds -----------------------------------------------------------------------------------

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
        """Take the labels away that no layout below the cutoff uses; whether any are left."""
        left = reduced(self.problem, self._budget.cutoff)
        if left is None:
            self._budget.found("bounds", bound=self._budget.cutoff)
            return False
        self._budget.found("bounds", bound=min(left.bound(), self._budget.cutoff))
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
        misses.  The layout of a crowd is searched long, once.  Whether any are left."""
        many, long = len(self.problem.costs) > LARGEST_TESTED, False
        while not self._budget.stopped():
            before, bound = len(self.problem.costs), self.problem.bound()
            raise_bound(self.problem, self._budget)
            if not (self._reduced() and self._excluded()):
                return False
            now, labels = self.problem.bound(), len(self.problem.costs)
            if self.exact and labels > LARGEST_TESTED:
                if not long and self._budget.spent(HARD):
                    long, most = True, self._budget.work + HARD * self._budget.work_left
                    self._incumbent.search(TRAPS, most, LONG)
                self._budget.lower_aim()
            elif self.exact and many:
                return self._thinned()
            few_gone = labels > (1.0 - SLOW) * before and not many
            if self.exact and few_gone:
                self._search()  # Of fewer labels a better layout is found, which excludes more.
            if now - bound <= (SLOW * (self._budget.cost - now) if few_gone else 0.0):
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
