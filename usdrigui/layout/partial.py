"""Partial layouts: anchors and groups that are given, and requests that no layout can meet.

Fixed anchors come from the configuration (``controls."name".anchor``) or from an existing layout; they
are kept to the point, and the rest is optimal given them (paper section 1, partial layouts).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from usdrigui.errors import refuse
from usdrigui.layout.locality import fixed_anchor
from usdrigui.layout.symmetry import plane_distance, reflected
from usdrigui.layout.terms import Context
from usdrigui.levels import outer_first
from usdrigui.model import Element, Group, Layout, LayoutProblem, Motion, Rig
from usdrigui.settings import ControlSettings, Settings

if TYPE_CHECKING:
    from usdrigui.layout.problem import Choice

_SAME = 0.5
"""Earlier places of two twins mirror each other when they are nearer to it than this, in handle widths."""


def fixed_by(layout: Layout, rig: Rig, settings: Settings, only: frozenset[str] | None = None) -> Settings:
    """The settings with every anchor of `layout` fixed, or of the elements called `only`.

    What the configuration itself says of a control's place is stronger.  Raises FIXED_IMPOSSIBLE where the
    layout was made for other points, CONFIG_UNKNOWN_CONTROL where it has a control that the rig lacks.
    """
    known = {control.name for control in rig.controls}
    renamed = {said.rename: name for name, said in settings.controls.items() if said.rename}
    controls = dict(settings.controls)
    placed: set[str] = set()
    for element in outer_first(layout.elements):
        if only is not None and element.name not in only:
            continue
        for member in element.members:
            if member.control not in known:
                where = f"{layout.root} element {element.name}"
                raise refuse("CONFIG_UNKNOWN_CONTROL", where, f"{rig.root} has no control {member.control!r}")
            name = renamed.get(member.control, member.control)
            said = controls.get(name, ControlSettings())
            if name in placed:
                controls[name] = _anchored_again(said, element, rig)
                continue
            if said.anchor or said.place:
                continue
            placed.add(name)
            controls[name] = replace(said, place="beside") if element.anchor.beside else _anchored(said, element, rig)
    return replace(settings, controls=controls)


def moves(motion: Motion, name: str, said: ControlSettings, point: int) -> bool:
    """Whether a control moves the point at which it is fixed; raises FIXED_IMPOSSIBLE if it should but does not."""
    if point in motion.points:
        return True
    if said.place == "proxy":
        return False
    raise refuse("FIXED_IMPOSSIBLE", f'controls."{name}".anchor', f"{name} does not move the point {said.anchor}")


def _said(context: Context, control: int) -> tuple[str, str, float]:
    """What the configuration says of a control's place, apart from a fixed anchor."""
    said = context.said[control]
    return said.place, said.near, said.within


def stands_alone(context: Context, control: int) -> bool:
    """Whether a control of a pair has a place that is not the mirror image of its twin's, so that the two
    cannot be one decision: a fixed anchor, or an earlier place that somebody moved on one side only."""
    twin = int(context.symmetry.twins[control])
    if twin >= 0 and _said(context, control) != _said(context, twin):
        return True
    if context.said[control].anchor:
        return not _fixed_in_mirror(context, control, twin)
    precedent = context.precedent
    mine, other = precedent.places.get(control), precedent.places.get(twin)
    if mine is None or other is None or precedent.reach > 0.0:
        return False
    if mine.beside or other.beside:
        return mine.beside != other.beside
    apart = np.linalg.norm(reflected(mine.position[None], context.symmetry)[0] - other.position)
    return bool(apart > _SAME * context.handle_width)


def refuse_impossible(
    context: Context, groups: tuple[Group, ...], problem: LayoutProblem, choices: Sequence[Choice]
) -> None:
    """Raise FIXED_IMPOSSIBLE when the fixed anchors contradict each other, naming them."""
    fixed = list(_fixed(context, groups, choices))
    for number in fixed:
        name = problem.variables[number].name
        anchors = sorted({context.said[c].anchor for c in groups[choices[number].group].controls} - {""})
        if len(anchors) > 1:
            raise refuse("FIXED_IMPOSSIBLE", name, f"one element is fixed at {' and at '.join(anchors)}")
        if not len(choices[number].anchors):
            why = "not all of its controls can be anchored there, or its copies would collide"
            raise refuse("FIXED_IMPOSSIBLE", name, f"cannot stand at {anchors[0]}: {why}")
    for place, a in enumerate(fixed):
        for b in fixed[place + 1 :]:
            one, other = problem.variables[a], problem.variables[b]
            if not problem.together[a, b]:
                continue
            apart = np.linalg.norm(one.handles[0][:, None] - other.handles[0][None], axis=2).min()
            if apart < problem.separation:
                told = f"{apart / problem.separation:.2f} of the least distance between two handles"
                raise refuse("FIXED_IMPOSSIBLE", one.name, f"is fixed at {told} from {other.name}")


def _anchored(said: ControlSettings, element: Element, rig: Rig) -> ControlSettings:
    anchor = element.anchor
    mesh = next((each for each in rig.meshes if each.path == anchor.mesh), None)
    if mesh is None or (anchor.topology_hash and anchor.topology_hash != mesh.topology_hash):
        change = "is gone" if mesh is None else "has other points or faces by now"
        raise refuse("FIXED_IMPOSSIBLE", element.name, f"its mesh {anchor.mesh} {change}")
    return replace(said, anchor=f"{anchor.mesh}#{anchor.point}")


def _anchored_again(said: ControlSettings, element: Element, rig: Rig) -> ControlSettings:
    """What is fixed of the slider that a control has of its own under a coarse element."""
    if said.inner_anchor or element.anchor.beside:
        return said
    return replace(said, inner_anchor=_anchored(said, element, rig).anchor)


def _fixed_in_mirror(context: Context, control: int, twin: int) -> bool:
    """Whether both twins are fixed, and the right one exactly at the mirror partner of the left one."""
    if twin < 0 or not context.said[twin].anchor:
        return False
    names = [context.rig.controls[c].name for c in (control, twin)]
    pair = [fixed_anchor(context.rig, name, context.said[c]) for name, c in zip(names, (control, twin), strict=True)]
    points = np.array([point for point in pair if point is not None])
    apart = plane_distance(context.trajectories.base[points], context.symmetry)
    left, right = points if apart[0] >= apart[1] else points[::-1]
    return bool(context.symmetry.partner[left] == right)


def _fixed(context: Context, groups: tuple[Group, ...], choices: Sequence[Choice]) -> Iterator[int]:
    """Numbers of the variables with a fixed anchor."""
    for number, choice in enumerate(choices):
        group = groups[choice.group]
        if not group.part and any(context.said[control].anchor for control in group.controls):
            yield number
