"""The head mesh: the cage laid on the form, features shaped loop by loop, mirrored into a whole."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import form
from .cage import BLOCKS, CAP_LENGTH, CAP_WIDTH, COLUMNS, ROWS, Cage, cap_key, half_cage
from .form import EYE, EYE_RADIUS, LID_RADIUS, Floats

Indices = NDArray[np.int64]

LID_MARGIN = 4
"""Loop of the lid's outer edge; the next one is the inner edge."""
LIP_EDGE = 4
"""Loop along which the lips meet."""
NECK_Y = -15.2
RELAX_ROUNDS = 60


@dataclass(frozen=True, eq=False)
class Head:
    """The whole head; the left half (x >= 0) comes first."""

    points: Floats
    """(n, 3)"""
    faces: tuple[tuple[int, ...], ...]
    mirror: Indices
    """(n,) the vertex at the mirrored place; itself on the mid-plane."""
    loops: dict[str, Indices]
    """Per feature of the left half, (loops, places) vertices."""


def build_head() -> Head:
    """Model the neutral head."""
    cage = half_cage()
    points, fixed = _first_guess(cage)
    points = _relax(cage, points, fixed)
    return _mirrored(cage, points)


# --- laying the cage on the form ---------------------------------------------------------------------

# fmt: off
_FRONT_Y = [10.7, 9.7, 8.4, 7.0, 5.6, 4.2, 2.7, 1.5, 0.4, -0.6, -1.3, -1.7, -2.15, -2.6, -3.05, -3.55, -3.85, -4.15,
            -4.55, -5.05, -5.9, -6.5, -7.3, -8.15, -8.7, -9.2, -9.7, -10.1, -10.3, -10.3, -10.4, -11.0, -12.0, -13.0,
            -14.1, NECK_Y]
_FRONT_Z = [3.4, 5.0, 6.4, 7.3, 7.8, 8.0, 7.8, 7.8, 7.8, 8.2, 8.7, 9.2, 9.6, 10.0, 10.6, 10.3, 9.6, 8.75,
            8.2, 8.2, 8.2, 8.2, 8.0, 7.8, 7.8, 7.8, 7.5, 6.6, 5.3, 3.8, 2.2, 0.8, 0.1, 0.0, 0.0, 0.0]
"""Height and depth of each row on the mid-plane, to aim by."""
_NOSE = {
    11: ((0.00, -1.70, 8.95), (0.34, -1.72, 8.80), (0.61, -1.80, 8.35), (0.98, -1.95, 7.75)),
    12: ((0.00, -2.15, 9.35), (0.37, -2.20, 9.15), (0.65, -2.30, 8.75),
         (1.02, -2.45, 8.15), (1.40, -2.40, 7.75), (1.91, -2.35, 7.45)),
    13: ((0.00, -2.60, 9.95), (0.39, -2.65, 9.75), (0.71, -2.75, 9.25),
         (1.12, -2.85, 8.75), (1.51, -2.90, 8.35), (1.95, -2.85, 7.65)),
    14: ((0.00, -3.05, 10.25), (0.42, -3.10, 10.05), (0.79, -3.15, 9.55),
         (1.26, -3.20, 9.15), (1.67, -3.40, 8.50), (1.97, -3.40, 7.75)),
    15: ((0.00, -3.55, 10.00), (0.35, -3.62, 9.65), (0.73, -3.65, 9.45),
         (1.19, -3.70, 9.10), (1.63, -3.78, 8.45), (1.95, -3.85, 7.65)),
    16: ((0.00, -3.85, 9.25), (0.28, -3.92, 8.95), (0.74, -4.00, 8.65),
         (1.44, -4.00, 8.40), (1.67, -4.02, 8.05), (1.95, -4.20, 7.55)),
    17: ((0.00, -4.15, 8.40), (0.37, -4.12, 8.15), (0.84, -4.15, 8.00),
         (1.32, -4.15, 7.90), (1.72, -4.35, 7.60), (2.05, -4.50, 7.45)),
}
"""Row: places of its first columns, laid on the form; rows 15 to 17 frame the nostril."""
# fmt: on


def _first_guess(cage: Cage) -> tuple[Floats, NDArray[np.bool_]]:
    """Positions of all vertices and which of them must stay."""
    points = np.zeros((len(cage.number), 3))
    fixed = np.zeros(len(points), dtype=bool)
    _lay_grid(cage, points)
    _lay_cap(cage, points)
    nose = {
        cage.grid(row, column): place for row, places in _NOSE.items() for column, place in _on_grid(cage, row, places)
    }
    points[list(nose)] = form.project(np.array(list(nose.values())), rounds=8)
    fixed[list(nose)] = True
    outline = points[cage.loops["nostril"][0]]
    for name, loops in (
        ("eye", _eye_loops()),
        ("mouth", _mouth_loops()),
        ("ear", _ear_loops()),
        ("nostril", _nostril_loops(outline)),
    ):
        rings = np.array(cage.loops[name])
        points[rings] = loops
        fixed[rings if name == "nostril" else rings[1:]] = True
    for name in cage.fills:
        _lay_fill(cage, name, points)
        fixed[cage.fills[name]] = True
    fixed[[cage.grid(ROWS - 1, column) for column in range(COLUMNS + 1)]] = True
    return points, fixed


