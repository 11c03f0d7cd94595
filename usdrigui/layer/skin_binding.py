"""What carries an element: where its anchor rests, and which shapes and joints move its drawn
parts.

Everything drawn is in the *bind pose*: the space of the SkelRoot with the skeleton in its bind
pose and no shape applied.  There the skin of a point is its mesh's, and the space is the same for
every mesh.  numpy only.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from usdrigui.character import (
    Body,
    Control,
    Floats,
    Indices,
    Joint,
    Record,
    Rig,
    RigMesh,
    Skin,
    Topology,
)
from usdrigui.character.deform import channel_state, keyed, posed
from usdrigui.character.rays import diagonal
from usdrigui.errors import refuse
from usdrigui.following import following, shared
from usdrigui.layer.control_api import felt
from usdrigui.model import Element, Layout

Method = Literal["classicLinear", "dualQuaternion"]

_NO_OFFSET = 1e-9
"""Offsets below this share of the rig's size are noise of the file."""


class JointBinding(Record):
    """How a drawn part hangs on the character's joints."""

    skeleton: int
    """Index into `Body.skeletons`, or -1 if the body has none."""
    joints: Indices
    """(k,) indices into `Body.joints`; none where no joint moves it."""
    weights: Floats
    """(k,)"""
    method: Method
    base: Floats
    """(4, 3) affine map from the bind pose to root space in the base pose: ``p @ base[:3] +
    base[3]``."""

    def unposed(self, positions: Floats) -> Floats:
        """Where points must rest to be at `positions` (q, 3) of root space in the base pose."""
        return np.asarray((positions - self.base[3]) @ self.inverse)

    @property
    def inverse(self) -> Floats:
        """(3, 3) inverse of the linear part; of what is left of it where the base pose collapses
        it."""
        return np.asarray(np.linalg.pinv(self.base[:3], rcond=1e-9))


class PointShape(Record):
    """What one blend-shape weight does to one point, or to each of several points."""

    channel: int
    weights: Floats
    """(k,) ascending; contains 1, never 0."""
    offsets: Floats
    """(k, 3) or (k, q, 3) in the bind pose."""

    def at(self, weight: float) -> Floats:
        """Offset (3,) or (q, 3) at a weight, piecewise linear and extrapolated."""
        nodes = np.append(self.weights, 0.0)
        order = np.argsort(nodes)
        rows = np.concatenate([self.offsets, np.zeros_like(self.offsets[:1])])
        found: Floats = keyed(nodes[order], rows[order], np.array([weight]))[0]
        return found


class AnchorBinding(Record):
    """Everything that the drawn parts of one element need to know about the character."""

    rest: Floats
    """(3,) anchor in the bind pose."""
    handle: JointBinding
    track: JointBinding
    """As `handle`, less what the element's own controls move; on the board, those of any element
    there."""
    shapes: tuple[PointShape, ...]
    """Of the anchor, in the order of the channels; none for an element that does not deform."""
    own_channels: frozenset[int]
    """Channels that the element's own controls drive."""
    turning: bool
    """True when controls that `track` ignores move joints that the anchor hangs on."""
    deforms: bool
    """False for elements on the board and static ones: the anchor's shapes do not act on them."""


class SkinBinding:
    """A rig in the base pose of a layout, with the skin binding of each of its elements."""

    def __init__(self, rig: Rig, layout: Layout) -> None:
        self.rig = rig
        self.values = layout.base_values
        self.weights = channel_state(rig, self.values)[0]
        self.size = _size(rig.body)
        self._positions = rig.control_indices
        self._all_of = shared(rig, layout.elements)

    def control(self, name: str) -> Control:
        """The rig's control of that name."""
        return self.rig.controls[self._positions[name]]

    def value(self, name: str) -> float:
        """Value of a control in the base pose."""
        return float(self.values[self._positions[name]])

    def at_anchor(self, element: Element) -> AnchorBinding:
        """What carries one element."""
        body = self.rig.body
        mesh, point = body.by_path[element.anchor.mesh], element.anchor.point
        follows = following(self.rig, element, self._all_of)
        held = [self.rig.controls[each] for each in follows.held.tolist()]
        deforms = follows.deforms
        skeleton, skin = body.bound_to(mesh), mesh.skin
        moving = influences(skin, point)
        if follows.joint >= 0:
            moving = np.array([follows.joint]), np.ones(1)
        fixed = _without(body, moving, _own_joints(held, self.size))
        turning = fixed is not moving
        track = self._joint_binding(skin, skeleton, fixed)
        return AnchorBinding(
            rest=np.append(mesh.points[point], 1.0) @ _to_rest(body, mesh),
            handle=(self._joint_binding(skin, skeleton, moving) if deforms and turning else track),
            track=track,
            shapes=_shapes_at(body, mesh, point, self.size) if deforms else (),
            own_channels=frozenset(int(c) for control in held for c in control.drive.channels),
            turning=turning,
            deforms=deforms,
        )

    def maps_at(self, handle: JointBinding, controls: Indices, rows: Floats) -> Floats:
        """Affine maps (q, 4, 3) of the handle with some controls at the values of each of the rows
        (q, controls), all others in the base pose."""
        values = np.tile(self.values, (len(rows), 1))
        values[:, controls] = rows
        return np.stack([self._map(handle, each) for each in values])

    def _joint_binding(
        self, skin: Skin | None, skeleton: int, influences: tuple[Indices, Floats]
    ) -> JointBinding:
        method: Method = skin.method if skin is not None else "classicLinear"
        still = JointBinding(skeleton, *influences, method, np.eye(4)[:, :3])
        return replace(still, base=self._map(still, self.values))

    def _map(self, of: JointBinding, values: Floats) -> Floats:
        """(4, 3) map from bind pose to root space, by posing a rig of a single point."""
        if not len(of.joints):
            return of.base
        bound: Floats = np.asarray(np.linalg.inv(self.rig.body.skeletons[of.skeleton].to_root))
        skin = Skin(of.joints[None], of.weights[None], of.method, bound, False)
        single = RigMesh(
            "",
            np.full((1, 3), self.size),
            Topology(_NONE, _NONE, False, ""),
            np.eye(4),
            skin,
        )
        alone = replace(self.rig, body=replace(self.rig.body, meshes=(single,)))
        return np.array(posed(alone, values).maps[0][0])


