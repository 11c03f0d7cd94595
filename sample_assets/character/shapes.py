"""The controls: offsets of every mesh per control, named in the ARKit manner.

A sculptor's function gives the offsets of all points at once, for the left control of a pair or for a control
symmetric about the mid-plane.  The right control is the exact mirror image; a symmetric one is averaged with its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from .form import EYE, EYE_RADIUS, LID_RADIUS, Floats
from .head import LID_MARGIN, Head, Indices
from .parts import Part

JAW_PIVOT = np.array([0.0, -2.6, -0.3])
"""A point of the axis through the jaw joints, which runs along X."""
JAW_OPEN_DEGREES = 19.0
NECK_PIVOT = np.array([0.0, -8.5, -1.5])
_LIP_PULL = (0, 0, 0, 0.01, 0.04, 0.10, 0.20, 0.34, 0.5, 0.66, 0.80, 0.90, 0.96, 0.99, 1, 1, 1)
"""Pull of the jaw round each loop of the mouth, from the middle of the upper lip to that of the lower."""
SMALLEST = 4e-4
"""Offsets shorter than this in every coordinate are dropped."""


@dataclass(frozen=True, eq=False)
class Body:
    """All meshes as one cloud with the fields that the sculptor's functions use; lids of the left eye only."""

    points: Floats
    """(n, 3)"""
    mirror: Indices
    starts: Indices
    """(parts + 1,) first point of each part."""
    jaw: Floats
    """(n,) 1 what hangs on the lower jaw, 0 the rest, smooth between; the lips are told apart by it."""
    soft: Floats
    """(n,) 1 on skin and hair."""
    lid: Floats
    """(n,) share of the lid's travel: 1 at its edge, 0 at the socket."""
    lid_close: Floats
    """(n,) angle about the eye's X axis from open to shut, radians."""
    tongue: Floats
    """(n,) 0 at the root of the tongue, 1 at its tip; 0 elsewhere."""
    mouth_corner: Floats
    """(3,) left corner of the mouth."""


@dataclass(frozen=True, eq=False)
class ControlShape:
    """One control: offsets of the whole body at each in-between weight and at 1."""

    name: str
    weights: tuple[float, ...]
    """Ascending, the last is 1."""
    offsets: Floats
    """(k, n, 3)"""


Sculptor = Callable[[Body, float], Floats]
"""Offsets (n, 3) at a weight in (0, 1]."""


def build_body(head: Head, parts: list[Part]) -> Body:
    """Join the parts and measure the fields."""
    starts = np.cumsum([0, *(len(part.points) for part in parts)])
    mirror = np.concatenate([start + part.mirror for start, part in zip(starts, parts, strict=False)])
    at = {part.name: slice(start, start + len(part.points)) for start, part in zip(starts, parts, strict=False)}
    left, right = at["EyeLeft"], at["EyeRight"]
    count = int(starts[-1])
    mirror[left], mirror[right] = np.arange(count)[right], np.arange(count)[left]
    points = np.concatenate([part.points for part in parts])
    jaw, soft, tongue = np.zeros(count), np.zeros(count), np.zeros(count)
    jaw[at["Head"]] = jaw_weights(head)
    jaw[at["LowerTeeth"]] = jaw[at["Tongue"]] = 1.0
    for name in ("Head", "Brows", "Lashes"):
        soft[at[name]] = 1.0
    z = points[at["Tongue"], 2]
    tongue[at["Tongue"]] = (z - z.min()) / np.ptp(z)
    lid, close = _lid_fields(head, at["Lashes"].start, count)
    return Body(points, mirror, starts, jaw, soft, lid, close, tongue, head.points[head.loops["mouth"][2][8]])


def build_controls(body: Body) -> list[ControlShape]:
    """All controls in the order of the animation."""
    made = []
    for name, (sculptor, weights) in PAIRS.items():
        left = np.array([sculptor(body, weight) for weight in weights])
        left_name, right_name = _pair_names(name)
        made.append(_control(left_name, weights, left))
        made.append(_control(right_name, weights, left[:, body.mirror] * [-1.0, 1.0, 1.0]))
    for name, (sculptor, weights) in MIDDLE.items():
        whole = np.array([sculptor(body, weight) for weight in weights])
        made.append(_control(name, weights, (whole + whole[:, body.mirror] * [-1.0, 1.0, 1.0]) / 2))
    return sorted(made, key=lambda control: control.name)