def _on_grid(cage: Cage, row: int, places: Sequence[tuple[float, ...]]) -> list[tuple[int, tuple[float, ...]]]:
    return [(column, place) for column, place in enumerate(places) if ("grid", row, column) in cage.number]


def _azimuths() -> Floats:
    """Angle of each column from the front, degrees: dense over the face."""
    return np.radians(np.interp(np.arange(COLUMNS + 1), [0, 4, 12, 16, 20, COLUMNS], [0, 14, 58, 84, 106, 180]))


def _lay_grid(cage: Cage, points: Floats) -> None:
    steps = np.arange(ROWS)
    back_y = np.interp(steps, [0, 27, ROWS - 1], [10.7, -8.5, NECK_Y])
    back_z = np.interp(back_y, [NECK_Y, -8.5, -4.0, 2.0, 8.0, 10.7], [-8.2, -6.6, -8.2, -10.3, -9.2, -5.9])
    front = np.stack([np.zeros(ROWS), _FRONT_Y, _FRONT_Z], axis=1)
    back = np.stack([np.zeros(ROWS), back_y, back_z], axis=1)
    centre = (front + back) / 2
    turn = _azimuths()
    for row in steps:
        ahead = np.where(np.cos(turn)[:, None] >= 0, front[row] - centre[row], centre[row] - back[row])
        side = np.linalg.norm(front[row] - back[row]) / 2
        rays = ahead * np.cos(turn)[:, None] + np.outer(np.sin(turn) * side, [1.0, 0.0, 0.0])
        hits = form.cast(np.repeat(centre[row][None], len(turn), axis=0), rays, reach=18.0)
        hits[[0, -1], 0] = 0.0
        if row == ROWS - 1:
            hits[:, 1] = NECK_Y
        for column, hit in enumerate(hits):
            if ("grid", row, column) in cage.number:
                points[cage.grid(int(row), column)] = hit


def _lay_cap(cage: Cage, points: Floats) -> None:
    keys = [key for key in cage.number if isinstance(key, tuple) and key[0] == "cap"]
    for _, step, along in keys:
        rim = points[cage.vertex(cap_key(CAP_WIDTH, along))]
        t = along / CAP_LENGTH
        front, back = points[cage.vertex(cap_key(step, 0))], points[cage.vertex(cap_key(step, CAP_LENGTH))]
        across = rim * [step / CAP_WIDTH, 1.0, 1.0]
        lengthwise = front + (back - front) * t
        points[cage.vertex(("cap", step, along))] = [across[0], 12.0, (across[2] + lengthwise[2]) / 2]
    numbers = [cage.vertex(key) for key in keys]
    points[numbers] = form.project(points[numbers], rounds=8)


def _lay_fill(cage: Cage, name: str, points: Floats) -> None:
    """Spread the inner vertices of a closed loop by relaxation."""
    inner = cage.fills[name]
    points[inner] = points[cage.loops[name][-1]].mean(axis=0)
    neighbours, valence = _neighbours(cage)
    for _ in range(80):
        points[inner] = _average(points, neighbours, valence)[inner]


def _neighbours(cage: Cage) -> tuple[Indices, Indices]:
    """(n, k) neighbours padded with the vertex itself, and (n,) their number."""
    rings: list[set[int]] = [set() for _ in cage.number]
    for face in cage.faces:
        for a, b in zip(face, (*face[1:], face[0]), strict=True):
            rings[a].add(b)
            rings[b].add(a)
    width = max(map(len, rings))
    table = np.array([[*sorted(ring), *([own] * (width - len(ring)))] for own, ring in enumerate(rings)])
    return table, np.array([len(ring) for ring in rings])


def _average(points: Floats, neighbours: Indices, valence: Indices) -> Floats:
    padding = neighbours.shape[1] - valence
    return np.asarray((points[neighbours].sum(axis=1) - padding[:, None] * points) / valence[:, None])


