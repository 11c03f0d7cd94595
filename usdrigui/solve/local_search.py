"""Good layouts early: greedy insertion, coordinate descent, large-neighbourhood search.

The state keeps, for every label of the problem, what it would cost against the labels chosen now,
so that the best label of one variable is one pass over its candidates.  Everything is drawn from a
seeded generator and counted in work, so the same problem gives the same layout.
"""

from __future__ import annotations

from collections import OrderedDict, deque
from collections.abc import Iterable

import numpy as np

from usdrigui.model import Floats, Indices, LayoutProblem
from usdrigui.solve.assignment import allowed_below
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import ALL, Labels, LabelSet, close_bounds, squared

STEP = "local search"
SAME = 1e-9
"""Costs that differ by no more are of the same layout."""
WORSE = 0.02
"""How much worse than the best a layout may be for the search to go on from it."""
CACHE_SHARE = 0.2
"""Share of the memory allowed that may hold remembered neighbours, at 16 bytes an entry."""


class Neighbours:
    """What one label costs against every other label, remembered."""

    def __init__(self, problem: LayoutProblem, labels: Labels, budget: Budget) -> None:
        self._problem = problem
        self._labels = labels
        self._budget = budget
        self._known: OrderedDict[int, tuple[Indices, Floats]] = OrderedDict()
        self._entries = 0
        self._most = int(CACHE_SHARE * budget.settings.memory_limit * 2**20 / 16)
        overlap, separation = problem.overlap, problem.separation
        self._extents = [
            [
                one.extent(ALL, other, overlap.reach, separation)
                for other in labels.label_set.geometries
            ]
            for one in labels.label_set.geometries
        ]
        """[a][b] (n,) extents of the geometries of set a against those of set b."""
        self._top = max(overlap.reach, separation)
        self._place = [
            np.full(len(labels.label), -1, dtype=np.int64) for _ in labels.label_set.geometries
        ]
        for place, geometry in zip(self._place, labels.label_set.geometries, strict=True):
            place[geometry.owner] = np.arange(len(geometry.owner))

    def of(self, label: int) -> tuple[Indices, Floats]:
        """Labels of other variables with a pair cost against `label`, ascending, and the costs
        (+inf forbidden)."""
        if label in self._known:
            self._known.move_to_end(label)
            return self._known[label]
        found = self._evaluate(label)
        self._known[label] = found
        self._entries += len(found[0])
        while self._entries > self._most and len(self._known) > 1:
            self._entries -= len(self._known.popitem(last=False)[1][0])
        return found

    def _evaluate(self, label: int) -> tuple[Indices, Floats]:
        label_set = self._labels.label_set
        cost = np.zeros(len(label_set.cost))
        together = self._problem.together[label_set.variable[label]]
        on_face = False
        for a, one in enumerate(label_set.geometries):
            at = int(self._place[a][label])
            if at < 0:
                continue
            on_face = True
            for b, other in enumerate(label_set.geometries):
                near = self._near(a, at, b)
                near = near[together[label_set.variable[other.owner[near]]]]
                if not len(near):
                    continue
                self._budget.spend(len(near))
                piece, _ = close_bounds(
                    one,
                    np.full(len(near), at),
                    other,
                    near,
                    self._problem.overlap,
                    self._problem.separation,
                )
                cost[other.owner[near]] += piece
        if on_face:
            self._add_explicit(label, cost)
        variable = label_set.variable[label]
        cost[label_set.start[variable] : label_set.start[variable + 1]] = 0.0
        found = np.flatnonzero(cost)
        return found, cost[found]

    def _near(self, a: int, at: int, b: int) -> Indices:
        """LabelGeometry of set b that may interact with geometry `at` of set a."""
        one, other = self._labels.label_set.geometries[a], self._labels.label_set.geometries[b]
        limit = self._extents[b][a] + (self._extents[a][b][at] + self._top)
        return np.flatnonzero(squared(one.middle[:, at, None], other.middle) < np.square(limit))

    def _add_explicit(self, label: int, cost: Floats) -> None:
        label_set, candidate = self._labels.label_set, self._labels.label
        variable = int(label_set.variable[label])
        for extra in self._problem.extra:
            for mine, other, mine_labels, other_labels in (
                (extra.first, extra.second, extra.first_labels, extra.second_labels),
                (extra.second, extra.first, extra.second_labels, extra.first_labels),
            ):
                if mine != variable:
                    continue
                hit = mine_labels == candidate[label]
                low = label_set.start[other]
                at = np.searchsorted(candidate[low : self._face_end(other)], other_labels[hit])
                at = np.minimum(at, self._face_end(other) - low - 1)
                if not len(at):
                    continue
                same = (at >= 0) & (candidate[low + at] == other_labels[hit])
                cost[low + at[same]] += extra.costs[hit][same]

    def _face_end(self, variable: int) -> int:
        """One past the variable's last label on the face; the board comes last."""
        end = int(self._labels.label_set.start[variable + 1])
        low = int(self._labels.label_set.start[variable])
        return end - 1 if end > low and self._labels.label[end - 1] < 0 else end