def jaw_weights(head: Head) -> Floats:
    """(n,) pull of the lower jaw on the skin: fixed on lips, chin, skull and neck, harmonic in between."""
    points, mouth = head.points, head.loops["mouth"]
    _, y, z = points.T
    weight = np.full(len(points), 0.3)
    held = (y > -3.2) | (y < -11.6) | (z < -1.5)
    weight[held] = 0.0
    chin = (y < -8.2) & (z > 4.0) & (y > -10.6)
    weight[chin] = 1.0
    lips = np.array(_LIP_PULL)
    for ring in mouth[2:]:
        for vertices in (ring, head.mirror[ring]):
            weight[vertices] = lips
    seeds = held | chin
    seeds[mouth[2:]] = seeds[head.mirror[mouth[2:]]] = True
    edges = np.array([(a, b) for face in head.faces for a, b in zip(face, (*face[1:], face[0]), strict=True)])
    edges = np.unique(np.concatenate([edges, edges[:, ::-1]]), axis=0)
    valence = np.bincount(edges[:, 0], minlength=len(points))
    for _ in range(600):
        mean = np.bincount(edges[:, 0], weights=weight[edges[:, 1]], minlength=len(points)) / valence
        weight = np.where(seeds, weight, mean)
    return np.asarray(np.round((weight + weight[head.mirror]) / 2, 4))


def _lid_fields(head: Head, lash_start: int, count: int) -> tuple[Floats, Floats]:
    rings = head.loops["eye"]
    lid, close = np.zeros(count), np.zeros(count)
    edge = head.points[rings[LID_MARGIN]] - EYE
    angle = np.arctan2(edge[:, 1], edge[:, 2])
    partner = -np.arange(24) % 24
    upper = np.arange(24) <= 12
    low, high = np.where(upper, angle[partner], angle), np.where(upper, angle, angle[partner])
    travel = low + 0.22 * (high - low) - angle
    for ring, share in zip(rings, (0.0, 0.10, 0.52, 0.84, 1.0, 1.0, 1.0, 1.0), strict=True):
        lid[ring], close[ring] = share, travel
    lashes = lash_start + np.arange(39)
    lid[lashes], close[lashes] = 1.0, np.tile(travel[:13], 3)
    return lid, close


def _pair_names(name: str) -> tuple[str, str]:
    """Left and right name of a pair."""
    return name.replace("*", "Left"), name.replace("*", "Right")


def _control(name: str, weights: tuple[float, ...], offsets: Floats) -> ControlShape:
    offsets = np.round(offsets, 4) + 0.0
    offsets[:, np.abs(offsets).max(axis=(0, 2)) < SMALLEST] = 0.0
    return ControlShape(name, weights, offsets)


# --- brushes -----------------------------------------------------------------------------------------


def _bump(body: Body, centre: tuple[float, ...] | Floats, radii: tuple[float, ...]) -> Floats:
    """(n, 1) smooth, compact falloff on the skin."""
    d = np.sum(((body.points - np.asarray(centre)) / radii) ** 2, axis=1)
    return np.asarray((np.clip(1.0 - d, 0.0, None) ** 2 * body.soft)[:, None])


def _left(body: Body, width: float = 0.9) -> Floats:
    """(n, 1) 1 on the left, 0 on the right, smooth across the mid-plane."""
    t = np.clip(0.5 + body.points[:, :1] / (2 * width), 0.0, 1.0)
    return np.asarray(t * t * (3 - 2 * t))


def _lower(body: Body) -> Floats:
    return body.jaw[:, None]


def _upper(body: Body) -> Floats:
    return 1.0 - body.jaw[:, None]


def _off_lids(body: Body) -> Floats:
    """(n, 1) keeps the brows from dragging the edges of the lids."""
    both = np.maximum(body.lid, body.lid[body.mirror])
    return (1.0 - both)[:, None]