def _relax(cage: Cage, points: Floats, fixed: NDArray[np.bool_]) -> Floats:
    """Even out the free vertices on the form."""
    neighbours, valence = _neighbours(cage)
    middle = np.abs(points[:, 0]) < 1e-9
    free = np.flatnonzero(~fixed)
    for _ in range(RELAX_ROUNDS):
        goal = _average(points, neighbours, valence)
        goal[middle, 0] = 0.0
        moved = points[free] + 0.5 * (goal[free] - points[free])
        points[free] = form.project(moved, rounds=1)
        points[middle, 0] = 0.0
    points[free] = form.project(points[free])
    points[middle, 0] = 0.0
    return points


def _mirrored(cage: Cage, points: Floats) -> Head:
    whole, faces, mirror = reflect(points, cage.faces)
    return Head(whole, faces, mirror, {name: np.array(rings) for name, rings in cage.loops.items()})


def reflect(points: Floats, faces: list[tuple[int, ...]]) -> tuple[Floats, tuple[tuple[int, ...], ...], Indices]:
    """Add the right half to a left half (x >= 0): points rounded to 1e-4, faces and (n,) mirror vertices."""
    points = np.round(points, 4) + 0.0
    count = len(points)
    off_plane = np.flatnonzero(points[:, 0] > 1e-6)
    twin = np.arange(count)
    twin[off_plane] = count + np.arange(len(off_plane))
    whole = np.concatenate([points, points[off_plane] * [-1.0, 1.0, 1.0]])
    others = [tuple(int(twin[vertex]) for vertex in face[::-1]) for face in faces]
    return whole, (*faces, *others), np.concatenate([twin, off_plane])


# --- features ----------------------------------------------------------------------------------------


def _front(x: Floats, y: Floats) -> Floats:
    """Points of the form seen from the front at (x, y)."""
    origin = np.stack([x, y, np.zeros_like(x)], axis=1)
    return form.cast(origin, np.repeat([[0.0, 0.0, 1.0]], len(x), axis=0), reach=14.0)


def lid_contour(grow: float, above: float, below: float) -> tuple[Floats, Floats]:
    """x, y of an almond loop round the lid slit: wider by `grow`, its lids raised and lowered.

    24 places, clockwise from the inner corner over the upper lid, the outer corner at 12.
    """
    angle = np.linspace(0.0, 2 * np.pi, 24, endpoint=False)
    x = EYE[0] + 0.08 - (1.54 + grow) * np.cos(angle)
    arch = np.sin(angle)
    tilt = -0.14 * np.cos(angle) - 0.02
    upper = (0.90 + above) * np.abs(arch) ** 1.15 * (1.0 + 0.10 * np.cos(angle))
    lower = (0.70 + below) * np.abs(arch) ** 1.15 * (1.0 - 0.12 * np.cos(angle))
    return x, EYE[1] + tilt + np.where(arch >= 0, upper, -lower)


def _on_ball(x: Floats, y: Floats, radius: float) -> Floats:
    """Points of the eye's concentric sphere seen from the front at (x, y), or its rim outside."""
    flat = np.stack([x - EYE[0], y - EYE[1]], axis=1)
    length = np.linalg.norm(flat, axis=1)
    flat *= np.minimum(1.0, 0.97 * radius / length)[:, None]
    depth = np.sqrt(radius**2 - (flat**2).sum(axis=1))
    return np.asarray(EYE + np.column_stack([flat, depth]))


def _eye_loops() -> Floats:
    angle = np.pi - np.linspace(0.0, 2 * np.pi, 24, endpoint=False)
    outline = _front(3.2 + 2.5 * np.cos(angle), 0.35 + 2.35 * np.sin(angle))
    socket = _front(3.13 + 1.96 * np.cos(angle), 0.2 + 1.78 * np.sin(angle))
    crease = _front(*lid_contour(0.30, 0.42, 0.34))
    crease[:, 2] -= 0.10 * np.clip(np.sin(angle), 0.0, 1.0)
    lid = _front(*lid_contour(0.13, 0.20, 0.15))
    slit = lid_contour(0.0, 0.0, 0.0)
    back = [_on_ball(*lid_contour(0.12, 0.25, 0.25), EYE_RADIUS + 0.06)]
    back += [_on_ball(*lid_contour(0.16, 0.55, 0.60), EYE_RADIUS + 0.10)]
    return np.array([outline, socket, crease, lid, _on_ball(*slit, LID_RADIUS - 0.03),
                     _on_ball(*lid_contour(-0.02, -0.02, -0.02), EYE_RADIUS + 0.05), *back])  # fmt: skip


def _mouth_loop(half_width: float, top: float, bottom: float, corner_y: float) -> tuple[Floats, Floats]:
    """x, y of half an ellipse-like loop, 17 places from the top over the corner (place 8) to the bottom."""
    angle = np.linspace(np.pi / 2, -np.pi / 2, 17)
    y = np.where(
        angle >= 0, corner_y + (top - corner_y) * np.sin(angle), corner_y + (corner_y - bottom) * np.sin(angle)
    )
    return half_width * np.cos(angle), y


