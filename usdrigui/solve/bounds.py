"""Lower bounds by block-coordinate ascent on the dual of the local polytope relaxation.

The problem is a pairwise energy: linear costs u_v and tables T_vw.  Any vectors f moved between a table
and its two variables leave every solution's cost as it is,

    theta_v = u_v + sum of f_vw over the tables of v,    theta_vw[i, j] = T_vw[i, j] - f_vw[i] - f_wv[j],

and the sum of all the least entries is a lower bound, whatever f.  `sweep` improves f as sequential
tree-reweighted message passing does (V. Kolmogorov, "Convergent tree-reweighted message passing for
energy minimization", 2006, and "A new look at reweighted message passing", 2015); since the bound is
worked out afresh from f, a flaw in the ascent could weaken it but not make it wrong.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.model import Floats, Indices
from usdrigui.solve.tables import Table


class Edge:
    """A table with its multipliers f, in both directions."""

    def __init__(self, table: Table, sizes: tuple[int, int], forbidden: float) -> None:
        self.ends = (table.first, table.second)
        costs = table.costs if table.costs.max(initial=0.0) <= forbidden else np.minimum(table.costs, forbidden)
        self.costs = (costs, costs.T)
        self.used = (table.rows, table.columns)
        self.given = [np.zeros(sizes[0]), np.zeros(sizes[1])]
        self._least: float | None = None
        self.full = tuple(len(used) == size for used, size in zip(self.used, sizes, strict=True))
        self.rest = tuple(_complement(used, size) for used, size in zip(self.used, sizes, strict=True))

    def toward(self, side: int, add: Floats | None = None) -> Floats:
        """(n,) least over the other end's entries j of ``T[i, j] - f_other[j] (+ add[j])``."""
        theirs = self.given[1 - side]
        other = -theirs if add is None else add - theirs
        inside, elsewhere = other, np.inf
        if not self.full[1 - side]:
            inside, elsewhere = other[self.used[1 - side]], float(np.minimum.reduce(other[self.rest[1 - side]]))
        if not len(inside):
            return np.full(len(self.given[side]), elsewhere)
        near = np.minimum.reduce(self.costs[1 - side] + inside[:, None], axis=0)
        if elsewhere < np.inf:
            np.minimum(near, elsewhere, out=near)
        if self.full[side]:
            return np.asarray(near)
        found = np.full(len(self.given[side]), min(elsewhere, float(np.minimum.reduce(inside))))
        found[self.used[side]] = near
        return found

    def least(self) -> float:
        """Least reparametrised cost."""
        if self._least is None:
            self._least = float((self.toward(0) - self.given[0]).min())
        return self._least

    def give(self, side: int, amount: Floats) -> None:
        """Move costs from the table to one of its ends."""
        self.given[side] = self.given[side] + amount
        self._least = None

    def at(self, i: int, j: int) -> float:
        """Reparametrised cost of two entries."""
        return float(self.against(0, j)[i] - self.given[0][i] - self.given[1][j])

    def against(self, side: int, other: int) -> Floats:
        """(n,) original costs of the entries of one end against one entry of the other."""
        costs = np.zeros(len(self.given[side]))
        self.add_against(side, other, costs)
        return costs

    def add_against(self, side: int, other: int, costs: Floats) -> None:
        """Add to `costs` (n,) what the entries of one end cost against one entry of the other."""
        theirs = self.used[1 - side]
        at = int(theirs.searchsorted(other))
        if at < len(theirs) and theirs[at] == other:
            costs[self.used[side]] += self.costs[1 - side][at]

    def block(self, rows: Indices, columns: Indices) -> Floats:
        """Reparametrised costs of some entries of the first end against some of the second."""
        full = np.zeros((len(self.given[0]), len(self.given[1])))
        full[np.ix_(*self.used)] = self.costs[0]
        return np.asarray(full[np.ix_(rows, columns)] - self.given[0][rows][:, None] - self.given[1][columns])


