"""The layout line from a `Rig` to a `Layout`, without USD and without files."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.layout.place.candidates import find_candidates
from usdrigui.layout.place.terms import LinearTerms
from usdrigui.layout.reuse.prior_layout import NO_PRIOR
from usdrigui.pipeline.progress import Clock
from usdrigui.pipeline.stages import LaidPart, References, divided, layout_of, measure, part_problem, problem_at
from usdrigui.settings import Settings, load
from usdrigui.solve import solve


@dataclass(frozen=True)
class Placing:
    """A run up to the candidates."""

    face: Any
    candidates: Any


@dataclass(frozen=True)
class Line:
    """Every record of one run."""

    inputs: Any
    assignment: Any = None
    layout: Any = None

    @property
    def face(self):
        return self.inputs.face

    @property
    def candidates(self):
        return self.inputs.candidates

    @property
    def groups(self):
        return self.inputs.placement.groups

    @property
    def problem(self):
        return self.inputs.placement.problem

    @property
    def choices(self):
        return self.inputs.placement.choices

    @property
    def grouping(self):
        """What the stage of groups reads, but for what the configuration says of controls."""
        inputs = self.inputs
        groups, symmetry = inputs.settings.layout.groups, inputs.settings.character.symmetry
        return self.face, self.candidates, inputs.similarity, inputs.requests, groups, symmetry


def problem_of(rig, settings=None, base_values=None, prior=NO_PRIOR):
    """Up to the problem."""
    return Line(problem_at(*_start(rig, settings or Settings(), base_values), References(prior)))


def measured(rig, settings=None, base_values=None, camera=None):
    """Up to the classification."""
    return measure(*_start(rig, settings or Settings(), base_values), References(), Clock(), camera)


def face_of(rig, settings=None, base_values=None, camera=None):
    """The face as measured."""
    return measured(rig, settings, base_values, camera).face


def with_candidates(rig, settings=None):
    """A face and the candidates on it."""
    settings = settings or Settings()
    found = measured(rig, settings)
    return Line(
        Placing(
            found.face,
            find_candidates(
                found.face,
                found.classification,
                found.requests,
                settings.layout.candidates,
                LinearTerms.of(settings.layout),
                settings.layout.objective.samples,
            ),
        )
    )


def _start(rig, settings, base_values):
    values = np.array([each.default for each in rig.controls]) if base_values is None else base_values
    return rig, trajectories(rig, settings.character.trajectories, values), settings, values


def lay_out(rig, settings=None, base_values=None, prior=NO_PRIOR):
    """All the way, solved to optimality."""
    line = problem_of(rig, settings, base_values, prior)
    return solved(line, replace(line.inputs.settings.layout.solve, gap=1e-9))


def solved(line, settings):
    """The line with its problem solved by these settings of the solver."""
    assignment = solve(line.problem, settings)
    return replace(line, assignment=assignment, layout=layout_of(line.inputs, assignment))


def laid_parts(rig):
    """Every part of a rig, laid out one after the other."""
    character, laid = divided(rig, Settings()), []
    for part in character.parts:
        inputs = part_problem(character, part, [element for each in laid for element in each.layout.elements])
        found = solve(inputs.placement.problem, inputs.settings.layout.solve)
        laid.append(LaidPart(inputs, layout_of(inputs, found), found))
    return laid


def settings(**sections):
    """Settings from nested keyword arguments, one per section."""
    return load(sections)


def by_name(line):
    return {element.name: element for element in line.layout.elements}


def set_of(line, name):
    """The candidate set of a control."""
    names = [control.name for control in line.face.rig.controls]
    motions = line.face.trajectories.motions
    return next(each for each in line.candidates.sets if names[motions[each.motion].control] == name)


def chosen(rig, **parts):
    """The candidates of a control by its name, under settings of these `parts`."""
    found = with_candidates(rig, settings(**parts))
    return lambda name: set_of(found, name)
