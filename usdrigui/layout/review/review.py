"""How good a layout is, and whether it still fits its rig: for layers from any tool, or from any
hand.

`review` compares a `Layout` with the rig as it is today and rates every element by the objective
that would place it (paper section 1: layouts also validate manual design choices).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from usdrigui.character import Body, Control, Drive, Floats, Indices, Rig, RigMesh
from usdrigui.errors import (
    Faults,
    Issue,
    RigUIError,
    by_cause,
    catalogue,
    issue,
    listed,
    of_character,
)
from usdrigui.layout.face import Face
from usdrigui.layout.measured import Measured
from usdrigui.layout.place.problem import off_face_cost, placement_problem
from usdrigui.layout.place.terms import LinearTerms, linear_cost
from usdrigui.layout.reuse.identity import match_layout
from usdrigui.layout.reuse.partial_layout import place_of
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.review.legibility import legibility_of
from usdrigui.model import (
    Anchor,
    BaseSurface,
    Candidates,
    CandidateSet,
    Choice,
    Element,
    Group,
    Layout,
    LayoutProblem,
    Legibility,
    Trajectories,
)
from usdrigui.model.levels import inner_names, states
from usdrigui.overlap import pair_costs, total_cost
from usdrigui.settings import ReadSettings

_MOVED = 1e-4
"""An anchor is out of place when it is further off than this share of the face size."""
_TOUCHING = 1e-6
"""Handles may be nearer than the separation by this share of it: layers hold single precision."""
_WORTH = 0.05
"""A better place is worth naming when it saves this much of what the typical control's displacement
is worth."""


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
    improvement: float
    """What moving it to its best place would save, all others staying; a pair moves as one.  0 when
    it is there."""
    better: str
    """That place as ``MESH_PATH#POINT``, ready for a configuration; empty when it is there."""


@dataclass(frozen=True, eq=False)
class Review:
    """What `review` found."""

    issues: tuple[Issue, ...]
    elements: tuple[ElementReview, ...]
    cost: float
    """Objective of the elements on the face at their places; inf if two handles are too near."""
    legibility: Legibility


@dataclass(frozen=True, eq=False)
class Whole:
    """The layout of the character, of which a part is reviewed."""

    layout: Layout
    listed: frozenset[str] = frozenset()
    """The names of the controls that its author knew, with and without an element; empty where
    unknown."""


def review(
    known: Measured, candidates: Candidates, layout: Layout, whole: Whole | None = None
) -> Review:
    """Rate `layout` on the rig that was measured; faults come first, and what is faulty is not
    rated.  `whole` where it is not the layout of all of the character."""
    face, whole = known.face, whole or Whole(layout)
    faults = [
        *_stale(face.rig, face.trajectories, (layout, whole.layout), known.settings.rig.read),
        *_unplaced(face, layout, known.requests, whole.listed),
        *_crowded(layout.elements, layout.frame.handle_width or face.handle_width),
    ]
    sound = _sound(face, layout.elements)
    pinned = {element.name for element in layout.elements if "anchor" in element.placement.pinned}
    issues = [*faults, *_hidden(face, tuple(each for each in sound if each.name not in pinned))]
    problem, choices, labels = _as_problem(known, candidates, layout.elements, sound)
    mates = _mates(face, layout.elements, problem, choices, labels)
    rated = tuple(
        _rated(face, problem, choices, labels, index, mates[index]) for index in range(len(choices))
    )
    issues += [
        issue(
            "LAYOUT_BETTER_PLACE",
            each.element,
            f"would save {each.improvement:.2f} at {each.better}",
        )
        for each in rated
        if each.improvement > _WORTH and each.element not in pinned
    ]
    read = legibility_of(face, layout.elements)
    issues += [issue("LAYOUT_UNCLEAR", name, why) for name, why in read.unclear]
    cost = total_cost(problem, labels) + _off_face(known, candidates, layout.elements)
    return Review(tuple(issues), rated, cost, read)


