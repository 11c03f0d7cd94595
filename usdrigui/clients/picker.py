"""A layout as a flat picker beside the viewport: SVG for any tool, and the JSON of dwpicker.

The layout is seen from the direction that it was made for, at its base pose, without perspective, over the
character's silhouette.  The character's elements keep their places, its board moves up to it; characters stand
side by side.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from usdrigui.markup import markup
from usdrigui.model import Element, Floats, Layout, Record, Rig
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.surface import mesh_triangles
from usdrigui.view import lettering
from usdrigui.view.overlay import colour_of, form_of
from usdrigui.view.shading import look
from usdrigui.view.silhouette import silhouette

_HANDLE = 22.0
"""Diameter of a handle, in picture units."""
_MARGIN = 40.0
_LETTER = 8.0
"""Width that is kept free for a letter of a name."""
_GAP = 1.5 * _HANDLE
"""Between the silhouette and the board, or names beside it."""
_PITCH = 20.0
"""Between names in a column."""
_AROUND, _WIDE, _HAIR, _CROWN = 0.16, 0.9, 1.4, 1.2
"""Of the silhouette: space around the elements, how far it may go to either side of their middle, level with them
and in the upper half of the head, and up from them, in heights of their box."""
_DWPICKER = [0, 12, 0]
"""Version of the dwpicker file format that is written; later ones read it and bring it up to date."""


@dataclass(frozen=True, eq=False)
class Spot(Record):
    """One element in the picture; x to the right, y down."""

    element: Element
    handle: Floats
    """(2,)."""
    tracks: tuple[Floats, ...]
    """Per member (k, 2)."""
    width: float = _HANDLE
    """Diameter of the handle, that of the part in which the element stands."""
    lead: Floats | None = None
    """(2, 2) line from the name of an element on the face to its handle, where names are asked for."""

    def moved(self, shift: Floats) -> Spot:
        """The same elsewhere."""
        lead = None if self.lead is None else self.lead + shift
        return replace(self, handle=self.handle + shift, tracks=tuple(each + shift for each in self.tracks), lead=lead)


@dataclass(frozen=True, eq=False)
class Picker(Record):
    """One or more characters in one picture."""

    size: Floats
    """(2,) width and height."""
    outlines: tuple[tuple[Floats, ...], ...]
    """Per character polygons (k, 2) around what it covers where its elements are; holes are polygons too."""
    spots: tuple[Spot, ...]


def picker(characters: Sequence[tuple[Rig, Layout]], *, labels: bool = False) -> Picker:
    """Flatten the layouts; ``labels`` names the elements on the face as well.

    Raises RigUIError LAYOUT_STALE where a layout does not belong to its rig.
    """
    outlines, spots, left, height = [], [], 0.0, 0.0
    for rig, layout in characters:
        loops, own = _flat(rig, layout, labels)
        points = np.concatenate([*loops, *(_drawn(spot) for spot in own), np.zeros((0 if own else 1, 2))])
        low, high = points.min(axis=0) - _MARGIN, points.max(axis=0) + _MARGIN
        shift = np.array([left, 0.0]) - low
        outlines.append(tuple(loop + shift for loop in loops))
        spots += [spot.moved(shift) for spot in own]
        left, height = left + float(high[0] - low[0]), max(height, float(high[1] - low[1]))
    return Picker(np.array([left, height]), tuple(outlines), tuple(spots))


def to_svg(made: Picker) -> str:
    """A stand-alone SVG: one group per element, with its controls and where it is anchored as data attributes."""
    width, height = made.size
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.2f} {height:.2f}" '
        f'width="{width:.0f}" height="{height:.0f}" font-family="sans-serif">',
        f'<rect width="{width:.2f}" height="{height:.2f}" fill="#f4f5f6"/>',
    ]
    lines += [
        f'<path d="{_path(each)}" fill="#e4e6e9" fill-rule="evenodd" stroke="#c8ccd1"/>' for each in made.outlines
    ]
    leads = [spot.lead for spot in made.spots if spot.lead is not None]
    lines += [f'<path d="M{_points(lead)}" fill="none" stroke="#969ba3" stroke-width="1"/>' for lead in leads]
    for spot in made.spots:
        lines += _group(spot)
    return "\n".join([*lines, "</svg>"]) + "\n"


def to_dwpicker(made: Picker, name: str) -> str:
    """A dwpicker file: one button per element, which selects what is called like the element's controls."""
    width, height = (float(round(each, 2)) for each in made.size)
    shapes = [_shape("square", (0.0, 0.0, width, height), "#3c4046", background=True)]
    for spot in made.spots:
        width = float(round(spot.width, 2))
        x, y = (float(round(each - 0.5 * width, 2)) for each in spot.handle)
        form = "round" if spot.element.kind == "slider" else "square"
        button = _shape(form, (x, y, width, width), _hex(spot.element))
        button["action.targets"] = [member.control for member in spot.element.members]
        label = _shape("square", (x + width, y, 8.0 * len(spot.element.label) + 8.0, width), "#000000")
        label |= {"text.content": spot.element.label, "bgcolor.transparency": 255, "border": False, "background": True}
        shapes += [label, button]
    general = {"name": name, "version": _DWPICKER, "zoom_locked": False, "width": width, "height": height}
    return json.dumps({"general": general, "shapes": shapes}, indent=2, ensure_ascii=False) + "\n"


