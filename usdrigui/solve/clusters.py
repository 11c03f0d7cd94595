"""Controls laid out together: the paper's clusters (section 4.2, rig parameter clustering)."""

from __future__ import annotations

import itertools
from typing import Literal

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.model import Floats, LayoutProblem, Variable

Linkage = Literal["single", "sum"]


def clusters(problem: LayoutProblem, count: int, method: Linkage = "single") -> list[list[int]]:
    """Partition of the variables into `count` clusters (fewer where there are fewer variables),
    largest first.

    Starting from one cluster per variable, the two of least distance are merged until `count` are
    left.  The distance of two controls is taken over all pairs of their candidates, from handle to
    handle (section 4.2 allows that for speed).  ``single`` merges by the nearest pair of controls,
    whose distance is the mean, so that a control with few candidates is not near everything;
    ``sum`` merges by the sum over all pairs of candidates of both clusters, as printed.  Variables
    without candidates on the face touch nothing and go with the first cluster.
    """
    placed = [at for at, each in enumerate(problem.variables) if len(each.cost)]
    homeless = [at for at, each in enumerate(problem.variables) if not len(each.cost)]
    if not placed:
        return [homeless] if homeless else []
    distance = _mean_distances([problem.variables[at] for at in placed])
    if method == "sum":
        sizes = np.array([len(problem.variables[at].cost) for at in placed], dtype=np.float64)
        distance *= np.outer(sizes, sizes)
    parts = _merged(distance, count, np.minimum if method == "single" else np.add)
    found = sorted(
        (sorted(placed[at] for at in part) for part in parts), key=lambda each: (-len(each), each)
    )
    return [sorted(found[0] + homeless), *found[1:]]


def _merged(distance: Floats, count: int, linkage: np.ufunc) -> list[list[int]]:
    """Merge the nearest two until `count` are left; `linkage` makes one distance of two."""
    members = [[at] for at in range(len(distance))]
    np.fill_diagonal(distance, np.inf)
    while len(members) > count:
        a, b = sorted(divmod(int(distance.argmin()), len(members)))
        distance[a] = distance[:, a] = linkage(distance[a], distance[b])
        distance[a, a] = np.inf
        distance = np.delete(np.delete(distance, b, axis=0), b, axis=1)
        members[a] += members.pop(b)
    return members


def _mean_distances(variables: list[Variable]) -> Floats:
    """(variables, variables) mean distance between the candidates' handles, of the nearest two
    copies.

    Estimated from 200 candidates of each, evenly chosen.
    """
    spots = [each.handles[:: -(-len(each.cost) // 200)] for each in variables]
    found = np.zeros((len(spots), len(spots)))
    for a, one in enumerate(spots):
        for b, other in enumerate(spots[:a]):
            copies = itertools.product(one.swapaxes(0, 1), other.swapaxes(0, 1))
            found[a, b] = min(cdist(*each).mean() for each in copies)
    return found + found.T
