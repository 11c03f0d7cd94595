"""A layout as a flat picker beside the viewport: SVG for any tool, and the JSON of dwpicker.

Each part of a character is seen from the direction that it was laid out for, at the base pose,
without perspective, over a picture of it.  Elements keep their places but where handles would lie
on each other; the board is in rows beside it.  Parts and characters are in rows.
"""

from __future__ import annotations

import base64
import io
import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from PIL import Image

from usdrigui.model import Element, Floats, Layout, Record, Rig
from usdrigui.pose.evaluate import PosedLayout, evaluate, prepare
from usdrigui.report.markup import markup
from usdrigui.view import lettering, shading
from usdrigui.view.complexion import complexion
from usdrigui.view.overlay import colour_of, form_of
from usdrigui.view.sections import cut_away, main_layout, sections
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
"""Of the silhouette: space around the elements, how far it may go to either side of their middle,
level with them and in the upper half of the head, and up from them, in heights of their box."""
_FINENESS = 720
"""Pixels along the longer side of a backdrop."""
_VEIL = 0.55
"""Share of the paper in a backdrop, so that handles stand out from it."""
_PAPER = np.array([244.0, 245.0, 246.0])
_APART = 1.1
"""Least distance of handles, in their diameters."""
_LARGEST = 72.0
"""Longer side of what is shown of a part, in handles; a larger one is shown smaller."""
_ROUNDS = 400
"""Of pushing rectangles apart, at most."""
_ROW_TRACK = 3.0
"""Longest track in a row of the board, in handles."""
_ACROSS = 2.6
"""Widths of a row of panels, in heights of the tallest, before another one begins."""
_BUTTON, _BUTTON_LETTER, _BUTTON_SCALE = 18.0, 6.2, 1.8
"""Of a dwpicker file: height of a button, width of a letter on it, and how much larger the whole is
for their sake."""
_DWPICKER = [0, 12, 0]
"""Version of the dwpicker file format that is written; later ones read it and bring it up to
date."""


@dataclass(frozen=True, eq=False)
class Spot(Record):
    """One element in the picture; x to the right, y down."""

    element: Element
    handle: Floats
    """(2,)."""
    tracks: tuple[Floats, ...]
    """Per member (k, 2)."""
    lead: Floats | None = None
    """(2, 2) line from the name of an element on the face to its handle, where names are asked
    for."""

    @property
    def around(self) -> Floats:
        """(2, 2) corners of the box around handle and tracks."""
        points = np.vstack([self.handle - 0.5 * _HANDLE, self.handle + 0.5 * _HANDLE, *self.tracks])
        return np.stack([points.min(axis=0), points.max(axis=0)])

    def moved(self, shift: Floats) -> Spot:
        """The same elsewhere."""
        lead = None if self.lead is None else self.lead + shift
        return replace(
            self,
            handle=self.handle + shift,
            tracks=tuple(each + shift for each in self.tracks),
            lead=lead,
        )


@dataclass(frozen=True, eq=False)
class Backdrop(Record):
    """What a part of a character looks like, behind its elements."""

    low: Floats
    """(2,) upper left corner in the picture."""
    high: Floats
    outline: tuple[Floats, ...]
    """Polygons (k, 2) around what it covers; holes are polygons too."""
    image: Image.Image
    """RGBA, clear beside the character."""
    title: str
    """Of one of several parts."""

    def moved(self, shift: Floats) -> Backdrop:
        """The same elsewhere."""
        outline = tuple(loop + shift for loop in self.outline)
        return replace(self, low=self.low + shift, high=self.high + shift, outline=outline)


@dataclass(frozen=True, eq=False)
class Picker(Record):
    """One or more characters in one picture."""

    size: Floats
    """(2,) width and height."""
    backdrops: tuple[Backdrop, ...]
    """One a part of a character."""
    spots: tuple[Spot, ...]


def picker(characters: Sequence[tuple[Rig, Layout]], *, labels: bool = False) -> Picker:
    """Flatten the layouts; ``labels`` names the elements on the face as well.

    Raises RigUIError LAYOUT_STALE where a layout does not belong to its rig.
    """
    panels = [panel for rig, layout in characters for panel in _panels(rig, layout, labels)]
    boxes = [_box(panel) for panel in panels]
    wide = _ACROSS * max((float(high[1] - low[1]) for low, high in boxes), default=0.0)
    backdrops, spots, at, row, size = [], [], np.zeros(2), 0.0, np.zeros(2)
    for (backdrop, own), (low, high) in zip(panels, boxes, strict=True):
        if at[0] > 0.0 and at[0] + high[0] - low[0] > wide:
            at, row = np.array([0.0, at[1] + row]), 0.0
        backdrops.append(backdrop.moved(at - low))
        spots += [spot.moved(at - low) for spot in own]
        row = max(row, float(high[1] - low[1]))
        size = np.maximum(size, at + high - low)
        at = np.array([at[0] + high[0] - low[0], at[1]])
    return Picker(size, tuple(backdrops), tuple(spots))


