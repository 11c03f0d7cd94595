"""Decisions of a person, carried from the layout that records them to the rig of today.

A correction holds through reprocessing, renames, other vertex orders and other topology: an anchor
that is pinned goes to the same point, or on another mesh to the nearest one that its controls move,
and says so where that is not near.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from usdrigui.character import Floats, Indices, Rig
from usdrigui.errors import Issue, RigUIError, issue
from usdrigui.layout.reuse.partial_layout import MIRROR, fixed_anchor, place_of
from usdrigui.layout.reuse.prior_layout import ONE_PLACE, points_of_meshes, same_point
from usdrigui.model import Decision, Element, Layout, Symmetry, Trajectories
from usdrigui.model.levels import outer_first
from usdrigui.settings import ControlSettings
from usdrigui.ties import first_smallest

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
    place: Literal["", "board", "face"] = ""
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

    def without(self, error: RigUIError) -> Pins:
        """The rest, of an error about an anchor that one of the pins fixes; raises it if it is
        about none of them."""
        named = [pin for pin in self.pins if pin.anchor and _is_about(error.issue.path, pin)]
        if not named:
            raise error
        lost = tuple(issue("PIN_LOST", pin.element, error.issue.message) for pin in named)
        rest = (replace(pin, anchor="") if pin in named else pin for pin in self.pins)
        return Pins(tuple(rest), (*self.issues, *lost))


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
    names = rig.control_names
    for element in outer_first(layout.elements):
        placement, on_board = element.placement, element.anchor.on_board
        known = tuple(m.control for m in element.manipulator.members if m.control in names)
        inner = bool(held & set(known))
        held |= set(known)
        if not placement.pinned or not known:
            continue
        pin = Pin(element.name, known, placement.pinned, position=placement.pinned_position)
        if "anchor" in placement.pinned and not on_board:
            width = layout.frame.handle_width_of(placement.part)
            anchor, problem = _carried(element, known, width, (rig, rest, trajectories))
            pin = replace(pin, anchor=anchor)
            issues += [problem] if problem is not None else []
        if "place" in placement.pinned and not pin.anchor:
            pin = replace(pin, place="board" if on_board else "face")
        pins.append(replace(pin, inner=inner))
    return Pins(tuple(pins), tuple(issues))


def _carried(
    element: Element,
    controls: Sequence[str],
    width: float,
    today: tuple[Rig, Floats, Trajectories],
) -> tuple[str, Issue | None]:
    """Where the pinned anchor of an element is on the rig of today, empty if nowhere, and an issue
    about it; `width` is that of a handle."""
    rig, rest, trajectories = today
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
        issue("PIN_CARRIED", element.name, message) if off > ONE_PLACE else None
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


def with_pins(
    rig: Rig, overrides: Sequence[ControlSettings], pins: Pins
) -> tuple[ControlSettings, ...]:
    """(controls,) the `overrides` with what the pins fix; what the configuration says itself is
    stronger."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    found = list(overrides)
    for pin in pins.pins:
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
        if twin in (-1, control) or not _follows(overrides[twin]):
            continue
        if override.near and not override.anchor:
            near, within = MIRROR + override.near, override.within
            found[twin] = replace(overrides[twin], near=near, within=within)
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
    there = symmetry.plane.reflected(trajectories.surface.points[point])
    far = motion.points[motion.arc_length >= _MOVES * motion.peak]
    return int(
        far[first_smallest(np.linalg.norm(trajectories.surface.points[far] - there, axis=1))]
    )