_NONE: Indices = np.zeros(0, dtype=np.int64)


def _size(body: Body) -> float:
    """Diagonal of the box around the largest mesh, in the units of the bind pose."""
    sizes = (diagonal(mesh.points @ _to_rest(body, mesh)[:3]) for mesh in body.meshes)
    return max(sizes, default=1.0) or 1.0


def _to_rest(body: Body, mesh: RigMesh) -> Floats:
    """(4, 3) map from mesh space to the bind pose."""
    skin = mesh.skin
    if skin is None:
        return mesh.to_root[:, :3]
    skeleton = body.skeletons[body.bound_to(mesh)]
    if abs(np.linalg.det(skeleton.to_root[:3, :3])) < 1e-30:
        raise refuse("SKELETON_INVALID", skeleton.path, "its transform collapses space")
    return (skin.geom_bind @ skeleton.to_root)[:, :3]


def influences(skin: Skin | None, point: int) -> tuple[Indices, Floats]:
    """The joints that move a point of a mesh, and their weights."""
    if skin is None:
        return _NONE, np.zeros(0)
    joints, weights = skin.joints[point], skin.weights[point]
    return joints[weights != 0.0], weights[weights != 0.0]


def _own_joints(controls: list[Control], size: float) -> set[int]:
    """Joints that the controls move by more than nothing."""
    return {
        joint
        for drive in (control.drive for control in controls)
        for joint in drive.joints[felt(drive, size).any(axis=(0, 1, 3))].tolist()
    }


def _without(
    body: Body, influences: tuple[Indices, Floats], own: set[int]
) -> tuple[Indices, Floats]:
    """Influences that the joints `own` cannot reach: each that hangs on them goes to the nearest
    joint above.

    Where there is none above, the others take its share if theirs is no smaller; else nothing moves
    the point any more. Returns the very `influences` when nothing has to change.
    """
    joints, weights = influences
    moved = {int(joint): _free_ancestor(body.joints, int(joint), own) for joint in joints}
    if all(joint == target for joint, target in moved.items()):
        return influences
    shares: dict[int, float] = {}
    for joint, weight in zip(joints.tolist(), weights.tolist(), strict=True):
        shares[moved[joint]] = shares.get(moved[joint], 0.0) + weight
    lost = shares.pop(-1, 0.0)
    kept = sum(shares.values())
    if kept < lost or not kept:
        return _NONE, np.zeros(0)
    targets = sorted(shares)
    scale = (kept + lost) / kept
    return np.array(targets, dtype=np.int64), np.array(
        [shares[target] * scale for target in targets]
    )


def _free_ancestor(joints: tuple[Joint, ...], joint: int, own: set[int]) -> int:
    """The joint itself if no joint from it up to the root is in `own`, else the parent of the
    topmost that is."""
    found, step = joint, joint
    while step >= 0:
        if step in own:
            found = joints[step].parent
        step = joints[step].parent
    return found


def _shapes_at(body: Body, mesh: RigMesh, point: int, size: float) -> tuple[PointShape, ...]:
    """The shapes that move a point of a mesh, in the order of their channels."""
    to_rest, found = _to_rest(body, mesh)[:3], []
    for shape in mesh.shapes:
        offsets = shape.offsets[:, shape.points == point].sum(axis=1, dtype=np.float64) @ to_rest
        if np.abs(offsets).max() > _NO_OFFSET * size:
            found.append(PointShape(shape.channel, shape.weights, offsets))
    return tuple(sorted(found, key=lambda shape: shape.channel))
