"""Control values from the drag of a handle in the plane of the screen.

Everything is two-dimensional, in pixels, x to the right and y down: a client projects an element's
tracks as they are at the pose of the moment (`evaluate.elements_at`) and finds how far the pointer
has moved.

* An element has axes (`Element.axes`): one control, or two opposed controls that are the
  negative and the positive end of one signed axis.  The *coordinate* of a single control goes from
  0 at its minimum to 1 at its maximum; that of an opposed pair from -1 through 0 to 1, and only one
  of its ends is away from its default.
* The handle is at its place in the base pose plus the sum of its axes' moves, each a polyline.
* One or two axes: every two pieces of their polylines span a parallelogram.  The handle goes to the
  point nearest to where the pointer wants it, downhill from the parallelogram in which it is: a
  curved track does not jump from one branch to another, unless the other is nearer by far.
* Three and more axes (a fan): only two *arms*, next to each other by angle and less than 180
  degrees apart, are away from the base pose together (paper section 4.2).  The nearest such pair
  wins, the one in use a tie.
* A slider seen from its end has no length on the screen: it is given one, `LEAST` pixels, along
  what is left of its direction, or else upward.  Of several axes, one seen from its end keeps its
  value.

numpy only, and nothing of the package but `handle_track` beside it: these very files are part of
the Blender extension.
viewer/src/drag.js is the same in JavaScript; schemas/conformance/drags.json holds both to the same
answers.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .handle_track import along, piece_at  # a sibling in the Blender extension, too

Floats = NDArray[np.float64]

LEAST = 24.0
"""Pixels that a track is given for dragging when it is shorter than a quarter of this on the
screen."""
_FARTHER = 2.0
"""A handle leaves its branch of a curved track for another that is this many times nearer to the
pointer..."""
_STRAY = 4.0
"""...and this many pixels besides."""
_STAY = 0.02
"""Pixels that a whole range costs: decides between axes that lie on one line.  Where a range moves
the handle by L pixels, it falls short of the pointer by the share _STAY^2 / (L^2 + _STAY^2): never
by more than _STAY / 2."""
_TIE = 1.02
_SAME = 1e-9
"""Coordinates nearer to each other than this are one."""


@dataclass(frozen=True)
class End:
    """One control on its axis: its value goes from `off` to `far` while the coordinate goes from 0
    to `sign`."""

    member: int
    sign: float
    off: float
    far: float
    base: float
    """The value in the base pose, which is met to the last bit."""

    def value(self, coordinate: float) -> float:
        """The control's value; `off` on the other side of 0."""
        share = min(max(self.sign * coordinate, 0.0), 1.0)
        found = (1.0 - share) * self.off + share * self.far
        return self.base if abs(found - self.base) <= 1e-12 * abs(self.far - self.off) else found

    def share(self, value: float) -> float:
        """How far from `off` towards `far` a value is, within 0 and 1."""
        return (
            min(max((value - self.off) / (self.far - self.off), 0.0), 1.0)
            if self.far != self.off
            else 0.0
        )


@dataclass(frozen=True)
class Axis:
    """One axis on the screen."""

    ends: tuple[End, ...]
    at: Floats
    """(k,) ascending coordinates; one of them is `base`."""
    points: Floats
    """(k, 2) pixels from the handle's place in the base pose."""
    base: float
    """Coordinate in the base pose."""

    def point(self, coordinate: float) -> Floats:
        """(2,) where the axis alone takes the handle."""
        return along(self.at, self.points, coordinate)

    def arms(self) -> Iterator[Axis]:
        """The parts on either side of the base pose."""
        middle = int(np.argmin(np.abs(self.at - self.base)))
        for part in (slice(0, middle + 1), slice(middle, None)):
            if len(self.at[part]) > 1:
                yield replace(self, at=self.at[part], points=self.points[part])


@dataclass(frozen=True)
class Drag:
    """A handle taken hold of."""

    axes: tuple[Axis, ...]
    free: tuple[int, ...]
    """The axes that follow the pointer."""
    start: Floats
    """(axes,) coordinates when it was taken."""
    values: Floats
    """(members,) control values when it was taken."""


def begin_drag(
    tracks: Sequence[ArrayLike],
    values: Sequence[ArrayLike],
    axes: Sequence[Sequence[int]],
    ranges: ArrayLike,
    base: ArrayLike,
    current: ArrayLike,
) -> Drag:
    """Take hold of an element of m members.

    ``tracks[i]`` (k_i, 2) are pixels at the control values ``values[i]`` (k_i,), ascending;
    ``axes`` are positions of members: one, or the negative and the positive end.  ``ranges`` (m, 3)
    are minimum, default and maximum of each control, ``base`` (m,) and ``current`` (m,) its values
    in the base pose and now.  Raises ValueError for a track that is not in sight
    as a whole.
    """
    lines, knots = (
        [np.array(each, dtype=np.float64) for each in given] for given in (tracks, values)
    )
    if not all(np.isfinite(line).all() for line in lines):
        raise ValueError("a part of a track is behind the viewer")
    limits, home, now = (np.array(each, dtype=np.float64) for each in (ranges, base, current))
    drawn, free = _long_enough(
        [_axis(_ends(members, limits, home), lines, knots) for members in axes]
    )
    start = [
        sum(end.sign * end.share(float(now[end.member])) for end in axis.ends) for axis in drawn
    ]
    return Drag(drawn, free, np.array(start), now)


