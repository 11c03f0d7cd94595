"""How the elements look: tracks, areas and handles as two batches, the label of the one in hand."""

from __future__ import annotations

import blf
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from .maths.palette import SIDES

_HOT = (1.0, 1.0, 1.0)
_CORNERS = np.array([(np.cos(a), np.sin(a)) for a in np.linspace(0.0, 2.0 * np.pi, 17)[:-1]])


def draw_elements(screen, shown, radii, opacity, lit):
    """Draw ``shown`` elements in the 3-D view, those whose key is ``lit`` in white.

    ``radii`` are the handles' sizes in pixels.  Those that face away are left out.
    """
    lines, faces = [], []
    seen = zip((item.key in lit for item in shown), shown, radii, strict=True)
    seen = [each for each in seen if screen.faces(each[1].placed)]
    for hot, item, radius in sorted(seen, key=lambda each: each[0]):
        colour = _HOT if hot else _side_colour(item.element.side)
        _add_element(screen, lines, faces, item, radius, colour, opacity * (1.0 if hot else 0.85))
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("NONE")
    _draw("LINES", lines, width=2.0, viewport=(screen.width, screen.height))
    _draw("TRIS", faces)
    gpu.state.blend_set("NONE")


def _side_colour(side):
    return tuple(part / 255.0 for part in SIDES.get(side, SIDES["none"]))


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


def _add_element(screen, lines, faces, item, radius, colour, opacity):
    placed = item.placed
    lines += [(np.repeat(each, 2, axis=0)[1:-1], (*colour, opacity)) for each in placed.tracks]
    faces += [
        (placed.area, (*colour, 0.18 * opacity)),
        (_disc(screen, placed.handle, radius + 1.5), (0.05, 0.05, 0.05, opacity)),
        (_disc(screen, placed.handle, radius), (*colour, opacity)),
    ]


def _disc(screen, centre, radius):
    """(48, 3) triangles of a disc of ``radius`` pixels that looks at the viewer."""
    right, up = screen.axes_at(centre)
    ring = centre + radius * (_CORNERS[:, :1] * right + _CORNERS[:, 1:] * up)
    return np.stack(
        [np.broadcast_to(centre, ring.shape), ring, np.roll(ring, -1, axis=0)], axis=1
    ).reshape(-1, 3)


def _draw(primitive, parts, width=0.0, viewport=None):
    """Draw vertices of one primitive type: (points (k, 3), colour) pairs."""
    if not parts:
        return
    points = np.concatenate([points for points, _ in parts])
    colours = np.concatenate([np.tile(colour, (len(points), 1)) for points, colour in parts])
    columns = {"pos": points.astype(np.float32), "color": colours.astype(np.float32)}
    kind = "POLYLINE_SMOOTH_COLOR" if width else "SMOOTH_COLOR"
    shader = gpu.shader.from_builtin(kind)
    batch = batch_for_shader(shader, primitive, columns)
    shader.bind()
    if width:
        shader.uniform_float("viewportSize", viewport)
        shader.uniform_float("lineWidth", width)
    batch.draw(shader)
