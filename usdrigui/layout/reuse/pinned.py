"""Decisions of a person: carried from the layout that records them to the rig of today, and
recorded in its layout.

A correction holds through reprocessing, renames, other vertex orders and other topology: an anchor
that is pinned goes to the same point, or on another mesh to the nearest one that its controls move,
and says so where that is not near.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from usdrigui.errors import Issue, RigUIError, issue
from usdrigui.layout.reuse.partial_layout import MIRROR, fixed_anchor, place_of
from usdrigui.layout.reuse.prior_layout import points_of_meshes, same_point
from usdrigui.layout.symmetry.mirror_plane import reflected
from usdrigui.model import (
    Body,
    Decision,
    Element,
    Floats,
    Indices,
    Layout,
    Placement,
    Rig,
    Symmetry,
    Trajectories,
)
from usdrigui.model.levels import outer_first
from usdrigui.settings import ControlSettings
from usdrigui.ties import first_smallest

_NEAR = 0.5
"""Handle widths within which a place is the same place."""
_MOVES = 0.05
"""Share of its peak by which a control moves a point to which it may be carried."""
_SHARED = 0.25
"""Share of its peak by which a control moves a point that is its own as well as its twin's."""


@dataclass(frozen=True)
class Pin:
    """What a person has decided about one element, on the rig of today."""

    element: str
    controls: tuple[str, ...]
    decisions: tuple[Decision, ...]
    anchor: str = ""
    """``MESH_PATH#POINT`` where it is pinned to a point."""
    place: str = ""
    """``board`` or ``face`` where only that is decided."""
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """At rest, on the rig for which the anchor was decided."""
    inner: bool = False
    """Whether the element is a member of a coarse one that has its controls, too."""


@dataclass(frozen=True)
class Pins:
    """The decisions that an earlier layout records, and what could not be carried."""

    pins: tuple[Pin, ...] = ()
    issues: tuple[Issue, ...] = ()

    def without(self, error: RigUIError) -> Pins | None:
        """The rest, if the error is of an anchor that one of the pins fixes; none if it is not."""
        named = [pin for pin in self.pins if pin.anchor and _is_about(error.issue.path, pin)]
        if error.issue.code != "FIXED_IMPOSSIBLE" or not named:
            return None
        lost = tuple(issue("PIN_LOST", pin.element, error.issue.message) for pin in named)
        kept = (replace(pin, anchor="") if pin in named else pin for pin in self.pins)
        return Pins(tuple(kept), (*self.issues, *lost))


def _is_about(path: str, pin: Pin) -> bool:
    return path == pin.element or any(
        path in (name, f'controls."{name}".anchor') for name in pin.controls
    )


def pins_of(layout: Layout, rig: Rig, rest: Floats, trajectories: Trajectories) -> Pins:
    """The pins of an earlier layout of a character, by its names of today; `rest` (n, 3) are its
    points at rest.

    Controls that are gone leave their decisions to the others of the element.
    """
    pins, issues = [], []
    held: set[str] = set()
    for element in outer_first(layout.elements):
        members, placement = element.manipulator.members, element.placement
        known = tuple(m.control for m in members if m.control in {c.name for c in rig.controls})
        inner = bool(held & set(known))
        held |= set(known)
        if not placement.pinned or not known:
            continue
        anchor, problem = "", None
        if "anchor" in placement.pinned and not element.anchor.on_board:
            width = layout.frame.handle_width_of(placement.part)
            anchor, problem = _carried(element, known, width, rig, rest, trajectories)
        place = (
            ("board" if element.anchor.on_board else "face")
            if "place" in placement.pinned and not anchor
            else ""
        )
        pins.append(
            Pin(
                element.name,
                known,
                placement.pinned,
                anchor,
                place,
                placement.pinned_position,
                inner,
            )
        )
        issues += [problem] if problem is not None else []
    return Pins(tuple(pins), tuple(issues))


