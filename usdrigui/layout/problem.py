"""The layout problem: every element's candidates, their costs and their geometry (paper eq. 2 to 5).

Lengths are measured in units of the face (displacement in typical peak displacements, the overlap's
radius in handle widths), so that the same character in metres and in centimetres gets the same layout;
``objective.scene_units`` takes the paper's constants literally instead.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from usdrigui.layout.additions import standing_costs
from usdrigui.layout.candidates import anew, loosened
from usdrigui.layout.extensions import user_pairs
from usdrigui.layout.levels import of_parts
from usdrigui.layout.orbits import orbit_points
from usdrigui.layout.partial import refuse_impossible
from usdrigui.layout.precedent import leaving, stood_on_face
from usdrigui.layout.terms import Context, off_plane
from usdrigui.layout.tracks import arc_lengths, flattened, gains, lengths, paths, resampled
from usdrigui.model import (
    Candidates,
    CandidateSet,
    Floats,
    Group,
    Indices,
    LayoutProblem,
    Motion,
    Overlap,
    Record,
    Variable,
)
from usdrigui.overlap import own_costs
from usdrigui.surface import mean_edge_length, mesh_triangles

_COINCIDENT = 1e-9
"""Separation that forbids only a shared point, in face sizes."""


@dataclass(frozen=True, eq=False)
class Choice(Record):
    """What the labels of one variable mean: anchors and drawn points of every copy of the element."""

    group: int
    """Index into the groups."""
    controls: tuple[tuple[int, ...], ...]
    """(copies, members) indices into `Rig.controls`."""
    anchors: Indices
    """(R, copies) anchor points."""
    sources: Indices
    """(R, copies) points whose trajectories are drawn."""


def layout_problem(
    context: Context, candidates: Candidates, groups: tuple[Group, ...]
) -> tuple[LayoutProblem, tuple[Choice, ...]]:
    """The problem whose solution is the layout of all groups that may stand on the face, and for each of
    its variables what the labels mean."""
    overlap, separation = _constants(context)
    sets = {context.trajectories.motions[each.motion].control: each for each in candidates.sets}
    variables, choices = [], []
    for index, group in enumerate(groups):
        if group.beside:
            continue
        here, its = _of_part(context, sets, group) if group.part else (context, sets)
        variable, choice = _variable(here, its, index, group, overlap, separation)
        variables.append(variable)
        choices.append(choice)
    weight = context.settings.objective.displacement_weight
    problem = LayoutProblem(tuple(variables), overlap, separation, weight)
    refuse_impossible(context, groups, problem, tuple(choices))
    return replace(problem, extra=user_pairs(context, problem, tuple(choices))), tuple(choices)


def inner_context(context: Context) -> Context:
    """What holds for the sliders that controls have of their own under a coarse element."""
    precedent = replace(context.precedent, places=context.precedent.parts, parts={})
    return replace(context, settings=of_parts(context.settings), precedent=precedent)


def _of_part(context: Context, sets: dict[int, CandidateSet], group: Group) -> tuple[Context, dict[int, CandidateSet]]:
    inner = inner_context(context)
    return inner, {control: anew(inner, sets[control]) for copy in _copies(group) for control in copy}


def _constants(context: Context) -> tuple[Overlap, float]:
    """The overlap's constants and the separation in scene units."""
    settings = context.settings.objective
    trajectories = context.trajectories
    if settings.scene_units:
        corners = mesh_triangles(context.rig.meshes)
        radius = mean_edge_length(trajectories.base, corners, trajectories.places) * settings.overlap_radius
        sharpness = settings.overlap_sharpness
    else:
        radius = settings.overlap_radius * context.handle_width
        sharpness = settings.overlap_sharpness / radius
    reach = settings.overlap_reach * radius or np.inf
    overlap = Overlap(settings.overlap_max, radius, sharpness, reach, 1.0 - settings.displacement_weight)
    coincident = _COINCIDENT * trajectories.face_size
    return overlap, context.handle_width if settings.separation else coincident


def _variable(
    context: Context,
    sets: dict[int, CandidateSet],
    index: int,
    group: Group,
    overlap: Overlap,
    separation: float,
) -> tuple[Variable, Choice]:
    for choice_of in (sets, {c: loosened(context, sets[c]) for controls in _copies(group) for c in controls}):
        choice, cost, displacement = _labels(context, choice_of, index, group)
        samples, handles = _geometry(context, choice)
        cost = cost + own_costs(samples, handles, overlap, separation)
        cost += standing_costs(context, overlap, separation, samples, handles)
        kept = np.isfinite(cost)
        if kept.any():
            break
    choice = Choice(index, choice.controls, choice.anchors[kept], choice.sources[kept])
    stay, leave = leaving_costs(context, choice)
    settings = context.settings.objective
    stays = any(context.said[c].place in ("face", "proxy") or context.said[c].anchor for c in group.controls)
    beside = settings.beside_price * len(choice.controls) if settings.beside_allowed and not stays else np.inf
    variable = Variable(
        group.name,
        choice.anchors[:, 0],
        cost[kept] + stay,
        samples[kept],
        handles[kept],
        beside + leave,
        displacement[kept],
        group.states,
    )
    return variable, choice


