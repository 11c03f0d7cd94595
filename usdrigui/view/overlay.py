"""The elements of a layout drawn over a picture: tracks, handles and the fields of patches and
fans.

Drawn in the plane of the picture at three times its resolution and reduced, so that lines stay
crisp; what the character hides is drawn faintly.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np
from PIL import Image, ImageDraw

from usdrigui.model import Element, Flags, Floats, Glyph, Manipulator, Record
from usdrigui.palette import BOARD, SIDES, Colour
from usdrigui.pose.evaluate import PosedElement
from usdrigui.ties import axis_across
from usdrigui.view.shading import Camera

FORMS = {
    "slider": "slider",
    "two-way": "two-way slider",
    "patch": "patch",
    "joystick": "joystick",
    "fan": "fan",
}
_FINE = 3
"""Sub-pixels along each axis."""
_FAINT = 0.30
_FIELD = 0.26
_WHITE: Colour = (255, 255, 255)


@dataclass(frozen=True, eq=False)
class Mark(Record):
    """One element ready to draw; pixels as `Camera.project`."""

    colour: Colour
    form: str
    """A key of `FORMS`."""
    tracks: tuple[Floats, ...]
    """Per member (k, 3), finely resampled."""
    seen: tuple[Flags, ...]
    """Per member (k,) whether the character leaves it in view."""
    handle: Floats
    """(3,)."""
    handle_seen: bool
    fields: tuple[Floats, ...]
    """Closed outlines (k, 2) of what two neighbouring members span."""
    outlines: tuple[Floats, ...] = ()
    """Lines or faces (k, 3) of a custom handle, which then stands for the usual one."""
    solid: bool = False
    """True when the outlines are faces."""
    coarse: bool = False
    """Whether it opens into other elements, and so has a ring."""
    radius: float = 3.2
    """Of its handle, which is that of its part."""


def colour_of(element: Element) -> Colour:
    """The colour in which an element is drawn."""
    return BOARD if element.anchor.on_board else SIDES[element.look.side]


def form_of(manipulator: Manipulator) -> str:
    """Which handle an element with it gets: a key of `FORMS`."""
    signed = any(member.values[0] < 0.0 < member.values[-1] for member in manipulator.members)
    both_ways = bool(manipulator.opposed) or signed
    if manipulator.kind == "slider":
        return "two-way" if both_ways else "slider"
    return "joystick" if manipulator.kind == "patch" and both_ways else manipulator.kind


def mark(
    element: Element, posed: PosedElement, camera: Camera, depth: Floats, handle_width: float
) -> Mark:
    """Project an element and decide what of it the character hides."""
    tracks = tuple(_resampled(camera.project(track)) for track in posed.tracks)
    handle = camera.project(posed.handle)
    slack = 0.5 * handle_width
    fields = (
        _fields(element.manipulator, posed, camera) if element.manipulator.kind != "slider" else ()
    )
    return Mark(
        colour_of(element),
        form_of(element.manipulator),
        tracks,
        tuple(_seen(track, depth, slack) for track in tracks),
        handle,
        bool(_seen(handle[None], depth, slack)[0]),
        fields,
        _outlines(element.look.glyph, posed, camera, handle_width),
        element.look.glyph is not None and element.look.glyph.form == "mesh",
        bool(element.look.inner),
        _radius(camera, handle_width),
    )


def _radius(camera: Camera, handle_width: float) -> float:
    """Of a handle, in pixels: small ones are drawn larger than they are."""
    return max(0.5 * handle_width * camera.scale, 3.2)


def _outlines(
    glyph: Glyph | None, posed: PosedElement, camera: Camera, handle_width: float
) -> tuple[Floats, ...]:
    """Lines, or faces from far to near, of a custom handle; as much enlarged as the usual one
    is."""
    if glyph is None:
        return ()
    points, centre = camera.project(posed.glyph), camera.project(posed.handle)
    enlarged = _radius(camera, handle_width) / max(0.5 * handle_width * camera.scale, 1e-12)
    points[:, :2] = centre[:2] + enlarged * (points[:, :2] - centre[:2])
    parts = np.split(points[glyph.indices], np.cumsum(glyph.counts)[:-1])
    return tuple(sorted(parts, key=lambda part: float(part[:, 2].mean())))


def draw(picture: Image.Image, marks: list[Mark]) -> Image.Image:
    """The picture with all marks over it: hidden parts, fields, tracks, then handles from far to
    near."""
    ordered = sorted(marks, key=lambda each: float(each.handle[2]))
    picture = _over(picture, _hidden(picture.size, ordered), _FAINT)
    picture = _over(picture, _spans(picture.size, ordered), _FIELD)
    picture = _over(picture, _lines(picture.size, ordered), 1.0)
    return _over(picture, _knobs(picture.size, [each for each in ordered if each.handle_seen]), 1.0)


def leaders(picture: Image.Image, lines: list[Floats]) -> Image.Image:
    """The picture with thin lines (k, 2) that can be followed over skin and paper alike: light,
    cased darkly."""
    layer = _layer(picture.size)
    pen = ImageDraw.Draw(layer)
    for width, ink in ((3.0, (52, 56, 63, 200)), (1.34, (255, 255, 255, 255))):
        for line in lines:
            _stroke(pen, line, width, ink)
    return _over(picture, layer, 1.0)


@cache
def knob(form: str, colour: Colour, radius: float, coarse: bool = False) -> Image.Image:
    """A handle as a small square picture at the fine resolution: a lit ball, block or diamond with
    a white rim.

    What goes both ways has a thin ring of its own form, what is ``coarse`` a broad round one.
    """
    reach = int(np.ceil(radius * _FINE * (2.2 if coarse else 1.5))) + 2
    y, x = np.mgrid[-reach : reach + 1, -reach : reach + 1] / (radius * _FINE)
    if form in ("patch", "joystick"):
        away = np.maximum(np.abs(x), np.abs(y)) * 0.5 + np.hypot(x, y) * 0.5
        away = away * 1.08
    elif form == "fan":
        away = (np.abs(x) + np.abs(y)) * 0.60 + np.hypot(x, y) * 0.28
    else:
        away = np.hypot(x, y)
    depth = np.sqrt(np.clip(1.0 - np.minimum(away / 0.86, 1.0) ** 2, 0.0, 1.0))
    light = 0.62 + 0.30 * depth + 0.34 * np.clip(-0.45 * x - 0.6 * y, -0.6, 1.0)
    rgb = np.clip(np.array(colour) * light[..., None], 0, 255)
    shine = np.clip(1.0 - np.hypot(x + 0.30, y + 0.34) / 0.34, 0.0, 1.0) ** 2
    rgb += (255.0 - rgb) * (0.75 * shine[..., None])
    inside = np.clip((0.86 - away) * radius * _FINE + 0.5, 0.0, 1.0)[..., None]
    rgb = rgb * inside + 255.0 * (1.0 - inside)
    alpha = np.clip((1.06 - away) * radius * _FINE + 0.5, 0.0, 1.0)
    rings = [(away, 1.28, 0.08)] if form in ("two-way", "joystick") else []
    rings += [(np.hypot(x, y), 1.75, 0.15)] if coarse else []
    for apart, at, half in rings:
        casing = (
            0.6 * np.clip((half + 0.16 - np.abs(apart - at)) * radius * _FINE + 0.5, 0.0, 1.0)
            if coarse
            else 0.0
        )
        ring = np.clip((half - np.abs(apart - at)) * radius * _FINE + 0.5, 0.0, 1.0)
        rgb = np.where(ring[..., None] > 0.0, np.array(colour, dtype=np.float64), rgb)
        alpha = np.maximum(alpha, np.maximum(ring, casing))
    return Image.fromarray(np.dstack([rgb, 255.0 * alpha]).round().astype(np.uint8), "RGBA")


def paste_knob(
    picture: Image.Image,
    form: str,
    colour: Colour,
    radius: float,
    at: tuple[float, float],
    coarse: bool = False,
) -> None:
    """Put one handle on an RGB picture, for legends."""
    fine = knob(form, colour, radius, coarse)
    small = fine.resize(
        (round(fine.width / _FINE), round(fine.height / _FINE)), Image.Resampling.BOX
    )
    corner = (round(at[0] - small.width / 2), round(at[1] - small.height / 2))
    picture.paste(small, corner, small)


# --- geometry -------------------------------------------------------------------------------------


def _resampled(line: Floats) -> Floats:
    """A projected polyline (k, 3) with vertices at most two pixels apart."""
    parts = [line[:1]]
    for start, end in pairwise(line):
        steps = int(np.clip(np.ceil(np.linalg.norm((end - start)[:2]) / 2.0), 1, 2000))
        share = np.arange(1, steps + 1)[:, None] / steps
        parts.append(start + share * (end - start))
    return np.concatenate(parts)


def _seen(at: Floats, depth: Floats, slack: float) -> Flags:
    """(k,) whether projected points (k, 3) lie in front of the depth buffer, give or take `slack`
    scene units."""
    column = np.clip(at[:, 0].astype(np.int64), 0, depth.shape[1] - 1)
    row = np.clip(at[:, 1].astype(np.int64), 0, depth.shape[0] - 1)
    return np.asarray(at[:, 2] >= depth[row, column] - slack)


def _fields(manipulator: Manipulator, posed: PosedElement, camera: Camera) -> tuple[Floats, ...]:
    """Outlines (k, 2), pixels, of the parallelograms between arms next to each other by angle
    (paper section 4.2).

    A track that goes both ways from the rest is two arms: two such axes span all four quadrants.
    Arms of one axis and pairs more than 180 degrees apart span nothing.
    """
    lines = [
        (number, posed.tracks[i] - posed.rest)
        for number, axis in enumerate(manipulator.axes)
        for i in axis
    ]
    halves = [(axis, arm) for axis, line in lines for arm in _arms(line)]
    if not halves:
        return ()
    axes, arms = [axis for axis, _ in halves], [arm for _, arm in halves]
    tips = np.array([arm[int(np.argmax(np.linalg.norm(arm, axis=1)))] for arm in arms])
    east = np.cross(posed.normal, axis_across(posed.normal))
    angle = np.arctan2(tips @ np.cross(posed.normal, east), tips @ east)
    order = np.argsort(angle, kind="stable")
    found = []
    for i, j in zip(order, np.roll(order, -1), strict=True):
        span = (angle[j] - angle[i]) % (2.0 * np.pi)
        if axes[i] != axes[j] and 1e-3 < span < np.pi - 1e-3:
            out = np.concatenate(
                [arms[i], arms[i][-1] + arms[j], (arms[j][-1] + arms[i])[::-1], arms[j][::-1]]
            )
            found.append(camera.project(posed.rest + out)[:, :2])
    return tuple(found)


def _arms(line: Floats) -> list[Floats]:
    """A track (k, 3) relative to the rest, cut where it passes the rest: one or two lines that
    start there.

    Tracks pass the rest at the base value of their control, which need not be one of the vertices.
    """
    steps = np.diff(line, axis=0)
    square = np.maximum((steps**2).sum(axis=1), 1e-300)
    share = np.clip(-(line[:-1] * steps).sum(axis=1) / square, 0.0, 1.0)
    nearest = line[:-1] + share[:, None] * steps
    away = np.linalg.norm(nearest, axis=1)
    size = float(np.linalg.norm(line, axis=1).max(initial=0.0))
    if not len(away) or not size > 0.0:
        return []
    # A loop that comes back to the rest is cut where it first passes, whatever rounding makes of
    # the second time.
    piece = int(np.flatnonzero(away <= away.min() + 1e-9 * size)[0])
    cut = nearest[piece][None]
    halves = (np.concatenate([cut, line[piece::-1]]), np.concatenate([cut, line[piece + 1 :]]))
    reaches = [float(np.linalg.norm(half - cut, axis=1).max()) for half in halves]
    return [half for half, reach in zip(halves, reaches, strict=True) if reach > 1e-6 * size]


# --- layers ---------------------------------------------------------------------------------------


def _over(picture: Image.Image, layer: Image.Image, opacity: float) -> Image.Image:
    """Reduce a fine layer and lay it over the picture."""
    small = layer.resize(picture.size, Image.Resampling.BOX)
    if opacity < 1.0:
        small.putalpha(
            small.getchannel("A").point([round(value * opacity) for value in range(256)])
        )
    return Image.alpha_composite(picture.convert("RGBA"), small).convert("RGB")


def _layer(size: tuple[int, int]) -> Image.Image:
    return Image.new("RGBA", (size[0] * _FINE, size[1] * _FINE), (255, 255, 255, 0))


def _spans(size: tuple[int, int], marks: list[Mark]) -> Image.Image:
    layer = _layer(size)
    pen = ImageDraw.Draw(layer)
    for each in marks:
        for outline in each.fields:
            points = [(float(x) * _FINE, float(y) * _FINE) for x, y in outline]
            pen.polygon(points, fill=(*each.colour, 255))
    return layer


def _lines(size: tuple[int, int], marks: list[Mark]) -> Image.Image:
    """Tracks with a light casing, all casings below all cores; a dot at the end of each."""
    layer = _layer(size)
    pen = ImageDraw.Draw(layer)
    for plain in (True, False):
        for each in marks:
            width = float(np.clip(0.34 * each.radius, 1.5, 4.0)) + 2.2 * plain
            ink = (255, 255, 255, 215) if plain else (*_deep(each.colour), 255)
            for track, seen in zip(each.tracks, each.seen, strict=True):
                for run in _runs(track, seen):
                    _stroke(pen, run, width, ink)
                if seen[-1]:
                    _dot(pen, track[-1], 0.5 * width + 0.12 * each.radius, ink)
    return layer


def _hidden(size: tuple[int, int], marks: list[Mark]) -> Image.Image:
    """What the character hides, without casings."""
    layer = _layer(size)
    pen = ImageDraw.Draw(layer)
    for each in marks:
        for track, seen in zip(each.tracks, each.seen, strict=True):
            for run in _runs(track, ~seen):
                _stroke(
                    pen,
                    run,
                    float(np.clip(0.3 * each.radius, 1.2, 3.0)),
                    (*_deep(each.colour), 255),
                )
        if not each.handle_seen:
            _dot(pen, each.handle, each.radius, (*each.colour, 255))
            _dot(pen, each.handle, 0.7 * each.radius, (*_WHITE, 140))
    return layer


def _knobs(size: tuple[int, int], marks: list[Mark]) -> Image.Image:
    layer = _layer(size)
    for each in marks:
        if each.outlines:
            _glyph(ImageDraw.Draw(layer), each)
            continue
        ball = knob(each.form, each.colour, round(each.radius, 2), each.coarse)
        x, y = (round(float(value) * _FINE - ball.width / 2) for value in each.handle[:2])
        if -ball.width < x < layer.width and -ball.height < y < layer.height:
            box = (
                max(-x, 0),
                max(-y, 0),
                min(ball.width, layer.width - x),
                min(ball.height, layer.height - y),
            )
            layer.alpha_composite(ball.crop(box), (max(x, 0), max(y, 0)))
    return layer


def _glyph(pen: ImageDraw.ImageDraw, drawn: Mark) -> None:
    """A custom handle with a white rim."""
    parts = [part[:, :2] for part in drawn.outlines]
    lines = [np.concatenate([part, part[:1]]) if drawn.solid else part for part in parts]
    for width, ink in ((4.2, (*_WHITE, 255)), (2.0, (*_deep(drawn.colour), 255))):
        for line in lines:
            _stroke(pen, line, width, ink)
    if drawn.solid:
        for part in parts:
            pen.polygon(
                [(float(x) * _FINE, float(y) * _FINE) for x, y in part], fill=(*drawn.colour, 255)
            )


def _runs(track: Floats, wanted: Flags) -> list[Floats]:
    """The stretches (k >= 2 vertices) of a track whose vertices are all wanted."""
    borders = np.flatnonzero(np.diff(wanted.astype(np.int8))) + 1
    parts = zip(np.split(track, borders), np.split(wanted, borders), strict=True)
    return [part for part, flags in parts if flags[0] and len(part) > 1]


def _stroke(
    pen: ImageDraw.ImageDraw, line: Floats, width: float, ink: tuple[int, int, int, int]
) -> None:
    points = [(float(x) * _FINE, float(y) * _FINE) for x, y in line[:, :2]]
    pen.line(points, fill=ink, width=max(round(width * _FINE), 1), joint="curve")
    for end in (line[0], line[-1]):
        _dot(pen, end, 0.5 * width, ink)


def _dot(
    pen: ImageDraw.ImageDraw, at: Floats, radius: float, ink: tuple[int, int, int, int]
) -> None:
    x, y, r = float(at[0]) * _FINE, float(at[1]) * _FINE, radius * _FINE
    pen.ellipse((x - r, y - r, x + r, y + r), fill=ink)


def _deep(colour: Colour) -> Colour:
    """The darker tone of a colour in which its tracks are drawn."""
    red, green, blue = (round(0.82 * value) for value in colour)
    return red, green, blue
