"""The controls of a rig driven by joints alone: hinges, balls, twists, and fingers as curl and
spread.

Which degrees of freedom matter is read from where the joints are and what skin hangs on them, never
from names.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import chain, pairwise

import numpy as np

from usdrigui.character import Floats, Record
from usdrigui.character.joint_tree import FINGERS, Fan, Tree, fans, level, unit
from usdrigui.character.rotation import rotation_part, rotations
from usdrigui.character.skinning import parents_of, under_parents
from usdrigui.ties import first_largest, towards

_THUMB = 0.85
"""A finger whose cosine to the others is less is a thumb."""
_OPPOSED = 4.0
"""Sines of bends that the side of the thumb counts as: the palms of forty characters, of which a
fifth have fingers bent back a little, are found with 2.3 to 6.8."""
_TIP = 0.3
"""Share of the last bone of a finger that its skin reaches on from there, at least; the skin of the
last joints of people's fingers reaches .7 and more, that of joints at their tips .1."""
_BENT = 0.05
"""Sine of the bend from which a chain defines its own hinge axis."""
_LONG = 0.05
"""Least length of the bones on either side of an elbow or a knee, as a share of the skeleton's
extent."""
_CARRIED = 0.5
"""Reach of the second of the chains that hang on a trunk, at least, as a share of its own
length."""
_ROUND = 0.85
"""Least lever of an axis against the best one where the skin of a joint is a ball."""

BALL = (-30.0, 30.0)
HINGE = (-10.0, 120.0)
CURL = (-10.0, 80.0)
SPREAD = (-20.0, 20.0)
"""Ranges in degrees."""


class Turn(Record):
    """One degree of freedom: joints that turn alike."""

    name: str
    """What follows the joint's name: ``rx``, ``bend``, ``twist``, ``curl``, ``spread``."""
    home: int
    """The joint on whose skin the control is."""
    joints: tuple[int, ...]
    axes: Floats
    """(j, 3) unit axes of the turns, each in its joint's own frame."""
    range: tuple[float, float]
    """Degrees from the base pose."""


def default_turns(tree: Tree) -> tuple[Turn, ...]:
    """The degrees of freedom of every joint that skin follows, in the order of the joints.

    A Skeleton of one joint only says where its mesh is, as exporters make one for a mesh with
    shapes that lacks it.
    """
    skeletons = [tree.joints[joint].skeleton for joint in tree.owners]
    alone = {i for i in tree.owners if skeletons.count(tree.joints[i].skeleton) == 1}
    if alone == tree.owners:
        return ()
    fingers, hinges = {}, _hinges(tree)
    for fan in fans(tree):
        legs = _legs(tree, fan, hinges)
        strands = {finger: own for finger, own in _fingers(tree, fan).items() if finger not in legs}
        fingers.update(strands if len(strands) > 1 else {})
    turns = [*chain.from_iterable(fingers.values())]
    for joint in sorted(tree.bearers.difference(*fingers)):
        turns.extend(_turns(tree, joint, hinges))
    left = (turn for turn in turns if turn.home not in tree.cut_off | alone)
    return tuple(sorted(left, key=lambda turn: (turn.joints[0], turn.name)))


# --- hands ----------------------------------------------------------------------------------------


