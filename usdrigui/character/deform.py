"""Evaluation of a rig at a pose, without USD: the same points as UsdSkel computes.

`deform` answers for one pose, `channel_state` for what a pose sets, `posed` and `Sweep` make the
trajectories of many controls around one pose cheap, and `knots` lists where a control bends.  The
rules are those of the UsdSkel specification: blend shapes first, in mesh space, then
geomBindTransform, then linear or dual-quaternion skinning in skeleton space.  numpy and
scipy only.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array

from usdrigui.character import (
    Body,
    Drive,
    Flags,
    Floats,
    Indices,
    Joint,
    Record,
    Rig,
    RigMesh,
    Shape,
    Singles,
)
from usdrigui.character.rotation import rotations
from usdrigui.character.skinning import (
    SAME,
    applied,
    base_frames,
    base_locals,
    bound_points,
    descendants,
    point_maps,
    skinning_matrices,
)


class Posed(Record):
    """A rig held at one pose."""

    weights: Floats
    """(channels,) blend-shape weights."""
    moves: Floats
    """(3, joints, 3) rotation vectors, translations and logarithms of scales on top of
    `Joint.base`."""
    maps: tuple[Floats, ...]
    """Per mesh, (1 or n, 4, 3): affine map of each blended point from mesh space to root space,
    ``p @ map[:3] + map[3]``; a single map where all points share it."""
    points: Floats
    """(n, 3) points in root space."""

    def map_of(self, body: Body, point: int) -> Floats:
        """(4, 3) the map of one of the points of the `body`."""
        mesh, local = body.mesh_of(point)
        maps = self.maps[body.meshes.index(mesh)]
        return np.asarray(maps[local if len(maps) > 1 else 0])


def deform(rig: Rig, values: ArrayLike | None = None) -> Floats:
    """Points of all meshes in root space, (n, 3), at control `values` (controls,); None for the
    defaults."""
    return posed(rig, values).points


def posed(rig: Rig, values: ArrayLike | None = None) -> Posed:
    """The rig held at control `values` (controls,), or at the defaults: the starting point of
    `sweep`."""
    weights, moves = driven(rig, values)
    skinning = skinning_matrices(rig.body.joints, moved_locals(rig.body.joints, moves[None])[0])
    blended = [_blended(mesh, weights) for mesh in rig.body.meshes]
    maps = tuple(point_maps(rig.body, mesh, skinning) for mesh in rig.body.meshes)
    points = [applied(shape, to_root) for shape, to_root in zip(blended, maps, strict=True)]
    return Posed(weights, moves, maps, np.concatenate(points) if points else np.zeros((0, 3)))


def channel_state(rig: Rig, values: ArrayLike | None = None) -> tuple[Floats, Floats]:
    """What control `values` (controls,) set: weights (channels,) and local joint transforms
    (joints, 4, 4).

    Where several controls drive one joint, their rotation vectors, translations and logarithms of
    scales are added before they are applied, so that the order of the controls does not matter.
    """
    weights, moves = driven(rig, values)
    return weights, moved_locals(rig.body.joints, moves[None])[0]


def sweep(rig: Rig, base: Posed, control: int, values: ArrayLike) -> tuple[Indices, Singles]:
    """The points that one control can move (p,), and their offsets (k, p, 3) at its `values` (k,),
    as `Sweep` has them."""
    found = Sweep(rig, base, control)
    return found.points, found.offsets(np.atleast_1d(np.asarray(values, dtype=np.float64)))


def sweep_start(
    rig: Rig, base: Posed, base_values: Floats | None, control: int
) -> tuple[Posed, float]:
    """The pose from which a control is swept, itself at its default, and its value at the base pose
    `base` of all controls; None for the defaults."""
    default = rig.controls[control].default
    if base_values is None or base_values[control] == default:
        return base, default
    others = base_values.copy()
    others[control] = default
    return posed(rig, others), float(base_values[control])


def knots(rig: Rig, control: int) -> Floats:
    """Values of a control, ascending, at which the path of some point may bend, with minimum,
    default and maximum.

    Under blend shapes alone the path is exactly the polyline through these; where joints move it is
    curved in between and must be sampled.
    """
    subject = rig.controls[control]
    drive = subject.drive
    found = [*drive.values[1:-1]]
    for column, channel in enumerate(drive.channels.tolist()):
        absolute = rig.body.base_weights[channel] + drive.weights[:, column]
        for _, shape in rig.body.shapes_by_channel.get(channel, ()):
            # The offset bends at all nodes but the outermost.
            found.extend(_crossings(drive.values, absolute, _nodes(shape)[1:-1]))
    ends = [subject.minimum, subject.default, subject.maximum]
    # A layer tells values no more exactly than that.
    least = 1e-6 * (subject.maximum - subject.minimum)
    bends = np.unique(np.asarray(found, dtype=np.float64))
    bends = bends[np.diff(bends, prepend=-np.inf) > least]
    bends = bends[(bends > subject.minimum) & (bends < subject.maximum)]
    return np.unique([*ends, *bends[np.abs(bends[:, None] - ends).min(axis=1) > least]])


# --- drives ---------------------------------------------------------------------------------------


def driven(rig: Rig, values: ArrayLike | None) -> tuple[Floats, Floats]:
    """Weights (channels,) and joint moves (3, joints, 3) at control values (controls,)."""
    weights = rig.body.base_weights.copy()
    moves = np.zeros((3, len(rig.body.joints), 3))
    if values is not None:
        for control, value in zip(rig.controls, np.asarray(values, dtype=np.float64), strict=True):
            if value != control.default:
                added, turned = _at(control.drive, value[None])
                weights[control.drive.channels] += added[0]
                moves[:, control.drive.joints] += turned[0]
    return weights, moves


def _at(drive: Drive, values: Floats) -> tuple[Floats, Floats]:
    """Added weights (m, t) and moves (m, 3, j, 3) of a drive at control `values` (m,)."""
    return keyed(drive.values, drive.weights, values), keyed(drive.values, drive.moves, values)


def keyed(keys: Floats, rows: Floats, at: Floats) -> Floats:
    """Rows (k, ...) at values `at` (m,), linear between ascending `keys` (k,), and on beyond
    them."""
    i = keys[1:-1].searchsorted(at, side="right")
    share = ((at - keys[i]) / (keys[i + 1] - keys[i])).reshape(-1, *(1,) * (rows.ndim - 1))
    return (1.0 - share) * rows[i] + share * rows[i + 1]


def moved_locals(joints: tuple[Joint, ...], moves: Floats) -> Floats:
    """Local transforms (m, joints, 4, 4) after `moves` (m, 3, joints, 3).

    With ``base = S R`` and translation t, the result is ``exp(scales) S exp(rotations) R`` and t
    plus the translations: exactly the components that a SkelAnimation holds.
    """
    base, moved = base_locals(joints), np.flatnonzero(moves.any(axis=(0, 1, 3)))
    local: Floats = np.broadcast_to(base, (len(moves), *base.shape)).copy()
    if len(moved):
        frame = base_frames(joints)[moved]
        stretch = base[moved, :3, :3] @ np.swapaxes(frame, -1, -2)
        turned = stretch @ rotations(moves[:, 0, moved]) @ frame
        local[:, moved, :3, :3] = np.exp(moves[:, 2, moved])[..., None] * turned
        local[:, moved, 3, :3] += moves[:, 1, moved]
    return local


def _crossings(keys: Floats, weights: Floats, targets: Floats) -> Floats:
    """Control values at which the piecewise linear `weights` (k,) over `keys` (k,) meet one of
    `targets` (t,)."""
    rise, away = np.diff(weights)[:, None], targets - weights[:-1, None]
    share = np.divide(away, rise, out=np.full(away.shape, np.nan), where=rise != 0.0)
    met = (share >= 0.0) & (share <= 1.0)
    # Beyond the ends the first and last pieces go on.
    met[0] |= share[0] < 0.0
    met[-1] |= share[-1] > 1.0
    pieces = np.nonzero(met)[0]
    return np.asarray(keys[pieces] + share[met] * np.diff(keys)[pieces])


# --- blend shapes ---------------------------------------------------------------------------------


def _nodes(shape: Shape) -> Floats:
    return np.sort(np.append(shape.weights, 0.0))


def _shares(shape: Shape, weights: Floats) -> Floats:
    """How much of each row of `Shape.offsets` acts at the channel's `weights` (m,): (m, k)."""
    if len(shape.weights) == 1:
        return weights[:, None]
    nodes = _nodes(shape)
    table = keyed(nodes, np.eye(len(nodes)), weights)
    return np.delete(table, int(np.searchsorted(nodes, 0.0)), axis=1)


