"""The sculpted form of the head as one implicit surface: smooth sums of ellipsoids, capsules and balls.

Centimetres, Y up, the face looks along +Z, the eye line is at y = 0; negative inside.  Everything is a
function of |x|, so the form is exactly symmetric.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

EYE = np.array([3.15, 0.0, 5.8])
"""Centre of the left eyeball."""
EYE_RADIUS = 1.75
LID_RADIUS = EYE_RADIUS + 0.2
"""Outside of the closed lid."""


def distance(p: Floats) -> Floats:
    """Approximate signed distance (n,) of points (n, 3) to the head without ears and lips."""
    q = p.copy()
    q[:, 0] = np.sqrt(p[:, 0] ** 2 + 0.02)
    d = _skull(q)
    d = _union(d, _nose(q), 0.7)
    d = _cut(d, _ellipsoid(q, (3.2, 0.05, 8.05), (2.45, 1.75, 1.85)), 1.0)
    d = _union(d, _ball(q, EYE, LID_RADIUS), 0.5)
    return _union(d, _ball(q, (1.0, 0.1, 7.0), 0.5), 0.8)


def gradient(p: Floats) -> Floats:
    """Gradient (n, 3) of `distance` by central differences."""
    step = 1e-4
    axes = np.eye(3) * step
    columns = [distance(p + axis) - distance(p - axis) for axis in axes]
    return np.stack(columns, axis=1) / (2 * step)


def project(p: Floats, rounds: int = 4) -> Floats:
    """Move points (n, 3) along the gradient onto the surface; the mid-plane stays the mid-plane."""
    p = p.copy()
    for _ in range(rounds):
        g = gradient(p)
        length = np.maximum((g * g).sum(axis=1), 0.05)
        p -= np.clip(distance(p) / length, -1.0, 1.0)[:, None] * g
    return p


def normals(p: Floats) -> Floats:
    """Unit outward normals (n, 3)."""
    g = gradient(p)
    return np.asarray(g / np.linalg.norm(g, axis=1, keepdims=True))


def cast(origin: Floats, direction: Floats, reach: float = 24.0) -> Floats:
    """First hits (n, 3) of rays that come from `reach` along `direction` (n, 3) back towards `origin` (n, 3)."""
    direction = direction / np.linalg.norm(direction, axis=1, keepdims=True)
    travel = np.full(len(origin), reach)
    for _ in range(90):
        travel -= 0.7 * distance(origin + travel[:, None] * direction)
        travel = np.clip(travel, 0.0, reach)
    return np.asarray(origin + travel[:, None] * direction)


def _skull(q: Floats) -> Floats:
    d = _ellipsoid(q, (0.0, 3.2, -1.4), (7.3, 7.7, 9.0))
    d = _union(d, _ellipsoid(q, (0.0, -2.0, 1.6), (5.8, 6.8, 6.5)), 2.0)
    d = _union(d, _ellipsoid(q, (0.0, -6.4, 3.5), (3.9, 3.3, 4.2)), 1.6)
    d = _union(d, _capsule(q, (4.5, -4.0, 0.2), (1.6, -8.5, 5.2), 1.1, 1.1), 1.5)
    d = _union(d, _ellipsoid(q, (0.0, -8.9, 6.75), (1.7, 1.35, 1.45)), 1.1)
    d = _union(d, _ellipsoid(q, (4.0, -2.3, 4.8), (1.9, 1.5, 1.9)), 1.8)
    d = _union(d, _ellipsoid(q, (2.6, -4.9, 4.3), (2.2, 2.6, 2.7)), 1.6)
    d = _union(d, _ellipsoid(q, (0.0, -6.0, 5.8), (3.2, 2.5, 2.8)), 1.2)
    d = _union(d, _capsule(q, (0.0, 2.2, 6.95), (4.7, 2.55, 5.2), 0.75, 0.65), 1.5)
    d = _union(d, _capsule(q, (0.0, -5.0, -3.2), (0.0, -17.0, -4.4), 3.1, 3.6), 2.0)
    return _union(d, _ellipsoid(q, (0.0, -18.0, -4.4), (8.5, 3.6, 4.6)), 3.5)


def _nose(q: Floats) -> Floats:
    d = _capsule(q, (0.0, 1.2, 7.0), (0.0, -2.7, 8.75), 0.62, 0.66)
    d = _union(d, _ball(q, (0.0, -3.0, 9.15), 0.86), 0.5)
    d = _union(d, _ellipsoid(q, (1.02, -3.4, 8.4), (0.64, 0.60, 0.80)), 0.32)
    return _union(d, _capsule(q, (0.0, -3.5, 8.95), (0.0, -3.95, 8.1), 0.38, 0.45), 0.4)


def _union(a: Floats, b: Floats, k: float) -> Floats:
    """Polynomial smooth minimum with blending radius k."""
    h = np.maximum(k - np.abs(a - b), 0.0) / k
    return np.asarray(np.minimum(a, b) - h * h * k * 0.25)


def _cut(a: Floats, b: Floats, k: float) -> Floats:
    return -_union(-a, b, k)


def _ball(q: Floats, centre: Floats | tuple[float, ...], radius: float) -> Floats:
    return np.asarray(np.linalg.norm(q - np.asarray(centre), axis=1) - radius)


def _ellipsoid(q: Floats, centre: Floats | tuple[float, ...], radii: tuple[float, ...]) -> Floats:
    r = q - np.asarray(centre)
    k0 = np.linalg.norm(r / radii, axis=1)
    k1 = np.linalg.norm(r / np.square(radii), axis=1)
    return np.asarray(k0 * (k0 - 1.0) / np.maximum(k1, 1e-9))


def _capsule(q: Floats, start: tuple[float, ...], end: tuple[float, ...], radius: float, end_radius: float) -> Floats:
    """Segment with a radius that runs linearly from one end to the other."""
    a, axis = np.asarray(start), np.subtract(end, start)
    t = np.clip((q - a) @ axis / (axis @ axis), 0.0, 1.0)
    nearest = np.linalg.norm(q - a - t[:, None] * axis, axis=1)
    return np.asarray(nearest - (radius + (end_radius - radius) * t))
