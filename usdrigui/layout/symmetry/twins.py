"""Twin controls: which control is the mirror image of which (paper section 3.3, symmetric
elements).

Two controls are twins when one's motion, mirrored, is the other's; or, of controls that go both
ways, its reverse (the yaw of two eyes turned by the same joint axis).  Names are hints that decide
only where the motions leave room; the configuration has the last word.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import combinations_with_replacement

import networkx as nx
import numpy as np

from usdrigui.character import Flags, Floats, Indices, Rig, Singles
from usdrigui.conventions.sides import has_side, hints_at_twin
from usdrigui.errors import Faults, check_known
from usdrigui.layout.control_overrides import control_index, control_overrides
from usdrigui.layout.motion.similarity import (
    DisplacementFields,
    bidirectional,
    displacement_fields,
    rows_of,
)
from usdrigui.layout.shares import HARDLY_ANY
from usdrigui.layout.symmetry.sides_of_joints import mirrored_joints
from usdrigui.model import MirrorPlane, Motion, Symmetry, Trajectories
from usdrigui.settings import ControlSettings, Settings
from usdrigui.ties import steady

_NAME_FLOOR = 0.3
"""Least agreement of the motions of two controls that only their names call twins."""


def paired(
    rig: Rig,
    trajectories: Trajectories,
    mirror: tuple[MirrorPlane, Indices],
    settings: Settings,
) -> Symmetry:
    """The symmetry with the twin of every control.

    `mirror` are the mirror plane and the partners (n,) of all points, where the `trajectories` are.
    """
    motions, (plane, partner) = trajectories.motions, mirror
    configured = configured_twins(rig, settings.controls)
    least = settings.symmetry.twin_similarity
    count = len(rig.controls)
    twins, sources = np.full(count, -1, dtype=np.int64), [""] * count
    reversed_twins = np.zeros(count, dtype=bool)
    for control, twin in configured.items():
        twins[control], sources[control] = twin, "config"
    if plane.normal.any():
        raw = agreements(displacement_fields(trajectories), partner, plane.normal)
        raw = 0.5 * (raw + raw.T)
        free = [i for i, motion in enumerate(motions) if motion.control not in configured]
        names = [rig.control_names[motion.control] for motion in motions]
        agreed, mirrored = pairable(raw, motions), _mirrored_by(rig, motions, plane)
        possible = {}
        for i, j in combinations_with_replacement(free, 2):
            hinted = hints_at_twin(names[i], names[j]) if i != j else not has_side(names[i])
            of_joints = mirrored(i, j)
            believed = i != j and (hinted or of_joints is True)
            floor = min(least, _NAME_FLOOR) if believed else least
            if of_joints is not False and agreed[i, j] >= floor and agreed[i, j] > 0.0:
                # A name that matches decides between those that agree alike.
                possible[i, j] = float(agreed[i, j]) + (HARDLY_ANY if hinted else 0.0)
        for i, j in _matched(possible, names):
            a, b = motions[i].control, motions[j].control
            twins[a], twins[b] = b, a
            sources[a] = sources[b] = "geometry" if agreed[i, j] >= least else "name"
        reversed_twins = _reversed(motions, twins, raw)
    apart = plane.distance(trajectories.surface.points)
    return Symmetry(plane, partner, apart, twins, tuple(sources), reversed_twins)


def _reversed(motions: tuple[Motion, ...], twins: Indices, raw: Floats) -> Flags:
    """(controls,) whether a control's mirror image is its twin going the other way."""
    row = {motion.control: i for i, motion in enumerate(motions)}
    two_sided = {motions[i].control for i in bidirectional(motions)}
    flags = np.zeros(len(twins), dtype=bool)
    for control in two_sided:
        twin = int(twins[control])
        flags[control] = (
            twin != control and twin in two_sided and raw[row[control], row[twin]] < 0.0
        )
    return flags


