"""Decisions of a person, recorded in the layout that heeds them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from usdrigui.character import Floats, Rig
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import ONE_PLACE, Decision, Element, Layout, in_order
from usdrigui.model.levels import with_levels


def with_decisions(layout: Layout, rig: Rig, rest: Floats, requests: Requests) -> Layout:
    """The layout with the decisions of a person in it: those of the configuration, and those
    carried.  `rest` (n, 3) are the points at rest."""
    index = rig.control_indices
    decided = {element.name: _configured(element, index, requests) for element in layout.elements}
    before: dict[str, tuple[float, float, float]] = {}
    for element, inner in with_levels(layout.elements):
        controls = element.controls
        for pin in requests.pins.pins:
            if pin.inner == inner and not controls.isdisjoint(pin.controls):
                here = element.anchor.place == (pin.anchor or "board")
                decided[element.name] |= {k for k in pin.decisions if k != "anchor" or here}
                before |= {element.name: pin.position} if pin.anchor else {}
    mirrored = [
        element.name
        for element in layout.elements
        if "anchor" in decided.get(element.mirror, ())
        and any(requests.overrides[index[name]].anchor for name in element.controls)
    ]
    for name in mirrored:
        decided[name].add("anchor")

    def pinned(element: Element) -> Element:
        kinds, anchor = decided[element.name], element.anchor
        if anchor.on_board:
            kinds.discard("anchor")
        element = replace(element, pinned=in_order(kinds))
        if "anchor" in kinds:
            here = rest[anchor.on(rig.body)]
            # The place that was decided stays on record while it is the same place: carrying it on
            # adds up no errors.
            then = np.array(before.get(element.name, (np.nan,) * 3))
            near = float(np.linalg.norm(here - then)) <= ONE_PLACE * layout.frame.handle_width
            x, y, z = (then if near else here).tolist()
            element = replace(element, pinned_position=(x, y, z))
        return element

    return replace(layout, elements=tuple(pinned(element) for element in layout.elements))


def _configured(element: Element, index: Mapping[str, int], requests: Requests) -> set[Decision]:
    """What the configuration decides about an element."""
    controls = element.controls
    asked = [requests.configured[index[name]] for name in controls]
    found: set[Decision] = {"anchor"} if any(each.anchor for each in asked) else set()
    found |= {"place"} if any(each.place or each.near for each in asked) else set()
    return found | ({"grouping"} if controls in map(frozenset, requests.groups.values()) else set())
