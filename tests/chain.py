"""The layout line from a `Rig` to a `Layout`, without USD and without files."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from usdrigui.layout.candidates import candidates
from usdrigui.layout.elements import layout
from usdrigui.layout.groups import find_groups
from usdrigui.layout.levels import levelled
from usdrigui.layout.posed_symmetry import symmetry_at_pose
from usdrigui.layout.precedent import NONE
from usdrigui.layout.problem import layout_problem
from usdrigui.layout.terms import Context
from usdrigui.layout.trajectory import trajectories
from usdrigui.layout.visibility import find_views
from usdrigui.settings import Settings, load
from usdrigui.solve import solve


@dataclass(frozen=True)
class Line:
    """Every record of one run."""

    context: Any
    candidates: Any
    groups: Any
    problem: Any
    choices: Any
    assignment: Any = None
    layout: Any = None


def context_of(rig, settings=None, base_values=None, camera=None):
    settings = settings or Settings()
    found = trajectories(rig, settings.trajectories, base_values)
    symmetry = symmetry_at_pose(rig, found, settings, base_values)
    views = find_views(rig, found, symmetry, settings.candidates.view, settings.candidates.occlusion, camera)
    return Context(rig, found, symmetry, views, settings)


def posed(rig, settings=None, base_values=None, precedent=NONE):
    """Up to the problem."""
    context = replace(context_of(rig, settings, base_values), precedent=precedent)
    chosen = candidates(context)
    groups = levelled(context, find_groups(context, chosen))
    problem, choices = layout_problem(context, chosen, groups)
    return Line(context, chosen, groups, problem, choices)


def lay_out(rig, settings=None, base_values=None, precedent=NONE):
    """All the way, solved to optimality."""
    settings = settings or Settings()
    line = posed(rig, settings, base_values, precedent)
    solving = replace(settings.solve, gap=1e-9, threads=1)
    assignment = solve(line.problem, solving)
    made = layout(line.context, line.candidates, line.groups, line.problem, line.choices, assignment, base_values)
    return replace(line, assignment=assignment, layout=made)


def settings(**parts):
    """Settings from nested keyword arguments, one per part."""
    return load(parts)


def by_name(line):
    return {element.name: element for element in line.layout.elements}


def set_of(line, name):
    """The candidate set of a control."""
    names = [control.name for control in line.context.rig.controls]
    motions = line.context.trajectories.motions
    return next(each for each in line.candidates.sets if names[motions[each.motion].control] == name)
