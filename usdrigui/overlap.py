"""The overlap of elements: distance, cost and the objective itself (paper section 4.1, eq. 1 and
2).

Stands on the ground floor because both the stages that build a `LayoutProblem` and those that solve
it must agree on it to the last bit.  numpy only.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from usdrigui.model import Floats, Indices, LayoutProblem, Overlap, Variable


def overlap_cost(distance: ArrayLike, overlap: Overlap) -> Floats:
    """phi(distance): the unweighted cost of two elements at that distance, in [0, maximum].

    Eq. 1 as printed grows with distance; this is the decreasing sigmoid that its text describes,
    lowered and cut so that it vanishes from `Overlap.cutoff_distance` on.
    """
    z: Floats = np.asarray(distance, dtype=np.float64)
    value: Floats = overlap.maximum * _fall(z, overlap)
    if np.isfinite(overlap.cutoff_distance):
        value = value - overlap.maximum * float(_fall(np.array(overlap.cutoff_distance), overlap))
        value = np.where(z < overlap.cutoff_distance, np.maximum(value, 0.0), 0.0)
    return np.asarray(value, dtype=np.float64)


def element_distance(first: Floats, second: Floats) -> Floats:
    """Mean, over both sample sets, of the distance to the nearest sample of the other set.

    Parameters: ``(..., u, 3)`` and ``(..., v, 3)`` sample positions, broadcast over the leading
    axes. Returns: ``(...)`` distances in the samples' units (paper section 4.1, dist(x_r, x_s)).
    """
    apart = np.sqrt(np.square(first[..., :, None, :] - second[..., None, :, :]).sum(axis=-1))
    nearest = apart.min(axis=-1).sum(axis=-1) + apart.min(axis=-2).sum(axis=-1)
    return np.asarray(nearest / (apart.shape[-1] + apart.shape[-2]), dtype=np.float64)


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
    on_face = (one >= 0) & (other >= 0)
    if on_face.any():
        cost[on_face] = _on_face_costs(
            problem, problem.variables[a], problem.variables[b], one[on_face], other[on_face]
        )
    return cost


def own_costs(samples: Floats, handles: Floats, overlap: Overlap, separation: float) -> Floats:
    """Overlap of an element with its own mirror images, to be part of its linear cost.

    `samples` (R, copies, u, 3), `handles` (R, copies, 3).  Returns ``(R,)`` weighted costs, +inf
    where two copies' handles are nearer than the separation: such a candidate must be dropped.
    """
    copies = samples.shape[1]
    cost = np.zeros(len(samples))
    for i in range(copies):
        for j in range(i + 1, copies):
            cost += overlap.weight * overlap_cost(
                element_distance(samples[:, i], samples[:, j]), overlap
            )
            cost[np.linalg.norm(handles[:, i] - handles[:, j], axis=-1) < separation] = np.inf
    return cost


def total_cost(problem: LayoutProblem, labels: ArrayLike) -> float:
    """Value of the objective for one label per variable; +inf if the labels are not allowed."""
    chosen = np.asarray(labels, dtype=np.int64)
    count = len(problem.variables)
    cost = sum(
        variable.off_face_cost if label < 0 else float(variable.cost[label])
        for variable, label in zip(problem.variables, chosen, strict=True)
    )
    for a in range(count):
        for b in range(a + 1, count):
            cost += float(pair_costs(problem, a, b, chosen[a : a + 1], chosen[b : b + 1])[0])
    for extra in problem.extra:
        hit = (extra.first_labels == chosen[extra.first]) & (
            extra.second_labels == chosen[extra.second]
        )
        cost += float(extra.costs[hit].sum())
    return float(cost)


def _fall(z: Floats, overlap: Overlap) -> Floats:
    """1 / (1 + exp(sharpness (z - radius))), without overflow."""
    return np.asarray(
        0.5 * (1.0 - np.tanh(0.5 * overlap.sharpness * (z - overlap.radius))), dtype=np.float64
    )


def _on_face_costs(
    problem: LayoutProblem, a: Variable, b: Variable, first: Indices, second: Indices
) -> Floats:
    overlap = problem.overlap
    a_samples, b_samples = a.samples[first], b.samples[second]
    a_handles, b_handles = a.handles[first], b.handles[second]
    cost = np.zeros(len(a_samples))
    for i in range(a_samples.shape[1]):
        for j in range(b_samples.shape[1]):
            cost += overlap.weight * overlap_cost(
                element_distance(a_samples[:, i], b_samples[:, j]), overlap
            )
            cost[
                np.linalg.norm(a_handles[:, i] - b_handles[:, j], axis=-1) < problem.separation
            ] = np.inf
    return cost
