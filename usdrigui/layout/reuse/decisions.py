"""Decisions of a person, recorded in the layout that heeds them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from usdrigui.character import Floats, Rig
from usdrigui.layout.reuse.pinned import Pin, Pins
from usdrigui.layout.reuse.prior_layout import ONE_PLACE
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import Decision, Element, Layout
from usdrigui.model.levels import outer_first


def with_decisions(layout: Layout, rig: Rig, rest: Floats, requests: Requests) -> Layout:
    """The layout with the decisions of a person in it: those of the configuration, and those
    carried.  `rest` (n, 3) are the points at rest."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    carried = list(_of_pins(layout.elements, requests.pins))
    decided = {element.name: _configured(element, index, requests) for element in layout.elements}
    for element, pin in carried:
        here = element.anchor.place == (pin.anchor or "board")
        decided[element.name] |= {each for each in pin.decisions if each != "anchor" or here}
    mirrored = [
        element.name
        for element in layout.elements
        if "anchor" in decided.get(element.manipulator.mirror, ())
        and any(requests.overrides[index[name]].anchor for name in element.manipulator.controls)
    ]
    for name in mirrored:
        decided[name].add("anchor")
    before = {element.name: pin.position for element, pin in carried if pin.anchor}

    def pinned(element: Element) -> Element:
        kinds, anchor = decided[element.name], element.anchor
        if anchor.on_board:
            kinds.discard("anchor")
        placement = replace(element.placement, pinned=tuple(k for k in _ORDER if k in kinds))
        if "anchor" in kinds:
            here = rest[rig.body.point_of(anchor.mesh, anchor.point)]
            # The place that was decided stays on record while it is the same place: carrying it on
            # adds up no errors.
            then = np.array(before.get(element.name, (np.nan,) * 3))
            near = float(np.linalg.norm(here - then)) <= ONE_PLACE * layout.frame.handle_width
            x, y, z = (then if near else here).tolist()
            placement = replace(placement, pinned_position=(x, y, z))
        return replace(element, placement=placement)

    return replace(layout, elements=tuple(pinned(element) for element in layout.elements))


_ORDER: tuple[Decision, ...] = ("anchor", "place", "grouping")


def _configured(element: Element, index: Mapping[str, int], requests: Requests) -> set[Decision]:
    """What the configuration decides about an element."""
    controls = element.manipulator.controls
    asked = [requests.configured[index[name]] for name in controls]
    found: set[Decision] = {"anchor"} if any(each.anchor for each in asked) else set()
    found |= {"place"} if any(each.place or each.near for each in asked) else set()
    return found | ({"grouping"} if controls in map(frozenset, requests.groups.values()) else set())


def _of_pins(elements: tuple[Element, ...], pins: Pins) -> Iterator[tuple[Element, Pin]]:
    """The elements that have the controls of a pin, each on its level."""
    held: set[str] = set()
    for element in outer_first(elements):
        controls = element.manipulator.controls
        inner = bool(held & controls)
        held |= controls
        for pin in pins.pins:
            if pin.inner == inner and controls & set(pin.controls):
                yield element, pin
