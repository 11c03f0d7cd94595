"""divided() and part_problem(): from a rig to the layout problems of its parts.

    Rig → Trajectories → Parts → Symmetry → Views → Classification → Face → Candidates → Groups →
    PlacementProblem

The order of these stages is known here and nowhere else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from usdrigui.conventions import meanings
from usdrigui.deform import posed
from usdrigui.errors import Issue, RigUIError, of_character, refuse
from usdrigui.layout.canonical_face import expectations
from usdrigui.layout.classify.classification import Classification, classify
from usdrigui.layout.classify.common_motion import with_common_motion
from usdrigui.layout.control_overrides import control_overrides
from usdrigui.layout.element.elements import layout, proof_of
from usdrigui.layout.face import Face
from usdrigui.layout.group.coarse_groups import with_levels
from usdrigui.layout.group.grouping import find_groups
from usdrigui.layout.motion.similarity import Similarity, displacement_fields, similarity
from usdrigui.layout.motion.trajectory import of_controls, trajectories
from usdrigui.layout.parts.division import Part, divide, main_part, of_part
from usdrigui.layout.parts.joint_regions import FACE, FLAT
from usdrigui.layout.place.candidates import find_candidates
from usdrigui.layout.place.handle_width import handle_width, on_face
from usdrigui.layout.place.problem import PlacementProblem, placement_problem
from usdrigui.layout.place.terms import LinearTerms
from usdrigui.layout.reuse.existing_layout import of_new_controls, with_drawn_handles
from usdrigui.layout.reuse.identity import Matching, matching_issues
from usdrigui.layout.reuse.pinned import Pins, with_decisions, with_pins, with_twins
from usdrigui.layout.reuse.prior_layout import NO_PRIOR, PriorLayout
from usdrigui.layout.reuse.requests import Names, Requests
from usdrigui.layout.review.review import refuse_stale
from usdrigui.layout.symmetry.base_pose import symmetry_at_pose
from usdrigui.layout.symmetry.mirror_plane import about_plane_of
from usdrigui.layout.symmetry.twins import configured_twins
from usdrigui.layout.visibility import find_views
from usdrigui.model import (
    Assignment,
    Candidates,
    Element,
    Floats,
    Layout,
    LayoutPart,
    LeftOff,
    Motion,
    Performance,
    Rig,
    Symmetry,
    Trajectories,
)
from usdrigui.pipeline import animation
from usdrigui.pipeline.configuration import base_values_of, camera_of
from usdrigui.pipeline.progress import Clock
from usdrigui.pipeline.references import (
    OwnReferenceLayouts,
    ReferenceLayouts,
    decisions,
    own_references,
    prior_layout_of,
    with_fixed,
)
from usdrigui.settings import PartSettings, Settings, with_sections


@dataclass(frozen=True, eq=False)
class References:
    """Layouts and animations to which one character's layout refers."""

    prior: PriorLayout = NO_PRIOR
    existing: Layout | None = None
    clips: tuple[Performance, ...] = ()
    neighbours: tuple[Element, ...] = ()
    """Elements of the parts that are laid out already, from which this one keeps clear."""


NO_REFERENCES = References()


@dataclass(frozen=True, eq=False)
class Measured:
    """What is known of a character before its elements are placed."""

    face: Face
    similarity: Similarity
    requests: Requests
    classification: tuple[Classification, ...]