# --- geometry ----------------------------------------------------------------------------------------


def _flat(rig: Rig, layout: Layout, labels: bool) -> tuple[tuple[Floats, ...], list[Spot]]:
    """Silhouette and elements of one character, the handles of its main part `_HANDLE` wide."""
    posed = evaluate(prepare(rig, layout))
    # Pictures have y down.
    plane = look(layout.view, rig.up)[:2].T * np.array([1.0, -1.0]) * (_HANDLE / layout.handle_width)
    spots = [
        Spot(
            element,
            at.handle @ plane,
            tuple(track @ plane for track in at.tracks),
            _HANDLE * layout.handle_width_of(element) / layout.handle_width,
        )
        for element, at in zip(layout.elements, posed.elements, strict=True)
    ]
    corners = mesh_triangles(rig.meshes, visible_only=True)
    corners = corners if len(corners) else mesh_triangles(rig.meshes)
    flat = posed.points @ plane
    low, high = _region(spots, flat[np.unique(corners)])
    loops = silhouette(flat, corners, low, high)
    spots = _named(spots, low, high) if labels else spots
    return loops, _with_board(spots, loops, low, high)


def _region(spots: list[Spot], skin: Floats) -> tuple[Floats, Floats]:
    """Corners (2,) of the part of the character that is shown: the head, or whatever holds the elements."""
    face = [spot for spot in spots if not spot.element.anchor.on_board] or spots
    around = np.concatenate([*(np.vstack([spot.handle, *spot.tracks]) for spot in face), skin[: 0 if face else 1]])
    low, high = around.min(axis=0), around.max(axis=0)
    tall, middle = max(float(high[1] - low[1]), 8.0 * _HANDLE), 0.5 * float(low[0] + high[0])
    low, high = low - _AROUND * tall, high + _AROUND * tall
    skin = skin[np.isfinite(skin).all(axis=1)]
    column = skin[np.abs(skin[:, 0] - middle) <= _WIDE * tall, 1]
    crown = max(float(column.min(initial=low[1])), low[1] - _CROWN * tall)
    for lowest, widest in ((float(high[1]), _WIDE), (0.5 * float(low[1] + high[1]), _HAIR)):
        # Shoulders are below, and need not be whole; hair and ears should be.
        level = skin[(skin[:, 1] >= crown) & (skin[:, 1] <= lowest), 0]
        low[0] = min(low[0], max(float(level.min(initial=low[0])), middle - widest * tall))
        high[0] = max(high[0], min(float(level.max(initial=high[0])), middle + widest * tall))
    return np.array([low[0], min(crown, low[1])]) - 2.0, high + 2.0