def _fingers(tree: Tree, fan: Fan) -> dict[tuple[int, ...], list[Turn]]:
    """The turns of the fingers of a hand, by every joint of each with skin: they curl about the
    line across their first joints, towards where they are bent and where the thumb is.

    Legs and strands that hang on the middle of a character have no metacarpals and no thumb; each
    curls about its own hinge, and so on the other side does its mirror image, and so do two fingers
    in no row.
    """
    chains, middle, on_middle = fan.chains, fan.middle, tree.on_plane(fan.joint)
    alone = on_middle or len(chains) < FINGERS
    ends = chains if on_middle else [_without_tip(tree, each)[-FINGERS:] for each in chains]
    straight = fan.directions @ middle
    thumb = (straight < _THUMB) & (straight == straight.min()) & (not alone)
    bases = tree.places[[end[0] for end in ends]]
    row = bases[~thumb] - bases[~thumb].mean(axis=0)
    across = np.linalg.svd(row - np.outer(row @ middle, middle))[2][0]
    bends = np.array([tree.bend(end) for end in ends])
    evidence = bends[~thumb].sum(axis=0)
    if len(chains) > FINGERS:
        # A thumb beside the fingers begins nearest to the wrist.
        first = np.argmin(bases @ middle - tree.size * thumb)
        aside = tree.places[chains[first][-1]] - np.delete(bases, first, axis=0).mean(axis=0)
        evidence += _OPPOSED * np.cross(middle, unit(aside))
    across = towards(across, evidence)
    palm = np.cross(across, middle)
    fingers = {}
    for finger, end, along, bend, apart in zip(
        chains, ends, fan.directions, bends, thumb, strict=True
    ):
        axis = _hinge_axis(tree, end) if alone else level(across, along)
        if apart:
            axis = unit(bend) if np.linalg.norm(bend) > _BENT else level(palm, along)
            ahead = bases[~thumb].mean(axis=0) - tree.places[finger[-1]]
            axis = towards(axis, np.cross(along, ahead))
        curl = np.array([tree.own(joint, axis) for joint in end])
        fingers[finger] = [
            Turn("curl", end[len(end) // 2], end, curl, CURL),
            _single("spread", tree, end[0], np.cross(along, axis), SPREAD),
        ]
    return fingers


def _without_tip(tree: Tree, finger: tuple[int, ...]) -> tuple[int, ...]:
    """A finger without the joint at its tip: no bone, and hardly any of its skin, lies ahead."""
    before, last = (tree.joints[joint].bind[3, :3] for joint in finger[-2:])
    bone = last - before
    ahead = (tree.skin[finger[-1]][0] - last) @ bone
    has_bone = tree.next(finger[-1]) >= 0 or ahead.max() >= _TIP * (bone @ bone)
    return finger if has_bone else finger[:-1]


# --- limbs and what is left -----------------------------------------------------------------------


def _legs(tree: Tree, fan: Fan, hinges: dict[int, Turn]) -> set[tuple[int, ...]]:
    """The chains of a fan that are legs, beside which a tail or a coat hangs: with a knee above a
    foot, and longer than the way up to where chains part.  No finger is longer than its arm."""
    # The fingers of eighteen bodies are .55 of their arms or shorter, the legs of two 1.46 or
    # longer.
    arm = tree.arm(fan.joint)
    return {
        chain
        for chain in fan.chains
        if hinges.keys() & {*chain[:-1]} and tree.max_path(chain[0], chain[0]) > arm
    }


def _hinges(tree: Tree) -> dict[int, Turn]:
    """The turns of elbows and knees, the joints between the two long bones of each limb.

    Where an arm has two long bones only but for the joints that lie in line on them, these twist.
    """
    found = {}
    hands = {fan.joint for fan in fans(tree)}
    for start in range(len(tree.joints)):
        limb = _limb(tree, start, hands)
        bent = [b for a, b in pairwise(limb[:-1]) if np.linalg.norm(tree.bend((a, b))) > _BENT]
        arm = [limb[0], *bent, limb[-1]] if limb and limb[-1] in hands else []
        bones = _long_bones(tree, limb) or _long_bones(tree, arm)
        if not bones:
            continue
        for joint in limb[limb.index(bones[0]) + 1 : limb.index(bones[2])]:
            found[joint] = _single("twist", tree, joint, tree.direction([joint]), BALL)
        found[bones[1]] = _single("bend", tree, bones[1], _hinge_axis(tree, bones[:2]), HINGE)
    return found


def _long_bones(tree: Tree, limb: Sequence[int]) -> Sequence[int]:
    """The three joints of the two long bones of a limb, which are longer than its others; none
    where there are no such."""
    if len(limb) < 3:
        return ()
    bones = np.linalg.norm(np.diff(tree.places[limb], axis=0), axis=1)
    shorter = np.minimum(bones[:-1], bones[1:])
    first = int(np.argmax(shorter))
    length, others = shorter[first], np.delete(bones, [first, first + 1])
    is_limb = length >= _LONG * tree.size and (length > 1.2 * others).all()
    return limb[first : first + 3] if is_limb else ()


def _limb(tree: Tree, start: int, hands: Collection[int]) -> list[int]:
    """The joints from a `start` beside the mirror plane, where chains part, to one of the `hands`
    or the end; else empty.  A chain on which chains hang that reach as far is a trunk, which need
    not lie on a mirror plane.
    """
    parent = tree.parents[start]
    if parent < 0 or tree.on_plane(start) or len(tree.branches(parent)) < 2:
        return []
    limb = [start]
    while len(tree.branches(limb[-1])) <= 1:
        ahead = tree.next(limb[-1])
        if ahead < 0:
            return limb
        limb.append(ahead)
    carried = sorted(tree.max_path(child, limb[-1]) for child in tree.branches(limb[-1]))
    length = np.linalg.norm(tree.places[limb[-1]] - tree.places[start])
    return [] if limb[-1] not in hands and carried[-2] >= _CARRIED * length else limb


def _hinge_axis(tree: Tree, chain: Sequence[int]) -> Floats:
    """(3,) axis about which a chain of joints is bent, or of a straight one: across the mirror
    plane, so that knees bend back; of what points across it, the one that bends elbows ahead."""
    before, bend = tree.direction(chain[:1]), tree.bend(chain)
    if np.linalg.norm(bend) > _BENT:
        return unit(bend)
    lateral = np.eye(3)[tree.mirror[0] if tree.mirror else 0]
    if abs(lateral @ before) < 0.7:
        return level(lateral, before)
    # The taller of the other axes is up; as stages are turned, this way is ahead.
    up = np.eye(3)[first_largest(np.ptp(tree.places, axis=0) * (1.0 - lateral))]
    return unit(np.cross(before, np.cross(lateral, up)))


def _turns(tree: Tree, joint: int, hinges: dict[int, Turn]) -> list[Turn]:
    """The degrees of freedom of a joint that belongs to no finger."""
    if joint in hinges:
        return [hinges[joint]]
    if joint in tree.twists:
        return [_single("twist", tree, joint, tree.direction([tree.twists[joint]]), BALL)]
    is_inner = any(tree.depth[child] for child in tree.children[joint])
    axes = range(3) if is_inner or _ends_trunk(tree, joint) else _levers(tree, joint)
    return [Turn(f"r{'xyz'[axis]}", joint, (joint,), np.eye(3)[[axis]], BALL) for axis in axes]


def _ends_trunk(tree: Tree, joint: int) -> bool:
    """Whether a joint at the end of a chain is the last of a spine, as a head is, which nods, tilts
    and turns: the joints beside it are chains off the mirror plane."""
    trunk = tree.parents[joint]
    beside = (c for c in tree.children[trunk] if tree.depth[c] and c != joint)
    limbs = all(tree.depth[c] > 1 and not tree.on_plane(c) for c in beside)
    return trunk >= 0 and tree.on_plane(joint) and limbs


def _single(name: str, tree: Tree, joint: int, axis: Floats, span: tuple[float, float]) -> Turn:
    return Turn(name, joint, (joint,), tree.own(joint, axis)[None], span)


def _levers(tree: Tree, joint: int) -> list[int]:
    """The axes of a joint at the end of a chain about which its skin turns furthest, two at
    most."""
    points, weights = tree.skin[joint]
    place = tree.joints[joint].bind
    bind = rotation_part(place)
    crosses = np.cross((points - place[3, :3])[None], bind[:, None])
    levers = (weights * np.linalg.norm(crosses, axis=2)).max(axis=1, initial=0.0).tolist()
    axes = [axis for axis in range(3) if axis != _roll(tree, joint, bind, levers)]
    if len(axes) == 2:  # Both of those across a bone matter.
        return axes
    ranked = sorted(axes, key=lambda axis: (-round(levers[axis], 9), axis))[:2]
    return sorted(ranked)


def _roll(tree: Tree, joint: int, bind: Floats, levers: list[float]) -> int:
    """The axis along which the bone of a strand or an eye lies, about which nobody turns it; -1 for
    another joint.

    A joint without skin may end the bone.  A ball that lies wholly to one side of the mirror plane
    is an eye; it looks across the neck and the line between the eyes, or, on a head without a neck,
    away from the skin of the head.
    """
    bone = np.abs(tree.own(joint, tree.direction([joint])))
    if bone.any() and not tree.on_plane(joint):
        return first_largest(bone)
    head = tree.parents[joint]
    if tree.mirror is None or min(levers) < _ROUND * max(levers) or head not in tree.owners:
        return -1
    across, aside = tree.mirror
    if abs(float(aside[joint])) <= max(levers):
        return -1
    neck = tree.places[head] - tree.places[max(tree.parents[head], 0)]
    out = np.cross(neck, np.eye(3)[across])
    if not out.any():
        points, weights = tree.skin[head]
        out = tree.places[joint] - weights @ points / weights.sum()
        out[across] = 0.0
    return first_largest(np.abs(bind @ out))


def posed_locals(tree: Tree, turn: Turn, degrees: Floats) -> Floats:
    """(k, joints, 4, 4) local transforms with `turn` at each of `degrees` (k,)."""
    return np.array([_turned(tree, turn, value) for value in degrees.tolist()])


def _turned(tree: Tree, turn: Turn, degrees: float) -> Floats:
    """(joints, 4, 4) local transforms of all joints, which go along with those that turn."""
    world = tree.world.copy()
    for joint in tree.from_the_ends()[::-1]:
        parent = tree.parents[joint]
        before, after = (tree.world[parent], world[parent]) if parent >= 0 else (np.eye(4),) * 2
        spin = np.eye(4)
        if joint in turn.joints:
            spin[:3, :3] = rotations(np.radians(degrees) * turn.axes[turn.joints.index(joint)])
        world[joint] = spin @ tree.world[joint] @ np.linalg.inv(before) @ after
    return under_parents(world, parents_of(tree.joints))
