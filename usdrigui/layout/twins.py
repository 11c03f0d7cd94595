"""Twin controls: which control is the mirror image of which (paper section 3.3, symmetric elements).

Two controls are twins when one's motion, mirrored, is the other's.  Names are hints that decide only
where the motions leave room; the configuration has the last word.
"""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.layout.names import has_side, hints_at_twin
from usdrigui.layout.trajectory import ends
from usdrigui.model import Floats, Indices, Rig, Trajectories
from usdrigui.settings import ControlSettings, Settings

_NAME_BONUS = 0.15
"""What a matching name adds to the agreement of two controls."""
_NAME_FLOOR = 0.3
"""Least agreement of the motions of two controls that only their names call twins."""
_CHUNK = 8192
"""Points compared at a time: bounds the memory."""


def find_twins(
    rig: Rig, trajectories: Trajectories, partner: Indices, normal: Floats, settings: Settings
) -> tuple[Indices, tuple[str, ...]]:
    """Twin of every control and how it was decided, as in `Symmetry.twins` and `Symmetry.sources`."""
    count = len(rig.controls)
    twins, sources = np.full(count, -1, dtype=np.int64), [""] * count
    fixed = _configured(rig, settings, twins, sources)
    if normal.any():
        free = [i for i, motion in enumerate(trajectories.motions) if motion.control not in fixed]
        for a, b, source in _matched(rig, trajectories, partner, normal, free, settings.symmetry.twin_similarity):
            twins[a], twins[b] = b, a
            sources[a] = sources[b] = source
    return twins, tuple(sources)


def agreements(trajectories: Trajectories, partner: Indices, normal: Floats) -> Floats:
    """(motions, motions) agreement of each motion, mirrored, with each other, in [-1, 1].

    ``2 <a, b> / (|a|^2 + |b|^2)`` over the vectors from the minimum to the maximum of the control at all
    places that have a partner: 1 for exact mirror images, less where direction, region or measure differ.
    """
    places = np.flatnonzero((trajectories.places == np.arange(len(partner))) & (partner >= 0))
    count = len(trajectories.motions)
    product, own, mirrored = np.zeros((count, count)), np.zeros(count), np.zeros(count)
    if not len(places):
        return product
    fields = [ends(motion, len(partner)) for motion in trajectories.motions]
    for start in range(0, len(places), _CHUNK):
        chunk = places[start : start + _CHUNK]
        here = np.stack([field[chunk] for field in fields]).astype(np.float64)
        there = np.stack([field[partner[chunk]] for field in fields]).astype(np.float64)
        there -= 2.0 * (there @ normal)[..., None] * normal
        here, there = here.reshape(count, -1), there.reshape(count, -1)
        product += there @ here.T
        own += np.square(here).sum(axis=1)
        mirrored += np.square(there).sum(axis=1)
    both = mirrored[:, None] + own[None, :]
    return np.divide(2.0 * product, both, out=np.zeros_like(product), where=both > 0.0)


def _configured(rig: Rig, settings: Settings, twins: Indices, sources: list[str]) -> set[int]:
    """Enter what the configuration says into `twins` and `sources`; returns the controls it decides."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    fixed: set[int] = set()
    for name, said in settings.controls.items():
        if not said.twin or name not in index:
            continue
        own = index[name]
        other = _named_twin(own, name, said, index)
        fixed |= {own, other} - {-1}
        twins[own] = other
        sources[own] = "config"
        if other >= 0:
            twins[other], sources[other] = own, "config"
    return fixed


def _named_twin(own: int, name: str, said: ControlSettings, index: dict[str, int]) -> int:
    if said.twin in ("self", "none"):
        return own if said.twin == "self" else -1
    if said.twin not in index:
        raise refuse("CONFIG_UNKNOWN_CONTROL", f'controls."{name}".twin', f"no control is called {said.twin!r}")
    return index[said.twin]


def _matched(
    rig: Rig, trajectories: Trajectories, partner: Indices, normal: Floats, free: list[int], least: float
) -> list[tuple[int, int, str]]:
    """Disjoint pairs of controls (a control with itself: self-symmetric), the best agreement first."""
    raw = agreements(trajectories, partner, normal)
    raw = 0.5 * (raw + raw.T)
    names = [rig.controls[motion.control].name for motion in trajectories.motions]
    ranked = []
    for i in free:
        for j in free:
            if j < i or raw[i, j] <= 0.0:
                continue
            named = hints_at_twin(names[i], names[j]) if i != j else not has_side(names[i])
            floor = min(least, _NAME_FLOOR) if named and i != j else least
            if raw[i, j] >= floor:
                score = raw[i, j] + (_NAME_BONUS if named else 0.0)
                source = "geometry" if raw[i, j] >= least else "name"
                ranked.append((-round(score, 9), min(names[i], names[j]), max(names[i], names[j]), i, j, source))
    taken: set[int] = set()
    pairs = []
    for *_, i, j, source in sorted(ranked):
        if i not in taken and j not in taken:
            taken |= {i, j}
            pairs.append((trajectories.motions[i].control, trajectories.motions[j].control, source))
    return pairs
