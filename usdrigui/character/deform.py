"""Evaluation of a rig at a pose, without USD: the same points as UsdSkel computes.

`deform` answers for one pose, `channel_state` for what a pose sets, `posed` and `sweep` make the
trajectories of many controls around one pose cheap, and `knots` lists where a control bends.  The
rules are those of the UsdSkel specification: blend shapes first, in mesh space, then
geomBindTransform, then linear or dual-quaternion skinning in skeleton space.  numpy only.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from usdrigui.character import (
    Body,
    Drive,
    Floats,
    Indices,
    Joint,
    Record,
    Rig,
    RigMesh,
    Shape,
    Singles,
)
from usdrigui.character.rotation import rotation_part, rotations
from usdrigui.character.skinning import (
    SAME,
    add_influences,
    applied,
    bound_points,
    point_maps,
    skeleton_to_root,
    skinned,
    skinning_matrices,
)


@dataclass(frozen=True, eq=False)
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


def deform(rig: Rig, values: ArrayLike | None = None) -> Floats:
    """Points of all meshes in root space, (n, 3), at control `values` (controls,); None for the
    defaults."""
    weights, local = channel_state(rig, values)
    skinning = skinning_matrices(rig.body.joints, local)
    points = [
        skinned(rig.body, mesh, _blended(mesh, weights), skinning) for mesh in rig.body.meshes
    ]
    return np.concatenate(points) if points else np.zeros((0, 3))


def posed(rig: Rig, values: ArrayLike | None = None) -> Posed:
    """The rig held at control `values` (controls,), or at the defaults: the starting point of
    `sweep`."""
    weights, moves = _driven(rig, values)
    skinning = skinning_matrices(rig.body.joints, _moved(rig.body.joints, moves))
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
    weights, moves = _driven(rig, values)
    return weights, _moved(rig.body.joints, moves)


def sweep(rig: Rig, base: Posed, control: int, values: ArrayLike) -> tuple[Indices, Singles]:
    """Motion of the points as one control takes `values` (k,) and all others stay as in `base`.

    Returns the points that the control can move (p,), ascending, and their offsets (k, p, 3) from
    `base.points` in root space.  Under blend shapes alone the offset is the blended offset times
    the point's own 3x3 map, whatever the skinning, because the skin does not change.
    """
    drive = rig.controls[control].drive
    at = np.atleast_1d(np.asarray(values, dtype=np.float64))
    added = _interpolated(drive.values, drive.weights, at)
    if len(drive.joints):
        return _sweep_joints(rig.body, base, drive, at, added)
    return _sweep_shapes(rig.body, base, drive.channels, base.weights[drive.channels] + added)


def sweep_start(
    rig: Rig, base: Posed, base_values: Floats | None, control: int
) -> tuple[Posed, float]:
    """The pose from which a control is swept, itself at its default, and its value at the base pose
    `base` of all controls; None for the defaults."""
    default = rig.controls[control].default
    if base_values is None or base_values[control] == default:
        return base, default
    others = np.array(base_values, dtype=np.float64)
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
    found = [subject.minimum, subject.default, subject.maximum, *drive.values[1:-1]]
    for column, channel in enumerate(drive.channels):
        absolute = rig.body.base_weights[channel] + drive.weights[:, column]
        found.extend(
            _crossings(drive.values, absolute, _bends(rig.body.shapes_by_channel, int(channel)))
        )
    inside = np.unique(np.asarray(found, dtype=np.float64))
    return inside[(inside >= subject.minimum) & (inside <= subject.maximum)]


# --- drives ---------------------------------------------------------------------------------------


def _driven(rig: Rig, values: ArrayLike | None) -> tuple[Floats, Floats]:
    """Weights (channels,) and joint moves (3, joints, 3) at control values (controls,)."""
    weights = rig.body.base_weights.copy()
    moves = np.zeros((3, len(rig.body.joints), 3))
    if values is not None:
        for control, value in zip(rig.controls, np.asarray(values, dtype=np.float64), strict=True):
            if value != control.default:
                _add_drive(control.drive, float(value), weights, moves)
    return weights, moves


def _add_drive(drive: Drive, value: float, weights: Floats, moves: Floats) -> None:
    # One value at a time, many times a second while posing: as `_interpolated`, without its arrays.
    keys = drive.values
    i = min(max(int(keys.searchsorted(value, side="right")) - 1, 0), len(keys) - 2)
    share = (value - keys[i]) / (keys[i + 1] - keys[i])
    if len(drive.channels):
        weights[drive.channels] += (1.0 - share) * drive.weights[i] + share * drive.weights[i + 1]
    if len(drive.joints):
        for row, table in enumerate((drive.rotations, drive.translations, drive.scales)):
            moves[row, drive.joints] += (1.0 - share) * table[i] + share * table[i + 1]


def _interpolated(keys: Floats, table: Floats, at: Floats) -> Floats:
    """Rows of `table` (k, ...) at `at` (m,), linear between `keys` (k,) and extrapolated beyond
    them."""
    i = np.clip(np.searchsorted(keys, at, side="right") - 1, 0, len(keys) - 2)
    share = (at - keys[i]) / (keys[i + 1] - keys[i])
    share = share.reshape(-1, *(1,) * (table.ndim - 1))
    return np.asarray((1.0 - share) * table[i] + share * table[i + 1], dtype=np.float64)


def _base_locals(joints: tuple[Joint, ...]) -> Floats:
    return np.array([joint.base for joint in joints], dtype=np.float64).reshape(-1, 4, 4)


def _moved(joints: tuple[Joint, ...], moves: Floats) -> Floats:
    """Local transforms (joints, 4, 4) after `moves` (3, joints, 3)."""
    local: Floats = _moved_joints(_base_locals(joints), moves[None])[0]
    return local


def _moved_joints(base: Floats, moves: Floats) -> Floats:
    """Local transforms (m, joints, 4, 4) of `base` (joints, 4, 4) after `moves` (m, 3, joints, 3).

    With ``base = S R`` and translation t, the result is ``exp(scales) S exp(rotations) R`` and t
    plus the translations: exactly the components that a SkelAnimation holds.
    """
    local: Floats = np.broadcast_to(base, (len(moves), *base.shape)).copy()
    moved = np.flatnonzero(moves.any(axis=(0, 1, 3)))
    if len(moved):
        frame = rotation_part(base[moved])
        stretch = base[moved, :3, :3] @ np.swapaxes(frame, -1, -2)
        turned = stretch @ rotations(moves[:, 0, moved]) @ frame
        local[:, moved, :3, :3] = np.exp(moves[:, 2, moved])[..., None] * turned
        local[:, moved, 3, :3] += moves[:, 1, moved]
    return local


def _bends(
    shapes_by_channel: Mapping[int, tuple[tuple[int, Shape], ...]], channel: int
) -> list[float]:
    """Weights, ascending, at which some shape's offset bends: all its nodes but the outermost."""
    shapes = shapes_by_channel.get(channel, ())
    return sorted({node for _, shape in shapes for node in _nodes(shape)[1:-1].tolist()})


