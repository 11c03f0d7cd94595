"""Candidates as arrays: the label_set of labels, and blocks of neighbouring labels bounded as one.

A *label* here is one candidate of one variable, numbered through the whole problem.  A *block* is a
set of labels of one variable that are treated as one: its cost is the least of theirs and its
geometry a centre with radii, from which the distance of any two members of two blocks is bounded
from above.  A block of one label has radius zero, so blocks and single candidates go through the
same code.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from usdrigui.model import Flags, Floats, Indices, LayoutProblem, Overlap, Record, Variable
from usdrigui.overlap import overlap_cost

CHUNK = 32768
"""Pairs of elements, or distances of samples, worked out at a time: they stay in the processor's
cache."""
ROUNDING = 1e-12
"""Share of costs and lengths by which rounding may be off: bounds leave so much room, exact ones
none."""
ALL = slice(None)
"""As indices of geometries: every one."""


@dataclass(frozen=True, eq=False)
class LabelGeometry(Record):
    """One copy of the elements of many labels (or blocks), all with the same number of samples.

    Scene units.
    """

    owner: Indices
    """(n,) label or block, ascending."""
    samples: Floats
    """(u, 3, n) positions along the drawn element; for blocks of their centres."""
    apart: Floats
    """(2, n) mean and maximum, over the samples, of how far a member's sample is from the centre's
    at most."""
    handle: Floats
    """(3, n)."""
    handle_slack: Floats
    """(n,) largest distance of a member's handle from `handle`."""
    middle: Floats
    """(3, n) mean of the samples."""
    radius: Floats
    """(2, n) mean and maximum distance of the samples of all members from `middle`."""
    handle_radius: Floats
    """(n,) largest distance of a member's handle from `middle`."""

    def of(self, kept: Indices, number: Indices) -> LabelGeometry:
        """Some of the geometries, their owners renumbered."""
        return LabelGeometry(
            number[self.owner[kept]],
            self.samples[:, :, kept],
            self.apart[:, kept],
            self.handle[:, kept],
            self.handle_slack[kept],
            self.middle[:, kept],
            self.radius[:, kept],
            self.handle_radius[kept],
        )

    def slack(self, at: Indices | slice, samples: int) -> Floats:
        """(q,) largest change of the distance to an element of so many samples when a member
        replaces the centre of geometries `at`.

        Moving each sample by at most its own amount changes the sum over this element's samples by
        no more than the sum of the amounts, and each of the other's nearest distances by no more
        than the largest.
        """
        return self._weighed(self.apart[:, at], samples)

    def extent(
        self, at: Indices | slice, other: LabelGeometry, reach: float, separation: float
    ) -> Floats:
        """(q,) such that members of two geometries interact only if the distance of the middles is
        below the sum of both geometries' extents and the larger of `reach` and `separation`.

        The distance of two samples is at least that of the middles less what each is off its own;
        averaged over the nearest ones, the mean of these counts for the own samples and the maximum
        for the other's.
        """
        radius, handle_radius = (
            self._weighed(self.radius[:, at], len(other.samples)),
            self.handle_radius[at],
        )
        of_samples = radius - max(0.0, separation - reach) / 2
        extent = np.maximum(of_samples, handle_radius - max(0.0, reach - separation) / 2)
        return np.asarray(extent + ROUNDING * (radius + handle_radius + max(reach, separation)))

    def _weighed(self, mean_and_most: Floats, samples: int) -> Floats:
        own = len(self.samples)
        return np.asarray(
            (own * mean_and_most[0] + samples * mean_and_most[1]) / max(own + samples, 1)
        )


@dataclass(frozen=True, eq=False)
class LabelSet(Record):
    """Labels or blocks of all variables, sorted by variable; those on the board have no
    geometry."""

    count: int
    """Number of variables."""
    variable: Indices
    """(n,) ascending."""
    start: Indices
    """(count + 1,) first entry of each variable."""
    cost: Floats
    """(n,) linear cost; the least of the members."""
    geometries: tuple[LabelGeometry, ...]
    """One per number of samples and copy."""


@dataclass(frozen=True, eq=False)
class Labels(Record):
    """The labels of a problem that can be part of a best solution, before any search."""

    label_set: LabelSet
    label: Indices
    """(n,) index into the variable's candidates, or -1 for on the board."""
    best: Floats
    """(count,) least linear cost of each variable."""


