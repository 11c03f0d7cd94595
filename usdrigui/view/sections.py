"""The close-ups of a character in several parts: one section a part, and one a side where a part
lies on both sides."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from usdrigui.character import Floats, Rig
from usdrigui.character.rays import AROUND, Caster, blocked, make_caster
from usdrigui.character.surface import mesh_triangles
from usdrigui.layout.parts.joint_regions import OF_SIDES
from usdrigui.model import Element, Layout, LayoutPart
from usdrigui.pose.evaluate import PosedLayout
from usdrigui.ties import first_largest
from usdrigui.view import directions

_SHOWN = 2
"""Elements of a side, at least, that has a close-up of its own: eyes look together."""
_TITLES = {"interior": "inside the mouth"}
"""What parts are called that are not called by their names."""


@dataclass(frozen=True, eq=False)
class Section:
    """What one close-up shows."""

    title: str
    layout: Layout
    """Of the elements shown, at their own handle width."""
    posed: PosedLayout
    views: tuple[Floats, ...]
    """Directions to the viewer, the first with the board."""


def sections(
    rig: Rig, layout: Layout, posed: PosedLayout, azimuth: float | None = None
) -> tuple[Section, ...]:
    """One section a part, in the order of `LayoutFrame.parts`.

    A character in one part has one without a title, seen from the layout's own view and its
    companions; with an `azimuth`, degrees from that view, so has any, seen from there alone.
    """
    up, view = rig.up, layout.frame.view
    ahead = directions.ahead_of(layout, up)
    if azimuth is not None:
        return (Section("", layout, posed, (directions.turned(view, up, azimuth),)),)
    if not layout.frame.parts:
        return (Section("", layout, posed, (view, *directions.companions(view, ahead, up))),)
    found: list[Section] = []
    caster = make_caster(posed.points[mesh_triangles(rig.body.meshes, visible_only=True)])
    mirrored = layout.frame.plane.turned
    for part in layout.frame.parts:
        own = [i for i, e in enumerate(layout.elements) if e.part == part.name]
        title = _TITLES.get(part.name, part.name)
        sides = _sides(layout.elements, own) if part.name in OF_SIDES else {}
        views = [part.view, *(() if sides else directions.companions(part.view, ahead, up))]
        for side, chosen in (sides or {"": own}).items():
            # The right side is looked at from where the left one is, in the mirror.
            views = [mirrored(view) for view in views] if side == "right" else views
            shown = [layout.elements[i] for i in chosen if not layout.elements[i].anchor.on_board]
            places = [e.anchor.position + 0.5 * part.handle_width * e.anchor.normal for e in shown]
            if places:
                axes = np.stack([np.cross(up, ahead), up, ahead])
                views = _with_hidden(views, np.array(places), axes, caster)
            whose = f"{title}, character's {side}" if side else title
            found.append(_section(layout, posed, part, chosen, whose, tuple(views)))
    return tuple(found)


def _with_hidden(
    views: list[Floats], handles: Floats, axes: Floats, caster: Caster
) -> list[Floats]:
    """The views, and the one of the directions along `axes` (3, 3) that shows most of the `handles`
    (h, 3) that they hide: beside a single view in any case another one, across it."""
    hidden = np.all([blocked(caster, handles, view) for view in views], axis=0)
    worth = hidden + (0.01 if len(views) == 1 else 0.0)
    ways = [way @ axes for way in AROUND]
    across = np.array([2.0 - abs(float(way @ views[0])) for way in ways])
    gains = across * np.array([worth @ ~blocked(caster, handles, way) for way in ways])
    best = first_largest(gains)
    return [*views, ways[best]] if gains[best] > 0.0 else views


def _section(
    layout: Layout,
    posed: PosedLayout,
    part: LayoutPart,
    chosen: list[int],
    title: str,
    views: tuple[Floats, ...],
) -> Section:
    shown = replace(
        layout,
        elements=tuple(layout.elements[i] for i in chosen),
        left_off=(),
        frame=replace(
            layout.frame,
            handle_width=part.handle_width,
            view=views[0],
            parts=(),
        ),
        proof=replace(layout.proof, status=part.status, cost=part.cost, bound=part.bound),
    )
    return Section(
        title, shown, replace(posed, elements=tuple(posed.elements[i] for i in chosen)), views
    )


def _sides(elements: tuple[Element, ...], own: list[int]) -> dict[str, list[int]]:
    """The elements of either side of a part that lies on both; the board goes with the left."""
    sides = {
        side: [i for i in own if elements[i].side == side and not elements[i].anchor.on_board]
        for side in ("left", "right")
    }
    if min(map(len, sides.values())) < _SHOWN:
        return {}
    sides["left"] = sorted({*own} - {*sides["right"]})
    return sides
