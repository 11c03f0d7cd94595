"""The problem that a layout answers: its elements are variables, their anchors candidates."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.character import Control, Indices
from usdrigui.layout.face import Face
from usdrigui.layout.measured import Measured
from usdrigui.layout.place.problem import off_face_cost, placement_problem
from usdrigui.layout.shares import NOTHING
from usdrigui.model import (
    Candidates,
    CandidateSet,
    Choice,
    Element,
    Group,
    LayoutProblem,
)
from usdrigui.model.levels import inner_names, states, with_levels
from usdrigui.overlap import total_cost


def layout_cost(known: Measured, candidates: Candidates, elements: tuple[Element, ...]) -> float:
    """The objective of a layout by its places alone, whatever it was made from: the one that
    `review` gives; nan where an element cannot be rated."""
    sound = sound_elements(known.face, elements)
    problem, choices, labels = as_problem(known, candidates, elements, sound)
    placed = sum(not element.anchor.on_board for element in elements)
    if len(choices) < placed:
        return float("nan")
    return total_cost(problem, labels) + board_cost(known, candidates, elements)


def board_cost(known: Measured, candidates: Candidates, elements: tuple[Element, ...]) -> float:
    """What the elements on the board cost that could stand on the face."""
    face, requests = known.face, known.requests
    index = face.rig.control_indices
    able = {
        name
        for name, found in zip(face.names, known.classification, strict=True)
        if index[name] in candidates.sets and not found.category
    }
    inner = inner_names(elements)
    away = tuple(
        element
        for element in elements
        if element.anchor.on_board and element.name not in inner and able >= element.controls
    )
    objective = known.settings.objective
    groups = _as_groups(face.rig.controls, elements, away)
    return sum(off_face_cost(face, group, requests, objective) for group in groups)


def sound_elements(face: Face, elements: tuple[Element, ...]) -> tuple[Element, ...]:
    """The elements on the face that can be rated: mesh, point and controls exist and the controls
    move it."""
    moving = {*face.names}
    return tuple(
        element
        for element in elements
        if not element.anchor.on_board
        and element.anchor.on(face.rig.body) >= 0
        and moving >= element.controls
    )


def as_problem(
    known: Measured,
    candidates: Candidates,
    every: tuple[Element, ...],
    elements: tuple[Element, ...],
) -> tuple[LayoutProblem, tuple[Choice, ...], Indices]:
    """The problem in which each of the `elements` is one variable, its own anchor among the
    candidates; `every` element of the layout defines of what they are states and parts.

    Beside the elements of other parts, unless one of them is too near: then beside none.
    """
    face = known.face
    groups = _as_groups(face.rig.controls, every, elements)
    points = [element.anchor.on(face.rig.body) for element in elements]
    sets = _with_points(candidates, groups, points)
    placement = placement_problem(known, sets, groups)
    labels, kept = [], []
    for number, choice in enumerate(placement.choices):
        at = np.flatnonzero(choice.anchors[:, 0] == points[choice.group])
        if len(at):
            labels.append(int(at[0]))
            kept.append(number)
    if len(kept) < len(elements) and known.requests.neighbours:
        alone = replace(known, requests=replace(known.requests, neighbours=()))
        return as_problem(alone, candidates, every, elements)
    problem = placement.problem
    separation = min(problem.separation, face.handle_width * (1.0 - NOTHING))
    variables = tuple(problem.variables[number] for number in kept)
    return (
        replace(problem, variables=variables, separation=separation, extra=()),
        tuple(placement.choices[number] for number in kept),
        np.array(labels, dtype=np.int64),
    )


def _as_groups(
    controls: tuple[Control, ...], elements: tuple[Element, ...], sound: tuple[Element, ...]
) -> tuple[Group, ...]:
    index = {control.name: number for number, control in enumerate(controls)}
    seen, inner = states(elements), inner_names(elements)
    parts = {each.name for each, again in with_levels(elements) if again and each.name in inner}
    owned = {each.name: tuple(index[member.control] for member in each.members) for each in sound}
    return tuple(
        Group(
            element.name,
            element.kind,
            owned[element.name],
            element.opposed,
            # A copy of a doubled element is not held to the mirror plane; that of a pair never is.
            owned.get(element.mirror, ()),
            "",
            part=element.name in parts,
            states=seen[element.name],
        )
        for element in sound
    )


def _with_points(
    candidates: Candidates, groups: tuple[Group, ...], points: list[int]
) -> Candidates:
    """The candidates with the anchors of the layout among them, pruned or not."""
    sets = dict(candidates.sets)
    for group, point in zip(groups, points, strict=True):
        for control in sets.keys() & group.controls:
            found = sets[control]
            if point in found.motion.points and point not in found.points:
                at = int(np.searchsorted(found.points, point))
                places = (np.insert(each, at, point) for each in (found.points, found.sources))
                sets[control] = CandidateSet(found.motion, *places)
    return Candidates(sets, candidates.left_off)
