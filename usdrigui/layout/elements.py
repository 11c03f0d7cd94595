"""From the chosen labels to the elements that the animator sees (paper section 3.2)."""

from __future__ import annotations

import numpy as np

from usdrigui.layout.board import Board, beside_elements
from usdrigui.layout.fans import fan_order
from usdrigui.layout.glyphs import fitted_glyph
from usdrigui.layout.levels import with_inner
from usdrigui.layout.names import common_label
from usdrigui.layout.problem import Choice, own_mirror_image
from usdrigui.layout.symmetry import plane_distance
from usdrigui.layout.terms import Context
from usdrigui.layout.tracks import arc_lengths, gains, paths
from usdrigui.model import (
    Anchor,
    Assignment,
    Candidates,
    Element,
    Floats,
    Group,
    Layout,
    LayoutProblem,
    LeftOff,
    Member,
    Side,
)

_ON_PLANE = 1e-3
"""An anchor nearer to the mirror plane than this share of the face size lies in the middle."""


def layout(
    context: Context,
    candidates: Candidates,
    groups: tuple[Group, ...],
    problem: LayoutProblem,
    choices: tuple[Choice, ...],
    assignment: Assignment,
    base_values: Floats | None = None,
) -> Layout:
    """The elements of every group, on the face where the assignment says so and beside it otherwise."""
    controls = context.rig.controls
    elements: list[Element] = []
    board: list[Board] = [
        Board(group, copy, group.family, group.reason) for group in groups if group.beside for copy in _copies(group)
    ]
    for choice, label in zip(choices, assignment.labels, strict=True):
        group = groups[choice.group]
        if label < 0:
            reason = "left the face to more telling elements" if len(choice.anchors) else "no place on the face"
            board.extend(Board(group, copy, "crowded", reason) for copy in _copies(group))
        else:
            elements.extend(_on_face(context, group, choice, int(label)))
    elements.extend(beside_elements(context, board))
    view = context.settings.candidates
    return Layout(
        root=context.rig.root,
        elements=with_inner(elements, groups, context),
        left_off=_left_off(context, candidates),
        handle_width=context.handle_width,
        space=view.space,
        view=context.views.directions[0],
        plane_origin=context.symmetry.origin,
        plane_normal=context.symmetry.normal,
        base_values=np.array([control.default for control in controls]) if base_values is None else base_values,
        method=assignment.method,
        status=assignment.status,
        cost=assignment.cost,
        bound=assignment.bound,
        in_play=assignment.in_play,
        weights=_weights(context, problem),
    )


def element_name(context: Context, controls: tuple[int, ...]) -> str:
    """Unique name of the element of these controls."""
    return "_".join(context.rig.controls[control].name for control in controls)


def element_label(context: Context, controls: tuple[int, ...]) -> str:
    """What people read beside the element of these controls."""
    return common_label([context.rig.controls[control].label for control in controls])


def _copies(group: Group) -> tuple[tuple[int, ...], ...]:
    return (group.controls, *group.images)


def _left_off(context: Context, candidates: Candidates) -> tuple[LeftOff, ...]:
    return (*context.rig.left_off, *context.trajectories.left_off, *candidates.left_off)


def _weights(context: Context, problem: LayoutProblem) -> tuple[tuple[str, float], ...]:
    overlap = problem.overlap
    return (
        ("displacement_weight", problem.unit_cost),
        ("overlap_max", overlap.maximum),
        ("overlap_radius", overlap.radius),
        ("overlap_sharpness", overlap.sharpness),
        ("overlap_reach", overlap.reach),
        ("separation", problem.separation),
        ("typical_length", context.trajectories.typical_length),
        ("samples", float(context.settings.objective.samples)),
    )


def _on_face(context: Context, group: Group, choice: Choice, label: int) -> list[Element]:
    """The element of a group and of its mirror images."""
    names = names_of_copies(context, group, choice)
    made = []
    for copy, controls in enumerate(choice.controls):
        point, source = int(choice.anchors[label, copy]), int(choice.sources[label, copy])
        said = context.said[controls[0]]
        members, opposed = _ordered(
            group, tuple(_member(context, control, point, source) for control in controls), _normal(context, point)
        )
        anchor, side = anchor_at(context, point), _side(context, group, point)
        mirror = names[1 - copy] if len(names) == 2 else ""
        made.append(
            Element(
                name=names[copy],
                label=element_label(context, controls),
                kind=group.kind,
                members=members,
                opposed=opposed,
                anchor=anchor,
                side=side,
                mirror=mirror,
                family="",
                reason=group.reason,
                adapt=said.adapt or context.settings.output.adapt,
                glyph=fitted_glyph(context, controls, anchor, members, bool(mirror) and side == "right"),
                reversed=_reversed(context, members) if mirror else (),
            )
        )
    return made


def _reversed(context: Context, members: tuple[Member, ...]) -> tuple[int, ...]:
    names = {control.name: i for i, control in enumerate(context.rig.controls)}
    return tuple(m for m, member in enumerate(members) if context.symmetry.reversed[names[member.control]])


def names_of_copies(context: Context, group: Group, choice: Choice) -> list[str]:
    """Names of the element and of its images."""
    given = [group.name, *group.image_names]
    names = [given[copy] or element_name(context, controls) for copy, controls in enumerate(choice.controls)]
    if len(set(names)) < len(names):
        # The same controls on both sides: a double element in the middle.
        names = [name + ("_mirror" if copy else "") for copy, name in enumerate(names)]
    return names


def _normal(context: Context, point: int) -> Floats:
    normal = context.trajectories.normals[point]
    return np.array(normal if normal.any() else context.views.directions[0])


def _ordered(
    group: Group, members: tuple[Member, ...], normal: Floats
) -> tuple[tuple[Member, ...], tuple[tuple[int, int], ...]]:
    """Members of a fan by their angle about the anchor (paper section 3.2), and its opposed pairs so numbered."""
    if group.kind != "fan":
        return members, group.opposed
    order = fan_order(np.stack([member.track[-1] - member.track[0] for member in members]), normal)
    place = {old: new for new, old in enumerate(order)}
    return tuple(members[i] for i in order), tuple((place[a], place[b]) for a, b in group.opposed)


def _member(context: Context, control: int, point: int, source: int) -> Member:
    """The control's own trajectory at the source, drawn from the anchor, enlarged where it is too short."""
    motion = context.trajectories.motion_of(control)
    one = np.array([source])
    length = arc_lengths(motion, one)
    gain = float(gains(length, context.settings.output.min_track * context.handle_width)[0])
    track = context.trajectories.base[point] + gain * paths(motion, one)[0]
    return Member(context.rig.controls[control].name, motion.values, track, float(length[0]), gain)


def anchor_at(context: Context, point: int) -> Anchor:
    """The anchor on a point of the face."""
    index, local = context.rig.mesh_of(point)
    mesh = context.rig.meshes[index]
    base, normal = context.trajectories.base[point], context.trajectories.normals[point]
    return Anchor(mesh.path, local, len(mesh.points), mesh.topology_hash, base, normal, False)


def _side(context: Context, group: Group, point: int) -> Side:
    """The side that an element works on: one that is its own mirror image is of the middle wherever it stands."""
    if not context.symmetry.normal.any():
        return "none"
    if own_mirror_image(context, group):
        return "middle"
    apart = float(plane_distance(context.trajectories.base[point], context.symmetry))
    if abs(apart) <= _ON_PLANE * context.trajectories.face_size:
        return "middle"
    return "left" if apart > 0.0 else "right"
