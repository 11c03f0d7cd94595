"""Bounded least squares on sums of polylines: the small problem behind every pull of the skin.

A point's path under one control is a polyline; where several controls act, their paths add up.  Given
where the points should go, find the least change of the controls that brings them there:

    minimise  1/2 |sum_j (f_j(v_j) - f_j(home_j)) - wanted|^2  +  1/2 sum_i cost_i x_i^2
    with      v_j = home_j + span_j x_variable(j),   low <= x <= high

`fit` linearises the polylines (Gauss-Newton); `bounded` solves each linear problem exactly through its
dual, whose unknowns are as many as the rows, not the variables: nine for three points, whatever the rig.
Small enough to be rewritten in any language.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from usdrigui.model import Floats, Indices, Record

_STEPS = 10
_NEWTON_STEPS = 100
_HALVINGS = 12
_NUDGE = 0.02
_TOLERANCE = 1e-9
"""Of the variables, relative to the size of the solution."""


@dataclass(frozen=True, eq=False)
class Lines(Record):
    """Paths of all rows (coordinates of the points, weighted) under m controls."""

    knots: Floats
    """(m, k) ascending control values; shorter polylines repeat their last knot."""
    offsets: Floats
    """(m, k, r) where the rows are at the knots."""
    home: Floats
    """(m,) control values at x = 0."""
    span: Floats
    """(m,) change of the control per unit of its variable."""
    variable: Indices
    """(m,) which variable moves the control."""

    @property
    def straight(self) -> bool:
        """True when no path bends: then one linear problem is the whole problem."""
        return bool(self.knots.shape[1] == 2)

    @cached_property
    def last(self) -> Indices:
        """(m,) first knot of the last piece of each path that has a length."""
        last = (self.knots < self.knots[:, -1:]).sum(axis=1) - 1
        return np.asarray(np.maximum(last, 0), dtype=np.int64)

    @cached_property
    def at_home(self) -> Floats:
        """(r,) the rows at x = 0, all paths added up."""
        return np.asarray(self._at(self.home).sum(axis=0))

    def moved(self, x: Floats) -> Floats:
        """(r,) change of the rows from home."""
        return np.asarray(self._at(self.home + self.span * x[self.variable]).sum(axis=0) - self.at_home)

    def slopes(self, x: Floats, nudge: float = 0.0) -> Floats:
        """(r, variables) derivative of the rows, on the pieces a `nudge` (in units of x) further along."""
        low = self._piece(self.home + self.span * (x[self.variable] + nudge))
        every = np.arange(len(self.knots))
        rise = self.offsets[every, low + 1] - self.offsets[every, low]
        run = self.knots[every, low + 1] - self.knots[every, low]
        slope = rise * (self.span / np.where(run > 0.0, run, np.inf))[:, None]
        total = np.zeros((len(x), slope.shape[1]))
        np.add.at(total, self.variable, slope)
        return total.T

    def _at(self, values: Floats) -> Floats:
        low = self._piece(values)
        every = np.arange(len(self.knots))
        start, end = self.knots[every, low], self.knots[every, low + 1]
        share = (values - start) / np.where(end > start, end - start, np.inf)
        first, second = self.offsets[every, low], self.offsets[every, low + 1]
        return np.asarray(first + share[:, None] * (second - first))

    def _piece(self, values: Floats) -> Indices:
        """(m,) first knot of the piece on which each value lies; never a piece of no length."""
        low = (self.knots <= values[:, None]).sum(axis=1) - 1
        return np.asarray(np.minimum(np.maximum(low, 0), self.last), dtype=np.int64)


def lines(knots: list[Floats], offsets: list[Floats], home: Floats, span: Floats, variable: Indices) -> Lines:
    """`Lines` from one polyline per control: ``knots[j]`` (k_j,) and ``offsets[j]`` (k_j, r)."""
    longest = max((len(each) for each in knots), default=2)
    rows = offsets[0].shape[1] if offsets else 0
    padded = np.zeros((len(knots), max(longest, 2)))
    stacked = np.zeros((len(knots), max(longest, 2), rows))
    for j, (at, where) in enumerate(zip(knots, offsets, strict=True)):
        padded[j, : len(at)], padded[j, len(at) :] = at, at[-1]
        stacked[j, : len(at)], stacked[j, len(at) :] = where, where[-1]
    return Lines(padded, stacked, home, span, variable)


def fit(paths: Lines, wanted: Floats, cost: Floats, low: Floats, high: Floats, start: Floats | None = None) -> Floats:
    """(variables,) the x that minimises the problem above, at least locally; exact for straight paths.

    ``wanted`` (r,) is the change asked of the rows, ``cost`` (variables,) > 0.  Deterministic.
    """
    x = np.clip(np.zeros(len(cost)) if start is None else start, low, high)
    energy = _energy(paths, wanted, cost, x)
    for _ in range(_STEPS):
        moved = _improved(paths, wanted, cost, low, high, x, energy)
        if moved is None:
            break
        step = float(np.abs(moved[0] - x).max())
        x, energy = moved
        if paths.straight or step <= _TOLERANCE * (1.0 + float(np.abs(x).max())):
            break
    return x


def bounded(rows: Floats, wanted: Floats, cost: Floats, low: Floats, high: Floats) -> Floats:
    """(m,) minimiser of ``1/2 |rows x - wanted|^2 + 1/2 sum cost x^2`` within ``low <= x <= high``.

    ``rows`` (r, m), ``cost`` (m,) > 0.  With the residual u = wanted - rows x as unknown, the optimum is
    x_j(u) = clip(rows_j . u / cost_j, low_j, high_j), and u solves  u - wanted + rows x(u) = 0:  the
    gradient of a convex, piecewise quadratic function of r variables.  Newton steps of r by r systems
    with exact line search end at the optimum, mostly after 3 to 15 steps.
    """
    light = rows / cost
    u: Floats = wanted
    enough = 1e-11 * (1.0 + float(np.abs(wanted).max(initial=0.0)) + float(np.abs(rows).max(initial=0.0)))
    for _ in range(_NEWTON_STEPS):
        at = u @ light
        x = np.minimum(np.maximum(at, low), high)
        slope = u - wanted + rows @ x
        if float(np.abs(slope).max(initial=0.0)) <= enough:
            break
        free = (at > low) & (at < high)
        step: Floats = np.linalg.solve(np.eye(len(u)) + light[:, free] @ rows[:, free].T, slope).astype(np.float64)
        u = u - step * _step_length(rows.T @ step, step @ light, at, u - wanted, step, low, high)
    return np.minimum(np.maximum(u @ light, low), high)


def _step_length(
    pull: Floats, speed: Floats, at: Floats, short: Floats, step: Floats, low: Floats, high: Floats
) -> float:
    """t > 0 at which the function of `bounded` is least along ``u - t step``.

    Its derivative there, ``t step.step - step.short - pull.x(t)``, grows with t and is linear between
    the values at which some x_j meets a bound; the piece with the zero is found by bisection.
    """
    first, second = float(step @ short), float(step @ step)

    def rise(t: float) -> float:
        return t * second - first - float(pull @ np.minimum(np.maximum(at - t * speed, low), high))

    moving = speed != 0.0
    corners = np.concatenate([(at - low)[moving] / speed[moving], (at - high)[moving] / speed[moving]])
    corners = np.sort(corners[corners > 0.0])
    before, after = 0, len(corners)
    while before < after:
        middle = (before + after) // 2
        if rise(float(corners[middle])) < 0.0:
            before = middle + 1
        else:
            after = middle
    start = float(corners[before - 1]) if before else 0.0
    end = float(corners[before]) if before < len(corners) else start + 1.0
    down, up = rise(start), rise(end)
    return start - down * (end - start) / (up - down) if up > down else end


def _improved(
    paths: Lines, wanted: Floats, cost: Floats, low: Floats, high: Floats, x: Floats, energy: float
) -> tuple[Floats, float] | None:
    """A better x and its energy, or None.

    The problem is linearised on the pieces that x lies on and, should that not help, on those a little
    further along or back: where a path bends, the least energy of one piece lies just short of the bend.
    """
    short = wanted - paths.moved(x)
    tried: list[Floats] = []
    for nudge in (0.0,) if paths.straight else (0.0, _NUDGE, -_NUDGE):
        rows = paths.slopes(x, nudge)
        if any(np.array_equal(rows, other) for other in tried):
            continue
        tried.append(rows)
        best = bounded(rows, short + rows @ x, cost, low, high)
        if float(np.abs(best - x).max()) <= _TOLERANCE * (1.0 + float(np.abs(x).max())):
            continue
        share = 1.0
        for _ in range(_HALVINGS):
            moved = x + share * (best - x)
            after = _energy(paths, wanted, cost, moved)
            if after < energy - 1e-12 * abs(energy):
                return moved, after
            share *= 0.5
    return None


def _energy(paths: Lines, wanted: Floats, cost: Floats, x: Floats) -> float:
    short = paths.moved(x) - wanted
    return 0.5 * float(short @ short + cost @ (x * x))
