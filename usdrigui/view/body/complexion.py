"""Colours to judge a face by: those of the asset, and for what has none skin, eyes with pupils,
lips, brows and teeth.

Where the asset has no colour, form decides: a pair of balls in front are the eyes; the surface
that faces itself across the mid-plane is the mouth; the ridge above an eye carries its brow; what
lies behind the mouth are teeth and tongue.  Where the form is unclear, everything is skin.  The
layout is not changed by any of this.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from usdrigui.character import Flags, Floats, Indices, Record, Rig, RigMesh
from usdrigui.character.deform import deform
from usdrigui.character.surface import components, mesh_triangles, vertex_normals, weld
from usdrigui.model import Layout
from usdrigui.view.body.shading import SKIN, Complexion, look

_TRIM, _TEETH, _GUMS, _HAIR = (
    (0.66, 0.63, 0.60),
    (0.80, 0.76, 0.68),
    (0.52, 0.20, 0.19),
    (0.07, 0.045, 0.03),
)
_LIPS, _BROWS = (0.43, 0.17, 0.15), (0.12, 0.075, 0.05)
_NAMED = (
    (re.compile(r"teeth|tooth|denture", re.IGNORECASE), _TEETH),
    (re.compile(r"tongue|gum", re.IGNORECASE), _GUMS),
    (re.compile(r"lash|brow|hair|beard|moustache", re.IGNORECASE), _HAIR),
)
"""Colours of meshes by a word of their name; numbers are linear light."""

_ROUND = 0.08
"""Root mean square by which an eyeball may differ from a ball, in radii: corneas and flat irises
do."""
_SHELL = (0.6, 1.6)
"""What lies so many radii from an eye's centre lies over the eye: tears, corneas, shadows of
lids."""
_GAP = 2.0
"""Handle widths between lips that touch, at most."""


@dataclass(frozen=True)
class _Seen:
    """The character at rest in its layout's view: x to the right, y up, z toward the viewer."""

    at: Floats
    """(n, 3)."""
    normals: Floats
    pieces: Indices
    """(n,) connected piece of the visible surface, -1 for points of none."""
    corners: Indices
    """(t, 3) of the visible surface."""
    sheets: Indices
    """(n,) as `pieces`, but of points that share triangles, whatever else lies where they lie."""
    free: Flags
    """(n,) visible points whose mesh has no colour, neither by values nor by its
    name."""
    width: float
    """Of a handle."""
    middle: float
    """x of the mid-plane."""
    low: Floats
    """(2,) lower left corner of the elements on the face."""
    high: Floats


@dataclass(frozen=True)
class _Eye:
    centre: Floats
    radius: float
    piece: int


def complexion(rig: Rig, layout: Layout) -> Complexion:
    """Colours of a character in the base pose of its layout."""
    colours = _of_meshes(rig.body.meshes)
    gaze, clear = np.full((len(colours), 2), 9.0), np.zeros(len(colours), dtype=bool)
    seen = _seen(rig, layout)
    if seen is None:
        return Complexion(colours, gaze, clear)
    skin = _skin(seen)
    colours[seen.free & ~skin] = _TRIM
    eyes = _eyes(seen, skin)
    for eye in eyes:
        on, over = _on_eye(seen, eye, skin)
        gaze[on], clear[over] = _directions(seen.at[on] - eye.centre, eye.radius), True
    brows = [_brow(seen, skin, eye) for eye in eyes]
    mouth = _mouth(seen, skin)
    _paint(colours, _BROWS, np.max(brows, axis=0) if brows else np.zeros(len(colours)))
    if mouth is not None:
        _paint(colours, _LIPS, mouth.lips(seen.at, seen.normals) * skin)
        inside = mouth.behind(seen.at) & seen.free & ~skin & (gaze[:, 0] > 2.0)
        colours[inside] = _TEETH
        largest = np.bincount(seen.pieces[inside]).argmax() if inside.any() else -1
        colours[inside & (seen.pieces == largest)] = _GUMS
    return Complexion(colours, gaze, clear)


