"""What the configuration and the layouts that exist ask of one character."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from usdrigui.character import Rig
from usdrigui.character.deform import posed
from usdrigui.errors import refuse
from usdrigui.layout.control_overrides import control_overrides, with_anchors_of_groups
from usdrigui.layout.motion.trajectory import trajectories as find_trajectories
from usdrigui.layout.reuse.identity import Matching, match_layout, match_rigs
from usdrigui.layout.reuse.partial_layout import with_fixed
from usdrigui.layout.reuse.pinned import Pins, pins_of, with_pins, with_twins
from usdrigui.layout.reuse.prior_layout import (
    NO_PRIOR,
    PriorLayout,
    joined,
    kept_groups,
    of_parts,
    prior_of_previous,
)
from usdrigui.layout.reuse.renaming import with_names
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.reuse.retargeting import of_another
from usdrigui.model import Layout, Trajectories
from usdrigui.pipeline.animation import weighted
from usdrigui.pipeline.records import CharacterPart
from usdrigui.pipeline.reference_layouts import (
    OwnReferences,
    ReferenceLayouts,
    check_like,
    imitated,
)
from usdrigui.settings import Settings, TrajectorySettings


def own_references(
    references: ReferenceLayouts, rig: Rig, trajectories: Trajectories, settings: Settings
) -> OwnReferences:
    """The references of one character, their controls matched with those that it has now.

    Raises CONFIG_UNKNOWN_CONTROL for names of `like` that nobody bears, CONFIG_VALUE when the fixed
    layer has no such character, or none of several characters to imitate has the path of this one.
    """
    root, names = rig.skel_root.path, settings.character.like.names
    if references.fixed and root not in references.fixed:
        have = f"has layouts of {', '.join(references.fixed)}, not of {root}"
        raise refuse("CONFIG_VALUE", "--fixed", have)
    matchings, here = dict[str, Matching](), dict[str, Layout]()
    for which, layouts in (("fixed", references.fixed), ("previous", references.previous)):
        if root in layouts:
            matchings[which] = match_layout(layouts[root], rig, trajectories)
            here[which] = with_names(layouts[root], matchings[which].renamed)
    like = _to_imitate(references.like, rig, names, settings.character.trajectories)
    if like is not None:
        matchings["like"] = match_rigs(like[:2], (rig, trajectories), names)
    fixed, previous = here.get("fixed"), here.get("previous")
    succeeded = (previous or fixed) if settings.layout.objective.keep_penalty > 0.0 else None
    pins = Pins()
    if succeeded is not None:
        pins = pins_of(succeeded, rig, posed(rig, None).points, trajectories)
    existing, clips = references.existing(rig), references.clips
    return OwnReferences(fixed, previous, like, existing, clips, pins, matchings)


def requested(
    rig: Rig, parts: Sequence[CharacterPart], settings: Settings, references: OwnReferences
) -> Requests:
    """What the configuration and the references ask of one character.

    Raises FIXED_IMPOSSIBLE and CONFIG_UNKNOWN_CONTROL for a fixed layout, CLIP_FOREIGN where no
    clip is of this character.
    """
    configured = control_overrides(rig, settings.rig.controls)
    overrides = configured
    if references.fixed is not None:
        overrides = with_fixed(rig, overrides, references.fixed)
    overrides = with_pins(rig, overrides, references.pins)
    overrides = with_anchors_of_groups(rig, overrides, settings.layout.groups.groups)
    priors, twins = [], np.full(len(rig.controls), -1)
    for part in parts:
        overrides = with_twins(rig, part.trajectories, part.symmetry, overrides)
        priors.append((part.controls, _prior(rig, part, settings, references)))
        own = list(part.controls)
        twins[own] = part.symmetry.twins[own]
    if references.clips:
        weight = settings.character.animation.weight
        overrides = weighted(rig, twins, (overrides, references.clips), weight)
    existing = references.existing
    known = existing.controls if existing is not None else frozenset[str]()
    return Requests(
        configured,
        overrides,
        groups={
            name: controls
            for name, controls in settings.layout.groups.groups.items()
            if not known.issuperset(controls)
        },
        levels=settings.layout.levels.members,
        prior=of_parts(priors),
        existing=existing,
        pins=references.pins,
    )


def _prior(
    rig: Rig, part: CharacterPart, settings: Settings, references: OwnReferences
) -> PriorLayout:
    """What the references ask of one part besides fixed anchors."""
    prior, imitating = NO_PRIOR, settings.character.like
    if references.like is not None and imitating.penalty > 0.0:
        other, found, layout = references.like
        names = {**references.matchings["like"].names, **imitating.names}
        ours = (rig, part.trajectories)
        prior = of_another(layout, (other, found), ours, names, imitating.penalty)
    if references.previous is not None:
        keep_penalty = settings.layout.objective.keep_penalty
        prior = prior_of_previous(references.previous.elements, rig, keep_penalty)
    if references.fixed is not None:
        prior = joined(PriorLayout(kept_groups(references.fixed.elements, rig)), prior)
    return prior


def _to_imitate(
    like: tuple[tuple[Rig, Layout], ...],
    rig: Rig,
    names: Mapping[str, str],
    sampling: TrajectorySettings,
) -> tuple[Rig, Trajectories, Layout] | None:
    if not like:
        return None
    check_like(like, rig, names)
    other, layout = imitated(like, rig.skel_root.path)
    return other, find_trajectories(other, sampling), layout