@dataclass(frozen=True, eq=False)
class ProblemInputs:
    """A layout problem, and what it was built from."""

    part: str
    """Name of the part of the character that it lays out."""
    face: Face
    similarity: Similarity
    requests: Requests
    classification: tuple[Classification, ...]
    settings: Settings
    candidates: Candidates
    placement: PlacementProblem
    base_values: Floats
    """(controls,) the base pose."""
    matchings: Mapping[str, Matching] = field(default_factory=dict)
    """By ``fixed``, ``previous`` and ``like``: which control of that layout is which of this
    rig."""
    asked: Settings | None = None
    """The settings as given, before any layout fixed more; None where no layout did."""
    pins: Pins = field(default_factory=Pins)
    """Decisions of a person in the layout that the new one succeeds."""

    @property
    def issues(self) -> tuple[Issue, ...]:
        """Findings about the rig and its controls."""
        unexplained = (found for each in self.classification for found in each.issues)
        renamed = (
            found
            for which, each in self.matchings.items()
            for found in matching_issues(which, each)
        )
        rig, odd = self.face.rig, self.face.trajectories.findings.issues
        own = of_character(
            rig.skel_root.path_in_variants, (*odd, *unexplained, *renamed, *self.pins.issues)
        )
        return (*rig.findings.issues, *own)

    @property
    def explained_by(self) -> dict[str, tuple[tuple[str, float], ...]]:
        """Names of the controls that others explain, to those and how far each of them goes."""
        names = [
            self.face.rig.controls[motion.control].name for motion in self.face.trajectories.motions
        ]
        named = zip(names, self.classification, strict=True)
        return {
            name: tuple((names[i], amount) for i, amount in each.explained_by)
            for name, each in named
        }

    @property
    def left_off(self) -> tuple[LeftOff, ...]:
        """Controls that the stages after reading left off, and why."""
        return (*self.face.trajectories.findings.left_off, *self.candidates.left_off)

    @property
    def twin_names(self) -> dict[str, str]:
        """Names of the controls that have a twin other than themselves, to its name."""
        controls, twins = self.face.rig.controls, self.face.symmetry.twins
        return {
            control.name: controls[twin].name
            for control, twin in zip(controls, twins, strict=True)
            if twin >= 0 and controls[twin] is not control
        }


@dataclass(frozen=True, eq=False)
class Divided:
    """A character with its parts, ready to be laid out one part after the other."""

    rig: Rig
    asked: Settings
    """The settings as given."""
    settings: Settings
    """Those with the anchors that a layout fixes."""
    pins: Pins
    """Decisions of a person in the layout that the new one succeeds."""
    base_values: Floats
    """(controls,) the base pose."""
    trajectories: Trajectories
    parts: tuple[Part, ...]
    """In the order in which they are laid out."""
    symmetry: Symmetry | None
    """Of the character as a whole; None where it is one part."""
    camera: Floats | None
    references: OwnReferenceLayouts
    existing: Layout | None
    clips: tuple[Performance, ...]


def divided(
    rig: Rig,
    settings: Settings,
    clock: Clock | None = None,
    cameras: Mapping[str, Floats] | None = None,
    references: ReferenceLayouts | None = None,
) -> Divided:
    """A character with its trajectories and its parts: what the problems of all parts are built
    from."""
    clock, references = clock or Clock(), references or ReferenceLayouts()
    camera = camera_of(rig.skel_root.path, settings.layout.candidates.view, cameras or {})
    base_values = base_values_of(rig.skel_root.path, rig.controls, settings.rig.read.pose)
    with clock.stage("trajectories"):
        found = trajectories(rig, settings.character.trajectories, base_values)
    _refuse_motionless(rig.skel_root.path, found.motions)
    asked, sampling = settings, settings.character.trajectories
    own = own_references(references, rig, found, settings.character.like, sampling)
    settings = with_sections(asked, controls=with_fixed(own, rig, asked.rig.controls))
    pins = decisions(own, rig, found, settings.layout.objective.keep_penalty)
    existing = references.existing(rig)
    if existing is not None:
        refuse_stale(rig, found, existing, settings.rig.read)
    with clock.stage("symmetry"):
        parts = divide(rig, found, settings)
        symmetry = None
        if len(parts) > 1:
            symmetry = symmetry_at_pose(
                rig,
                found,
                displacement_fields(found),
                settings.character.symmetry,
                configured_twins(rig, settings.rig.controls),
                sampling,
                base_values,
            )
    return Divided(
        rig,
        asked,
        settings,
        pins,
        base_values,
        found,
        parts,
        symmetry,
        camera,
        own,
        existing,
        references.clips,
    )