def _named(spots: list[Spot], low: Floats, high: Floats) -> list[Spot]:
    """The spots with names on the face in columns left and right of the region."""
    face = [index for index, spot in enumerate(spots) if not spot.element.anchor.on_board]
    columns = lettering.sides([float(spots[i].handle[0]) for i in face], [spots[i].element.name for i in face])
    named = list(spots)
    for column, edge in zip(columns, (low[0] - _GAP, high[0] + _GAP), strict=True):
        ordered = sorted((face[i] for i in column), key=lambda i: (float(spots[i].handle[1]), spots[i].element.name))
        rows = lettering.spread(np.array([float(spots[i].handle[1]) for i in ordered]), _PITCH, low[1], high[1])
        handles = np.array([spots[i].handle for i in ordered]).reshape(-1, 2)
        for which, row in zip(lettering.uncrossed(handles, float(edge), rows), rows, strict=True):
            own = spots[ordered[which]]
            named[ordered[which]] = replace(own, lead=np.array([[edge, row], own.handle]))
    return named


def _with_board(spots: list[Spot], loops: tuple[Floats, ...], low: Floats, high: Floats) -> list[Spot]:
    """The spots with the board next to the silhouette and names there, at a height where the character is."""
    board = [_drawn(spot) for spot in spots if spot.element.anchor.on_board]
    if not board:
        return spots
    top_left, end = np.concatenate(board).min(axis=0), np.concatenate(board).max(axis=0)
    outline = np.concatenate([*(_dense(loop) for loop in loops), np.zeros((0, 2))])
    bottom = float(outline[:, 1].max()) if len(outline) else float(high[1])
    down = max(min(0.0, bottom - float(end[1])), float(low[1] - top_left[1]))
    level = outline[(outline[:, 1] >= top_left[1] + down - _GAP) & (outline[:, 1] <= end[1] + down + _GAP), 0]
    face = [_drawn(spot)[:, 0].max() for spot in spots if not spot.element.anchor.on_board]
    shift = np.array([max(float(level.max(initial=-np.inf)), *face, -np.inf) + _GAP - top_left[0], down])
    if not np.isfinite(shift).all():
        return spots
    return [spot.moved(shift) if spot.element.anchor.on_board else spot for spot in spots]


def _drawn(spot: Spot) -> Floats:
    """(k, 2) points around everything drawn of an element."""
    points = [np.vstack([spot.handle - 0.5 * spot.width, spot.handle + 0.5 * spot.width, *spot.tracks])]
    wide = np.array([_LETTER * len(spot.element.label), 0.0])
    if spot.element.anchor.on_board:
        place = _label_place(spot)
        points.append(np.vstack([place - [0.0, _LETTER], place + wide]))
    if spot.lead is not None:
        outward = -1.0 if spot.lead[0, 0] < spot.handle[0] else 1.0
        points.append(np.vstack([spot.lead[0] - [0.0, 0.5 * _PITCH], spot.lead[0] + outward * wide]))
    return np.concatenate(points)


def _label_place(spot: Spot) -> Floats:
    """(2,) where the name of an element on the board begins: above all of it."""
    around = np.vstack([spot.handle - 0.5 * spot.width, *spot.tracks])
    return np.asarray(around.min(axis=0) - [0.0, 6.0])


def _dense(loop: Floats) -> Floats:
    """Points along a closed polygon, dense enough to tell how far it goes at any height."""
    share = np.linspace(0.0, 1.0, 33)[:, None, None]
    return np.asarray(((1.0 - share) * loop + share * np.roll(loop, -1, axis=0)).reshape(-1, 2))


# --- SVG ---------------------------------------------------------------------------------------------