def _carried(
    element: Element,
    controls: Sequence[str],
    width: float,
    rig: Rig,
    rest: Floats,
    trajectories: Trajectories,
) -> tuple[str, Issue | None]:
    """Where the pinned anchor of an element is today, empty if nowhere, and an issue about
    it."""
    moved = _moved_by_all(controls, rig, trajectories)
    same = same_point(element.anchor, points_of_meshes(rig.body.meshes, rig.body.starts))
    if same >= 0 and same in moved:
        return place_of(rig.body, same), None
    if not len(moved) or not np.isfinite(element.placement.pinned_position).all():
        why = (
            "its controls move no point together"
            if not len(moved)
            else "its mesh has other points or faces by now"
        )
        return "", issue("PIN_LOST", element.name, why)
    apart = np.linalg.norm(rest[moved] - element.placement.pinned_position, axis=1)
    nearest = first_smallest(apart)
    off = float(apart[nearest]) / max(width, 1e-300)
    message = f"is {off:.1f} handle widths from where it was pinned"
    return place_of(rig.body, int(moved[nearest])), (
        issue("PIN_CARRIED", element.name, message) if off > _NEAR else None
    )


def _moved_by_all(controls: Sequence[str], rig: Rig, trajectories: Trajectories) -> Indices:
    """Points that every one of these controls moves by a share of its peak; none where one of them
    moves nothing."""
    by_name = {rig.controls[motion.control].name: motion for motion in trajectories.motions}
    found = np.arange(len(trajectories.surface.points))
    for motion in (by_name.get(name) for name in controls):
        far = (
            motion.points[motion.arc_length >= _MOVES * motion.peak]
            if motion is not None
            else found[:0]
        )
        found = np.intersect1d(found, far)
    return found


def with_pins(controls: Mapping[str, ControlSettings], pins: Pins) -> dict[str, ControlSettings]:
    """What the configuration says of controls, with what the pins fix; what it says itself is
    stronger."""
    renamed = {each.rename: name for name, each in controls.items() if each.rename}
    found = dict(controls)
    for pin in pins.pins:
        for control in pin.controls:
            name = renamed.get(control, control)
            override = found.get(name, ControlSettings())
            if pin.inner:
                found[name] = replace(override, inner_anchor=override.inner_anchor or pin.anchor)
            elif not (override.anchor or override.place or override.near):
                found[name] = _decided(override, pin)
    return found


def _decided(override: ControlSettings, pin: Pin) -> ControlSettings:
    if pin.anchor:
        return replace(override, anchor=pin.anchor)
    return (
        replace(override, place="board" if pin.place == "board" else "face")
        if pin.place
        else override
    )


def with_twins(
    rig: Rig, trajectories: Trajectories, symmetry: Symmetry, overrides: tuple[ControlSettings, ...]
) -> tuple[ControlSettings, ...]:
    """The overrides with the anchor of one side on the other, too, and the mirror image of what one
    stays near, where nothing is decided about that."""
    found = list(overrides)
    for control, override in enumerate(overrides):
        twin = int(symmetry.twins[control])
        if twin in (-1, control) or not _follows(overrides[twin]):
            continue
        if override.near and not override.anchor:
            found[twin] = replace(
                overrides[twin], near=MIRROR + override.near, within=override.within
            )
        if override.anchor:
            point = fixed_anchor(rig, rig.controls[control].name, override.anchor)
            image = -1 if point is None else _image(trajectories, symmetry, twin, point)
            if image >= 0:
                found[twin] = replace(overrides[twin], anchor=place_of(rig.body, image))
    return tuple(found)


def _follows(override: ControlSettings) -> bool:
    return override.follow_twin and not (
        override.anchor or override.place or override.near or override.exclude
    )


def _image(trajectories: Trajectories, symmetry: Symmetry, twin: int, point: int) -> int:
    """The mirror image of a point, or what the twin moves nearest to that; -1 where it moves
    nothing, or that point too: the two ends of a jaw's axis may be one element."""
    motion = next((each for each in trajectories.motions if each.control == twin), None)
    if motion is None or motion.arc_length[motion.points == point].sum() >= _SHARED * motion.peak:
        return -1
    partner = int(symmetry.partner[point])
    if partner in motion.points:
        return partner
    there = reflected(trajectories.surface.points[point], symmetry.plane)
    far = motion.points[motion.arc_length >= _MOVES * motion.peak]
    return int(
        far[first_smallest(np.linalg.norm(trajectories.surface.points[far] - there, axis=1))]
    )


