"""Labels as arrays: what they cost, and where their elements are.

A *label* is a candidate of a variable, or the board, numbered through the whole problem.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from usdrigui.character import Floats, Indices, Record
from usdrigui.model import LayoutProblem, Variable
from usdrigui.overlap import ROUNDING, Drawn


class LabelGeometry(Record):
    """One copy of the elements of labels that have the same number of samples.

    Scene units.
    """

    owner: Indices
    """(n,) label, ascending."""
    samples: Floats
    """(u, d, n) positions along the drawn element."""
    handle: Floats
    """(d, n), or (3, n): see `Drawn`."""

    @cached_property
    def middle(self) -> Floats:
        """(d, n) mean of the samples."""
        return self.samples.mean(axis=0) if len(self.samples) else self.handle

    @cached_property
    def extent(self) -> Floats:
        """(n,) radius of a ball around `middle` that holds all samples and the handle."""
        of_samples = np.sqrt(np.square(self.samples - self.middle).sum(axis=1))
        of_handle = np.sqrt(squared(self.handle[: len(self.middle)], self.middle))
        most = np.maximum(of_samples.max(axis=0, initial=0.0), of_handle)
        return np.asarray(most * (1.0 + ROUNDING))

    def drawn(self, at: Indices) -> Drawn:
        """Geometries `at` as drawn."""
        return Drawn(self.samples, self.handle).of(at)

    def of(self, kept: Indices, owner: Indices) -> LabelGeometry:
        """Some of the geometries, of other owners."""
        some = self.drawn(kept)
        return LabelGeometry(owner, some.samples, some.handle)


class LabelSet(Record):
    """Labels of all variables; those on the board have no geometry."""

    variables: int
    """How many; each has a label."""
    variable: Indices
    """(n,) ascending."""
    candidate: Indices
    """(n,) which candidate of the variable, -1 for the board."""
    cost: Floats
    """(n,) linear cost."""
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
    for (_, copy), members in sorted(groups.items()):
        owner = np.flatnonzero(np.isin(variable, members) & (candidate >= 0))
        mine = [(problem.variables[at], candidate[owner[variable[owner] == at]]) for at in members]
        samples = np.concatenate([each.samples[labels, copy] for each, labels in mine])
        handles = np.concatenate([each.handles[labels, copy] for each, labels in mine])
        positions = np.ascontiguousarray(np.moveaxis(samples, 0, -1))
        found.append(LabelGeometry(owner, positions, np.ascontiguousarray(handles.T)))
    return tuple(found)


def squared(a: Floats, b: Floats) -> Floats:
    """Squared distances of (d, ...) positions."""
    total: Floats = np.square(a[0] - b[0])
    for first, second in zip(a[1:], b[1:], strict=True):
        total += np.square(first - second)
    return total
