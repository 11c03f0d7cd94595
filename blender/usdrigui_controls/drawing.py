"""How the elements look: tracks, areas and handles as two batches, the label of the one in hand."""

from __future__ import annotations

import blf
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from .maths.palette import SIDES

_HOT = (1.0, 1.0, 1.0)
_ROUND = np.array([(np.cos(a), np.sin(a)) for a in np.linspace(0.0, 2.0 * np.pi, 17)])
_DISC = np.stack([0.0 * _ROUND[1:], _ROUND[:-1], _ROUND[1:]], axis=1).reshape(-1, 2)
"""(48, 2) triangles of the unit disc."""


def draw_elements(screen, shown, radii, opacity, lit):
    """Draw ``shown`` elements in the 3-D view, those whose key is ``lit`` in white.

    ``radii`` are the handles' sizes in pixels.  Those that face away are left out.
    """
    lines, faces = [], []
    seen = [each for each in zip(shown, radii, strict=True) if screen.faces(each[0].placed)]
    for item, radius in sorted(seen, key=lambda each: each[0].key in lit):
        placed, colour, alpha = item.placed, _HOT, opacity
        if item.key not in lit:
            side = SIDES.get(item.element.side, SIDES["none"])
            colour, alpha = [part / 255.0 for part in side], 0.85 * opacity
        lines += [(np.repeat(each, 2, axis=0)[1:-1], (*colour, alpha)) for each in placed.tracks]
        faces += [
            (placed.area, (*colour, 0.18 * alpha)),
            (_disc(screen, placed.handle, radius + 1.5), (0.05, 0.05, 0.05, alpha)),
            (_disc(screen, placed.handle, radius), (*colour, alpha)),
        ]
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("NONE")
    _draw("LINES", lines, (screen.width, screen.height))
    _draw("TRIS", faces)
    gpu.state.blend_set("NONE")


def draw_label(at, text):
    """A line of text in pixels, y upwards, with a shadow so that it reads on any ground."""
    font = 0
    blf.size(font, 13)
    blf.enable(font, blf.SHADOW)
    blf.shadow(font, 3, 0.0, 0.0, 0.0, 1.0)
    blf.color(font, 1.0, 1.0, 1.0, 1.0)
    blf.position(font, at[0], at[1], 0)
    blf.draw(font, text)
    blf.disable(font, blf.SHADOW)


def _disc(screen, centre, radius):
    """(48, 3) triangles of a disc of ``radius`` pixels that looks at the viewer."""
    right, up = screen.axes_at(centre)
    return centre + radius * (_DISC[:, :1] * right + _DISC[:, 1:] * up)


def _draw(primitive, parts, viewport=()):
    """Draw vertices of one primitive type: (points (k, 3), colour) pairs; lines need the size of
    the ``viewport``."""
    if not parts:
        return
    points = np.concatenate([points for points, _ in parts])
    colours = np.concatenate([np.tile(colour, (len(points), 1)) for points, colour in parts])
    columns = {"pos": points.astype(np.float32), "color": colours.astype(np.float32)}
    shader = gpu.shader.from_builtin("POLYLINE_SMOOTH_COLOR" if viewport else "SMOOTH_COLOR")
    batch = batch_for_shader(shader, primitive, columns)
    shader.bind()
    if viewport:
        shader.uniform_float("viewportSize", viewport)
        shader.uniform_float("lineWidth", 2.0)
    batch.draw(shader)
