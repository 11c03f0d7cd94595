"""The skin that a joint owns: where the control of a joint stands.

The displacement of a joint grows with the distance from it, so its largest displacement lies at the
end of the chain.  The control stands instead where the joint has the most weight, between the joint
and the next one.
"""

from __future__ import annotations

import numpy as np

from usdrigui.model import Control, Flags, Floats, Rig

_SPAN = (0.2, 0.8)
"""Share of the way from a joint to the next one between which its control stands."""
_BEYOND = 0.5
"""Factor on the weight of skin beyond that, and of skin nearer to another bone of the same
chain."""
_NOTHING = 1e-3
"""Weight below which a point does not count as skin of a joint."""


def owned_skin(rig: Rig, control: Control, points: Floats) -> Floats | None:
    """(n,) how much of each point the joints of a joint control own, in [0, 1]; None for other
    controls and where no skin hangs on them.

    `points` (n, 3) are all points in root space.  A joint without skin has that of the joints next
    below it.
    """
    driven = set(control.drive.joints.tolist())
    joints = {i for i in driven if rig.joints[i].path == control.source} or driven
    if control.kind != "joint" or not joints or len(control.drive.channels):
        return None
    while joints:
        weights = _weights(rig, joints)
        if weights.max(initial=0.0) > _NOTHING:
            return weights * _by_own_bone(rig, joints, points, weights > _NOTHING)
        joints = {i for i, joint in enumerate(rig.joints) if joint.parent in joints}
    return None


def _weights(rig: Rig, joints: set[int]) -> Floats:
    """(n,) weight of `joints` together at every point of the rig."""
    total = np.zeros(int(rig.starts[-1]))
    for start, mesh in zip(rig.starts, rig.meshes, strict=False):
        if mesh.skin is None:
            continue
        local, weights, present, starts = mesh.skin.by_joint
        for row in np.flatnonzero(np.isin(present, list(joints))):
            part = slice(starts[row], starts[row + 1])
            total[start + local[part]] += weights[part]
    return total


def _by_own_bone(rig: Rig, joints: set[int], points: Floats, owned: Flags) -> Floats:
    """(n,) one where a point lies along a bone of `joints`, less at its ends and where a bone above
    or below is nearer.

    A joint at the end of a chain, or one of several that fan out from one, has no bone to lie
    along.
    """
    factor = np.ones(len(points))
    places = joint_places(rig)
    bones = [
        (i, k)
        for k, each in enumerate(rig.joints)
        if (i := each.parent) >= 0 and (places[i] != places[k]).any()
    ]
    own = [bone for bone in bones if bone[0] in joints and bone[1] not in joints]
    if not own:
        return factor
    above, below = (
        _above(rig, joints),
        {k for k in range(len(rig.joints)) if joints & _above(rig, {k})},
    )
    rivals = [bone for bone in bones if bone[0] in (above | below) - joints]
    near, share = _nearest(points[owned], places, own)
    rival, _ = _nearest(points[owned], places, rivals)
    along = (share >= _SPAN[0]) & (share <= _SPAN[1])
    factor[owned] = np.where(along, 1.0, _BEYOND) * np.where(near <= rival, 1.0, _BEYOND)
    return factor


def _above(rig: Rig, joints: set[int]) -> set[int]:
    """The joints from the parents of `joints` up to the root."""
    found: set[int] = set()
    for joint in joints:
        while (joint := rig.joints[joint].parent) >= 0:
            found.add(joint)
    return found


def _nearest(points: Floats, places: Floats, bones: list[tuple[int, int]]) -> tuple[Floats, Floats]:
    """(p,) distance to the nearest bone, and the share of the way along it."""
    least, share = np.full(len(points), np.inf), np.zeros(len(points))
    for start, end in bones:
        along = places[end] - places[start]
        at = (points - places[start]) @ along / float(along @ along)
        apart = np.linalg.norm(
            points - places[start] - np.clip(at, 0.0, 1.0)[:, None] * along, axis=1
        )
        nearer = apart < least
        least[nearer], share[nearer] = apart[nearer], at[nearer]
    return least, share


def joint_places(rig: Rig) -> Floats:
    """(joints, 3) positions in root space at the base pose."""
    world: list[Floats] = []
    for joint in rig.joints:
        world.append(joint.base @ world[joint.parent] if joint.parent >= 0 else joint.base)
    to_root = [rig.skeletons[joint.skeleton].to_root for joint in rig.joints]
    return np.array([(m @ t)[3, :3] for m, t in zip(world, to_root, strict=True)]).reshape(-1, 3)
