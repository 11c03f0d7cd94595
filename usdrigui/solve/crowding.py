"""Finding crowded cells and their prices: ascent of the smoothed dual over the entries in play.

The bound over multipliers and prices is concave but has corners; replacing every least value by a soft one,
-eps log sum exp(-x / eps), makes it smooth (Y. Nesterov 2005; for such problems B. Savchynskyy et al., "Efficient
MRF energy minimization via adaptive diminishing smoothing", 2012), and its derivatives are marginals: how much of
every entry, and of every pair, the relaxation chooses.  Those tell which cells are crowded and how to change their
prices.  All of this only proposes: `usdrigui.solve.bounds` works the bound out afresh from what is proposed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from usdrigui.model import Flags, Floats, Indices, Record
from usdrigui.solve.blocks import Pool
from usdrigui.solve.bounds import Dual
from usdrigui.solve.cells import Cells, bounded, cells_of, flags, members, priced
from usdrigui.solve.tables import Table
from usdrigui.solve.watch import Watch

IN_PLAY = 400
"""Entries that the ascent works on at most."""
STEPS = 36
SEARCH_EVERY = 6
"""Steps between two searches for crowded cells."""
COOLING = 0.15
"""Share of the first softness that is left at the end."""
MOMENTUM = 0.8
GAIN = 2.0
NEW = 40
"""Cells added at a time."""
MOST = 300
VIOLATED = 0.04
ALIKE = 0.7
"""Share of their mass in common above which two cells count as the same."""
HANDLE_RADII = (0.4, 0.5, 0.65, 0.9)
BODY_RADII = (0.5, 0.65, 0.8, 1.0, 1.25)
"""Of the cells tried around an entry, in overlap radii: balls of handles, and of handles and middles."""
PAIR_COSTS = (0.03, 0.1, 0.3, 1.0)
"""Cells tried around an entry: all that cost it at least this much."""
COUNTS = np.arange(1.0, 5.0)
SOFT = 1.0
"""Softness at first, in shares of what is missing per variable."""
SWEEPS = 8
TINY = 1e-7
SUPPORT = 0.003
"""Least share of an entry that cells are looked for among."""


@dataclass(frozen=True, eq=False)
class Places(Record):
    """Where the entries of a pool stand."""

    handle: Floats
    """(n, copies, 3) in overlap radii; nan where there is no copy or no body."""
    middle: Floats
    """(n, copies, 3)."""


def places(pool: Pool, unit: float) -> Places:
    """Positions of handles and of the elements' middles in multiples of `unit`."""
    size = len(pool.cost)
    seen = np.zeros(size, dtype=np.int64)
    for body in pool.bodies:
        seen[body.owner] += 1
    found = np.full((2, size, seen.max(initial=1), 3), np.nan)
    seen[:] = 0
    for body in pool.bodies:
        found[0, body.owner, seen[body.owner]] = body.handle.T / unit
        found[1, body.owner, seen[body.owner]] = body.middle.T / unit
        seen[body.owner] += 1
    return Places(found[0], found[1])


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
        ends = zip(self.pool.start[:-1], self.pool.start[1:], strict=True)
        return Dual([linear[a:b].copy() for a, b in ends], tables, self.forbidden, cells.constant)


