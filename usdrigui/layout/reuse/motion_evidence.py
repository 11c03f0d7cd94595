"""The evidence of the motions of two rigs' controls, or of a layout's, on which is which.

Two rigs are compared over the whole face, as fields of displacements that are carried from one face
to the other and blurred a little, so that neither topology nor a lid that lies somewhat higher
counts.  A layout knows of each control what it does at its own anchor alone, to the last digit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_array
from scipy.spatial import cKDTree

from usdrigui.character import Flags, Floats, Rig
from usdrigui.layout.motion.similarity import displacement_fields
from usdrigui.layout.motion.trajectory import of_controls
from usdrigui.layout.reuse.name_evidence import CHANCE, SAME
from usdrigui.layout.reuse.retargeting import face_map
from usdrigui.layout.shares import NOTHING
from usdrigui.model import Element, Motion, Trajectories
from usdrigui.model.levels import outer_first
from usdrigui.settings import TrajectorySettings

_BLUR = 0.03
"""Standard deviation of the blur, as a share of the face; so far apart are the sample points, and
half as wide the cells over which displacements are averaged first."""
_NO_SIGN = 0.45
"""Cosine of the fields of two motions that says nothing, in rigs of two makers."""


@dataclass(frozen=True)
class Agreement:
    """How alike the motions of two rigs' controls are."""

    cosine: Floats
    """(a, b) of the motions as vectors; 0 where one of them moves nothing."""
    ratio: Floats
    """(a, b) of their lengths, the smaller one by the larger one."""
    moving: Flags
    """(a, b) whether both move anything."""

    @property
    def of_fields(self) -> Floats:
        """(a, b) logarithms of odds that two motions over a face are of one control: they go the
        same way, and more so the closer they are."""
        return self._bounded(SAME * (self.cosine - _NO_SIGN) + np.maximum(self._close, 0.0))

    @property
    def at_a_point(self) -> Floats:
        """The same of motions at one point, where many controls go the same way: only how close
        they are says something."""
        return self._bounded(self._close)

    @property
    def _close(self) -> Floats:
        """The difference of vectors of lengths 1 and r <= 1, which is their relative difference,
        has the square 1 + r^2 - 2 r cos."""
        off = np.sqrt(np.maximum(1.0 + self.ratio**2 - 2.0 * self.ratio * self.cosine, 0.0))
        return -np.log(off + NOTHING)

    def _bounded(self, odds: Floats) -> Floats:
        return np.where(self.moving, np.maximum(odds, -CHANCE), 0.0)


class Kind(NamedTuple):
    """What is compared of two characters: joints, or all else."""

    before: tuple[Rig, Trajectories]
    after: tuple[Rig, Trajectories]
    samples: Floats
    """(m, 3) points of the one face."""
    fields: Floats
    """(controls, m, 3) what its controls do there."""


def kinds(before: tuple[Rig, Trajectories], after: tuple[Rig, Trajectories]) -> list[Kind]:
    """Joints to be compared with joints and the rest with the rest, each at the scale of what they
    move: at that of a body all of a face is one place.  Where the characters have no kind in
    common, everything is one."""
    pairs = [(_of_kind(before, jointed), _of_kind(after, jointed)) for jointed in (False, True)]
    common = [pair for pair in pairs if all(found.motions for _, found in pair)]
    found = []
    for one, other in common or [(before, after)]:
        samples = _thinned(one[1])
        found.append(Kind(one, other, samples, _blurred(one, samples)))
    return found


def over_faces(compared: Sequence[Kind], landmarks: Mapping[str, str]) -> Floats:
    """(before, after) evidence that a control of one character acts as one of another; of a pair of
    two kinds nothing is said.

    `landmarks`: names after by names before, from which the map between the faces is made; the
    faces are laid over each other by size where there are too few.
    """
    return np.asarray(sum(_over(each, landmarks).of_fields for each in compared))


def _of_kind(character: tuple[Rig, Trajectories], jointed: bool) -> tuple[Rig, Trajectories]:
    rig, found = character
    own = [i for i, each in enumerate(rig.controls) if (each.kind == "joint") == jointed]
    return rig, of_controls(rig, found, own, TrajectorySettings())


def _over(kind: Kind, landmarks: Mapping[str, str]) -> Agreement:
    before, after, samples, fields = kind
    map_ = face_map(before, after, {**dict.fromkeys(before[0].control_names, ""), **landmarks})
    one, other = map_.vectors(fields), _blurred(after, map_.points(samples))
    return _agreement(one.reshape(len(one), -1), other.reshape(len(other), -1))


