"""The layout problem: every element's candidates, their costs and their geometry (paper eq. 2 to
5).

The overlap's radius is measured in handle widths, so that the same character in metres and in
centimetres gets the same layout; ``objective.scene_units`` takes the paper's constants literally
instead.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import chain, combinations

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from usdrigui.character import Floats, Indices, Record
from usdrigui.character.surface import mean_edge_length, mesh_triangles
from usdrigui.errors import RigUIError, refuse
from usdrigui.layout.face import Face
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.coverage import NOTABLE
from usdrigui.layout.names import element_name
from usdrigui.layout.place.candidates import candidates_of_axis, loosened
from usdrigui.layout.place.extensions import user_pairs
from usdrigui.layout.place.labels import drawn_points, labels_of
from usdrigui.layout.reuse.existing_layout import costs_beside_existing, existing_variables
from usdrigui.layout.reuse.prior_layout import leaving_penalties
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import (
    AnyOverlap,
    Candidates,
    CandidateSet,
    Choice,
    Group,
    LayoutProblem,
    MeanOverlap,
    Overlap,
    Variable,
)
from usdrigui.overlap import own_costs
from usdrigui.settings import ControlSettings, ObjectiveSettings

_NEEDED = 5.0
"""What it costs besides, per copy, that a control leaves the face that is needed there: more than
any place does."""
_COVERED = 3.0
"""How much dearer it is that handles are near each other on a screen where nothing forbids that
one covers another."""
_COINCIDENT = 1e-9
"""Separation that forbids only a shared point, in face sizes."""

Contradiction = tuple[RigUIError, tuple[frozenset[int], ...]]
"""FIXED_IMPOSSIBLE where fixed anchors contradict each other, and the controls of each element that
they are of."""


class PlacementProblem(Record):
    """The problem whose solution is the layout of all groups that may stand on the face."""

    groups: tuple[Group, ...]
    problem: LayoutProblem
    choices: tuple[Choice, ...]
    """(variables,) what the labels of each variable mean."""
    impossible: Contradiction | None = None


def placement_problem(
    known: Measured, candidates: Candidates, groups: tuple[Group, ...]
) -> PlacementProblem:
    """One variable for each group that may stand on the face.  Raises TERM_INVALID for a term of
    another package."""
    face, requests, objective = known.face, known.requests, known.settings.objective
    overlap, separation = _constants(face, objective)
    beside = () if face.behind else requests.neighbours
    existing = existing_variables(face, requests.existing_elements + beside, objective.samples)
    costs = _Costs(known, overlap, separation, existing, _others(face, requests))
    variables, choices = [], []
    for index, group in enumerate(groups):
        if group.category:
            continue
        asked, own = costs, candidates.sets
        if group.part:
            axes = replace(known, requests=requests.of_axes())
            asked = replace(costs, known=axes)
            own = {
                control: candidates_of_axis(axes, own[control])
                for control in sorted(group.all_controls)
            }
        variable, choice = _variable(asked, own, groups, index)
        variables.append(variable)
        choices.append(choice)
    problem = LayoutProblem(tuple(variables), overlap, separation)
    impossible = _impossible(problem, groups, tuple(choices), requests.overrides)
    extra = user_pairs(face, problem, tuple(choices), objective.terms)
    return PlacementProblem(groups, replace(problem, extra=extra), tuple(choices), impossible)


def without_lone_pairs(
    known: Measured, candidates: Candidates, groups: tuple[Group, ...]
) -> tuple[Group, ...]:
    """The groups, with the element of either side in place of a pair that has no two places which
    mirror each other, as arms modelled in a pose, and one in place of a doubled element: they lose
    the mirror and not the character."""
    face, sets = known.face, candidates.sets
    found: list[Group] = []
    for index, group in enumerate(groups):
        is_pair = bool(group.mirror) and not group.category
        looser = chain([sets], _looser(known, sets, group.copies))
        costs = (labels_of(known, used, groups, index)[1] for used in looser)
        if is_pair and not any(np.isfinite(each).any() for each in costs):
            names = [face.control_name(control) for control in group.mirror]
            found += group.apart(element_name(names, face.rig.control_names))
        else:
            found.append(group)
    return tuple(sorted(found, key=lambda group: group.name))


def _looser(
    known: Measured, sets: Mapping[int, CandidateSet], copies: tuple[tuple[int, ...], ...]
) -> Iterator[Mapping[int, CandidateSet]]:
    """The sets of an element's controls where handles keep less and less of the peak, for it to
    have a place at all."""
    shares = (known.pruning.least_kept, NOTABLE)
    for least in shares[: 1 + (len(copies[0]) > 1)]:
        yield {
            control: loosened(known, sets[control], least) for each in copies for control in each
        }


def penalties_of_leaving(face: Face, requests: Requests, choice: Choice) -> tuple[Floats, float]:
    """What an earlier layout makes each label cost (R,), and what it makes leaving the face cost,
    above what it makes all of them cost."""
    prior, base = requests.prior, face.surface.points
    stay, leave = np.zeros(len(choice.anchors)), 0.0
    copies = [set(controls) for controls in choice.controls]
    for controls in choice.controls:
        # A doubled element has one earlier place, that of its first copy.
        anchors = choice.anchors[:, copies.index(set(controls))]
        stay += leaving_penalties(prior, controls, anchors, base, face.handle_width)
        leave += prior.leaving_penalty * prior.stood_on_face(controls)
    # What no solution saves is no part of what is to be proved.
    forced = stay.min(initial=leave)
    return stay - forced, leave - forced


def penalty_of(
    face: Face, requests: Requests, placement: PlacementProblem, labels: Indices
) -> float:
    """What all the earlier places cost that a solution leaves."""
    penalty = 0.0
    for choice, label in zip(placement.choices, labels, strict=True):
        part = placement.groups[choice.group].part
        stay, leave = penalties_of_leaving(face, requests.of_axes() if part else requests, choice)
        penalty += leave if label < 0 else float(stay[label])
    return penalty


def _constants(face: Face, settings: ObjectiveSettings) -> tuple[AnyOverlap, float]:
    """The overlap's constants and the separation in scene units."""
    trajectories, width = face.trajectories, face.handle_width
    separation = width if settings.separation else _COINCIDENT * trajectories.surface.face_size
    if settings.overlap == "seen":
        # A crowd that made handles narrower has no room to give.
        has_room = width >= settings.handle_size * trajectories.surface.face_size
        seen = Overlap(
            samples=settings.samples,
            handle_width=width,
            near=settings.near_weight * (_COVERED if face.behind else 1.0),
            near_radius=settings.near_radius * width,
            room=settings.room_weight * has_room,
            room_radius=settings.room_radius * width,
            on_track=settings.track_weight,
            track_radius=settings.track_radius * width,
            crossing=settings.crossing_weight,
            along=settings.along_weight,
            along_radius=settings.along_radius * width,
            short=settings.short_weight,
        )
        return seen, separation
    if settings.scene_units:
        corners = mesh_triangles(face.rig.body.meshes)
        radius = (
            mean_edge_length(trajectories.surface.points, corners, trajectories.surface.places)
            * settings.overlap_radius
        )
        sharpness = settings.overlap_sharpness
    else:
        radius = settings.overlap_radius * face.handle_width
        sharpness = settings.overlap_sharpness / radius
    cutoff_distance = settings.overlap_cutoff * radius or np.inf
    weight = 1.0 - settings.displacement_weight
    return MeanOverlap(settings.overlap_max, radius, sharpness, cutoff_distance, weight), separation


