"""What the configuration, corrections of a person and layouts that exist ask of one character."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import Rig
from usdrigui.character.deform import posed
from usdrigui.conventions import same_name
from usdrigui.errors import Issue, issue, meant, refuse
from usdrigui.layout.control_overrides import control_overrides, with_anchors_of_groups
from usdrigui.layout.motion.trajectory import trajectories as find_trajectories
from usdrigui.layout.reuse.carrying import Today
from usdrigui.layout.reuse.identity import Matching, match_layout, match_rigs
from usdrigui.layout.reuse.other_world import in_world
from usdrigui.layout.reuse.pinned import (
    Pins,
    pins_of,
    pins_of_corrections,
    pins_of_fixed,
    with_pins,
    with_twins,
)
from usdrigui.layout.reuse.prior_layout import (
    NO_PRIOR,
    PriorLayout,
    joined,
    kept_groups,
    prior_of_previous,
)
from usdrigui.layout.reuse.renaming import with_names
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.reuse.retargeting import of_another
from usdrigui.model import Correction, Layout, Trajectories
from usdrigui.pipeline.animation import weighted
from usdrigui.pipeline.records import CharacterPart
from usdrigui.pipeline.reference_layouts import (
    OwnReferences,
    ReferenceLayouts,
    imitated,
)
from usdrigui.settings import Settings, TrajectorySettings


def own_references(
    references: ReferenceLayouts, rig: Rig, trajectories: Trajectories, settings: Settings
) -> OwnReferences:
    """The references of one character, their controls matched with those that it has now.

    Raises CONFIG_UNKNOWN_CONTROL for names of a fixed layout that are gone, FIXED_IMPOSSIBLE where
    that was made for other points, CONFIG_VALUE when the fixed layer has no such character, or none
    of several characters to imitate has the path of this one, PREVIOUS_MISMATCH for a layout
    without any of its controls.
    """
    root, names = rig.path, settings.like.names
    if references.fixed and root not in references.fixed:
        have = f"has layouts of {', '.join(references.fixed)}, not of {root}"
        raise refuse("CONFIG_VALUE", "--fixed", have)
    matchings, here, then = dict[str, Matching](), dict[str, Layout](), dict[str, Layout]()
    for which, layouts in (("fixed", references.fixed), ("previous", references.previous)):
        if root in layouts:
            then[which] = in_world(layouts[root], rig.metres_per_unit, rig.up)
            matchings[which] = match_layout(then[which], rig, trajectories)
            if not matchings[which].names:
                what = f"shares no control with its {which} layout"
                raise refuse("PREVIOUS_MISMATCH", root, what)
            here[which] = with_names(then[which], matchings[which].renamed)
    like = _to_imitate(references.like, rig, settings.trajectories)
    if like is not None:
        matchings["like"] = match_rigs(like[:2], (rig, trajectories), names)
    return OwnReferences(
        here.get("fixed"),
        here.get("previous"),
        like,
        references.existing(rig),
        references.clips,
        _pins(references.corrections, here, (rig, trajectories, matchings), settings),
        matchings,
        then.get("previous"),
    )


def _pins(
    said: Sequence[Correction],
    here: Mapping[str, Layout],
    character: tuple[Rig, Trajectories, Mapping[str, Matching]],
    settings: Settings,
) -> Pins:
    """What a person has decided: the corrections first, then what is on record in the layout that
    this one succeeds; `here` are the layouts by the names of today."""
    rig, trajectories, matchings = character
    succeeded = here.get("previous") or here.get("fixed")
    if not said and succeeded is None:
        return Pins()
    names: dict[str, str] = {}
    for each in here:
        names |= matchings[each].names
    corrections, issues = by_names_of_today(said, rig, names)
    today = Today(rig, posed(rig, None).points, trajectories)
    width = settings.objective.handle_size * trajectories.surface.face_size
    if succeeded is not None:
        width = succeeded.frame.handle_width
    asked = pins_of_corrections(corrections, today, width)
    recorded = Pins()
    if succeeded is not None and settings.objective.keep_penalty > 0.0:
        recorded = pins_of(succeeded, today, corrections)
    return Pins((*asked.pins, *recorded.pins), (*issues, *asked.issues, *recorded.issues))


def by_names_of_today(
    corrections: Sequence[Correction], rig: Rig, renamed: Mapping[str, str]
) -> tuple[list[Correction], list[Issue]]:
    """The corrections of a character by the names that its controls have today, without those of
    controls that are excluded, and PIN_LOST for those of controls that it does not have, with the
    name that is likely meant.

    `renamed` are names of today by those of an earlier layout, as far as known; beyond these a
    control is known by another spelling of its name.
    """
    found, told, names = [], [], rig.control_names
    excluded = {control.name for control in rig.excluded}
    for each in corrections:
        if each.root != rig.path or each.control in excluded:
            continue
        spelt = same_name(each.control, tuple(names))
        name = renamed.get(each.control, "") or spelt
        if name not in names:
            what = f"{rig.path} has no control of this name{meant(each.control, names)}"
            told.append(issue("PIN_LOST", each.control, what))
            continue
        found.append(replace(each, control=name))
        if spelt != each.control:
            told.append(issue("CONTROL_RENAMED", each.control, f"of the corrections is {name} now"))
        if not spelt and (each.group or each.settings):
            what = f"is {name} now: its group and its settings are to be said again"
            told.append(issue("PIN_LOST", each.control, what))
    return found, told


def requested(
    rig: Rig, parts: Sequence[CharacterPart], settings: Settings, references: OwnReferences
) -> Requests:
    """What the configuration and the references ask of one character, but for what they ask of each
    part of it (`prior_of`).

    Raises CLIP_FOREIGN where no clip is of this character.
    """
    configured, pins = control_overrides(rig, settings.controls), references.pins
    fixed = () if references.fixed is None else pins_of_fixed(references.fixed, rig)
    # What is said now is stronger than what is fixed, and that stronger than what is on record.
    every = sorted((*pins.pins, *fixed), key=lambda pin: (pin.recorded, not pin.decisions))
    overrides = with_pins(rig, configured, every)
    overrides = with_anchors_of_groups(rig, overrides, settings.groups.groups)
    twins = np.full(len(rig.controls), -1)
    for part in parts:
        overrides = with_twins(rig, part.trajectories, part.symmetry, overrides)
        own = list(part.controls)
        twins[own] = part.symmetry.twins[own]
    if references.clips:
        overrides = weighted(rig, twins, (overrides, references.clips), settings.animation.weight)
    existing = references.existing
    known = existing.controls if existing is not None else frozenset[str]()
    return Requests(
        configured,
        overrides,
        groups={
            name: controls
            for name, controls in settings.groups.groups.items()
            if not known.issuperset(controls)
        },
        levels=settings.levels.members,
        existing=existing,
        pins=pins,
    )


def prior_of(
    rig: Rig, part: CharacterPart, settings: Settings, references: OwnReferences
) -> PriorLayout:
    """The earlier layout that one part should be like, by the references."""
    prior, imitating = NO_PRIOR, settings.like
    if references.like is not None and imitating.penalty > 0.0:
        other, found, layout = references.like
        names = {**references.matchings["like"].names, **imitating.names}
        ours = (rig, part.trajectories)
        prior = of_another(layout, (other, found), ours, names, imitating.penalty)
    if references.previous is not None:
        today = Today(rig, part.trajectories.surface.points, part.trajectories)
        prior = prior_of_previous(references.previous, today, settings.objective.keep_penalty)
    if references.fixed is not None:
        prior = joined(PriorLayout(kept_groups(references.fixed.elements, rig)), prior)
    return prior


def _to_imitate(
    like: tuple[tuple[Rig, Layout], ...], rig: Rig, sampling: TrajectorySettings
) -> tuple[Rig, Trajectories, Layout] | None:
    if not like:
        return None
    other, layout = imitated(like, rig.path)
    return other, find_trajectories(other, sampling), layout
