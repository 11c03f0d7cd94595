"""Controls laid out together: the paper's clusters (section 4.2, rig parameter clustering)."""

from __future__ import annotations

import itertools
from typing import Literal

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Floats
from usdrigui.model import LayoutProblem, Variable

Linkage = Literal["single", "sum"]


def clusters(problem: LayoutProblem, count: int, linkage: Linkage = "single") -> list[list[int]]:
    """Partition of the variables into `count` clusters (fewer where there are fewer variables),
    largest first.

    Starting from one cluster per variable, the two of least distance are merged until `count` are
    left.  The distance of two controls is taken over all pairs of their candidates, from handle to
    handle (section 4.2 allows that for speed).  ``single`` merges by the nearest pair of controls,
    whose distance is the mean, so that a control with few candidates is not near everything;
    ``sum`` merges by the sum over all pairs of candidates of both clusters, as printed.  Variables
    without candidates on the face touch nothing and go with the first cluster.
    """
    sizes = np.array([len(each.cost) for each in problem.variables], dtype=np.float64)
    parts, homeless = [[int(at)] for at in np.flatnonzero(sizes)], np.flatnonzero(sizes == 0)
    distance = _mean_distances([problem.variables[at] for (at,) in parts])
    if linkage == "sum":
        distance *= np.outer(sizes[sizes > 0], sizes[sizes > 0])
    while len(parts) > count:
        np.fill_diagonal(distance, np.inf)
        a, b = sorted(divmod(int(distance.argmin()), len(parts)))
        merged = (np.minimum if linkage == "single" else np.add)(distance[a], distance[b])
        distance[a] = distance[:, a] = merged
        distance = np.delete(np.delete(distance, b, axis=0), b, axis=1)
        parts[a] += parts.pop(b)
    found = sorted(map(sorted, parts), key=lambda each: (-len(each), each))
    first = sorted(itertools.chain(*found[:1], homeless.tolist()))
    return [first, *found[1:]] if first else []


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
