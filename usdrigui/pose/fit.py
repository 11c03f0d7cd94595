"""Bounded least squares on sums of polylines: the small problem behind every drag.

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

import numpy as np

from usdrigui.model import Floats, Indices, Record

_STEPS = 10
_NEWTON_STEPS = 40
_HALVINGS = 12
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

    def moved(self, x: Floats) -> Floats:
        """(r,) change of the rows from home."""
        return np.asarray((self._at(self.home + self.span * x[self.variable]) - self._at(self.home)).sum(axis=0))

    def slopes(self, x: Floats, before: bool) -> Floats:
        """(r, variables) derivative of the rows; at a knot that of the piece after it, or `before` it."""
        low = self._piece(self.home + self.span * x[self.variable], before)
        every = np.arange(len(self.knots))
        rise = self.offsets[every, low + 1] - self.offsets[every, low]
        run = self.knots[every, low + 1] - self.knots[every, low]
        slope = rise * (self.span / np.where(run > 0.0, run, np.inf))[:, None]
        total = np.zeros((len(x), slope.shape[1]))
        np.add.at(total, self.variable, slope)
        return total.T

    def _at(self, values: Floats) -> Floats:
        low = self._piece(values, False)
        every = np.arange(len(self.knots))
        start, end = self.knots[every, low], self.knots[every, low + 1]
        share = (values - start) / np.where(end > start, end - start, np.inf)
        first, second = self.offsets[every, low], self.offsets[every, low + 1]
        return np.asarray(first + share[:, None] * (second - first))

    def _piece(self, values: Floats, before: bool) -> Indices:
        """(m,) first knot of the piece on which each value lies; never a piece of no length."""
        below = self.knots < values[:, None] if before else self.knots <= values[:, None]
        last = (self.knots < self.knots[:, -1:]).sum(axis=1) - 1
        return np.asarray(np.clip(below.sum(axis=1) - 1, 0, np.maximum(last, 0)), dtype=np.int64)


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
    x_j(u) = clip(rows_j . u / cost_j, low_j, high_j), and u solves  u + rows x(u) = wanted:  the zero of
    the gradient of a convex function of r variables, found by Newton steps of r by r systems, each
    shortened until the function falls.  Piecewise quadratic, so it ends exactly, mostly in 3 to 8 steps.
    """
    light = rows / cost
    u = wanted
    x, value = _dual(rows, light, wanted, cost, low, high, u)
    for _ in range(_NEWTON_STEPS):
        slope = u - wanted + rows @ x
        if float(np.abs(slope).max(initial=0.0)) <= 1e-10 * (1.0 + float(np.abs(wanted).max(initial=0.0))):
            break
        free = (x > low) & (x < high)
        step = np.linalg.solve(np.eye(len(u)) + light[:, free] @ rows[:, free].T, slope)
        share = 1.0
        for _ in range(_HALVINGS):
            ahead = u - share * step
            moved, after = _dual(rows, light, wanted, cost, low, high, ahead)
            if after < value:
                break
            share *= 0.5
        else:
            break
        u, x, value = ahead, moved, after
    return x


def _dual(
    rows: Floats, light: Floats, wanted: Floats, cost: Floats, low: Floats, high: Floats, u: Floats
) -> tuple[Floats, float]:
    """x(u) and the convex function whose gradient is ``u - wanted + rows x(u)``."""
    x = np.minimum(np.maximum(u @ light, low), high)
    return x, float((0.5 * u - wanted) @ u + (u @ rows) @ x - 0.5 * (cost * x) @ x)


def _improved(
    paths: Lines, wanted: Floats, cost: Floats, low: Floats, high: Floats, x: Floats, energy: float
) -> tuple[Floats, float] | None:
    """A better x and its energy, from the problem linearised after the knots at x, or else before them."""
    short = wanted - paths.moved(x)
    for before in (False, True):
        rows = paths.slopes(x, before)
        best = bounded(rows, short + rows @ x, cost, low, high)
        share = 1.0
        for _ in range(_HALVINGS):
            moved = x + share * (best - x)
            after = _energy(paths, wanted, cost, moved)
            if after < energy:
                return moved, after
            share *= 0.5
    return None


def _energy(paths: Lines, wanted: Floats, cost: Floats, x: Floats) -> float:
    short = paths.moved(x) - wanted
    return 0.5 * float(short @ short + cost @ (x * x))