def part_problem(
    character: Divided, part: Part, neighbours: Sequence[Element] = (), clock: Clock | None = None
) -> ProblemInputs:
    """The layout problem of one part; `neighbours` are the elements of the parts that are laid out
    already."""
    rig, settings, found = character.rig, character.settings, character.trajectories
    own = settings.layout
    if len(character.parts) > 1:
        found = of_controls(
            rig, found, part.controls, part.excluded, settings.character.trajectories
        )
        own = of_part(own, rig.controls, part)
    if character.existing is not None:
        own = with_drawn_handles(character.existing, part.name, found.surface, own)
    settings = replace(settings, layout=own)
    prior = prior_layout_of(
        character.references,
        rig,
        found,
        settings.character.like,
        settings.layout.objective.keep_penalty,
    )
    references = References(prior, character.existing, character.clips, tuple(neighbours))
    pins, values = character.pins, character.base_values
    while True:
        fixed = with_sections(settings, controls=with_pins(settings.rig.controls, pins))
        try:
            inputs = problem_at(
                rig,
                found,
                fixed,
                values,
                references,
                clock,
                character.camera,
                part.name,
                character.symmetry,
            )
        except RigUIError as error:
            fewer = pins.without(error)
            if fewer is None:
                raise
            pins = fewer
        else:
            return replace(
                inputs, matchings=character.references.matchings, asked=character.asked, pins=pins
            )


@dataclass(frozen=True, eq=False)
class LaidPart:
    """One part of a character, laid out."""

    inputs: ProblemInputs
    layout: Layout
    assignment: Assignment


def build_problem(
    rig: Rig,
    settings: Settings,
    clock: Clock | None = None,
    cameras: Mapping[str, Floats] | None = None,
    references: ReferenceLayouts | None = None,
) -> ProblemInputs:
    """The layout problem of all controls of a rig as one part."""
    whole = with_sections(settings, parts=PartSettings(divide=False))
    character = divided(rig, whole, clock, cameras, references)
    return part_problem(character, character.parts[0], (), clock)


def problem_at(
    rig: Rig,
    found: Trajectories,
    settings: Settings,
    base_values: Floats,
    references: References = NO_REFERENCES,
    clock: Clock | None = None,
    camera: Floats | None = None,
    part: str = FACE,
    whole: Symmetry | None = None,
) -> ProblemInputs:
    """The layout problem at a base pose (controls,) whose trajectories are found; `camera` (3,) is
    the direction to the viewer of the camera that ``candidates.view`` names, `whole` the symmetry
    of the character whose part this is.
    """
    clock = clock or Clock()
    measured = measure(rig, found, settings, base_values, references, clock, camera, part, whole)
    face, requests, alike = measured.face, measured.requests, measured.similarity
    layout = settings.layout
    with clock.stage("candidates"):
        candidates = find_candidates(
            face,
            measured.classification,
            requests,
            layout.candidates,
            LinearTerms.of(layout),
            layout.objective.samples,
        )
        candidates = of_new_controls(requests.existing, rig.controls, found.motions, candidates)
    with clock.stage("problem"):
        groups = find_groups(
            face,
            candidates,
            alike,
            requests,
            layout.groups,
            settings.character.symmetry,
            settings.rig.controls,
        )
        groups = with_levels(rig, groups, layout.levels, requests.existing_names)
        placement = placement_problem(face, candidates, groups, requests, settings)
    return ProblemInputs(
        part,
        face,
        alike,
        requests,
        measured.classification,
        settings,
        candidates,
        placement,
        base_values,
    )


def measure(
    rig: Rig,
    found: Trajectories,
    settings: Settings,
    base_values: Floats,
    references: References,
    clock: Clock,
    camera: Floats | None,
    part: str = FACE,
    whole: Symmetry | None = None,
) -> Measured:
    """The stages before placing; parameters as of `problem_at`."""
    _refuse_motionless(rig.skel_root.path, found.motions)
    candidates, objective = settings.layout.candidates, settings.layout.objective
    twin_similarity = settings.character.symmetry.twin_similarity
    with clock.stage("symmetry"):
        fields, twins = displacement_fields(found), configured_twins(rig, settings.rig.controls)
        # A hand by itself is nearly symmetric about its middle finger.
        about = whole if whole is not None and whole.plane.normal.any() and part != FACE else None
        if about is None:
            symmetry = symmetry_at_pose(
                rig,
                found,
                fields,
                settings.character.symmetry,
                twins,
                settings.character.trajectories,
                base_values,
            )
            about = None if symmetry.plane.normal.any() else whole
        if about is not None:
            symmetry = about_plane_of(
                rig.controls, found.motions, fields, about, twin_similarity, twins
            )
    with clock.stage("candidates"):
        views = find_views(
            rig,
            found,
            symmetry.plane,
            candidates.view,
            candidates.occlusion,
            camera,
        )
        requests = _requests(rig, found, symmetry, settings, references)
        expected = expectations(found, symmetry, views, requests.names.meanings)
        requests = replace(requests, names=replace(requests.names, expected=expected))
        alike = similarity(fields)
        classification = classify(rig, found, symmetry, views, alike, requests, candidates)
        flat = candidates.space == "view" or (candidates.space == "part" and part in FLAT)
        placed = on_face(found.motions, classification, requests.overrides)
        axes = views.drawing_axes(flat)
        width = handle_width(found, views, placed, axes if flat else views.axes, objective)
        if objective.distinctive_weight > 0.0:
            found = with_common_motion(found, alike, placed, views.anywhere)
    return Measured(Face(rig, found, symmetry, views, width, flat), alike, requests, classification)


