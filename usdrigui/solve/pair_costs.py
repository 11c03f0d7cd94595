"""What pairs of labels cost, worked out where the two can meet."""

from __future__ import annotations

import itertools

import numpy as np
from scipy.sparse import coo_array, csr_array

from usdrigui.character import Flags, Floats, Indices
from usdrigui.model import ExtraPairs, LayoutProblem
from usdrigui.overlap import drawn_costs
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import LabelGeometry, LabelSet, squared

CHUNK = 65536
"""Distances worked out at a time: they stay in the processor's cache."""

Entries = tuple[Indices, Indices, Floats]
"""(q,) labels, the earlier variable's first, and what they cost together."""


def pair_costs(
    problem: LayoutProblem, labels: LabelSet, budget: Budget, most: float = np.inf
) -> csr_array | None:
    """(n, n) costs of the pairs that cost anything, each once, the label of the earlier variable
    first; +inf where forbidden.  None where more than `most` pairs come near each other."""
    pairs = np.triu(problem.together, 1)
    found: list[Entries] = []
    for one, other in itertools.product(labels.geometries, repeat=2):
        mine, theirs = labels.variable[one.owner], labels.variable[other.owner]
        rows = max(1, 8 * CHUNK // max(1, len(theirs)))
        for low in range(0, len(mine), rows):
            later = int(np.searchsorted(theirs, mine[low], side="right"))
            i, j = np.ix_(range(low, min(low + rows, len(mine))), range(later, len(theirs)))
            near = np.argwhere(meeting(one, i, other, j, problem)) + np.array([low, later])
            at, columns = near[pairs[mine[near[:, 0]], theirs[near[:, 1]]]].T
            most -= len(at)
            if most < 0:
                return None
            budget.spend(len(at))
            costs = geometry_costs(one, at, other, columns, problem)
            paid = np.flatnonzero(costs)
            found.append((one.owner[at[paid]], other.owner[columns[paid]], costs[paid]))
    return _summed(problem, labels, found)


def explicit_costs(problem: LayoutProblem, labels: LabelSet) -> csr_array:
    """The part of the pair costs that is explicit (`LayoutProblem.extra`)."""
    return _summed(problem, labels, [])


def _summed(problem: LayoutProblem, labels: LabelSet, found: list[Entries]) -> csr_array:
    """(n, n) what is found and the explicit costs."""
    found += [_explicit(labels, each) for each in problem.extra]
    none = np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64), np.empty(0)
    first, second, costs = map(np.concatenate, zip(none, *found, strict=True))
    every = coo_array((costs, (first, second)), shape=(len(labels.cost),) * 2).tocsr()
    every.eliminate_zeros()
    return every


def meeting(
    one: LabelGeometry, i: Indices, other: LabelGeometry, j: Indices | slice, problem: LayoutProblem
) -> Flags:
    """Whether geometries ``i`` of `one` and ``j`` of `other`, broadcast, may interact: balls around
    what is drawn of each come within reach of the overlap or of the separation."""
    limit = one.extent[i] + other.extent[j] + max(problem.overlap.reach, problem.separation)
    return squared(one.middle[:, i], other.middle[:, j]) < np.square(limit)


def geometry_costs(
    one: LabelGeometry, i: Indices, other: LabelGeometry, j: Indices, problem: LayoutProblem
) -> Floats:
    """(q,) costs of geometries ``i[q]`` of `one` and ``j[q]`` of `other`, +inf where the handles
    are nearer than the separation."""
    costs = np.empty(len(j))
    at_once = max(1, CHUNK // max(1, len(one.samples), len(other.samples)))
    for low in range(0, len(j), at_once):
        part = slice(low, low + at_once)
        drawn = one.drawn(i[part]), other.drawn(j[part])
        costs[part] = drawn_costs(*drawn, problem.overlap, problem.separation)
    return costs


def _explicit(labels: LabelSet, extra: ExtraPairs) -> Entries:
    """Labels that explicit costs speak of, and the costs."""
    first = _label(labels, extra.first, extra.first_labels)
    second = _label(labels, extra.second, extra.second_labels)
    known = (first >= 0) & (second >= 0)
    return first[known], second[known], extra.costs[known]


def _label(labels: LabelSet, variable: int, candidates: Indices) -> Indices:
    """(q,) the variable's labels that are the candidates, or -1."""
    mine = np.arange(labels.start[variable], labels.start[variable + 1])
    place = np.full(max(labels.candidate[mine].max(initial=0), candidates.max(initial=0)) + 1, -1)
    on_face = mine[labels.candidate[mine] >= 0]
    place[labels.candidate[on_face]] = on_face
    return place[candidates]
