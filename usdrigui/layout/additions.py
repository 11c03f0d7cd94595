"""What a shot adds to a layout that stands: its new controls are placed, and everything else stays to the point.

The standing elements are no variables of the problem.  What each of them costs a candidate of a new element is
part of that candidate's linear cost, so that the new elements are optimal given the standing ones, and the
bound is one of that problem (paper section 1, partial layouts).
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from usdrigui.layout.tracks import flattened, resampled
from usdrigui.model import (
    Candidates,
    Element,
    Floats,
    Layout,
    LayoutProblem,
    Overlap,
    Rig,
    Trajectories,
    Variable,
)
from usdrigui.overlap import pair_costs
from usdrigui.settings import Settings

if TYPE_CHECKING:
    from usdrigui.layout.terms import Context

_ROUNDING = 1e-9
"""Handles of the standing layout are exactly as far apart as they were, but for rounding."""


def standing_layout(layouts: tuple[Layout, ...], rig: Rig) -> Layout | None:
    """The one of some layouts that is of this character, with the paths of `rig`; none if there is no such.

    A shot may have the character at another path.  Below its SkelRoot nothing may have another name.
    """
    found = _fitting(layouts, rig)
    return _moved(found, rig.root) if found is not None else None


def root_in_base(layouts: tuple[Layout, ...], rig: Rig) -> str:
    """The SkelRoot's path in the layer of the standing layout; empty where none stands."""
    found = _fitting(layouts, rig)
    return found.root if found is not None else ""


def new_controls(layout: Layout, rig: Rig) -> frozenset[int]:
    """Indices of the controls that the layout neither has nor says it left off."""
    known = {member.control for element in layout.elements for member in element.members}
    known |= {left.control for left in layout.left_off}
    return frozenset(i for i, control in enumerate(rig.controls) if control.name not in known)


def as_drawn(layout: Layout, trajectories: Trajectories, settings: Settings) -> Settings:
    """The settings with which handles are as wide as in `layout`, and groups only of what it lacks."""
    known = {member.control for element in layout.elements for member in element.members}
    groups = {name: controls for name, controls in settings.groups.groups.items() if not known.issuperset(controls)}
    width = layout.handle_width or settings.objective.handle_size * trajectories.face_size
    size = width * (1.0 - _ROUNDING) / trajectories.face_size
    return replace(
        settings,
        objective=replace(settings.objective, handle_size=size, handle_crowd=0.0),
        groups=replace(settings.groups, groups=groups),
    )


def of_new_controls(context: Context, candidates: Candidates) -> Candidates:
    """The candidates of the controls that the standing layout does not have; of all where none stands."""
    if context.standing is None:
        return candidates
    new = new_controls(context.standing, context.rig)
    motions = context.trajectories.motions
    kept = tuple(each for each in candidates.sets if motions[each.motion].control in new)
    return Candidates(kept, candidates.left_off)


def standing_costs(context: Context, overlap: Overlap, separation: float, samples: Floats, handles: Floats) -> Floats:
    """(R,) what the standing elements cost the candidates of a new one: overlap with each of them, +inf where
    two handles would be too near.

    `samples` (R, copies, u, 3) and `handles` (R, copies, 3) are those of the new element.
    """
    standing = context.standing.elements if context.standing is not None else ()
    labels, none = np.arange(len(handles)), np.zeros(len(handles))
    new = Variable("", labels, none, samples, handles, np.inf, none)
    cost = np.zeros(len(handles))
    for element in standing:
        if not element.anchor.beside:
            pair = LayoutProblem((new, _fixed(context, element)), overlap, separation, 0.0)
            cost += pair_costs(pair, 0, 1, labels, np.zeros_like(labels))
    return cost


def told_apart(added: Layout, standing: Layout) -> Layout:
    """The added elements, none called like a standing one."""
    taken = {element.name for element in standing.elements}
    names: dict[str, str] = {}
    for element in added.elements:
        name = element.name
        while name in taken:
            name = f"{name}_added"
        names[element.name] = name
        taken.add(name)
    elements = tuple(
        replace(e, name=names[e.name], mirror=names.get(e.mirror, ""), inner=tuple(names[each] for each in e.inner))
        for e in added.elements
    )
    return replace(added, elements=elements)


def joined(standing: Layout, added: Layout) -> Layout:
    """Both as one layout: what a client sees that composes the two layers."""
    return replace(
        standing,
        elements=(*standing.elements, *added.elements),
        left_off=added.left_off,
        handle_width=standing.handle_width or added.handle_width,
        base_values=added.base_values,
        method=added.method,
        status=added.status,
        cost=added.cost,
        bound=added.bound,
        in_play=added.in_play,
        weights=added.weights,
    )


def _fitting(layouts: tuple[Layout, ...], rig: Rig) -> Layout | None:
    here = [layout for layout in layouts if layout.root == rig.root]
    fitting = [layout for layout in here or layouts if _alike(_moved(layout, rig.root), rig)]
    return fitting[0] if len(fitting) == 1 else None


def _alike(layout: Layout, rig: Rig) -> bool:
    """Whether a layout has a mesh and a control in common with a character."""
    meshes = {element.anchor.mesh for element in layout.elements}
    names = {member.control for element in layout.elements for member in element.members}
    return bool(meshes & {mesh.path for mesh in rig.meshes}) and bool(names & {each.name for each in rig.controls})


def _moved(layout: Layout, root: str) -> Layout:
    """The layout of the same character at another path."""
    elements = tuple(
        replace(each, anchor=replace(each.anchor, mesh=_moved_path(each.anchor.mesh, layout.root, root)))
        for each in layout.elements
    )
    return replace(layout, root=root, elements=elements)


def _moved_path(path: str, before: str, after: str) -> str:
    """A path below `before` as it is below `after`."""
    return after + path.removeprefix(before) if path.startswith(f"{before}/") else path


def _fixed(context: Context, element: Element) -> Variable:
    """A standing element as a variable of one candidate, drawn as its layer draws it."""
    count = context.settings.objective.samples
    point = np.array([_anchor_point(context.rig, element)])
    samples = np.concatenate([resampled(member.track[None], count)[0] for member in element.members])
    handle: Floats = context.trajectories.base[point]
    if context.settings.candidates.space == "view":
        toward = context.views.directions[0]
        samples, handle = flattened(samples, toward), flattened(handle, toward)
    return Variable(element.name, point, np.zeros(1), samples[None, None], handle[None], np.inf, np.zeros(1))


def _anchor_point(rig: Rig, element: Element) -> int:
    """The anchor of an element as an index into all points of the rig."""
    paths = [mesh.path for mesh in rig.meshes]
    return int(rig.starts[paths.index(element.anchor.mesh)]) + element.anchor.point
