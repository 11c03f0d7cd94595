"""posed(): from a rig to its layout problem.

    Rig → Trajectories → Candidates → Groups → LayoutProblem

The order of these stages is known here and nowhere else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from usdrigui import animation
from usdrigui.errors import Issue, meant, refuse
from usdrigui.examples import Examples, precedent_of, with_fixed
from usdrigui.layout import additions as additions_stage
from usdrigui.layout import candidates as candidates_stage
from usdrigui.layout import groups as groups_stage
from usdrigui.layout import levels as levels_stage
from usdrigui.layout import posed_symmetry as symmetry_stage
from usdrigui.layout import problem as problem_stage
from usdrigui.layout import review as review_stage
from usdrigui.layout import trajectory as trajectory_stage
from usdrigui.layout import visibility as visibility_stage
from usdrigui.layout.terms import Context
from usdrigui.model import Candidates, Floats, Group, LayoutProblem, LeftOff, Rig
from usdrigui.pipeline.progress import Clock
from usdrigui.settings import Settings


@dataclass(frozen=True, eq=False)
class Posed:
    """A layout problem with everything needed to turn its solution into a layout."""

    context: Context
    candidates: Candidates
    groups: tuple[Group, ...]
    problem: LayoutProblem
    choices: tuple[problem_stage.Choice, ...]
    base_values: Floats
    """(controls,) the base pose."""

    @property
    def issues(self) -> tuple[Issue, ...]:
        """Findings about the rig and its controls."""
        return (*self.context.rig.issues, *self.context.trajectories.issues)

    @property
    def notes(self) -> tuple[LeftOff, ...]:
        """What the stages left off, and why."""
        return (*self.context.trajectories.left_off, *self.candidates.left_off)

    @property
    def twin_names(self) -> dict[str, str]:
        """Names of the controls that have a twin other than themselves, to its name."""
        controls = self.context.rig.controls
        twins = self.context.symmetry.twins
        return {
            control.name: controls[twin].name
            for control, twin in zip(controls, twins, strict=True)
            if twin >= 0 and controls[twin] is not control
        }


def posed(
    rig: Rig,
    settings: Settings,
    clock: Clock | None = None,
    cameras: Mapping[str, Floats] | None = None,
    examples: Examples | None = None,
) -> Posed:
    """The layout problem of one rig: every stage between reading and solving."""
    clock, examples = clock or Clock(), examples or Examples()
    view, camera = settings.candidates.view, (cameras or {}).get(rig.root)
    if view.startswith("/") and camera is None:
        raise refuse("CONFIG_VALUE", "candidates.view", f"there is no camera {view}")
    settings = with_fixed(examples, rig, settings)
    base_values = _base_values(rig, settings)
    with clock.stage("trajectories"):
        found = trajectory_stage.trajectories(rig, settings.trajectories, base_values)
    if not found.motions:
        raise refuse("CONTROLS_MISSING", rig.root, "none of its controls moves a point")
    standing = examples.standing(rig)
    if standing is not None:
        settings = additions_stage.as_drawn(standing, found, settings)
    with clock.stage("symmetry"):
        symmetry = symmetry_stage.symmetry_at_pose(rig, found, settings, base_values)
    settings = animation.heeded(rig, symmetry, settings, examples.clips)
    with clock.stage("candidates"):
        views = visibility_stage.find_views(
            rig,
            found,
            symmetry,
            view,
            settings.candidates.occlusion,
            camera,
        )
        precedent = precedent_of(examples, rig, found, settings)
        context = Context(rig, found, symmetry, views, settings, precedent, standing)
        if standing is not None:
            review_stage.refuse_stale(context, standing)
        candidates = additions_stage.of_new_controls(context, candidates_stage.candidates(context))
    with clock.stage("problem"):
        groups = levels_stage.levelled(context, groups_stage.find_groups(context, candidates))
        problem, choices = problem_stage.layout_problem(context, candidates, groups)
    return Posed(context, candidates, groups, problem, choices, base_values)


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