def layout_cost(known: Measured, candidates: Candidates, elements: tuple[Element, ...]) -> float:
    """The objective of a layout by its places alone, whatever it was made from: the one that
    `review` gives; nan where an element cannot be rated."""
    sound = _sound(known.face, elements)
    problem, choices, labels = _as_problem(known, candidates, elements, sound)
    placed = sum(not element.anchor.on_board for element in elements)
    if len(choices) < placed:
        return float("nan")
    return total_cost(problem, labels) + _off_face(known, candidates, elements)


def _off_face(known: Measured, candidates: Candidates, elements: tuple[Element, ...]) -> float:
    """What the elements on the board cost that could stand on the face."""
    face, requests = known.face, known.requests
    motions = face.trajectories.motions
    able = {
        face.control_name(motions[each.motion].control)
        for each in candidates.sets
        if not each.category
    }
    inner = inner_names(elements)
    away = tuple(
        element
        for element in elements
        if element.anchor.on_board
        and element.name not in inner
        and able >= element.manipulator.controls
    )
    objective = known.settings.layout.objective
    groups = _as_groups(face.rig.controls, elements, away)
    return sum(off_face_cost(face, group, requests, objective) for group in groups)


def not_animated(rig: Rig, layout: Layout) -> Iterator[Issue]:
    """LAYOUT_NOT_ANIMATED for each element with controls that nothing moves, as no SkelAnimation
    that is bound has their weights or joints; one for the character where it has none at all."""
    still = {control.name for control in rig.controls if not _animated(rig.body, control.drive)}
    if still and len(still) == len(rig.controls):
        where = layout.character.root
        what = f"no SkelAnimation that is bound has any of its {len(still)} controls"
        yield issue("LAYOUT_NOT_ANIMATED", where, what)
        return
    for element in layout.elements:
        if names := sorted(element.manipulator.controls & still):
            what = f"no SkelAnimation that is bound has {listed(names)}"
            yield issue("LAYOUT_NOT_ANIMATED", element.name, what)


def _animated(body: Body, drive: Drive) -> bool:
    animations = [body.channels[index].animation for index in drive.channels]
    joints = [body.joints[index] for index in drive.joints]
    return all([*animations, *(body.skeletons[joint.skeleton].animation for joint in joints)])


def joined(parts: Sequence[Review]) -> Review:
    """What was found of all parts of a character."""
    return Review(
        tuple(dict.fromkeys(found for each in parts for found in each.issues)),
        tuple(element for each in parts for element in each.elements),
        sum(each.cost for each in parts),
        sum((each.legibility for each in parts), Legibility(0, ())),
    )


def refuse_stale(
    rig: Rig, trajectories: Trajectories, layout: Layout, settings: ReadSettings
) -> None:
    """Raise every error for which a layout does not fit the rig any more (LAYOUT_...), by cause."""
    faults = Faults()
    stale = of_character(
        rig.skel_root.path_in_variants, _stale(rig, trajectories, (layout, layout), settings)
    )
    for found in by_cause(stale):
        with faults.collected():
            if found.severity == "error":
                raise RigUIError(found, catalogue()[found.code].exit)
    faults.raise_all()


# --- does it fit the rig --------------------------------------------------------------------------