def agreements(fields: DisplacementFields, partner: Indices, normal: Floats) -> Floats:
    """(motions, motions) agreement of each motion, mirrored, with each other, in [-1, 1].

    ``2 <a, b> / (|a|^2 + |b|^2)`` over the vectors from the minimum to the maximum of the control
    at all places that have a partner: 1 for exact mirror images, less where direction, region or
    measure differ.  Rounded: an agreement may be just the least that counts.
    """
    mirrored, weights = _mirrored(fields, partner, normal)
    product = fields.products(mirrored)
    one, other = (
        DisplacementFields(fields.places, vectors, weights).sizes()
        for vectors in (mirrored, fields.vectors)
    )
    both = one[:, None] + other[None, :]
    return steady(np.divide(2.0 * product, both, out=np.zeros_like(product), where=both > 0.0))


def pairable(raw: Floats, motions: tuple[Motion, ...]) -> Floats:
    """`agreements` with the sign dropped between controls that swing to both sides: such a one is
    symmetric when its mirror image is its own reverse, and so are two."""
    swings = np.zeros(len(raw), dtype=bool)
    swings[list(bidirectional(motions))] = True
    return np.where(swings[:, None] & swings[None, :], np.abs(raw), raw)


def _mirrored(
    fields: DisplacementFields, partner: Indices, normal: Floats
) -> tuple[Singles, Floats]:
    """The mirrored vectors (motions, m, 3) and the weights (m,) of the places, both zero where the
    partner is none of them."""
    row = rows_of(fields.places, len(partner))
    images = partner[fields.places]
    source = np.where(images >= 0, row[images], -1)
    turn = (np.eye(3) - 2.0 * np.outer(normal, normal)).astype(np.float32)
    mirrored = fields.vectors[:, source] @ turn
    mirrored[:, source < 0] = 0.0
    return mirrored, np.where(source >= 0, fields.weights, 0.0)


def configured_twins(rig: Rig, controls: Mapping[str, ControlSettings]) -> dict[int, int]:
    """The controls whose twin the configuration names, to that; -1 where they are to have none.

    Raises CONFIG_UNKNOWN_CONTROL for a twin that is no control.
    """
    index, faults = control_index(rig, controls), Faults()
    found: dict[int, int] = {}
    for own, override in enumerate(control_overrides(rig, controls)):
        if override.twin:
            with faults.collected():
                found[own] = other = _named_twin(own, rig.control_names[own], override.twin, index)
                if other >= 0:
                    found[other] = own
    faults.raise_all()
    return found


def _named_twin(own: int, name: str, twin: str, index: dict[str, int]) -> int:
    if twin in ("self", "none"):
        return own if twin == "self" else -1
    check_known(twin, index, f'controls."{name}".twin')
    return index[twin]


def _matched(pairs: Mapping[tuple[int, int], float], names: Sequence[str]) -> list[tuple[int, int]]:
    """Disjoint pairs of controls (a control with itself: self-symmetric) that agree best, all at
    once; `pairs` (i <= j) are those that may be, and how well each control agrees.

    A matching of greatest weight (Edmonds; `networkx.max_weight_matching`): a pair weighs what both
    of its controls agree, a control that is its own mirror image is matched with a node of its own.
    Where weights tie, the pair whose names come first is matched.
    """
    by_name = sorted(pairs, key=lambda pair: sorted(names[i] for i in pair), reverse=True)
    graph = nx.Graph()
    for rank, (i, j) in enumerate(by_name):
        # Whole numbers: the matching is exact, and the ranks of all pairs together weigh less than
        # one unit.
        whole = round(1e9 * pairs[i, j] * (1.0 if i == j else 2.0))
        graph.add_edge(i, j if i != j else -1 - i, weight=len(by_name) ** 2 * whole + rank)
    found = (
        tuple(sorted(i if i >= 0 else -1 - i for i in pair))
        for pair in nx.max_weight_matching(graph)
    )
    return sorted((i, j) for i, j in found)


def _mirrored_by(
    rig: Rig, motions: tuple[Motion, ...], plane: MirrorPlane
) -> Callable[[int, int], bool | None]:
    """Whether two motions are of joints that mirror each other; None for motions of which one is
    not of joints."""
    images = mirrored_joints(rig.body, plane)
    controls = [rig.controls[motion.control] for motion in motions]
    first = [int(each.drive.joints[0]) if each.kind == "joint" else -1 for each in controls]

    def mirrored(i: int, j: int) -> bool | None:
        return images.get(first[i]) == first[j] if min(first[i], first[j]) >= 0 else None

    return mirrored
