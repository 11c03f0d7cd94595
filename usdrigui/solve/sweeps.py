"""Many sweeps of a dual at once, in single precision.

`Dual.sweep` looks at one table after another, a dozen small array operations each.  Here the multipliers of all
tables of a variable lie next to each other, tables are held in single precision, and a visit is two operations per
table and a dozen in all.  The multipliers are handed back and a last sweep is made in double precision: as always
the bound is worked out afresh from them, so what rounding spoils could only weaken it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from usdrigui.model import Flags, Indices, Singles
from usdrigui.solve.bounds import Dual, Edge

if TYPE_CHECKING:
    from usdrigui.solve.compiled import Loops

FEWEST = 3
"""Sweeps for which it is worth while to gather the tables."""
LONG = 200_000
"""Work of sweeps from which on compiled loops are used, if there are any: some tenths of a second."""
LARGEST = 1e30
"""Costs beyond could overflow, and compiled loops do not treat what is not a number as numpy does."""

LeastCosts = Callable[["_Visit", Singles, Singles], None]
"""Works out what each column of a visit's tables costs at least, of its multipliers, into the room given."""


def swept(dual: Dual, times: int) -> None:
    """Sweep so many times."""
    if times >= FEWEST and dual.edges:
        gathered = Sweeps(dual, times)
        gathered.go(times - 1)
        gathered.hand_over()
        times = 1
    for _ in range(times):
        dual.sweep()


def _quickest(dual: Dual, times: int) -> LeastCosts:
    """The way to work out least costs that is done first: a compiled one where it pays to have it."""
    if work_of(dual, times) < LONG:
        return least
    from usdrigui.solve.compiled import compiled_loops

    loops = compiled_loops()
    if loops is None or any(edge.costs[0].max(initial=0.0) >= LARGEST for edge in dual.edges):
        return least
    return partial(_compiled_least, loops)


