"""How good a layout is, and whether it still fits its rig: for layers from any tool, or from any hand.

`review` compares a `Layout` with the rig as it is today and rates every element by the objective that
would place it (paper section 1: layouts also validate manual design choices).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from usdrigui.errors import Issue, issue, refuse
from usdrigui.layout.problem import Choice, layout_problem
from usdrigui.layout.terms import Context, linear_cost
from usdrigui.levels import inner_names, states
from usdrigui.model import Candidates, CandidateSet, Element, Floats, Group, Indices, Layout, LayoutProblem, Rig
from usdrigui.overlap import pair_costs, total_cost

_MOVED = 1e-4
"""An anchor is out of place when it is further off than this share of the face size."""
_TOUCHING = 1e-6
"""Handles may be nearer than the separation by this share of it: layers hold single precision."""
_WORTH = 0.05
"""A better place is worth naming when it saves this much of what the typical control's displacement is worth."""


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
    """What moving it to its best place would save, all others staying; a pair moves as one.  0 when it stands there."""
    better: str
    """That place as ``MESH_PATH#POINT``, ready for a configuration; empty when it stands there."""


@dataclass(frozen=True, eq=False)
class Review:
    """What `review` found."""

    issues: tuple[Issue, ...]
    elements: tuple[ElementReview, ...]
    cost: float
    """Objective of the elements on the face as they stand; inf if two handles are too near."""


def review(context: Context, candidates: Candidates, layout: Layout) -> Review:
    """Rate `layout` on the rig of `context`; faults come first, and what is faulty is not rated."""
    faults = [*_stale(context, layout), *_unplaced(context, layout), *_crowded(context, layout)]
    sound = _sound(context, layout)
    issues = [*faults, *_hidden(context, sound)]
    problem, choices, labels = _as_problem(context, candidates, layout, sound)
    mates = _mates(context, layout, problem, choices, labels)
    rated = tuple(_rated(context, problem, choices, labels, index, mates[index]) for index in range(len(choices)))
    issues += [
        issue("LAYOUT_BETTER_PLACE", each.element, f"would gain {each.gain:.2f} at {each.better}")
        for each in rated
        if each.gain > _WORTH
    ]
    return Review(tuple(issues), rated, total_cost(problem, labels) if choices else 0.0)


def refuse_stale(context: Context, layout: Layout) -> None:
    """Raise the first error for which a layout does not fit the rig any more (LAYOUT_...)."""
    for found in _stale(context, layout):
        if found.severity == "error":
            raise refuse(found.code, found.path, found.message)


# --- does it fit the rig -----------------------------------------------------------------------------


def _stale(context: Context, layout: Layout) -> Iterator[Issue]:
    rig = context.rig
    meshes = {mesh.path: mesh for mesh in rig.meshes}
    known = {control.name for control in rig.controls}
    for element in layout.elements:
        anchor = element.anchor
        mesh = meshes.get(anchor.mesh)
        if mesh is None:
            yield issue("LAYOUT_MESH_GONE", element.name, f"is anchored to {anchor.mesh or 'no mesh'}")
        elif anchor.topology_hash and anchor.topology_hash != mesh.topology_hash:
            change = f"{anchor.point_count} points then, {len(mesh.points)} now"
            yield issue("LAYOUT_TOPOLOGY", element.name, f"{anchor.mesh} has other points or faces: {change}")
        elif not 0 <= anchor.point < len(mesh.points):
            yield issue("LAYOUT_TOPOLOGY", element.name, f"{anchor.mesh} has no point {anchor.point}")
        elif not anchor.beside and _off(context, layout, element) > _MOVED:
            off = f"{_off(context, layout, element):.1%} of the face"
            yield issue("LAYOUT_ANCHOR_MOVED", element.name, f"its point lies {off} from where it was")
        for member in element.members:
            if member.control not in known:
                yield issue("LAYOUT_CONTROL_GONE", element.name, f"{rig.root} has no control {member.control!r}")


def _off(context: Context, layout: Layout, element: Element) -> float:
    """Distance between the anchor as recorded and as it is, over the face size."""
    if _custom_base(context, layout):
        return 0.0
    here = context.trajectories.base[_point(context.rig, element)]
    return float(np.linalg.norm(here - element.anchor.position)) / context.trajectories.face_size


def _custom_base(context: Context, layout: Layout) -> bool:
    """Whether the layout was solved at a pose other than the context's, so that positions cannot be compared."""
    values = context.settings.read.pose
    return bool(values) or context.settings.read.time is not None or not np.allclose(layout.base_values, 0.0)


