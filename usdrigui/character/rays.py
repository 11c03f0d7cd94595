"""Parallel rays against a triangle soup: what is seen from a direction, and what lies in front of
it.

Views are orthographic: a *direction* ``toward`` points from the face to the viewer, and all rays of
one call share it.  One `Caster` has two ways to cast: Embree, where the optional package
`embreex` is installed, and `GridCaster` in numpy alone.  Both are exact up to rounding and
deterministic.  The fall-back computes in double precision where Embree computes in single, so they
may differ for rays that graze an edge or start within rounding of a surface; and it prepares one
grid per call and tests pairs in numpy, which makes it some twenty times slower.  numpy only, apart
from the optional import.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Protocol

import numpy as np

from usdrigui.character import Flags, Floats, Indices, Record
from usdrigui.ties import axis_across

OFFSET = 1e-4
"""How far rays start from the surface, as a share of the soup's diagonal: above the rounding of
single precision by three orders, below the thickness of an eyelid."""

_PAIRS = 200_000
"""Ray and triangle pairs that `GridCaster` tests at a time: more bring nothing and leave the
cache."""


@dataclass(frozen=True, eq=False)
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
        return GridCaster(triangles)
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
    return np.asarray(caster.first_hits(origins, direction).triangle >= 0)


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


@dataclass(frozen=True, eq=False)
class GridCaster(Record):
    """Exact ray casting without Embree: triangles are binned in a grid across the rays'
    direction."""

    triangles: Floats
    """(t, 3, 3)."""

    @property
    def size(self) -> float:
        """Diagonal of the soup's bounding box."""
        return _diagonal(self.triangles)

    def first_hits(self, origins: Floats, direction: Floats) -> Hits:
        """Nearest triangle along each ray; of several at one distance the first in the soup."""
        count = len(origins)
        triangle, distance = np.full(count, -1, dtype=np.int64), np.full(count, np.inf)
        if not count or not len(self.triangles):
            return Hits(triangle, distance)
        frame = _frame(_unit(direction))
        flat = _facing(self.triangles @ frame.T)
        grid = _binned(flat, origins @ frame.T)
        for ray, member in _pairs(grid):
            met, apart = _meetings(flat.planes[member], grid.rays[ray])
            _keep_nearest(triangle, distance, ray[met], flat.index[member[met]], apart)
        return Hits(triangle, distance)


@dataclass(frozen=True, eq=False)
class _Flat:
    """The triangles in the rays' frame: x and y across, z along; edge-on ones left out."""

    corners: Floats
    planes: Floats
    """(t, 3, 3) coefficients of x, y and 1 that give the second and third barycentric weight, and
    z."""
    index: Indices


@dataclass(frozen=True, eq=False)
class _Grid:
    """Members of every cell, in cell order, and the cell of every ray (-1 outside)."""

    rays: Floats
    cell: Indices
    starts: Indices
    members: Indices


def _facing(corners: Floats) -> _Flat:
    edges = corners[:, 1:, :2] - corners[:, :1, :2]
    twice_area = edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 0, 1] * edges[:, 1, 0]
    longest = np.square(edges).sum(axis=2).max(axis=1)
    index = np.flatnonzero(np.abs(twice_area) > 1e-12 * longest)
    corners, edges, twice_area = corners[index], edges[index], twice_area[index, None]
    second = np.stack([edges[:, 1, 1], -edges[:, 1, 0]], axis=1) / twice_area
    third = np.stack([-edges[:, 0, 1], edges[:, 0, 0]], axis=1) / twice_area
    heights = corners[:, :, 2] - corners[:, :1, 2]
    slope = heights[:, 1:2] * second + heights[:, 2:] * third
    planes = np.empty((len(index), 3, 3))
    for row, across in enumerate((second, third, slope)):
        planes[:, row, :2] = across
        planes[:, row, 2] = -(across * corners[:, 0, :2]).sum(axis=1)
    planes[:, 2, 2] += corners[:, 0, 2]
    return _Flat(corners, planes, index)


