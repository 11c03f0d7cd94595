"""An earlier layout that the new one should be like: what was where, and what it costs to leave it.

It is a soft request.  Its groups are kept where they still can be, and every other place than the
earlier one costs a penalty, so that a control moves when that improves the cost by more than the
penalty and stays otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import cast

import numpy as np

from usdrigui.character import Floats, Indices, Record, Rig
from usdrigui.layout.face import FAR
from usdrigui.layout.reuse.carrying import Today, carried
from usdrigui.model import Category, Element, Layout
from usdrigui.model.levels import inner_names, outer_first
from usdrigui.ties import first_smallest


@dataclass(frozen=True, slots=True)
class KeptGroup:
    """Controls that shared an element, or one that had its own."""

    name: str
    """Name of the element; empty when it is to be made from its controls."""
    controls: tuple[int, ...]
    """Indices into `Rig.controls`."""
    opposed: tuple[tuple[int, int], ...]
    """Pairs of positions in `controls`."""
    doubled: bool = False
    """Whether it had a handle on either side of the middle."""


class Place(Record):
    """The earlier place of a control."""

    point: int
    """The point of today's rig that is there, or -1 where none is."""
    position: Floats
    """(3,) in root space."""
    on_board: bool
    category: Category = ""
    """Why it was on the board for good; empty where there was no room for it, or a person wanted it
    there, and on the face."""
    reason: str = ""
    """The same in words."""


class PriorLayout(Record):
    """What an earlier layout asks of the new one."""

    groups: tuple[KeptGroup, ...] = ()
    places: Mapping[int, Place] = field(default_factory=dict)
    """By index into `Rig.controls`; controls without a place are free."""
    axis_places: Mapping[int, Place] = field(default_factory=dict)
    """The same for the sliders that controls have of their own under a coarse element."""
    penalty: float = 0.0
    """Cost of leaving a place, per copy of the element, in the units of the objective."""
    cutoff_distance: float = 0.0
    """Distance at which the full penalty is due, in handle widths; 0 asks it of every other
    point, and more of those beyond a handle's width."""

    @property
    def leaving_penalty(self) -> float:
        """Cost of leaving the face, per copy: what an earlier place costs so far away."""
        return self.penalty * (1.0 if self.cutoff_distance else FAR**2)

    def stood_on_face(self, controls: Sequence[int]) -> bool:
        """Whether any of these controls had its place on the face."""
        return any(
            control in self.places and not self.places[control].on_board for control in controls
        )

    def stood_on_board(self, controls: Sequence[int]) -> bool:
        """Whether all of these controls had their place on the board."""
        return all(control in self.places and self.places[control].on_board for control in controls)


NO_PRIOR = PriorLayout()


def prior_of_previous(layout: Layout, today: Today, penalty: float) -> PriorLayout:
    """An earlier layout of the same character as a prior; no prior at a penalty of 0.  `today` has
    the points of the base pose."""
    if penalty <= 0.0:
        return NO_PRIOR
    places = places_of(
        layout.elements, today.rig.control_indices, lambda element: _place(element, today)
    )
    return PriorLayout(kept_groups(layout.elements, today.rig), *places, penalty)


def joined(first: PriorLayout, second: PriorLayout) -> PriorLayout:
    """Both priors: the first decides for a control that both place; the penalty is the second's."""
    taken = set().union(*(group.controls for group in first.groups))
    others = tuple(group for group in second.groups if not taken & set(group.controls))
    return replace(
        second,
        groups=(*first.groups, *others),
        places={**second.places, **first.places},
        axis_places={**second.axis_places, **first.axis_places},
    )


def kept_groups(elements: tuple[Element, ...], rig: Rig) -> tuple[KeptGroup, ...]:
    """The groups of a layout, without the controls that `rig` no longer has; each control in one
    only."""
    index = rig.control_indices
    groups: list[KeptGroup] = []
    taken: set[int] = set()
    by_name = {element.name: element.controls for element in elements}
    for element in outer_first(elements):
        members = element.members
        kept = [
            place
            for place, member in enumerate(members)
            if member.control in index and index[member.control] not in taken
        ]
        if not kept:
            continue
        controls = tuple(index[members[place].control] for place in kept)
        opposed = tuple(
            (kept.index(a), kept.index(b)) for a, b in element.opposed if a in kept and b in kept
        )
        name = element.name if len(kept) == len(members) else ""
        doubled = by_name.get(element.mirror) == element.controls
        groups.append(KeptGroup(name, controls, opposed, doubled))
        taken |= set(controls)
    return tuple(groups)


def leaving_penalties(
    prior: PriorLayout, controls: Sequence[int], anchors: Indices, base: Floats, width: float
) -> Floats:
    """(R,) what each candidate of one copy of an element costs because it is not the earlier place.

    Parameters: `anchors` (R,) points; `base` (n, 3) positions; `width` of a handle.  An element
    that was on the board pays the whole penalty for every place on the face.
    """
    cost = np.zeros(len(anchors))
    for control in controls:
        place = prior.places.get(control)
        if place is None:
            continue
        cost = np.maximum(cost, prior.penalty * _penalty_share(prior, place, anchors, base, width))
    return cost


def _penalty_share(
    prior: PriorLayout, place: Place, anchors: Indices, base: Floats, width: float
) -> Floats:
    """(R,) share of the penalty: 0 at the earlier place, 1 within a handle's width of it, its
    distance squared beyond; in proportion to it and at most 1 where there is a cutoff."""
    if place.on_board or not len(anchors):
        return np.ones(len(anchors))
    if prior.cutoff_distance > 0.0:
        apart = np.linalg.norm(base[anchors] - place.position, axis=1)
        # Counted from the nearest candidate: where none is near, the nearest are still to be
        # preferred.
        return np.asarray(np.minimum(1.0, (apart - apart.min()) / (prior.cutoff_distance * width)))
    here = anchors == place.point
    apart = np.linalg.norm(base[anchors] - place.position, axis=1) / width
    if not here.any():
        # The mesh has other points, or the control no longer moves that one: the nearest place
        # stands for it.
        here[first_smallest(apart)] = True
    # Further than a handle's width from the nearest place that it may keep, it is another place.
    return np.where(here, 0.0, np.maximum(1.0, np.square(apart - apart[here].min())))


def places_of(
    elements: Sequence[Element], index: Mapping[str, int], place: Callable[[Element], Place]
) -> tuple[dict[int, Place], dict[int, Place]]:
    """The places of the controls of some elements, and those of the sliders that some have besides
    under a coarse element; `index` finds controls by name."""
    places: dict[int, Place] = {}
    axis_places: dict[int, Place] = {}
    inner = inner_names(elements)
    for element in outer_first(elements):
        here = place(element)
        for control in (index[m.control] for m in element.members if m.control in index):
            if control not in places:
                places[control] = here
            elif element.name in inner:
                axis_places[control] = here
    return places, axis_places


def _place(element: Element, today: Today) -> Place:
    """Where an element was, at the point of today's rig that is nearest to there."""
    anchor, known = element.anchor, today.rig.control_indices
    if not anchor.on_board:
        controls = [m.control for m in element.members if m.control in known]
        point, _ = carried(anchor, anchor.position, controls, today)
        return Place(point, anchor.position, False)
    kept = element.category not in ("crowded", "requested")
    category, reason = (cast(Category, element.category), element.reason) if kept else ("", "")
    return Place(-1, anchor.position, True, category, reason)
