"""From the chosen labels to the elements that the animator sees (paper section 3.2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace

import numpy as np

from usdrigui.character import Floats, Indices, Rig
from usdrigui.layout.board.board import BoardEntry, board_elements
from usdrigui.layout.element.fans import fan_order
from usdrigui.layout.face import Face
from usdrigui.layout.glyph_fitting import fitted_glyph
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.tracks import arc_lengths, paths
from usdrigui.layout.names import common_label, element_name
from usdrigui.layout.place.labels import drawn_magnification, own_mirror_image
from usdrigui.layout.place.problem import PlacementProblem
from usdrigui.layout.symmetry.lobes import MIDDLE, side_at
from usdrigui.model import (
    Assignment,
    Choice,
    Element,
    Group,
    Layout,
    LayoutFrame,
    Member,
    Proof,
    Side,
)

_CROWDED = "too crowded; this control lost the least displacement"


def layout(
    known: Measured, placement: PlacementProblem, assignment: Assignment, part: str
) -> Layout:
    """The elements of every group, on the face where the assignment has them there and on the board
    otherwise; `part` is the name of what is laid out."""
    face, requests, settings = known.face, known.requests, known.settings
    elements: list[Element] = []
    off: list[tuple[Group, str, str]] = [
        (group, group.category, "") for group in placement.groups if group.category
    ]
    for choice, label in zip(placement.choices, assignment.labels, strict=True):
        group = placement.groups[choice.group]
        if label < 0:
            reason = (
                f"moved off the {part}: {_CROWDED}"
                if len(choice.anchors)
                else f"no free place on the {part}"
            )
            off.append((group, "crowded", reason))
        else:
            elements.extend(_on_face(known, group, choice, int(label)))
    board = [
        BoardEntry(group, name, copy, category, reason or group.reason_of(copy))
        for group, category, reason in off
        for name, copy in _once(names_of_copies(face.rig, group), group.copies)
    ]
    elements.extend(board_elements(face, board, requests, settings.output.adapt))
    asked = asdict(settings.objective).items()
    weights = tuple(
        (f"objective.{k}", float(f"{v:.7g}")) for k, v in asked if isinstance(v, (int, float))
    )
    return Layout(
        root=face.rig.path,
        base_values=np.zeros(0),
        variant_path=face.rig.variant_path,
        elements=tuple(
            replace(each, part=part) for each in _with_inner(elements, placement.groups, face.rig)
        ),
        left_off=(),
        frame=LayoutFrame(
            space="view" if face.flat else "object",
            view=face.views.directions[0],
            plane=face.symmetry.plane,
            handle_width=face.handle_width,
        ),
        proof=proof_of(assignment, weights),
    )


def proof_of(assignment: Assignment, weights: tuple[tuple[str, float], ...]) -> Proof:
    """What a layout keeps of how it was found; `weights` as of `Proof.weights`."""
    return Proof(
        assignment.method,
        assignment.status,
        assignment.cost,
        assignment.bound,
        assignment.above_unary_bound,
        weights,
        assignment.closed_by,
        assignment.figures,
    )


def _once(
    names: Sequence[str], copies: Sequence[tuple[int, ...]]
) -> Iterator[tuple[str, tuple[int, ...]]]:
    """Name and controls of the copies of a group that hold other controls: of a double element one
    is enough on the board."""
    for i, (name, copy) in enumerate(zip(names, copies, strict=True)):
        if set(copy) not in [set(each) for each in copies[:i]]:
            yield name, copy


def _with_inner(
    elements: Sequence[Element], groups: Sequence[Group], rig: Rig
) -> Iterator[Element]:
    """The elements of all groups, the coarse ones with the names of their members on their own
    side."""
    made = {element.name for element in elements}
    names = {
        group.name: [name for name in names_of_copies(rig, group) if name in made]
        for group in groups
    }
    inner: dict[str, set[str]] = {}
    for group in groups:
        for copy, name in enumerate(own := names[group.name]):
            for theirs in (names[member] for member in group.inner):
                same = theirs[copy : copy + 1] if len(theirs) == len(own) else theirs
                inner.setdefault(name, set()).update(same)
    for element in elements:
        yield replace(element, inner=tuple(sorted(inner.get(element.name, ()))))


def names_of_copies(rig: Rig, group: Group) -> list[str]:
    """Names of the element and of its images, each unique."""
    given = [group.name, *group.image_names]
    own = [
        element_name([rig.control_names[each] for each in copy], rig.control_names)
        for copy in group.copies
    ]
    names = [chosen or name for chosen, name in zip(given, own, strict=False)]
    if len(set(names)) < len(names):
        # The same controls on both sides: a double element in the middle.
        names = [name + ("_mirror" if copy else "") for copy, name in enumerate(names)]
    return names


def _on_face(known: Measured, group: Group, choice: Choice, label: int) -> list[Element]:
    """The element of a group and of its mirror images."""
    face, requests, settings = known.face, known.requests, known.settings.output
    names = names_of_copies(face.rig, group)
    least = settings.min_track * face.handle_width
    made, sides = [], _sides(face, choice.anchors[label])
    for copy, controls in enumerate(choice.controls):
        point, source = int(choice.anchors[label, copy]), int(choice.sources[label, copy])
        overrides = [requests.overrides[control] for control in controls]
        drawn = tuple(_member(face, control, point, source, least) for control in controls)
        members, opposed = _ordered(group, drawn, _normal(face, point))
        middle = own_mirror_image(face, group)
        anchor, side = face.anchor(point), "middle" if middle else sides[copy]
        mirror = names[1 - copy] if len(names) == 2 else ""
        made.append(
            Element(
                name=names[copy],
                kind=group.kind,
                members=members,
                opposed=opposed,
                mirror=mirror,
                reversed=_reversed(face, members) if mirror else (),
                anchor=anchor,
                label=common_label([face.rig.controls[control].label for control in controls]),
                side=side,
                # What goes another way than the skin at its anchor slides over it.
                adapt="static" if source != point else overrides[0].adapt or settings.adapt,
                glyph=fitted_glyph(
                    face, overrides, anchor, members, bool(mirror) and side == "right"
                ),
                reason=group.reason_of(controls),
            )
        )
    return made


def _reversed(face: Face, members: tuple[Member, ...]) -> tuple[int, ...]:
    names = face.rig.control_indices
    return tuple(
        m for m, member in enumerate(members) if face.symmetry.reversed[names[member.control]]
    )


def _normal(face: Face, point: int) -> Floats:
    normal = face.surface.normals[point]
    return np.array(normal if normal.any() else face.views.directions[0])


def _ordered(
    group: Group, members: tuple[Member, ...], normal: Floats
) -> tuple[tuple[Member, ...], tuple[tuple[int, int], ...]]:
    """Members of a fan by their angle about the anchor (paper section 3.2), and its opposed pairs
    so numbered."""
    if group.kind != "fan":
        return members, group.opposed
    order = fan_order(np.stack([member.track[-1] - member.track[0] for member in members]), normal)
    place = {old: new for new, old in enumerate(order)}
    return tuple(members[i] for i in order), tuple((place[a], place[b]) for a, b in group.opposed)


def _member(face: Face, control: int, point: int, source: int, least: float) -> Member:
    """The control's own trajectory at the source, drawn from the anchor, enlarged where it is
    shorter than `least`."""
    motion = face.trajectories.motion_of(control)
    one = np.array([source])
    (length,), (path,) = arc_lengths(motion, one).tolist(), paths(motion, one)
    (factor,) = drawn_magnification(face, motion, one, least).tolist()
    track = face.surface.points[point] + factor * path
    name, peak = face.control_name(control), float(motion.arc_length.max())
    return Member(name, motion.values, track, length, factor, peak)


def _sides(face: Face, points: Indices) -> list[Side]:
    """The side of the character on which each copy of an element at `points` lies."""
    plane, surface = face.symmetry.plane, face.surface
    if not plane.normal.any():
        return ["none"] * len(points)
    away = plane.aside(surface.points[points]) / surface.face_size
    return [side_at(apart, MIDDLE) for apart in away.tolist()]
