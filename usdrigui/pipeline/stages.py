"""build_problem(): from a rig to its layout problem.

    Rig → Trajectories → Symmetry → Views → Classification → Face → Candidates → Groups → PlacementProblem

The order of these stages is known here and nowhere else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from usdrigui import animation
from usdrigui.conventions import meanings
from usdrigui.errors import Issue, meant, refuse
from usdrigui.examples import Examples, own_examples, prior_layout_of, with_fixed
from usdrigui.layout.canonical_face import expectations
from usdrigui.layout.classify.classification import Classification, classify
from usdrigui.layout.control_overrides import control_overrides
from usdrigui.layout.element.elements import layout
from usdrigui.layout.face import Face
from usdrigui.layout.group.coarse_groups import with_levels
from usdrigui.layout.group.grouping import find_groups
from usdrigui.layout.motion.similarity import Similarity, displacement_fields, similarity
from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.layout.place.candidates import find_candidates
from usdrigui.layout.place.handle_width import handle_width, on_face
from usdrigui.layout.place.problem import PlacementProblem, placement_problem
from usdrigui.layout.reuse.existing_layout import of_new_controls, with_drawn_handles
from usdrigui.layout.reuse.identity import Matching, matching_issues
from usdrigui.layout.reuse.prior_layout import NO_PRIOR, PriorLayout
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.review.review import refuse_stale
from usdrigui.layout.symmetry.base_pose import symmetry_at_pose
from usdrigui.layout.visibility import find_views
from usdrigui.model import (
    Assignment,
    Candidates,
    Floats,
    Layout,
    LeftOff,
    Performance,
    Rig,
    Symmetry,
    Trajectories,
)
from usdrigui.pipeline.progress import Clock
from usdrigui.settings import Settings


@dataclass(frozen=True, eq=False)
class References:
    """Layouts and animations to which one character's layout refers."""

    prior: PriorLayout = NO_PRIOR
    existing: Layout | None = None
    clips: tuple[Performance, ...] = ()


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
    """By ``fixed``, ``previous`` and ``like``: which control of that layout is which of this rig."""

    @property
    def issues(self) -> tuple[Issue, ...]:
        """Findings about the rig and its controls."""
        unexplained = (found for each in self.classification for found in each.issues)
        renamed = (found for which, each in self.matchings.items() for found in matching_issues(which, each))
        return (*self.face.rig.issues, *self.face.trajectories.issues, *unexplained, *renamed)

    @property
    def left_off(self) -> tuple[LeftOff, ...]:
        """Controls that the stages after reading left off, and why."""
        return (*self.face.trajectories.left_off, *self.candidates.left_off)

    @property
    def twin_names(self) -> dict[str, str]:
        """Names of the controls that have a twin other than themselves, to its name."""
        controls, twins = self.face.rig.controls, self.face.symmetry.twins
        return {
            control.name: controls[twin].name
            for control, twin in zip(controls, twins, strict=True)
            if twin >= 0 and controls[twin] is not control
        }


def build_problem(
    rig: Rig,
    settings: Settings,
    clock: Clock | None = None,
    cameras: Mapping[str, Floats] | None = None,
    examples: Examples | None = None,
) -> ProblemInputs:
    """The layout problem of one rig: every stage between reading and solving."""
    clock, examples = clock or Clock(), examples or Examples()
    camera = _camera(rig, settings.candidates.view, cameras or {})
    base_values = _base_values(rig, settings)
    with clock.stage("trajectories"):
        found = trajectories(rig, settings.trajectories, base_values)
    own = own_examples(examples, rig, found, settings)
    settings = with_fixed(own, rig, settings)
    existing = examples.existing(rig)
    if existing is not None:
        settings = with_drawn_handles(existing, found, settings)
        refuse_stale(rig, found, existing, settings.read)
    references = References(prior_layout_of(own, rig, found, settings), existing, examples.clips)
    inputs = problem_at(rig, found, settings, base_values, references, clock, camera)
    return replace(inputs, matchings=own.matchings)


