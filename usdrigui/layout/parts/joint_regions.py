"""Which joints and which skin are the face, the eyes, the hands, the feet and the body.

A head is known by its joint's name; without one by the many joints without joints below that hang
on it (a face driven by joints), or by the skin that the blend shapes move.  Fans of chains that
carry on a limb are fingers and toes.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats, Indices, Record, Rig, RigMesh
from usdrigui.character.joint_tree import Fan, Tree, fans, unit
from usdrigui.conventions import words
from usdrigui.layout.motion.owned_skin import FAN
from usdrigui.layout.parts.own_pieces import is_eye, pieces_of
from usdrigui.layout.shares import NEARLY_ALL
from usdrigui.model import Trajectories

FACE, EYES, HANDS, FEET, BODY = "face", "eyes", "hands", "feet", "body"
INTERIOR = "interior"
"""Tongue, teeth and gums."""
HEAD = "head"
"""Joints that hang on a head whose face other controls move, or none: brows, ears, hair."""
OF_SIDES = (HANDS, FEET)
"""Parts that lie apart from each other, left and right, and face any way."""
_FLAT = (FACE, EYES, HEAD, INTERIOR, *OF_SIDES)
"""Parts that are looked at from one side, each hand from its own: their elements are kept apart on
its screen."""

_HEAD = frozenset({"head", "頭"})
LIMB = 3
"""Joints with skin of an arm or a leg; two such, beside the spine, hands and feet, make a body. As
many outside of the head are the neck and shoulders of a bust."""
_LOW = 0.2
"""Share of a character's height below which chains side by side are toes."""


class JointRegions(Record):
    """Which part each joint belongs to, and which part its skin belongs to."""

    of_joint: tuple[str, ...]
    """(joints,) A head and a wrist turn all that hangs on them: they are joints of the
    body, where there is one."""
    of_skin: tuple[str, ...]
    """(joints,) The skin of a head is of the face, that of a wrist of the hand."""
    drive_face: bool
    """Whether as many joints end on one of the head as drive a face; ears and hair are fewer, and
    chains."""


def joint_regions(rig: Rig, found: Trajectories) -> JointRegions | None:
    """The regions of a rig's joints; None for a rig that is not skinned to several joints."""
    body = rig.body
    tree = Tree(body.joints, body.meshes, bound=True)
    if len(tree.owners) < 2:
        return None
    ends_on = [
        sum(tree.depth[child] == 1 for child in children) * (parent >= 0)
        for children, parent in zip(tree.children, tree.parents, strict=True)
    ]
    heads = _heads(rig, tree, found, ends_on)
    spine = {*tree.above(min(heads))} if heads else set[int]()
    on_head = tree.below(heads)
    of_joint, of_skin = [BODY] * len(body.joints), [BODY] * len(body.joints)
    ends = [
        fan for fan in fans(tree) if _carries_on(tree, fan) and fan.joint not in spine | on_head
    ]
    for fan in ends:
        fingers = tree.below([chain[0] for chain in fan.chains])
        in_root = body.skeletons[body.joints[fan.joint].skeleton].to_root[:3, :3]
        name = _end(in_root @ rig.up, tree, fan.joint, fingers, spine)
        for joint in fingers:
            of_joint[joint] = of_skin[joint] = name
        of_skin[fan.joint] = name
    for joint in on_head:
        of_joint[joint] = BODY if joint in heads else FACE
        of_skin[joint] = FACE
    pieces = pieces_of(body, tree, found.surface.places)
    eyes = {joint for joint in on_head - heads if is_eye(pieces, joint)}
    for joint in tree.below(eyes):
        of_joint[joint] = of_skin[joint] = EYES
    in_body = {i for i in tree.owners if of_skin[i] == BODY}
    # Limbs and necks are chains: joints that all end, each by itself, are of a face.
    chained = {i for i in in_body if tree.depth[i] > 1 or tree.owners.intersection(tree.above(i))}
    # A face and hands are those of a body, however little of it has skin; under a face that blend
    # shapes move, so are a neck and shoulders.
    whole = {FACE, HANDS} <= {of_skin[joint] for joint in tree.owners}
    bust = (
        heads
        and len(chained) >= LIMB
        and any(rig.controls[each.control].kind == "blendShape" for each in found.motions)
    )
    if len(chained - spine) < 2 * LIMB and not (whole or bust):
        # A hand by itself may have an arm; what hangs on no arm is more than hands.
        arms = {joint for fan in ends for joint in (fan.joint, *tree.above(fan.joint))}
        if heads or (ends and arms >= in_body):
            # Without a body a joint is of the part of its skin.
            rest = FACE if heads else of_skin[ends[0].joint]
            of_joint = of_skin = [rest if name in (BODY, EYES) else name for name in of_skin]
    drive_face = any(ends_on[joint] >= FAN for joint in on_head)
    return JointRegions(tuple(of_joint), tuple(of_skin), drive_face)