def _others(face: Face, requests: Requests) -> cKDTree:
    """The handles of other parts that may be behind those of this one, along its axes for them."""
    elements = requests.neighbours if face.behind else ()
    positions = [element.anchor.position for element in elements]
    return cKDTree(np.reshape(positions, (-1, 3)) @ face.handle_axes.T)


class _Costs(Record):
    """What every variable is costed with."""

    known: Measured
    overlap: AnyOverlap
    separation: float
    existing: tuple[Variable, ...]
    """Elements of an existing layout."""
    others: cKDTree
    """Handles of other parts, from which an element stays apart whatever it looks like from the
    front: each part is looked at by itself."""


def _variable(
    costs: _Costs,
    sets: Mapping[int, CandidateSet],
    groups: tuple[Group, ...],
    index: int,
) -> tuple[Variable, Choice]:
    """The variable of group `index`, with loosened candidates where its copies collide at all
    others, or its members share none; of a group that is missed off the face, or of a joint, also
    where they are one spot, which another one may take."""
    known, group = costs.known, groups[index]
    face, requests, objective = known.face, known.requests, known.settings.objective
    roomy = _needed(face, group.controls) or all(
        face.trajectories.motion_of(control).of_joint for control in group.controls
    )
    for used in chain([sets], _looser(known, sets, group.copies)):
        choice, cost, displacement = labels_of(known, used, groups, index)
        samples, handles = drawn_points(
            face, choice, objective.samples, known.settings.output.min_track
        )
        cost = cost + own_costs(samples, handles, costs.overlap, costs.separation)
        cost += costs_beside_existing(
            costs.existing, costs.overlap, costs.separation, samples, handles
        )
        apart, _ = costs.others.query(handles)
        kept = np.isfinite(cost) & (apart >= costs.separation).all(axis=1)
        spots = handles[kept][:, 0, : samples.shape[-1]]
        spot = np.ptp(spots, axis=0).max() if kept.any() else 0.0
        if kept.any() and (not roomy or spot >= costs.separation):
            break
    choice = Choice(index, choice.controls, choice.anchors[kept], choice.sources[kept])
    stay, leave = penalties_of_leaving(face, requests, choice)
    return (
        Variable(
            group.name,
            choice.anchors[:, 0],
            cost[kept] + stay,
            samples[kept],
            handles[kept],
            off_face_cost(face, group, requests, objective) + leave,
            displacement[kept],
            group.states,
        ),
        choice,
    )


