"""The stages from a rig to the layouts of its parts; their order is known here and nowhere else.

Rig → Trajectories → Parts → Symmetry → Requests → Views → Classification → Face → Candidates →
Groups → PlacementProblem → Assignment → Layout
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import Rig
from usdrigui.character.deform import posed
from usdrigui.conventions import meanings
from usdrigui.errors import RigUIError, refuse
from usdrigui.layout.canonical_face import believed, own_up
from usdrigui.layout.classify.classification import classify
from usdrigui.layout.classify.common_motion import with_common_motion
from usdrigui.layout.element.elements import layout
from usdrigui.layout.face import Face
from usdrigui.layout.group.coarse_groups import with_levels
from usdrigui.layout.group.grouping import find_groups
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.similarity import displacement_fields, similarity
from usdrigui.layout.motion.trajectory import at_scale_of_a_side, of_controls, trajectories
from usdrigui.layout.parts.division import divide
from usdrigui.layout.parts.joint_regions import FACE, OF_SIDES, seen_flat
from usdrigui.layout.place.candidates import find_candidates
from usdrigui.layout.place.handle_width import handle_width
from usdrigui.layout.place.problem import (
    PlacementProblem,
    penalty_of,
    placement_problem,
    without_lone_pairs,
)
from usdrigui.layout.place.regions import crowded_regions, joints_behind_shapes
from usdrigui.layout.reuse.decisions import with_decisions
from usdrigui.layout.reuse.existing_layout import drawn_width, of_new_controls
from usdrigui.layout.reuse.prior_layout import NO_PRIOR
from usdrigui.layout.review.layout_faults import refuse_stale
from usdrigui.layout.review.layout_problem import layout_cost
from usdrigui.layout.symmetry.base_pose import (
    NeutralPose,
    neutral_pose,
    symmetry_at_pose,
    with_left_of,
)
from usdrigui.layout.visibility import find_views
from usdrigui.model import Assignment, Candidates, Element, Layout, Symmetry, Trajectories
from usdrigui.pipeline.configuration import base_values_of
from usdrigui.pipeline.progress import Clock
from usdrigui.pipeline.records import Character, CharacterPart, ProblemInputs
from usdrigui.pipeline.reference_layouts import OwnReferences, ReferenceLayouts
from usdrigui.pipeline.requested import own_references, prior_of, requested
from usdrigui.settings import PartSettings, Settings


def character_of(
    rig: Rig,
    settings: Settings,
    references: ReferenceLayouts | None = None,
    clock: Clock | None = None,
) -> Character:
    """What is found out about a character as a whole: its motions, its parts, and what is asked."""
    clock, root = clock or Clock(), rig.path
    base_values = base_values_of(rig, settings.read.pose)
    with clock.stage("trajectories"):
        found = trajectories(rig, settings.trajectories, base_values)
        if not found.motions:
            raise refuse("CONTROLS_MISSING", root, "none of its controls moves a point")
    neutral = neutral_pose(rig, settings)
    # Everything that knows an up direction begins again, once, by that of a face that lies down.
    for again in (False, True):
        with clock.stage("symmetry"):
            whole = symmetry_at_pose(rig, found, neutral, settings)
            parts = _parts(rig, found, (whole, neutral), settings)
        face = parts[0].trajectories if parts[0].name == FACE else None
        up = own_up(rig, whole.plane, face)
        if again or (up == rig.up).all():
            break
        rig = replace(rig, up=up)
        every = range(len(rig.controls) + len(rig.excluded))
        found = of_controls(rig, found, every, settings.trajectories)
    own = own_references(references or ReferenceLayouts(), rig, found, settings)
    if own.existing is not None:
        refuse_stale(rig, found, own.existing, settings.read)
    requests = requested(rig, parts, settings, own)
    liked = tuple(replace(each, prior=prior_of(rig, each, settings, own)) for each in parts)
    return Character(rig, settings, base_values, found, whole, liked, own, requests)


def _parts(
    rig: Rig, found: Trajectories, mirror: tuple[Symmetry, NeutralPose | None], settings: Settings
) -> tuple[CharacterPart, ...]:
    """The parts of a character with their own trajectories and symmetry; `mirror` is the symmetry
    of the whole, and its neutral pose.  A face has a plane of its own."""
    divided, sampling = divide(rig, found, settings), settings.trajectories
    (whole, neutral), parts = mirror, []
    for part in divided:
        own, symmetry = found, whole
        if len(divided) > 1:
            own = of_controls(rig, found, part.controls, sampling)
            if part.name == FACE:
                symmetry = with_left_of(whole.plane, symmetry_at_pose(rig, own, neutral, settings))
        if part.name in OF_SIDES:
            own = at_scale_of_a_side(own, symmetry.plane)
        parts.append(CharacterPart(part.name, own, symmetry))
    return tuple(parts)


def part_problem(
    character: Character,
    part: CharacterPart,
    neighbours: Sequence[Element] = (),
    clock: Clock | None = None,
) -> ProblemInputs:
    """The layout problem of one part; `neighbours` are the elements of the parts that are laid out
    already.

    Raises FIXED_IMPOSSIBLE where what is fixed contradicts itself; decisions in an earlier layout
    that are in the way are given up instead.
    """
    clock = clock or Clock()
    while True:
        with clock.stage("candidates"):
            known = measured(character, part, neighbours)
            candidates = of_new_controls(known.face, known.requests, find_candidates(known))
        with clock.stage("problem"):
            placement = _placement(known, candidates)
        if placement.impossible is None:
            return ProblemInputs(character, part.name, known, candidates, placement)
        character = _without_pin(character, *placement.impossible)


def measured(character: Character, part: CharacterPart, neighbours: Sequence[Element]) -> Measured:
    """The stages before placing."""
    rig, found, symmetry = character.rig, part.trajectories, part.symmetry
    settings = character.settings
    requests = character.requests.of_part(rig.controls, part.controls, neighbours, part.prior)
    each_side = part.name in OF_SIDES
    views = find_views(rig, found, symmetry.plane, settings.candidates, of_sides=each_side)
    names = rig.control_names
    read = meanings(names, numbers=True) if settings.candidates.conventions else [None] * len(names)
    meant, expected = believed(found, symmetry, views, read)
    face = Face(rig, found, symmetry, views, meant, expected)
    alike = similarity(displacement_fields(found))
    classification = classify(face, alike, requests, settings.candidates)
    placed = np.array([not each.category for each in classification])
    places = found.surface.points @ views.axes.T
    flat, behind = seen_flat(part.name, settings.candidates.space, places)
    axes = views.drawing_axes(flat and not each_side)
    width, crowded = handle_width(
        found, views, placed, axes, settings.objective, levels=settings.levels.crowds
    )
    width = drawn_width(requests.existing, part.name) or width
    # Anchors that are fixed were apart by a width of the layout that they come from.
    width = min(width, drawn_width(character.references.fixed, part.name) or width)
    if settings.objective.distinctive_weight > 0.0:
        found = with_common_motion(found, alike, placed, views.anywhere)
    face = replace(
        face,
        trajectories=found,
        handle_width=width,
        crowded=crowded,
        flat=flat,
        behind=behind,
        each_side=each_side,
    )
    return Measured(face, alike, requests, classification, character.settings)


def _without_pin(
    character: Character, error: RigUIError, groups: Sequence[frozenset[int]]
) -> Character:
    """The character without the weakest decision of a person that an error about the anchors of
    some groups of controls is about; raises it where it is about none."""
    references, rig = character.references, character.rig
    names = [frozenset(rig.control_names[control] for control in group) for group in groups]
    return _asking(character, replace(references, pins=references.pins.without(error, names)))


def _asking(character: Character, references: OwnReferences) -> Character:
    """The character with other references, and so with other requests."""
    asked = requested(character.rig, character.parts, character.settings, references)
    return replace(character, references=references, requests=asked)


def _placement(known: Measured, candidates: Candidates) -> PlacementProblem:
    face, requests, settings = known.face, known.requests, known.settings
    groups = without_lone_pairs(known, candidates, find_groups(known, candidates))
    most = settings.objective.max_neighbours
    regions = crowded_regions(face, groups, most) if face.crowded else {}
    if settings.levels.crowds and not regions:
        regions = joints_behind_shapes(face, known.similarity, groups)
    groups = with_levels(face.rig, groups, settings.levels, requests, regions)
    return placement_problem(known, candidates, groups)


def build_problem(
    rig: Rig,
    settings: Settings,
    references: ReferenceLayouts | None = None,
    clock: Clock | None = None,
) -> ProblemInputs:
    """The layout problem of all controls of a rig as one part."""
    whole = replace(settings, parts=PartSettings(divide=False))
    character = character_of(rig, whole, references, clock)
    return part_problem(character, character.parts[0], (), clock)


def with_own_cost(
    inputs: ProblemInputs, part: CharacterPart, made: Layout, assignment: Assignment
) -> Assignment:
    """The solution with the cost of the layout that it `made`: the problem of a run that follows
    another layout adds penalties, and counts costs from the places that this leaves.

    The bound moves along, so that it stays as far below.
    """
    references = inputs.character.references
    if not references.followed:
        return assignment
    alone = OwnReferences(existing=references.existing, clips=references.clips)
    character, part = _asking(inputs.character, alone), replace(part, prior=NO_PRIOR)
    plain = part_problem(character, part, inputs.requests.neighbours)
    cost = layout_cost(plain.measured, plain.candidates, made.elements)
    penalty = penalty_of(inputs.face, inputs.requests, inputs.placement, assignment.labels)
    if not np.isfinite(cost):
        cost = assignment.cost - penalty
    bound = cost - (assignment.cost - assignment.bound)
    return replace(assignment, cost=cost, bound=bound, penalty=penalty)


def layout_of(inputs: ProblemInputs, assignment: Assignment) -> Layout:
    """The layout that a solution of the problem means, with the decisions of a person in it."""
    rig = inputs.face.rig
    found = layout(inputs.measured, inputs.placement, assignment, inputs.part)
    found = replace(
        found,
        base_values=inputs.character.base_values,
        matches=inputs.character.references.matches,
        left_off=(*rig.left_off, *inputs.left_off),
    )
    return with_decisions(found, rig, posed(rig, None).points, inputs.requests)
