"""An existing layout to which a shot adds: new controls are placed, and every existing element
stays to the point.

The existing elements are no variables of the problem.  What each of them costs a candidate of a new
element is part of that candidate's linear cost, so that the new elements are optimal given the
existing ones, and the bound is one of that problem (paper section 1, partial layouts).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.character import Control, Floats, Rig
from usdrigui.layout.face import Face
from usdrigui.layout.motion.tracks import resampled
from usdrigui.layout.reuse.renaming import with_element_names
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import AnyOverlap, Candidates, Element, Layout, LayoutProblem, Variable
from usdrigui.overlap import ROUNDING, pair_costs


def layout_of(layouts: tuple[Layout, ...], rig: Rig) -> Layout | None:
    """The one of some layouts that is of this character, with the paths of `rig`; none if there is
    no such.

    A shot may have the character at another path.  Below its SkelRoot nothing may have another
    name.
    """
    found = _fitting(layouts, rig)
    return None if found is None else _moved(found, rig.path, rig.variant_path)


def root_in_base(layouts: tuple[Layout, ...], rig: Rig) -> str:
    """The SkelRoot's path in the layer of the existing layout; empty where there is none."""
    found = _fitting(layouts, rig)
    return found.root if found is not None else ""


def new_controls(layout: Layout, controls: tuple[Control, ...]) -> frozenset[int]:
    """Indices of the controls that the layout neither has nor lists as left off."""
    known = layout.controls | {left.control for left in layout.left_off}
    return frozenset(i for i, control in enumerate(controls) if control.name not in known)


def drawn_width(layout: Layout | None, part: str) -> float:
    """The width of a part's handles in the existing layout; 0 where there is none, or it has none
    of that part."""
    width = layout.frame.handle_width_of(part) if layout is not None else 0.0
    return width * (1.0 - ROUNDING)  # they are exactly as far apart as they were, but for that


def of_new_controls(face: Face, requests: Requests, candidates: Candidates) -> Candidates:
    """The candidates of the controls that the existing layout does not have; of all where there is
    none."""
    if requests.existing is None:
        return candidates
    new = new_controls(requests.existing, face.rig.controls)
    kept = {control: each for control, each in candidates.sets.items() if control in new}
    return Candidates(kept, candidates.left_off)


def existing_variables(
    face: Face, elements: tuple[Element, ...], count: int
) -> tuple[Variable, ...]:
    """The existing `elements` on the face, each as a variable of one candidate, drawn as its layer
    draws it with `count` samples of a track."""
    return tuple(_variable(face, each, count) for each in elements if not each.anchor.on_board)


def costs_beside_existing(
    existing: tuple[Variable, ...],
    overlap: AnyOverlap,
    separation: float,
    samples: Floats,
    handles: Floats,
) -> Floats:
    """(R,) what the existing elements cost the candidates of a new one: overlap with each of them,
    +inf where two handles would be too near.

    `samples` (R, copies, u, 3) and `handles` (R, copies, 3) are those of the new element.
    """
    labels, none = np.arange(len(handles)), np.zeros(len(handles))
    new = Variable("", labels, none, samples, handles, np.inf, none)
    cost = np.zeros(len(handles))
    for each in existing:
        pair = LayoutProblem((new, each), overlap, separation)
        cost += pair_costs(pair, 0, 1, labels, np.zeros_like(labels))
    return cost


def uniquify_names(added: Layout, existing: Layout) -> Layout:
    """The added elements, none with the name of an existing one."""
    taken = {element.name for element in existing.elements}
    names: dict[str, str] = {}
    for element in added.elements:
        name = element.name
        while name in taken:
            name = f"{name}_added"
        names[element.name] = name
        taken.add(name)
    return with_element_names(added, names)


def combined(existing: Layout, added: Layout) -> Layout:
    """Both as one layout: what a client sees that composes the two layers."""
    return replace(
        existing,
        elements=(*existing.elements, *added.elements),
        left_off=added.left_off,
        frame=replace(
            existing.frame, handle_width=existing.frame.handle_width or added.frame.handle_width
        ),
        base_values=added.base_values,
        proof=added.proof,
    )


def _fitting(layouts: tuple[Layout, ...], rig: Rig) -> Layout | None:
    here = [layout for layout in layouts if layout.root == rig.path]
    fitting = [
        layout
        for layout in here or layouts
        if _alike(_moved(layout, rig.path, rig.variant_path), rig)
    ]
    return fitting[0] if len(fitting) == 1 else None


def _alike(layout: Layout, rig: Rig) -> bool:
    """Whether a layout has a mesh and a control in common with a character."""
    meshes = {element.anchor.mesh for element in layout.elements}
    elsewhere = meshes.isdisjoint(mesh.path for mesh in rig.body.meshes)
    return not (elsewhere or layout.controls.isdisjoint(rig.control_names))


def _moved(layout: Layout, root: str, variant_path: str) -> Layout:
    """The layout of the same character at another path."""
    elements = tuple(
        replace(
            each,
            anchor=replace(each.anchor, mesh=moved_path(each.anchor.mesh, layout.root, root)),
        )
        for each in layout.elements
    )
    return replace(layout, root=root, variant_path=variant_path, elements=elements)


def moved_path(path: str, before: str, after: str) -> str:
    """A path below `before` as it is below `after`."""
    return after + path.removeprefix(before) if path.startswith(f"{before}/") else path


def _variable(face: Face, element: Element, count: int) -> Variable:
    point = np.array([element.anchor.on(face.rig.body)])
    samples = np.hstack([resampled(member.track[None], count) for member in element.members])
    aside = face.aside[point]
    samples = face.seen(face.drawing_axes, samples, aside)[None]
    handles = face.seen(face.handle_axes, face.surface.points[point], aside)[None]
    return Variable(element.name, point, np.zeros(1), samples, handles, np.inf, np.zeros(1))