class Dual:
    """Multipliers of all tables and the bound that they prove."""

    def __init__(
        self, unary: Sequence[Floats], tables: Sequence[Table], forbidden: float, constant: float = 0.0
    ) -> None:
        self.constant = constant
        """Part of the cost of every solution."""
        sizes = [len(each) for each in unary]
        self.unary = list(unary)
        self.theta = [each.copy() for each in unary]
        self.edges = [Edge(each, (sizes[each.first], sizes[each.second]), forbidden) for each in tables]
        self.near: list[list[tuple[Edge, int]]] = [[] for _ in unary]
        for edge in self.edges:
            for side in (0, 1):
                self.near[edge.ends[side]].append((edge, side))

    @property
    def size(self) -> int:
        """Table entries read in one pass."""
        return sum(edge.costs[0].size for edge in self.edges)

    def start_from(self, older: Dual, parents: Sequence[Indices]) -> None:
        """Take over the multipliers of a coarser problem: each entry those of its parent."""
        known = {edge.ends: edge for edge in older.edges}
        for edge in self.edges:
            if edge.ends in known:
                for side in (0, 1):
                    self.move(edge, side, known[edge.ends].given[side][parents[edge.ends[side]]])

    def sweep(self) -> None:
        """One pass over the variables and one back."""
        count = len(self.unary)
        for forward in (True, False):
            for variable in range(count) if forward else range(count - 1, -1, -1):
                self._visit(variable, forward)

    def bound(self) -> float:
        """Lower bound on the cost of every solution."""
        least = [float(theta.min(initial=np.inf)) for theta in self.theta]
        return self.constant + sum(least) + sum(edge.least() for edge in self.edges)

    def cost(self, chosen: Indices) -> float:
        """Cost of a solution."""
        total = self.constant + sum(float(each[at]) for each, at in zip(self.unary, chosen, strict=True))
        return total + sum(
            float(edge.against(0, int(chosen[edge.ends[1]]))[chosen[edge.ends[0]]]) for edge in self.edges
        )

    def parts(self, member: Indices | None = None) -> tuple[float, list[Floats]]:
        """The bound, and for every variable a lower bound on the excess over it of each of its entries.

        With `member` (groups of variables, -1 for none) the excess uses nothing that belongs to another
        group, so that what those groups gain may be added to it.
        """
        excess = [theta - theta.min(initial=np.inf) for theta in self.theta]
        stars = [each.copy() for each in excess]
        for edge in self.edges:
            least = edge.least()
            for side in (0, 1):
                mine, other = edge.ends[side], edge.ends[1 - side]
                foreign = member is not None and member[other] >= 0 and member[other] != member[mine]
                stars[mine] += edge.toward(side, None if foreign else excess[other]) - edge.given[side] - least
        return self.bound(), stars

    def inner_excess(self, group: Sequence[int]) -> list[Floats]:
        """Like the excess of `parts`, of the problem that a group of variables is by itself."""
        inside = set(group)
        excess = {each: self.theta[each] - self.theta[each].min() for each in group}
        stars = {each: excess[each].copy() for each in group}
        for variable in group:
            for edge, side in self.near[variable]:
                other = edge.ends[1 - side]
                if other in inside:
                    stars[variable] += edge.toward(side, excess[other]) - edge.given[side] - edge.least()
        return [stars[each] for each in group]

    def ahead(self, variable: int, forward: bool) -> list[tuple[Edge, int]]:
        """A variable's tables with those that a pass has yet to visit."""
        return [(edge, side) for edge, side in self.near[variable] if (edge.ends[1 - side] > variable) == forward]

    def _visit(self, variable: int, forward: bool) -> None:
        """Share a variable's reduced costs among the tables ahead and push them on to the other ends."""
        ahead = self.ahead(variable, forward)
        if not ahead:
            return
        share = self.theta[variable] / max(len(ahead), len(self.near[variable]) - len(ahead))
        for edge, side in ahead:
            self.move(edge, side, -share)
            self.move(edge, 1 - side, edge.toward(1 - side) - edge.given[1 - side])

    def move(self, edge: Edge, side: int, amount: Floats) -> None:
        """Move costs from a table to the linear costs of one of its ends."""
        edge.give(side, amount)
        self.theta[edge.ends[side]] += amount


def _complement(used: Indices, size: int) -> Indices:
    rest = np.ones(size, dtype=bool)
    rest[used] = False
    return np.flatnonzero(rest)