def _binned(flat: _Flat, rays: Floats) -> _Grid:
    """Bin the triangles that can meet a ray: one to four cells for each, as there are rays to make
    use of them."""
    low, high = rays[:, :2].min(axis=0), rays[:, :2].max(axis=0)
    least, most = flat.corners[:, :, :2].min(axis=1), flat.corners[:, :, :2].max(axis=1)
    near = np.flatnonzero(
        ((most >= low) & (least <= high)).all(axis=1)
        & (flat.corners[:, :, 2].max(axis=1) > rays[:, 2].min())
    )
    span = np.maximum(high - low, 1e-9 * max(float((high - low).max()), 1e-30))
    wanted = max(len(near), min(4 * len(near), len(rays)), 1)
    pitch = max(float(np.sqrt(span.prod() / wanted)), float(span.max()) / 2048.0)
    shape = np.floor(span / pitch).astype(np.int64) + 1

    def cells(at: Floats) -> Indices:
        return np.asarray(np.clip(np.floor((at - low) / pitch), 0, shape - 1), dtype=np.int64)

    first, last = cells(least[near]), cells(most[near])
    wide = last - first + 1
    count = wide.prod(axis=1)
    owner = np.repeat(np.arange(len(near)), count)
    rank = _ranks(count)
    column = first[owner, 0] + rank % wide[owner, 0]
    row = first[owner, 1] + rank // wide[owner, 0]
    bins = row * shape[0] + column
    order = np.argsort(bins, kind="stable")
    starts = np.searchsorted(bins[order], np.arange(shape.prod() + 1))
    at = cells(rays[:, :2])
    return _Grid(rays, at[:, 1] * shape[0] + at[:, 0], starts.astype(np.int64), near[owner[order]])


def _pairs(grid: _Grid) -> Iterator[tuple[Indices, Indices]]:
    """Yield (ray, member) index arrays, at most about `_PAIRS` at a time, rays ascending within
    each."""
    count = grid.starts[grid.cell + 1] - grid.starts[grid.cell]
    chunk = np.cumsum(count) // _PAIRS
    for rays in np.split(np.arange(len(count)), np.flatnonzero(np.diff(chunk)) + 1):
        ray = np.repeat(rays, count[rays])
        if len(ray):
            yield ray, grid.members[grid.starts[grid.cell[ray]] + _ranks(count[rays])]


def _meetings(planes: Floats, rays: Floats) -> tuple[Indices, Floats]:
    """Which pairs of triangle and ray meet ahead of the ray's start, and at what distance along
    +z."""
    x, y = rays[:, 0], rays[:, 1]
    second = planes[:, 0, 0] * x + planes[:, 0, 1] * y + planes[:, 0, 2]
    third = planes[:, 1, 0] * x + planes[:, 1, 1] * y + planes[:, 1, 2]
    within = np.flatnonzero((second >= -1e-9) & (third >= -1e-9) & (second + third <= 1.0 + 1e-9))
    level = planes[within, 2]
    apart = level[:, 0] * x[within] + level[:, 1] * y[within] + level[:, 2] - rays[within, 2]
    ahead = apart > 0.0
    return within[ahead], apart[ahead]


def _keep_nearest(
    triangle: Indices, distance: Floats, ray: Indices, candidate: Indices, apart: Floats
) -> None:
    """Update `triangle` and `distance` (in place) by the nearest candidate of each ray; rays come
    once, ascending."""
    order = np.lexsort((candidate, apart, ray))
    first = order[np.diff(ray[order], prepend=-1) > 0]
    triangle[ray[first]] = candidate[first]
    distance[ray[first]] = apart[first]


def _ranks(count: Indices) -> Indices:
    """0, 1, ... count - 1 for each entry of `count`, one after the other."""
    starts = np.cumsum(count) - count
    return np.arange(count.sum(), dtype=np.int64) - np.repeat(starts, count)


class EmbreeCaster:
    """Embree by way of embreex.  Positions are centred and scaled first: it computes in single
    precision."""

    def __init__(self, soup: Floats) -> None:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        self.size = _diagonal(soup)
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
    return np.asarray(points + (OFFSET * caster.size) * (normals + direction), dtype=np.float64)


def _frame(direction: Floats) -> Floats:
    """(3, 3) rotation whose rows are two axes across `direction` and `direction` itself."""
    across = _unit(np.cross(axis_across(direction), direction))
    return np.stack([across, np.cross(direction, across), direction])


def _unit(vector: Floats) -> Floats:
    length = float(np.linalg.norm(vector))
    if not np.isfinite(length) or length == 0.0:
        raise ValueError("a direction must be finite and not zero")
    return np.asarray(vector, dtype=np.float64) / length


def _diagonal(soup: Floats) -> float:
    return float(np.linalg.norm(np.ptp(soup.reshape(-1, 3), axis=0))) if len(soup) else 0.0
