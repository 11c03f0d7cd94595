"""Parallel rays against a triangle soup: what is seen from a direction, and what lies in front of
it.

Views are orthographic: a *direction* ``toward`` points from the face to the viewer, and all rays of
one call share it.  One `Caster` has two ways to cast: Embree, where the package `embreex` is
installed, and `TreeCaster`, by numpy and scipy alone.  Both are exact up to rounding and
deterministic.  The fall-back computes in double precision where Embree computes in single, so they
may differ for rays that graze an edge or start within rounding of a surface; and it is some
twenty times slower.
"""

from __future__ import annotations

from importlib.util import find_spec
from itertools import chain, product
from typing import Protocol

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.ties import axis_across

OFFSET = 1e-4
"""How far rays start from the surface, as a share of the soup's diagonal: above the rounding of
single precision by three orders, below the thickness of an eyelid."""

AROUND = tuple(
    np.array(way) / np.linalg.norm(way) for way in product((0, 1, -1), repeat=3) if any(way)
)
"""Directions to the left, up and ahead along three axes and between them."""
_PAIRS = 200_000
"""Ray and triangle pairs that `TreeCaster` tests at a time, about."""


class Hits(Record):
    """First triangle on each ray."""

    triangle: Indices
    """(n,) index into the soup, or -1 where the ray meets nothing."""
    distance: Floats
    """(n,) along the unit direction; inf where the ray meets nothing."""


class Caster(Protocol):
    """Casts rays at one triangle soup; laws: both ways give the same answer, up to rounding.

    Triangles count from both sides; one seen exactly edge-on counts for nothing.
    """

    @property
    def size(self) -> float:
        """Diagonal of the soup's bounding box."""

    def first_hits(self, origins: Floats, direction: Floats) -> Hits:
        """Nearest triangle at a positive distance from ``origins`` (n, 3) along ``direction``
        (3,)."""


def make_caster(triangles: Floats) -> Caster:
    """A caster for finite ``triangles`` (t, 3, 3): Embree's where it is installed."""
    if find_spec("embreex") is None or not len(triangles):
        return TreeCaster(triangles)
    return EmbreeCaster(triangles)


def visible_from(caster: Caster, points: Floats, normals: Floats, toward: Floats) -> Flags:
    """(n,) whether surface points can be seen from an orthographic viewer in the direction
    `toward`.

    A point is visible when its unit normal looks to the viewer and nothing lies in between.  Rays
    start a little outside the surface (`OFFSET`).  Points with a zero normal are judged by the ray
    alone. ``points`` and ``normals`` are (n, 3), ``toward`` (3,) of any length.
    """
    direction = _unit(toward)
    facing = normals @ direction
    seen: Flags = (facing > 0.0) | ~normals.any(axis=1)
    ask = np.flatnonzero(seen)
    seen[ask] = ~blocked(caster, _lifted(caster, points[ask], normals[ask], direction), direction)
    return seen


def blocked(caster: Caster, origins: Floats, direction: Floats) -> Flags:
    """(n,) whether anything lies on the rays from exactly ``origins`` (n, 3) along ``direction``
    (3,)."""
    return caster.first_hits(origins, direction).triangle >= 0


def hidden_share(caster: Caster, polylines: Floats, normals: Floats, toward: Floats) -> Floats:
    """(p,) share of each polyline's points that lie inside or behind the surface, seen from
    `toward`.

    ``polylines`` (p, k, 3) are trajectories of surface points with unit ``normals`` (p, 3) at rest:
    a point of the path counts as hidden when the soup lies between it and the viewer, whichever way
    the surface itself faces.  Paths are lifted off the surface by `OFFSET` like the points of
    `visible_from`.
    """
    direction = _unit(toward)
    count, steps = polylines.shape[:2]
    starts = _lifted(caster, polylines, normals[:, None], direction).reshape(-1, 3)
    shares: Floats = blocked(caster, starts, direction).reshape(count, steps).mean(axis=1)
    return shares


