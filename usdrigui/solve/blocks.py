"""Candidates as arrays: the pool of labels, and blocks of neighbouring labels bounded as one.

A *label* here is one candidate of one variable, numbered through the whole problem.  A *block* is a set
of labels of one variable that are treated as one: its cost is the least of theirs and its geometry a
centre with radii, from which the distance of any two members of two blocks is bounded from above.  A
block of one label has radius zero, so blocks and single candidates go through the same code.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from usdrigui.model import Flags, Floats, Indices, LayoutProblem, Overlap, Record
from usdrigui.overlap import overlap_cost

CHUNK = 4096
"""Pairs whose distance is worked out at a time: the buffers stay in the processor's cache."""


@dataclass(frozen=True, eq=False)
class Bodies(Record):
    """One copy of the elements of many labels (or blocks), all with the same number of samples.

    Scene units.
    """

    owner: Indices
    """(n,) label or block, ascending."""
    samples: Floats
    """(u, 3, n) positions along the drawn element; for blocks of their centres."""
    slack: Floats
    """(n,) largest change of the element distance when a member replaces the centre."""
    handle: Floats
    """(3, n)."""
    handle_slack: Floats
    """(n,) largest distance of a member's handle from `handle`."""
    middle: Floats
    """(3, n) mean of the samples."""
    radius: Floats
    """(n,) of a ball around `middle` that holds the samples and handles of all members."""


@dataclass(frozen=True, eq=False)
class Pool(Record):
    """Labels or blocks of all variables, sorted by variable; those beside the face have no body."""

    count: int
    """Number of variables."""
    variable: Indices
    """(n,) ascending."""
    start: Indices
    """(count + 1,) first entry of each variable."""
    cost: Floats
    """(n,) linear cost; the least of the members."""
    bodies: tuple[Bodies, ...]
    """One per number of samples and copy."""


@dataclass(frozen=True, eq=False)
class Labels(Record):
    """The labels of a problem that can be part of a best solution, before any search."""

    pool: Pool
    label: Indices
    """(n,) index into the variable's candidates, or -1 for beside the face."""
    best: Floats
    """(count,) least linear cost of each variable."""


@dataclass(frozen=True, eq=False)
class Blocks(Record):
    """A partition of some labels of a pool into blocks."""

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


# --- labels ------------------------------------------------------------------------------------------


def all_labels(problem: LayoutProblem) -> Labels:
    """Every label of the problem that *beside the face* does not dominate.

    A candidate that costs more than leaving the face can always be replaced by that, whose pair costs are
    zero, so it is in no best solution.
    """
    variable, label, cost, best = [], [], [], []
    for index, each in enumerate(problem.variables):
        kept = np.flatnonzero(each.cost < each.beside)  # at equal cost, beside the face is no worse
        if np.isfinite(each.beside):
            kept = np.append(kept, -1)
        variable.append(np.full(len(kept), index))
        label.append(kept)
        own = np.where(kept >= 0, each.cost[kept] if len(each.cost) else 0.0, each.beside)
        cost.append(own)
        best.append(own.min(initial=np.inf))
    none = np.empty(0, dtype=np.int64)
    variables, chosen = np.concatenate([none, *variable]), np.concatenate([none, *label])
    start = np.searchsorted(variables, np.arange(len(problem.variables) + 1))
    bodies = _bodies(problem, chosen, start)
    pool = Pool(len(problem.variables), variables, start, np.concatenate([np.empty(0), *cost]), bodies)
    return Labels(pool, chosen, np.array(best))


def _bodies(problem: LayoutProblem, labels: Indices, start: Indices) -> tuple[Bodies, ...]:
    """Bodies of the labels, one set per (samples, copy)."""
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
        found.append(_single(np.concatenate(owner), np.concatenate(samples), np.concatenate(handles)))
    return tuple(each for each in found if len(each.owner))


def _single(owner: Indices, samples: Floats, handles: Floats) -> Bodies:
    """Bodies without slack from (n, u, 3) samples and (n, 3) handles."""
    positions = np.ascontiguousarray(np.moveaxis(samples, 0, -1), dtype=np.float64)
    handle = np.ascontiguousarray(handles.T, dtype=np.float64)
    none = np.zeros(len(owner))
    centre, radius = _ball(positions, np.zeros(positions.shape[::2]), handle, none)
    return Bodies(owner, positions, none, handle, none, centre, radius)