def problem_at(
    rig: Rig,
    found: Trajectories,
    settings: Settings,
    base_values: Floats,
    references: References = NO_REFERENCES,
    clock: Clock | None = None,
    camera: Floats | None = None,
) -> ProblemInputs:
    """The layout problem at a base pose (controls,) whose trajectories are found; `camera` (3,) is the direction to the
    viewer of the camera that ``candidates.view`` names."""
    clock = clock or Clock()
    measured = measure(rig, found, settings, base_values, references, clock, camera)
    face, requests, alike = measured.face, measured.requests, measured.similarity
    with clock.stage("candidates"):
        candidates = find_candidates(face, measured.classification, requests, settings)
        candidates = of_new_controls(requests.existing, rig, found, candidates)
    with clock.stage("problem"):
        groups = find_groups(face, candidates, alike, requests, settings)
        groups = with_levels(rig, groups, settings.levels, requests.existing_names)
        placement = placement_problem(face, candidates, groups, requests, settings)
    return ProblemInputs(face, alike, requests, measured.classification, settings, candidates, placement, base_values)


def measure(
    rig: Rig,
    found: Trajectories,
    settings: Settings,
    base_values: Floats,
    references: References,
    clock: Clock,
    camera: Floats | None,
) -> Measured:
    """The stages before placing; parameters as of `problem_at`."""
    if not found.motions:
        raise refuse("CONTROLS_MISSING", rig.root, "none of its controls moves a point")
    with clock.stage("symmetry"):
        fields = displacement_fields(found)
        symmetry = symmetry_at_pose(rig, found, fields, settings, base_values)
    with clock.stage("candidates"):
        views = find_views(rig, found, symmetry, settings.candidates.view, settings.candidates.occlusion, camera)
        requests = _requests(rig, symmetry, settings, references)
        told = meanings([control.name for control in rig.controls])
        requests = replace(requests, meanings=told, expected=expectations(found, symmetry, views, told))
        alike = similarity(fields)
        classification = classify(rig, found, symmetry, views, alike, requests, settings.candidates)
        toward = views.flat_direction(settings.candidates.space)
        standing = on_face(found, classification, requests.overrides)
        width = handle_width(found, views, standing, toward, settings.objective)
    return Measured(Face(rig, found, symmetry, views, width), alike, requests, classification)


def layout_of(inputs: ProblemInputs, assignment: Assignment) -> Layout:
    """The layout that a solution of the problem means."""
    left_off = (*inputs.face.rig.left_off, *inputs.left_off)
    return layout(
        inputs.face, inputs.placement, assignment, inputs.requests, inputs.settings, left_off, inputs.base_values
    )


def _requests(rig: Rig, symmetry: Symmetry, settings: Settings, references: References) -> Requests:
    """The configuration and the existing layouts, as what they ask of each control."""
    overrides = control_overrides(rig, settings)
    overrides = animation.weighted(rig, symmetry, overrides, references.clips, settings.animation.weight)
    return Requests(overrides, references.prior, references.existing)


def _camera(rig: Rig, view: str, cameras: Mapping[str, Floats]) -> Floats | None:
    """(3,) direction to the viewer of the camera that the view names, if it names one."""
    camera = cameras.get(rig.root)
    if view.startswith("/") and camera is None:
        raise refuse("CONFIG_VALUE", "candidates.view", f"there is no camera {view}")
    return camera


def _base_values(rig: Rig, settings: Settings) -> Floats:
    """(controls,) the base pose (paper: P)."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    values = np.array([control.default for control in rig.controls], dtype=np.float64)
    for name, value in settings.read.pose.items():
        if name not in index:
            what = f"{rig.root} has no control of this name{meant(name, index)}"
            raise refuse("CONFIG_UNKNOWN_CONTROL", f'read.pose."{name}"', what)
        values[index[name]] = value
    return values
