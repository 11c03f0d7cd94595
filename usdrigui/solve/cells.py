"""Cells: spots that many elements want, and the prices that make crowding there cost what it must.

The pairwise bound lets any number of elements share two spots, each half here and half there.  Let C be any
set of entries (of several variables) and m the number of variables that choose in it.  For every whole k

    k m - k (k + 1) / 2  <=  m (m - 1) / 2  =  number of pairs of variables that both choose in C,

because the difference is (m - k) (m - k - 1) / 2, a product of neighbouring whole numbers.  These are the
clique inequalities of the boolean quadric polytope (M. Padberg, "The boolean quadric polytope", 1989).  A
price of mu >= 0 on one of them turns the problem into another pairwise one that costs no more for any
solution, whatever C, k and mu: k mu more for each entry of C, mu less for each pair of them, and
-mu k (k + 1) / 2 for all.  So everything that bounds the priced problem bounds the original.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from usdrigui.model import Flags, Floats, Indices, Record
from usdrigui.solve.blocks import Pool
from usdrigui.solve.bounds import Dual
from usdrigui.solve.subproblem import Part
from usdrigui.solve.tables import Table

GRAIN = 2.0**-30
"""Prices are whole multiples of this."""
PAIRS = 20_000_000
"""Pairs of entries that prices may link, at most."""
BYTES_PER_PAIR = 24
"""Memory that one takes in the tables of a dual."""


@dataclass(frozen=True, eq=False)
class Cells(Record):
    """Sets of entries of a pool with their prices."""

    entries: Indices
    """(m,) members, one cell after another, ascending within a cell."""
    start: Indices
    """(cells + 1,) first member of each cell."""
    count: Floats
    """(cells,) k, a whole number >= 1."""
    price: Floats
    """(cells,) mu >= 0."""

    @property
    def owner(self) -> Indices:
        """(m,) cell of each member."""
        return np.repeat(np.arange(len(self.count)), np.diff(self.start))

    @property
    def constant(self) -> float:
        """What the prices take off the cost of every solution."""
        return -float((self.price * self.count * (self.count + 1) / 2).sum())


def no_cells() -> Cells:
    """None at all."""
    none = np.empty(0)
    return Cells(none.astype(np.int64), np.zeros(1, dtype=np.int64), none, none)


def cells_of(members: Sequence[Indices], count: ArrayLike, price: ArrayLike) -> Cells:
    """Cells from the members of each; those without a price yet get none."""
    start = np.concatenate([[0], np.cumsum([len(each) for each in members])]).astype(np.int64)
    known = np.floor(np.asarray(price, dtype=np.float64) / GRAIN) * GRAIN
    prices = np.concatenate([known, np.zeros(len(members) - len(known))])
    entries = np.concatenate([np.empty(0, dtype=np.int64), *members])
    return Cells(entries, start, np.array(count, dtype=np.float64), prices)


def members(cells: Cells) -> list[Indices]:
    """The entries of each cell."""
    return [cells.entries[a:b] for a, b in zip(cells.start[:-1], cells.start[1:], strict=True)]


def inherited(cells: Cells, parent: Indices) -> Cells:
    """The cells after entries were split or dropped; `parent` (n,) tells each new entry's old number."""
    order = np.argsort(parent, kind="stable")
    low = np.searchsorted(parent[order], cells.entries, side="left")
    high = np.searchsorted(parent[order], cells.entries, side="right")
    found = [
        np.sort(
            np.concatenate(
                [np.empty(0, dtype=np.int64), *(order[i:j] for i, j in zip(low[a:b], high[a:b], strict=True))]
            )
        )
        for a, b in zip(cells.start[:-1], cells.start[1:], strict=True)
    ]
    kept = [at for at, each in enumerate(found) if len(each) and cells.price[at] > 0]
    return bounded(cells_of([found[at] for at in kept], cells.count[kept], cells.price[kept]))


def bounded(cells: Cells) -> Cells:
    """The dearest cells, as many as link `PAIRS` pairs of entries at most; the memory for prices is planned so."""
    each = members(cells)
    order = np.argsort(-cells.price, kind="stable")
    seen = np.zeros(int(cells.entries.max(initial=-1)) + 1, dtype=bool)
    kept = []
    for at in order:
        seen[each[at]] = True
        if int(seen.sum()) ** 2 > 2 * PAIRS:
            break
        kept.append(int(at))
    kept.sort()
    return cells_of([each[at] for at in kept], cells.count[kept], cells.price[kept])