def _offsets(shape: Shape, shares: Floats) -> NDArray[np.floating]:
    """Blended offsets (m, p, 3) in mesh space for `shares` (m, k)."""
    singles = shares.astype(np.float32)[:, :, None, None]
    total: NDArray[np.floating] = singles[:, 0] * shape.offsets[0]
    for row in range(1, len(shape.weights)):  # added in the same order on every processor
        total += singles[:, row] * shape.offsets[row]
    return total


def _blended(mesh: RigMesh, weights: Floats) -> Floats:
    """(n, 3) points of a mesh in its own space with the shapes applied."""
    points = mesh.points
    acting = [shape for shape in mesh.shapes if weights[shape.channel] != 0.0]
    if acting:
        points = points.copy()
        for shape in acting:
            points[shape.points] += _offsets(shape, _shares(shape, weights[shape.channel][None]))[0]
    return points


# --- sweeps ---------------------------------------------------------------------------------------


class Sweep:
    """Motion of the points as one control moves and all others stay as in `base`.

    What does not depend on the control's value is found once.  Under blend shapes alone the offset
    is the blended offset times the point's own 3x3 map, whatever the skinning, because the skin
    does not change.
    """

    points: Indices
    """(p,) the points that the control can move, ascending."""

    def __init__(self, rig: Rig, base: Posed, control: int) -> None:
        self._body, self._base, self._drive = rig.body, base, rig.controls[control].drive
        joints, channels = (
            frozenset(each.tolist()) for each in (self._drive.joints, self._drive.channels)
        )
        self._parts = _reached(rig.body, base, joints, channels)
        starts = rig.body.starts
        parts = [starts[part.index] + part.local for part in self._parts]
        self.points = np.concatenate([np.zeros(0, dtype=np.int64), *parts])

    def offsets(self, values: Floats) -> Singles:
        """(k, p, 3) from `base` in root space, at control `values` (k,)."""
        added, turned = _at(self._drive, values)
        weights = np.repeat(self._base.weights[None], len(values), axis=0)
        weights[:, self._drive.channels] += added
        skinning = np.zeros((0, 0, 4, 4))
        if len(self._drive.joints):
            moves = np.repeat(self._base.moves[None], 1 + len(values), axis=0)
            moves[1:, :, self._drive.joints] += turned
            joints = self._body.joints
            skinning = skinning_matrices(joints, moved_locals(joints, moves))
        nothing = np.zeros((len(values), 0, 3), dtype=np.float32)
        parts = [self._of(part, weights, skinning) for part in self._parts]
        return np.concatenate([nothing, *parts], axis=1)

    def _of(self, part: _Reached, weights: Floats, skinning: Floats) -> Singles:
        """Offsets (k, p, 3) of one mesh at `weights` (k, channels); `skinning` holds the base and
        then k poses, or nothing."""
        body, mesh = self._body, self._body.meshes[part.index]
        if not part.turning:
            offsets = _shape_offsets(part, weights, self._base.weights)
            return _turned(offsets, self._base.maps[part.index], part.local)
        skin = mesh.skin
        if part.weighted is not None and skin is not None:
            to_root = body.skeletons[body.skeleton_of(skin)].to_root[:3, :3]
            change = (skinning[1:] - skinning[0])[..., :3] @ to_root
            table = change.transpose(1, 2, 0, 3).reshape(4 * len(body.joints), -1)
            swept = (part.weighted @ table).reshape(len(part.local), -1, 3)
            return np.asarray(swept.transpose(1, 0, 2), dtype=np.float32)
        before = self._base.points[body.starts[part.index] + part.local]
        offsets = np.empty((len(weights), len(part.local), 3), dtype=np.float32)
        for k, pose in enumerate(weights):
            maps = point_maps(body, mesh, skinning[k + 1], part.local)
            offsets[k] = applied(_blended(mesh, pose)[part.local], maps) - before
        return offsets