class State:
    """One label per variable (or -1: none yet) and every label's cost against the others chosen."""

    def __init__(self, labels: Labels, neighbours: Neighbours, forbidden: float) -> None:
        self.label_set: LabelSet = labels.label_set
        self.chosen = np.full(self.label_set.count, -1, dtype=np.int64)
        self._neighbours = neighbours
        self._price = forbidden
        self._pair = np.zeros(len(self.label_set.cost))

    def place(self, variable: int, label: int) -> None:
        """Choose a label (label_set index), or none with -1."""
        old = int(self.chosen[variable])
        if old == label:
            return
        if old >= 0:
            at, cost = self._neighbours.of(old)
            self._pair[at] -= np.minimum(cost, self._price)
        if label >= 0:
            at, cost = self._neighbours.of(label)
            self._pair[at] += np.minimum(cost, self._price)
        self.chosen[variable] = label

    def best(self, variable: int) -> tuple[int, float]:
        """Cheapest label of a variable against the others as they are, and its cost."""
        part = slice(self.label_set.start[variable], self.label_set.start[variable + 1])
        cost = self.label_set.cost[part] + self._pair[part]
        at = int(cost.argmin())
        return int(part.start) + at, float(cost[at])

    def cost_of(self, variable: int) -> float:
        """What the variable's present label costs against the others; +inf without one."""
        label = int(self.chosen[variable])
        return float(self.label_set.cost[label] + self._pair[label]) if label >= 0 else np.inf

    def total(self) -> float:
        """Cost of the layout, with a finite price on forbidden pairs; +inf while a variable has no
        label."""
        if (self.chosen < 0).any():
            return np.inf
        return float(self.label_set.cost[self.chosen].sum() + 0.5 * self._pair[self.chosen].sum())

    def set(self, chosen: Indices) -> None:
        """Choose a whole layout."""
        for variable in range(len(chosen)):
            self.place(variable, int(chosen[variable]))

    def refresh(self) -> None:
        """Work the pair costs out anew: what was added and taken off again leaves its rounding
        behind."""
        self._pair[:] = 0.0
        for label in self.chosen[self.chosen >= 0]:
            at, cost = self._neighbours.of(int(label))
            self._pair[at] += np.minimum(cost, self._price)

    def touching(self, variable: int) -> list[int]:
        """Variables whose present labels have a pair cost against the variable's present label."""
        at, _ = self._neighbours.of(int(self.chosen[variable]))
        spot = np.minimum(np.searchsorted(at, self.chosen), max(len(at) - 1, 0))
        hit = at[spot] == self.chosen if len(at) else np.zeros(len(self.chosen), dtype=bool)
        return [int(each) for each in np.flatnonzero(hit)]

    def rivals(self, variable: int) -> list[int]:
        """Variables whose present labels have a pair cost against some label of the variable worth
        having."""
        part = slice(self.label_set.start[variable], self.label_set.start[variable + 1])
        mine = self.label_set.cost[part]
        near = {*self.touching(variable)}
        for label in part.start + np.argsort(mine, kind="stable")[:1]:
            at, _ = self._neighbours.of(int(label))
            if len(at):
                spot = np.minimum(np.searchsorted(at, self.chosen), len(at) - 1)
                near.update(int(each) for each in np.flatnonzero(at[spot] == self.chosen))
        return sorted(near)

    def regret(self) -> Floats:
        """(count,) how much more each variable pays than its cheapest label would alone."""
        label_set = self.label_set
        least = np.minimum.reduceat(label_set.cost, label_set.start[:-1])
        return np.maximum(label_set.cost[self.chosen] + self._pair[self.chosen] - least, 0.0)