def _of_meshes(meshes: tuple[RigMesh, ...]) -> Floats:
    """(n, 3) the colours that meshes have, or the usual ones of the things that they name."""
    parts = [np.zeros((0, 3))]
    for mesh in meshes:
        usual = np.tile(np.array(_said(mesh.path) or SKIN), (len(mesh.points), 1))
        parts.append(usual if mesh.display.colours is None else np.asarray(mesh.display.colours))
    return np.concatenate(parts)


def _said(path: str) -> tuple[float, float, float] | None:
    """The colour of the thing that a mesh names."""
    name = path.rsplit("/", 1)[-1]
    return next((colour for word, colour in _NAMED if word.search(name)), None)


def _seen(rig: Rig, layout: Layout) -> _Seen | None:
    """None where no point is left to be coloured."""
    coloured = [
        mesh.display.colours is not None or _said(mesh.path) is not None for mesh in rig.body.meshes
    ]
    spans = [
        np.full(len(mesh.points), mesh.display.visible and not has)
        for mesh, has in zip(rig.body.meshes, coloured, strict=True)
    ]
    free = np.concatenate([np.zeros(0, dtype=bool), *spans])
    corners = mesh_triangles(rig.body.meshes, visible_only=True)
    on_face = [
        element.anchor.position for element in layout.elements if not element.anchor.on_board
    ]
    if not free.any() or not len(corners) or not on_face:
        return None
    rows = look(layout.frame.view, rig.skel_root.up)
    points = deform(rig, layout.character.base_values)
    points = np.where(np.isfinite(points), points, 0.0)
    places = weld(points)
    used = np.isin(np.arange(len(points)), corners)
    pieces = np.where(used, components(corners, places), -1)
    sheets = np.where(used, components(corners, np.arange(len(points))), -1)
    anchors = np.array(on_face) @ rows[:2].T
    middle = float(layout.frame.plane.origin @ rows[0])
    normals = vertex_normals(points, corners, places) @ rows.T
    low, high = anchors.min(axis=0), anchors.max(axis=0)
    return _Seen(
        points @ rows.T,
        normals,
        pieces,
        corners,
        sheets,
        free & used,
        layout.frame.handle_width,
        middle,
        low,
        high,
    )


def _skin(seen: _Seen) -> Flags:
    """(n,) the largest piece among those without colours."""
    pieces = seen.pieces[seen.free]
    return seen.free & (seen.pieces == np.bincount(pieces).argmax()) if len(pieces) else seen.free


def _paint(colours: Floats, colour: tuple[float, float, float], share: Floats) -> None:
    colours += share[:, None] * (np.array(colour) - colours)


# --- eyes -----------------------------------------------------------------------------------------


def _eyes(seen: _Seen, skin: Flags) -> list[_Eye]:
    """The pair of balls that mirror each other farthest in front, the outer where several have one
    centre."""
    balls = [
        ball
        for piece in np.unique(seen.pieces[seen.free & ~skin])
        if (ball := _ball(seen, int(piece)))
    ]
    depth = float(seen.at[skin, 2].min() + seen.at[skin, 2].max()) / 2.0 if skin.any() else 0.0
    pairs = [
        (a, b)
        for a in balls
        for b in balls
        if _mirrored(seen, a, b) and a.centre[2] + a.radius > depth
    ]
    if not pairs:
        return []
    foremost = max(
        pairs, key=lambda pair: (round(float(pair[0].centre[2]) / seen.width), pair[0].radius)
    )
    return [*foremost]


def _ball(seen: _Seen, piece: int) -> _Eye | None:
    """The ball that fits a piece in the least-squares sense, if it is round and not a mere cap."""
    at = seen.at[seen.pieces == piece]
    if len(at) < 16:
        return None
    system = np.hstack([2.0 * at, np.ones((len(at), 1))])
    found = np.linalg.lstsq(system, (at**2).sum(axis=1), rcond=None)[0]
    centre, radius = found[:3], float(np.sqrt(max(found[3] + found[:3] @ found[:3], 0.0)))
    off = np.linalg.norm(at - centre, axis=1) - radius
    spans = at.max(axis=0) - at.min(axis=0)
    is_ball = (
        radius > 0.0
        and np.sqrt((off**2).mean()) < _ROUND * radius
        and (spans[:2] > 1.5 * radius).all()
    )
    return _Eye(centre, radius, piece) if is_ball and spans[2] > radius else None


