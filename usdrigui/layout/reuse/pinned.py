"""Decisions of a person, carried from the layout that records them to the rig of today.

A correction holds through reprocessing, renames, other vertex orders and other topology: an anchor
that is pinned goes to the same point, or on another mesh to the nearest one that its controls move,
and says so where that is not near.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from usdrigui.character import Rig
from usdrigui.character.deform import posed
from usdrigui.errors import Issue, RigUIError, check_known, issue, refuse
from usdrigui.layout.motion.coverage import NOTABLE
from usdrigui.layout.reuse.carrying import Today, carried, moved, point_named
from usdrigui.layout.reuse.other_world import turn_between
from usdrigui.layout.reuse.partial_layout import MIRROR, fixed_anchor, place_of
from usdrigui.model import (
    ONE_PLACE,
    Anchor,
    Correction,
    Decision,
    Element,
    Layout,
    Symmetry,
    Trajectories,
)
from usdrigui.model.levels import with_levels
from usdrigui.settings import ControlSettings
from usdrigui.ties import first_smallest


@dataclass(frozen=True)
class Pin:
    """What a person has decided about one element, on the rig of today."""

    element: str
    controls: tuple[str, ...]
    decisions: tuple[Decision, ...]
    anchor: str = ""
    """``MESH_PATH#POINT`` where it is pinned to a point."""
    place: Literal["", "board", "face"] = ""
    """``board`` or ``face`` where only that is decided."""
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """At rest, on the rig for which the anchor was decided."""
    inner: bool = False
    """Whether the element is a member of a coarse one that has its controls, too."""
    recorded: bool = False
    """Whether an earlier layout has it on record; else a correction says it."""


@dataclass(frozen=True)
class Pins:
    """The decisions that hold for a rig, the strongest first, and what could not be carried."""

    pins: tuple[Pin, ...] = ()
    issues: tuple[Issue, ...] = ()

    def without(self, error: RigUIError, groups: Sequence[frozenset[str]]) -> Pins:
        """The rest, of an error about the anchors of one group of controls or of two: without those
        of the group that has the fewest, of those on record if there are any; raises it if none of
        the pins is one."""
        fixed = [pin for pin in self.pins if pin.anchor]
        named = [[p for p in fixed if not g.isdisjoint(p.controls)] for g in groups]
        named = [pins for pins in named if pins]
        if not named:
            raise error
        gone = min(named, key=lambda pins: (not all(p.recorded for p in pins), len(pins)))
        if len(groups) == 1:
            gone = gone[-1:]
        lost = (issue("PIN_LOST", pin.element, error.issue.message) for pin in gone)
        rest = (replace(pin, anchor="") if pin in gone else pin for pin in self.pins)
        return Pins(tuple(rest), (*self.issues, *lost))


def pins_of(layout: Layout, today: Today, corrections: Sequence[Correction]) -> Pins:
    """The pins of an earlier layout of a character, by its names of today, of whose points at rest
    `today` tells; but for those that corrections replace or take back.

    Controls that are gone leave their decisions to the others of the element, and are told as lost.
    """
    pins, issues = [], []
    names = today.rig.control_names
    corrected = {each.control for each in corrections if each.place}
    free = corrected | layout.follow(corrected)
    for element, inner in with_levels(layout.elements):
        on_board = element.anchor.on_board
        every = [m.control for m in element.members]
        known = tuple(name for name in every if name in names)
        if not element.pinned or not free.isdisjoint(known):
            continue
        gone = "is gone, and no control is surely it by another name"
        issues += [issue("PIN_LOST", name, gone) for name in every if name not in names]
        if not known:
            continue
        pin = Pin(element.name, known, element.pinned, position=element.pinned_position)
        if "anchor" in element.pinned and not on_board:
            pin, told = _at_point(
                pin, element.anchor, layout.frame.handle_width_of(element.part), today
            )
            issues += told
        if "place" in element.pinned and not pin.anchor:
            pin = replace(pin, place="board" if on_board else "face")
        pins.append(replace(pin, inner=inner, recorded=True))
    return Pins(tuple(pins), tuple(issues))


def with_rest_places(layout: Layout, rig: Rig) -> Layout:
    """The layout with the rest positions on `rig`, which its own stage has, of the anchors that a
    person gave as a point alone."""
    points = posed(rig, None).points

    def placed(element: Element) -> Element:
        point = element.anchor.on(rig.body)
        if point < 0 or np.isfinite(element.pinned_position).all():
            return element
        x, y, z = points[point].tolist()
        return replace(element, pinned_position=(x, y, z))

    return replace(layout, elements=tuple(map(placed, layout.elements)))