class Incumbent:
    """The best layout so far, and the ways to a better one."""

    def __init__(
        self, problem: LayoutProblem, labels: Labels, forbidden: float, budget: Budget
    ) -> None:
        self.neighbours = Neighbours(problem, labels, budget)
        self.state = State(labels, self.neighbours, forbidden)
        self.chosen = self.state.chosen.copy()
        self.cost = np.inf
        self._forbidden = forbidden
        self._budget = budget
        self._generator = np.random.default_rng(budget.settings.seed)
        self._tried: set[bytes] = set()

    def construct(self) -> None:
        """A first layout: the variables in order of what their best labels cost, then descent."""
        count = self.state.label_set.count
        insert(
            self.state,
            np.argsort([self.state.best(each)[1] for each in range(count)], kind="stable"),
        )
        self._settle(range(count))

    def start_from(self, chosen: Indices) -> None:
        """A first layout: a given one, then descent."""
        self.state.set(chosen)
        self._settle(range(len(chosen)))

    def improve_from(self, chosen: Indices) -> Indices:
        """Descend from a given layout, unless it was tried before; the best layout so far."""
        key = chosen.tobytes()
        if key not in self._tried:
            self._tried.add(key)
            self.state.set(chosen)
            self._settle(range(len(chosen)))
        return self.chosen

    def search(self, tries: int) -> None:
        """Large-neighbourhood search: take a few rivals out, put them back in another order,
        descend."""
        self.state.set(self.chosen)
        for attempt in range(tries):
            if attempt % 8 == 0 and (self._budget.stopped() or self._budget.closed()):
                return
            group = _group(self.state, self._generator)
            for variable in group:
                self.state.place(variable, -1)
            insert(self.state, self._generator.permutation(group))
            if self._settle(group) > self.cost + WORSE:
                self.state.set(self.chosen)

    def _settle(self, variables: Iterable[int]) -> float:
        """Descend, and remember the layout if it is the best so far; its cost."""
        descend(self.state, variables, self._budget)
        cost = self.state.total()
        if cost < self.cost - SAME:
            self.state.refresh()
            cost = self.state.total()
        if cost < self.cost - SAME:
            self.chosen, self.cost = self.state.chosen.copy(), cost
            self._budget.found(STEP, _cost(self.state, self._forbidden))
        return cost


def _cost(state: State, forbidden: float) -> float:
    """The total, or +inf when it must contain a forbidden pair."""
    total = state.total()
    least = float(np.minimum.reduceat(state.label_set.cost, state.label_set.start[:-1]).sum())
    return total if total < allowed_below(least, forbidden) else np.inf


def insert(state: State, order: Iterable[int]) -> None:
    """Give the variables, in order, their cheapest labels."""
    for variable in order:
        state.place(int(variable), state.best(int(variable))[0])


def descend(state: State, variables: Iterable[int], budget: Budget) -> None:
    """Move one variable at a time to its cheapest label until none of those touched gains."""
    queue = deque(int(each) for each in variables)
    for _ in range(50 * len(queue)):
        if not queue:
            return
        variable = queue.popleft()
        label, cost = state.best(variable)
        budget.spend(
            1 + int(state.label_set.start[variable + 1] - state.label_set.start[variable]) // 64
        )
        if cost < state.cost_of(variable) - SAME:
            before = state.touching(variable)
            state.place(variable, label)
            queue.extend(each for each in {*before, *state.touching(variable)} if each not in queue)


def _group(state: State, generator: np.random.Generator) -> list[int]:
    """Variables to take out together: one that pays much, and others that stand or want to stand
    near it."""
    regret = state.regret() + 1e-3
    seed = int(generator.choice(len(regret), p=regret / regret.sum()))
    wanted = int(generator.integers(2, 9))
    rivals = [each for each in state.rivals(seed) if each != seed]
    if len(rivals) > wanted:
        rivals = [int(each) for each in generator.choice(rivals, wanted, replace=False)]
    return [seed, *rivals]