def owner_of_points(meshes: tuple[RigMesh, ...]) -> Indices:
    """(n,) the joint that holds each point most firmly, -1 for points of meshes that are not
    skinned."""
    parts = []
    for mesh in meshes:
        skin = mesh.skin
        if skin is None:
            parts.append(np.full(len(mesh.points), -1, dtype=np.int64))
            continue
        strongest = np.argmax(skin.weights, axis=1)
        parts.append(skin.joints[np.arange(len(mesh.points)), strongest].astype(np.int64))
    return np.concatenate(parts)


def seen_flat(part: str, space: str, places: Floats) -> tuple[bool, bool]:
    """Whether the elements of a part are measured on the screen of its view, by
    ``candidates.space``, and whether their handles may stand behind each other there.

    So may those of a body, wrists behind fingers.  One that is deeper than wide, as an animal on
    four legs, is measured in space; `places` (n, 3) are the character's points along the right, the
    up and the viewer's direction of that view.
    """
    if space != "part":
        return space == "view", False
    across, _, deep = np.ptp(places, axis=0)
    stands = part == BODY and bool(across >= deep)
    return stands or part in _FLAT, stands


# --- the head -------------------------------------------------------------------------------------


def _heads(rig: Rig, tree: Tree, found: Trajectories, ends_on: list[int]) -> frozenset[int]:
    """The joint of the head, of each skeleton that has one; `ends_on` (joints,) are the joints that
    end on each, but on roots."""
    named = {
        i
        for i, joint in enumerate(rig.body.joints)
        if not _HEAD.isdisjoint(words(joint.name)) and tree.depth[i] > 0
    }
    if named:
        return frozenset(i for i in named if not named & set(tree.above(i)))
    if max(ends_on) >= FAN:
        return frozenset({int(np.argmax(ends_on))})
    return _by_shapes(rig, tree, found)


def _by_shapes(rig: Rig, tree: Tree, found: Trajectories) -> frozenset[int]:
    """The joint furthest down below which nearly all that blend shapes move is; none where that is
    the root."""
    share = np.zeros(len(tree.joints) + 1)
    owners = owner_of_points(rig.body.meshes) % len(share)
    for motion in found.motions:
        if rig.controls[motion.control].kind == "blendShape":
            mass = found.surface.swept(motion)
            share += np.bincount(owners[motion.points], mass / (mass.sum() or 1.0), len(share))
    least = NEARLY_ALL * share.sum()
    for joint in tree.from_the_ends():
        share[tree.parents[joint]] += share[joint]
        if least > 0.0 and tree.parents[joint] >= 0 and share[joint] >= least:
            return frozenset({joint})
    return frozenset()


# --- limbs ----------------------------------------------------------------------------------------


def _carries_on(tree: Tree, fan: Fan) -> bool:
    """Whether the chains run on where the bone before them leads: hair and skirts hang back."""
    before = tree.parents[fan.joint]
    return (
        before < 0 or float(unit(tree.places[fan.joint] - tree.places[before]) @ fan.middle) > 0.0
    )


def _end(up: Floats, tree: Tree, joint: int, fingers: set[int], spine: set[int]) -> str:
    """Feet stand on the ground, on legs with skin: their joint lies at the bottom of a character
    that has more than them.  Hands beside a bust hang as low.  `up` is that of the Skeleton."""
    heights = (tree.places @ up)[sorted(tree.owners)]
    is_low = tree.places[joint] @ up <= heights.min() + _LOW * np.ptp(heights)
    on_leg = tree.owners & {*tree.above(joint)} - spine
    return FEET if is_low and on_leg and len(tree.owners - fingers - {joint}) >= LIMB else HANDS
