"""Which controls are off the face, and why (paper sections 3.3 and 4.2)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import Control, Flags, Floats, Indices, Record
from usdrigui.conventions import Meaning
from usdrigui.layout.classify.composites import composites
from usdrigui.layout.classify.visibility_shapes import visibility_shapes
from usdrigui.layout.face import Face
from usdrigui.layout.motion.coverage import coverage_of_smaller, shares_of_face
from usdrigui.layout.motion.similarity import Similarity
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import BaseSurface, Classification, Motion
from usdrigui.settings import CandidateSettings


class _Evidence(Record):
    """What speaks for one control leaving the face."""

    wide: bool
    """Whether it moves the face as a whole, and its name is that of no part of it."""
    vanishes: bool
    visible_share: float
    kept: float
    """Largest share of its true peak at a visible place."""
    essential: bool
    """Whether it is on the face even if its peak is hidden."""
    composite: Classification | None


def classify(
    face: Face, similarity: Similarity, requests: Requests, settings: CandidateSettings
) -> tuple[Classification, ...]:
    """One per motion.

    Whether one is global does not depend on which others the configuration excludes: those still
    count for what the face is.
    """
    surface, motions = face.surface, face.trajectories.motions
    seen = face.views.anywhere
    visible_areas = np.where(seen, surface.areas, 0.0)
    every = (*motions, *face.trajectories.excluded)
    meanings = [face.meanings[motion.control] for motion in motions]
    controls = [face.rig.controls[motion.control] for motion in motions]
    covered = coverage_of_smaller(every, visible_areas)[: len(motions)]
    covered = _of_sets(covered, controls, meanings)
    shares = shares_of_face(every, visible_areas)[: len(motions)]
    vanish = visibility_shapes(face.pieces, face.trajectories)
    repeated = composites(face, similarity, shares)
    kept = _kept(motions, face.twins, seen)
    # The joints of a chain explain each other, and one holds most of a robot's head; only shapes
    # and poses show what repeats a shape or a pose, and what moves all of a face.
    joints_alone = all(control.kind == "joint" for control in controls)
    found = []
    for index, motion in enumerate(motions):
        own, meaning = motion.on_own_skin(), meanings[index]
        alone = joints_alone and motion.of_joint
        evidence = _Evidence(
            wide=not alone
            and bool(covered[index] > settings.global_coverage)
            and not _named_local(meaning),
            vanishes=bool(vanish[index]),
            visible_share=max(_visible_share(surface, seen, each) for each in (own, motion)),
            kept=float(kept[index]),
            essential=meaning is not None and meaning.action.is_essential,
            composite=None if alone else repeated.get(index),
        )
        said = _classified(evidence, motion.control, requests, settings)
        if index in repeated and said.category == repeated[index].category:
            said = repeated[index]
        found.append(replace(said, coverage=float(shares[index])))
    return tuple(found)


def _classified(
    evidence: _Evidence, control: int, requests: Requests, settings: CandidateSettings
) -> Classification:
    """Category and reason, both empty for a control of the face."""
    override = requests.overrides[control]
    if override.place in ("face", "proxy") or override.anchor:
        return Classification()
    earlier = requests.prior.places.get(control)
    if earlier is not None and earlier.category:
        return Classification(earlier.category, earlier.reason)
    stood = requests.prior.stood_on_face((control,))
    # Not where another character's layout is imitated.
    stays = stood and requests.prior.cutoff_distance == 0.0
    # A control that is on the face already is not sent away because another one was added.
    composite = evidence.composite if settings.board_composite and not stood else None
    if composite is not None and composite.category != "composite":
        # A family under one heading, whatever else speaks against some of its members.
        return composite
    if settings.board_global and not stays:
        if evidence.vanishes:
            return Classification("global", "makes parts of the character disappear")
        if evidence.wide:
            return Classification("global", "moves the face as a whole")
    if settings.board_hidden and evidence.visible_share < settings.hidden_share:
        return Classification("hidden", "only affects geometry hidden in all views")
    needed = stays or evidence.essential
    if settings.board_hidden and evidence.kept < settings.least_kept and not needed:
        what = f"no visible place keeps more than {evidence.kept:.0%} of its displacement"
        return Classification("hidden", what)
    if composite is not None:
        return composite
    if override.place == "board":
        return Classification("requested", "its place on the board is decided")
    return Classification()


def _of_sets(
    covered: Floats, controls: Sequence[Control], meanings: Sequence[Meaning | None]
) -> Floats:
    """(motions,) shares of the face with the median of its set for each member: a family leaves the
    face as a whole, and so do the axes of a joint, a head's nod with its turn."""
    found, members = covered.copy(), dict[tuple[str, str], list[int]]()
    for index, (control, meaning) in enumerate(zip(controls, meanings, strict=True)):
        if meaning is not None and meaning.action.in_family:
            members.setdefault(("family", meaning.action.name), []).append(index)
        elif control.kind == "joint":
            members.setdefault(("joint", control.source), []).append(index)
    for each in members.values():
        found[each] = np.median(covered[each])
    return found


def _kept(motions: tuple[Motion, ...], twins: Indices, visible: Flags) -> Floats:
    """(motions,) largest share of its peak that each keeps at a visible place, the same for twins;
    1 for the control of a joint, whose skin is its place."""
    found = np.ones(len(motions))
    for index, motion in enumerate(motions):
        if not motion.of_joint:
            seen = motion.arc_length[visible[motion.points]]
            found[index] = seen.max(initial=0.0) / motion.peak
    return np.maximum(found, np.where(twins < 0, found, found[twins]))


def _named_local(meaning: Meaning | None) -> bool:
    """Whether the name is that of an atom of a part of the face: where the mouth alone is animated,
    a jaw moves all that smaller controls move."""
    action = meaning and meaning.action
    return bool(action and action.category == "atom" and action.region not in ("head", "neck"))


def _visible_share(surface: BaseSurface, visible: Flags, motion: Motion) -> float:
    """Share of the control's motion, area times distance, that some view sees."""
    weight = surface.swept(motion)
    total = float(weight.sum())
    seen = visible[motion.points]
    return float(weight[seen].sum()) / total if total > 0.0 else float(seen.mean())