def _mouth_loops() -> Floats:
    angle = np.linspace(np.pi / 2, -np.pi / 2, 17)
    upper = angle > 0
    x = np.cos(angle)
    outline = _front(*_mouth_loop(3.35, -4.85, -8.35, -6.45))
    muzzle = _front(*_mouth_loop(2.8, -5.12, -7.75, -6.42))
    s = x * 2.12
    meet = (
        -6.30 + 0.22 * x**3 - 0.07 * np.exp(-((s / 0.45) ** 2)) + 0.06 * np.exp(-(((s - 0.9) / 0.6) ** 2)) - 0.05 * x**4
    )
    bow = -5.60 - 0.10 * np.exp(-((s / 0.3) ** 2)) + 0.04 * np.exp(-(((s - 0.55) / 0.35) ** 2))
    rise = np.sqrt(np.clip(1.0 - x**2.4, 0.0, 1.0))
    border_y = np.where(upper, meet + (bow - meet) * rise**1.2, meet + (-7.14 - meet) * rise**0.9)
    border = _front(x * 2.26, border_y)
    full = rise**0.8
    body_y = meet + (border_y - meet) * 0.52
    body = _front(s * 1.03, body_y)
    body[:, 2] += np.where(upper, 0.24, 0.34) * full
    edge_y = meet + np.where(upper, 0.01, -0.01) * full
    edge = _front(s, edge_y)
    edge[:, 2] += np.where(upper, 0.12, 0.16) * full - 0.12
    inside = edge + np.stack([-0.02 * x, np.where(upper, -0.09, 0.09) * full, np.full(17, -0.4)], axis=1)
    behind = inside + np.stack([0.05 * x, np.where(upper, 0.44, -0.44) * full, np.full(17, -0.45)], axis=1)
    bags = []
    for width, top, bottom, depth, corner_depth in (
        (2.5, -4.9, -8.0, 6.1, 4.6),
        (2.7, -4.5, -8.3, 4.0, 3.4),
        (1.6, -5.2, -7.4, 1.4, 1.4),
    ):
        bx, by = _mouth_loop(width, top, bottom, -6.35)
        bags.append(np.stack([bx, by, depth + (corner_depth - depth) * x**3], axis=1))
    loops = np.array([outline, muzzle, border, body, edge, inside, behind, *bags])
    loops[:, [0, -1], 0] = 0.0
    return loops


def _nostril_loops(outline: Floats) -> Floats:
    """The outline on the underside of the nose, a rim within it and the hole above."""
    centre = outline.mean(axis=0)
    rim = form.project(centre + 0.70 * (outline - centre), rounds=6)
    hole = centre + 0.55 * (outline - centre) + [0.02, 0.45, -0.05]
    return np.array([outline, rim, hole])


def _ear_loops() -> Floats:
    """Ear in its own plane: `back` along the head, `up`, and `out` away from it."""
    count = len(BLOCKS["ear"].outline())
    angle = np.pi - np.linspace(0.0, 2 * np.pi, count, endpoint=False)
    back, up, out = np.array([0.20, -0.12, -0.97]), np.array([0.05, 0.98, -0.16]), np.array([0.97, 0.0, 0.20])
    foot = np.array([6.65, -1.2, -0.9])
    c, s = np.cos(angle), np.sin(angle)
    egg = 1.0 + 0.22 * s
    root = form.project(foot + np.outer(1.1 * c + 0.30, [0.0, 0.0, -1.0]) + np.outer(2.15 * s + 0.1, up), rounds=8)
    stem = form.project(foot + np.outer(0.8 * c + 0.32, [0.0, 0.0, -1.0]) + np.outer(1.8 * s + 0.1, up), rounds=8)

    def ring(width: float, height: float, shift: float, lift: float, fold: float) -> Floats:
        a = 0.9 * width * c * egg + shift
        free = (1.0 + c) / 2
        away = 0.85 * (lift * (0.45 + 0.55 * free) + fold * free)
        return foot + np.outer(a, back) + np.outer(0.9 * height * s + 0.1, up) + np.outer(away, out)

    behind = ring(1.15, 2.35, 0.55, 0.20, 0.20)
    rim = ring(1.50, 2.70, 0.75, 0.36, 0.50)
    front = ring(1.33, 2.48, 0.72, 0.55, 0.52)
    groove = ring(1.10, 2.12, 0.62, 0.40, 0.28)
    fold = ring(0.85, 1.55, 0.45, 0.46, 0.28)
    concha = ring(0.55, 0.95, 0.25, 0.05, 0.0)
    return np.array([root, stem, behind, rim, front, groove, fold, concha])
