"""Control values from the drag of a handle in the plane of the screen.

Everything is two-dimensional, in pixels: a client projects an element's tracks as they are at the pose
of the moment (`evaluate.elements_at`) and says where the pointer wants the handle to be.

* A slider takes the point of its track nearest to the pointer that can be reached downhill from the
  value it has (continuity: a curved track does not jump from one branch to another), unless another
  branch is nearer by far.
* Patch, fan, joystick and two-way slider are one rule.  The handle stands at rest + sum of the members'
  moves; only members next to each other by angle may be away from their base values together (paper
  section 4.2).  Each such pair less than 180 degrees apart, and each member alone, is fitted to the
  pointer within its range; the nearest answer wins, and the pair in use wins a tie.
* A track that is seen from its end has no length on screen: it is given one, `LEAST` pixels, along what is
  left of its direction, or else upward.

numpy only; no state but the values themselves, so that a drag can be replayed.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from usdrigui.model import Floats
from usdrigui.pose.fit import fit, lines

LEAST = 24.0
"""Pixels that a track is given for dragging when it is shorter than a quarter of this on screen."""
_STAY = 1e-6
"""Regularisation of pair fits: share of the squared length of the tracks per whole range."""
_FARTHER = 2.0
"""A slider leaves its branch for another that is this many times nearer to the pointer."""
_TIE = 1.02


def drag(
    tracks: Sequence[ArrayLike],
    values: Sequence[ArrayLike],
    base: ArrayLike,
    current: ArrayLike,
    pointer: ArrayLike,
) -> Floats:
    """(m,) new values of an element's m members.

    ``tracks[i]`` (k_i, 2) are pixels, x to the right and y down, at the control values ``values[i]``
    (k_i,), ascending; ``base`` (m,) are the members' values in the base pose, ``current`` (m,) those of
    the moment, ``pointer`` (2,) is where `held_at` should be: the pointer, plus what `held_at` was away
    from it when it took hold.  The result lies within each track's values.  Raises ValueError for records that
    do not fit together or are not finite.
    """
    lines_, at = _checked(tracks, values)
    rest, now, goal = (np.array(each, dtype=np.float64) for each in (base, current, pointer))
    if rest.shape != (len(lines_),) or now.shape != rest.shape or goal.shape != (2,):
        raise ValueError("base and current need one value per member, and a pointer two coordinates")
    if not (np.isfinite(rest).all() and np.isfinite(now).all() and np.isfinite(goal).all()):
        raise ValueError("values and pointer must be finite")
    lines_ = [_lengthened(line, mine, float(own)) for line, mine, own in zip(lines_, at, rest, strict=True)]
    if len(lines_) == 1:
        return np.array([slide(lines_[0], at[0], float(now[0]), goal)])
    return _several(lines_, at, rest, now, goal)


def held_at(tracks: Sequence[ArrayLike], values: Sequence[ArrayLike], base: ArrayLike, current: ArrayLike) -> Floats:
    """(2,) the place on the drawn tracks, in pixels, that stands for the ``current`` values (m,).

    It is the handle's centre where the tracks are drawn in true size, and goes further where they are
    enlarged (`Member.gain`).
    """
    lines_, at = _checked(tracks, values)
    rest, now = np.array(base, dtype=np.float64), np.array(current, dtype=np.float64)
    if rest.shape != (len(lines_),) or now.shape != rest.shape:
        raise ValueError("base and current need one value per member")
    lines_ = [_lengthened(line, mine, float(own)) for line, mine, own in zip(lines_, at, rest, strict=True)]
    return _handle(lines_, at, rest, now)


def slide(track: Floats, values: Floats, current: float, pointer: Floats) -> float:
    """Value of a slider whose handle follows ``pointer`` (2,) along ``track`` (k, 2), coming from `current`."""
    best, away = _along_pieces(track, pointer)
    piece = int(np.clip(np.searchsorted(values, current, side="right") - 1, 0, len(values) - 2))
    mine = _downhill(away, piece)
    nearest = int(np.argmin(away))
    if away[mine] > _FARTHER * away[nearest] + 1.0:
        mine = nearest
    return float(values[mine] + best[mine] * (values[mine + 1] - values[mine]))


def pairs(tracks: Sequence[Floats], values: Sequence[Floats], base: Floats) -> list[tuple[int, ...]]:
    """Members that may be away from their base values together: each alone, and neighbours by angle.

    Angles are those of each track's farthest end from its place at the base value; pairs 180 degrees
    apart or more, and pairs on one line, are left out.
    """
    arms = [_arm(line, mine, float(own)) for line, mine, own in zip(tracks, values, base, strict=True)]
    angle = np.array([np.arctan2(arm[1], arm[0]) for arm in arms])
    found: list[tuple[int, ...]] = [(i,) for i in range(len(arms))]
    order = np.argsort(angle, kind="stable").tolist()
    for i, j in zip(order, order[1:] + order[:1], strict=True):
        span = float((angle[j] - angle[i]) % (2.0 * np.pi))
        pair = (min(i, j), max(i, j))
        if 0.02 < span < np.pi - 0.02 and pair not in found:
            found.append(pair)
    return found


# --- several members ---------------------------------------------------------------------------------


def _several(tracks: list[Floats], values: list[Floats], base: Floats, current: Floats, goal: Floats) -> Floats:
    in_use = tuple(np.flatnonzero(np.abs(current - base) > 1e-9).tolist())
    best, least = current, np.inf
    for members in sorted(
        pairs(tracks, values, base), key=lambda each: (not set(in_use) <= set(each), len(each), each)
    ):
        found = base.copy()
        found[list(members)] = _fitted(tracks, values, base, current, goal, members)
        away = float(np.linalg.norm(_handle(tracks, values, base, found) - goal))
        if away * _TIE + 1e-6 < least:
            best, least = found, away
    return best


def _fitted(
    tracks: list[Floats], values: list[Floats], base: Floats, current: Floats, goal: Floats, members: tuple[int, ...]
) -> Floats:
    """(len(members),) values that bring the handle nearest to the goal, all other members at base."""
    chosen = list(members)
    home = base[chosen]
    low, high = np.array([values[i][0] for i in chosen]), np.array([values[i][-1] for i in chosen])
    span = np.maximum(high - low, 1e-300)
    paths = lines(
        [values[i] for i in chosen], [tracks[i] for i in chosen], home, span, np.arange(len(chosen), dtype=np.int64)
    )
    size = max(float(np.ptp(tracks[i], axis=0).max()) for i in chosen)
    wanted = goal - _handle(tracks, values, base, base)
    start = (np.clip(current[chosen], low, high) - home) / span
    cost = np.full(len(chosen), _STAY * size**2)
    x = fit(paths, wanted, cost, (low - home) / span, (high - home) / span, start)
    return np.asarray(np.clip(home + span * x, low, high))


def _handle(tracks: list[Floats], values: list[Floats], base: Floats, at: Floats) -> Floats:
    """(2,) the handle: the first member's base place plus every member's move from its own."""
    homes = [_place(line, mine, float(own)) for line, mine, own in zip(tracks, values, base, strict=True)]
    moves = [_place(line, mine, float(own)) for line, mine, own in zip(tracks, values, at, strict=True)]
    return np.asarray(homes[0] + sum(move - home for move, home in zip(moves, homes, strict=True)))


# --- polylines ---------------------------------------------------------------------------------------


def _along_pieces(track: Floats, pointer: Floats) -> tuple[Floats, Floats]:
    """Nearest share (k - 1,) in [0, 1] on every piece, and its distance (k - 1,) from the pointer."""
    step = np.diff(track, axis=0)
    squared = np.square(step).sum(axis=1)
    along = ((pointer - track[:-1]) * step).sum(axis=1)
    share = np.clip(np.divide(along, squared, out=np.zeros_like(along), where=squared > 0.0), 0.0, 1.0)
    return share, np.linalg.norm(track[:-1] + share[:, None] * step - pointer, axis=1)


def _downhill(away: Floats, piece: int) -> int:
    """The piece at which walking from neighbour to nearer neighbour ends."""
    while True:
        around = [other for other in (piece - 1, piece + 1) if 0 <= other < len(away)]
        nearer = min(around, key=lambda other: float(away[other]), default=piece)
        if away[nearer] >= away[piece]:
            return piece
        piece = nearer


def _place(track: Floats, values: Floats, value: float) -> Floats:
    return np.array([float(np.interp(value, values, track[:, axis])) for axis in (0, 1)])


def _arm(track: Floats, values: Floats, base: float) -> Floats:
    """(2,) from the place at the base value to the track's farthest point."""
    away = track - _place(track, values, base)
    return np.asarray(away[int(np.argmax(np.square(away).sum(axis=1)))])