def _turn_x(points: Floats, pivot: Floats, angle: Floats) -> Floats:
    """Offsets of a rotation about the X axis through `pivot`, positive from +Y to +Z, by `angle` (n,)."""
    r = points - pivot
    c, s = np.cos(angle), np.sin(angle)
    turned = np.column_stack([r[:, 0], c * r[:, 1] - s * r[:, 2], s * r[:, 1] + c * r[:, 2]])
    return turned - r


def _roll_lids(body: Body, shut: Floats) -> Floats:
    """Turn the lids about the eye by `shut` (n,) radians and keep their skin outside the closed lid's ball."""
    moved = body.points + _turn_x(body.points, EYE, -shut)
    r = moved - EYE
    length = np.linalg.norm(r, axis=1)
    start = np.linalg.norm(body.points - EYE, axis=1)
    least = np.minimum(np.maximum(start, EYE_RADIUS + 0.05), LID_RADIUS)
    skin = (body.lid > 0.3) & (body.lid < 0.99)
    least = np.where(skin, LID_RADIUS, least)
    push = np.where((np.abs(shut) > 1e-9) & (length < least), least / np.maximum(length, 1e-9), 1.0)
    return np.asarray(EYE + r * push[:, None] - body.points)


# --- sculptors: eyes and brows -----------------------------------------------------------------------


def _blink(body: Body, w: float) -> Floats:
    return _roll_lids(body, w * body.lid * body.lid_close)


def _wide(body: Body, w: float) -> Floats:
    upper = body.lid_close < 0
    return _roll_lids(body, w * body.lid * body.lid_close * np.where(upper, -0.30, -0.35))


def _squint(body: Body, w: float) -> Floats:
    upper = body.lid_close < 0
    roll = _roll_lids(body, w * body.lid * body.lid_close * np.where(upper, 0.22, 1.25))
    return roll + w * _off_lids(body) * _bump(body, (3.4, -2.2, 7.0), (2.6, 1.5, 2.6)) * [0.0, 0.45, 0.18]


def _brow_down(body: Body, w: float) -> Floats:
    knit = _bump(body, (2.0, 2.6, 7.4), (2.6, 2.0, 3.0)) * [-0.32, -0.62, 0.12]
    return (
        w
        * _left(body, 0.7)
        * _off_lids(body)
        * (knit + _bump(body, (4.2, 2.9, 6.4), (2.6, 1.9, 3.0)) * [-0.05, -0.38, 0.05])
    )


def _brow_inner_up(body: Body, w: float) -> Floats:
    return w * _off_lids(body) * _bump(body, (0.0, 3.0, 7.4), (3.2, 2.6, 3.2)) * [0.0, 1.05, -0.05]


def _brow_outer_up(body: Body, w: float) -> Floats:
    return w * _off_lids(body) * _bump(body, (4.1, 3.2, 6.3), (2.5, 2.5, 3.2)) * [0.05, 0.95, -0.2]


# --- sculptors: jaw and tongue -----------------------------------------------------------------------


def _jaw_open(body: Body, w: float) -> Floats:
    return _turn_x(body.points, JAW_PIVOT, w * np.radians(JAW_OPEN_DEGREES) * body.jaw)


def _jaw_left(body: Body, w: float) -> Floats:
    return w * _lower(body) * [0.95, 0.0, -0.12]


def _jaw_forward(body: Body, w: float) -> Floats:
    return w * _lower(body) * [0.0, -0.12, 0.85]


def _tongue_out(body: Body, w: float) -> Floats:
    """Forward over the lower teeth, then down: a curved way."""
    s = body.tongue[:, None]
    lift = 0.55 * np.sin(np.pi * min(w * 1.25, 1.0)) + 0.42 * w
    droop = -1.0 * w * w * np.clip((s - 0.62) / 0.38, 0.0, 1.0) ** 2
    forward = 3.2 * w * s
    return np.concatenate([0 * s, s * lift + droop, forward], axis=1) * (s > 0)


# --- sculptors: mouth --------------------------------------------------------------------------------


def _at_corner(body: Body, radii: tuple[float, float, float]) -> Floats:
    return _left(body) * _bump(body, body.mouth_corner - [0.15, 0.0, 0.3], radii)