def _agreement(one: Floats, other: Floats) -> Agreement:
    """Of vectors (a, n) and (b, n)."""
    lengths = np.linalg.norm(one, axis=1)[:, None], np.linalg.norm(other, axis=1)[None]
    moving = (lengths[0] > 0.0) & (lengths[1] > 0.0)
    first, second = (np.maximum(each, 1e-300) for each in lengths)
    cosine = np.where(moving, (one / first) @ (other / second.T).T, 0.0)
    return Agreement(cosine, np.minimum(first / second, second / first), moving)


def at_anchors(
    elements: tuple[Element, ...],
    left: Sequence[str],
    rig: Rig,
    trajectories: Trajectories,
    new: Sequence[str],
) -> Floats:
    """(left, new) evidence for controls of an earlier layout and of the rig, at the anchors of the
    layout."""
    held = _held(elements)
    # Of today's rig the point whose track the layout holds: the nearest that moves.
    places = displacement_fields(trajectories).places
    tree = cKDTree(trajectories.surface.points[places])
    points = {name: int(places[tree.query(place)[1]]) for name, (place, _) in held.items()}
    index = rig.control_indices
    columns = np.array([index[name] for name in new], dtype=np.int64)
    found = np.zeros((len(left), len(new)))
    for row, name in enumerate(left):
        if name in held:
            here = _at_point(trajectories.motions, len(rig.controls), points[name])[columns]
            found[row] = _agreement(held[name][1][None], here).at_a_point[0]
    return found


# --- fields ---------------------------------------------------------------------------------------


def _thinned(found: Trajectories) -> Floats:
    """(m, 3) about one moved place in every cell of a grid, as wide as the blur."""
    base = found.surface.points[displacement_fields(found).places]
    cells = np.floor(base / (_BLUR * found.surface.face_size))
    _, first = np.unique(cells, axis=0, return_index=True)
    return base[np.sort(first)]


def _blurred(character: tuple[Rig, Trajectories], points: Floats) -> Floats:
    """(controls, m, 3) displacements from least to greatest value around `points` (m, 3), zero
    where none is near: their means over the surface in each cell of a fine grid, blurred."""
    rig, trajectories = character
    fields, surface = displacement_fields(trajectories), trajectories.surface
    base, size = surface.points[fields.places], surface.face_size
    areas = np.maximum(fields.weights, 1e-6)
    grid = np.floor(base / (0.5 * _BLUR * size))
    number = np.unique(grid, axis=0, return_inverse=True)[1].reshape(-1)
    area = np.bincount(number, areas)
    cells = csr_array((areas / area[number], (number, np.arange(len(base)))))
    tree = cKDTree(cells @ base)
    reach = 2.0 * _BLUR * size
    near = cKDTree(points).sparse_distance_matrix(tree, reach, output_type="coo_matrix")
    amounts = np.exp(-0.5 * np.square(near.data / (_BLUR * size))) * area[near.col]
    amounts /= np.bincount(near.row, amounts, len(points))[near.row]
    weights = csr_array((amounts, (near.row, near.col)), shape=near.shape) @ cells
    found = np.zeros((len(rig.controls), len(points), 3))
    for motion, field in zip(trajectories.motions, fields.vectors, strict=True):
        found[motion.control] = weights @ field
    return found


# --- anchors --------------------------------------------------------------------------------------


def _held(elements: tuple[Element, ...]) -> dict[str, tuple[Floats, Floats]]:
    """What a layout knows of each control on the face: (3,) the position of its anchor, and (3,)
    from the least value to the greatest where the track is.

    The first level first; tracks on the board are drawn and hold no motion.
    """
    found: dict[str, tuple[Floats, Floats]] = {}
    for element in outer_first(elements):
        for member in element.members if not element.anchor.on_board else ():
            moved = (member.track[-1] - member.track[0]) / (member.magnification or 1.0)
            found.setdefault(member.control, (element.anchor.position, moved))
    return found


def _at_point(motions: tuple[Motion, ...], count: int, point: int) -> Floats:
    """(count, 3) what every control does at a point."""
    found = np.zeros((count, 3))
    for motion in motions:
        at = int(np.searchsorted(motion.points, point))
        if at < len(motion.points) and motion.points[at] == point:
            found[motion.control] = motion.span[at]
    return found
