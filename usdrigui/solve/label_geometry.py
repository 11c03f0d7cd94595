"""Labels as arrays: what they cost, where their elements are, and least pair costs from that.

A *label* is a candidate of a variable, or the board, numbered through the whole problem.  A *block*
is a set of labels of one variable that are treated as one (`usdrigui.solve.partition`): its cost is
the least of theirs, its geometry a centre with radii, from which the distance of any two members of
two blocks is bounded from above.  A block of one label has radius zero, so blocks and labels go
through the same code.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.model import LayoutProblem, Variable
from usdrigui.overlap import ROUNDING, Drawn, least_costs

CHUNK = 65536
"""Distances worked out at a time: they stay in the processor's cache."""
SEVERAL = -2
"""Stands for the candidate of a block of several."""


class LabelGeometry(Record):
    """One copy of the elements of labels (or blocks) that have the same number of samples.

    Scene units.
    """

    owner: Indices
    """(n,) label or block, ascending."""
    samples: Floats
    """(u, d, n) positions along the drawn element; for blocks of their centres."""
    apart: Floats
    """(u, n) how far a member's sample is from the centre's at most."""
    handle: Floats
    """(d, n)."""
    handle_apart: Floats
    """(n,) how far a member's handle is from `handle` at most."""

    @cached_property
    def middle(self) -> Floats:
        """(d, n) mean of the samples."""
        return self.samples.mean(axis=0) if len(self.samples) else self.handle

    @cached_property
    def extent(self) -> Floats:
        """(n,) radius of a ball around `middle` that holds all samples and handles of members."""
        of_samples = np.sqrt(np.square(self.samples - self.middle).sum(axis=1)) + self.apart
        of_handle = np.sqrt(squared(self.handle, self.middle)) + self.handle_apart
        most = np.maximum(of_samples.max(axis=0, initial=0.0), of_handle)
        return np.asarray(most * (1.0 + ROUNDING))

    def drawn(self, at: Indices) -> Drawn:
        """Geometries `at` as drawn."""
        return Drawn(self.samples, self.handle, self.apart, self.handle_apart).of(at)

    def of(self, kept: Indices, owner: Indices) -> LabelGeometry:
        """Some of the geometries, of other owners."""
        some = self.drawn(kept)
        return LabelGeometry(owner, some.samples, some.apart, some.handle, some.handle_apart)

    def places(self, labels: int) -> Indices:
        """(labels,) which of the geometries is each label's, or -1."""
        place = np.full(labels, -1, dtype=np.int64)
        place[self.owner] = np.arange(len(self.owner))
        return place


class LabelSet(Record):
    """Labels or blocks of all variables; those on the board have no geometry."""

    variables: int
    """How many; each has a label."""
    variable: Indices
    """(n,) ascending."""
    candidate: Indices
    """(n,) which candidate of the variable, -1 for the board, `SEVERAL` for a block of several."""
    cost: Floats
    """(n,) linear cost; the least of the members."""
    geometries: tuple[LabelGeometry, ...]
    """One per number of samples and copy."""

    @cached_property
    def start(self) -> Indices:
        """(variables + 1,) first label of each variable."""
        return np.searchsorted(self.variable, np.arange(self.variables + 1))

    @cached_property
    def best(self) -> Floats:
        """(variables,) least linear cost of each variable."""
        return np.minimum.reduceat(self.cost, self.start[:-1])

    def active_below(self, cost: float) -> Flags:
        """(n,) the labels that a layout of less than `cost` may use: all others at their cheapest,
        and no overlap."""
        spare = cost - float(self.best.sum()) + ROUNDING * (1.0 + float(np.abs(self.best).sum()))
        return self.cost - self.best[self.variable] <= spare

    def of(self, kept: Indices) -> LabelSet:
        """Some of the labels (ascending), at least one of every variable."""
        number = np.full(len(self.cost), -1, dtype=np.int64)
        number[kept] = np.arange(len(kept))
        geometries = []
        for each in self.geometries:
            at = np.flatnonzero(number[each.owner] >= 0)
            geometries.append(each.of(at, number[each.owner[at]]))
        variable, candidate, cost = self.variable[kept], self.candidate[kept], self.cost[kept]
        return LabelSet(self.variables, variable, candidate, cost, tuple(geometries))


def all_labels(problem: LayoutProblem) -> LabelSet:
    """Every label of the problem that the board does not dominate.

    A candidate that costs no less than the board can always be replaced by that, whose pair costs
    are zero.  Of candidates that are equal in all that costs anything only the first is a label:
    which of them is chosen does not depend on the search.
    """
    explicit = {end for each in problem.extra for end in (each.first, each.second)}
    kept = [_kept(each, at not in explicit) for at, each in enumerate(problem.variables)]
    variable = np.repeat(np.arange(len(kept)), [*map(len, kept)])
    candidate = np.concatenate([np.empty(0, dtype=np.int64), *kept])
    costs = [
        np.append(each.cost, each.off_face_cost)[labels]
        for each, labels in zip(problem.variables, kept, strict=True)
    ]
    geometries = _geometries(problem, variable, candidate)
    cost = np.concatenate([np.empty(0), *costs])
    return LabelSet(len(kept), variable, candidate, cost, geometries)