def _ball(samples: Floats, around: Floats, handle: Floats, handle_around: Floats) -> tuple[Floats, Floats]:
    """Middle (3, n) and radius (n,) of a ball around (u, 3, n) samples and (3, n) handles, each with the
    ball that its members fill."""
    centre = samples.mean(axis=0) if len(samples) else handle
    far = np.linalg.norm(samples - centre, axis=1) + around
    far_handle = np.linalg.norm(handle - centre, axis=0) + handle_around
    return centre, np.maximum(far.max(axis=0, initial=0.0), far_handle)


# --- blocks ------------------------------------------------------------------------------------------


def whole(labels: Labels) -> Blocks:
    """One block per variable, with *beside the face* as a block of its own."""
    pool = labels.pool
    beside = labels.label < 0
    first = np.ones(len(beside), dtype=bool)
    first[1:] = (pool.variable[1:] != pool.variable[:-1]) | beside[1:]
    start = np.append(np.flatnonzero(first), len(beside))
    return Blocks(np.arange(len(beside)), start, pool.variable[start[:-1]])


def singles(labels: Labels) -> Blocks:
    """One block per label."""
    count = len(labels.label)
    return Blocks(np.arange(count), np.arange(count + 1), labels.pool.variable)


def halve(labels: Labels, blocks: Blocks, chosen: Flags) -> tuple[Blocks, Indices]:
    """Cut the chosen blocks of more than one member in two where they are widest.

    Returns the new blocks and, for each, the block it came from.
    """
    cut = chosen & (blocks.sizes > 1)
    group = np.repeat(np.arange(len(cut)), blocks.sizes)
    key = _widest(labels.pool, blocks, cut)
    order = np.lexsort((blocks.members, key, group))
    half = blocks.start[:-1] + (blocks.sizes + 1) // 2
    start = np.sort(np.concatenate([blocks.start, half[cut]]))
    parent = group[start[:-1]]
    return Blocks(blocks.members[order], start, blocks.variable[parent]), parent


def singled(labels: Labels, blocks: Blocks) -> tuple[Blocks, Indices]:
    """The labels of the blocks one by one, neighbours next to each other; and the block each came from."""
    parent = np.arange(len(blocks.variable))
    while blocks.sizes.max(initial=1) > 1:
        blocks, came_from = halve(labels, blocks, blocks.sizes > 1)
        parent = parent[came_from]
    return blocks, parent


def keep(blocks: Blocks, alive: Flags) -> Blocks:
    """The blocks that are alive."""
    members = blocks.members[np.repeat(alive, blocks.sizes)]
    start = np.concatenate([[0], np.cumsum(blocks.sizes[alive])])
    return Blocks(members, start, blocks.variable[alive])


def block_pool(labels: Labels, blocks: Blocks) -> Pool:
    """Cost and bounding geometry of every block."""
    pool = labels.pool
    cost = np.minimum.reduceat(pool.cost[blocks.members], blocks.start[:-1])
    start = np.searchsorted(blocks.variable, np.arange(pool.count + 1))
    most = max((len(each.samples) for each in pool.bodies), default=1)
    bodies = tuple(_bounding(each, blocks, len(pool.cost), most) for each in pool.bodies)
    return Pool(pool.count, blocks.variable, start, cost, bodies)


def _places(body: Bodies, labels: int) -> Indices:
    """(labels,) position of each label's body in `body`, or -1."""
    place = np.full(labels, -1, dtype=np.int64)
    place[body.owner] = np.arange(len(body.owner))
    return place


def _bounding(body: Bodies, blocks: Blocks, labels: int, most: int) -> Bodies:
    """Centres and radii of the blocks' members in one set of bodies; `most` is the largest number of samples."""
    place = _places(body, labels)[blocks.members]
    with_body = place >= 0
    group = np.repeat(np.arange(len(blocks.variable)), blocks.sizes)[with_body]
    place = place[with_body]
    if not len(place):
        return _single(group, np.empty((0, len(body.samples), 3)), np.empty((0, 3)))
    first = np.flatnonzero(np.diff(group, prepend=-1))
    owner, sizes = group[first], np.diff(np.append(first, len(group)))
    samples = body.samples[:, :, place]
    centre = _box_middle(samples, first)
    apart = np.sqrt(np.square(samples - np.repeat(centre, sizes, axis=-1)).sum(axis=1))
    apart = np.maximum.reduceat(apart, first, axis=-1)
    handles = body.handle[:, place]
    handle = _box_middle(handles, first)
    off = np.linalg.norm(handles - np.repeat(handle, sizes, axis=-1), axis=0)
    handle_slack = np.maximum.reduceat(off, first)
    middle, radius = _ball(centre, apart, handle, handle_slack)
    # Moving each sample i by at most apart[i] changes the sum over this element's samples by at most
    # sum(apart), and each of the other element's v nearest distances by at most max(apart); the mean over
    # both grows with v.
    slack = (apart.sum(axis=0) + most * apart.max(axis=0)) / (len(apart) + most)
    return Bodies(owner, centre, slack, handle, handle_slack, middle, radius)