def _unplaced(context: Context, layout: Layout) -> Iterator[Issue]:
    laid = {member.control for element in layout.elements for member in element.members}
    laid |= {left.control for left in layout.left_off}
    for motion in context.trajectories.motions:
        name = context.rig.controls[motion.control].name
        if name not in laid and not context.said[motion.control].exclude:
            yield issue("LAYOUT_CONTROL_NEW", name, "has no element and is not said to be left off")


def _crowded(context: Context, layout: Layout) -> Iterator[Issue]:
    least = layout.handle_width or context.handle_width
    placed = [element for element in layout.elements if not element.anchor.beside]
    if len(placed) < 2:
        return
    seen = states(layout.elements)
    spots = np.array([element.anchor.position for element in placed])
    apart = np.linalg.norm(spots[:, None] - spots[None], axis=2)
    for a, b in np.argwhere(np.triu(apart < least * (1.0 - _TOUCHING), 1)):
        if not seen[placed[a].name] & seen[placed[b].name]:
            continue
        between = f"{apart[a, b] / least:.2f} handle widths from {placed[b].name}"
        yield issue("LAYOUT_HANDLES_COLLIDE", placed[a].name, f"its handle is {between}")


def _hidden(context: Context, elements: tuple[Element, ...]) -> Iterator[Issue]:
    seen = context.views.anywhere
    for element in elements:
        if not seen[_point(context.rig, element)]:
            yield issue("LAYOUT_ANCHOR_HIDDEN", element.name, "no view shows its anchor")


# --- how good it is ----------------------------------------------------------------------------------


def _sound(context: Context, layout: Layout) -> tuple[Element, ...]:
    """The elements on the face that can be rated: mesh, point and controls exist and the controls move it."""
    rig = context.rig
    moving = {rig.controls[motion.control].name for motion in context.trajectories.motions}
    meshes = {mesh.path: len(mesh.points) for mesh in rig.meshes}
    return tuple(
        element
        for element in layout.elements
        if not element.anchor.beside
        and 0 <= element.anchor.point < meshes.get(element.anchor.mesh, 0)
        and all(member.control in moving for member in element.members)
    )


def _as_problem(
    context: Context, candidates: Candidates, layout: Layout, elements: tuple[Element, ...]
) -> tuple[LayoutProblem, tuple[Choice, ...], Indices]:
    """The problem in which every element is one variable, its own anchor among the candidates."""
    index = {control.name: number for number, control in enumerate(context.rig.controls)}
    seen, parts = states(layout.elements), _parts(layout)
    groups = tuple(
        Group(
            element.name,
            element.kind,
            tuple(index[member.control] for member in element.members),
            element.opposed,
            (),
            "",
            part=element.name in parts,
            states=seen[element.name],
        )
        for element in elements
    )
    points = [_point(context.rig, element) for element in elements]
    sets = _with_points(context, candidates, groups, points)
    problem, choices = layout_problem(context, sets, groups)
    labels, kept = [], []
    for number, choice in enumerate(choices):
        at = np.flatnonzero(choice.anchors[:, 0] == points[choice.group])
        if len(at):
            labels.append(int(at[0]))
            kept.append(number)
    variables = tuple(problem.variables[number] for number in kept)
    return (
        replace(problem, variables=variables, separation=min(problem.separation, _least(context)), extra=()),
        tuple(choices[number] for number in kept),
        np.array(labels, dtype=np.int64),
    )


def _parts(layout: Layout) -> frozenset[str]:
    """Names of the elements all of whose controls a coarse element holds too."""
    inner = inner_names(layout.elements)
    outer = {m.control for element in layout.elements if element.name not in inner for m in element.members}
    return frozenset(e.name for e in layout.elements if e.name in inner and outer >= {m.control for m in e.members})


def _least(context: Context) -> float:
    return context.handle_width * (1.0 - _TOUCHING)


def _with_points(context: Context, candidates: Candidates, groups: tuple[Group, ...], points: list[int]) -> Candidates:
    """The candidates with the anchors of the layout among them, whatever the pruning thought of them."""
    motions = context.trajectories.motions
    sets = {motions[each.motion].control: each for each in candidates.sets}
    for group, point in zip(groups, points, strict=True):
        for control in group.controls:
            if control in sets and point in motions[sets[control].motion].points:
                sets[control] = _with_point(context, sets[control], point)
    return Candidates(tuple(sets.values()), candidates.left_off)


