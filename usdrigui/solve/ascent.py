"""Ascent of the smoothed dual over the entries in play, with prices on cells.

The bound over multipliers and prices is concave but has corners; replacing every least value by a soft one,
-eps log sum exp(-x / eps), makes it smooth (Y. Nesterov 2005; for such problems B. Savchynskyy et al., "Efficient
MRF energy minimization via adaptive diminishing smoothing", 2012), and its derivatives are marginals: how much of
every entry, and of every pair, the relaxation chooses.  Those tell which cells are crowded and how to change their
prices.  All of this only proposes, in single precision: `usdrigui.solve.bounds` works the bound out afresh from what
is proposed.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from usdrigui.model import Flags, Floats, Indices, Singles
from usdrigui.solve.bounds import Dual
from usdrigui.solve.cells import Cells, Costs, flags
from usdrigui.solve.held_pairs import HeldPairs

STEP = 8.0
"""First step of a price, in Newton steps."""
GROWTH, DECAY = 1.3, 0.4
"""Of a price's step while its slope keeps its sign, and when that changes."""
STEPS = (0.1, 300.0)
"""Least and largest step."""


class Ascent:
    """Multipliers of all entries of a pool and prices of cells, improved over the few entries in play."""

    def __init__(self, costs: Costs, dual: Dual, cells: Cells, dear: float) -> None:
        self.costs = costs
        self._dear = dear
        """Pairs that cost more count as much: no solution of interest has them."""
        self.start = costs.pool.start
        """(variables + 1,) first entry of each variable in the pool."""
        count, size = costs.pool.count, len(costs.pool.cost)
        self.given: Singles = np.zeros((size, count), dtype=np.float32)
        """(n, variables) what the table with each variable gives to each entry of the pool."""
        self.linked: Flags = np.zeros((count, count), dtype=bool)
        for edge in dual.edges:
            self.linked[edge.ends] = self.linked[edge.ends[::-1]] = True
            for side in (0, 1):
                mine = slice(self.start[edge.ends[side]], self.start[edge.ends[side] + 1])
                self.given[mine, edge.ends[1 - side]] = edge.given[side]
        self.member: Flags = flags(cells, np.arange(size), size)
        """(cells, n) whether an entry of the pool is in a cell."""
        self.count, self.price = cells.count, cells.price
        self._step = np.full(len(self.price), STEP)
        self._slope = np.zeros(len(self.price))
        self.chosen = np.arange(0)
        self.across: Singles = np.empty((0, size), dtype=np.float32)
        self.play(self.chosen)

    # --- entries in play -----------------------------------------------------------------------------

    def play(self, chosen: Indices) -> None:
        """Work on these entries of the pool from now on (ascending), with the multipliers that they have."""
        self.across = self._across(chosen)
        """(m, n) pair costs of the entries in play against every entry of the pool, without prices."""
        self.chosen = chosen
        self.variable = self.costs.pool.variable[chosen]
        self.first = np.searchsorted(self.variable, np.arange(len(self.start)))
        """(variables + 1,) first entry in play of each variable."""
        self._mine: Singles = self.given[chosen]
        self._apply()

    def _across(self, chosen: Indices) -> Singles:
        """The pair costs of these entries; those that were in play are not worked out again."""
        known = np.isin(chosen, self.chosen, assume_unique=True)
        found = np.empty((len(chosen), len(self.costs.pool.cost)), dtype=np.float32)
        found[known] = self.across[np.searchsorted(self.chosen, chosen[known])]
        found[~known] = self._against(chosen[~known])
        return found

    def _against(self, chosen: Indices) -> Singles:
        """(m, n) pair costs of some entries (ascending) against every entry of the pool."""
        pool = self.costs.pool
        first = np.searchsorted(chosen, pool.start)
        found = np.zeros((len(chosen), len(pool.cost)), dtype=np.float32)
        for table in self.costs.tables:
            for mine, rows, other, columns, costs in (
                (table.first, table.rows, table.second, table.columns, table.costs),
                (table.second, table.columns, table.first, table.rows, table.costs.T),
            ):
                low, high = first[mine], first[mine + 1]
                if low == high:
                    continue
                wanted = chosen[low:high] - pool.start[mine]
                at = np.minimum(np.searchsorted(rows, wanted), len(rows) - 1)
                hit = np.flatnonzero(rows[at] == wanted)
                part = np.minimum(costs[at[hit]], self._dear)
                found[np.ix_(low + hit, pool.start[other] + columns)] = part
        return found

    def _apply(self) -> None:
        """Costs of the entries in play as the prices are now."""
        self._inside: list[Indices] = []
        """Of each cell, its entries in play."""
        self._held = HeldPairs(self.variable, len(self.start) - 1)
        self._enter(self.member)
        self.pairs: Singles = self.across.take(self.chosen, axis=1)
        """(m, m) pair costs of the entries in play, less what prices take off; changed as a flat list."""
        self._link()
        self._reduce(self.price)
        self._charge()

    def _enter(self, member: Flags) -> None:
        inside = [np.flatnonzero(each) for each in member[:, self.chosen]]
        self._inside += inside
        self._held.enter(inside)
        self._gather()

    def _gather(self) -> None:
        self._places = np.concatenate([np.empty(0, dtype=np.int64), *self._inside])
        """Entries in play of all cells, one cell after another."""
        self._owner = np.repeat(np.arange(len(self._inside)), [len(each) for each in self._inside])
        """Cell of each of those."""

    def _summed(self, values: NDArray[np.floating]) -> Floats:
        """(cells,) sums of values (m,) of the entries in play inside each cell."""
        return np.asarray(np.bincount(self._owner, values[self._places], len(self._inside)), dtype=np.float64)

    def _reduce(self, price: Floats) -> None:
        """Take prices off the pairs inside the cells."""
        less, flat = self._held.cells.T @ price.astype(np.float32), self.pairs.reshape(-1)
        flat[self._held.above] -= less
        flat[self._held.below] -= less

    def _link(self) -> None:
        """Where the entries of the variables linked to each one are."""
        self._near = []
        sizes = np.diff(self.first)
        for linked in self.linked:
            start = np.concatenate([[0], np.cumsum(sizes[linked])])
            self._near.append((np.flatnonzero(linked), np.flatnonzero(linked[self.variable]), start))

    def _charge(self) -> None:
        charged = np.bincount(self._places, (self.price * self.count)[self._owner], len(self.chosen))
        self.linear: Singles = (self.costs.linear[self.chosen] + charged).astype(np.float32)

    def settle(self) -> Floats:
        """(n,) how much dearer every entry of the pool is than the cheapest in play of its variable.

        Those out of play get multipliers that leave every table between them and entries in play as it is.
        """
        linear, costs = self.costs.linear.copy(), self.across.copy()
        for cell in np.flatnonzero(self.price > 0).tolist():
            mine, price = np.flatnonzero(self.member[cell]), self.price[cell]
            linear[mine] += price * self.count[cell]
            pairs = (self._inside[cell][:, None] * costs.shape[1] + mine).ravel()
            costs.reshape(-1)[pairs] -= np.float32(price)
        self.given[self.chosen] = self._mine
        message = np.zeros_like(self.given)
        for variable, (low, high) in enumerate(itertools.pairwise(self.start)):
            least = np.minimum.reduceat(costs[:, low:high] - self._mine[:, variable, None], self.first[:-1], axis=0)
            message[low:high, self.linked[variable]] = least[self.linked[variable]].T
        total = linear + message.sum(axis=1)
        best = np.minimum.reduceat(total[self.chosen], self.first[:-1])
        share = total / (self.linked.sum(axis=1) + 1)[self.costs.pool.variable]
        outside = np.ones(len(total), dtype=bool)
        outside[self.chosen] = False
        self.given[outside] = (message - share[:, None])[outside]
        return np.asarray(total - best[self.costs.pool.variable])

    # --- multipliers ---------------------------------------------------------------------------------

    def sweep(self, eps: float, back: bool = False) -> None:
        """Best multipliers of one variable after another, forth and back, or only back."""
        count = len(self.first) - 1
        for variable in (*(() if back else range(count)), *range(count - 1, -1, -1)):
            near, entries, start = self._near[variable]
            if not len(near):
                continue
            mine = slice(self.first[variable], self.first[variable + 1])
            reduced = self.pairs[mine].take(entries, axis=1)
            reduced -= self._mine[entries, variable]
            message = _soft_least(reduced, start, eps)
            total = self.linear[mine] + message.sum(axis=1)
            self._mine[mine, near] = message - (total / (len(near) + 1))[:, None]

    def hand_over(self, dual: Dual) -> None:
        """Give the multipliers to a dual of all entries."""
        for edge in dual.edges:
            for side in (0, 1):
                low, high = self.start[edge.ends[side]], self.start[edge.ends[side] + 1]
                given = self.given[low:high, edge.ends[1 - side]].astype(np.float64)
                dual.move(edge, side, given - edge.given[side])

    def shares(self, eps: float) -> tuple[Singles, Singles]:
        """(m,) how much of each entry in play the relaxation chooses, and (m, m) of each pair; pairs stand above
        the diagonal blocks, where they are settled after a sweep."""
        soft, share = self._entry_shares(eps)
        pairs = np.zeros_like(self.pairs)
        for variable, (low, high) in enumerate(itertools.pairwise(self.first[:-1])):
            found = self.pairs[low:high, high:] - self._mine[high:, variable]
            found -= self._mine[low:high][:, self.variable[high:]]
            np.subtract(soft[variable], found, out=found)
            np.minimum(found, 0.0, out=found)
            np.exp(found / np.float32(eps), out=found)
            apart = ~self.linked[variable][self.variable[high:]]
            found[:, apart] = share[low:high, None] * share[high:][apart]
            pairs[low:high, high:] = found
        return share, pairs

    def _entry_shares(self, eps: float) -> tuple[Singles, Singles]:
        """(variables,) soft least costs and (m,) shares of the entries in play."""
        left = self.linear + np.where(self.linked[self.variable], self._mine, np.float32(0)).sum(axis=1)
        soft = _soft_least(left[None], self.first, eps)[0]
        return soft, np.exp((soft[self.variable] - left) / np.float32(eps))

    def _held_shares(self, soft: Singles, eps: float) -> Singles:
        """(pairs,) shares of the pairs that cells hold, settled after a sweep: cells link their variables."""
        held, given = self._held, self._mine.reshape(-1)
        found = soft[held.variable] - self.pairs.reshape(-1)[held.above]
        found += given[held.multipliers[0]]
        found += given[held.multipliers[1]]
        np.minimum(found, 0.0, out=found)
        found *= np.float32(1.0 / eps)
        return np.asarray(np.exp(found, out=found))

    # --- prices --------------------------------------------------------------------------------------

    def extend(self, member: Flags, count: Sequence[float]) -> None:
        """Take more cells, at no price yet; their variables are linked."""
        self.member = np.concatenate([self.member, member])
        self.count = np.append(self.count, count)
        self.price = np.append(self.price, np.zeros(len(count)))
        self._step = np.append(self._step, np.full(len(count), STEP))
        self._slope = np.append(self._slope, np.zeros(len(count)))
        touched = np.logical_or.reduceat(member, self.start[:-1], axis=1)
        for each in touched:
            self.linked[np.ix_(each, each)] = True
        np.fill_diagonal(self.linked, False)
        self._link()
        self._enter(member)

    def drop(self, least: float) -> None:
        """Forget the cells whose price is no more than `least`; what that took off the pairs is left there."""
        kept = self.price > least
        self.member, self.count, self.price = self.member[kept], self.count[kept], self.price[kept]
        self._step, self._slope = self._step[kept], self._slope[kept]
        self._inside = list(itertools.compress(self._inside, kept))
        self._held.drop(kept)
        self._gather()
        self._charge()

    @property
    def work(self) -> int:
        """Nanoseconds or so of a sweep back and a step of prices, with its share of a search for crowded cells."""
        linked = sum(int(self.first[at + 1] - self.first[at]) * len(each) for at, (_, each, _) in enumerate(self._near))
        return 8 * linked + 11 * len(self.chosen) ** 2 + 20 * int(self._held.cells.nnz)

    def price_step(self, eps: float) -> None:
        """Raise the prices of crowded cells, lower those of others: a Newton step of each by itself, longer for
        those that keep their direction and shorter for those that turn (M. Riedmiller and H. Braun, 1993)."""
        soft, share = self._entry_shares(eps)
        mass = self._summed(share)
        both = (self._held.cells @ self._held_shares(soft, eps)).astype(np.float64)
        slope = self.count * mass - self.count * (self.count + 1) / 2 - both
        active = (self.price > 0) | (slope > 0)
        others = np.bincount(self._places[active[self._owner]], minlength=len(share))
        weighted = self._summed(share * others)
        crowd = np.maximum(weighted / np.maximum(mass, 1e-9), 1.0)
        bend = (self.count**2 * np.minimum(mass, 1.0) + both + 0.1) / eps
        turned = np.sign(slope * self._slope)
        self._step = np.clip(self._step * np.where(turned > 0, GROWTH, np.where(turned < 0, DECAY, 1.0)), *STEPS)
        self._slope = slope
        self._change(np.maximum(0.0, self.price + self._step * slope / (bend * crowd)))

    def _change(self, price: Floats) -> None:
        self._reduce(price - self.price)
        self.price = price
        self._charge()


def _soft_least(values: Singles, first: Indices, eps: float) -> Singles:
    """(rows, variables) soft least of each row over the entries of each variable."""
    least: Singles = np.minimum.reduceat(values, first[:-1], axis=1)
    weight = np.repeat(least, np.diff(first), axis=1)
    weight -= values
    weight *= np.float32(1.0 / eps)
    np.exp(weight, out=weight)
    total: Singles = np.add.reduceat(weight, first[:-1], axis=1)
    return np.asarray(least - np.log(total) * np.float32(eps), dtype=np.float32)
