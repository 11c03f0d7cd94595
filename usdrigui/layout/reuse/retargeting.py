"""From one character's layout to another's: where the same place is on another face (paper section
1, re-targeting).

The two faces need not share topology, size, pose or place in the world.  What they share is
controls, by name: the region that each of them moves is a landmark, and the landmarks map one face
onto the other, by a similarity that outvotes those that disagree and then by a smooth warp.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from usdrigui.character import Flags, Floats, Rig
from usdrigui.layout.canonical_face import LEAST
from usdrigui.layout.face import AROUND
from usdrigui.layout.reuse.prior_layout import Place, PriorLayout, kept_groups, places_of
from usdrigui.layout.reuse.renaming import with_names
from usdrigui.layout.shares import NOTHING, OUTLIER
from usdrigui.model import BaseSurface, Layout, Motion, Trajectories

_POWERS = (2.0, 12.0)
"""Of the distance moved, as weights of the two landmarks of a control: a wide mean and one close to
the peak."""
_ROUNDS = 20
_SMOOTHINGS = (NOTHING, 1.0 / NOTHING)
"""Of the warp: one that passes through every landmark, and hardly more than an affine map."""


@dataclass(frozen=True)
class _Similarity:
    """p -> scale * rotation @ p + offset."""

    scale: float
    rotation: Floats
    offset: Floats

    def __call__(self, points: Floats) -> Floats:
        return self.scale * points @ self.rotation.T + self.offset


def of_another(
    layout: Layout,
    theirs: tuple[Rig, Trajectories],
    ours: tuple[Rig, Trajectories],
    names: Mapping[str, str],
    penalty: float,
) -> PriorLayout:
    """Another character's layout as a prior of ours.

    Parameters: `layout` of `theirs`; `names` maps their control names to ours where these differ.
    Controls without a counterpart are free.  Elements that share controls there share them here.
    """
    renamed = with_names(layout, names)
    positions = np.array([element.anchor.position for element in layout.elements])
    places = face_map(theirs, ours, names).points(positions)
    there = {e.name: place for e, place in zip(renamed.elements, places, strict=True)}
    found, _ = places_of(
        renamed.elements,
        ours[0].control_indices,
        lambda element: Place(-1, there[element.name], element.anchor.on_board),
    )
    return PriorLayout(
        kept_groups(renamed.elements, ours[0]),
        found,
        penalty=penalty,
        cutoff_distance=AROUND,  # from the corresponding place: there the whole penalty is due
    )


@dataclass(frozen=True)
class FaceMap:
    """From one face to another: a similarity, and the landmarks that warp what it maps."""

    similarity: _Similarity
    source: Floats
    """(k, 3) trusted landmarks of the one face, mapped by the similarity; none where they are too
    few for a warp."""
    target: Floats
    """(k, 3) the same landmarks on the other."""

    def points(self, points: Floats) -> Floats:
        """(m, 3) where points (m, 3) of the one face are on the other."""
        aligned = self.similarity(points)
        return _warped(self.source, self.target, aligned) if len(self.source) else aligned

    def vectors(self, vectors: Floats) -> Floats:
        """(..., 3) displacements as the other face has them, without the warp."""
        return self.similarity.scale * vectors @ self.similarity.rotation.T


def face_map(
    theirs: tuple[Rig, Trajectories], ours: tuple[Rig, Trajectories], names: Mapping[str, str]
) -> FaceMap:
    """The map from their face to ours by the controls that both have; `names` maps their names to
    ours."""
    source, target = _landmarks(theirs, ours, names)
    if len(source) < LEAST * len(_POWERS) or not (_spans(source, 2) and _spans(target, 2)):
        return FaceMap(_by_size(theirs, ours), source[:0], target[:0])
    similarity, trusted = _robust(source, target)
    return FaceMap(similarity, similarity(source[trusted]), target[trusted])


# --- landmarks ------------------------------------------------------------------------------------


def _landmarks(
    theirs: tuple[Rig, Trajectories], ours: tuple[Rig, Trajectories], names: Mapping[str, str]
) -> tuple[Floats, Floats]:
    """(k, 3) landmarks of the shared controls, on their face and on ours."""
    here, there = _marks(*ours), _marks(*theirs)
    named = ((names.get(name, name), marks) for name, marks in there.items())
    kept = np.array([(marks, here[name]) for name, marks in named if name in here])
    source, target = kept.reshape(-1, 2, 2, 3).swapaxes(0, 1)
    return source.reshape(-1, 3), target.reshape(-1, 3)


def _marks(rig: Rig, trajectories: Trajectories) -> dict[str, Floats]:
    """By control name, (2, 3) the middle of what it moves and the middle of what it moves most."""
    return {
        rig.control_names[motion.control]: np.stack(
            [_middle(trajectories.surface, motion, power) for power in _POWERS]
        )
        for motion in trajectories.motions
    }


def _middle(surface: BaseSurface, motion: Motion, power: float) -> Floats:
    """(3,) mean of the places (a face that is split at seams is the same face), weighted by the
    distance moved."""
    first = surface.first[motion.points]
    weights = np.where(first, (motion.arc_length / motion.arc_length.max()) ** power, 0.0)
    if not weights.any():
        weights = np.ones(len(weights))
    return np.asarray(weights @ surface.points[motion.points] / weights.sum())


def _spans(points: Floats, directions: int) -> bool:
    """Whether points span so many directions: 2 is more than a line, 3 more than a plane."""
    values = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return len(points) > directions and bool(values[directions - 1] > NOTHING * values[0])


# --- from one face to the other -------------------------------------------------------------------


def _robust(source: Floats, target: Floats) -> tuple[_Similarity, Flags]:
    """The similarity on which most landmarks agree, and (k,) which of them do."""
    similarity = _fitted(source, target, np.ones(len(source)))
    for _ in range(_ROUNDS):
        off = np.linalg.norm(similarity(source) - target, axis=1)
        scale = max(
            float(np.median(off)), 1e-9 * float(np.linalg.norm(target - target[0], axis=1).max())
        )
        similarity = _fitted(source, target, 1.0 / (1.0 + np.square(off / scale)))
    return similarity, off <= OUTLIER * scale


def _fitted(source: Floats, target: Floats, weights: Floats) -> _Similarity:
    """Least squares, weighted, without reflection (Umeyama 1991)."""
    share = weights / weights.sum()
    from_middle, to_middle = share @ source, share @ target
    one, other = source - from_middle, target - to_middle
    turn = Rotation.align_vectors(other, one, weights)[0].as_matrix()
    scale = float(
        share @ (other * (one @ turn.T)).sum(axis=1) / (share @ np.square(one).sum(axis=1))
    )
    return _Similarity(scale, turn, to_middle - scale * turn @ from_middle)


def _warped(source: Floats, target: Floats, points: Floats) -> Floats:
    """`points` (k, 3) under the smooth warp that takes aligned landmarks to where they belong.

    How far two characters' controls correspond differs from pair to pair: copies of one head agree
    to the point, two makers' rigs only on the whole.  So the landmarks themselves choose the
    smoothness, those of every second control predicted from the others and the other way round
    (cross-validation).
    """
    second = np.arange(len(source)) // len(_POWERS) % 2 == 1
    missed = np.zeros((len(_SMOOTHINGS), len(source)))
    for out in (second, ~second):
        for row, smoothing in enumerate(_SMOOTHINGS):
            found = _thin_plate(source[~out], target[~out], smoothing, source[out])
            missed[row, out] = np.linalg.norm(found - target[out], axis=1)
    return _thin_plate(source, target, _SMOOTHINGS[int(np.median(missed, axis=1).argmin())], points)


def _thin_plate(source: Floats, target: Floats, smoothing: float, points: Floats) -> Floats:
    """`points` moved as a thin-plate spline moves `source` to `target`; in units of the source's
    own size."""
    middle = source.mean(axis=0)
    unit = np.linalg.norm(source - middle, axis=1).max()
    _, first = np.unique(np.round((source - middle) / unit, 6), axis=0, return_index=True)
    if not _spans(source[first], 3):
        return points
    from scipy.interpolate import RBFInterpolator  # a tenth of a second that only some layouts need

    moved = RBFInterpolator(
        (source[first] - middle) / unit,
        (target - source)[first],
        kernel="thin_plate_spline",
        smoothing=smoothing,
        degree=1,
    )
    return np.asarray(points + moved((points - middle) / unit))


def _by_size(theirs: tuple[Rig, Trajectories], ours: tuple[Rig, Trajectories]) -> _Similarity:
    """From too few landmarks: moving regions put middle on middle, scaled by their heights, up on
    up."""
    (rig, one), (other_rig, other) = theirs, ours
    scale = other.surface.face_size / one.surface.face_size
    rotation = Rotation.align_vectors(other_rig.up, rig.up)[0].as_matrix()
    return _Similarity(scale, rotation, other.middle - scale * rotation @ one.middle)
