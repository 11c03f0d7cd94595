"""Whether a layout still fits its rig: what is gone, has moved or is new, and which handles collide
or are hidden."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Body, Drive, Rig, RigMesh
from usdrigui.errors import (
    Faults,
    Issue,
    by_cause,
    catalogue,
    issue,
    listed,
    of_character,
)
from usdrigui.layout.face import Face
from usdrigui.layout.reuse.identity import match_layout
from usdrigui.layout.shares import NOTHING
from usdrigui.model import (
    Anchor,
    BaseSurface,
    Element,
    Layout,
    Trajectories,
)
from usdrigui.model.levels import states
from usdrigui.settings import ReadSettings


def refuse_stale(
    rig: Rig, trajectories: Trajectories, layout: Layout, settings: ReadSettings
) -> None:
    """Raise every error for which a layout does not fit the rig any more (LAYOUT_...), by cause."""
    faults = Faults()
    reasons = stale(rig, trajectories, (layout, layout), settings)
    told = by_cause(of_character(rig.path_in_variants, reasons))
    faults.add(found for found in told if found.severity == "error")
    faults.raise_all()


def stale(
    rig: Rig, trajectories: Trajectories, layouts: tuple[Layout, Layout], settings: ReadSettings
) -> Iterator[Issue]:
    """Why a layout, and with it the whole of which it is a part, does not fit the rig any more."""
    layout, whole = layouts
    posed = bool(settings.pose) or settings.time is not None
    # Positions of another base pose cannot be compared.
    comparable = not posed and np.allclose(layout.base_values, 0.0)
    known = {*rig.control_names}
    lacking = not known.issuperset(layout.controls)
    renamed = match_layout(layout, rig, trajectories).renamed if lacking else {}
    anchored = dict.fromkeys(element.anchor.mesh for element in whole.elements)
    lost = [path for path in anchored if path not in rig.body.by_path]
    for path in lost:
        yield whole.mesh_gone(path, len(whole.controls - known))
    # Controls go with the mesh that has their shapes; a renamed one has its own issue.
    along = layout.controls - renamed.keys() if lost else frozenset[str]()
    for element in layout.elements:
        mesh = rig.body.by_path.get(element.anchor.mesh)
        if mesh is not None:
            yield from _anchor_faults(
                rig.body, trajectories.surface, element, mesh, comparable=comparable
            )
        for member in element.members:
            if member.control not in known | along:
                now = (
                    f"; {renamed[member.control]!r} moves as it did"
                    if member.control in renamed
                    else ""
                )
                yield issue(
                    "LAYOUT_CONTROL_GONE",
                    element.name,
                    f"{rig.path} has no control {member.control!r}{now}",
                )


def reshaped(rig: Rig, layout: Layout, found: Sequence[Issue]) -> tuple[Issue, ...]:
    """`found`, behind LAYOUT_RESHAPED if most of several elements lie or move elsewhere than in the
    layout: then the character has another shape now, and what the code covers follows from that."""
    off = max(
        len({each.path for each in found if each.code == code})
        for code in ("LAYOUT_ANCHOR_MOVED", "LAYOUT_TRACK")
    )
    placed = sum(not element.anchor.on_board for element in layout.elements)
    if off == 1 or 2 * off <= placed:  # A single one may have been edited by hand.
        return tuple(found)
    covered = [e.severity for e in found if e.code in catalogue()["LAYOUT_RESHAPED"].covers]
    what = (
        f"{off} of {placed} elements lie or move elsewhere on it than in the layout, which is of an"
        f" earlier shape of it; {len(covered)} findings follow from that"
    )
    whole = issue("LAYOUT_RESHAPED", rig.path, what)
    worst = "error" if "error" in covered else whole.severity
    return (replace(whole, severity=worst), *found)


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
    elif comparable and not anchor.on_board and (off := _off(body, surface, anchor)) > NOTHING:
        found = f"its point lies {off:.1%} of the face from where it was"
        yield issue("LAYOUT_ANCHOR_MOVED", element.name, found)


def _off(body: Body, surface: BaseSurface, anchor: Anchor) -> float:
    """Distance between the anchor as recorded and as it is, over the face size."""
    here = surface.points[anchor.on(body)]
    return float(np.linalg.norm(here - anchor.position)) / surface.face_size


def unplaced(face: Face, layout: Layout, listed: frozenset[str]) -> Iterator[Issue]:
    """Controls that move something and have no element, nor are `listed` without one."""
    known = layout.controls | {left.control for left in layout.left_off}
    if not layout.proof.method:  # only the list shows what is left off by hand
        known |= listed
    new = [name for name in face.names if name not in known]
    if len(new) > 1 and not listed and not layout.proof.method:
        clause = "controls have no element, and rigUI:layout:baseControls lists none"
        yield issue("LAYOUT_CONTROL_NEW", layout.root, f"{len(new)} {clause}")
        return
    for name in new:
        yield issue("LAYOUT_CONTROL_NEW", name, "has no element and is not listed without one")


def crowded(elements: tuple[Element, ...], least: float) -> Iterator[Issue]:
    """Handles on the face nearer than `least` to each other that are drawn together."""
    placed = [element for element in elements if not element.anchor.on_board]
    if len(placed) < 2:
        return
    seen = states(elements)
    positions = np.array([element.anchor.position for element in placed])
    apart = cdist(positions, positions)
    for a, b in np.argwhere(np.triu(apart < least * (1.0 - NOTHING), 1)):
        if not seen[placed[a].name] & seen[placed[b].name]:
            continue
        between = f"{apart[a, b] / least:.2f} handle widths from {placed[b].name}"
        yield issue("LAYOUT_HANDLES_COLLIDE", placed[a].name, f"its handle is {between}")


def hidden(face: Face, elements: tuple[Element, ...]) -> Iterator[Issue]:
    """Elements whose anchor no view sees."""
    seen = face.views.anywhere
    for element in elements:
        if not seen[element.anchor.on(face.rig.body)]:
            yield issue("LAYOUT_ANCHOR_HIDDEN", element.name, "its anchor is hidden in all views")


def not_animated(rig: Rig, layout: Layout) -> Iterator[Issue]:
    """LAYOUT_NOT_ANIMATED for each element with controls that nothing moves, as no SkelAnimation
    that is bound has their weights or joints; one for the character where it has none at all."""
    still = {control.name for control in rig.controls if not _animated(rig.body, control.drive)}
    if still and len(still) == len(rig.controls):
        where = layout.root
        what = f"no SkelAnimation that is bound has any of its {len(still)} controls"
        yield issue("LAYOUT_NOT_ANIMATED", where, what)
        return
    for element in layout.elements:
        if names := sorted(element.controls & still):
            what = f"no SkelAnimation that is bound has {listed(names)}"
            yield issue("LAYOUT_NOT_ANIMATED", element.name, what)


def _animated(body: Body, drive: Drive) -> bool:
    animations = [body.channels[index].animation for index in drive.channels]
    joints = [body.joints[index] for index in drive.joints]
    return all([*animations, *(body.skeletons[joint.skeleton].animation for joint in joints)])