def off_face_cost(
    face: Face, group: Group, requests: Requests, settings: ObjectiveSettings
) -> float:
    """Cost of sending the element and its images to the board, which takes all its controls off the
    face; inf where they must stand on the face."""
    overrides = [requests.overrides[control] for control in group.controls]
    if not settings.off_face_allowed or any(
        each.place in ("face", "proxy") or each.anchor for each in overrides
    ):
        return float(np.inf)
    if requests.prior.stood_on_board(group.controls):
        return 0.0  # Nothing leaves the face.
    leaves, needed = len(group.controls), _needed(face, group.controls)
    return (settings.off_face_penalty * leaves + _NEEDED * needed) * len(group.copies)


def _needed(face: Face, controls: tuple[int, ...]) -> int:
    """How many controls of the element are missed where they leave the face: those whose names say
    what they do there, and the joints of a body, where nobody looks for them on a board."""
    return sum(
        (face.behind and face.trajectories.motion_of(control).of_joint)
        or ((meaning := face.meanings[control]) is not None and not meaning.action.vague)
        for control in controls
    )


# --- fixed anchors --------------------------------------------------------------------------------


def _impossible(
    problem: LayoutProblem,
    groups: tuple[Group, ...],
    choices: tuple[Choice, ...],
    overrides: tuple[ControlSettings, ...],
) -> Contradiction | None:
    """FIXED_IMPOSSIBLE when the fixed anchors contradict each other, naming them."""
    fixed = list(_fixed(groups, choices, overrides))
    controls = {number: groups[choices[number].group].all_controls for number in fixed}

    def told(what: str, *numbers: int) -> Contradiction:
        error = refuse("FIXED_IMPOSSIBLE", problem.variables[numbers[0]].name, what)
        return error, tuple(controls[number] for number in numbers)

    for number in fixed:
        group = groups[choices[number].group]
        anchors = sorted({overrides[control].anchor for control in group.controls} - {""})
        if len(anchors) > 1:
            return told(f"one element is fixed at {' and at '.join(anchors)}", number)
        if not len(choices[number].anchors):
            why = "not all of its controls can be anchored there, or its copies would collide"
            return told(f"cannot be anchored at {anchors[0]}: {why}", number)
    for a, b in combinations(fixed, 2):
        one, other = problem.variables[a], problem.variables[b]
        apart = cdist(one.handles[0], other.handles[0]).min()
        if problem.together[a, b] and apart < problem.separation:
            share = f"{apart / problem.separation:.2f} of the least distance of two handles"
            return told(f"is fixed at {share} from {other.name}", a, b)
    return None


def _fixed(
    groups: tuple[Group, ...], choices: tuple[Choice, ...], overrides: tuple[ControlSettings, ...]
) -> Iterator[int]:
    """Numbers of the variables with a fixed anchor."""
    for number, choice in enumerate(choices):
        group = groups[choice.group]
        if not group.part and any(overrides[control].anchor for control in group.controls):
            yield number
