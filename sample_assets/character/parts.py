"""The meshes beside the head: eyeballs, teeth, tongue, eyebrows and lashes; and colours for all."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import form
from .form import EYE, EYE_RADIUS, Floats
from .head import LID_MARGIN, Head, Indices, reflect

SKIN = (0.87, 0.66, 0.55)
BLUSH = (0.86, 0.56, 0.47)
LIP = (0.74, 0.36, 0.35)
INNER_MOUTH = (0.42, 0.13, 0.14)
LID_LINE = (0.45, 0.27, 0.22)
HAIR = (0.20, 0.12, 0.08)
HAIR_TOP = (0.33, 0.20, 0.12)
GUM = (0.75, 0.40, 0.40)
TOOTH = (0.93, 0.90, 0.82)
TONGUE = (0.78, 0.38, 0.38)

TEETH = 5
"""Teeth on each side of the mid-plane, in each jaw."""


@dataclass(frozen=True, eq=False)
class Part:
    """One mesh in the neutral pose."""

    name: str
    points: Floats
    """(n, 3)"""
    faces: tuple[tuple[int, ...], ...]
    mirror: Indices
    """(n,) mirror vertex in the same mesh, or in the twin mesh for the eyeballs."""
    colors: Floats
    """(n, 3) linear display colours, or (1, 3)."""


def build_parts(head: Head) -> list[Part]:
    """All meshes, the head first."""
    return [
        Part("Head", head.points, head.faces, head.mirror, _skin_colors(head)),
        _whole("Brows", *_brow(), HAIR),
        _whole("Lashes", *_lash(head), HAIR),
        _whole("Hair", *_hair(), HAIR_TOP),
        _teeth("UpperTeeth", gum_y=-5.0, root_y=-5.65, edge_y=-6.42, front=7.35, half_width=2.0),
        _teeth("LowerTeeth", gum_y=-7.9, root_y=-7.15, edge_y=-6.45, front=7.08, half_width=1.88),
        _tongue(),
        _eyeball("EyeLeft", 1.0),
        _eyeball("EyeRight", -1.0),
    ]


def _whole(name: str, points: Floats, faces: list[tuple[int, ...]], color: tuple[float, ...]) -> Part:
    whole, both, mirror = reflect(points, faces)
    return Part(name, whole, both, mirror, np.array([color]))


# --- colours -----------------------------------------------------------------------------------------


def _skin_colors(head: Head) -> Floats:
    points = head.points
    colors = np.tile(np.array(SKIN), (len(points), 1))
    for centre, radii in (
        ((4.1, -2.8, 6.6), (2.2, 1.8, 2.5)),
        ((0.0, -3.3, 9.8), (1.1, 1.0, 1.2)),
        ((7.6, -1.0, -1.4), (2.2, 3.0, 2.4)),
    ):
        near = np.sum(((np.abs(points) * [1, 0, 0] + points * [0, 1, 1] - centre) / radii) ** 2, axis=1)
        colors += (0.55 * np.exp(-2.0 * near))[:, None] * (np.array(BLUSH) - colors)
    mouth, eye = head.loops["mouth"], head.loops["eye"]
    stains = [(mouth[2], LIP, 0.3), (mouth[3], LIP, 1.0), (mouth[4], LIP, 1.0), (mouth[5], INNER_MOUTH, 0.5)]
    stains += [(ring, INNER_MOUTH, 1.0) for ring in mouth[6:]]
    stains += [(eye[LID_MARGIN], LID_LINE, 0.55), (eye[LID_MARGIN + 1], LID_LINE, 0.9)]
    stains += [(head.loops["nostril"][2], INNER_MOUTH, 0.7)]
    for ring, stain, share in stains:
        for vertices in (ring, head.mirror[ring]):
            colors[vertices] += share * (np.array(stain) - colors[vertices])
    return np.round(colors, 3)


# --- eyeballs ----------------------------------------------------------------------------------------

_EYE_RINGS = (
    (7.5, (0.015, 0.015, 0.02)), (11.0, (0.015, 0.015, 0.02)), (12.3, (0.16, 0.30, 0.30)), (19.0, (0.24, 0.44, 0.42)),
    (24.5, (0.12, 0.27, 0.29)), (27.0, (0.04, 0.09, 0.11)), (29.3, (0.86, 0.86, 0.85)), (38.0, (0.93, 0.92, 0.90)),
    (50.0, (0.92, 0.89, 0.87)), (70.0, (0.90, 0.82, 0.79)), (95.0, (0.86, 0.72, 0.68)), (125.0, (0.80, 0.60, 0.56)),
)  # fmt: skip
"""Angle from the pupil's axis in degrees, colour."""
_EYE_SIDES = 20