def _kept(variable: Variable, first_of_equals: bool) -> Indices:
    """The candidates of a variable that may be in a best layout, the board last."""
    kept = np.flatnonzero(variable.cost < variable.off_face_cost)
    _, which, times = np.unique(variable.cost[kept], return_inverse=True, return_counts=True)
    alike = kept[times[which] > 1]  # few, and rows are dear to compare
    if first_of_equals and len(alike):
        fields = (variable.cost, variable.samples, variable.handles)
        rows = np.hstack([each[alike].reshape(len(alike), -1) for each in fields])
        first = np.unique(rows, axis=0, return_index=True)[1]
        kept = np.setdiff1d(kept, np.delete(alike, first))
    return np.append(kept, -1) if np.isfinite(variable.off_face_cost) else kept


def _geometries(
    problem: LayoutProblem, variable: Indices, candidate: Indices
) -> tuple[LabelGeometry, ...]:
    """Geometries of the labels, one set per number of samples and copy."""
    groups: dict[tuple[int, int], list[int]] = {}
    for index, each in enumerate(problem.variables):
        for copy in range(each.samples.shape[1]):
            groups.setdefault((each.samples.shape[2], copy), []).append(index)
    found = []
    for (count, copy), members in sorted(groups.items()):
        owner = np.flatnonzero(np.isin(variable, members) & (candidate >= 0))
        mine = [(problem.variables[at], candidate[owner[variable[owner] == at]]) for at in members]
        samples = np.concatenate([each.samples[labels, copy] for each, labels in mine])
        handles = np.concatenate([each.handles[labels, copy] for each, labels in mine])
        positions = np.ascontiguousarray(np.moveaxis(samples, 0, -1), dtype=np.float64)
        handle = np.ascontiguousarray(handles.T, dtype=np.float64)
        exact = np.zeros((count, len(owner)))
        found.append(LabelGeometry(owner, positions, exact, handle, np.zeros(len(owner))))
    return tuple(found)


def bounding(geometry: LabelGeometry, place: Indices, block: Indices) -> LabelGeometry:
    """Centres and radii of blocks: `place` (n,) tells the geometry of each member, or -1, `block`
    (n,) its block, ascending."""
    block, place = block[place >= 0], place[place >= 0]
    first = np.flatnonzero(np.diff(block, prepend=-1))
    sizes = np.diff(np.append(first, len(block)))
    if not len(first):
        return geometry.of(place, block)
    samples, handles = geometry.samples[:, :, place], geometry.handle[:, place]
    centre, handle = _box_middle(samples, first), _box_middle(handles, first)
    apart = np.sqrt(np.square(samples - np.repeat(centre, sizes, axis=-1)).sum(axis=1))
    handle_apart = np.sqrt(squared(handles, np.repeat(handle, sizes, axis=-1)))
    most = np.maximum.reduceat(apart, first, axis=-1)
    handle_most = np.maximum.reduceat(handle_apart, first)
    return LabelGeometry(block[first], centre, most, handle, handle_most)


def _box_middle(positions: Floats, first: Indices) -> Floats:
    """Middles of the boxes around groups of positions along the last axis."""
    low = np.minimum.reduceat(positions, first, axis=-1)
    return (low + np.maximum.reduceat(positions, first, axis=-1)) / 2


# --- pairs ----------------------------------------------------------------------------------------


def meeting(
    one: LabelGeometry, i: Indices, other: LabelGeometry, j: Indices | slice, problem: LayoutProblem
) -> Flags:
    """Whether members of geometries ``i`` of `one` and ``j`` of `other`, broadcast, may interact:
    balls around what is drawn of each come within reach of the overlap or of the separation."""
    limit = one.extent[i] + other.extent[j] + max(problem.overlap.reach, problem.separation)
    return squared(one.middle[:, i], other.middle[:, j]) < np.square(limit)


def pair_bounds(
    one: LabelGeometry, i: Indices, other: LabelGeometry, j: Indices, problem: LayoutProblem
) -> tuple[Floats, Flags]:
    """Least cost of pairs of members of geometries ``i[q]`` of `one` and ``j[q]`` of `other`; `i`
    may be (1,), one against all.

    Returns the costs, +inf where all members' handles are nearer than the separation, and whether
    any members can interact at all.  Exact for blocks of one label.
    """
    costs, near = np.empty(len(j)), np.empty(len(j), dtype=bool)
    first = np.broadcast_to(i, j.shape)
    at_once = max(1, CHUNK // max(1, len(one.samples), len(other.samples)))
    for low in range(0, len(j), at_once):
        part = slice(low, low + at_once)
        costs[part], near[part] = least_costs(
            one.drawn(first[part]), other.drawn(j[part]), problem.overlap, problem.separation
        )
    return costs, near


def squared(a: Floats, b: Floats) -> Floats:
    """Squared distances of (d, ...) positions."""
    total: Floats = np.square(a[0] - b[0])
    for first, second in zip(a[1:], b[1:], strict=True):
        total += np.square(first - second)
    return total