def _mirrored(seen: _Seen, a: _Eye, b: _Eye) -> bool:
    """Whether `b` is the mirror image of `a`, which lies to the right, and both leave room for a
    nose."""
    image = np.array([2.0 * seen.middle - b.centre[0], *b.centre[1:]])
    apart = a.centre[0] - seen.middle
    near = (
        float(np.linalg.norm(a.centre - image)) < 0.4 * a.radius
        and abs(a.radius - b.radius) < 0.15 * a.radius
    )
    return near and 1.02 * a.radius < apart < 5.0 * a.radius


def _on_eye(seen: _Seen, eye: _Eye, skin: Flags) -> tuple[Flags, Flags]:
    """(n,) points of the eyeball and of other balls about its centre, and of the shells that lie
    over its pupil."""
    away = np.linalg.norm(seen.at - eye.centre, axis=1) / eye.radius
    within = seen.free & (away > _SHELL[0]) & (away < _SHELL[1])
    on = np.isin(
        seen.pieces,
        [each for each in _whole(seen.pieces, within & ~skin) if _ball(seen, each) is not None],
    )
    before = _around_axis(seen, eye)
    over = [
        each for each in _whole(seen.sheets, within & ~on) if (seen.sheets[before] == each).any()
    ]
    return on | (seen.pieces == eye.piece), np.isin(seen.sheets, over)


def _whole(labels: Indices, flags: Flags) -> list[int]:
    """The labels all of whose points have the flag."""
    return [
        int(each) for each in np.unique(labels[flags]) if each >= 0 and flags[labels == each].all()
    ]


def _around_axis(seen: _Seen, eye: _Eye) -> Indices:
    """A point of each triangle that the line of sight from an eye passes through."""
    flat = (seen.at[seen.corners] - eye.centre)[..., :2]
    a, b, c = flat[:, 0], flat[:, 1], flat[:, 2]
    turns = np.stack(
        [p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] for p, q in ((a, b), (b, c), (c, a))], axis=1
    )
    through = (turns >= 0.0).all(axis=1) | (turns <= 0.0).all(axis=1)
    front = (seen.at[seen.corners, 2] > eye.centre[2]).all(axis=1)
    return np.asarray(seen.corners[through & front, 0])


def _directions(offsets: Floats, radius: float) -> Floats:
    """(n, 2) `Complexion.gaze` of points that lie at `offsets` (n, 3) from an eye's centre."""
    unit = offsets / np.maximum(np.linalg.norm(offsets, axis=1, keepdims=True), 1e-12 * radius)
    across = np.linalg.norm(unit[:, :2], axis=1, keepdims=True)
    length = np.where(unit[:, 2:] >= 0.0, across, 2.0 - across)
    return np.asarray(unit[:, :2] / np.maximum(across, 1e-12) * length)


def _brow(seen: _Seen, skin: Flags, eye: _Eye) -> Floats:
    """(n,) how much of a point the brow above an eye covers: an arc along the ridge, thinner to the
    temple."""
    x, y, z = ((seen.at - eye.centre) / eye.radius).T
    outward = x * np.sign(eye.centre[0] - seen.middle)
    column = skin & (abs(x) < 0.4) & (y > 1.1) & (y < 2.3) & (z > 0.0) & (seen.normals[:, 2] > 0.2)
    if np.count_nonzero(column) < 8:
        return np.zeros(len(x))
    height = float(y[column][np.argsort(z[column])[-3:]].mean())
    share = (outward + 1.15) / 2.6
    arc = height + 0.12 - 0.5 * (share - 0.55) ** 2 - 0.25 * np.maximum(share - 0.8, 0.0)
    half = 0.24 - 0.12 * np.clip(share, 0.0, 1.0)
    cover = _soft(1.0 - abs(y - arc) / half) * _soft(8.0 * share) * _soft(5.0 * (1.0 - share))
    return np.asarray(0.8 * cover * (skin & (z > 0.0) & (seen.normals[:, 2] > 0.0)))


