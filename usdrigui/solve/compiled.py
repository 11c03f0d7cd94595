"""Long searches and sweeps in compiled loops, where numba is installed.

A node of the exact search touches every entry of its matrix a dozen times, in some hundred calls of numpy on small
blocks.  The loops below do the same in one pass or two.  They add, subtract, multiply and compare the same
numbers in the same order, so that every result is the same to the last bit, and a search may change over at any
node; what numpy adds up pairwise is left to numpy.  The sign of a zero may differ; nothing depends on it.

The loops are plain functions: what they need comes as arguments and they call nothing, so that what numba keeps
on disk is outdated exactly when this file or numba is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np

from usdrigui.model import Flags, Floats, Indices, Singles
from usdrigui.solve.subproblem import EPSILON, Part

LARGEST = 1e200
"""Costs beyond could overflow, and the loops do not treat what is not a number as numpy does."""


def settle(matrix: Floats, start: Indices, least: Floats, most: Floats, low: Floats, high: Floats) -> None:
    """Take its least cost out of every table; `least` and `most` (k, k) become what they were before.

    `low` and `high` (n,) are room to work in.
    """
    count = len(start) - 1
    for at in range(count - 1):
        first, end = start[at], start[at + 1]
        for row in range(first, end):
            ahead = matrix[row, end:]
            if row == first:
                for k in range(len(ahead)):
                    low[k] = ahead[k]
                    high[k] = ahead[k]
            else:
                for k in range(len(ahead)):
                    cost = ahead[k]
                    low[k] = min(low[k], cost)
                    high[k] = max(high[k], cost)
        for other in range(at + 1, count):
            lowest, highest = low[start[other] - end], high[start[other] - end]
            for k in range(start[other] - end + 1, start[other + 1] - end):
                lowest = min(lowest, low[k])
                highest = max(highest, high[k])
            least[at, other] = lowest
            most[at, other] = highest
            if lowest != 0.0:
                for row in range(first, end):
                    ahead = matrix[row, start[other] : start[other + 1]]
                    for k in range(len(ahead)):
                        ahead[k] -= lowest


def sweep(
    matrix: Floats, costs: Floats, start: Indices, linked: Flags, empty: Flags, portion: Floats, room: Floats
) -> None:
    """`Part.sweep`, but for tables of zeros (`empty`): nothing is moved by way of them.

    `portion` (k,) and `room` (n,) are room to work in.
    """
    count = len(start) - 1
    for at in range(count):
        first, end = start[at], start[at + 1]
        ahead, behind = 0, 0
        for other in range(count):
            if linked[at, other] and other > at:
                ahead += 1
            elif linked[at, other]:
                behind += 1
        portion[at] = 1.0 / max(ahead, behind, 1)
        if ahead == 0:
            continue
        other = at + 1
        while other < count:
            # Neighbours that are alike are worked on together: long runs are quick.
            left, link, void = other, linked[at, other], empty[at, other]
            while other < count and linked[at, other] == link and empty[at, other] == void:
                other += 1
            if void:
                continue
            message = room[: start[other] - start[left]]
            for row in range(first, end):
                share = costs[row] * portion[at] if link else 0.0
                entries = matrix[row, start[left] : start[other]]
                if row == first:
                    for k in range(len(entries)):
                        entries[k] += share
                        message[k] = entries[k]
                else:
                    for k in range(len(entries)):
                        cost = entries[k] + share
                        entries[k] = cost
                        message[k] = min(message[k], cost)
            for row in range(first, end):
                entries = matrix[row, start[left] : start[other]]
                for k in range(len(entries)):
                    entries[k] -= message[k]
            theirs = costs[start[left] : start[other]]
            for k in range(len(theirs)):
                theirs[k] += message[k]
        for row in range(first, end):
            costs[row] *= 1.0 - portion[at] * ahead
    for at in range(count - 1, -1, -1):
        behind = 0
        for other in range(at):
            if linked[at, other]:
                behind += 1
        if behind == 0:
            continue
        mine = costs[start[at] : start[at + 1]]
        share = room[: len(mine)]
        for other in range(at):
            if empty[other, at]:
                continue
            for k in range(len(mine)):
                share[k] = mine[k] * portion[at] if linked[other, at] else 0.0
            for row in range(start[other], start[other + 1]):
                entries = matrix[row, start[at] : start[at + 1]]
                least = entries[0] + share[0]
                for k in range(len(entries)):
                    cost = entries[k] + share[k]
                    entries[k] = cost
                    least = min(least, cost)
                for k in range(len(entries)):
                    entries[k] -= least
                costs[row] += least
        for k in range(len(mine)):
            mine[k] *= 1.0 - portion[at] * behind


def add_stars(matrix: Floats, excess: Floats, start: Indices, empty: Flags, stars: Floats, room: Floats) -> None:
    """Add to `stars` (n,) what each entry costs at least with every other variable, in the order of the variables."""
    count = len(start) - 1
    for at in range(count):
        first, end = start[at], start[at + 1]
        theirs = stars[end:]
        message = room[: len(theirs)]
        for row in range(first, end):
            ahead = matrix[row, end:]
            if row == first:
                for k in range(len(ahead)):
                    message[k] = ahead[k] + excess[row]
            else:
                for k in range(len(ahead)):
                    cost = ahead[k] + excess[row]
                    message[k] = min(message[k], cost)
            total = stars[row]
            for other in range(at + 1, count):
                if empty[at, other]:
                    continue
                entries, more = matrix[row, start[other] : start[other + 1]], excess[start[other] : start[other + 1]]
                least = entries[0] + more[0]
                for k in range(len(entries)):
                    cost = entries[k] + more[k]
                    least = min(least, cost)
                total += least
            stars[row] = total
        for k in range(len(theirs)):
            theirs[k] += message[k]


def gather(matrix: Floats, kept: Indices, found: Floats) -> None:
    """The rows and columns that are kept, above the diagonal, where all tables are."""
    for at in range(len(kept)):
        row, columns, there = matrix[kept[at]], kept[at + 1 :], found[at, at + 1 :]
        for k in range(len(columns)):
            there[k] = row[columns[k]]


def pay(matrix: Floats, kept: Indices, taken: Indices, found: Floats) -> None:
    """What each entry kept (a row of `found`) costs with each that is taken, of other variables."""
    for at in range(len(kept)):
        for k in range(len(taken)):
            found[at, k] = matrix[min(kept[at], taken[k]), max(kept[at], taken[k])]


def least(costs: Singles, rows: Indices, height: Indices, width: Indices, mine: Singles, message: Singles) -> None:
    """`sweeps.least`."""
    at = 0
    for table in range(len(height) - 1):
        found = message[width[table] : width[table + 1]]
        for number in range(height[table], height[table + 1]):
            own, row = mine[table, rows[number]], costs[at : at + len(found)]
            if number == height[table]:
                for k in range(len(found)):
                    found[k] = row[k] - own
            else:
                for k in range(len(found)):
                    cost = row[k] - own
                    found[k] = min(found[k], cost)
            at += len(found)


@dataclass(frozen=True)
class Loops:
    """The functions above, compiled."""

    settle: Callable[..., None]
    sweep: Callable[..., None]
    add_stars: Callable[..., None]
    gather: Callable[..., None]
    pay: Callable[..., None]
    least: Callable[..., None]


class CompiledPart(Part):
    """A part whose costs are read and changed by the loops."""

    def __init__(
        self, loops: Loops, variables: Indices, owner: Indices, entries: Indices, costs: Floats, matrix: Floats
    ) -> None:
        super().__init__(variables, owner, entries, costs, matrix)
        self._loops = loops
        self._empty: Flags = np.zeros_like(self.linked)
        """Which tables above the diagonal are known to be of zeros."""

    def settle(self) -> None:
        """As `Part.settle`."""
        least, most = np.zeros(self.linked.shape), np.zeros(self.linked.shape)
        room = np.empty((2, len(self.costs)))
        self._loops.settle(self.matrix, self.start, least, most, room[0], room[1])
        self.constant += float(least.sum())
        ahead = most - least > EPSILON
        self.linked = ahead | ahead.T
        self._empty = most == least

    def sweep(self) -> None:
        """As `Part.sweep`."""
        portion, room = np.empty(len(self.sizes)), np.empty(len(self.costs))
        self._loops.sweep(self.matrix, self.costs, self.start, self.linked, self._empty, portion, room)

    def bounds(self) -> tuple[float, Floats]:
        """As `Part.bounds`."""
        least = np.minimum.reduceat(self.costs, self.start[:-1])
        excess = self.costs - least[self.owner]
        stars = excess.copy()
        self._loops.add_stars(self.matrix, excess, self.start, self._empty, stars, np.empty(len(stars)))
        return self.constant + float(least.sum()), stars

    def _paid(self, taken: Indices, alive: Flags) -> Floats:
        kept = np.flatnonzero(alive)
        found = np.empty((len(kept), len(taken)))
        self._loops.pay(self.matrix, kept, taken, found)
        return np.asarray(found.sum(axis=1))

    def _kept(self, variables: Indices, owner: Indices, alive: Flags) -> CompiledPart:
        kept = np.flatnonzero(alive)
        matrix = np.zeros((len(kept), len(kept)))
        self._loops.gather(self.matrix, kept, matrix)
        part = CompiledPart(self._loops, variables, owner, self.entries[kept], self.costs[kept], matrix)
        part.constant, part.taken = self.constant, self.taken
        return part


def compiled_part(part: Part) -> Part:
    """The part, worked on by compiled loops from now on if there are any; the one given is used up."""
    if isinstance(part, CompiledPart):
        return part
    loops = compiled_loops()
    if loops is None or not _moderate(part):
        return part
    part.matrix = np.ascontiguousarray(part.matrix)
    found = CompiledPart(loops, part.variables, part.owner, part.entries, part.costs, part.matrix)
    found.constant, found.taken = part.constant, part.taken
    return found


def _moderate(part: Part) -> bool:
    """Whether no cost is so large that sums could overflow, nor infinite, nor no number at all."""
    return all(each.min() > -LARGEST and each.max() < LARGEST for each in (part.costs, part.matrix))


@cache
def compiled_loops() -> Loops | None:
    """The loops, compiled or read from where numba keeps them; None where numba is absent or does not work.

    Whatever is wrong with it, the search goes on without: it only makes it quicker.
    """
    for keep in (True, False):  # a place to keep them in may be missing, read-only or damaged
        try:
            return _compiled(keep)
        except ImportError:
            return None
        except Exception:
            continue
    return None


def _compiled(keep: bool) -> Loops | None:
    import numba

    if getattr(numba.config, "DISABLE_JIT", False):  # as functions of Python they are far slower than numpy
        return None
    table, costs = numba.float64[:, ::1], numba.float64[::1]
    places, flags, singles = numba.int64[::1], numba.boolean[:, ::1], numba.float32[::1]

    def made(loop: Callable[..., None], *arguments: object) -> Callable[..., None]:
        compiled: Callable[..., None] = numba.njit(numba.void(*arguments), cache=keep)(loop)
        return compiled

    return Loops(
        settle=made(settle, table, places, table, table, costs, costs),
        sweep=made(sweep, table, costs, places, flags, flags, costs, costs),
        add_stars=made(add_stars, table, costs, places, flags, costs, costs),
        gather=made(gather, table, places, table),
        pay=made(pay, table, places, places, table),
        least=made(least, singles, places, places, places, numba.float32[:, ::1], singles),
    )
