"""The records of a flat scene.  Lengths are pixels, x to the right, y down; a page's panels have
their own corners, everything in a panel is placed from its own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from PIL import Image

from usdrigui.character import Flags, Floats, Record
from usdrigui.character.palette import Colour
from usdrigui.model import Element

INK, QUIET = (46, 50, 56), (88, 94, 104)
"""Of names, and of what explains them: on either ground of contrast 4.5 at least (WCAG 2.1)."""
PAPER, GROUND = (250, 250, 251), (236, 238, 241)
"""Behind the panels, and in those that show something."""


class Mark(Record):
    """One element, or the example of a legend."""

    form: str
    """A key of `marks.FORMS`."""
    colour: Colour
    handle: Floats
    """(2,)."""
    radius: float
    """Of the handle."""
    coarse: bool = False
    """Whether it opens into other elements, and so has a ring."""
    element: Element | None = None
    """None in a legend."""
    tracks: tuple[Floats, ...] = ()
    """Per member (k, 2), finely resampled."""
    seen: tuple[Flags, ...] = ()
    """Per member (k,) whether the character leaves it in view."""
    hidden: bool = False
    """Whether the character hides the handle."""
    depth: float = 0.0
    """Of the handle, growing toward the viewer: near handles are drawn over far ones."""
    fields: tuple[Floats, ...] = ()
    """Closed outlines (k, 2) of what two neighbouring members span."""
    outlines: tuple[Floats, ...] = ()
    """Lines or faces (k, 2) of a custom handle, which then stands for the usual one."""
    solid: bool = False
    """True when the outlines are faces."""

    @property
    def deep(self) -> Colour:
        """The darker tone of the colour, in which tracks are drawn."""
        red, green, blue = (round(0.82 * part) for part in self.colour)
        return red, green, blue

    def placed(self, scale: float, shift: Floats) -> Mark:
        """The mark with every point p at ``scale * p + shift``; its handle keeps its size."""
        handle = scale * self.handle + shift
        glyph = handle - self.handle
        return replace(
            self,
            handle=handle,
            tracks=tuple(scale * track + shift for track in self.tracks),
            fields=tuple(scale * field + shift for field in self.fields),
            outlines=tuple(outline + glyph for outline in self.outlines),
        )


@dataclass(frozen=True)
class Label:
    """One line of text."""

    text: str
    place: tuple[float, float]
    anchor: str = "lm"
    """Where `place` is in it, as Pillow calls it: ``l``, ``m`` or ``r``, and ``m``."""
    size: int = 12
    ink: Colour = INK


class Panel(Record):
    """A rectangle of a page."""

    corner: tuple[int, int]
    size: tuple[int, int]
    body: Image.Image | None = None
    """The character, RGBA, in the middle of the panel's width; names stand beside it."""
    marks: tuple[Mark, ...] = ()
    labels: tuple[Label, ...] = ()
    leaders: tuple[Floats, ...] = ()
    """Lines (k, 2) from names to handles."""
    grounded: bool = True
    """Whether it has a ground of its own; titles and captions stand on the paper."""


class Page(Record):
    """Panels on one sheet."""

    size: tuple[int, int]
    panels: tuple[Panel, ...]

    def placed(self, left: int, top: int) -> tuple[Panel, ...]:
        """The panels on a larger page that has this one at a corner."""
        return tuple(
            replace(panel, corner=(panel.corner[0] + left, panel.corner[1] + top))
            for panel in self.panels
        )


def stacked(pages: Sequence[Page], axis: int = 1) -> Page:
    """The pages below each other, or beside each other along axis 0, as one."""
    panels: list[Panel] = []
    corner, (width, height) = [0, 0], np.max([page.size for page in pages], axis=0).tolist()
    for page in pages:
        panels += page.placed(*corner)
        corner[axis] += page.size[axis]
    return Page((corner[0] or width, corner[1] or height), tuple(panels))
