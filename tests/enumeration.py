"""The best of all layouts, one by one: what the solver is held against."""

from __future__ import annotations

import itertools
import math

import numpy as np

from usdrigui.character import Floats
from usdrigui.model import Assignment, LayoutProblem
from usdrigui.overlap import pair_costs

MOST = 4_000_000
"""Layouts that are enumerated at most; one number each."""


def best_of_all(problem: LayoutProblem) -> Assignment | None:
    """None where no layout keeps all handles apart."""
    labels = [
        np.append(np.arange(len(each.cost)), [-1] if np.isfinite(each.off_face_cost) else []).astype(np.int64)
        for each in problem.variables
    ]
    assert math.prod(map(len, labels)) <= MOST
    total = np.zeros([1] * len(labels))
    for at, (each, mine) in enumerate(zip(problem.variables, labels, strict=True)):
        own = np.where(mine >= 0, np.append(each.cost, 0.0)[mine], each.off_face_cost)
        total = total + _along(own, len(labels), at)
    for a in range(len(labels)):
        for b in range(a + 1, len(labels)):
            total = total + _along(_table(problem, a, b, labels[a], labels[b]), len(labels), a, b)
    if not total.size or not np.isfinite(total.min()):
        return None
    best = np.unravel_index(int(total.argmin()), total.shape)
    cost = float(total.min())
    chosen = np.array([mine[at] for mine, at in zip(labels, best, strict=True)], dtype=np.int64)
    return Assignment(chosen, cost, cost, "optimal", 0.0, "enumeration", "enumeration", ())


def total_costs(problem: LayoutProblem, layouts: np.ndarray) -> Floats:
    """(n,) the objective of layouts (n, variables), given by the labels that they choose."""
    cost = np.zeros(len(layouts))
    for each, mine in zip(problem.variables, layouts.T, strict=True):
        cost += np.where(mine >= 0, np.append(each.cost, 0.0)[mine], each.off_face_cost)
    for a, b in itertools.combinations(range(len(problem.variables)), 2):
        cost += pair_costs(problem, a, b, layouts[:, a], layouts[:, b])
    for extra in problem.extra:
        first, second = layouts[:, extra.first, None], layouts[:, extra.second, None]
        cost += ((first == extra.first_labels) & (second == extra.second_labels)) @ extra.costs
    return cost


def _table(problem: LayoutProblem, a: int, b: int, mine: np.ndarray, other: np.ndarray) -> Floats:
    """(len(mine), len(other)) pair costs, explicit ones included."""
    first, second = np.repeat(mine, len(other)), np.tile(other, len(mine))
    table = pair_costs(problem, a, b, first, second).reshape(len(mine), len(other))
    for extra in problem.extra:
        if (extra.first, extra.second) == (a, b):
            np.add.at(table, (extra.first_labels, extra.second_labels), extra.costs)
    return table


def _along(values: Floats, dimensions: int, *axes: int) -> Floats:
    """The array with its axes at the given places among `dimensions`."""
    return values.reshape([values.shape[axes.index(at)] if at in axes else 1 for at in range(dimensions)])