def to_svg(made: Picker) -> str:
    """A stand-alone SVG: one group per element, with its controls and where it is anchored as data
    attributes."""
    width, height = made.size
    lines = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.2f} {height:.2f}" '
            f'width="{width:.0f}" height="{height:.0f}" font-family="sans-serif">'
        ),
        f'<rect width="{width:.2f}" height="{height:.2f}" fill="#f4f5f6"/>',
    ]
    for each in made.backdrops:
        lines += _backdrop(each)
    leads = [spot.lead for spot in made.spots if spot.lead is not None]
    lines += [
        f'<path d="M{_points(lead)}" fill="none" stroke="#969ba3" stroke-width="1"/>'
        for lead in leads
    ]
    for spot in made.spots:
        lines += _group(spot)
    return "\n".join([*lines, "</svg>"]) + "\n"


def to_dwpicker(made: Picker, name: str, background: str = "") -> str:
    """A dwpicker file: one named button per element, which selects what is called like the
    element's controls.

    ``background`` is the path of the picture that `background_png` gives, as dwpicker is to find
    it.
    """
    width, height = (float(round(_BUTTON_SCALE * each, 2)) for each in made.size)
    behind = _shape("square", (0.0, 0.0, width, height), "#3c4046", background=True)
    shapes = [
        behind
        | {
            "image.path": background,
            "image.fit": True,
            "image.width": width,
            "image.height": height,
        }
    ]
    for spot, (left, top, wide, high) in zip(made.spots, _buttons(made), strict=True):
        place = (
            float(round(left, 2)),
            float(round(top, 2)),
            float(round(wide, 2)),
            float(round(high, 2)),
        )
        form = "rounded_rect" if spot.element.manipulator.kind == "slider" else "square"
        button = _shape(form, place, _hex(spot.element))
        button["action.targets"] = [member.control for member in spot.element.manipulator.members]
        shapes.append(
            button | {"text.content": spot.element.look.label, "text.color": _ink(spot.element)}
        )
    general = {
        "name": name,
        "version": _DWPICKER,
        "zoom_locked": False,
        "width": width,
        "height": height,
    }
    return json.dumps({"general": general, "shapes": shapes}, indent=2, ensure_ascii=False) + "\n"


def background_png(made: Picker) -> bytes:
    """All backdrops as one picture of the picker's proportions."""
    share = min(1.0, 2.0 * _FINENESS / float(made.size.max()))
    page = Image.new(
        "RGB",
        tuple(np.maximum(np.rint(share * made.size), 1).astype(int).tolist()),
        (244, 245, 246),
    )
    for each in made.backdrops:
        size = np.maximum(np.rint(share * (each.high - each.low)), 1).astype(int)
        image = each.image.resize((int(size[0]), int(size[1])))
        page.paste(image, tuple(np.rint(share * each.low).astype(int).tolist()), image)
    return _png(page)


# --- rectangles that do not overlap ---------------------------------------------------------------


def spread(centres: Floats, sizes: Floats) -> Floats:
    """(n, 2) centres of rectangles of ``sizes`` (n, 2), moved as little as it takes until none
    overlaps another.

    Pairs that overlap are pushed apart along the axis on which less is missing, the first to the
    left or up where they coincide; what a crowd still holds then is moved down.
    """
    at = centres.astype(np.float64)
    first, second = np.triu_indices(len(at), 1)
    least = 0.5 * (sizes[first] + sizes[second])
    for _ in range(_ROUNDS):
        apart = at[second] - at[first]
        missing = least - np.abs(apart)
        over = np.flatnonzero((missing > 1e-6).all(axis=1))
        if not len(over):
            break
        axis = np.argmin(missing[over], axis=1)
        push = 0.5 * (missing[over, axis] + 1e-3) * np.where(apart[over, axis] < 0.0, -1.0, 1.0)
        moved, count = np.zeros_like(at), np.zeros_like(at)
        for ends, sign in ((first[over], -1.0), (second[over], 1.0)):
            np.add.at(moved, (ends, axis), sign * push)
            np.add.at(count, (ends, axis), 1.0)
        at += moved / np.maximum(count, 1.0)
    return _cleared(at, sizes)