def tightened(costs: Costs, where: Places, dual: Dual, cells: Cells, cut: float, watch: Watch) -> tuple[Dual, Cells]:
    """A dual of the same problem with other prices, if its bound is better; else the one given."""
    bound = dual.bound()
    missing = cut - bound
    if missing <= 0 or watch.stopped():
        return dual, cells
    other, ascent = _proposed(costs, where, dual, cells, SOFT * missing / len(dual.theta), watch)
    new = costs.dual(other)
    new.start_from(dual, [np.arange(len(each)) for each in dual.theta])
    ascent.hand_over(new, costs.pool)
    for _sweep in range(SWEEPS):
        new.sweep()
    watch.spend(SWEEPS * (new.size // 16 + 64 * len(new.edges)))
    return (new, other) if new.bound() > bound else (dual, cells)


def _proposed(
    costs: Costs, where: Places, dual: Dual, cells: Cells, softness: float, watch: Watch
) -> tuple[Cells, Ascent]:
    """Cells and multipliers likely to give a better bound than `dual`, whose prices are those of `cells`."""
    ascent = Ascent(costs, _in_play(costs.pool, dual), dual, cells)
    groups, counts = members(cells), cells.count.tolist()
    known = {(count, each.tobytes()) for count, each in zip(counts, groups, strict=True)}
    for step in range(STEPS):
        eps = softness * COOLING ** (step / STEPS)
        ascent.sweep(eps)
        if step % SEARCH_EVERY == 0 and step < STEPS - 2 * SEARCH_EVERY and len(groups) < MOST:
            for each, count in _crowded(ascent, where, eps):
                if (count, each.tobytes()) not in known:
                    known.add((count, each.tobytes()))
                    groups.append(each)
                    counts.append(count)
            ascent.extend(cells_of(groups, counts, ascent.price))
        ascent.price_step(eps)
        watch.spend((len(ascent.chosen) ** 2 * 3 + len(groups) * len(ascent.chosen)) // 16)
        if watch.stopped():
            break
    for _ in range(4):
        ascent.sweep(0.0)
    kept = np.flatnonzero(ascent.price > TINY)
    return bounded(cells_of([groups[at] for at in kept], ascent.count[kept], ascent.price[kept])), ascent


def _in_play(pool: Pool, dual: Dual) -> Indices:
    """The entries of least excess over their variable's least, two of each variable at least."""
    excess = np.concatenate([each - each.min() for each in dual.theta])
    order = np.lexsort((excess, pool.variable))
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.arange(len(order)) - pool.start[pool.variable[order]]
    excess[rank < 2] = -1.0
    most = max(IN_PLAY, int((rank < 2).sum()))
    return np.sort(np.argsort(excess, kind="stable")[:most])


class Ascent:
    """The smoothed dual over some entries, with prices on cells."""

    def __init__(self, costs: Costs, chosen: Indices, dual: Dual, cells: Cells) -> None:
        pool = costs.pool
        self.chosen = chosen
        """(n,) entries of the pool."""
        self.variable = pool.variable[chosen]
        self.start = np.searchsorted(self.variable, np.arange(pool.count + 1))
        self.given = np.zeros((len(chosen), pool.count))
        """(n, variables) what the table with each variable gives to each entry."""
        self.linked: Flags = np.zeros((pool.count, pool.count), dtype=bool)
        self.pairs = _dense(costs, chosen)
        """(n, n) pair costs without prices."""
        self._linear = costs.linear[chosen]
        self._size = len(pool.cost)
        for edge in dual.edges:
            self.linked[edge.ends] = self.linked[edge.ends[::-1]] = True
            for side in (0, 1):
                mine, local = self._local(pool, edge.ends[side])
                self.given[mine, edge.ends[1 - side]] = edge.given[side][local]
        self.extend(cells)

    def hand_over(self, dual: Dual, pool: Pool) -> None:
        """Give the multipliers to a dual of the whole."""
        for edge in dual.edges:
            for side in (0, 1):
                mine, local = self._local(pool, edge.ends[side])
                change = np.zeros(len(edge.given[side]))
                change[local] = self.given[mine, edge.ends[1 - side]] - edge.given[side][local]
                dual.move(edge, side, change)

    def _local(self, pool: Pool, variable: int) -> tuple[slice, Indices]:
        """Where a variable's entries are here, and their numbers within the variable."""
        mine = slice(int(self.start[variable]), int(self.start[variable + 1]))
        return mine, self.chosen[mine] - pool.start[variable]

    def extend(self, cells: Cells) -> None:
        """Take other cells, of which those known so far come first; new ones start without a price."""
        self.count = cells.count
        self.price = cells.price
        self.member: Floats = flags(cells, self.chosen, self._size).astype(np.float64)
        self._before, self._momentum = self.price, 1.0
        by_variable = (np.add.reduceat(self.member, self.start[:-1], axis=1) > 0).astype(np.float64)
        self.linked |= (by_variable.T @ by_variable) > 0
        np.fill_diagonal(self.linked, False)
        triples = [self._pairs_within(each) for each in self.member]
        self._cell = np.repeat(np.arange(len(triples)), [len(first) for first, _ in triples])
        none = np.empty(0, dtype=np.int64)
        self._first = np.concatenate([none, *(first for first, _ in triples)])
        self._second = np.concatenate([none, *(second for _, second in triples)])
        self._apply()

    def _pairs_within(self, member: Floats) -> tuple[Indices, Indices]:
        """Pairs of entries of a cell that belong to different variables, the earlier first."""
        mine = np.flatnonzero(member)
        variable = self.variable[mine]
        first, second = np.nonzero(variable[:, None] < variable)
        return mine[first], mine[second]

    def _apply(self) -> None:
        """Costs as the prices are now."""
        size = len(self.chosen)
        rebate = np.bincount(self._first * size + self._second, self.price[self._cell], size**2).reshape(size, size)
        self.costs: NDArray[np.float32] = (self.pairs - (rebate + rebate.T)).astype(np.float32)
        self.linear = self._linear + (self.price * self.count) @ self.member

    def sweep(self, eps: float) -> None:
        """Best multipliers of one variable after another, forth and back; hard minima with `eps` 0."""
        count = len(self.start) - 1
        for variable in (*range(count), *range(count - 1, -1, -1)):
            near = np.flatnonzero(self.linked[variable])
            mine = slice(self.start[variable], self.start[variable + 1])
            message = self._soft_least(self.costs[mine] - self.given[:, variable].astype(np.float32), eps)[:, near]
            total = self.linear[mine] + message.sum(axis=1)
            self.given[mine, near] = message - total[:, None] / (len(near) + 1)

    def _soft_least(self, values: NDArray[np.floating], eps: float) -> Floats:
        """(rows, variables) soft least of each row over the entries of each variable."""
        first = self.start[:-1]
        least = np.minimum.reduceat(values, first, axis=1)
        if not eps:
            return np.asarray(least)
        weight = np.exp((np.repeat(least, np.diff(self.start), axis=1) - values) / eps)
        return np.asarray(least - eps * np.log(np.add.reduceat(weight, first, axis=1)))

    def shares(self, eps: float) -> tuple[Floats, Floats]:
        """(n,) how much of each entry the relaxation chooses, and (variables,) soft least reduced costs."""
        theta = self.linear + self.given.sum(axis=1)
        soft = self._soft_least(theta[None], eps)[0]
        return np.exp((soft[self.variable] - theta) / eps), soft

    def together(self, first: Indices, second: Indices, share: Floats, soft: Floats, eps: float) -> Floats:
        """How much of pairs of entries the relaxation chooses; the first of an earlier variable than the second.

        After a sweep the table of two variables is settled with the earlier of the two.
        """
        one, other = self.variable[first], self.variable[second]
        left = self.costs[first, second] - self.given[first, other] - self.given[second, one]
        pairs = np.exp(np.minimum((soft[one] - left) / eps, 0.0))
        return np.where(self.linked[one, other], pairs, share[first] * share[second])

    def price_step(self, eps: float) -> None:
        """Raise the prices of crowded cells, lower those of others, as Newton's method would one by one."""
        if not len(self.price):
            return
        share, soft = self.shares(eps)
        mass = self.member @ share
        pairs = self.together(self._first, self._second, share, soft, eps)
        both = np.bincount(self._cell, pairs, len(self.price))
        slope = self.count * mass - self.count * (self.count + 1) / 2 - both
        others = ((self.price > 0) | (slope > 0)) @ self.member
        crowd = np.maximum((self.member @ (share * others)) / np.maximum(mass, 1e-9), 1.0)
        bend = (self.count**2 * np.minimum(mass, 1.0) + both + 0.1) / eps
        new = np.maximum(0.0, self.price + GAIN * slope / (bend * crowd))
        if slope @ (new - self._before) < 0:
            self._momentum = 1.0
        following = (1 + np.sqrt(1 + 4 * self._momentum**2)) / 2
        push = min((self._momentum - 1) / following, MOMENTUM)
        self.price = np.maximum(0.0, new + push * (new - self._before))
        self._before, self._momentum = new, following
        self._apply()


# --- crowded cells -----------------------------------------------------------------------------------


def _crowded(ascent: Ascent, where: Places, eps: float) -> list[tuple[Indices, float]]:
    """The most violated cells that are not much alike: entries of the pool, and k."""
    share, soft = ascent.shares(eps)
    chosen = np.flatnonzero(share > SUPPORT)
    first, second = np.nonzero(ascent.variable[chosen][:, None] < ascent.variable[chosen])
    pairs = np.zeros((len(chosen), len(chosen)))
    pairs[first, second] = ascent.together(chosen[first], chosen[second], share, soft, eps)
    share = share[chosen]
    sets, family, centre = _candidates(ascent, where, chosen, share)
    mass = sets @ share
    both = ((sets @ pairs) * sets).sum(axis=1)
    excess = (COUNTS * mass[:, None] - COUNTS * (COUNTS + 1) / 2 - both[:, None]) / COUNTS
    best, worst = excess.argmax(axis=1), excess.max(axis=1)
    order = np.argsort(-worst, kind="stable")[:500]
    order = order[worst[order] > VIOLATED]
    alike = (sets[order] * share) @ sets[order].T > ALIKE * np.maximum(mass[order][:, None], mass[order])
    free = np.ones(len(order), dtype=bool)
    found: list[tuple[Indices, float]] = []
    for at, number in enumerate(order):
        if free[at] and len(found) < NEW:
            free &= ~alike[at]
            mine = ascent.chosen[chosen[sets[number] > 0]]
            ball = _ball(where, int(ascent.chosen[chosen[centre[number]]]), int(family[number]))
            found.append((np.union1d(mine, ball), float(COUNTS[best[number]])))
    return found


def _candidates(ascent: Ascent, where: Places, chosen: Indices, share: Floats) -> tuple[Floats, Indices, Indices]:
    """(sets, m) sets of the chosen entries around each of them that hold more than one element, as numbers 0 and
    1; the number of the family of each, and the entry around which it lies."""
    entries = ascent.chosen[chosen]
    handle, body = _apart(where.handle[entries]), _apart(where.middle[entries])
    body = np.maximum(handle, body)
    same = ascent.variable[chosen][:, None] == ascent.variable[chosen]
    costs = ascent.pairs[np.ix_(chosen, chosen)]
    found = [handle <= each for each in HANDLE_RADII] + [body <= each for each in BODY_RADII]
    found += [(costs >= each) | (same & (handle < 0.5)) for each in PAIR_COSTS]
    crowded = [each @ share > 1.0 + VIOLATED for each in found]
    sets = np.concatenate([each[rows] for each, rows in zip(found, crowded, strict=True)]).astype(np.float64)
    family = np.repeat(np.arange(len(found)), [int(rows.sum()) for rows in crowded])
    return sets, family, np.concatenate([np.flatnonzero(rows) for rows in crowded])


def _ball(where: Places, centre: int, family: int) -> Indices:
    """All entries of the pool that belong to a cell around an entry; none for cells of pair costs."""
    if family >= len(HANDLE_RADII) + len(BODY_RADII):
        return np.empty(0, dtype=np.int64)
    handle = _apart(where.handle[[centre]], where.handle)[0]
    if family < len(HANDLE_RADII):
        return np.flatnonzero(handle <= HANDLE_RADII[family])
    body = np.maximum(handle, _apart(where.middle[[centre]], where.middle)[0])
    return np.flatnonzero(body <= BODY_RADII[family - len(HANDLE_RADII)])


def _dense(costs: Costs, chosen: Indices) -> Floats:
    """(n, n) pair costs of some entries."""
    pool = costs.pool
    place = np.full(len(pool.cost), -1, dtype=np.int64)
    place[chosen] = np.arange(len(chosen))
    found = np.zeros((len(chosen), len(chosen)))
    for table in costs.tables:
        rows, columns = place[pool.start[table.first] + table.rows], place[pool.start[table.second] + table.columns]
        part = np.minimum(table.costs[np.ix_(rows >= 0, columns >= 0)], costs.forbidden)
        found[np.ix_(rows[rows >= 0], columns[columns >= 0])] = part
        found[np.ix_(columns[columns >= 0], rows[rows >= 0])] = part.T
    return found


def _apart(one: Floats, other: Floats | None = None) -> Floats:
    """(n, m) least distance between any copies; inf where there is none."""
    other = one if other is None else other
    found = np.full((len(one), len(other)), np.inf)
    for mine in range(one.shape[1]):
        for theirs in range(other.shape[1]):
            np.fmin(found, np.linalg.norm(one[:, None, mine] - other[None, :, theirs], axis=-1), out=found)
    return found
