"""A flat scene drawn by Pillow, at twice its resolution and reduced, so that lines stay
crisp; what the character hides is drawn faintly."""

from __future__ import annotations

import io

import numpy as np
from PIL import Image, ImageDraw

from usdrigui.character import Floats
from usdrigui.view.flat.lettering import font, legible
from usdrigui.view.flat.marks import handle_outlines, rings, runs
from usdrigui.view.flat.scene import GROUND, PAPER, Mark, Page, Panel

_FINE = 2
"""Sub-pixels along each axis."""
_FAINT, _FIELD, _CASING = 76, 66, 215
"""Opacity of what is hidden, of fields, and of the light casing of tracks; of 255."""
_WHITE = (255, 255, 255, 255)

Ink = tuple[int, int, int, int]


def painted(page: Page) -> Image.Image:
    """The page as a picture, RGB."""
    whole = Image.new("RGB", page.size, PAPER)
    for panel in page.panels:
        whole.paste(_panel(panel), panel.corner)
    return whole


def png(image: Image.Image) -> bytes:
    """The bytes of a picture's file."""
    stream = io.BytesIO()
    image.save(stream, "PNG")
    return stream.getvalue()


def _panel(panel: Panel) -> Image.Image:
    picture = Image.new("RGB", panel.size, GROUND if panel.grounded else PAPER)
    if panel.body is not None:
        picture.paste(panel.body, ((panel.size[0] - panel.body.width) // 2, 0), panel.body)
    if panel.marks:
        fine = Image.new("RGBA", (panel.size[0] * _FINE, panel.size[1] * _FINE), (255, 255, 255, 0))
        _draw(ImageDraw.Draw(fine), panel)
        drawn = fine.resize(panel.size, Image.Resampling.BOX)
        picture = Image.alpha_composite(picture.convert("RGBA"), drawn).convert("RGB")
    pen = ImageDraw.Draw(picture)
    for label in panel.labels:
        text, type_ = legible(label.text), font(label.size, label.text)
        pen.text(label.place, text, fill=label.ink, font=type_, anchor=label.anchor)
    return picture


def _draw(pen: ImageDraw.ImageDraw, panel: Panel) -> None:
    """Leaders, then what is hidden, fields, tracks, and handles from far to near."""
    ordered = sorted(panel.marks, key=lambda mark: mark.depth)
    # Light, cased darkly: such a line can be followed over skin and paper alike.
    for width, ink in ((3.0, (52, 56, 63, 200)), (1.34, _WHITE)):
        for line in panel.leaders:
            _stroke(pen, line, width, ink)
    for mark in ordered:
        _hidden(pen, mark)
    for mark in ordered:
        for field in mark.fields:
            pen.polygon(_points(field), fill=(*mark.colour, _FIELD))
    for cased in (True, False):
        for mark in ordered:
            _tracks(pen, mark, cased)
    for mark in ordered:
        if not mark.hidden:
            _handle(pen, mark)


def _hidden(pen: ImageDraw.ImageDraw, mark: Mark) -> None:
    faint = (*mark.deep, _FAINT)
    for track, seen in zip(mark.tracks, mark.seen, strict=True):
        for run in runs(track, ~seen):
            _stroke(pen, run, float(np.clip(0.3 * mark.radius, 1.2, 3.0)), faint)
    if mark.hidden:
        _dot(pen, mark.handle, 0.85 * mark.radius, faint)


def _tracks(pen: ImageDraw.ImageDraw, mark: Mark, cased: bool) -> None:
    """Tracks or their light casing, with a dot at the end of each."""
    width = float(np.clip(0.34 * mark.radius, 1.5, 4.0)) + 2.2 * cased
    ink = (255, 255, 255, _CASING) if cased else (*mark.deep, 255)
    for track, seen in zip(mark.tracks, mark.seen, strict=True):
        for run in runs(track, seen):
            _stroke(pen, run, width, ink)
        if seen[-1]:
            _dot(pen, track[-1], 0.5 * width + 0.12 * mark.radius, ink)


def _handle(pen: ImageDraw.ImageDraw, mark: Mark) -> None:
    """A handle with a white rim; custom ones are lines or faces."""
    outlines, filled = handle_outlines(mark)
    for ring, width in rings(mark):
        _stroke(pen, ring, width + 1.5, _WHITE)
        _stroke(pen, ring, width, (*mark.colour, 255))
    for width, ink in ((4.2, _WHITE), (2.0, (*mark.deep, 255))):
        for line in outlines:
            _stroke(pen, np.concatenate([line, line[:1]]) if filled else line, width, ink)
    for face in outlines if filled else ():
        pen.polygon(_points(face), fill=(*mark.colour, 255))


def _stroke(pen: ImageDraw.ImageDraw, line: Floats, width: float, ink: Ink) -> None:
    pen.line(_points(line), fill=ink, width=max(round(width * _FINE), 1), joint="curve")
    for end in (line[0], line[-1]):
        _dot(pen, end, 0.5 * width, ink)


def _dot(pen: ImageDraw.ImageDraw, centre: Floats, radius: float, ink: Ink) -> None:
    x, y, r = float(centre[0]) * _FINE, float(centre[1]) * _FINE, radius * _FINE
    pen.ellipse((x - r, y - r, x + r, y + r), fill=ink)


def _points(line: Floats) -> list[tuple[float, float]]:
    return [(float(x) * _FINE, float(y) * _FINE) for x, y in line]
