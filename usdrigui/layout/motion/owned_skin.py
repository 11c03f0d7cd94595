"""The skin that a joint owns: the places of the joint's control.

The displacement of a joint grows with the distance from it, so its largest displacement lies at the
end of the chain.  The control is instead where the joint has the most weight, between the joint
and the next one.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import cached_property, lru_cache

import numpy as np

from usdrigui.character import Body, Control, Flags, Floats, Record, Rig
from usdrigui.character.deform import posed
from usdrigui.character.joint_tree import OWNS, Tree
from usdrigui.character.skinning import base_locals, descendants, in_skeleton_space
from usdrigui.layout.shares import MOST
from usdrigui.ties import steady

_SPAN = (0.2, 0.7)
"""Share of the way from a joint to the next one between which its control is."""
_BEYOND = 0.5
"""Factor on the weight of skin beyond that."""
_OTHERS = 8
"""Power of the ratio of distances by which skin nearer to another bone of the chain counts less."""
_LAST = 0.8
"""Length of the bone of a joint at the end of a chain, as a share of the bone before it."""
FAN = 6
"""Joints at the end of a chain that fan out from one joint, at least, are a face and have no
bones."""


class BoundSkin(Record):
    """A character where its skin was bound to its joints: in a pose an arm may lie on a belly,
    whose skin it does not move."""

    rig: Rig

    @cached_property
    def points(self) -> Floats:
        """(n, 3) all points in root space."""
        return posed(self.rig, None).points

    @cached_property
    def bones(self) -> Sequence[Bone]:
        """Those between joints apart from each other, and those of joints at the end of a chain."""
        body, places = self.rig.body, joint_places(self.rig.body)
        chains = Tree(body.joints, body.meshes).hanging
        parents = chains.parents
        joined = [k for k, i in enumerate(parents) if i >= 0 and k not in chains.aside]
        found = [
            Bone(parents[k], k, places[parents[k]], along)
            for k in joined
            if (along := places[k] - places[parents[k]]).any()
        ]
        ends = sorted(set(joined) - {parents[k] for k in joined})
        fan = Counter(parents[k] for k in ends)
        for k in ends:
            along = _LAST * (places[k] - places[parents[k]])
            if fan[parents[k]] < FAN and along.any():
                found.append(Bone(k, -1, places[k], along))
        return found


def owned_skin(skin: BoundSkin, control: Control) -> Floats | None:
    """(n,) how much of each point the joints of a joint control own, in [0, 1]; None for other
    controls and where no skin hangs on them.

    A joint without skin has what lies by its bone of the skin below it.
    """
    driven = frozenset(control.drive.joints.tolist())
    joints = frozenset(i for i in driven if skin.rig.body.joints[i].path == control.source)
    if control.kind != "joint" or len(control.drive.channels):
        return None
    return _owned(skin, joints or driven)


@lru_cache(1)
def _owned(skin: BoundSkin, joints: frozenset[int]) -> Floats | None:
    """(n,) how much of each point the joints own; None where no skin hangs on them.  Worked out
    once for all axes of a joint, which follow each other."""
    body, bones = skin.rig.body, skin.bones
    below = frozenset(np.flatnonzero(descendants(body.joints)[[*joints]].any(axis=0)).tolist())
    below -= joints
    has_bone = any(b.joint in joints and b.next in below for b in bones)
    for holders in (joints, *((joints | below,) if has_bone else ())):
        weights = weights_of(body, holders)
        if weights.max(initial=0.0) > OWNS:
            # Skin that it holds by most of what it holds anywhere is wholly its own.
            firm = np.minimum(weights / (MOST * weights.max()), 1.0)
            of = joints if has_bone else holders
            return np.asarray(firm * _by_own_bone(skin, of, weights > OWNS))
    return None


def weights_of(body: Body, joints: frozenset[int]) -> Floats:
    """(n,) weight of `joints` together at every point of the rig."""
    total = np.zeros(int(body.starts[-1]))
    for start, mesh in zip(body.starts, body.meshes, strict=False):
        if mesh.skin is None:
            continue
        table = mesh.skin.by_joint
        held = [joint for joint in sorted(joints) if joint < table.shape[1]]
        if np.diff(table.indptr)[held].any():
            total[start : start + len(mesh.points)] = table[:, held].sum(axis=1)
    return total


def _by_own_bone(skin: BoundSkin, joints: frozenset[int], owned: Flags) -> Floats:
    """(n,) one where a point lies along a bone of `joints`, less at its ends and where a bone above
    or below is nearer."""
    bones, points = skin.bones, skin.points
    factor = np.ones(len(points))
    own = [b for b in bones if b.joint in joints and b.next not in joints]
    if not own:
        return factor
    starts = {bone.start.tobytes() for bone in own}
    below = descendants(skin.rig.body.joints)
    chain = {*np.flatnonzero((below | below.T)[[*joints]].any(axis=0))} - joints
    rivals = [b for b in bones if b.joint in chain and b.start.tobytes() not in starts]
    near, share = _nearest(points[owned], own)
    # Skin modelled at an even share of a bone lies just on a limit: the last bit decides nothing.
    share = steady(share)
    rival, _ = _nearest(points[owned], rivals)
    along = (share >= _SPAN[0]) & (share <= _SPAN[1])
    nearer = np.minimum(1.0, rival / np.maximum(near, 1e-30))
    factor[owned] = np.where(along, 1.0, _BEYOND) * nearer**_OTHERS
    return factor


class Bone(Record):
    """From a joint to the next one."""

    joint: int
    next: int
    """The joint at its end, -1 at the end of a chain."""
    start: Floats
    along: Floats
    """(3,) from the joint to the next one; straight on from the bone before at the end of a
    chain."""


def _nearest(points: Floats, bones: Sequence[Bone]) -> tuple[Floats, Floats]:
    """(p,) distance to the nearest bone, and the share of the way along it."""
    least, share = np.full(len(points), np.inf), np.zeros(len(points))
    for bone in bones:
        at = (points - bone.start) @ bone.along / float(bone.along @ bone.along)
        apart = np.linalg.norm(
            points - bone.start - np.clip(at, 0.0, 1.0)[:, None] * bone.along, axis=1
        )
        nearer = apart < least
        least[nearer], share[nearer] = apart[nearer], at[nearer]
    return least, share


def joint_places(body: Body) -> Floats:
    """(joints, 3) positions in root space at the base pose."""
    world = in_skeleton_space(body.joints, base_locals(body.joints))
    to_root = [body.skeletons[joint.skeleton].to_root for joint in body.joints]
    return np.asarray((world @ np.array(to_root).reshape(-1, 4, 4))[:, 3, :3])