def _cleared(at: Floats, sizes: Floats) -> Floats:
    """(n, 2) the same, from above to below each moved down past those above that it overlaps
    still."""
    order = np.lexsort((at[:, 0], at[:, 1]))
    for k, index in enumerate(order):
        above = order[:k]
        least = 0.5 * (sizes[above] + sizes[index])
        while (over := (least - np.abs(at[above] - at[index]) > 1e-6).all(axis=1)).any():
            at[index, 1] = (at[above, 1] + least[:, 1])[over].max() + 1e-6
    return at


# --- geometry -------------------------------------------------------------------------------------


Panel = tuple[Backdrop, list[Spot]]


def _panels(rig: Rig, layout: Layout, labels: bool) -> list[Panel]:
    """One panel a part of a character."""
    up = rig.skel_root.up
    posed = evaluate(prepare(rig, layout))
    colours = complexion(rig, main_layout(layout))
    whole = shading.subject_of(rig.body.meshes, posed.points, colours)
    if len(layout.frame.parts) < 2:
        return [_panel(up, layout, posed, whole, "", labels)]
    panels = []
    for each in sections(layout, posed, up):
        own = cut_away(rig, each.layout, colours)
        seen = whole if own is colours else shading.subject_of(rig.body.meshes, posed.points, own)
        panels.append(_panel(up, each.layout, each.posed, seen, each.title, labels))
    return panels


def _panel(
    up: Floats,
    layout: Layout,
    posed: PosedLayout,
    subject: shading.Subject,
    title: str,
    labels: bool,
) -> Panel:
    """What is seen of a part, one handle width being `_HANDLE`."""
    rows, scale = look(layout.frame.view, up), _HANDLE / layout.frame.handle_width
    plane = rows[:2].T * np.array([1.0, -1.0]) * scale  # pictures have y down
    corners = subject.corners
    skin = posed.points[np.unique(corners)]
    low, high = _region(_spots(layout.elements, posed, plane), skin @ plane)
    smaller = min(1.0, _LARGEST * _HANDLE / max(float((high - low).max()), 1e-9))
    plane, scale, low, high = smaller * plane, smaller * scale, smaller * low, smaller * high
    spots, flat = _spots(layout.elements, posed, plane), posed.points @ plane
    image = _picture(subject, rows, scale, low, high)
    backdrop = Backdrop(low, high, silhouette(flat, corners, low, high), image, title)
    spots = _apart(spots)
    spots = _named(spots, low, high) if labels else spots
    return backdrop, _with_board(spots, backdrop)


def _spots(elements: tuple[Element, ...], posed: PosedLayout, plane: Floats) -> list[Spot]:
    return [
        Spot(element, at.handle @ plane, tuple(track @ plane for track in at.tracks))
        for element, at in zip(elements, posed.elements, strict=True)
    ]


def _picture(
    subject: shading.Subject, rows: Floats, scale: float, low: Floats, high: Floats
) -> Image.Image:
    """What is seen of the body in a rectangle of the plane, paler than it is, RGBA."""
    share = min(1.0, _FINENESS / float((high - low).max()))
    width, height = (int(each) for each in np.maximum(np.rint(share * (high - low)), 1))
    centre = 0.5 * (low + high) * [1.0, -1.0] / scale
    shaded = shading.shade(
        subject, shading.Camera(rows, centre @ rows[:2], share * scale, width, height)
    )
    colour = (1.0 - _VEIL) * 255.0 * shading.encoded(shaded.colour) + _VEIL * _PAPER
    pixels = np.concatenate([colour, 255.0 * shaded.cover[..., None]], axis=2)
    return Image.fromarray(pixels.round().clip(0.0, 255.0).astype(np.uint8), "RGBA")


def _apart(spots: list[Spot]) -> list[Spot]:
    """The spots with no handle of the face on another; tracks go with their handles."""
    face = [i for i, spot in enumerate(spots) if not spot.element.anchor.on_board]
    if not face:
        return spots
    places = np.array([spots[i].handle for i in face])
    moved = list(spots)
    for i, shift in zip(
        face, spread(places, np.full(places.shape, _APART * _HANDLE)) - places, strict=True
    ):
        moved[i] = spots[i].moved(shift)
    return moved


