"""The overlap of elements: what two of them cost that are in each other's way, and the objective.

There are two measures: what is seen on the screen of the layout's own view (`Overlap`), that is
handles near each other or on a foreign track, and tracks that cross or run along each other; and
the paper's mean distance of two sampled elements (`MeanOverlap`, section 4.1, eq. 1 and 2).

Both the stages that build a `LayoutProblem` and those that solve it ask `drawn_costs`, so that they
agree to the last bit.  numpy only.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike

from usdrigui.character import Flags, Floats, Indices
from usdrigui.model import AnyOverlap, LayoutProblem, MeanOverlap, Overlap

ROUNDING = 1e-12
"""Share of lengths and costs by which rounding may be off: bounds leave so much room."""
SAME_WAY = float(np.cos(np.pi / 6))
"""Tracks that differ by less than this angle run the same way."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """Elements as drawn, one copy of each, in the coordinates of the overlap: d = 2 on a screen, 3
    in the scene."""

    samples: Floats
    """(u, d, q) positions along the tracks."""
    handle: Floats
    """(d, q), or (3, q) where handles that cover each other on a screen may stand apart in
    depth."""

    @property
    def spot(self) -> Floats:
        """(d, q) the handles, as the tracks are measured."""
        return self.handle[: self.samples.shape[1]]

    @classmethod
    def of_labels(cls, samples: Floats, handles: Floats) -> Drawn:
        """One copy of labels: `samples` (q, u, d), `handles` (q, d)."""
        return cls(samples.transpose(1, 2, 0), handles.T)

    def of(self, rows: Indices) -> Drawn:
        """Some of the elements."""
        return Drawn(*(each.take(rows, axis=-1) for each in (self.samples, self.handle)))


def drawn_costs(one: Drawn, other: Drawn, overlap: AnyOverlap, separation: float) -> Floats:
    """Costs (q,) of the elements `one` and `other`, pair by pair; +inf where the handles are nearer
    than the separation."""
    between = np.sqrt(np.square(one.handle - other.handle).sum(axis=0))
    allowed = between >= separation
    if isinstance(overlap, MeanOverlap):
        costs = overlap.weight * overlap_cost(element_distance(one.samples, other.samples), overlap)
    else:
        costs = _seen_costs(one, other, allowed, overlap)
    costs[~allowed] = np.inf
    return costs


def pair_costs(
    problem: LayoutProblem, a: int, b: int, first: ArrayLike, second: ArrayLike
) -> Floats:
    """Cost of label pairs ``(first[i], second[i])`` of variables `a` and `b`, without `extra`.

    Returns ``(q,)`` costs; +inf where two handles are nearer than the separation, 0 where a label
    is -1 or the two elements are never visible together.
    """
    one, other = np.asarray(first, dtype=np.int64), np.asarray(second, dtype=np.int64)
    cost = np.zeros(len(one))
    if not problem.variables[a].states & problem.variables[b].states:
        return cost
    on_face = np.flatnonzero((one >= 0) & (other >= 0))
    reach = max(problem.overlap.reach, problem.separation)
    first_copies, second_copies = (
        _copies(variable.samples[labels[on_face]], variable.handles[labels[on_face]])
        for variable, labels in ((problem.variables[a], one), (problem.variables[b], other))
    )
    for mine in first_copies:
        for theirs in second_copies:
            near = np.flatnonzero(_boxes_meet(mine, theirs, reach))
            if len(near):
                cost[on_face[near]] += drawn_costs(
                    mine.of(near), theirs.of(near), problem.overlap, problem.separation
                )
    return cost


def own_costs(samples: Floats, handles: Floats, overlap: AnyOverlap, separation: float) -> Floats:
    """What elements cost by how they are drawn, to be part of their linear cost: the overlap with
    their own mirror images, and tracks too short to be seen.

    `samples` (R, copies, u, d), `handles` (R, copies, d or 3).  Returns ``(R,)`` costs, +inf
    where two copies' handles are nearer than the separation: such a candidate must be dropped.
    """
    copies = _copies(samples, handles)
    cost = np.zeros(len(samples))
    for i, one in enumerate(copies):
        cost += short_costs(one, overlap)
        for other in copies[i + 1 :]:
            cost += drawn_costs(one, other, overlap, separation)
    return cost


def short_costs(drawn: Drawn, overlap: AnyOverlap) -> Floats:
    """(q,) what it costs that the longest track of an element is too short for a hand."""
    if isinstance(overlap, MeanOverlap):
        return np.zeros(drawn.handle.shape[1])
    starts, ends = _segments(drawn.samples, overlap.samples)
    steps = np.sqrt(np.square(ends - starts).sum(axis=1))
    count = len(drawn.samples) // overlap.samples
    tracks = steps.reshape(count, overlap.samples - 1, steps.shape[1]).sum(axis=1)
    return overlap.short * _hinge(tracks.max(axis=0), overlap.handle_width)


def total_cost(problem: LayoutProblem, labels: ArrayLike) -> float:
    """Value of the objective for one label per variable; +inf if the labels are not allowed."""
    chosen = np.asarray(labels, dtype=np.int64)
    cost = sum(
        variable.off_face_cost if label < 0 else float(variable.cost[label])
        for variable, label in zip(problem.variables, chosen, strict=True)
    )
    for a, b in combinations(range(len(chosen)), 2):
        cost += float(pair_costs(problem, a, b, chosen[[a]], chosen[[b]])[0])
    for extra in problem.extra:
        hit = (extra.first_labels == chosen[extra.first]) & (
            extra.second_labels == chosen[extra.second]
        )
        cost += float(extra.costs[hit].sum())
    return float(cost)


def _copies(samples: Floats, handles: Floats) -> list[Drawn]:
    """Every copy of labels: `samples` (R, copies, u, d), `handles` (R, copies, d)."""
    return [Drawn.of_labels(samples[:, i], handles[:, i]) for i in range(samples.shape[1])]


# --- as it is seen --------------------------------------------------------------------------------


def _seen_costs(one: Drawn, other: Drawn, allowed: Flags, overlap: Overlap) -> Floats:
    """Handles near each other, and of pairs that are `allowed` a handle on the other's track,
    tracks that cross or run along."""
    between = np.sqrt(np.square(one.spot - other.spot).sum(axis=0))
    cost = overlap.near * _hinge(between, overlap.near_radius)
    if overlap.room:
        cost += overlap.room * _hinge(between, overlap.room_radius)
    radius = max(overlap.track_radius, overlap.along_radius)
    met = np.flatnonzero(allowed & _boxes_meet(one, other, radius))
    first, second = one.of(met), other.of(met)
    for track, handle in ((first, second), (second, first)):
        starts, ends = _segments(track.samples, overlap.samples)
        gap = segment_distances(handle.spot[None], starts, ends).min(axis=0)
        cost[met] += overlap.on_track * _hinge(gap, overlap.track_radius)
    if len(one.spot) == 2:
        cost[met] += _track_costs(first, second, overlap)
    return cost


def _boxes_meet(one: Drawn, other: Drawn, margin: float) -> Flags:
    """(q,) whether the boxes around what is drawn of two elements come within the margin."""
    (low, high), (other_low, other_high) = (
        (
            np.minimum(each.samples.min(axis=0), each.spot),
            np.maximum(each.samples.max(axis=0), each.spot),
        )
        for each in (one, other)
    )
    return np.asarray((np.maximum(low - other_high, other_low - high) <= margin).all(axis=0))


def _track_costs(first: Drawn, second: Drawn, overlap: Overlap) -> Floats:
    """(q,) what tracks on a screen cost that cross, or run along each other."""
    cost = np.zeros(first.handle.shape[1])
    met = np.flatnonzero(_boxes_meet(first, second, overlap.along_radius))
    one, other = (_segments(each.of(met).samples, overlap.samples) for each in (first, second))
    crossing = segments_cross(*(end[:, None] for end in one), *(end[None] for end in other))
    cost[met] = overlap.crossing * crossing.any(axis=(0, 1))
    alike = _alike(one[1] - one[0], other[1] - other[0])
    rows = np.flatnonzero(alike.any(axis=(0, 1)))
    alike = alike.take(rows, axis=-1)
    mine, theirs = (
        _segments(each.of(met[rows]).samples, overlap.samples) for each in (first, second)
    )
    along = _along(*mine, *theirs, alike, overlap.along_radius)
    along += _along(*theirs, *mine, alike.swapaxes(0, 1), overlap.along_radius)
    cost[met[rows]] += overlap.along * along
    return cost


def _hinge(distance: Floats, radius: float) -> Floats:
    return np.maximum(1.0 - distance / radius, 0.0)


def _segments(samples: Floats, each: int) -> tuple[Floats, Floats]:
    """(segments, d, q) starts and ends of the pieces of tracks of `each` samples."""
    starts = np.flatnonzero((np.arange(len(samples)) + 1) % each)
    return samples[starts], samples[starts + 1]


def segment_distances(points: Floats, starts: Floats, ends: Floats) -> Floats:
    """(..., q) distances of points (..., d, q) from segments (..., d, q), broadcast."""
    steps = ends - starts
    from_start = points - starts
    share = np.clip(_dot(from_start, steps) / np.maximum(_dot(steps, steps), 1e-300), 0.0, 1.0)
    aside = from_start - share[..., None, :] * steps
    return np.sqrt(_dot(aside, aside))


def _dot(first: Floats, second: Floats) -> Floats:
    """(..., q) inner products of vectors (..., d, q): numpy sums over a short axis slowly."""
    total = first[..., 0, :] * second[..., 0, :]
    for axis in range(1, first.shape[-2]):
        total += first[..., axis, :] * second[..., axis, :]
    return total


def segments_cross(a: Floats, b: Floats, c: Floats, d: Floats) -> Flags:
    """(...) whether segments from `a` (..., 2, q) to `b` properly cross those from `c` to `d`,
    broadcast."""
    return (_turn(a, b, c) * _turn(a, b, d) < 0.0) & (_turn(c, d, a) * _turn(c, d, b) < 0.0)


def _turn(a: Floats, b: Floats, c: Floats) -> Floats:
    """Twice the signed area of triangles on a screen."""
    (along_x, along_y), (aside_x, aside_y) = (np.moveaxis(end - a, -2, 0) for end in (b, c))
    return np.asarray(along_x * aside_y - along_y * aside_x)


def _alike(one: Floats, other: Floats) -> Flags:
    """(a, b, q) which steps (a, d, q) run the same way as which of (b, d, q)."""
    lengths, other_lengths = (np.sqrt(_dot(each, each)) for each in (one, other))
    return np.abs(_dot(one[:, None], other)) >= SAME_WAY * lengths[:, None] * other_lengths


def _along(
    starts: Floats,
    ends: Floats,
    other_starts: Floats,
    other_ends: Floats,
    alike: Flags,
    radius: float,
) -> Floats:
    """(q,) share of the segments whose middles lie near one of the others that is `alike`
    (segments, others, q)."""
    middles = 0.5 * (starts + ends)
    gaps = segment_distances(middles[:, None], other_starts, other_ends)
    nearest = np.where(alike, gaps, np.inf).min(axis=1)
    return np.asarray(_hinge(nearest, radius).sum(axis=0) / len(alike))


# --- the paper's ----------------------------------------------------------------------------------


def overlap_cost(distance: ArrayLike, overlap: MeanOverlap) -> Floats:
    """phi(distance): the unweighted cost of two elements at that distance, in [0, maximum].

    Eq. 1 as printed grows with distance; this is the decreasing sigmoid that its text describes,
    lowered and cut so that it vanishes from `MeanOverlap.cutoff_distance` on.
    """
    z: Floats = np.asarray(distance, dtype=np.float64)
    value: Floats = overlap.maximum * _fall(z, overlap)
    if np.isfinite(overlap.cutoff_distance):
        value = value - overlap.maximum * float(_fall(np.array(overlap.cutoff_distance), overlap))
        value = np.where(z < overlap.cutoff_distance, np.maximum(value, 0.0), 0.0)
    return np.asarray(value)


def element_distance(first: Floats, second: Floats) -> Floats:
    """(q,) mean, over both sample sets, of the distance to the nearest sample of the other set.

    `first` (u, d, q), `second` (v, d, q): positions (paper section 4.1, dist(x_r, x_s)).
    """
    square = np.square(first[:, None] - second[None]).sum(axis=2)
    nearest = np.sqrt(square.min(axis=0)).sum(axis=0) + np.sqrt(square.min(axis=1)).sum(axis=0)
    return np.asarray(nearest / (len(first) + len(second)))


def _fall(z: Floats, overlap: MeanOverlap) -> Floats:
    """1 / (1 + exp(sharpness (z - radius))), without overflow."""
    return 0.5 * (1.0 - np.tanh(0.5 * overlap.sharpness * (z - overlap.radius)))