# --- mouth ----------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class _Mouth(Record):
    """The line in which the lips meet, seen from the front."""

    line: Floats
    """(k, 3) from right to left of the picture."""

    def _place(self, at: Floats) -> tuple[Floats, Floats, Floats, float]:
        """Share of the way from the middle to a corner, height and depth against the line, half the
        mouth's width."""
        half = 0.5 * float(self.line[-1, 0] - self.line[0, 0])
        middle = 0.5 * float(self.line[-1, 0] + self.line[0, 0])
        height, depth = (
            np.interp(at[:, 0], self.line[:, 0], self.line[:, axis]) for axis in (1, 2)
        )
        return (
            (at[:, 0] - middle) / half,
            (at[:, 1] - height) / half,
            (at[:, 2] - depth) / half,
            half,
        )

    def lips(self, at: Floats, normals: Floats) -> Floats:
        across, above, before, _ = self._place(at)
        full = np.sqrt(np.clip(1.0 - across**2, 0.0, 1.0))
        thick = np.where(above > 0.0, 0.30, 0.36) * full + 1e-9
        cover = _soft(2.5 * (1.0 - abs(above) / thick)) * (abs(before) < 0.8)
        return np.asarray(
            0.75 * cover * (full > 0.0) * ((normals[:, 2] > -0.5) | (abs(above) < 0.2))
        )

    def behind(self, at: Floats) -> Flags:
        across, above, before, _ = self._place(at)
        return np.asarray(
            (abs(across) < 1.4) & (abs(above) < 1.6) & (before < 0.1) & (before > -4.0)
        )


def _mouth(seen: _Seen, skin: Flags) -> _Mouth | None:
    """Where the skin faces itself across a small gap, in one stretch over the mid-plane; the widest
    one counts."""
    room = (seen.high - seen.low).max() * 0.15
    inside = ((seen.at[:, :2] > seen.low - room) & (seen.at[:, :2] < seen.high + room)).all(axis=1)
    near = np.flatnonzero(skin & inside)
    facing = (
        near[_faces_itself(seen.at[near], seen.normals[near], _GAP * seen.width)]
        if len(near)
        else near
    )
    best: tuple[float, _Mouth | None] = (3.0 * seen.width, None)
    for stretch in _stretches(seen.at[facing], 1.5 * seen.width):
        line = _front_line(seen.at[facing[stretch]], seen.width)
        right, left = seen.middle - line[0, 0], line[-1, 0] - seen.middle
        if min(right, left) > 0.6 * max(right, left) and right + left > best[0]:
            best = (float(right + left), _Mouth(line))
    return best[1]


def _faces_itself(at: Floats, normals: Floats, reach: float) -> Flags:
    """(n,) points with another within reach in front of them that looks back."""
    pairs = KDTree(at).query_pairs(reach, output_type="ndarray")
    apart = at[pairs[:, 1]] - at[pairs[:, 0]]
    length = np.maximum(np.linalg.norm(apart, axis=1), 1e-12)
    out, back = normals[pairs[:, 0]], normals[pairs[:, 1]]
    against = np.einsum("ni,ni->n", out, back) < 0.0
    ahead = (np.einsum("ni,ni->n", out, apart) > 0.2 * length) & (
        np.einsum("ni,ni->n", back, apart) < -0.2 * length
    )
    found = np.zeros(len(at), dtype=bool)
    found[pairs[against & ahead].ravel()] = True
    return found


def _stretches(at: Floats, reach: float) -> list[Indices]:
    if not len(at):
        return []
    pairs = KDTree(at).query_pairs(reach, output_type="ndarray")
    graph = csr_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(at), len(at)))
    count, labels = connected_components(graph, directed=False)
    return [np.flatnonzero(labels == each) for each in range(count)]


def _front_line(at: Floats, step: float) -> Floats:
    """(k, 3) the foremost points of a stretch, one for each step to the side."""
    cell = np.floor(at[:, 0] / step).astype(np.int64)
    rows = [at[cell == each][np.argmax(at[cell == each][:, 2])] for each in np.unique(cell)]
    return np.array(sorted(rows, key=lambda row: float(row[0])))


def _soft(share: Floats) -> Floats:
    """0 below 0, 1 above 1, smooth between."""
    t = np.clip(share, 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))