def leaving_costs(context: Context, choice: Choice) -> tuple[Floats, float]:
    """What an earlier layout makes each label cost (R,), and what it makes the place beside the face cost."""
    precedent, base, width = context.precedent, context.trajectories.base, context.handle_width
    stay, leave = np.zeros(len(choice.anchors)), 0.0
    for copy, controls in enumerate(choice.controls):
        stay += leaving(precedent, controls, choice.anchors[:, copy], base, width)
        leave += precedent.price * stood_on_face(precedent, controls)
    return stay, leave


def _copies(group: Group) -> tuple[tuple[int, ...], ...]:
    return (group.controls, *group.images)


def _labels(context: Context, sets: dict[int, CandidateSet], index: int, group: Group) -> tuple[Choice, Floats, Floats]:
    """Candidates that all members and all copies share, their costs without the overlap, and displacements.

    Displacement and linear costs are those of the worst member (paper section 3.3), summed over copies.
    """
    first = sets[group.controls[0]]
    choice = _with_copies(context, group, index, first.points, first.sources)
    weight = context.settings.objective.displacement_weight
    cost, displacement = np.zeros(len(choice.anchors)), np.zeros(len(choice.anchors))
    for copy, controls in enumerate(choice.controls):
        worst, least = np.full(len(cost), -np.inf), np.full(len(cost), np.inf)
        worth = weight * _importance(context, controls)
        for control in controls:
            motion = context.trajectories.motions[sets[control].motion]
            reach = _displacements(context, motion, choice.sources[:, copy]) / _unit(context, motion)
            linear = _looked_up(sets[control], choice.anchors[:, copy])
            worst = np.maximum(worst, np.where(reach > 0.0, linear - worth * reach, np.inf))
            least = np.minimum(least, reach)
        cost += worst
        displacement += least
    if own_mirror_image(context, group):
        away = off_plane(context, choice.anchors[:, 0])
        cost += away - away.min(initial=np.inf) if len(away) else away
    return choice, cost, displacement


def _importance(context: Context, controls: tuple[int, ...]) -> float:
    """Of an element: that of its most important control."""
    found = (context.said[control].importance for control in controls)
    return max(1.0 if each is None else each for each in found)


def _displacements(context: Context, motion: Motion, sources: Indices) -> Floats:
    """(R,) arc lengths of the trajectories; in a flat layout as the viewer sees them, which penalises
    foreshortened ones (paper section 3.3 and fig. 7)."""
    if context.settings.candidates.space == "object":
        return arc_lengths(motion, sources)
    return lengths(flattened(paths(motion, sources), context.views.directions[0]))


def _unit(context: Context, motion: Motion) -> float:
    """Length that counts as a displacement of one: between the rig's typical peak and the control's own."""
    settings = context.settings.objective
    if settings.scene_units:
        return 1.0
    own = float(motion.arc_length.max())
    share = settings.relative_displacement
    return float(context.trajectories.typical_length ** (1.0 - share) * own**share)


def own_mirror_image(context: Context, group: Group) -> bool:
    """Whether the element is its own mirror image."""
    if not context.symmetry.normal.any() or context.settings.symmetry.double_middle:
        return False
    return {int(context.symmetry.twins[control]) for control in group.controls} == set(group.controls)


def _looked_up(candidate_set: CandidateSet, points: Indices) -> Floats:
    """Linear costs at `points`; inf where the point is no candidate of this control."""
    rows = np.minimum(np.searchsorted(candidate_set.points, points), len(candidate_set.points) - 1)
    return np.where(candidate_set.points[rows] == points, candidate_set.cost[rows], np.inf)


def _with_copies(context: Context, group: Group, index: int, points: Indices, sources: Indices) -> Choice:
    """Anchors and sources of all copies, of those candidates whose images lie on the character."""
    anchors, drawn = (_images(context, group, each) for each in (points, sources))
    kept = (anchors >= 0).all(axis=1) & (drawn >= 0).all(axis=1)
    return Choice(index, _copies(group), anchors[kept], drawn[kept])


def _images(context: Context, group: Group, points: Indices) -> Indices:
    """(R, copies) images of `points` under the symmetry of the group."""
    if not group.images:
        return points[:, None]
    if group.mirror:
        return np.stack([points, context.symmetry.partner[points]], axis=1)
    motions = {motion.control: i for i, motion in enumerate(context.trajectories.motions)}
    orbit = tuple(motions[controls[0]] for controls in _copies(group))
    return orbit_points(context, orbit, points)


def _geometry(context: Context, choice: Choice) -> tuple[Floats, Floats]:
    """Samples (R, copies, u, 3) along the drawn tracks, and handles (R, copies, 3)."""
    base = context.trajectories.base
    samples = [
        np.concatenate(
            [drawn_track(context, control, choice.anchors[:, copy], choice.sources[:, copy]) for control in controls],
            axis=1,
        )
        for copy, controls in enumerate(choice.controls)
    ]
    stacked, handles = np.stack(samples, axis=1), base[choice.anchors]
    if context.settings.candidates.space == "object":
        return stacked, handles
    toward = context.views.directions[0]
    return flattened(stacked, toward), flattened(handles, toward)


def drawn_track(context: Context, control: int, anchors: Indices, sources: Indices) -> Floats:
    """(R, u, 3) the drawn track of a control at each anchor: its trajectory, enlarged where it is too short."""
    motion = context.trajectories.motion_of(control)
    least = context.settings.output.min_track * context.handle_width
    factor = gains(arc_lengths(motion, sources), least)
    offsets = resampled(paths(motion, sources), context.settings.objective.samples)
    return np.asarray(context.trajectories.base[anchors][:, None] + factor[:, None, None] * offsets)
