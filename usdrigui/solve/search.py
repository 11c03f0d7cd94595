"""Exact search on what the bounds leave: depth first, with the dual kept warm and components apart.

A node of the search is a smaller problem of the same kind, its costs reparametrised by the multipliers
found so far.  Variables with one entry left are folded into the neighbours' linear costs; entries that the bound
rules out are dropped from the tables; what falls apart into components is solved component by component.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from usdrigui.model import Flags, Floats, Indices
from usdrigui.solve.subproblem import EPSILON, ROOT_SWEEPS, Part
from usdrigui.solve.watch import Watch

HELD_BYTES = 200_000_000
"""Matrices of a branch of the tree; below that, nodes are left open."""
HALVED = 5
"""Entries of a variable beyond which a node parts them in two instead of trying them one by one."""
PLAIN = 20_000_000
"""Entries of the matrices of a search, about half a second's work, after which compiled loops take over: to have them
takes as long."""
IN_PLAY = 0.25
"""Excess at which an entry counts 1/e where a domain is parted, in shares of what the node misses."""


@dataclass(frozen=True, eq=False)
class Found:
    """Outcome of a search below a cut-off."""

    bound: float
    """No solution of the part costs less than this."""
    cost: float
    """Of the best solution found below the cut-off; +inf if there is none."""
    chosen: dict[int, int]
    """Entry of each variable in that solution."""


class Search:
    """Depth-first branch and bound; remembers which variables made it fail."""

    def __init__(self, watch: Watch, nodes: int) -> None:
        self.nodes = 0
        self._most = nodes
        self._watch = watch
        self._read = 0
        """Entries of the matrices of all nodes so far."""
        self._held = 0
        """Bytes of the matrices of the nodes above the one at hand."""
        self._weight: dict[int, float] = {}

    def deepen(self, part: Part, cut: float, gap: float, proved: Callable[[float], None] | None = None) -> Found:
        """Like `solve`, with the cut-off raised step by step from the bound: stopped early, it has still proved
        the last step.  `gap` is an estimate of the part's optimum over its bound; every step is told to `proved`."""
        part.settle()
        for _ in range(ROOT_SWEEPS):
            part.sweep()
        bound = part.bounds()[0]
        step = max(0.25 * gap, 1e-6)
        while True:
            if proved is not None:
                proved(bound)
            limit = min(cut, bound + step)
            found = self.solve(part, limit)
            if not np.isfinite(found.cost) and found.bound < limit - 1e-9:
                return Found(max(bound, found.bound), np.inf, {})
            if np.isfinite(found.cost) or limit >= cut:
                return Found(max(bound, found.bound), found.cost, found.chosen)
            bound, step = limit - 1e-9, 1.5 * step

    def solve(self, part: Part, cut: float) -> Found:
        """Best solution of the part that costs less than `cut`; complete unless a limit is reached."""
        if not len(part.variables):
            return _only_solution(part, cut)
        return self._node(part.restricted(np.ones(len(part.costs), dtype=bool)), cut)

    def _node(self, part: Part, cut: float) -> Found:
        """As `solve`, of a part in which every variable has several entries; it is used up."""
        self.nodes += 1
        if not len(part.variables):
            return _only_solution(part, cut)
        part = self._at_hand(part)
        part.settle()
        groups = part.components()
        if len(groups) > 1:
            return self._apart(part, groups, cut)
        self._watch.spend(len(part.costs) ** 2 // 16 + 50)
        part.sweep()
        bound, excess = part.bounds()
        alive = bound + excess < cut
        if bound >= cut or not np.logical_or.reduceat(alive, part.start[:-1]).all():
            self._blame(part)
            return Found(max(bound, cut), np.inf, {})
        if self.nodes >= self._most or self._held + part.matrix.nbytes > HELD_BYTES or self._watch.stopped():
            return Found(bound, np.inf, {})
        self._held += part.matrix.nbytes
        found = self._branch(part, alive, excess, bound, cut)
        self._held -= part.matrix.nbytes
        return found

    def _at_hand(self, part: Part) -> Part:
        """The part of a node, worked on by compiled loops once the search is long: nothing but the time changes."""
        self._read += part.matrix.size
        if self._read < PLAIN:
            return part
        from usdrigui.solve.compiled import compiled_part

        return compiled_part(part)

    def _apart(self, part: Part, groups: list[Indices], cut: float) -> Found:
        """Solve components one after another, each below what the others leave."""
        pieces = sorted((part.picked(group) for group in groups), key=lambda each: len(each.costs))
        bounds = [piece.bounds()[0] for piece in pieces]
        costs, chosen = part.constant, part.taken
        for at, piece in enumerate(pieces):
            others = part.constant + sum(bounds) - bounds[at]
            found = self._node(piece, cut - others)
            bounds[at] = max(bounds[at], found.bound)
            costs += found.cost
            chosen = chosen | found.chosen
            if not np.isfinite(costs):
                break
        total = part.constant + sum(bounds)
        good = costs < cut
        return Found(min(total, cut), costs if good else np.inf, chosen if good else {})

    def _branch(self, part: Part, alive: Flags, excess: Floats, bound: float, cut: float) -> Found:
        """Try the entries of one variable, or the two halves of many entries, likeliest first."""
        best, lowest = Found(cut, np.inf, {}), np.inf
        at = self._variable(part, alive)
        low, high = part.start[at], part.start[at + 1]
        mine = low + np.flatnonzero(alive[low:high])
        for tried in _choices(mine, excess[mine], IN_PLAY * (cut - bound)):
            limit = min(cut, best.cost)
            least = bound + float(excess[tried].min())
            if least >= limit:
                lowest = min(lowest, least)
                continue
            kept = alive.copy()
            kept[low:high] = False
            kept[tried] = True
            found = self._node(part.restricted(kept), limit)
            lowest = min(lowest, found.bound)
            if found.cost < limit:
                best = found
        return Found(min(max(bound, min(lowest, best.cost)), cut), best.cost, best.chosen)

    def _variable(self, part: Part, alive: Flags) -> int:
        """Position of the variable to branch on: few entries, in many failures."""
        weight = np.array([1.0 + self._weight.get(each, 0.0) for each in part.variables.tolist()])
        sizes = np.add.reduceat(alive, part.start[:-1], dtype=np.int64)
        return int(np.argmin(sizes / weight))

    def _blame(self, part: Part) -> None:
        """Weigh the variables of a failed node, most those with least room."""
        for variable, size in zip(part.variables.tolist(), part.sizes.tolist(), strict=True):
            self._weight[variable] = self._weight.get(variable, 0.0) + 1.0 / size


def _only_solution(part: Part, cut: float) -> Found:
    """Of a part whose variables are all taken."""
    return Found(part.constant, part.constant if part.constant < cut else np.inf, part.taken)


def _choices(entries: Indices, excess: Floats, scale: float) -> list[Indices]:
    """The sets of a variable's entries that a node tries, likeliest first: one by one, or half of many.

    Blocks are numbered as they were halved, neighbours next to each other: two halves are two places.
    """
    if len(entries) <= HALVED:
        return [entries[[at]] for at in np.argsort(excess, kind="stable")]
    weight = np.cumsum(np.exp(-excess / max(scale, EPSILON)))
    middle = 1 + int(np.abs(weight[:-1] - weight[-1] / 2).argmin())
    halves = [(excess[:middle], entries[:middle]), (excess[middle:], entries[middle:])]
    return [each for _, each in sorted(halves, key=lambda half: float(half[0].min()))]