def _region(spots: list[Spot], skin: Floats) -> tuple[Floats, Floats]:
    """Corners (2,) of the part of the character that is shown: the head, or whatever holds the
    elements."""
    face = [spot for spot in spots if not spot.element.anchor.on_board] or spots
    around = np.concatenate(
        [*(np.vstack([spot.handle, *spot.tracks]) for spot in face), skin[: 0 if face else 1]]
    )
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
    columns = lettering.sides(
        [float(spots[i].handle[0]) for i in face], [spots[i].element.name for i in face]
    )
    named = list(spots)
    for column, edge in zip(columns, (low[0] - _GAP, high[0] + _GAP), strict=True):
        ordered = sorted(
            (face[i] for i in column),
            key=lambda i: (float(spots[i].handle[1]), spots[i].element.name),
        )
        rows = lettering.spread(
            np.array([float(spots[i].handle[1]) for i in ordered]), _PITCH, low[1], high[1]
        )
        handles = np.array([spots[i].handle for i in ordered]).reshape(-1, 2)
        for which, row in zip(lettering.uncrossed(handles, float(edge), rows), rows, strict=True):
            own = spots[ordered[which]]
            named[ordered[which]] = replace(own, lead=np.array([[edge, row], own.handle]))
    return named


def _with_board(spots: list[Spot], backdrop: Backdrop) -> list[Spot]:
    """The spots with the board in rows, to the right of the character and of the names there."""
    board = [i for i, spot in enumerate(spots) if spot.element.anchor.on_board]
    face = [_drawn(spot) for i, spot in enumerate(spots) if i not in set(board)]
    right = max(
        (float(points[:, 0].max()) for points in (*backdrop.outline, *face)),
        default=float(backdrop.low[0]),
    )
    tallest = max(float(backdrop.high[1] - backdrop.low[1]), 8.0 * _HANDLE)
    column, top, wide, placed = right + _GAP, 0.0, 0.0, list(spots)
    for i in board:
        small = _in_a_row(spots[i])
        low, high = small.around
        high_enough = float(high[1] - low[1]) + 6.0
        if top > 0.0 and top + high_enough > tallest:
            column, top, wide = column + wide + _GAP, 0.0, 0.0
        placed[i] = small.moved(np.array([column, float(backdrop.low[1]) + top]) - low)
        top += high_enough
        wide = max(wide, float(np.ptp(_drawn(small)[:, 0])))
    return placed


def _in_a_row(spot: Spot) -> Spot:
    """An element of the board with its tracks no longer than a row holds."""
    extent = float(np.ptp(np.vstack([spot.handle, *spot.tracks]), axis=0).max())
    share = min(1.0, _ROW_TRACK * _HANDLE / max(extent, 1e-9))
    return replace(
        spot, tracks=tuple(spot.handle + share * (track - spot.handle) for track in spot.tracks)
    )


def _box(panel: Panel) -> tuple[Floats, Floats]:
    """Corners (2,) around everything drawn of a panel, with a margin and room for its title."""
    backdrop, spots = panel
    corners = np.stack([backdrop.low, backdrop.high]) if not backdrop.outline else np.zeros((0, 2))
    points = np.concatenate([*backdrop.outline, *(_drawn(spot) for spot in spots), corners])
    head = np.array([0.0, _PITCH if backdrop.title else 0.0])
    return points.min(axis=0) - _MARGIN - head, points.max(axis=0) + _MARGIN


def _drawn(spot: Spot) -> Floats:
    """(k, 2) points around everything drawn of an element."""
    points = list(spot.around)
    wide = np.array([_LETTER * len(spot.element.look.label), 0.0])
    if spot.element.anchor.on_board:
        points += [_label_place(spot), _label_place(spot) + wide]
    if spot.lead is not None:
        outward = -1.0 if spot.lead[0, 0] < spot.handle[0] else 1.0
        points += [spot.lead[0] - [0.0, 0.5 * _PITCH], spot.lead[0] + outward * wide]
    return np.array(points)


def _label_place(spot: Spot) -> Floats:
    """(2,) where the name of an element on the board begins: to the right of all of it."""
    low, high = spot.around
    return np.array([high[0] + 8.0, 0.5 * (low[1] + high[1]) + 5.0])


def _buttons(made: Picker) -> Floats:
    """(n, 4) left, top, width and height of a named button per element, none of which overlaps
    another."""
    if not made.spots:
        return np.zeros((0, 4))
    wide = [
        max(_BUTTON, _BUTTON_LETTER * len(spot.element.look.label) + 10.0) for spot in made.spots
    ]
    sizes = np.stack([np.array(wide), np.full(len(wide), _BUTTON)], axis=1)
    at = spread(_BUTTON_SCALE * np.array([spot.handle for spot in made.spots]), sizes + 2.0)
    return np.concatenate([at - 0.5 * sizes, sizes], axis=1)