def _group(spot: Spot) -> list[str]:
    element, anchor = spot.element, spot.element.anchor
    controls = [member.control for member in element.members]
    facts = {
        "id": element.name,
        "data-controls": json.dumps(controls, ensure_ascii=False),
        "data-kind": element.kind,
        "data-side": element.side,
        "data-mirror": element.mirror,
        "data-anchor": f"{anchor.mesh}#{anchor.point}",
        "data-board": str(anchor.on_board).lower(),
    }
    attributes = " ".join(f'{name}="{markup(value)}"' for name, value in facts.items())
    lines = [f"<g {attributes}>"]
    lines.append(f"<title>{markup(element.label)}: {markup(', '.join(controls))}</title>")
    for member, track in zip(element.members, spot.tracks, strict=True):
        lines.append(
            f'<polyline data-control="{markup(member.control)}" points="{_points(track)}" fill="none" '
            f'stroke="{_hex(element)}" stroke-width="4" stroke-linecap="round" stroke-linejoin="round"/>'
        )
    lines.append(_handle(spot))
    if spot.lead is not None:
        (x, y), side = spot.lead[0], "end" if spot.lead[0, 0] < spot.handle[0] else "start"
        x += 4.0 if side == "start" else -4.0
        lines.append(
            f'<text x="{x:.2f}" y="{y + 5.0:.2f}" font-size="14" text-anchor="{side}">{markup(element.label)}</text>'
        )
    if anchor.on_board:
        x, y = _label_place(spot)
        lines.append(f'<text x="{x:.2f}" y="{y:.2f}" font-size="14">{markup(element.label)}</text>')
    return [*lines, "</g>"]


def _handle(spot: Spot) -> str:
    (x, y), r = spot.handle, 0.5 * spot.width
    style = f'fill="{_hex(spot.element)}" stroke="#ffffff" stroke-width="2"'
    form = form_of(spot.element)
    if form in ("patch", "joystick"):
        return f'<rect x="{x - r:.2f}" y="{y - r:.2f}" width="{2 * r:.2f}" height="{2 * r:.2f}" rx="4" {style}/>'
    if form == "fan":
        corners = np.array([[x, y - r], [x + r, y], [x, y + r], [x - r, y]])
        return f'<polygon points="{_points(corners)}" {style}/>'
    return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{r:.2f}" {style}/>'


def _points(points: Floats) -> str:
    return " ".join(f"{x:.2f},{y:.2f}" for x, y in points)


def _path(loops: tuple[Floats, ...]) -> str:
    return " ".join(f"M{_points(loop)}Z" for loop in loops)


def _hex(element: Element) -> str:
    return "#{:02x}{:02x}{:02x}".format(*colour_of(element))


# --- dwpicker ----------------------------------------------------------------------------------------


def _shape(
    form: str, place: tuple[float, float, float, float], colour: str, *, background: bool = False
) -> dict[str, Any]:
    """One shape with every key that the format asks for."""
    left, top, width, height = place
    return {
        "background": background,
        "visibility_layer": None,
        "shape": form,
        "shape.left": left,
        "shape.top": top,
        "shape.width": width,
        "shape.height": height,
        "shape.cornersx": 4,
        "shape.cornersy": 4,
        "border": not background,
        **{f"borderwidth.{state}": width for state, width in (("normal", 1.0), ("hovered", 1.25), ("clicked", 2.0))},
        **dict.fromkeys(("bordercolor.normal", "bordercolor.hovered", "bordercolor.clicked"), "#ffffff"),
        "bordercolor.transparency": 0,
        **dict.fromkeys(("bgcolor.normal", "bgcolor.hovered", "bgcolor.clicked"), colour),
        "bgcolor.transparency": 0,
        "text.content": "",
        "text.size": 11,
        "text.bold": False,
        "text.italic": False,
        "text.color": "#ffffff",
        "text.valign": "center",
        "text.halign": "left",
        "action.targets": [],
        "action.commands": [],
        "action.menu_commands": [],
        "image.path": "",
        "image.fit": False,
        "image.height": 32,
        "image.width": 32,
    }