def _eyeball(name: str, side: float) -> Part:
    """Sphere about the eye joint, pupil towards +Z, open at the back."""
    turn = 2 * np.pi * np.arange(_EYE_SIDES) / _EYE_SIDES
    rings = [np.array([[0.0, 0.0, 1.0]])]
    for degrees, _ in _EYE_RINGS:
        a = np.radians(degrees)
        rings.append(
            np.column_stack([side * np.sin(a) * np.sin(turn), np.sin(a) * np.cos(turn), np.full_like(turn, np.cos(a))])
        )
    points = np.round(EYE * [side, 1.0, 1.0] + EYE_RADIUS * np.concatenate(rings), 4)
    faces = _fan_and_tube(len(_EYE_RINGS), _EYE_SIDES)
    if side > 0:
        faces = [face[::-1] for face in faces]
    colors = np.concatenate([[_EYE_RINGS[0][1]], np.repeat([color for _, color in _EYE_RINGS], _EYE_SIDES, axis=0)])
    return Part(name, points, tuple(faces), np.arange(len(points)), colors)


def _fan_and_tube(rings: int, sides: int) -> list[tuple[int, ...]]:
    """Vertex 0 is the tip, then rings of `sides` vertices."""
    following = [(k, (k + 1) % sides) for k in range(sides)]
    faces: list[tuple[int, ...]] = [(0, 1 + a, 1 + b) for a, b in following]
    for ring in range(rings - 1):
        near, far = 1 + ring * sides, 1 + (ring + 1) * sides
        faces.extend((near + a, far + a, far + b, near + b) for a, b in following)
    return faces


# --- teeth and tongue --------------------------------------------------------------------------------


def _teeth(name: str, gum_y: float, root_y: float, edge_y: float, front: float, half_width: float) -> Part:
    """An arch of teeth with their gum: rows from the gum over the biting edge to the back."""
    per_tooth = 4
    columns = TEETH * per_tooth + 1
    along = np.linspace(0.0, 1.0, columns)
    phase = np.arange(columns) % per_tooth / per_tooth
    gap = np.where(phase == 0.0, 1.0, 0.0)
    angle = along * np.radians(82)
    down = np.sign(edge_y - root_y)
    edge = edge_y - down * (0.10 * gap + 0.25 * along**2)
    root = root_y + down * 0.16 * gap
    rows = []
    for y, inset in ((gum_y, 0.10), (root - down * 0.05, -0.02), (root + down * 0.04, 0.02), ((root + edge) / 2, -0.03),
                     (edge, 0.08), (edge, 0.30), (root, 0.50), (gum_y, 0.55)):  # fmt: skip
        shrink = inset + 0.07 * gap
        x, z = (half_width - shrink) * np.sin(angle), front - 2.9 + (2.9 - shrink) * np.cos(angle)
        rows.append(np.column_stack([x, np.broadcast_to(y, x.shape), z]))
    points = np.concatenate(rows)
    quads = _sheet(len(rows), columns)
    faces = [face[::-1] for face in quads] if down < 0 else quads
    shades = np.repeat([GUM, GUM, TOOTH, TOOTH, TOOTH, TOOTH, GUM, GUM], columns, axis=0)
    whole, both, mirror = reflect(points, faces)
    return Part(name, whole, both, mirror, np.concatenate([shades, shades[points[:, 0] > 1e-6]]))


def _sheet(rows: int, columns: int) -> list[tuple[int, ...]]:
    return [
        (row * columns + k, row * columns + k + 1, (row + 1) * columns + k + 1, (row + 1) * columns + k)
        for row in range(rows - 1)
        for k in range(columns - 1)
    ]


def _tongue() -> Part:
    """Half a flattened tube from the throat to a rounded tip."""
    lengths = np.array([1.0, 0.985, 0.93, 0.84, 0.72, 0.58, 0.44, 0.30, 0.15, 0.0])
    turn = np.linspace(np.pi / 2, -np.pi / 2, 9)
    width = 1.25 * np.sqrt(np.clip(1.0 - lengths**9, 0.0, 1.0)) * (0.85 + 0.15 * lengths)
    thick = 0.48 * np.sqrt(np.clip(1.0 - lengths**6, 0.0, 1.0))
    groove = 1.0 - 0.35 * np.exp(-((np.cos(turn) / 0.28) ** 2)) * (turn > 0)
    rows = [
        np.column_stack(
            [w * np.cos(turn), -7.05 - 0.45 * (1 - s) ** 2 + t * np.sin(turn) * groove, np.full(9, 1.8 + 4.75 * s)]
        )
        for s, w, t in zip(lengths, width, thick, strict=True)
    ]
    rows[0][:, 0] = 0.06 * np.cos(turn)
    points = np.concatenate(rows)
    points[np.arange(len(rows)) * 9, 0] = points[np.arange(len(rows)) * 9 + 8, 0] = 0.0
    whole, both, mirror = reflect(points, _sheet(len(rows), 9))
    return Part("Tongue", whole, both, mirror, np.array([TONGUE]))


# --- hair --------------------------------------------------------------------------------------------