# --- SVG ------------------------------------------------------------------------------------------


def _backdrop(each: Backdrop) -> list[str]:
    """The character behind its elements: outline, picture, and the name of the part above."""
    (left, top), (width, height) = each.low, each.high - each.low
    shown = base64.b64encode(_png(each.image)).decode("ascii")
    lines = [
        f'<path d="{_path(each.outline)}" fill="#e4e6e9" fill-rule="evenodd" stroke="#c8ccd1"/>'
    ]
    lines.append(
        f'<image x="{left:.2f}" y="{top:.2f}" width="{width:.2f}" height="{height:.2f}"'
        f' preserveAspectRatio="none" href="data:image/png;base64,{shown}"/>'
    )
    if each.title:
        left = min((float(loop[:, 0].min()) for loop in each.outline), default=float(left))
        lines.append(
            f'<text x="{left:.2f}" y="{top - 8.0:.2f}" font-size="16"'
            f' fill="#565b63">{markup(each.title)}</text>'
        )
    return lines


def _png(image: Image.Image) -> bytes:
    stream = io.BytesIO()
    image.save(stream, "PNG", optimize=True)
    return stream.getvalue()


def _group(spot: Spot) -> list[str]:
    element, anchor = spot.element, spot.element.anchor
    manipulator, label = element.manipulator, markup(element.look.label)
    controls = [member.control for member in manipulator.members]
    facts = {
        "id": element.name,
        "data-controls": json.dumps(controls, ensure_ascii=False),
        "data-kind": manipulator.kind,
        "data-side": element.look.side,
        "data-mirror": manipulator.mirror,
        "data-anchor": f"{anchor.mesh}#{anchor.point}",
        "data-board": str(anchor.on_board).lower(),
    }
    attributes = " ".join(f'{name}="{markup(value)}"' for name, value in facts.items())
    lines = [f"<g {attributes}>"]
    lines.append(f"<title>{label}: {markup(', '.join(controls))}</title>")
    for member, track in zip(manipulator.members, spot.tracks, strict=True):
        lines.append(
            f'<polyline data-control="{markup(member.control)}" points="{_points(track)}"'
            f' fill="none" stroke="{_hex(element)}" stroke-width="4" stroke-linecap="round"'
            ' stroke-linejoin="round"/>'
        )
    lines.append(_handle(spot))
    if spot.lead is not None:
        (x, y), side = spot.lead[0], "end" if spot.lead[0, 0] < spot.handle[0] else "start"
        x += 4.0 if side == "start" else -4.0
        lines.append(
            f'<text x="{x:.2f}" y="{y + 5.0:.2f}" font-size="14"'
            f' text-anchor="{side}">{label}</text>'
        )
    if anchor.on_board:
        x, y = _label_place(spot)
        lines.append(f'<text x="{x:.2f}" y="{y:.2f}" font-size="14">{label}</text>')
    return [*lines, "</g>"]


def _handle(spot: Spot) -> str:
    (x, y), r = spot.handle, 0.5 * _HANDLE
    style = f'fill="{_hex(spot.element)}" stroke="#ffffff" stroke-width="2"'
    form = form_of(spot.element.manipulator)
    if form in ("patch", "joystick"):
        return (
            f'<rect x="{x - r:.2f}" y="{y - r:.2f}" width="{2 * r:.2f}" height="{2 * r:.2f}" rx="4"'
            f" {style}/>"
        )
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


def _ink(element: Element) -> str:
    """What is read on the colour of an element."""
    red, green, blue = colour_of(element)
    return "#16181b" if 0.299 * red + 0.587 * green + 0.114 * blue > 130.0 else "#ffffff"


# --- dwpicker -------------------------------------------------------------------------------------


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
        **{
            f"borderwidth.{state}": width
            for state, width in (("normal", 1.0), ("hovered", 1.25), ("clicked", 2.0))
        },
        **dict.fromkeys(
            ("bordercolor.normal", "bordercolor.hovered", "bordercolor.clicked"), "#ffffff"
        ),
        "bordercolor.transparency": 0,
        **dict.fromkeys(("bgcolor.normal", "bgcolor.hovered", "bgcolor.clicked"), colour),
        "bgcolor.transparency": 0,
        "text.content": "",
        "text.size": 11,
        "text.bold": False,
        "text.italic": False,
        "text.color": "#ffffff",
        "text.valign": "center",
        "text.halign": "center",
        "action.targets": [],
        "action.commands": [],
        "action.menu_commands": [],
        "image.path": "",
        "image.fit": False,
        "image.height": 32,
        "image.width": 32,
    }