def drag_to(drag: Drag, at: ArrayLike, moved: ArrayLike) -> Floats:
    """(axes,) coordinates for a handle that is to be ``moved`` (2,) pixels from where it was at the
    start.

    ``at`` (axes,) are the coordinates of the moment: those of the last move, `Drag.start` for the
    first.
    """
    last, goal = np.array(at, dtype=np.float64), np.array(moved, dtype=np.float64)
    free = list(drag.free)
    goal = goal + sum((drag.axes[i].point(drag.start[i]) for i in free), np.zeros(2))
    found = drag.start.copy()
    if len(free) > 2:
        found[free] = _on_fan([drag.axes[i] for i in free], drag.start[free], last[free], goal)
    elif free:
        pair = [*(drag.axes[i] for i in free), _NONE][:2]
        start, now = (np.append(each[free], 0.0)[:2] for each in (drag.start, last))
        found[free] = _nearest(pair[0], pair[1], start, now, goal)[0][: len(free)]
    return found


def values_at(drag: Drag, at: ArrayLike) -> Floats:
    """(members,) control values at coordinates (axes,)."""
    found, coordinates = drag.values.copy(), np.asarray(at, dtype=np.float64)
    for i in drag.free:
        for end in drag.axes[i].ends:
            found[end.member] = end.value(float(coordinates[i]))
    return found


# --- axes -----------------------------------------------------------------------------------------


def _ends(members: Sequence[int], ranges: Floats, home: Floats) -> tuple[End, ...]:
    found = []
    for sign, member in zip((1.0,) if len(members) == 1 else (-1.0, 1.0), members, strict=True):
        minimum, default, maximum = map(float, ranges[member])
        far = maximum if maximum - default >= default - minimum else minimum
        off, far = (minimum, maximum) if len(members) == 1 else (default, far)
        found.append(End(member, sign, off, far, float(home[member])))
    return tuple(found)


def _axis(ends: tuple[End, ...], tracks: list[Floats], values: list[Floats]) -> Axis:
    base = sum(end.sign * end.share(end.base) for end in ends)
    at = np.array([base])
    for end in ends:
        shares = [end.share(float(value)) for value in values[end.member]]
        at = np.concatenate([at, end.sign * np.array([0.0, *shares, 1.0])])
    at = np.sort(at)
    at = at[np.append(np.diff(at) > _SAME, True)]
    points = np.zeros((len(at), 2))
    for end in ends:
        track, knots = tracks[end.member], values[end.member]
        points += [along(knots, track, end.value(float(each))) for each in at]
        points -= along(knots, track, end.base)
    return Axis(ends, at, points, base)


def _long_enough(axes: list[Axis]) -> tuple[tuple[Axis, ...], tuple[int, ...]]:
    """The axes, stretched where all are too short on the screen to be followed, and which of them
    follow."""
    lengths = np.array(
        [np.linalg.norm(np.diff(axis.points, axis=0), axis=1).sum() for axis in axes]
    )
    longest = float(lengths.max())
    if longest >= 0.25 * LEAST:
        return tuple(axes), tuple(np.flatnonzero(lengths >= 0.25 * LEAST).tolist())
    if len(axes) == 1:
        return (_straightened(axes[0]),), (0,)
    if longest < 1.0:
        return tuple(axes), ()
    longer = tuple(replace(axis, points=axis.points * (LEAST / longest)) for axis in axes)
    return longer, tuple(np.flatnonzero(lengths >= 0.25 * longest).tolist())


def _straightened(axis: Axis) -> Axis:
    """A straight line of `LEAST` pixels instead."""
    across = axis.points[-1] - axis.points[0]
    length = float(np.linalg.norm(across))
    direction = across / length if length >= 1.0 else np.array([0.0, -1.0])
    share = (axis.at - axis.base) / (axis.at[-1] - axis.at[0])
    return replace(axis, points=LEAST * share[:, None] * direction)


# --- the nearest point ----------------------------------------------------------------------------


_NONE = Axis((), np.array([0.0, 1.0]), np.zeros((2, 2)), 0.0)
"""An axis that goes nowhere, beside one that is alone."""


def _nearest(u: Axis, v: Axis, start: Floats, last: Floats, goal: Floats) -> tuple[Floats, float]:
    """(2,) coordinates on two axes of the point nearest to the goal, and its distance from it."""
    away, at = _cells(u, v, start, goal)
    mine = _downhill(away, piece_at(u.at, float(last[0])), piece_at(v.at, float(last[1])))
    nearest = np.unravel_index(int(np.argmin(away)), away.shape)
    if away[mine] > _FARTHER * away[nearest] + _STRAY:
        mine = (int(nearest[0]), int(nearest[1]))
    return at[mine], float(away[mine])


