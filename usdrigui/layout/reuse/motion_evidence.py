"""What the motions of two rigs' controls, or of a layout's, say about which is which.

Two rigs are compared over the whole face, as fields of displacements that are carried from one face to the other and
blurred a little, so that neither topology nor a lid that lies somewhat higher counts.  A layout knows of each control
what it does at its own anchor, to the last digit: exact agreement there says as much as a whole field.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial import cKDTree

from usdrigui.layout.reuse.prior_layout import points_of_meshes, same_point
from usdrigui.layout.reuse.retargeting import face_map
from usdrigui.levels import outer_first
from usdrigui.model import Element, Floats, Indices, Layout, Member, Rig, Trajectories

_SAMPLES = 1.0 / 30.0
"""Distance of the sample points, as a share of the face."""
_CELLS = 1.0 / 60.0
"""Size of the cells over which displacements are averaged first, as a share of the face."""
_BLUR = 0.03
"""Standard deviation of the blur, as a share of the face."""
_NEIGHBOURS = 64
"""Cells within two standard deviations, at most."""

_SLOPE, _MIDDLE, _LEAST = 12.0, 0.45, -4.0
"""Evidence of two fields by their cosine: none at the middle, that of one maker's shape and another's is above."""
_ANCHOR_SLOPE, _ANCHOR_MIDDLE = 5.0, 0.6
"""The same at a single point, where many controls go the same way."""
_LENGTH = 0.5
"""What a pair loses for each natural logarithm between the two lengths, up to three."""
_CLOSE, _CLOSE_WEIGHT, _EXACT = 0.3, 1.5, 0.01
"""Relative difference below which agreement says more and more, until it is as small as rounding and resampling."""
_HANDLE = 0.5
"""Handle widths within which two anchors are one place."""


def over_faces(
    before: tuple[Rig, Trajectories], after: tuple[Rig, Trajectories], landmarks: Mapping[str, str]
) -> Floats:
    """(controls, controls) evidence for every pair of controls of two characters.

    `landmarks`: names after by names before, from which the map between the faces is made; the faces are laid over
    each other by size where there are too few.
    """
    known = {each.name for each in before[0].controls}
    map_ = face_map(before, after, {**dict.fromkeys(known, ""), **landmarks})
    samples = _thinned(before[1], _SAMPLES)
    one, other = map_.vectors(_blurred(before, samples)), _blurred(after, map_.points(samples))
    return _evidence(one.reshape(len(one), -1), other.reshape(len(other), -1), _SLOPE, _MIDDLE)


def at_anchors(
    layout: Layout, left: Sequence[str], rig: Rig, trajectories: Trajectories, new: Sequence[str]
) -> Floats:
    """(left, new) evidence for controls of an earlier layout and of the rig, at the anchors of the layout."""
    held = _held(layout)
    points = _anchor_points(held, rig, trajectories)
    index = {control.name: number for number, control in enumerate(rig.controls)}
    columns = np.array([index[name] for name in new], dtype=np.int64)
    found = np.zeros((len(left), len(new)))
    for row, name in enumerate(left):
        if name in held:
            here = _at_point(trajectories, len(rig.controls), points[name])[columns]
            found[row] = _evidence(held[name].vector[None], here, _ANCHOR_SLOPE, _ANCHOR_MIDDLE)[0]
    return found


def between_anchors(before: Layout, left: Sequence[str], after: Layout, new: Sequence[str]) -> Floats:
    """(left, new) evidence for controls of two layouts of one character."""
    one, other = _held(before), _held(after)
    width = max(before.handle_width, after.handle_width, 1e-300)
    found = np.zeros((len(left), len(new)))
    for row, name in enumerate(left):
        for column, new_name in enumerate(new):
            if name not in one or new_name not in other:
                continue
            a, b = one[name], other[new_name]
            apart = float(np.linalg.norm(a.element.anchor.position - b.element.anchor.position)) / width
            exact = apart < _HANDLE
            value = _evidence(a.vector[None], b.vector[None], _ANCHOR_SLOPE, _ANCHOR_MIDDLE, exact=exact)[0, 0]
            found[row, column] = max(_LEAST, value - (0.0 if exact else apart))
    return found


def _evidence(one: Floats, other: Floats, slope: float, middle: float, *, exact: bool = True) -> Floats:
    """(a, b) evidence for every pair of vectors (a, n) and (b, n); none where one of them does nothing at all."""
    lengths = np.linalg.norm(one, axis=1)[:, None], np.linalg.norm(other, axis=1)[None]
    both = np.maximum(lengths[0] * lengths[1], 1e-300)
    product = one @ other.T
    off = np.sqrt(np.maximum(np.square(lengths[0]) + np.square(lengths[1]) - 2.0 * product, 0.0))
    off /= np.maximum(np.maximum(*lengths), 1e-300)
    ratio = np.abs(np.log(np.maximum(lengths[0], 1e-300) / np.maximum(lengths[1], 1e-300)))
    found = np.maximum(slope * (product / both - middle), _LEAST) - _LENGTH * np.minimum(ratio, 3.0)
    if exact:
        found += np.where(off < _CLOSE, _CLOSE_WEIGHT * np.log(_CLOSE / (off + _EXACT)), 0.0)
    return np.where((lengths[0] > 0.0) & np.any(lengths[1] > 0.0), found, 0.0)


# --- fields ------------------------------------------------------------------------------------------


def _moved_places(trajectories: Trajectories) -> Indices:
    """Places that any control moves."""
    moved = np.zeros(len(trajectories.base), dtype=bool)
    for motion in trajectories.motions:
        moved[motion.points] = True
    return np.flatnonzero(moved & (trajectories.places == np.arange(len(moved))))


def _thinned(trajectories: Trajectories, size: float) -> Floats:
    """(m, 3) about one moved place in every cell of a grid, whose cells are `size` of the face."""
    base = trajectories.base[_moved_places(trajectories)]
    _, first = np.unique(np.floor(base / (size * trajectories.face_size)), axis=0, return_index=True)
    return base[np.sort(first)]


def _blurred(character: tuple[Rig, Trajectories], points: Floats) -> Floats:
    """(controls, m, 3) displacements from least to greatest value around `points` (m, 3), zero where none is near."""
    rig, trajectories = character
    weights = (_around(trajectories, points) @ _cells(trajectories)).tocsc()
    found = np.zeros((len(rig.controls), len(points), 3))
    for motion in trajectories.motions:
        found[motion.control] = weights[:, motion.points] @ (motion.offsets[-1] - motion.offsets[0])
    return found


def _cells(trajectories: Trajectories) -> csr_array:
    """(cells, n) mean over the surface in each cell of a fine grid; cells in the order of `_cell_numbers`."""
    places, number, count = _cell_numbers(trajectories)
    areas = _areas(trajectories, places)
    share = areas / np.bincount(number, areas, count)[number]
    return csr_array((share, (number, places)), shape=(count, len(trajectories.base)))


def _around(trajectories: Trajectories, points: Floats) -> csr_array:
    """(m, cells) weights of the cells around each point."""
    places, number, count = _cell_numbers(trajectories)
    areas = _areas(trajectories, places)
    area = np.bincount(number, areas, count)
    centres = np.stack([np.bincount(number, areas * axis, count) / area for axis in trajectories.base[places].T], 1)
    blur = _BLUR * trajectories.face_size
    apart, near = cKDTree(centres).query(points, k=_NEIGHBOURS, distance_upper_bound=2.0 * blur)
    weights = np.where(np.isfinite(apart), np.exp(-0.5 * np.square(np.minimum(apart, 3.0 * blur) / blur)), 0.0)
    weights *= np.append(area, 0.0)[near]
    weights /= np.maximum(weights.sum(axis=1, keepdims=True), 1e-300)
    rows = np.repeat(np.arange(len(points)), near.shape[1])
    return csr_array((weights.ravel(), (rows, np.minimum(near, count - 1).ravel())), shape=(len(points), count))


def _cell_numbers(trajectories: Trajectories) -> tuple[Indices, Indices, int]:
    """The moved places, the cell of each, and the number of cells."""
    places = _moved_places(trajectories)
    grid = np.floor(trajectories.base[places] / (_CELLS * trajectories.face_size))
    _, number = np.unique(grid, axis=0, return_inverse=True)
    return places, number.reshape(-1), int(number.max(initial=-1)) + 1


def _areas(trajectories: Trajectories, places: Indices) -> Floats:
    """(places,) areas, all above zero."""
    areas = trajectories.areas[places]
    return np.maximum(areas, 1e-6 * float(areas.max(initial=0.0)) or 1.0)


# --- anchors -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Held:
    """What a layout knows of a control on the face."""

    element: Element
    vector: Floats
    """(3,) from the least value to the greatest, at the anchor."""


def _held(layout: Layout) -> dict[str, _Held]:
    """By control, the first level first; tracks on the board are drawn and say nothing."""
    found: dict[str, _Held] = {}
    for element in outer_first(layout.elements):
        for member in element.members if not element.anchor.beside else ():
            found.setdefault(member.control, _Held(element, _displacement(member)))
    return found


def _displacement(member: Member) -> Floats:
    return np.asarray((member.track[-1] - member.track[0]) / (member.gain or 1.0))


def _at_point(trajectories: Trajectories, count: int, point: int) -> Floats:
    """(count, 3) what every control does at a point."""
    found = np.zeros((count, 3))
    for motion in trajectories.motions:
        at = int(np.searchsorted(motion.points, point))
        if at < len(motion.points) and motion.points[at] == point:
            found[motion.control] = motion.offsets[-1, at] - motion.offsets[0, at]
    return found


def _anchor_points(held: Mapping[str, _Held], rig: Rig, trajectories: Trajectories) -> dict[str, int]:
    """By control, the point of today's rig at which the layout held it: the same one, or the nearest that moves."""
    meshes, places = points_of_meshes(rig), _moved_places(trajectories)
    tree = cKDTree(trajectories.base[places])
    found = {}
    for name, each in held.items():
        point = same_point(each.element, meshes)
        found[name] = point if point >= 0 else int(places[tree.query(each.element.anchor.position)[1]])
    return found