def _with_point(context: Context, known: CandidateSet, point: int) -> CandidateSet:
    if point in known.points:
        return known
    motion = context.trajectories.motions[known.motion]
    at = int(np.searchsorted(known.points, point))
    cost = linear_cost(context, motion, np.array([point]))
    return replace(
        known,
        points=np.insert(known.points, at, point),
        cost=np.insert(known.cost, at, cost[0]),
        sources=np.insert(known.sources, at, point),
    )


def _mates(
    context: Context, layout: Layout, problem: LayoutProblem, choices: tuple[Choice, ...], labels: Indices
) -> list[int]:
    """For every element the other one of its pair, where the two stand as mirror images; else -1."""
    mirror = {element.name: element.mirror for element in layout.elements}
    index = {variable.name: i for i, variable in enumerate(problem.variables)}
    at = [int(choice.anchors[label, 0]) for choice, label in zip(choices, labels, strict=True)]
    mates = [index.get(mirror[variable.name], -1) for variable in problem.variables]
    return [j if j >= 0 and context.symmetry.partner[at[i]] == at[j] else -1 for i, j in enumerate(mates)]


def _cost_with_mate(
    context: Context, problem: LayoutProblem, choices: tuple[Choice, ...], labels: Indices, index: int, mate: int
) -> Floats:
    """(R,) cost of every candidate of an element with its mirror image on the mirror image of it; inf where none is."""
    images = context.symmetry.partner[choices[index].anchors[:, 0]]
    anchors = choices[mate].anchors[:, 0]
    order = np.argsort(anchors, kind="stable")
    rows = order[np.minimum(np.searchsorted(anchors[order], images), len(anchors) - 1)]
    cost = cost_given_others(problem, labels, index, mate) + cost_given_others(problem, labels, mate, index)[rows]
    cost += pair_costs(problem, index, mate, np.arange(len(images)), rows)
    return np.where(anchors[rows] == images, cost, np.inf)


def _rated(
    context: Context, problem: LayoutProblem, choices: tuple[Choice, ...], labels: Indices, index: int, mate: int
) -> ElementReview:
    variable, choice, label = problem.variables[index], choices[index], int(labels[index])
    alone = cost_given_others(problem, labels, index)
    whole = _cost_with_mate(context, problem, choices, labels, index, mate) if mate >= 0 else alone
    best = int(np.argmin(whole))
    gain = float(whole[label] - whole[best]) if np.isfinite(whole[label]) else np.inf
    nearest, distance = _neighbour(problem, labels, index)
    return ElementReview(
        element=variable.name,
        kept=_kept(context, choice, label),
        linear=float(variable.cost[label]),
        overlap=float(alone[label] - variable.cost[label]),
        nearest=nearest,
        distance=distance / context.handle_width,
        gain=max(0.0, gain),
        better=_place(context.rig, int(choice.anchors[best, 0])) if gain > 0.0 else "",
    )


def cost_given_others(problem: LayoutProblem, labels: Indices, index: int, without: int = -1) -> Floats:
    """(R,) cost of every candidate of one variable, all others but `without` staying where they are."""
    count = len(problem.variables[index].points)
    mine = np.arange(count)
    cost = problem.variables[index].cost.copy()
    for other in range(len(labels)):
        if other not in (index, without):
            cost += pair_costs(problem, index, other, mine, np.full(count, labels[other]))
    return cost


def _neighbour(problem: LayoutProblem, labels: Indices, index: int) -> tuple[str, float]:
    handles = [variable.handles[label] for variable, label in zip(problem.variables, labels, strict=True)]
    nearest, distance = "", np.inf
    for other, spots in enumerate(handles):
        if other != index and problem.together[index, other]:
            apart = float(np.linalg.norm(handles[index][:, None] - spots[None], axis=2).min())
            if apart < distance:
                nearest, distance = problem.variables[other].name, apart
    return nearest, distance


def _kept(context: Context, choice: Choice, label: int) -> float:
    shares = []
    for copy, controls in enumerate(choice.controls):
        for control in controls:
            motion = context.trajectories.motion_of(control)
            row = int(np.searchsorted(motion.points, choice.sources[label, copy]))
            shares.append(float(motion.arc_length[row] / motion.arc_length.max()))
    return min(shares)


def _place(rig: Rig, point: int) -> str:
    mesh, local = rig.mesh_of(point)
    return f"{rig.meshes[mesh].path}#{local}"


def _point(rig: Rig, element: Element) -> int:
    """The anchor as an index into all points of the rig."""
    paths = [mesh.path for mesh in rig.meshes]
    return int(rig.starts[paths.index(element.anchor.mesh)]) + element.anchor.point