def _smile(body: Body, w: float) -> Floats:
    pull = _at_corner(body, (3.3, 2.7, 3.6)) * [0.85, 0.0, -0.62]
    curl = np.clip(np.abs(body.points[:, :1]) / body.mouth_corner[0], 0.0, 1.0) ** 1.4
    pull += _at_corner(body, (3.3, 2.7, 3.6)) * curl * [0.0, 1.0, 0.0]
    cheek = _bump(body, (4.0, -3.6, 6.6), (2.3, 2.0, 2.8)) * [0.20, 0.30, 0.45]
    return w * (pull + cheek)


def _frown(body: Body, w: float) -> Floats:
    return w * (_at_corner(body, (2.9, 2.6, 3.4)) * [0.12, -0.95, -0.22])


def _dimple(body: Body, w: float) -> Floats:
    return w * (_at_corner(body, (2.3, 1.8, 2.6)) * [0.48, 0.08, -0.75])


def _stretch(body: Body, w: float) -> Floats:
    return w * (_at_corner(body, (3.3, 2.7, 3.6)) * [1.0, -0.45, -0.75])


def _press(body: Body, w: float) -> Floats:
    spot = _left(body) * _bump(body, (1.2, -6.35, 8.3), (2.6, 1.25, 2.2))
    return w * spot * (_upper(body) * [0.0, -0.16, -0.22] + _lower(body) * [0.0, 0.22, -0.26])


def _lower_down(body: Body, w: float) -> Floats:
    return (
        w * _left(body, 0.6) * _lower(body) ** 2 * _bump(body, (1.2, -6.9, 8.2), (2.3, 1.9, 2.6)) * [0.10, -0.85, 0.08]
    )


def _upper_up(body: Body, w: float) -> Floats:
    return (
        w * _left(body, 0.6) * _upper(body) ** 2 * _bump(body, (1.2, -5.9, 8.4), (2.2, 1.8, 2.6)) * [0.10, 0.75, 0.05]
    )


def _pucker(body: Body, w: float) -> Floats:
    spot = _bump(body, (0.0, -6.35, 8.0), (4.2, 2.7, 4.0))
    inward = body.points * [-0.52, 0.0, 0.0]
    taller = 0.28 * (body.points - body.mouth_corner) * [0.0, 1.0, 0.0]
    return np.asarray(w * spot * (inward + taller + [0.0, 0.0, 0.80]))


def _funnel(body: Body, w: float) -> Floats:
    spot = _bump(body, (0.0, -6.35, 8.0), (4.0, 2.7, 4.0))
    inward = body.points * [-0.34, 0.0, 0.0]
    apart = _upper(body) * [0.0, 0.42, 0.0] + _lower(body) * [0.0, -0.48, 0.0]
    return np.asarray(w * spot * (inward + apart + [0.0, 0.0, 0.75]))


def _mouth_left(body: Body, w: float) -> Floats:
    return np.asarray(w * _bump(body, (0.2, -6.35, 8.0), (4.3, 2.7, 4.2)) * [1.15, 0.05, -0.10])


def _roll_upper(body: Body, w: float) -> Floats:
    return w * _upper(body) ** 2 * _bump(body, (0.0, -6.05, 8.7), (2.7, 0.95, 1.5)) * [0.0, -0.34, -0.62]


def _roll_lower(body: Body, w: float) -> Floats:
    return w * _lower(body) ** 2 * _bump(body, (0.0, -6.6, 8.7), (2.7, 1.1, 1.5)) * [0.0, 0.40, -0.66]


def _shrug_upper(body: Body, w: float) -> Floats:
    return w * _upper(body) ** 2 * _bump(body, (0.0, -5.8, 8.6), (2.9, 1.5, 2.4)) * [0.0, 0.48, 0.32]


def _shrug_lower(body: Body, w: float) -> Floats:
    chin = _lower(body) * _bump(body, (0.0, -7.6, 8.2), (3.2, 2.4, 2.8)) * [0.0, 0.62, 0.36]
    return w * (chin + _upper(body) ** 2 * _bump(body, (0.0, -6.0, 8.6), (2.7, 1.4, 2.2)) * [0.0, 0.52, 0.16])


