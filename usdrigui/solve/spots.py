"""Spots that a relaxation crowds: cells worth a price, found among the entries that it chooses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.model import Flags, Floats, Indices, Record, Singles
from usdrigui.solve.ascent import Ascent
from usdrigui.solve.blocks import Pool, squared

NEW = 80
"""Cells found at a time."""
TRIED = 400
VIOLATED = 0.02
ALIKE = 0.7
"""Share of their mass in common above which two cells count as the same."""
HANDLE_RADII = (0.4, 0.5, 0.65, 0.9)
BODY_RADII = (0.5, 0.65, 0.8, 1.0, 1.25)
"""Of the cells tried around an entry, in overlap radii: balls of handles, and of handles and middles."""
PAIR_COSTS = (0.03, 0.1, 0.3, 1.0)
"""Cells tried around an entry: all that cost it at least this much."""
OWN = 0.5
"""Distance of the handles within which other places of the entry's own variable belong to those."""
COUNTS = np.arange(1.0, 5.0)
GRAIN = 2.0**-12
SUPPORT = 0.003
"""Least share of an entry that cells are looked for among."""


@dataclass(frozen=True, eq=False)
class Places(Record):
    """Where the entries of a pool stand."""

    handle: Floats
    """(n, copies, 3) in overlap radii; nan where there is no copy or no body."""
    middle: Floats
    """(n, copies, 3)."""


def places(pool: Pool, unit: float) -> Places:
    """Positions of handles and of the elements' middles in multiples of `unit`."""
    size = len(pool.cost)
    seen = np.zeros(size, dtype=np.int64)
    for body in pool.bodies:
        seen[body.owner] += 1
    found = np.full((2, size, seen.max(initial=1), 3), np.nan)
    seen[:] = 0
    for body in pool.bodies:
        found[0, body.owner, seen[body.owner]] = body.handle.T / unit
        found[1, body.owner, seen[body.owner]] = body.middle.T / unit
        seen[body.owner] += 1
    return Places(found[0], found[1])


def crowded(ascent: Ascent, where: Places, eps: float, exchanges: int) -> tuple[Flags, list[float]]:
    """The most violated cells that are not much alike nor known: (cells, n) members in the pool, and k.

    Cells are spots, changed by so many exchanges of single entries.
    """
    share, pairs = ascent.shares(eps)
    support = np.flatnonzero(share > SUPPORT)
    if not len(support):  # spread thinly over hundreds of alike entries: nothing is crowded
        return np.zeros((0, len(ascent.costs.pool.cost)), dtype=bool), []
    share, pairs = _rounded(share[support]), _rounded(pairs[np.ix_(support, support)])
    pairs += pairs.T
    sets, family, centre = _candidates(ascent, where, support, share)
    count, worst = _violation(sets, share, pairs)
    tried = np.lexsort((-worst, centre))
    tried = tried[np.diff(centre[tried], prepend=-1) > 0]  # of the cells around an entry the most violated
    tried = tried[np.argsort(-worst[tried], kind="stable")[:TRIED]]
    tried = tried[worst[tried] > VIOLATED]
    sets = _grown(sets[tried], count[tried], share, pairs, exchanges)
    count, worst = _violation(sets, share, pairs)
    mass, common = sets @ share, (sets * share) @ sets.T
    known = {(k, each.tobytes()) for k, each in zip(ascent.count.tolist(), ascent.member, strict=True)}
    taken: list[int] = []
    found: list[tuple[Flags, float]] = []
    for at in np.argsort(-worst, kind="stable"):
        if (common[at, taken] > ALIKE * np.maximum(mass[at], mass[taken])).any():
            continue
        taken.append(int(at))
        member = _members(ascent, where, support, int(centre[tried[at]]), int(family[tried[at]]))
        member[ascent.chosen[support]] = sets[at] > 0
        if (float(count[at]), member.tobytes()) not in known:
            found.append((member, float(count[at])))
        if len(found) == NEW:
            break
    member = np.array([each for each, _ in found], dtype=bool).reshape(len(found), len(ascent.costs.pool.cost))
    return member, [each for _, each in found]