# --- recorded -------------------------------------------------------------------------------------


def with_decisions(
    layout: Layout,
    rig: Rig,
    rest: Floats,
    asked: Mapping[str, ControlSettings],
    groups: Mapping[str, Sequence[str]],
    pins: Pins,
    overrides: Sequence[ControlSettings],
) -> Layout:
    """The layout with the decisions of a person in it: those of the configuration, and those
    carried.

    `asked` is what the configuration says of controls before any layout fixed more, `groups` its
    groups, `overrides` (controls,) what was applied in the end; `rest` (n, 3) the points at rest.
    """
    decided = dict(_from_configuration(layout.elements, asked, groups))
    for element, pin in _of_pins(layout.elements, pins):
        still = [
            each
            for each in pin.decisions
            if each != "anchor" or element.anchor.place == (pin.anchor or "board")
        ]
        decided[element.name] = decided.get(element.name, frozenset()) | frozenset(still)
    anchored = {
        c.name for c, override in zip(rig.controls, overrides, strict=True) if override.anchor
    }
    for element in layout.elements:
        other = decided.get(element.manipulator.mirror, frozenset())
        if "anchor" in other and element.manipulator.controls & anchored:
            decided[element.name] = decided.get(element.name, frozenset()) | {"anchor"}
    before = {
        element.name: pin.position for element, pin in _of_pins(layout.elements, pins) if pin.anchor
    }
    return replace(
        layout,
        elements=tuple(
            replace(
                e, placement=_pinned(e, decided, before, layout.frame.handle_width, rig.body, rest)
            )
            for e in layout.elements
        ),
    )


def _from_configuration(
    elements: tuple[Element, ...],
    asked: Mapping[str, ControlSettings],
    groups: Mapping[str, Sequence[str]],
) -> Iterator[tuple[str, frozenset[Decision]]]:
    renamed = {each.rename: each for each in asked.values() if each.rename}
    together = [frozenset(members) for members in groups.values()]
    for element in elements:
        overrides = [
            renamed.get(name) or asked.get(name, ControlSettings())
            for name in element.manipulator.controls
        ]
        found: set[Decision] = {"anchor"} if any(each.anchor for each in overrides) else set()
        found |= {"place"} if any(each.place or each.near for each in overrides) else set()
        found |= {"grouping"} if element.manipulator.controls in together else set()
        if found:
            yield element.name, frozenset(found)


def _of_pins(elements: tuple[Element, ...], pins: Pins) -> Iterator[tuple[Element, Pin]]:
    """The elements that have the controls of a pin, each on its level."""
    for element, inner in _levels(elements):
        yield from (
            (element, pin)
            for pin in pins.pins
            if pin.inner == inner and element.manipulator.controls & set(pin.controls)
        )


def _levels(elements: tuple[Element, ...]) -> Iterator[tuple[Element, bool]]:
    held: set[str] = set()
    for element in outer_first(elements):
        yield element, bool(held & element.manipulator.controls)
        held |= element.manipulator.controls


def _pinned(
    element: Element,
    decided: Mapping[str, frozenset[Decision]],
    before: Mapping[str, tuple[float, float, float]],
    handle_width: float,
    body: Body,
    rest: Floats,
) -> Placement:
    found = decided.get(element.name, frozenset())
    order: tuple[Decision, ...] = ("anchor", "place", "grouping")
    kept = tuple(
        each
        for each in order
        if each in found and not (each == "anchor" and element.anchor.on_board)
    )
    if "anchor" not in kept:
        return replace(element.placement, pinned=kept)
    here = rest[body.point_of(element.anchor.mesh, element.anchor.point)]
    then = np.array(before.get(element.name, (np.nan,) * 3))
    # The place that was decided stays on record while it is the same place: carrying it on adds up
    # no errors.
    near = float(np.linalg.norm(here - then)) <= _NEAR * handle_width
    x, y, z = (then if near else here).tolist()
    return replace(element.placement, pinned=kept, pinned_position=(x, y, z))