def _brow() -> tuple[Floats, list[tuple[int, ...]]]:
    """A tapered, flattened tube laid on the brow ridge."""
    stations, sides = 11, 6
    t = np.linspace(0.0, 1.0, stations)
    x = 1.15 + 4.1 * t
    y = 2.84 + 0.50 * np.sin(np.pi * np.clip(t * 0.80 + 0.04, 0, 1)) - 0.25 * t**3
    spine = form.cast(np.column_stack([x, y, 0 * x]), np.repeat([[0.0, 0.0, 1.0]], stations, axis=0), reach=14.0)
    normal = form.normals(spine)
    along = np.gradient(spine, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    up = np.cross(normal, along)
    swell = np.sqrt(np.clip(1.0 - (1.6 * np.clip(0.42 - t, 0, 1)) ** 2, 0, 1)) * (1.0 - t**2.2) + 0.05
    height, depth = 0.34 * swell, 0.17 * swell + 0.02
    turn = 2 * np.pi * np.arange(sides) / sides
    rings = [
        spine[k]
        + normal[k] * 0.05
        + np.outer(np.cos(turn) * height[k], up[k])
        + np.outer(np.sin(turn) * depth[k], normal[k])
        for k in range(stations)
    ]
    inner, outer = rings[0].mean(axis=0) - along[0] * 0.12, rings[-1].mean(axis=0) + along[-1] * 0.1
    points = np.concatenate([[inner], *rings, [outer]])
    faces = _fan_and_tube(stations, sides)
    last = len(points) - 1
    faces += [(last, last - sides + (k + 1) % sides, last - sides + k) for k in range(sides)]
    return points, [face[::-1] for face in faces]


def _lash(head: Head) -> tuple[Floats, list[tuple[int, ...]]]:
    """Upper lashes: a curved strip out of the upper lid's edge, three rows of thirteen."""
    root = head.points[head.loops["eye"][LID_MARGIN][:13]]
    share = np.arange(13) / 12.0
    away = root - EYE
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    length = (0.06 + 0.24 * np.sin(np.pi * share**1.3) + 0.5 * share**3 * (1.0 - share))[:, None]
    sweep = np.column_stack([0.9 * (share - 0.35), np.full(13, 0.15), np.zeros(13)])
    middle = root + length * 0.55 * (away + 0.4 * sweep)
    tip = root + length * (away + sweep + [0.0, 0.45, -0.1])
    return np.concatenate([root, middle, tip]), _sheet(3, 13)


_HAIR_CENTRE = np.array([0.0, 2.0, -1.0])
_HAIR_LINE = (
    (0, 30),
    (25, 31),
    (45, 37),
    (56, 28),
    (66, -4),
    (74, -8),
    (82, 6),
    (98, 8),
    (114, 2),
    (126, -26),
    (150, -44),
    (180, -47),
)
"""Azimuth from the front and height of the hairline as seen from the centre, degrees."""
_HAIR_DEPTHS = (0.80, 0.80, 0.80, 0.80, 0.78, 0.75, 0.70, 0.62, 0.50, 0.30, -0.12)
"""Thickness of the hair from the crown to the hairline."""


def _hair() -> tuple[Floats, list[tuple[int, ...]]]:
    """Short hair combed from the crown: half a shell over the skull with ridges along the strands."""
    columns = 40
    azimuth, height = np.radians(np.array(_HAIR_LINE, dtype=float).T)
    turn = np.linspace(0.0, np.pi, columns + 1)
    line = np.interp(turn, azimuth, height)
    line[1:-1] = (line[:-2] + 2 * line[1:-1] + line[2:]) / 4
    ends = np.column_stack([np.cos(line) * np.sin(turn), np.sin(line), np.cos(line) * np.cos(turn)])
    crown = np.array([0.0, np.cos(np.radians(28)), -np.sin(np.radians(28))])
    arc = np.arccos(np.clip(ends @ crown, -1.0, 1.0))[:, None]
    rows = len(_HAIR_DEPTHS)
    shares = np.append(np.linspace(1.0 / rows, 0.975, rows - 1), 1.0)
    rings = []
    for row, (share, depth) in enumerate(zip(shares, _HAIR_DEPTHS, strict=True)):
        rays = (np.sin((1 - share) * arc) * crown + np.sin(share * arc) * ends) / np.sin(arc)
        rays[[0, -1], 0] = 0.0
        skin = form.cast(np.repeat(_HAIR_CENTRE[None], columns + 1, axis=0), rays, reach=16.0)
        strand = (
            0.17 * np.cos(np.arange(columns + 1) * np.pi * 0.5 + 0.8 * share) * np.sin(np.pi * min(share * 1.1, 1.0))
        )
        lift = depth * (1.0 + 0.35 * np.clip(np.cos(turn), 0.0, 1.0) * share) + (strand if row < rows - 1 else 0.0)
        rings.append(skin + form.normals(skin) * lift[:, None])
        rings[-1][[0, -1], 0] = 0.0
    top = form.cast(_HAIR_CENTRE[None], crown[None], reach=16.0) + crown * 0.72
    faces: list[tuple[int, ...]] = [(0, 1 + k, 2 + k) for k in range(columns)]
    faces += [tuple(1 + vertex for vertex in face[::-1]) for face in _sheet(rows, columns + 1)]
    return np.concatenate([top, *rings]), faces