@dataclass(frozen=True, eq=False)
class Blocks(Record):
    """A partition of some labels of a label_set into blocks."""

    members: Indices
    """(n,) labels, those of one block next to each other."""
    start: Indices
    """(blocks + 1,) first member of each block."""
    variable: Indices
    """(blocks,) ascending."""

    @property
    def sizes(self) -> Indices:
        """(blocks,) number of members."""
        return np.diff(self.start)


# --- labels ---------------------------------------------------------------------------------------


def all_labels(problem: LayoutProblem) -> Labels:
    """Every label of the problem that the board does not dominate.

    A candidate that costs more than leaving the face can always be replaced by that, whose pair
    costs are zero, so it is in no best solution.  Of candidates that are equal in all that costs
    anything only the first is a label: which of them is chosen does not depend on the search.
    """
    variable, label, cost, best = [], [], [], []
    for index, each in enumerate(problem.variables):
        kept = np.flatnonzero(
            each.cost < each.off_face_cost
        )  # at equal cost, the board is no worse
        explicit = any(index in (extra.first, extra.second) for extra in problem.extra)
        if len(kept) and not explicit:
            kept = kept[_first_of_equals(each, kept)]
        if np.isfinite(each.off_face_cost):
            kept = np.append(kept, -1)
        variable.append(np.full(len(kept), index))
        label.append(kept)
        own = np.where(kept >= 0, each.cost[kept] if len(each.cost) else 0.0, each.off_face_cost)
        cost.append(own)
        best.append(own.min(initial=np.inf))
    none = np.empty(0, dtype=np.int64)
    variables, chosen = np.concatenate([none, *variable]), np.concatenate([none, *label])
    start = np.searchsorted(variables, np.arange(len(problem.variables) + 1))
    geometries = _geometries(problem, chosen, start)
    label_set = LabelSet(
        len(problem.variables), variables, start, np.concatenate([np.empty(0), *cost]), geometries
    )
    return Labels(label_set, chosen, np.array(best))


def _first_of_equals(variable: Variable, labels: Indices) -> Indices:
    """Indices of the labels that no earlier one equals in cost and place: points of coincident
    skins."""
    count = len(labels)
    columns = [
        variable.cost[labels, None],
        variable.samples[labels].reshape(count, -1),
        variable.handles[labels].reshape(count, -1),
    ]
    return np.sort(np.unique(np.concatenate(columns, axis=1), axis=0, return_index=True)[1])


def _geometries(
    problem: LayoutProblem, labels: Indices, start: Indices
) -> tuple[LabelGeometry, ...]:
    """LabelGeometry of the labels, one set per (samples, copy)."""
    groups: dict[tuple[int, int], list[int]] = {}
    for index, each in enumerate(problem.variables):
        for copy in range(each.samples.shape[1]):
            groups.setdefault((each.samples.shape[2], copy), []).append(index)
    found = []
    for (_, copy), members in sorted(groups.items()):
        owner, samples, handles = [], [], []
        for index in members:
            spot = np.arange(start[index], start[index + 1])
            spot = spot[labels[spot] >= 0]
            owner.append(spot)
            samples.append(problem.variables[index].samples[labels[spot], copy])
            handles.append(problem.variables[index].handles[labels[spot], copy])
        found.append(
            _single(np.concatenate(owner), np.concatenate(samples), np.concatenate(handles))
        )
    return tuple(each for each in found if len(each.owner))


def _single(owner: Indices, samples: Floats, handles: Floats) -> LabelGeometry:
    """LabelGeometry without slack from (n, u, 3) samples and (n, 3) handles."""
    positions = np.ascontiguousarray(np.moveaxis(samples, 0, -1), dtype=np.float64)
    handle = np.ascontiguousarray(handles.T, dtype=np.float64)
    return _around(owner, positions, np.zeros(positions.shape[::2]), handle, np.zeros(len(owner)))


def _around(
    owner: Indices, samples: Floats, apart: Floats, handle: Floats, handle_slack: Floats
) -> LabelGeometry:
    """LabelGeometry of (u, 3, n) samples and (3, n) handles, each with the ball that its members
    fill."""
    middle = samples.mean(axis=0) if len(samples) else handle
    far = np.sqrt(np.square(samples - middle).sum(axis=1)) + apart
    handle_radius = np.sqrt(np.square(handle - middle).sum(axis=0)) + handle_slack
    return LabelGeometry(
        owner,
        samples,
        _mean_and_most(apart),
        handle,
        handle_slack,
        middle,
        _mean_and_most(far),
        handle_radius,
    )