def _stale(
    rig: Rig, trajectories: Trajectories, layouts: tuple[Layout, Layout], settings: ReadSettings
) -> Iterator[Issue]:
    """Why a layout, and with it the whole of which it is a part, does not fit the rig any more."""
    layout, whole = layouts
    comparable = not _custom_base(layout.character.base_values, settings)
    meshes = {mesh.path: mesh for mesh in rig.body.meshes}
    known = rig.control_names
    lacking = not known.issuperset(layout.controls)
    renamed = match_layout(layout, rig, trajectories).renamed if lacking else {}
    anchored = dict.fromkeys(element.anchor.mesh for element in whole.elements)
    lost = [path for path in anchored if path not in meshes]
    for path in lost:
        yield whole.mesh_gone(path, len(whole.controls - known))
    # Controls go with the mesh that has their shapes; a renamed one has its own issue.
    along = layout.controls - renamed.keys() if lost else frozenset[str]()
    for element in layout.elements:
        mesh = meshes.get(element.anchor.mesh)
        if mesh is not None:
            yield from _anchor_faults(
                rig.body, trajectories.surface, element, mesh, comparable=comparable
            )
        for member in element.manipulator.members:
            if member.control not in known | along:
                now = (
                    f"; {renamed[member.control]!r} moves as it did"
                    if member.control in renamed
                    else ""
                )
                yield issue(
                    "LAYOUT_CONTROL_GONE",
                    element.name,
                    f"{rig.skel_root.path} has no control {member.control!r}{now}",
                )


def _anchor_faults(
    body: Body, surface: BaseSurface, element: Element, mesh: RigMesh, *, comparable: bool
) -> Iterator[Issue]:
    """What is wrong with an anchor on a `mesh` that is there; where it is, only if base poses are
    `comparable`."""
    anchor = element.anchor
    if change := anchor.mesh_change(mesh.topology.hash, len(mesh.points)):
        yield issue("LAYOUT_TOPOLOGY", element.name, change)
    elif not 0 <= anchor.point < len(mesh.points):
        yield issue("LAYOUT_TOPOLOGY", element.name, f"{anchor.mesh} has no point {anchor.point}")
    elif comparable and not anchor.on_board and (off := _off(body, surface, anchor)) > _MOVED:
        found = f"its point lies {off:.1%} of the face from where it was"
        yield issue("LAYOUT_ANCHOR_MOVED", element.name, found)


def _off(body: Body, surface: BaseSurface, anchor: Anchor) -> float:
    """Distance between the anchor as recorded and as it is, over the face size."""
    here = surface.points[body.point_of(anchor.mesh, anchor.point)]
    return float(np.linalg.norm(here - anchor.position)) / surface.face_size


def _custom_base(base_values: Floats, settings: ReadSettings) -> bool:
    """Whether the layout was solved at another base pose, so that positions cannot be compared."""
    return bool(settings.pose) or settings.time is not None or not np.allclose(base_values, 0.0)


def _unplaced(
    face: Face, layout: Layout, requests: Requests, listed: frozenset[str]
) -> Iterator[Issue]:
    known = layout.controls | {left.control for left in layout.left_off}
    if not layout.proof.method:  # only the list shows what is left off by hand
        known |= listed
    names = [
        face.control_name(motion.control)
        for motion in face.trajectories.motions
        if not requests.overrides[motion.control].exclude
    ]
    new = [name for name in names if name not in known]
    if len(new) > 1 and not listed and not layout.proof.method:
        clause = "controls have no element, and rigUI:layout:baseControls lists none"
        yield issue("LAYOUT_CONTROL_NEW", layout.character.root, f"{len(new)} {clause}")
        return
    for name in new:
        yield issue("LAYOUT_CONTROL_NEW", name, "has no element and is not listed without one")


def _crowded(elements: tuple[Element, ...], least: float) -> Iterator[Issue]:
    placed = [element for element in elements if not element.anchor.on_board]
    if len(placed) < 2:
        return
    seen = states(elements)
    positions = np.array([element.anchor.position for element in placed])
    apart = np.linalg.norm(positions[:, None] - positions[None], axis=2)
    for a, b in np.argwhere(np.triu(apart < least * (1.0 - _TOUCHING), 1)):
        if not seen[placed[a].name] & seen[placed[b].name]:
            continue
        between = f"{apart[a, b] / least:.2f} handle widths from {placed[b].name}"
        yield issue("LAYOUT_HANDLES_COLLIDE", placed[a].name, f"its handle is {between}")