def work_of(dual: Dual, times: int) -> int:
    """Work that so many sweeps count as."""
    return times * (dual.size // 128 + 24 * len(dual.edges))


@dataclass(frozen=True, eq=False)
class _Visit:
    """What a variable's visit in one direction works on: its tables with the variables ahead."""

    variable: slice
    """Its entries, counted through all variables."""
    given: slice
    """(tables, entries) its multipliers, in the flat list of all."""
    portion: float
    """Share of its costs that each table gets."""
    costs: Singles
    """Pair costs of all tables, row by row, one table after another."""
    rows: Indices
    """Rows of all tables: entries of the variable."""
    height: Indices
    """(tables + 1,) first row of each table."""
    width: Indices
    """(tables + 1,) first column of each."""
    tables: Sequence[tuple[Singles, Indices, slice]]
    """The same for numpy: views of each table's costs (rows, columns) and rows, and where its columns are."""
    unused: Flags
    """(tables, entries) whether an entry is in no row of a table: it costs nothing against anyone."""
    sizes: Indices
    """(tables,) entries of the other ends."""
    used: Indices
    """Where the columns of all tables are among the entries of all other ends."""
    theirs: Indices
    """Multipliers of the other ends, in the flat list."""
    others: Indices
    """Entries of the other ends, counted through all variables."""


class Sweeps:
    """The multipliers of a dual in one list, and its tables by the order of visits.

    The number of sweeps `expected` tells whether compiled loops pay.
    """

    def __init__(self, dual: Dual, expected: int) -> None:
        self._dual = dual
        self._least = _quickest(dual, expected)
        self._start = _starts([len(each) for each in dual.theta])
        self._theta: Singles = np.concatenate(dual.theta).astype(np.float32)
        self._place: dict[tuple[Edge, int], int] = {}
        """First of an end's multipliers in the flat list: those of a variable that one visit changes are neighbours."""
        order = range(len(dual.theta))
        turns = [(each, dual.ahead(each, True)) for each in order]
        turns += [(each, dual.ahead(each, False)) for each in reversed(order)]
        at = 0
        for variable, ahead in turns:
            for edge, side in ahead:
                self._place[edge, side] = at
                at += len(dual.theta[variable])
        self._given: Singles = np.empty(at, dtype=np.float32)
        for (edge, side), low in self._place.items():
            self._given[low : low + len(edge.given[side])] = edge.given[side]
        self._visits = [self._visit_of(variable, ahead) for variable, ahead in turns if ahead]

    def go(self, times: int) -> None:
        """So many passes over the variables and back, as `Dual.sweep`."""
        for _ in range(times):
            for visit in self._visits:
                self._visit(visit)

    def bound(self) -> float:
        """The dual's bound after a sweep, about: a sweep leaves no table with a least cost but 0."""
        least = np.minimum.reduceat(self._theta, self._start[:-1], dtype=np.float64)
        return self._dual.constant + float(least.sum())

    def hand_over(self) -> None:
        """Give the multipliers to the dual."""
        for (edge, side), low in self._place.items():
            given = self._given[low : low + len(edge.given[side])].astype(np.float64)
            self._dual.move(edge, side, given - edge.given[side])

    def _visit(self, visit: _Visit) -> None:
        mine = self._given[visit.given].reshape(len(visit.sizes), -1)
        theta: Singles = self._theta[visit.variable]
        share = theta * np.float32(visit.portion)
        mine -= share
        theta -= share * np.float32(len(visit.sizes))
        message = np.empty(len(visit.used), dtype=np.float32)
        self._least(visit, mine, message)
        elsewhere = -np.where(visit.unused, mine, -np.inf).max(axis=1)
        np.minimum(message, np.repeat(elsewhere, np.diff(visit.width)), out=message)
        new = np.repeat(-mine.max(axis=1), visit.sizes)
        new[visit.used] = message
        self._theta[visit.others] += new - self._given[visit.theirs]
        self._given[visit.theirs] = new

    def _visit_of(self, variable: int, ahead: Sequence[tuple[Edge, int]]) -> _Visit:
        size = len(self._dual.theta[variable])
        ends = [edge.ends[1 - side] for edge, side in ahead]
        sizes = np.array([len(self._dual.theta[end]) for end in ends])
        unused = np.ones((len(ahead), size), dtype=bool)
        for row, (edge, side) in zip(unused, ahead, strict=True):
            row[edge.used[side]] = False
        first = self._place[ahead[0]]
        low = np.cumsum(sizes) - sizes
        packed = (
            np.concatenate([edge.costs[side].ravel() for edge, side in ahead], dtype=np.float32, casting="same_kind"),
            np.concatenate([edge.used[side] for edge, side in ahead]),
            _starts([len(edge.used[side]) for edge, side in ahead]),
            _starts([len(edge.used[1 - side]) for edge, side in ahead]),
        )
        return _Visit(
            slice(int(self._start[variable]), int(self._start[variable + 1])),
            slice(first, first + len(ahead) * size),
            1.0 / max(len(ahead), len(self._dual.near[variable]) - len(ahead)),
            *packed,
            _tables(*packed),
            unused,
            sizes,
            np.concatenate([at + edge.used[1 - side] for at, (edge, side) in zip(low, ahead, strict=True)]),
            _ranges([self._place[edge, 1 - side] for edge, side in ahead], sizes),
            _ranges(self._start[ends], sizes),
        )


def least(visit: _Visit, mine: Singles, message: Singles) -> None:
    """Work out what each column of a visit's tables costs at least: `message` (columns of all tables,)."""
    for (costs, rows, at), own in zip(visit.tables, mine, strict=True):
        np.minimum.reduce(costs - own[rows, None], axis=0, out=message[at])


def _compiled_least(loops: Loops, visit: _Visit, mine: Singles, message: Singles) -> None:
    loops.least(visit.costs, visit.rows, visit.height, visit.width, mine, message)


def _tables(costs: Singles, rows: Indices, height: Indices, width: Indices) -> list[tuple[Singles, Indices, slice]]:
    found, at = [], 0
    edges = zip(itertools.pairwise(height.tolist()), itertools.pairwise(width.tolist()), strict=True)
    for (top, end), (left, right) in edges:
        size = (end - top) * (right - left)
        found.append((costs[at : at + size].reshape(end - top, right - left), rows[top:end], slice(left, right)))
        at += size
    return found


def _starts(sizes: Sequence[int]) -> Indices:
    return np.concatenate([[0], np.cumsum(sizes)])


def _ranges(start: Sequence[int] | Indices, sizes: Indices) -> Indices:
    """Ranges of so many numbers from each start, one after another."""
    low = np.cumsum(sizes) - sizes
    return np.repeat(np.asarray(start) - low, sizes) + np.arange(int(sizes.sum()))