def _mean_and_most(values: Floats) -> Floats:
    """(2, n) of (u, n); zeros without values."""
    return np.stack([values.sum(axis=0) / max(len(values), 1), values.max(axis=0, initial=0.0)])


def selected(labels: Labels, kept: Indices) -> Labels:
    """Some of the labels (ascending), at least one of every variable, as a problem of their own."""
    label_set = labels.label_set
    number = np.full(len(label_set.cost), -1, dtype=np.int64)
    number[kept] = np.arange(len(kept))
    variable, cost = label_set.variable[kept], label_set.cost[kept]
    start = np.searchsorted(variable, np.arange(label_set.count + 1))
    geometries = tuple(
        each.of(np.flatnonzero(number[each.owner] >= 0), number) for each in label_set.geometries
    )
    best = np.minimum.reduceat(cost, start[:-1]) if len(cost) else labels.best
    kept_geometries = tuple(each for each in geometries if len(each.owner))
    return Labels(
        LabelSet(label_set.count, variable, start, cost, kept_geometries), labels.label[kept], best
    )


def in_play(labels: Labels, cost: float) -> Indices:
    """The labels that a layout of less than `cost` may use: all others at their cheapest, and no
    overlap."""
    label_set = labels.label_set
    spare = cost - float(labels.best.sum()) + ROUNDING * (1.0 + float(np.abs(labels.best).sum()))
    return np.flatnonzero(label_set.cost - labels.best[label_set.variable] <= spare)


# --- blocks ---------------------------------------------------------------------------------------


def whole(labels: Labels) -> Blocks:
    """One block per variable, with the board as a block of its own."""
    label_set = labels.label_set
    off_face = labels.label < 0
    first = np.ones(len(off_face), dtype=bool)
    first[1:] = (label_set.variable[1:] != label_set.variable[:-1]) | off_face[1:]
    start = np.append(np.flatnonzero(first), len(off_face))
    return Blocks(np.arange(len(off_face)), start, label_set.variable[start[:-1]])


def singles(labels: Labels) -> Blocks:
    """One block per label."""
    count = len(labels.label)
    return Blocks(np.arange(count), np.arange(count + 1), labels.label_set.variable)


def halve(labels: Labels, blocks: Blocks, chosen: Flags) -> tuple[Blocks, Indices]:
    """Cut the chosen blocks of more than one member in two where they are widest.

    Returns the new blocks and, for each, the block it came from.
    """
    cut = chosen & (blocks.sizes > 1)
    group = np.repeat(np.arange(len(cut)), blocks.sizes)
    key = _widest(labels.label_set, blocks, cut)
    order = np.lexsort((blocks.members, key, group))
    half = blocks.start[:-1] + (blocks.sizes + 1) // 2
    start = np.sort(np.concatenate([blocks.start, half[cut]]))
    parent = group[start[:-1]]
    return Blocks(blocks.members[order], start, blocks.variable[parent]), parent


def singled(labels: Labels, blocks: Blocks) -> tuple[Blocks, Indices]:
    """The labels of the blocks one by one, neighbours next to each other; and the block each came
    from."""
    parent = np.arange(len(blocks.variable))
    while blocks.sizes.max(initial=1) > 1:
        blocks, came_from = halve(labels, blocks, blocks.sizes > 1)
        parent = parent[came_from]
    return blocks, parent


def cheapest(labels: Labels, blocks: Blocks) -> Indices:
    """(blocks,) the member of least linear cost of each block."""
    cost = labels.label_set.cost[blocks.members]
    least = np.repeat(np.minimum.reduceat(cost, blocks.start[:-1]), blocks.sizes)
    hit = np.flatnonzero(cost == least)
    owner = np.searchsorted(blocks.start, hit, side="right")
    return blocks.members[hit[np.diff(owner, prepend=0) > 0]]