class TreeCaster(Record):
    """Exact ray casting without Embree: a k-d tree of the rays, seen along them, gives those that
    pass by each triangle."""

    triangles: Floats
    """(t, 3, 3)."""

    @property
    def size(self) -> float:
        """Diagonal of the soup's bounding box."""
        return diagonal(self.triangles)

    def first_hits(self, origins: Floats, direction: Floats) -> Hits:
        """Nearest triangle along each ray; of several at one distance the first in the soup."""
        frame = _frame(_unit(direction))
        triangle, distance = np.full(len(origins), -1), np.full(len(origins), np.inf)
        if not len(origins) or not len(self.triangles):
            return Hits(triangle, distance)
        corners, starts = self.triangles @ frame.T, origins @ frame.T
        least, most = corners[:, :, :2].min(axis=1), corners[:, :, :2].max(axis=1)
        middles, radii = 0.5 * (least + most), 0.5 * np.linalg.norm(most - least, axis=1)
        tree = cKDTree(starts[:, :2])
        count = tree.query_ball_point(middles, radii, return_length=True)
        cuts = np.flatnonzero(np.diff(np.cumsum(count) // _PAIRS)) + 1
        for some in np.split(np.arange(len(corners)), cuts):
            near = chain.from_iterable(tree.query_ball_point(middles[some], radii[some]))
            ray, member = np.fromiter(near, np.int64), np.repeat(some, count[some])
            apart = _distances(corners[member], starts[ray])
            order = np.lexsort((member, apart, ray))
            first = order[np.diff(ray[order], prepend=-1) > 0]
            nearer = first[apart[first] < distance[ray[first]]]
            triangle[ray[nearer]], distance[ray[nearer]] = member[nearer], apart[nearer]
        return Hits(triangle, distance)


def _distances(corners: Floats, starts: Floats) -> Floats:
    """(n,) how far each triangle of (n, 3, 3) lies ahead of its start (n, 3), along z; inf where it
    does not or is seen edge-on."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    way = starts - corners[:, 0]
    area = _crossed(first, second)
    longest = np.maximum((first * first).sum(axis=1), (second * second).sum(axis=1))
    flat = np.abs(area) <= 1e-12 * longest
    area = np.where(flat, 1.0, area)
    one, other = _crossed(way, second) / area, _crossed(first, way) / area
    apart = one * first[:, 2] + other * second[:, 2] - way[:, 2]
    inside = (one >= -1e-9) & (other >= -1e-9) & (one + other <= 1.0 + 1e-9)
    return np.where(inside & (apart > 0.0) & ~flat, apart, np.inf)


def _crossed(first: Floats, second: Floats) -> Floats:
    """(n,) how far vectors (n, 3) turn from `first` to `second`, seen along z."""
    return first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]


class EmbreeCaster:
    """Embree by way of embreex.  Positions are centred and scaled first: it computes in single
    precision."""

    def __init__(self, soup: Floats) -> None:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        self.size = diagonal(soup)
        self._centre: Floats = 0.5 * (soup.min(axis=(0, 1)) + soup.max(axis=(0, 1)))
        self._scale = 1.0 / max(self.size, 1e-30)
        self._scene = EmbreeScene()
        scaled = ((soup - self._centre) * self._scale).astype(np.float32)
        self._mesh = TriangleMesh(self._scene, scaled)

    def first_hits(self, origins: Floats, direction: Floats) -> Hits:
        """Nearest triangle along each ray."""
        if not len(origins):
            return Hits(np.empty(0, dtype=np.int64), np.empty(0))
        starts = ((origins - self._centre) * self._scale).astype(np.float32)
        along = np.broadcast_to(_unit(direction).astype(np.float32), starts.shape)
        hits = self._scene.run(starts, np.ascontiguousarray(along), output=True)
        triangle, distance = hits["primID"].astype(np.int64), hits["tfar"].astype(np.float64)
        return Hits(triangle, np.where(triangle >= 0, distance / self._scale, np.inf))


def _lifted(caster: Caster, points: Floats, normals: Floats, direction: Floats) -> Floats:
    return points + (OFFSET * caster.size) * (normals + direction)


def _frame(direction: Floats) -> Floats:
    """(3, 3) rotation whose rows are two axes across `direction` and `direction` itself."""
    across = _unit(np.cross(axis_across(direction), direction))
    return np.stack([across, np.cross(direction, across), direction])


def _unit(vector: Floats) -> Floats:
    return vector / np.linalg.norm(vector)


def diagonal(points: Floats) -> float:
    """Of the box about points (..., 3); 0 without any."""
    return float(np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0))) if points.size else 0.0
