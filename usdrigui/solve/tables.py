"""Pair costs of the blocks of every two variables that come near each other, as small dense tables."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.model import ExtraPairs, Floats, Indices, LayoutProblem, Record
from usdrigui.solve.blocks import Bodies, Pool, near_pairs, pair_bounds
from usdrigui.solve.watch import Watch


@dataclass(frozen=True, eq=False)
class Table(Record):
    """Least pair costs of the blocks of two variables; zero outside the rows and columns listed."""

    first: int
    second: int
    """Variables, first < second."""
    rows: Indices
    """(r,) blocks of `first` that can cost anything, counted within the variable, ascending."""
    columns: Indices
    costs: Floats
    """(r, c) >= 0, +inf where forbidden."""


def pair_tables(problem: LayoutProblem, pool: Pool, candidate: Indices, watch: Watch) -> list[Table]:
    """Tables of all pairs of variables with a pair cost above zero, in order of (first, second).

    `candidate` (n,) says which candidate of its variable stands behind each entry of the pool: -1 for
    beside the face, -2 for a block of several.  Explicit pair costs (`LayoutProblem.extra`) are added
    where both entries are single candidates; for blocks zero bounds them from below.
    """
    found: list[Table] = []
    for first in range(pool.count):
        found.extend(_row_of_tables(problem, pool, candidate, first, watch))
    return found


def _row_of_tables(
    problem: LayoutProblem, pool: Pool, candidate: Indices, first: int, watch: Watch
) -> list[Table]:
    """Tables of one variable with all later ones."""
    low, high = int(pool.start[first]), int(pool.start[first + 1])
    end = int(pool.start[-1])
    keys, costs = [], []
    for one in pool.bodies:
        mine = slice(*np.searchsorted(one.owner, [low, high]).tolist())
        if mine.start == mine.stop:
            continue
        for other in pool.bodies:
            key, cost = _hits(problem, one, mine, other, high, watch)
            keys.append(one.owner[key[0]] * end + other.owner[key[1]])
            costs.append(cost)
    for extra in problem.extra:
        if extra.first == first:
            key_pair, cost = _explicit(pool, candidate, extra)
            keys.append(key_pair[0] * end + key_pair[1])
            costs.append(cost)
    if not keys:
        return []
    key, cost = _summed(np.concatenate(keys), np.concatenate(costs))
    return _split(pool, first, key // end, key % end, cost)


def _hits(
    problem: LayoutProblem, one: Bodies, mine: slice, other: Bodies, beyond: int, watch: Watch
) -> tuple[tuple[Indices, Indices], Floats]:
    """Pairs of bodies with a cost, and their costs: `mine` of `one` with those of `other` owned from `beyond` on."""
    later = _from(other, int(np.searchsorted(other.owner, beyond)))
    i, j = near_pairs(one, mine, later, problem.overlap.reach, problem.separation)
    watch.spend(len(i))
    cost = pair_bounds(one, i, later, j, problem.overlap, problem.separation)
    hit = cost > 0
    return (i[hit], j[hit] + len(other.owner) - len(later.owner)), cost[hit]


def _explicit(pool: Pool, candidate: Indices, extra: ExtraPairs) -> tuple[tuple[Indices, Indices], Floats]:
    """Entries of the pool that explicit costs speak of, and the costs."""
    first = _entry(pool, candidate, extra.first, extra.first_labels)
    second = _entry(pool, candidate, extra.second, extra.second_labels)
    known = (first >= 0) & (second >= 0) & (extra.costs > 0)
    return (first[known], second[known]), extra.costs[known]


def _entry(pool: Pool, candidate: Indices, variable: int, labels: Indices) -> Indices:
    """(q,) the variable's entries that are the single candidates `labels`, or -1."""
    low, high = pool.start[variable], pool.start[variable + 1]
    mine = candidate[low:high]
    order = np.argsort(mine, kind="stable")
    at = np.minimum(np.searchsorted(mine[order], labels), max(len(mine) - 1, 0))
    if not len(mine):
        return np.full(len(labels), -1, dtype=np.int64)
    entry = order[at]
    return np.where(mine[entry] == labels, entry + low, -1)


def _from(body: Bodies, at: int) -> Bodies:
    return Bodies(
        body.owner[at:],
        body.samples[:, :, at:],
        body.slack[at:],
        body.handle[:, at:],
        body.handle_slack[at:],
        body.middle[:, at:],
        body.radius[at:],
    )


def _summed(keys: Indices, costs: Floats) -> tuple[Indices, Floats]:
    """Costs of equal keys (other copies of the same pair) added up."""
    unique, inverse = np.unique(keys, return_inverse=True)
    return unique, np.bincount(inverse, weights=costs, minlength=len(unique))


def _split(pool: Pool, first: int, rows: Indices, columns: Indices, costs: Floats) -> list[Table]:
    """One table per second variable from sparse entries."""
    second = pool.variable[columns]
    order = np.argsort(second, kind="stable")
    edges = np.searchsorted(second[order], np.arange(pool.count + 1))
    found = []
    for other in range(first + 1, pool.count):
        part = order[edges[other] : edges[other + 1]]
        if not len(part):
            continue
        row, row_at = np.unique(rows[part], return_inverse=True)
        column, column_at = np.unique(columns[part], return_inverse=True)
        table = np.zeros((len(row), len(column)))
        table[row_at, column_at] = costs[part]
        found.append(Table(first, other, row - pool.start[first], column - pool.start[other], table))
    return found