def _crossings(keys: Floats, weights: Floats, targets: list[float]) -> list[float]:
    """Control values at which the piecewise linear `weights` (k,) over `keys` (k,) meet one of
    `targets`."""
    found = []
    for i in range(len(keys) - 1):
        rise = weights[i + 1] - weights[i]
        # Beyond the ends the first and last pieces go on.
        low = 0.0 if i else -np.inf
        high = 1.0 if i < len(keys) - 2 else np.inf
        for target in targets if rise else ():
            share = (target - weights[i]) / rise
            if low <= share <= high:
                found.append(float(keys[i] + share * (keys[i + 1] - keys[i])))
    return found


# --- blend shapes ---------------------------------------------------------------------------------


def _nodes(shape: Shape) -> Floats:
    return np.sort(np.append(shape.weights, 0.0))


def _shares(shape: Shape, weights: Floats) -> Floats:
    """How much of each row of `Shape.offsets` acts at the channel's `weights` (m,): (m, k)."""
    if len(shape.weights) == 1:
        return weights[:, None]
    nodes = _nodes(shape)
    i = np.clip(np.searchsorted(nodes, weights, side="right") - 1, 0, len(nodes) - 2)
    share = (weights - nodes[i]) / (nodes[i + 1] - nodes[i])
    table = np.zeros((len(weights), len(nodes)))
    rows = np.arange(len(weights))
    table[rows, i] = 1.0 - share
    table[rows, i + 1] = share
    return np.delete(table, int(np.searchsorted(nodes, 0.0)), axis=1)


def _offsets(shape: Shape, shares: Floats) -> NDArray[np.floating]:
    """Blended offsets (m, p, 3) in mesh space for `shares` (m, k)."""
    singles = shares.astype(np.float32)[:, :, None, None]
    total: NDArray[np.floating] = singles[:, 0] * shape.offsets[0]
    for row in range(
        1, len(shape.weights)
    ):  # a matrix product would add in another order on each processor
        total += singles[:, row] * shape.offsets[row]
    return total


def _blended(mesh: RigMesh, weights: Floats) -> Floats:
    """(n, 3) points of a mesh in its own space with the shapes applied."""
    points = mesh.points
    acting = [shape for shape in mesh.binding.shapes if weights[shape.channel] != 0.0]
    if acting:
        points = points.copy()
        for shape in acting:
            points[shape.points] += _offsets(shape, _shares(shape, weights[shape.channel][None]))[0]
    return points


def _sweep_shapes(
    body: Body, base: Posed, channels: Indices, weights: Floats
) -> tuple[Indices, Singles]:
    """`sweep` for a control that drives `channels` (t,) with `weights` (k, t)."""
    column = {int(channel): i for i, channel in enumerate(channels)}
    driven: dict[int, list[Shape]] = {}
    for channel in column:
        for index, shape in body.shapes_by_channel.get(channel, ()):
            driven.setdefault(index, []).append(shape)
    starts = body.starts
    parts = []
    for index in sorted(driven):
        local, moved = _mesh_offsets(driven[index], column, weights, base.weights)
        parts.append((starts[index] + local, _turned(moved, base.maps[index], local)))
    return _joined(parts, len(weights))


