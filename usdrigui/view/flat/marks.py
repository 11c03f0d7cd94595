"""Elements as marks of a flat scene: projected, with what the character hides told apart."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from usdrigui.character import Flags, Floats, Glyph
from usdrigui.character.palette import SIDES
from usdrigui.model import Element
from usdrigui.model.neighbours import end_of, neighbours
from usdrigui.pose.evaluate import PosedElement
from usdrigui.ties import axis_across
from usdrigui.view.body.shading import Camera
from usdrigui.view.flat.scene import Mark

FORMS = {
    "slider": "slider",
    "two-way": "two-way slider",
    "patch": "patch",
    "joystick": "joystick",
    "fan": "fan",
}
_BLOCK, _DIAMOND = (4, 1.2, 0.5), (4, 1.2, 0.0)
_SHAPES = {"patch": _BLOCK, "joystick": _BLOCK, "fan": _DIAMOND}
"""Corners of a handle, how far they are from its centre, and by how much of a step they are turned;
others are discs."""
_MIN_RADIUS = 3.2
"""Of a handle, pixels: smaller ones are drawn larger than they are."""
_SPREAD = np.array([[0, 0, 0], [0.7, 0, 0], [-0.7, 0, 0], [0, 0.7, 0], [0, -0.7, 0]])
"""Places on a handle, in shares of its radius: it is hidden where all of them are."""


def form_of(element: Element) -> str:
    """Which handle an element with it gets: a key of `FORMS`."""
    signed = any(member.values[0] < 0.0 < member.values[-1] for member in element.members)
    both_ways = bool(element.opposed) or signed
    if element.kind == "slider":
        return "two-way" if both_ways else "slider"
    return "joystick" if element.kind == "patch" and both_ways else element.kind


def mark(
    element: Element,
    posed: PosedElement,
    camera: Camera,
    handle_width: float,
    depth: Floats | None = None,
) -> Mark:
    """An element as a camera sees it, pixels of its picture; `depth` (height, width) of the
    character decides what is hidden, nothing without it."""
    tracks = tuple(_resampled(camera.project(track)) for track in posed.tracks)
    handle = camera.project(posed.handle)
    radius = max(0.5 * handle_width * camera.scale, _MIN_RADIUS)
    enlarged = radius / max(0.5 * handle_width * camera.scale, 1e-12)
    glyph, slider = element.glyph, element.kind == "slider"
    return Mark(
        form_of(element),
        SIDES[element.side],
        handle[:2],
        radius,
        bool(element.inner),
        element,
        tuple(track[:, :2] for track in tracks),
        tuple(_seen(track, depth, 0.5 * handle_width) for track in tracks),
        not _seen(handle + radius * _SPREAD, depth, 0.5 * handle_width).any(),
        float(handle[2]),
        () if slider else _fields(element, posed, camera),
        () if glyph is None else _outlines(glyph, camera.project(posed.glyph), handle, enlarged),
        glyph is not None and glyph.form == "mesh",
    )


def handle_outlines(mark: Mark) -> tuple[tuple[Floats, ...], bool]:
    """Outlines (k, 2) of a mark's handle, and whether they are faces: a disc, block or diamond, or
    the custom one."""
    if mark.outlines:
        return mark.outlines, mark.solid
    return (mark.handle + mark.radius * _shape(mark.form),), True


def rings(mark: Mark) -> list[tuple[Floats, float]]:
    """Closed lines (k, 2) around a usual handle, with their widths: of its own form where it goes
    both ways, round and broad where it opens into others."""
    if mark.outlines:
        return []
    both_ways = mark.form in ("two-way", "joystick")
    found = [(1.5 * _shape(mark.form), 0.16 * mark.radius)] if both_ways else []
    found += [(1.8 * _shape("slider"), 0.3 * mark.radius)] if mark.coarse else []
    return [(mark.handle + mark.radius * line[[*range(len(line)), 0]], w) for line, w in found]


def runs(track: Floats, wanted: Flags) -> list[Floats]:
    """The stretches (k >= 2 vertices) of a track whose vertices are all wanted."""
    borders = np.flatnonzero(np.diff(wanted.astype(np.int8))) + 1
    parts = zip(np.split(track, borders), np.split(wanted, borders), strict=True)
    return [part for part, flags in parts if flags[0] and len(part) > 1]


def _shape(form: str) -> Floats:
    """(k, 2) corners of the handle of radius 1 of a form."""
    count, size, start = _SHAPES.get(form, (24, 0.95, 0.0))
    angle = 2.0 * np.pi * (np.arange(count) + start) / count
    return size * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _outlines(glyph: Glyph, points: Floats, centre: Floats, enlarged: float) -> tuple[Floats, ...]:
    """Lines, or faces from far to near, of a custom handle; as much enlarged as the usual one
    is."""
    points[:, :2] = centre[:2] + enlarged * (points[:, :2] - centre[:2])
    parts = [points[part] for part in glyph.parts]
    return tuple(part[:, :2] for part in sorted(parts, key=lambda part: float(part[:, 2].mean())))


def _resampled(line: Floats) -> Floats:
    """A projected polyline (k, 3) with vertices at most two pixels apart."""
    # Not two: pieces of a board are whole pixels long, and a last bit would decide.
    parts = [line[:1]]
    for start, end in pairwise(line):
        steps = int(np.clip(np.ceil(np.linalg.norm((end - start)[:2]) / 1.9), 1, 2000))
        share = np.arange(1, steps + 1)[:, None] / steps
        parts.append(start + share * (end - start))
    return np.concatenate(parts)


def _seen(at: Floats, depth: Floats | None, slack: float) -> Flags:
    """(k,) whether projected points (k, 3) lie in front of the depth buffer, give or take `slack`
    scene units."""
    if depth is None:
        return np.ones(len(at), dtype=bool)
    column = np.clip(at[:, 0].astype(np.int64), 0, depth.shape[1] - 1)
    row = np.clip(at[:, 1].astype(np.int64), 0, depth.shape[0] - 1)
    return at[:, 2] >= depth[row, column] - slack


def _fields(element: Element, posed: PosedElement, camera: Camera) -> tuple[Floats, ...]:
    """Outlines (4, 2), pixels, of the parallelograms between tracks next to each other (paper
    section 4.2)."""
    tracks, rest, normal = posed.tracks, posed.rest, posed.normal
    across = np.cross(normal, axis_across(normal))
    found = []
    for pair in neighbours(tracks, rest, normal, across, element.axes):
        a, b = (end_of(tracks, end) - rest for end in pair)
        found.append(camera.project(rest + np.array([0.0 * a, a, a + b, b]))[:, :2])
    return tuple(found)