def thinned(labels: Labels, blocks: Blocks, slack: Floats) -> Blocks:
    """The blocks without the labels that cannot be in a better solution, those left empty left out.

    `slack` (blocks,) is how far the bound of solutions that use the block lies below the cut-off.
    """
    alive = member_slack(labels, blocks, slack) >= 0
    sizes = np.add.reduceat(alive, blocks.start[:-1], dtype=np.int64)
    start = np.concatenate([[0], np.cumsum(sizes[sizes > 0])])
    return Blocks(blocks.members[alive], start, blocks.variable[sizes > 0])


def member_slack(labels: Labels, blocks: Blocks, slack: Floats) -> Floats:
    """(members,) the slack of each member of the blocks, in their order.

    The bound of a block counts the cost of its cheapest member; solutions that use another member
    cost more by what that one costs more, all else being bounded for every member alike.
    """
    cost = labels.label_set.cost[blocks.members]
    more = cost - np.repeat(
        np.minimum.reduceat(cost, blocks.start[:-1]), blocks.sizes
    )  # 0 of the cheapest, exactly
    return np.asarray(np.repeat(slack, blocks.sizes) - more)


def block_set(labels: Labels, blocks: Blocks) -> LabelSet:
    """Cost and bounding geometry of every block."""
    label_set = labels.label_set
    cost = np.minimum.reduceat(label_set.cost[blocks.members], blocks.start[:-1])
    start = np.searchsorted(blocks.variable, np.arange(label_set.count + 1))
    geometries = tuple(
        _bounding(each, blocks, len(label_set.cost)) for each in label_set.geometries
    )
    return LabelSet(label_set.count, blocks.variable, start, cost, geometries)


def _places(geometry: LabelGeometry, labels: int) -> Indices:
    """(labels,) position of each label's geometry in `geometry`, or -1."""
    place = np.full(labels, -1, dtype=np.int64)
    place[geometry.owner] = np.arange(len(geometry.owner))
    return place


def _bounding(geometry: LabelGeometry, blocks: Blocks, labels: int) -> LabelGeometry:
    """Centres and radii of the blocks' members in one set of geometries."""
    place = _places(geometry, labels)[blocks.members]
    placed = place >= 0
    group = np.repeat(np.arange(len(blocks.variable)), blocks.sizes)[placed]
    place = place[placed]
    if not len(place):
        return _single(group, np.empty((0, len(geometry.samples), 3)), np.empty((0, 3)))
    first = np.flatnonzero(np.diff(group, prepend=-1))
    owner, sizes = group[first], np.diff(np.append(first, len(group)))
    samples = geometry.samples[:, :, place]
    centre = _box_middle(samples, first)
    apart = np.sqrt(np.square(samples - np.repeat(centre, sizes, axis=-1)).sum(axis=1))
    apart = np.maximum.reduceat(apart, first, axis=-1)
    handles = geometry.handle[:, place]
    handle = _box_middle(handles, first)
    off = np.sqrt(np.square(handles - np.repeat(handle, sizes, axis=-1)).sum(axis=0))
    return _around(owner, centre, apart, handle, np.maximum.reduceat(off, first))


def _box_middle(positions: Floats, first: Indices) -> Floats:
    """Middles of the boxes around groups of positions along the last axis."""
    low = np.minimum.reduceat(positions, first, axis=-1)
    return np.asarray((low + np.maximum.reduceat(positions, first, axis=-1)) / 2)


def _widest(label_set: LabelSet, blocks: Blocks, cut: Flags) -> Floats:
    """(members,) coordinate along the widest direction of each block to cut; 0 in the others."""
    key = np.zeros(len(blocks.members))
    group = np.repeat(np.arange(len(cut)), blocks.sizes)
    place_of = [_places(each, len(label_set.cost)) for each in label_set.geometries]
    pending = cut.copy()
    for geometry, places in zip(label_set.geometries, place_of, strict=True):
        place = places[blocks.members]
        chosen = (place >= 0) & pending[group]
        if not chosen.any():
            continue
        owner = group[chosen]
        first = np.flatnonzero(np.diff(owner, prepend=-1))
        sizes = np.diff(np.append(first, len(owner)))
        values = geometry.samples[:, :, place[chosen]].reshape(-1, len(owner))
        width = np.maximum.reduceat(values, first, axis=-1) - np.minimum.reduceat(
            values, first, axis=-1
        )
        axis = np.repeat(width.argmax(axis=0), sizes)
        key[chosen] = values[axis, np.arange(len(owner))]
        pending[owner] = False
    return key


