"""A layout as a flat picker beside the viewport: SVG for any tool, and the JSON of dwpicker.

The layout is seen from the direction that it was made for, at its base pose, without perspective.  The
character's elements keep their places; characters stand side by side.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from xml.sax.saxutils import escape, quoteattr

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from usdrigui.model import Element, Floats, Layout, Record, Rig
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.view.overlay import colour_of, form_of
from usdrigui.view.shading import look

_HANDLE = 22.0
"""Diameter of a handle, in picture units."""
_MARGIN = 40.0
_LETTER = 8.0
"""Width that is kept free for a letter of a name."""
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


@dataclass(frozen=True, eq=False)
class Picker(Record):
    """One or more characters in one picture."""

    size: Floats
    """(2,) width and height."""
    outlines: tuple[Floats, ...]
    """Per character (k, 2): around the points on which its elements stand and those between them."""
    spots: tuple[Spot, ...]


def picker(characters: Sequence[tuple[Rig, Layout]]) -> Picker:
    """Flatten the layouts; raises RigUIError LAYOUT_STALE where a layout does not belong to its rig."""
    outlines, spots, left, height = [], [], 0.0, 0.0
    for rig, layout in characters:
        flat = _flat(rig, layout)
        points = np.concatenate([flat[0], *(_drawn(spot) for spot in flat[1])])
        low, high = points.min(axis=0) - _MARGIN, points.max(axis=0) + _MARGIN
        shift = np.array([left, 0.0]) - low
        outlines.append(flat[0] + shift)
        spots += [
            Spot(each.element, each.handle + shift, tuple(track + shift for track in each.tracks)) for each in flat[1]
        ]
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
    lines += [f'<polygon points="{_points(each)}" fill="#e4e6e9" stroke="#c8ccd1"/>' for each in made.outlines]
    for spot in made.spots:
        lines += _group(spot)
    return "\n".join([*lines, "</svg>"]) + "\n"


def to_dwpicker(made: Picker, name: str) -> str:
    """A dwpicker file: one button per element, which selects what is called like the element's controls."""
    width, height = (float(round(each, 2)) for each in made.size)
    shapes = [_shape("square", (0.0, 0.0, width, height), "#3c4046", background=True)]
    for spot in made.spots:
        x, y = (float(round(each - 0.5 * _HANDLE, 2)) for each in spot.handle)
        form = "round" if spot.element.kind == "slider" else "square"
        button = _shape(form, (x, y, _HANDLE, _HANDLE), _hex(spot.element))
        button["action.targets"] = [member.control for member in spot.element.members]
        label = _shape("square", (x + _HANDLE, y, 8.0 * len(spot.element.label) + 8.0, _HANDLE), "#000000")
        label |= {"text.content": spot.element.label, "bgcolor.transparency": 255, "border": False, "background": True}
        shapes += [label, button]
    general = {"name": name, "version": _DWPICKER, "zoom_locked": False, "width": width, "height": height}
    return json.dumps({"general": general, "shapes": shapes}, indent=2, ensure_ascii=False) + "\n"


# --- geometry ----------------------------------------------------------------------------------------


def _flat(rig: Rig, layout: Layout) -> tuple[Floats, list[Spot]]:
    """Outline and elements of one character, one handle width being `_HANDLE`."""
    posed = evaluate(prepare(rig, layout))
    # Pictures have y down.
    plane = look(layout.view, rig.up)[:2].T * np.array([1.0, -1.0]) * (_HANDLE / layout.handle_width)
    spots = [
        Spot(element, at.handle @ plane, tuple(track @ plane for track in at.tracks))
        for element, at in zip(layout.elements, posed.elements, strict=True)
    ]
    face = [spot for spot in spots if not spot.element.anchor.beside]
    around = np.concatenate([np.vstack([spot.handle, *spot.tracks]) for spot in face or spots] or [np.zeros((1, 2))])
    points = posed.points[np.isfinite(posed.points).all(axis=1)] @ plane
    low, high = around.min(axis=0) - 2.0 * _HANDLE, around.max(axis=0) + 2.0 * _HANDLE
    near = points[((points >= low) & (points <= high)).all(axis=1)]
    return _hull(np.concatenate([near, around])), spots


def _drawn(spot: Spot) -> Floats:
    """(k, 2) points around everything drawn of an element."""
    label = _label_place(spot) + np.array([_LETTER * len(spot.element.label), 0.0])
    return np.vstack([spot.handle, *spot.tracks, *([label] if spot.element.anchor.beside else [])])


def _label_place(spot: Spot) -> Floats:
    """(2,) where the name of an element beside the face begins: above all of it."""
    around = np.vstack([spot.handle - 0.5 * _HANDLE, *spot.tracks])
    return np.asarray(around.min(axis=0) - [0.0, 6.0])


def _hull(points: Floats) -> Floats:
    """(k, 2) convex outline; the points themselves where they span no area."""
    try:
        return np.asarray(points[ConvexHull(points).vertices])
    except (QhullError, ValueError):
        return points[:2]


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
        "data-beside": str(anchor.beside).lower(),
    }
    lines = [f"<g {' '.join(f'{name}={quoteattr(value)}' for name, value in facts.items())}>"]
    lines.append(f"<title>{escape(element.label)}: {escape(', '.join(controls))}</title>")
    for member, track in zip(element.members, spot.tracks, strict=True):
        lines.append(
            f'<polyline data-control={quoteattr(member.control)} points="{_points(track)}" fill="none" '
            f'stroke="{_hex(element)}" stroke-width="4" stroke-linecap="round" stroke-linejoin="round"/>'
        )
    lines.append(_handle(spot))
    if anchor.beside:
        x, y = _label_place(spot)
        lines.append(f'<text x="{x:.2f}" y="{y:.2f}" font-size="14">{escape(element.label)}</text>')
    return [*lines, "</g>"]


def _handle(spot: Spot) -> str:
    (x, y), r = spot.handle, 0.5 * _HANDLE
    style = f'fill="{_hex(spot.element)}" stroke="#ffffff" stroke-width="2"'
    form = form_of(spot.element)
    if form == "patch":
        return f'<rect x="{x - r:.2f}" y="{y - r:.2f}" width="{2 * r:.2f}" height="{2 * r:.2f}" rx="4" {style}/>'
    if form == "fan":
        corners = np.array([[x, y - r], [x + r, y], [x, y + r], [x - r, y]])
        return f'<polygon points="{_points(corners)}" {style}/>'
    return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{r:.2f}" {style}/>'


def _points(points: Floats) -> str:
    return " ".join(f"{x:.2f},{y:.2f}" for x, y in points)


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