def priced(
    cells: Cells, pool: Pool, linear: Floats, tables: Sequence[Table], forbidden: float
) -> tuple[Floats, list[Table]]:
    """Linear costs (n,) and tables of the priced problem; `Cells.constant` goes with them.

    `forbidden` stands in for +inf before anything is taken off it.
    """
    if not len(cells.count):
        return linear, list(tables)
    added = np.bincount(cells.entries, (cells.price * cells.count)[cells.owner], len(linear))
    finite = [replace(each, costs=np.minimum(each.costs, forbidden)) for each in tables]
    return linear + added, _merged(finite, _rebates(cells, pool))


def _rebates(cells: Cells, pool: Pool) -> list[Table]:
    """What the prices take off the pairs of members, as tables."""
    member = flags(cells, np.arange(len(pool.cost)), len(pool.cost))
    used = [low + np.flatnonzero(member[:, low:high].any(axis=0)) for low, high in itertools.pairwise(pool.start)]
    inside = [member[:, each] for each in used]
    touched = np.array([each.any(axis=1) for each in inside])
    found = []
    for first, second in itertools.combinations(range(pool.count), 2):
        both = np.flatnonzero(touched[first] & touched[second])
        if len(both):
            # Whole multiples of `GRAIN`: the sum is exact, whatever the order of its terms.
            costs = -(inside[first][both].T * cells.price[both]) @ inside[second][both].astype(np.float64)
            rows, columns = used[first] - pool.start[first], used[second] - pool.start[second]
            found.append(Table(first, second, rows, columns, costs))
    return found


def _merged(tables: Sequence[Table], others: Sequence[Table]) -> list[Table]:
    """Sums of tables of the same variables, in order."""
    known = {(each.first, each.second): each for each in tables}
    for each in others:
        ends = (each.first, each.second)
        known[ends] = _sum(known[ends], each) if ends in known else each
    return [known[ends] for ends in sorted(known)]


def _sum(one: Table, other: Table) -> Table:
    rows, columns = np.union1d(one.rows, other.rows), np.union1d(one.columns, other.columns)
    costs = np.zeros((len(rows), len(columns)))
    for each in (one, other):
        costs[np.ix_(np.searchsorted(rows, each.rows), np.searchsorted(columns, each.columns))] += each.costs
    return Table(one.first, one.second, rows, columns, costs)


def flags(cells: Cells, chosen: Indices, size: int) -> Flags:
    """(cells, len(chosen)) whether each of some entries of a pool of `size` is a member of each cell."""
    place = np.full(size, -1, dtype=np.int64)
    place[chosen] = np.arange(len(chosen))
    at = place[cells.entries]
    found: Flags = np.zeros((len(cells.count), len(chosen)), dtype=bool)
    found[cells.owner[at >= 0], at[at >= 0]] = True
    return found


@dataclass(frozen=True, eq=False)
class Costs(Record):
    """A pairwise problem without prices, over the entries of a pool."""

    pool: Pool
    linear: Floats
    """(n,)."""
    tables: tuple[Table, ...]
    forbidden: float
    """Finite stand-in for +inf."""

    def dual(self, cells: Cells) -> Dual:
        """The dual of the problem with prices."""
        linear, tables = priced(cells, self.pool, self.linear, self.tables, self.forbidden)
        ends = itertools.pairwise(self.pool.start)
        return Dual([linear[a:b].copy() for a, b in ends], tables, self.forbidden, cells.constant)

    def part(self, chosen: Indices) -> Part:
        """The problem over some entries of the pool (ascending, some of every variable), its costs in one matrix."""
        pool = self.pool
        place = np.full(len(pool.cost), -1, dtype=np.int64)
        place[chosen] = np.arange(len(chosen))
        matrix = np.zeros((len(chosen), len(chosen)))
        for table in self.tables:
            rows, columns = place[pool.start[table.first] + table.rows], place[pool.start[table.second] + table.columns]
            costs = table.costs[np.ix_(rows >= 0, columns >= 0)]
            matrix[np.ix_(rows[rows >= 0], columns[columns >= 0])] = np.minimum(costs, self.forbidden)
        owner = pool.variable[chosen]
        entries = chosen - pool.start[owner]
        return Part(np.arange(pool.count), owner, entries, self.linear[chosen], matrix)
