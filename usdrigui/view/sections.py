"""The close-ups of a character in several parts: one section a part, and one a side where a part
lies on both sides."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from usdrigui.character import Floats
from usdrigui.model import Element, Layout, LayoutPart, Side
from usdrigui.pose.evaluate import PosedLayout
from usdrigui.view import directions

_APART = 1.0
"""Two sides are apart when the gap between them is this many times the extent of either."""
_SHOWN = 2
"""Elements of a side, at least, that has a close-up of its own: eyes look together."""
_TITLES = {"interior": "inside the mouth"}
"""What parts are called that are not called by their names."""
_QUARTERS = {"left": (0.0, 90.0, 180.0), "right": (0.0, -90.0, 180.0)}
"""Azimuths from which a hand may be looked at: the body stands in the way of the fourth."""


@dataclass(frozen=True, eq=False)
class Section:
    """What one close-up shows."""

    title: str
    layout: Layout
    """Of the elements shown, at their own handle width."""
    posed: PosedLayout
    views: tuple[Floats, ...]
    """Directions to the viewer, the first with the board; empty for the layout's own and its
    companions."""


def undivided(layout: Layout, posed: PosedLayout) -> Section:
    """All of a character as one section without a title."""
    return Section("", layout, posed, ())


def sections(layout: Layout, posed: PosedLayout, up: Floats) -> tuple[Section, ...]:
    """One section a part, in the order of `LayoutFrame.parts`, undivided where there is one; `up`
    (3,) is that of the rig."""
    if len(layout.frame.parts) < 2:
        return (undivided(layout, posed),)
    found: list[Section] = []
    for part in layout.frame.parts:
        own = [i for i, e in enumerate(layout.elements) if e.placement.part == part.name]
        sides = _sides(layout.elements, own)
        if not sides:
            title = _TITLES.get(part.name, part.name)
            found.append(_section(layout, posed, part, own, title, ()))
        for side, chosen in sides:
            views = _best_views(part, side, [layout.elements[i] for i in chosen], up)
            found.append(
                _section(layout, posed, part, chosen, f"{part.name}, character's {side}", views)
            )
    return tuple(found)


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
            view=views[0] if views else part.view,
            parts=(),
        ),
        proof=replace(layout.proof, status=part.status, cost=part.cost, bound=part.bound),
    )
    return Section(
        title, shown, replace(posed, elements=tuple(posed.elements[i] for i in chosen)), views
    )


def _sides(elements: tuple[Element, ...], own: list[int]) -> list[tuple[Side, list[int]]]:
    """The elements of either side of a part that has nothing between them; the board goes with the
    left."""
    placed = [i for i in own if not elements[i].anchor.on_board]
    sides: list[tuple[Side, list[int]]] = []
    boxes = []
    for side in ("left", "right"):
        chosen = [i for i in placed if elements[i].look.side == side]
        places = np.array([elements[i].anchor.position for i in chosen])
        if len(places) < _SHOWN:
            return []
        boxes.append((places.min(axis=0), places.max(axis=0)))
        sides.append((side, chosen))
    extent = max(float((high - low).max()) for low, high in boxes)
    gap = max(float(np.maximum(boxes[0][0] - boxes[1][1], boxes[1][0] - boxes[0][1]).max()), 0.0)
    if len(placed) != len(sides[0][1]) + len(sides[1][1]) or gap < _APART * extent:
        return []
    board = [i for i in own if elements[i].anchor.on_board]
    return [("left", sorted(sides[0][1] + board)), sides[1]]


def _best_views(
    part: LayoutPart, side: Side, elements: list[Element], up: Floats
) -> tuple[Floats, ...]:
    """The two level directions of its side that together face the most handles, the better one
    first."""
    normals = np.array(
        [element.anchor.normal for element in elements if not element.anchor.on_board]
    )
    views = [directions.turned(part.view, up, degrees) for degrees in _QUARTERS[side]]
    facing = np.array([np.maximum(normals @ view, 0.0) for view in views])
    first = int(np.argmax(np.round(facing.sum(axis=1), 6)))
    added = np.maximum(facing, facing[first]).sum(axis=1)
    added[first] = -1.0
    return views[first], views[int(np.argmax(np.round(added, 6)))]