def _joined(parts: list[tuple[Indices, Singles]], count: int) -> tuple[Indices, Singles]:
    """Points (p,) and offsets (count, p, 3) of several meshes as one."""
    if len(parts) == 1:
        return parts[0]
    nothing = (np.zeros(0, dtype=np.int64), np.zeros((count, 0, 3), dtype=np.float32))
    points, offsets = zip(nothing, *parts, strict=True)
    return np.concatenate(points), np.concatenate(offsets, axis=1)


def _mesh_offsets(
    shapes: list[Shape], column: dict[int, int], weights: Floats, base: Floats
) -> tuple[Indices, NDArray[np.floating]]:
    """Local points (p,) of `shapes` and their blended offsets (k, p, 3) from the base weights, in
    mesh space."""
    parts = []
    for shape in shapes:
        now = _shares(shape, weights[:, column[shape.channel]])
        before = _shares(shape, base[shape.channel][None])
        parts.append(_offsets(shape, now - before))
    if len(shapes) == 1:
        return shapes[0].points, parts[0]
    points = np.unique(np.concatenate([shape.points for shape in shapes]))
    total = np.zeros((len(weights), len(points), 3), dtype=np.float32)
    for shape, part in zip(shapes, parts, strict=True):
        total[:, np.searchsorted(points, shape.points)] += part
    return points, total


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


# --- joints ---------------------------------------------------------------------------------------


def _sweep_joints(
    body: Body, base: Posed, drive: Drive, at: Floats, added: Floats
) -> tuple[Indices, Singles]:
    """`sweep` for a control that moves joints, and perhaps weights too."""
    moves = np.repeat(base.moves[None], len(at), axis=0)
    for row, table in enumerate((drive.rotations, drive.translations, drive.scales)):
        moves[:, row, drive.joints] += _interpolated(drive.values, table, at)
    moves = np.concatenate([base.moves[None], moves])
    skinning = skinning_matrices(body.joints, _moved_joints(_base_locals(body.joints), moves))
    turning = (skinning[1:] != skinning[0]).any(axis=(0, 2, 3))
    weights = np.repeat(base.weights[None], len(at), axis=0)
    weights[:, drive.channels] += added
    parts = []
    for index, mesh in enumerate(body.meshes):
        moved = _reached(mesh, turning, drive.channels)
        if len(moved):
            offsets = _mesh_sweep(body, base, index, moved, weights, skinning, turning)
            parts.append((body.starts[index] + moved, offsets))
    return _joined(parts, len(at))


def _mesh_sweep(
    body: Body,
    base: Posed,
    index: int,
    moved: Indices,
    weights: Floats,
    skinning: Floats,
    turning: NDArray[np.bool_],
) -> Singles:
    """Offsets (k, p, 3) of the `moved` local points of one mesh; `skinning` holds the base and then
    k poses."""
    mesh = body.meshes[index]
    driven = [
        shape
        for shape in mesh.binding.shapes
        if (weights[:, shape.channel] != base.weights[shape.channel]).any()
    ]
    skin = mesh.binding.skin
    if skin is not None and skin.method == "classicLinear" and not driven:
        # Only the turning joints contribute to the offset, linearly.
        bound = bound_points(_blended(mesh, base.weights)[moved], skin)
        change = (skinning[1:] - skinning[0])[..., :3] @ skeleton_to_root(
            body.skeletons, body.joints, skin
        )[:3, :3]
        total = np.zeros((len(moved), 3 * len(change)))
        flat = np.ascontiguousarray(change.transpose(1, 2, 0, 3)).reshape(len(body.joints), 4, -1)
        row = np.zeros(len(mesh.points), dtype=np.int64)
        row[moved] = np.arange(len(moved))
        add_influences(skin, bound, flat, total, turning, row)
        return total.reshape(len(moved), -1, 3).transpose(1, 0, 2).astype(np.float32)
    before = base.points[body.starts[index] + moved]
    offsets = np.empty((len(weights), len(moved), 3), dtype=np.float32)
    for k, pose in enumerate(weights):
        blended = _blended(mesh, pose)[moved]
        offsets[k] = applied(blended, point_maps(body, mesh, skinning[k + 1], moved)) - before
    return offsets


def _reached(mesh: RigMesh, turning: NDArray[np.bool_], channels: Indices) -> Indices:
    """Local points that turning joints or the channels' shapes move."""
    reached = np.zeros(len(mesh.points), dtype=np.bool_)
    if mesh.binding.skin is not None:
        points, _, joints, starts = mesh.binding.skin.by_joint
        for i in np.flatnonzero(turning[joints]):
            reached[points[starts[i] : starts[i + 1]]] = True
    driven = set(channels.tolist())
    for shape in mesh.binding.shapes:
        if shape.channel in driven:
            reached[shape.points] = True
    return np.flatnonzero(reached)
