"""What pictures and pickers show of a character: its body, marks over it, and the board."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from PIL import Image

from usdrigui.character import Floats
from usdrigui.model import Layout
from usdrigui.pose.evaluate import PosedLayout
from usdrigui.view.body.shading import Camera, Subject, encoded, shade
from usdrigui.view.directions import camera_rows
from usdrigui.view.flat.columns import RADIUS, board
from usdrigui.view.flat.marks import mark
from usdrigui.view.flat.scene import Mark, Panel
from usdrigui.view.sections import Section


def body(subject: Subject, camera: Camera) -> tuple[Image.Image, Floats]:
    """The character as a camera sees it, RGBA, and its depth (height, width)."""
    shaded = shade(subject, camera)
    pixels = np.dstack([encoded(shaded.colour), shaded.cover])
    return Image.fromarray((255.0 * pixels).round().astype(np.uint8), "RGBA"), shaded.depth


def marks_of(
    layout: Layout,
    posed: PosedLayout,
    indices: Iterable[int],
    camera: Camera,
    depth: Floats | None = None,
) -> list[Mark]:
    """Marks of some of the elements, in pixels of the camera's picture."""
    marks = []
    for index in indices:
        element = layout.elements[index]
        width = layout.frame.handle_width_of(element.part)
        marks.append(mark(element, posed.elements[index], camera, width, depth))
    return marks


def on_character(layout: Layout) -> list[int]:
    """Indices of the elements that are not on the board."""
    return [i for i, element in enumerate(layout.elements) if not element.anchor.on_board]


def board_of(
    section: Section, up: Floats, box: tuple[int, int, int], scale: float = 1.0
) -> list[Panel]:
    """The panel of the board of a section, as `board.board`; none where nothing is on it."""
    layout = section.layout
    on_board = [i for i, element in enumerate(layout.elements) if element.anchor.on_board]
    pixels = 2.0 * scale * RADIUS / layout.frame.handle_width
    camera = Camera(camera_rows(layout, up), np.zeros(3), pixels, 0, 0)
    marks = marks_of(layout, section.posed, on_board, camera)
    pairs = [(layout.elements[i], mark) for i, mark in zip(on_board, marks, strict=True)]
    return [board(pairs, box, scale)] if pairs else []
