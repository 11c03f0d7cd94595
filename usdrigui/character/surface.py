"""Triangles, normals and neighbourhood of polygon meshes whose points may be split at seams.

Stands on the ground floor; numpy and scipy only.  Vertex identity is never trusted: meshes born in
other formats are split along texture seams, so adjacency and normals go through *places*, the
classes of points that coincide.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from usdrigui.character import Floats, Indices, RigMesh

_GRID = 1e-9
"""Of the largest extent: points of one cell are at one position."""


def triangles(
    face_counts: ArrayLike, face_indices: ArrayLike, left_handed: bool = False
) -> Indices:
    """Triangulation of polygons as ``(t, 3)`` point indices, counter-clockwise from outside.

    `face_counts` ``(f,)`` and `face_indices` ``(sum(face_counts),)`` are as on a USD mesh.  Faces
    of fewer than three points give nothing, one of k points a fan of k - 2 triangles, as Hydra
    draws it.  `left_handed` faces are turned round, so that the normals computed from the result
    always point outward.
    """
    counts = np.asarray(face_counts, dtype=np.int64)
    indices = np.asarray(face_indices, dtype=np.int64)
    made = np.maximum(counts - 2, 0)
    faces = np.repeat(np.arange(len(counts)), made)
    if not len(faces):
        return np.zeros((0, 3), dtype=np.int64)
    starts = np.cumsum(counts) - counts
    step = np.arange(len(faces)) - np.repeat(np.cumsum(made) - made, made)
    first = starts[faces]
    corners = indices[np.stack([first, first + step + 1, first + step + 2], axis=1)]
    return np.asarray(corners[:, [0, 2, 1]] if left_handed else corners)


def mesh_triangles(meshes: Sequence[RigMesh], visible_only: bool = False) -> Indices:
    """``(t, 3)`` triangles of all meshes over their concatenated points (the numbering of
    `Rig`)."""
    parts: list[Indices] = [np.zeros((0, 3), dtype=np.int64)]
    start = 0
    for mesh in meshes:
        if mesh.visible or not visible_only:
            faces = mesh.topology
            of_mesh = (faces.face_counts, faces.face_indices, faces.left_handed)
            parts.append(triangles(*of_mesh) + start)
        start += len(mesh.points)
    return np.concatenate(parts)


def triangle_areas(points: Floats, corners: Indices) -> Floats:
    """``(t,)`` areas of the triangles, in squared units of `points`."""
    return np.asarray(0.5 * np.linalg.norm(_doubled_normals(points, corners), axis=1))


def vertex_normals(points: Floats, corners: Indices, places: Indices) -> Floats:
    """``(n, 3)`` unit normals, area-weighted over the triangles around each point; zero where
    undefined.

    Points of one of the `places` (from `weld`) share their normal, so that it is smooth over seams.
    """
    doubled, at = _doubled_normals(points, corners), places[corners].ravel()
    columns = [np.bincount(at, np.repeat(axis, 3), len(points)) for axis in doubled.T]
    normals = np.stack(columns, axis=1)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    unit = np.divide(normals, length, out=np.zeros(normals.shape), where=length > 0.0)
    return np.asarray(unit[places])


def faces_inward(points: Floats, corners: Indices) -> bool:
    """Whether the triangles enclose a clearly negative volume: a character whose faces are wound
    the wrong way round.  Open and flat surfaces, whose volume means little, count as right."""
    if not len(corners):
        return False
    middle = points[np.unique(corners)].mean(axis=0)
    a, b, c = np.moveaxis(points[corners] - middle, 1, 0)
    volume = float(np.einsum("ti,ti->", a, np.cross(b, c))) / 6.0
    return bool(volume < -0.01 * triangle_areas(points, corners).sum() ** 1.5)


def point_areas(points: Floats, corners: Indices, places: Indices) -> Floats:
    """``(n,)`` a third of the area of the triangles around each point; the whole of a place's area
    falls to its first point and the others get zero."""
    area = np.repeat(triangle_areas(points, corners) / 3.0, 3)
    return np.asarray(np.bincount(places[corners].ravel(), weights=area, minlength=len(points)))


def weld(points: Floats, extra: Floats | None = None) -> Indices:
    """``(n,)`` index of the first point at the same position: the point's *place*.

    Positions are compared on a grid of `_GRID` times the largest extent, above the rounding of
    transforms and below any distance that was modelled: points that nearly touch stay apart,
    whichever way the character is turned.  `extra` ``(n, k)`` further values must agree too
    (relative to their own largest magnitude): lips that touch at rest but move apart are two
    places.
    """
    cells = _cells(points)
    if extra is not None and extra.size:
        scale = float(np.abs(extra).max()) or 1.0
        cells = np.concatenate([cells, np.round(extra / (scale * 1e-4)).astype(np.int64)], axis=1)
    _, first, inverse = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    return first[inverse.reshape(-1)]


def edges(corners: Indices) -> Indices:
    """``(e, 2)`` undirected edges of the triangles, each once with the lower index first; edges
    within one place are left out where `corners` are places."""
    sides = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    pairs = np.sort(sides, axis=1)
    return np.unique(pairs[pairs[:, 0] != pairs[:, 1]], axis=0)


def mean_edge_length(points: Floats, corners: Indices, places: Indices) -> float:
    """Average distance between adjacent points (paper section 4.1, tau); 0 without edges."""
    pairs = edges(places[corners])
    if not len(pairs):
        return 0.0
    return float(_lengths(points, pairs).mean())


def components(corners: Indices, places: Indices) -> Indices:
    """``(n,)`` number of the connected piece of surface that each point belongs to, over welded
    points."""
    at = places[corners]
    pairs = np.concatenate([at[:, :2], at[:, 1:]])  # Two sides hold a triangle together.
    _, labels = connected_components(graph(pairs, len(places)), directed=False)
    return np.asarray(labels[places], dtype=np.int64)


def surface_distances(
    points: Floats, corners: Indices, places: Indices, sources: Indices
) -> Floats:
    """``(n,)`` shortest way along the surface from the nearest of the points `sources`; inf where
    none leads there.

    The ways go along edges and across each edge from corner to opposite corner, which makes them at
    most some 8 % longer than the shortest on a regular mesh.
    """
    corners = places[corners]
    sides = np.sort(corners[:, [[1, 2], [2, 0], [0, 1]]], axis=2).reshape(-1, 2)
    order = np.lexsort((sides[:, 1], sides[:, 0]))
    # Two triangles at one edge.
    twins = np.flatnonzero((sides[order[1:]] == sides[order[:-1]]).all(axis=1))
    opposite = corners.reshape(-1)
    across = np.stack([opposite[order[twins]], opposite[order[twins + 1]]], axis=1)
    bridges = np.sort(across[across[:, 0] != across[:, 1]], axis=1)
    pairs = np.unique(np.concatenate([edges(corners), bridges]), axis=0)
    ways = graph(pairs, len(points), _lengths(points, pairs))
    found = dijkstra(ways, directed=False, indices=np.unique(places[sources]), min_only=True)
    return np.asarray(found[places])


def _lengths(points: Floats, pairs: Indices) -> Floats:
    """(e,) distances between the two points of each of `pairs` (e, 2)."""
    return np.asarray(np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1))


def _doubled_normals(points: Floats, corners: Indices) -> Floats:
    """(t, 3) normals of twice the triangles' area."""
    a, b, c = points[corners[:, 0]], points[corners[:, 1]], points[corners[:, 2]]
    return np.cross(b - a, c - a)


def _cells(points: Floats) -> Indices:
    """(n, 3) cells of a grid laid at the lowest corner, cell centres on it so that noise there is
    harmless."""
    if not len(points):
        return np.zeros((0, 3), dtype=np.int64)
    low = points.min(axis=0)
    extent = float((points.max(axis=0) - low).max()) or 1.0
    return np.asarray(np.round((points - low) / (extent * _GRID)), dtype=np.int64)


def graph(pairs: Indices, count: int, lengths: Floats | None = None) -> csr_array:
    """What `count` points joined by pairs (p, 2) are to scipy; `lengths` (p,) of the ways."""
    # The only index type that every graph routine of scipy takes.
    first, second = pairs.astype(np.int32).T
    values = np.ones(len(pairs)) if lengths is None else lengths
    return csr_array((values, (first, second)), shape=(count, count))