def _hidden(face: Face, elements: tuple[Element, ...]) -> Iterator[Issue]:
    seen = face.views.anywhere
    for element in elements:
        if not seen[face.rig.body.point_of(element.anchor.mesh, element.anchor.point)]:
            yield issue("LAYOUT_ANCHOR_HIDDEN", element.name, "its anchor is hidden in all views")


# --- how good it is -------------------------------------------------------------------------------


def _sound(face: Face, elements: tuple[Element, ...]) -> tuple[Element, ...]:
    """The elements on the face that can be rated: mesh, point and controls exist and the controls
    move it."""
    rig = face.rig
    moving = {rig.controls[motion.control].name for motion in face.trajectories.motions}
    meshes = {mesh.path: len(mesh.points) for mesh in rig.body.meshes}
    return tuple(
        element
        for element in elements
        if not element.anchor.on_board
        and 0 <= element.anchor.point < meshes.get(element.anchor.mesh, 0)
        and all(member.control in moving for member in element.manipulator.members)
    )


def _as_problem(
    known: Measured,
    candidates: Candidates,
    every: tuple[Element, ...],
    elements: tuple[Element, ...],
) -> tuple[LayoutProblem, tuple[Choice, ...], Indices]:
    """The problem in which each of the `elements` is one variable, its own anchor among the
    candidates; `every` element of the layout defines of what they are states and parts."""
    face, settings = known.face, known.settings
    groups = _as_groups(face.rig.controls, every, elements)
    points = [
        face.rig.body.point_of(element.anchor.mesh, element.anchor.point) for element in elements
    ]
    sets = _with_points(face, candidates, groups, points, LinearTerms.of(settings.layout))
    placement = placement_problem(face, sets, groups, known.requests, settings)
    labels, kept = [], []
    for number, choice in enumerate(placement.choices):
        at = np.flatnonzero(choice.anchors[:, 0] == points[choice.group])
        if len(at):
            labels.append(int(at[0]))
            kept.append(number)
    problem = placement.problem
    separation = min(problem.separation, face.handle_width * (1.0 - _TOUCHING))
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
    seen, parts = states(elements), _parts(elements)
    owned = {
        each.name: tuple(index[member.control] for member in each.manipulator.members)
        for each in sound
    }
    return tuple(
        Group(
            element.name,
            element.manipulator.kind,
            owned[element.name],
            element.manipulator.opposed,
            # A copy of a doubled element is not held to the mirror plane; that of a pair never is.
            owned.get(element.manipulator.mirror, ()),
            "",
            part=element.name in parts,
            states=seen[element.name],
        )
        for element in sound
    )


def _parts(elements: tuple[Element, ...]) -> frozenset[str]:
    """Names of the elements all of whose controls a coarse element holds too."""
    inner = inner_names(elements)
    outer = {
        m.control
        for element in elements
        if element.name not in inner
        for m in element.manipulator.members
    }
    return frozenset(
        e.name for e in elements if e.name in inner and outer >= e.manipulator.controls
    )


def _with_points(
    face: Face,
    candidates: Candidates,
    groups: tuple[Group, ...],
    points: list[int],
    terms: LinearTerms,
) -> Candidates:
    """The candidates with the anchors of the layout among them, pruned or not."""
    motions = face.trajectories.motions
    sets = {motions[each.motion].control: each for each in candidates.sets}
    for group, point in zip(groups, points, strict=True):
        for control in group.controls:
            if control in sets and point in motions[sets[control].motion].points:
                sets[control] = _with_point(face, sets[control], point, terms)
    return Candidates(tuple(sets.values()), candidates.left_off)