def layout_of(inputs: ProblemInputs, assignment: Assignment) -> Layout:
    """The layout that a solution of the problem means."""
    left_off = (*inputs.face.rig.findings.left_off, *inputs.left_off)
    found = layout(
        inputs.face,
        inputs.placement,
        assignment,
        inputs.requests,
        inputs.settings,
        left_off,
        inputs.base_values,
        inputs.part,
    )
    rig, asked = inputs.face.rig, inputs.asked or inputs.settings
    return with_decisions(
        found,
        rig,
        posed(rig, None).points,
        asked.rig.controls,
        asked.layout.groups.groups,
        inputs.pins,
        inputs.requests.overrides,
    )


def joined(laid: Sequence[LaidPart]) -> Layout:
    """The layouts of all parts as one."""
    layouts = {each.inputs.part: each.layout for each in laid}
    main = layouts[main_part(layouts)]
    if len(laid) == 1:
        return main
    whole = joined_assignment([each.assignment for each in laid], list(layouts))
    parts = [
        LayoutPart(
            name,
            each.frame.handle_width,
            each.frame.view,
            each.proof.status,
            each.proof.cost,
            each.proof.bound,
        )
        for name, each in layouts.items()
    ]
    return replace(
        main,
        elements=tuple(element for each in layouts.values() for element in each.elements),
        left_off=tuple(dict.fromkeys(left for each in layouts.values() for left in each.left_off)),
        frame=replace(main.frame, parts=tuple(parts)),
        proof=proof_of(whole, main.proof.weights),
    )


def joined_assignment(assignments: Sequence[Assignment], names: Sequence[str]) -> Assignment:
    """The solutions of all parts, whose `names` are given, as one: costs and bounds are sums.

    How the whole ended is told by the first part that is open, else by the first that took a
    solver.
    """
    if len(assignments) == 1:
        return assignments[0]
    return replace(
        max(assignments, key=lambda each: (each.status != "optimal", each.method != "bounds")),
        labels=np.concatenate([each.labels for each in assignments]),
        cost=sum(each.cost for each in assignments),
        bound=sum(each.bound for each in assignments),
        above_unary_bound=sum(each.above_unary_bound for each in assignments),
        steps=tuple(
            replace(step, name=f"{name}: {step.name}")
            for name, each in zip(names, assignments, strict=True)
            for step in each.steps
        ),
    )


def issues_of(laid: Sequence[ProblemInputs]) -> tuple[Issue, ...]:
    """Findings about a rig and its controls, each once."""
    if len(laid) == 1:
        return laid[0].issues
    return tuple(dict.fromkeys(found for inputs in laid for found in inputs.issues))


def _requests(
    rig: Rig, found: Trajectories, symmetry: Symmetry, settings: Settings, references: References
) -> Requests:
    """The configuration and the existing layouts, as what they ask of each control."""
    overrides = with_twins(
        rig,
        found,
        symmetry,
        control_overrides(rig, settings.rig.controls, settings.layout.groups.groups),
    )
    overrides = animation.weighted(
        rig, symmetry.twins, overrides, references.clips, settings.character.animation.weight
    )
    names = [control.name for control in rig.controls]
    meant = meanings(names) if settings.layout.candidates.conventions else (None,) * len(names)
    return Requests(
        overrides,
        references.prior,
        references.existing,
        neighbours=references.neighbours,
        names=Names(meant),
    )


def _refuse_motionless(root: str, motions: tuple[Motion, ...]) -> None:
    if not motions:
        raise refuse("CONTROLS_MISSING", root, "none of its controls moves a point")
