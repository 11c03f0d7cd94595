"""The layout line from a `Rig` to a `Layout`, without USD and without files."""

from __future__ import annotations

from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

from scipy.spatial.distance import pdist

from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.layout.place.candidates import find_candidates
from usdrigui.layout.reuse.carrying import Today
from usdrigui.layout.reuse.prior_layout import NO_PRIOR, prior_of_previous
from usdrigui.pipeline import stages
from usdrigui.pipeline.records import LaidPart
from usdrigui.pipeline.reference_layouts import ReferenceLayouts
from usdrigui.settings import PartSettings, Settings, load
from usdrigui.solve import solve


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
        """What the stage of groups reads."""
        return self.inputs.measured, self.candidates


def problem_of(rig, settings=None, base_values=None, prior=NO_PRIOR, fixed=None):
    """Up to the problem; like a `prior` layout, with all that a `fixed` one has where it has it."""
    whole = _character(rig, settings, base_values, fixed)
    part = whole.parts[0] if prior is NO_PRIOR else replace(whole.parts[0], prior=prior)
    return Line(stages.part_problem(whole, part))


def with_motions(rig):
    """A rig and its trajectories."""
    return rig, trajectories(rig, Settings().trajectories)


def today(rig):
    """A rig as it moves today."""
    _, found = with_motions(rig)
    return Today(rig, found.surface.points, found)


def prior(layout, rig, penalty):
    """An earlier layout of a rig, or of one like it, as a prior."""
    return prior_of_previous(layout, today(rig), penalty)


def measured(rig, settings=None, base_values=None):
    """Up to the classification."""
    whole = _character(rig, settings, base_values)
    return stages.measured(whole, whole.parts[0], ())


def face_of(rig, settings=None, base_values=None):
    """The face as measured."""
    return measured(rig, settings, base_values).face


def with_candidates(rig, settings=None):
    """A face and the candidates on it."""
    known = measured(rig, settings)
    return Line(SimpleNamespace(face=known.face, candidates=find_candidates(known)))


def _character(rig, settings, base_values, fixed=None):
    """A rig as one part, at a base pose."""
    references = ReferenceLayouts(fixed={} if fixed is None else {rig.path: fixed})
    settings = settings or Settings()
    if base_values is not None:
        pose = {each.name: float(value) for each, value in zip(rig.controls, base_values, strict=True)}
        settings = replace(settings, read=replace(settings.read, pose=pose))
    return stages.character_of(rig, replace(settings, parts=PartSettings(divide=False)), references)


def lay_out(rig, settings=None, base_values=None, prior=NO_PRIOR, fixed=None):
    """All the way, solved to optimality."""
    line = problem_of(rig, settings, base_values, prior, fixed)
    return solved(line, replace(line.inputs.settings.solve, gap=1e-9))


def solved(line, settings):
    """The line with its problem solved by these settings of the solver."""
    assignment = solve(line.problem, settings)
    return replace(line, assignment=assignment, layout=stages.layout_of(line.inputs, assignment))


def laid_parts(rig):
    """Every part of a rig, laid out one after the other."""
    character, laid = stages.character_of(rig, Settings()), []
    for part in character.parts:
        inputs = stages.part_problem(character, part, [element for each in laid for element in each.layout.elements])
        found = solve(inputs.placement.problem, inputs.settings.solve)
        laid.append(LaidPart(inputs, stages.layout_of(inputs, found), found))
    return laid


def settings(**sections):
    """Settings from nested keyword arguments, one per section."""
    return load(sections)


def least_apart(elements):
    """The least distance of two anchors."""
    return pdist([element.anchor.position for element in elements]).min()


def by_name(line):
    return {element.name: element for element in line.layout.elements}


def set_of(line, name):
    """The candidate set of a control."""
    return line.candidates.sets[line.face.rig.control_indices[name]]


def chosen(rig, **parts):
    """The candidates of a control by its name and what is said of it, under settings of these `parts`."""
    known = measured(rig, settings(**parts))
    controls = (motion.control for motion in known.face.trajectories.motions)
    said, sets = dict(zip(controls, known.classification, strict=True)), find_candidates(known).sets
    return lambda name: SimpleNamespace(**vars(said[i := rig.control_indices[name]]), **vars(sets[i]))