def _cells(u: Axis, v: Axis, start: Floats, goal: Floats) -> tuple[Floats, Floats]:
    """Distance (k - 1, l - 1) and coordinates (k - 1, l - 1, 2) of the nearest point of every
    parallelogram.

    Minimises |r + x a + y b|^2 over 0 <= x, y <= 1 in pixels and, times `_STAY`, in coordinates
    from the start: strictly convex, so its minimum is the one without bounds, or else lies on one
    of the four sides.
    """
    a, b = _steps(u, 0)[:, None], _steps(v, 1)[None]
    r = np.empty((a.shape[0], b.shape[1], 4))
    r[..., :2] = u.points[:-1, None] + v.points[None, :-1] - goal
    r[..., 2] = _STAY * (u.at[:-1, None] - start[0])
    r[..., 3] = _STAY * (v.at[None, :-1] - start[1])
    aa, bb, ab, ra, rb = ((p * q).sum(axis=-1) for p, q in ((a, a), (b, b), (a, b), (r, a), (r, b)))
    aa, bb = np.broadcast_to(aa, ab.shape), np.broadcast_to(bb, ab.shape)
    area = np.maximum(aa * bb - ab**2, 1e-300)
    zero, one = np.zeros_like(ab), np.ones_like(ab)
    x = np.clip([(ab * rb - bb * ra) / area, -ra / aa, -(ra + ab) / aa, zero, one], 0.0, 1.0)
    y = np.clip([(ab * ra - aa * rb) / area, zero, one, -rb / bb, -(rb + ab) / bb], 0.0, 1.0)
    away = np.linalg.norm(r + x[..., None] * a + y[..., None] * b, axis=-1)
    best = np.argmin(away, axis=0)[None]
    x, y, away = (np.take_along_axis(each, best, axis=0)[0] for each in (x, y, away))
    at = np.stack(
        [
            _between(u.at[:-1, None], u.at[1:, None], x),
            _between(v.at[None, :-1], v.at[None, 1:], y),
        ],
        axis=-1,
    )
    return away, at


def _steps(axis: Axis, place: int) -> Floats:
    """(k - 1, 4) pieces: pixels, and coordinates times `_STAY`."""
    found = np.zeros((len(axis.at) - 1, 4))
    found[:, :2], found[:, 2 + place] = np.diff(axis.points, axis=0), _STAY * np.diff(axis.at)
    return found


def _between(low: Floats, high: Floats, share: Floats) -> Floats:
    return (1.0 - share) * low + share * high


def _downhill(away: Floats, i: int, j: int) -> tuple[int, int]:
    """The cell at which walking from neighbour to nearer neighbour ends."""
    while True:
        rows, columns = slice(max(i - 1, 0), i + 2), slice(max(j - 1, 0), j + 2)
        around = away[rows, columns]
        row, column = np.unravel_index(int(np.argmin(around)), around.shape)
        if around[row, column] >= away[i, j]:
            return i, j
        i, j = rows.start + int(row), columns.start + int(column)


def _on_fan(axes: list[Axis], start: Floats, last: Floats, goal: Floats) -> Floats:
    """(axes,) coordinates: the nearest of all pairs of neighbouring arms, all other axes in the
    base pose."""
    home = np.array([axis.base for axis in axes])
    in_use = {
        (i, bool(last[i] > home[i])) for i in range(len(axes)) if abs(last[i] - home[i]) > _SAME
    }
    best, least = last, np.inf
    for pair in sorted(
        _pairs(axes), key=lambda each: not in_use <= {(i, arm.at[-1] > home[i]) for i, arm in each}
    ):
        chosen = [i for i, _ in pair]
        rest = sum(
            (axes[i].point(home[i]) for i in range(len(axes)) if i not in chosen), np.zeros(2)
        )
        now = np.array([np.clip(last[i], arm.at[0], arm.at[-1]) for i, arm in pair])
        found, away = _nearest(pair[0][1], pair[1][1], start[chosen], now, goal - rest)
        if away * _TIE + 1e-6 < least:
            best, least = home.copy(), away
            best[chosen] = found
    return best


def _pairs(axes: list[Axis]) -> list[tuple[tuple[int, Axis], tuple[int, Axis]]]:
    """Arms, each with its axis, that are next to each other by angle and less than 180 degrees
    apart."""
    arms = [(i, arm) for i, axis in enumerate(axes) for arm in axis.arms()]
    angle = np.array([_angle(arm, axes[i].point(axes[i].base)) for i, arm in arms])
    order = np.argsort(angle, kind="stable").tolist()
    found = []
    for p, q in zip(order, order[1:] + order[:1], strict=True):
        span = float((angle[q] - angle[p]) % (2.0 * np.pi))
        if arms[p][0] != arms[q][0] and span < np.pi:
            found.append((arms[p], arms[q]))
    return found


def _angle(arm: Axis, origin: Floats) -> float:
    """Of the arm's farthest point."""
    away = arm.points - origin
    x, y = away[int(np.argmax(np.square(away).sum(axis=1)))]
    return float(np.arctan2(y, x))