def _box_middle(positions: Floats, first: Indices) -> Floats:
    """Middles of the boxes around groups of positions along the last axis."""
    low = np.minimum.reduceat(positions, first, axis=-1)
    return np.asarray((low + np.maximum.reduceat(positions, first, axis=-1)) / 2)


def _widest(pool: Pool, blocks: Blocks, cut: Flags) -> Floats:
    """(members,) coordinate along the widest direction of each block to cut; 0 in the others."""
    key = np.zeros(len(blocks.members))
    group = np.repeat(np.arange(len(cut)), blocks.sizes)
    place_of = [_places(each, len(pool.cost)) for each in pool.bodies]
    pending = cut.copy()
    for body, places in zip(pool.bodies, place_of, strict=True):
        place = places[blocks.members]
        chosen = (place >= 0) & pending[group]
        if not chosen.any():
            continue
        owner = group[chosen]
        first = np.flatnonzero(np.diff(owner, prepend=-1))
        sizes = np.diff(np.append(first, len(owner)))
        values = body.samples[:, :, place[chosen]].reshape(-1, len(owner))
        width = np.maximum.reduceat(values, first, axis=-1) - np.minimum.reduceat(values, first, axis=-1)
        axis = np.repeat(width.argmax(axis=0), sizes)
        key[chosen] = values[axis, np.arange(len(owner))]
        pending[owner] = False
    return key


# --- pairs -------------------------------------------------------------------------------------------


def near_pairs(one: Bodies, first: slice, other: Bodies, reach: float, extra: float) -> tuple[Indices, Indices]:
    """Pairs of bodies (of ``one[first]`` and of `other`) that may be nearer than `reach`, or whose handles may
    be nearer than `extra`; indices into the two sets, in order."""
    a, b = one.middle[:, first, None], other.middle[:, None, :]
    apart = np.square(a[0] - b[0])
    apart += np.square(a[1] - b[1])
    apart += np.square(a[2] - b[2])
    limit = (one.radius[first, None] + other.radius[None]) + max(reach, extra)
    rows, columns = np.nonzero(apart < np.square(limit))
    return rows + first.start, columns


def pair_bounds(
    one: Bodies, i: Indices, other: Bodies, j: Indices, overlap: Overlap, separation: float
) -> tuple[Floats, Flags]:
    """Least overlap cost between members of body ``i[q]`` of `one` and ``j[q]`` of `other`.

    Returns the costs, +inf where all members' handles are nearer than the separation, and whether any
    members can interact at all.  Exact for blocks of one label.
    """
    cost, near = np.empty(len(i)), np.empty(len(i), dtype=bool)
    for at in range(0, len(i), CHUNK):
        part = slice(at, at + CHUNK)
        p, q = i[part], j[part]
        apart = sample_distance(one.samples, p, other.samples, q)
        slack = one.slack[p] + other.slack[q]
        cost[part] = overlap.weight * overlap_cost(apart + slack, overlap)
        between = np.linalg.norm(one.handle[:, p] - other.handle[:, q], axis=0)
        handle_slack = one.handle_slack[p] + other.handle_slack[q]
        cost[part][between + handle_slack < separation] = np.inf
        near[part] = (apart - slack < overlap.reach) | (between - handle_slack < separation)
    return cost, near


def sample_distance(a: NDArray[np.float64], p: Indices, b: NDArray[np.float64], q: Indices) -> Floats:
    """`overlap.element_distance` of pairs of elements stored as (u, 3, n) and (v, 3, m) arrays."""
    left, right = a[:, :, p], b[:, :, q]
    to_left = np.full((len(left), len(p)), np.inf)
    total = np.zeros(len(p))
    square, part = np.empty(len(p)), np.empty(len(p))
    for theirs in right:
        nearest = np.full(len(p), np.inf)
        for k, mine in enumerate(left):
            np.subtract(mine[0], theirs[0], out=square)
            np.multiply(square, square, out=square)
            for axis in (1, 2):
                np.subtract(mine[axis], theirs[axis], out=part)
                np.multiply(part, part, out=part)
                np.add(square, part, out=square)
            np.minimum(nearest, square, out=nearest)
            np.minimum(to_left[k], square, out=to_left[k])
        total += np.sqrt(nearest, out=nearest)
    total += np.sqrt(to_left, out=to_left).sum(axis=0)
    return np.asarray(total / (len(left) + len(right)))