def pins_of_fixed(layout: Layout, rig: Rig) -> list[Pin]:
    """Every place of a layout that is kept to the point.

    Raises FIXED_IMPOSSIBLE where it was made for other points, CONFIG_UNKNOWN_CONTROL where it has
    a control that the rig lacks.
    """
    pins = []
    for element, inner in with_levels(layout.elements):
        names, anchor = tuple(m.control for m in element.members), element.anchor
        for name in names:
            where = f"{layout.root} element {element.name}"
            check_known(name, rig.control_names, where, f"{rig.path} has no control")
        if anchor.on_board:
            pins.append(Pin(element.name, names, (), place="board", inner=inner))
            continue
        point = point_named(rig, anchor)
        if point < 0:
            change = "is gone, or has other points or faces by now"
            raise refuse("FIXED_IMPOSSIBLE", element.name, f"its mesh {anchor.mesh} {change}")
        pins.append(Pin(element.name, names, (), place_of(rig.body, point), inner=inner))
    return pins


def pins_of_corrections(corrections: Sequence[Correction], today: Today, width: float) -> Pins:
    """The pins of corrections of this character, by its names of today; `width` is that of a
    handle."""
    pins, issues = [], []
    for each in corrections:
        pin = Pin(each.control, (each.control,), ("place",))
        if each.place == "board" or each.place == "face":
            pins.append(replace(pin, place=each.place))
        elif each.place == "point":
            unit = today.rig.metres_per_unit
            scale = (each.unit or unit) / unit
            turn = turn_between(np.array(each.up), today.rig.up)
            x, y, z = (scale * turn @ np.array(each.position)).tolist()
            pin = replace(pin, decisions=("anchor",), position=(x, y, z))
            pin, told = _at_point(pin, each, width, today)
            issues += told
            pins += [pin] if pin.anchor else []
    return Pins(tuple(pins), tuple(issues))


def _at_point(
    pin: Pin, hint: Anchor | Correction, width: float, today: Today
) -> tuple[Pin, list[Issue]]:
    """The pin at the point of today's rig to which its own is carried, at none where there is none,
    and what is to be told of it; `width` is that of a handle."""
    point, apart = carried(hint, pin.position, pin.controls, today)
    if point < 0:
        why = "its controls move no point together"
        if len(today.moved_by_all(pin.controls)):
            why = "its mesh has other points or faces by now, and its position is not known"
        return pin, [issue("PIN_LOST", pin.element, why)]
    off = apart / max(width, 1e-300)
    message = f"is {off:.1f} handle widths from where it was pinned"
    told = [issue("PIN_CARRIED", pin.element, message)] if off > ONE_PLACE else []
    return replace(pin, anchor=place_of(today.rig.body, point)), told


def with_pins(
    rig: Rig, overrides: Sequence[ControlSettings], pins: Iterable[Pin]
) -> tuple[ControlSettings, ...]:
    """(controls,) the `overrides` with what the pins fix; what the configuration says itself, and
    what an earlier pin fixes, is stronger."""
    index = rig.control_indices
    found = list(overrides)
    for pin in pins:
        for control in (index[name] for name in pin.controls):
            override = found[control]
            if pin.inner:
                found[control] = replace(override, inner_anchor=override.inner_anchor or pin.anchor)
            elif not (override.anchor or override.place or override.near):
                found[control] = replace(override, anchor=pin.anchor, place=pin.place)
    return tuple(found)


def with_twins(
    rig: Rig, trajectories: Trajectories, symmetry: Symmetry, overrides: Sequence[ControlSettings]
) -> tuple[ControlSettings, ...]:
    """(controls,) the overrides with the anchor of one side on the other, too, and the mirror image
    of what one side is kept near, for the controls of these trajectories."""
    found = list(overrides)
    for control in (motion.control for motion in trajectories.motions):
        twin, override = int(symmetry.twins[control]), overrides[control]
        own = overrides[twin]
        fixed = own.anchor or own.place or own.near
        if twin in (-1, control) or fixed or not own.follow_twin:
            continue
        if override.near and not override.anchor:
            near = override.near.removeprefix(MIRROR)
            if near == override.near:
                near = MIRROR + near
            found[twin] = replace(own, near=near, within=override.within)
        if override.anchor:
            point = fixed_anchor(rig, rig.control_names[control], override.anchor)
            image = _image(trajectories, symmetry, twin, point)
            if image >= 0:
                found[twin] = replace(own, anchor=place_of(rig.body, image))
    return tuple(found)


def _image(trajectories: Trajectories, symmetry: Symmetry, twin: int, point: int) -> int:
    """The mirror image of a point, or what the twin moves nearest to that; -1 where it moves
    nothing, or that point too: the two ends of a jaw's axis may be one element."""
    motion = next((each for each in trajectories.motions if each.control == twin), None)
    if motion is None or motion.arc_length[motion.points == point].sum() >= NOTABLE * motion.peak:
        return -1
    partner = int(symmetry.partner[point])
    if partner in motion.points:
        return partner
    there = symmetry.plane.reflected(trajectories.surface.points[point])
    far = motion.points[moved(motion)]
    return int(
        far[first_smallest(np.linalg.norm(trajectories.surface.points[far] - there, axis=1))]
    )
