"""An earlier layout that the new one should be like: what was where, and what it costs to leave it.

A precedent is soft.  Its groups stand where they still can, and every other place than the earlier one
has a price, so that a control moves when that gains more than the price and stays otherwise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from usdrigui.levels import inner_names, outer_first
from usdrigui.model import Element, Floats, Indices, Layout, Record, Rig, RigMesh


@dataclass(frozen=True, slots=True)
class KeptGroup:
    """Controls that shared an element, or one that had its own."""

    name: str
    """Name of the element; empty when it is to be made from its controls."""
    controls: tuple[int, ...]
    """Indices into `Rig.controls`."""
    opposed: tuple[tuple[int, int], ...]
    """Pairs of positions in `controls`."""


@dataclass(frozen=True, eq=False)
class Place(Record):
    """Where a control stood."""

    point: int
    """The same point of today's rig, or -1 where the mesh has other points by now."""
    position: Floats
    """(3,) in root space."""
    beside: bool


@dataclass(frozen=True, eq=False)
class Precedent(Record):
    """What an earlier layout asks of the new one."""

    groups: tuple[KeptGroup, ...] = ()
    places: Mapping[int, Place] = field(default_factory=dict)
    """By index into `Rig.controls`; controls without a place are free."""
    parts: Mapping[int, Place] = field(default_factory=dict)
    """The same for the sliders that controls have of their own under a coarse element."""
    price: float = 0.0
    """Cost of leaving a place, per copy of the element, in the units of the objective."""
    reach: float = 0.0
    """Distance at which the full price is due, in handle widths; 0 asks it of every other point."""


NONE = Precedent()


def of_previous(layout: Layout, rig: Rig, price: float) -> Precedent:
    """The precedent of an earlier layout of the same character; none at all at a price of 0."""
    if price <= 0.0:
        return NONE
    return Precedent(kept_groups(layout, rig), *_places(layout, rig), price)


def joined(first: Precedent, second: Precedent) -> Precedent:
    """Both precedents: where both speak of a control, the first is heard; the price is the second's."""
    taken = {control for group in first.groups for control in group.controls}
    others = tuple(group for group in second.groups if not taken & set(group.controls))
    return replace(
        second,
        groups=(*first.groups, *others),
        places={**second.places, **first.places},
        parts={**second.parts, **first.parts},
    )


def kept_groups(layout: Layout, rig: Rig) -> tuple[KeptGroup, ...]:
    """The groups of a layout, without the controls that `rig` no longer has; each control in one only."""
    index = {control.name: number for number, control in enumerate(rig.controls)}
    groups: list[KeptGroup] = []
    taken: set[int] = set()
    for element in outer_first(layout.elements):
        kept = [place for place, member in enumerate(element.members) if index.get(member.control, -1) not in taken]
        kept = [place for place in kept if element.members[place].control in index]
        if not kept:
            continue
        controls = tuple(index[element.members[place].control] for place in kept)
        opposed = tuple((kept.index(a), kept.index(b)) for a, b in element.opposed if a in kept and b in kept)
        groups.append(KeptGroup(element.name if len(kept) == len(element.members) else "", controls, opposed))
        taken |= set(controls)
    return tuple(groups)


def leaving(precedent: Precedent, controls: Sequence[int], anchors: Indices, base: Floats, width: float) -> Floats:
    """(R,) what each candidate of one copy of an element costs because it is not the earlier place.

    Parameters: `anchors` (R,) points; `base` (n, 3) positions; `width` of a handle.  An element that stood
    beside the face pays the whole price for every place on it.
    """
    cost = np.zeros(len(anchors))
    for control in controls:
        place = precedent.places.get(control)
        if place is None:
            continue
        cost = np.maximum(cost, precedent.price * _share_due(precedent, place, anchors, base, width))
    return cost


def stood_on_face(precedent: Precedent, controls: Sequence[int]) -> bool:
    """Whether any of these controls had its place on the face."""
    return any(control in precedent.places and not precedent.places[control].beside for control in controls)


def _share_due(precedent: Precedent, place: Place, anchors: Indices, base: Floats, width: float) -> Floats:
    """(R,) share of the price, from 0 at the earlier place to 1."""
    if place.beside or not len(anchors):
        return np.ones(len(anchors))
    if precedent.reach > 0.0:
        apart = np.linalg.norm(base[anchors] - place.position, axis=1)
        # Counted from the nearest candidate: where none is near, the nearest are still to be preferred.
        return np.asarray(np.minimum(1.0, (apart - apart.min()) / (precedent.reach * width)))
    here = anchors == place.point
    if not here.any():
        # The mesh has other points, or the control no longer moves that one: the nearest place stands for it.
        here[int(np.argmin(np.linalg.norm(base[anchors] - place.position, axis=1)))] = True
    return np.where(here, 0.0, 1.0)


def _places(layout: Layout, rig: Rig) -> tuple[dict[int, Place], dict[int, Place]]:
    """The places of the controls, and those of the sliders that some have besides under a coarse element."""
    index = {control.name: number for number, control in enumerate(rig.controls)}
    meshes = {mesh.path: (int(start), mesh) for start, mesh in zip(rig.starts, rig.meshes, strict=False)}
    places: dict[int, Place] = {}
    parts: dict[int, Place] = {}
    inner = inner_names(layout.elements)
    for element in outer_first(layout.elements):
        place = Place(_same_point(element, meshes), element.anchor.position, element.anchor.beside)
        for control in (index[member.control] for member in element.members if member.control in index):
            if control not in places:
                places[control] = place
            elif element.name in inner:
                parts[control] = place
    return places, parts


def _same_point(element: Element, meshes: Mapping[str, tuple[int, RigMesh]]) -> int:
    """The anchor as a point of today's rig; -1 where its mesh is gone or has other points or faces."""
    anchor = element.anchor
    if anchor.mesh not in meshes:
        return -1
    start, mesh = meshes[anchor.mesh]
    same = not anchor.topology_hash or anchor.topology_hash == mesh.topology_hash
    return start + anchor.point if same and 0 <= anchor.point < len(mesh.points) else -1