class _Reached(Record):
    """What a control can move of one mesh."""

    index: int
    local: Indices
    """(p,) points of the mesh, ascending."""
    shapes: tuple[Shape, ...]
    """Those that it drives."""
    turning: bool
    """Whether joints turn that act on the mesh."""
    weighted: csr_array | None
    """(p, 4 joints) points after geomBindTransform, times the weight of each turning joint: only
    these joints contribute to the offsets, linearly.  None where shapes or dual quaternions make
    them depend on more."""

    @classmethod
    def of(
        cls, body: Body, base: Posed, index: int, turning: Flags, channels: frozenset[int]
    ) -> _Reached:
        """What the joints `turning` (joints,) and the shapes of `channels` move."""
        mesh = body.meshes[index]
        shapes = tuple(shape for shape in mesh.shapes if shape.channel in channels)
        skin, count = mesh.skin, np.zeros(len(mesh.points), dtype=np.int64)
        if skin is not None:
            held = np.diff(skin.by_joint.indptr) > 0
            joints = np.flatnonzero(held & turning[: len(held)])
            if len(joints):
                acting = skin.by_joint[:, joints].tocsr()
                count = np.diff(acting.indptr)
        reached = count > 0
        turns = bool(reached.any())
        for shape in shapes:
            reached[shape.points] = True
        points = np.flatnonzero(reached)
        if skin is None or shapes or not turns or skin.method != "classicLinear":
            return cls(index, points, shapes, turns, None)
        bound = bound_points(_blended(mesh, base.weights)[points], skin)
        owner = np.repeat(np.arange(len(points)), count[points])
        data = (acting.data[:, None] * bound[owner]).ravel()
        columns = (4 * joints[acting.indices][:, None] + np.arange(4)).ravel()
        ends = np.append(0, 4 * acting.indptr[1:][reached])
        weighted = csr_array((data, columns, ends), shape=(len(points), 4 * len(body.joints)))
        return cls(index, points, (), True, weighted)