# --- pairs ----------------------------------------------------------------------------------------


def near_pairs(
    one: LabelGeometry, first: slice, other: LabelGeometry, reach: float, extra: float
) -> tuple[Indices, Indices]:
    """Pairs of geometries (of ``one[first]`` and of `other`) that may be nearer than `reach`, or
    whose handles may be nearer than `extra`; indices into the two sets, in order."""
    limit = (
        one.extent(first, other, reach, extra)[:, None]
        + other.extent(ALL, one, reach, extra)
        + max(reach, extra)
    )
    apart = squared(one.middle[:, first, None], other.middle[:, None, :])
    rows, columns = np.nonzero(apart < np.square(limit))
    return rows + first.start, columns


def pair_bounds(
    one: LabelGeometry,
    i: Indices,
    other: LabelGeometry,
    j: Indices,
    overlap: Overlap,
    separation: float,
) -> tuple[Floats, Flags]:
    """Least overlap cost between members of geometry ``i[q]`` of `one` and ``j[q]`` of `other`.

    Returns the costs, +inf where all members' handles are nearer than the separation, and whether
    any members can interact at all.  Exact for blocks of one label.
    """
    cost, near = np.zeros(len(i)), np.zeros(len(i), dtype=bool)
    for at in range(0, len(i), CHUNK):
        p, q = i[at : at + CHUNK], j[at : at + CHUNK]
        extents = one.extent(p, other, overlap.reach, separation) + other.extent(
            q, one, overlap.reach, separation
        )
        limit = extents + max(overlap.reach, separation)
        close = np.flatnonzero(squared(one.middle[:, p], other.middle[:, q]) < np.square(limit))
        cost[at + close], near[at + close] = close_bounds(
            one, p[close], other, q[close], overlap, separation
        )
    return cost, near


def close_bounds(
    one: LabelGeometry,
    p: Indices,
    other: LabelGeometry,
    q: Indices,
    overlap: Overlap,
    separation: float,
) -> tuple[Floats, Flags]:
    """`pair_bounds` of geometries whose extents meet."""
    apart = sample_distance(one.samples, p, other.samples, q)
    slack = one.slack(p, len(other.samples)) + other.slack(q, len(one.samples))
    between = np.sqrt(squared(one.handle[:, p], other.handle[:, q]))
    handle_slack = one.handle_slack[p] + other.handle_slack[q]
    cost = overlap.weight * overlap_cost(apart + slack, overlap)
    # Members at the separation exactly, as on a grid, are allowed: a bound must not fall short of
    # it by rounding.
    off = np.where(handle_slack > 0, ROUNDING * (between + handle_slack), 0.0)
    cost[between + handle_slack + off < separation] = np.inf
    near = (apart - slack < overlap.reach) | (between - handle_slack - off < separation)
    return cost, near


def squared(a: Floats, b: Floats) -> Floats:
    """Squared distances of (3, ...) positions."""
    total: Floats = np.square(a[0] - b[0])
    total += np.square(a[1] - b[1])
    total += np.square(a[2] - b[2])
    return total


def sample_distance(
    a: NDArray[np.float64], p: Indices, b: NDArray[np.float64], q: Indices
) -> Floats:
    """`overlap.element_distance` of pairs of elements stored as (u, 3, n) and (v, 3, m) arrays."""
    found = np.empty(len(p))
    at_once = max(1, CHUNK // max(1, len(a) * len(b)))
    buffers = np.empty((2, len(a), len(b), min(at_once, len(p))))
    for at in range(0, len(p), at_once):
        part = slice(at, at + at_once)
        left, right = a[:, None, :, p[part]], b[None, :, :, q[part]]
        square, along = buffers[..., : left.shape[-1]]
        np.subtract(left[:, :, 0], right[:, :, 0], out=square)
        np.multiply(square, square, out=square)
        for axis in (1, 2):
            np.subtract(left[:, :, axis], right[:, :, axis], out=along)
            np.multiply(along, along, out=along)
            np.add(square, along, out=square)
        nearest = np.sqrt(square.min(axis=0)).sum(axis=0) + np.sqrt(square.min(axis=1)).sum(axis=0)
        found[part] = nearest / (len(a) + len(b))
    return found
