"""Every element on the face by the objective that would place it, all others staying."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.layout.face import Face
from usdrigui.layout.reuse.partial_layout import place_of
from usdrigui.model import (
    Choice,
    Element,
    LayoutProblem,
)
from usdrigui.overlap import pair_costs


@dataclass(frozen=True, slots=True)
class ElementReview:
    """One element on the face, by the objective."""

    element: str
    kept: float
    """Arc length at the anchor over the control's peak, of the worst member."""
    linear: float
    """Linear cost: displacement (negative), occlusion, plane and the like; all copies."""
    overlap: float
    """Cost of its overlap with all other elements."""
    nearest: str
    """The element whose handle is nearest."""
    distance: float
    """Between the two handles, in handle widths; inf when it is alone."""
    gain: float
    """What moving it to its best place would save, all others staying; a pair moves as one.  0 when
    it is there."""
    better: str
    """That place as ``MESH_PATH#POINT``, ready for a configuration; empty when it is there."""


def ratings(
    face: Face,
    elements: tuple[Element, ...],
    answered: tuple[LayoutProblem, tuple[Choice, ...], Indices],
) -> tuple[ElementReview, ...]:
    """The elements of a layout in the order of the variables of the problem that it answers, as
    `as_problem` gives it."""
    problem, choices, labels = answered
    mates = _mates(face, elements, problem, choices, labels)
    given = [_given_others(problem, labels, index) for index in range(len(labels))]
    return tuple(
        _rated(face, problem, choices, labels, index, mate, given)
        for index, mate in enumerate(mates)
    )


def _rated(
    face: Face,
    problem: LayoutProblem,
    choices: tuple[Choice, ...],
    labels: Indices,
    index: int,
    mate: int,
    given: list[Floats],
) -> ElementReview:
    variable, choice, label = problem.variables[index], choices[index], labels[index]
    alone = given[index].sum(axis=0)
    whole = _cost_with_mate(face, problem, choices, index, mate, given) if mate >= 0 else alone
    best = np.argmin(whole)
    gain = whole[label] - whole[best] if np.isfinite(whole[label]) else np.inf
    nearest, distance = _neighbour(problem, labels, index)
    return ElementReview(
        element=variable.name,
        kept=_kept(face, choice, label),
        linear=float(variable.cost[label]),
        overlap=float(alone[label] - variable.cost[label]),
        nearest=nearest,
        distance=float(distance) / face.handle_width,
        gain=float(gain),
        better=place_of(face.rig.body, int(choice.anchors[best, 0])) if gain > 0.0 else "",
    )


def _mates(
    face: Face,
    elements: tuple[Element, ...],
    problem: LayoutProblem,
    choices: tuple[Choice, ...],
    labels: Indices,
) -> list[int]:
    """For every element the other one of its pair, where the two are mirror images; else
    -1."""
    mirror = {element.name: element.mirror for element in elements}
    index = {variable.name: i for i, variable in enumerate(problem.variables)}
    at = [choice.anchors[label, 0] for choice, label in zip(choices, labels, strict=True)]
    mates = [index.get(mirror[variable.name], -1) for variable in problem.variables]
    return [
        j if j >= 0 and face.symmetry.partner[at[i]] == at[j] else -1 for i, j in enumerate(mates)
    ]


def _cost_with_mate(
    face: Face,
    problem: LayoutProblem,
    choices: tuple[Choice, ...],
    index: int,
    mate: int,
    given: list[Floats],
) -> Floats:
    """(R,) cost of every candidate of an element with its mirror image on the mirror image of it;
    inf where none is."""
    images = face.symmetry.partner[choices[index].anchors[:, 0]]
    anchors = choices[mate].anchors[:, 0]
    order = np.argsort(anchors, kind="stable")
    rows = order[np.minimum(np.searchsorted(anchors[order], images), len(anchors) - 1)]
    cost = (
        np.delete(given[index], mate, axis=0).sum(axis=0)
        + np.delete(given[mate], index, axis=0).sum(axis=0)[rows]
        + pair_costs(problem, index, mate, np.arange(len(images)), rows)
    )
    return np.where(anchors[rows] == images, cost, np.inf)


def _given_others(problem: LayoutProblem, labels: Indices, index: int) -> Floats:
    """(variables, R) cost of every candidate of one variable: with each of the others where it is,
    and in its own row by itself."""
    own = problem.variables[index].cost
    return np.stack(
        [
            own
            if other == index
            else pair_costs(problem, index, other, np.arange(len(own)), np.full(len(own), label))
            for other, label in enumerate(labels)
        ]
    )


def _neighbour(problem: LayoutProblem, labels: Indices, index: int) -> tuple[str, float]:
    handles = [
        variable.handles[label] for variable, label in zip(problem.variables, labels, strict=True)
    ]
    apart = {
        problem.variables[other].name: np.linalg.norm(
            handles[index][:, None] - positions[None], axis=2
        ).min()
        for other, positions in enumerate(handles)
        if other != index and problem.together[index, other]
    }
    nearest = min(apart, key=apart.__getitem__, default="")
    return nearest, apart.get(nearest, np.inf)


def _kept(face: Face, choice: Choice, label: int) -> float:
    reached = (
        (face.trajectories.motion_of(control), choice.sources[label, copy])
        for copy, controls in enumerate(choice.controls)
        for control in controls
    )
    return min(
        float(motion.arc_length[np.searchsorted(motion.points, point)] / motion.arc_length.max())
        for motion, point in reached
    )