def _lengthened(track: Floats, values: Floats, base: float) -> Floats:
    """The track, or a straight one of `LEAST` pixels where it is too short on screen to be followed."""
    if float(np.linalg.norm(np.diff(track, axis=0), axis=1).sum()) >= 0.25 * LEAST:
        return track
    arm = _arm(track, values, base)
    length = float(np.linalg.norm(arm))
    along = arm / length if length > 1e-3 else np.array([0.0, -1.0])
    if length > 1e-3 and _place(track, values, float(values[-1])) @ along < _place(track, values, base) @ along:
        along = -along
    share = (values - base) / (values[-1] - values[0])
    return np.asarray(_place(track, values, base) + LEAST * share[:, None] * along)


def _checked(tracks: Sequence[ArrayLike], values: Sequence[ArrayLike]) -> tuple[list[Floats], list[Floats]]:
    found = [np.array(each, dtype=np.float64) for each in tracks]
    at = [np.array(each, dtype=np.float64) for each in values]
    if not found or len(found) != len(at):
        raise ValueError("an element needs at least one track, and values for each")
    for line, mine in zip(found, at, strict=True):
        if (
            line.shape != (len(mine), 2)
            or len(mine) < 2
            or not np.isfinite(line).all()
            or not (np.diff(mine) > 0).all()
        ):
            raise ValueError("a track needs two or more finite places (k, 2) at ascending values (k,)")
    return found, at