def _with_point(
    face: Face,
    known: CandidateSet,
    point: int,
    terms: LinearTerms,
) -> CandidateSet:
    if point in known.points:
        return known
    motion = face.trajectories.motions[known.motion]
    at = int(np.searchsorted(known.points, point))
    cost = linear_cost(face, motion, np.array([point]), terms)
    return replace(
        known,
        points=np.insert(known.points, at, point),
        cost=np.insert(known.cost, at, cost[0]),
        sources=np.insert(known.sources, at, point),
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
    mirror = {element.name: element.manipulator.mirror for element in elements}
    index = {variable.name: i for i, variable in enumerate(problem.variables)}
    at = [int(choice.anchors[label, 0]) for choice, label in zip(choices, labels, strict=True)]
    mates = [index.get(mirror[variable.name], -1) for variable in problem.variables]
    return [
        j if j >= 0 and face.symmetry.partner[at[i]] == at[j] else -1 for i, j in enumerate(mates)
    ]


def _cost_with_mate(
    face: Face,
    problem: LayoutProblem,
    choices: tuple[Choice, ...],
    labels: Indices,
    index: int,
    mate: int,
) -> Floats:
    """(R,) cost of every candidate of an element with its mirror image on the mirror image of it;
    inf where none is."""
    images = face.symmetry.partner[choices[index].anchors[:, 0]]
    anchors = choices[mate].anchors[:, 0]
    order = np.argsort(anchors, kind="stable")
    rows = order[np.minimum(np.searchsorted(anchors[order], images), len(anchors) - 1)]
    cost = (
        cost_given_others(problem, labels, index, mate)
        + cost_given_others(problem, labels, mate, index)[rows]
    )
    cost += pair_costs(problem, index, mate, np.arange(len(images)), rows)
    return np.where(anchors[rows] == images, cost, np.inf)


def _rated(
    face: Face,
    problem: LayoutProblem,
    choices: tuple[Choice, ...],
    labels: Indices,
    index: int,
    mate: int,
) -> ElementReview:
    variable, choice, label = problem.variables[index], choices[index], int(labels[index])
    alone = cost_given_others(problem, labels, index)
    whole = _cost_with_mate(face, problem, choices, labels, index, mate) if mate >= 0 else alone
    best = int(np.argmin(whole))
    improvement = float(whole[label] - whole[best]) if np.isfinite(whole[label]) else np.inf
    nearest, distance = _neighbour(problem, labels, index)
    return ElementReview(
        element=variable.name,
        kept=_kept(face, choice, label),
        linear=float(variable.cost[label]),
        overlap=float(alone[label] - variable.cost[label]),
        nearest=nearest,
        distance=distance / face.handle_width,
        improvement=max(0.0, improvement),
        better=place_of(face.rig.body, int(choice.anchors[best, 0])) if improvement > 0.0 else "",
    )


def cost_given_others(
    problem: LayoutProblem, labels: Indices, index: int, without: int = -1
) -> Floats:
    """(R,) cost of every candidate of one variable, all others but `without` staying where they
    are."""
    count = len(problem.variables[index].points)
    mine = np.arange(count)
    cost = problem.variables[index].cost.copy()
    for other in range(len(labels)):
        if other not in (index, without):
            cost += pair_costs(problem, index, other, mine, np.full(count, labels[other]))
    return cost


def _neighbour(problem: LayoutProblem, labels: Indices, index: int) -> tuple[str, float]:
    handles = [
        variable.handles[label] for variable, label in zip(problem.variables, labels, strict=True)
    ]
    nearest, distance = "", np.inf
    for other, positions in enumerate(handles):
        if other != index and problem.together[index, other]:
            apart = float(np.linalg.norm(handles[index][:, None] - positions[None], axis=2).min())
            if apart < distance:
                nearest, distance = problem.variables[other].name, apart
    return nearest, distance


def _kept(face: Face, choice: Choice, label: int) -> float:
    shares = []
    for copy, controls in enumerate(choice.controls):
        for control in controls:
            motion = face.trajectories.motion_of(control)
            row = int(np.searchsorted(motion.points, choice.sources[label, copy]))
            shares.append(float(motion.arc_length[row]) / motion.peak)
    return min(shares)