def _close(body: Body, w: float) -> Floats:
    """Seals the lips over a jaw that is about 0.3 open; alone the lips overlap."""
    up = _lower(body) ** 2 * _bump(body, (0.0, -6.8, 8.4), (3.0, 1.9, 2.4)) * [0.0, 0.85, 0.12]
    return w * (up + _upper(body) ** 2 * _bump(body, (0.0, -5.9, 8.5), (2.8, 1.3, 2.2)) * [0.0, -0.30, -0.16])


# --- sculptors: cheeks, nose, head -------------------------------------------------------------------


def _puff(body: Body, w: float) -> Floats:
    right = np.array([-1.0, 1.0, 1.0])
    centre, out = np.array([3.9, -5.1, 6.0]), np.array([0.85, 0.0, 0.55])
    radii = (3.1, 2.9, 3.6)
    return np.asarray(w * (_bump(body, centre, radii) * out + _bump(body, centre * right, radii) * out * right))


def _cheek_squint(body: Body, w: float) -> Floats:
    return w * _off_lids(body) * _bump(body, (3.9, -2.6, 6.8), (2.4, 1.7, 2.7)) * [0.08, 0.55, 0.32]


def _sneer(body: Body, w: float) -> Floats:
    wing = _bump(body, (1.2, -3.6, 8.8), (1.3, 1.5, 2.0)) * [0.10, 0.52, -0.02]
    bridge = _bump(body, (1.2, -1.0, 8.0), (1.2, 1.6, 1.8)) * [-0.12, 0.28, 0.14]
    lip = _upper(body) ** 2 * _bump(body, (1.5, -5.4, 8.2), (1.4, 1.2, 2.0)) * [0.05, 0.30, 0.05]
    return w * _left(body, 0.5) * _off_lids(body) * (wing + bridge + lip)


def _squash(body: Body, w: float) -> Floats:
    """The whole head flatter and wider about the top of the neck."""
    y = body.points[:, 1:2]
    t = np.clip((y + 15.5) / 6.0, 0.0, 1.0)
    share = t * t * (3 - 2 * t)
    return np.asarray(w * share * (body.points - NECK_PIVOT) * [0.09, -0.15, 0.09])


LINEAR = (1.0,)
ARC = (0.33, 0.67, 1.0)
HALF = (0.5, 1.0)

PAIRS: Mapping[str, tuple[Sculptor, tuple[float, ...]]] = {
    "eyeBlink*": (_blink, ARC),
    "eyeSquint*": (_squint, HALF),
    "eyeWide*": (_wide, LINEAR),
    "browDown*": (_brow_down, LINEAR),
    "browOuterUp*": (_brow_outer_up, LINEAR),
    "jaw*": (_jaw_left, LINEAR),
    "mouth*": (_mouth_left, LINEAR),
    "mouthSmile*": (_smile, LINEAR),
    "mouthFrown*": (_frown, LINEAR),
    "mouthDimple*": (_dimple, LINEAR),
    "mouthStretch*": (_stretch, LINEAR),
    "mouthPress*": (_press, LINEAR),
    "mouthLowerDown*": (_lower_down, LINEAR),
    "mouthUpperUp*": (_upper_up, LINEAR),
    "cheekSquint*": (_cheek_squint, LINEAR),
    "noseSneer*": (_sneer, LINEAR),
}
"""Sculptor of the left control and weights of its shapes; ``*`` stands for Left or Right."""
MIDDLE: Mapping[str, tuple[Sculptor, tuple[float, ...]]] = {
    "browInnerUp": (_brow_inner_up, LINEAR),
    "jawOpen": (_jaw_open, HALF),
    "jawForward": (_jaw_forward, LINEAR),
    "tongueOut": (_tongue_out, HALF),
    "mouthPucker": (_pucker, LINEAR),
    "mouthFunnel": (_funnel, LINEAR),
    "mouthRollUpper": (_roll_upper, LINEAR),
    "mouthRollLower": (_roll_lower, LINEAR),
    "mouthShrugUpper": (_shrug_upper, LINEAR),
    "mouthShrugLower": (_shrug_lower, LINEAR),
    "mouthClose": (_close, LINEAR),
    "cheekPuff": (_puff, LINEAR),
    "headSquash": (_squash, LINEAR),
}
"""Controls symmetric about the mid-plane."""