def _rounded(values: Singles) -> Singles:
    """Whole multiples of `GRAIN`: sums of some thousand are exact, so a matrix product does not depend on the order of
    its terms, which differs between processors."""
    return np.asarray(np.rint(values / np.float32(GRAIN)) * np.float32(GRAIN), dtype=np.float32)


def _violation(sets: Singles, share: Singles, pairs: Singles) -> tuple[Floats, Floats]:
    """(sets,) k at which each set is violated most, and by how much, over k."""
    mass, both = sets @ share, ((sets @ pairs) * sets).sum(axis=1) / 2
    excess = (COUNTS * mass[:, None] - COUNTS * (COUNTS + 1) / 2 - both[:, None]) / COUNTS
    return COUNTS[excess.argmax(axis=1)], excess.max(axis=1)


def _grown(sets: Singles, count: Floats, share: Singles, pairs: Singles, exchanges: int) -> Singles:
    """The sets after a few exchanges, each of the entry that makes its set more violated by most."""
    sets = sets.copy()
    gain = count.astype(np.float32)[:, None] * share - sets @ pairs
    for _ in range(exchanges):
        better = np.where(sets > 0, -gain, gain)
        at = better.argmax(axis=1)
        rows = np.flatnonzero(better[np.arange(len(sets)), at] > 1e-4)
        if not len(rows):
            break
        sign = 1 - 2 * sets[rows, at[rows]]
        sets[rows, at[rows]] += sign
        gain[rows] -= sign[:, None] * pairs[at[rows]]
    return sets


def _candidates(ascent: Ascent, where: Places, support: Indices, share: Singles) -> tuple[Singles, Indices, Indices]:
    """(sets, m) sets of the entries with a share around each of them that hold more than one element, as numbers
    0 and 1; the number of the family of each, and the entry around which it lies."""
    entries = ascent.chosen[support]
    handle = _squares_apart(where.handle[entries], where.handle[entries])
    body = np.maximum(handle, _squares_apart(where.middle[entries], where.middle[entries]))
    costs = ascent.across[np.ix_(support, entries)]
    same = ascent.variable[support][:, None] == ascent.variable[support]
    found = [handle <= each**2 for each in HANDLE_RADII] + [body <= each**2 for each in BODY_RADII]
    found += [(costs >= each) | (same & (handle < OWN**2)) for each in PAIR_COSTS]
    full = [each @ share > 1.0 + VIOLATED for each in found]
    sets: Singles = np.concatenate([each[rows] for each, rows in zip(found, full, strict=True)]).astype(np.float32)
    family = np.repeat(np.arange(len(found)), [int(rows.sum()) for rows in full])
    return sets, family, np.concatenate([np.flatnonzero(rows) for rows in full])


def _members(ascent: Ascent, where: Places, support: Indices, centre: int, family: int) -> Flags:
    """(n,) entries of the pool that belong to a cell around an entry in play."""
    middle = ascent.chosen[support[[centre]]]
    handle = _squares_apart(where.handle[middle], where.handle)[0]
    if family < len(HANDLE_RADII):
        return np.asarray(handle <= HANDLE_RADII[family] ** 2)
    family -= len(HANDLE_RADII)
    if family < len(BODY_RADII):
        body = np.maximum(handle, _squares_apart(where.middle[middle], where.middle)[0])
        return np.asarray(body <= BODY_RADII[family] ** 2)
    variable = ascent.costs.pool.variable
    own = (variable == variable[middle]) & (handle < OWN**2)
    costs = ascent.across[support[centre]]
    return np.asarray((costs >= PAIR_COSTS[family - len(BODY_RADII)]) | own)


def _squares_apart(one: Floats, other: Floats) -> Floats:
    """(n, m) squares of the least distance between any copies; inf where there is none."""
    found = np.full((len(one), len(other)), np.inf)
    for mine in np.moveaxis(one, 0, -1):
        for theirs in np.moveaxis(other, 0, -1):
            np.fmin(found, squared(mine[:, :, None], theirs[:, None, :]), out=found)
    return found