@lru_cache(1)
def _reached(
    body: Body, base: Posed, joints: frozenset[int], channels: frozenset[int]
) -> tuple[_Reached, ...]:
    """What some joints and channels move of each mesh, where they do: once for the axes of a joint,
    one after the other."""
    turning = np.asarray(descendants(body.joints)[[*joints]].any(axis=0))
    every = (_Reached.of(body, base, index, turning, channels) for index in range(len(body.meshes)))
    return tuple(part for part in every if len(part.local))


def _shape_offsets(part: _Reached, weights: Floats, base: Floats) -> NDArray[np.floating]:
    """Blended offsets (k, p, 3) of the shapes in mesh space, from the `base` weights (channels,) to
    `weights` (k, channels)."""
    total = np.zeros((len(weights), len(part.local), 3), dtype=np.float32)
    for shape in part.shapes:
        now, before = (_shares(shape, each[:, shape.channel]) for each in (weights, base[None]))
        total[:, np.searchsorted(part.local, shape.points)] += _offsets(shape, now - before)
    return total


def _turned(offsets: NDArray[np.floating], maps: Floats, local: Indices) -> Singles:
    """Offsets (k, p, 3) from mesh space to root space by the linear part of the points' maps."""
    linear = maps[:, :3]
    if len(linear) == 1 and np.abs(linear[0] - np.eye(3)).max() <= SAME:
        return offsets.astype(np.float32, copy=False)
    by_point = (linear[local] if len(linear) > 1 else linear).astype(np.float32)
    turned = np.empty(offsets.shape, dtype=np.float32)
    for j in range(3):  # one after the other: the same sums on every processor
        turned[..., j] = offsets[..., 0] * by_point[:, 0, j]
        turned[..., j] += offsets[..., 1] * by_point[:, 1, j]
        turned[..., j] += offsets[..., 2] * by_point[:, 2, j]
    return turned
