"""Labels that another label of their variable can always replace at no more cost (dead-end
elimination).

Label r of a variable goes when for some label s of it

    linear_s - linear_r + sum_u max_t (c_st - c_rt) <= 0,

u over the other variables, t over the labels of u that a layout with r may use: whatever the others
choose, s costs no more (J. Desmet et al., 1992; R. F. Goldstein, 1994).  A layout below the cutoff
stays below it, so it still uses nothing that bounds exclude.
"""

from __future__ import annotations

import itertools

import numpy as np

from usdrigui.model import Flags, Floats, Indices


def undominated(start: Indices, linear: Floats, pairs: Floats, excluded: Flags) -> Flags:
    """(n,) labels that no other label of their variable can replace.

    `start` (variables + 1,) is the first label of each variable; `linear` (n,) and `pairs` (n, n),
    the same both ways, are what labels cost before any reparametrisation; `excluded` (n, n) are the
    pairs that no layout below the cutoff uses.  Of labels that can replace each other one is kept.
    """
    alive = np.ones(len(linear), dtype=bool)
    owner = np.repeat(np.arange(len(start) - 1), np.diff(start))
    for low, high in itertools.pairwise(start.tolist()):
        others = np.flatnonzero(alive)
        first = np.flatnonzero(np.diff(owner[others], prepend=-1))
        costs = np.minimum(pairs[low:high, others], 1e30)  # infinite costs have no differences
        # No replacement need pay for a pair that is excluded.
        used = np.where(excluded[low:high, others], np.inf, costs)
        own, mine = linear[low:high], alive[low:high]
        for label in np.argsort(-own, kind="stable"):
            mine[label] = False
            more = np.maximum.reduceat(costs[mine] - used[label], first, axis=1).sum(axis=1)
            mine[label] = not (own[mine] - own[label] + more <= 0).any()
    return alive
