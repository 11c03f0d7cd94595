"""The controls of a rig driven by joints alone: hinges, balls, twists, and fingers as curl and spread.

Which degrees of freedom matter is read from where the joints are and what skin hangs on them, never from names.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from usdrigui.model import Floats, Joint, RigMesh
from usdrigui.rotation import rotation_part, rotations

_OWNS = 1e-3
"""Largest weight below which no skin hangs on a joint."""
_FINGERS = 3
"""Chains of a hand, at least; and joints of a finger that curl, at most."""
_PARALLEL = 0.6
"""Least cosine of a finger to the mean direction of the fingers; a thumb stays ahead."""
_THUMB = 0.85
"""A finger whose cosine to the others is less is a thumb."""
_BENT = 0.05
"""Sine of the bend from which a chain tells its own hinge axis."""
_ON_PLANE = 0.02
"""Share of the skeleton's size within which a joint lies on the mirror plane."""
_ALONG = 0.1
"""Share of a bone's length from it within which a joint lies on the bone."""
_MATTERS = 0.5
"""Least lever of an axis against the best axis of a joint at the end of a chain."""
_AIM = 0.95
"""Least cosine of the axis along which a joint of a flat skeleton looks to the next joint."""
_AHEAD = 0.5
"""The same for a joint that no other looks at so closely."""
_STRAIGHT = 8
"""Power of that cosine by which a distance is divided: the next joint lies straight ahead rather than near."""

BALL = (-30.0, 30.0)
HINGE = (-10.0, 120.0)
CURL = (-10.0, 80.0)
SPREAD = (-20.0, 20.0)
"""Ranges in degrees."""


@dataclass(frozen=True, eq=False)
class Turn:
    """One degree of freedom: joints that turn alike."""

    name: str
    """What follows the joint's name: ``rx``, ``bend``, ``twist``, ``curl``, ``spread``."""
    home: int
    """The joint on whose skin the control stands."""
    joints: tuple[int, ...]
    axes: Floats
    """(j, 3) unit axes of the turns, each in its joint's own frame."""
    range: tuple[float, float]
    """Degrees from the base pose."""


def default_turns(tree: Tree) -> tuple[Turn, ...]:
    """The degrees of freedom of every joint on which skin hangs, in the order of the joints."""
    if len(tree.owners) < 2:
        return ()
    fingers = [finger for hand in _hands(tree) for finger in hand]
    taken = {joint for finger in fingers for joint in finger.chain}
    hinges = _hinges(tree)
    turns = [turn for finger in fingers for turn in finger.turns(tree)]
    for joint in sorted(tree.owners - taken):
        turns.extend(_turns(tree, joint, hinges))
    return tuple(sorted(turns, key=lambda turn: (turn.joints[0], turn.name)))


@dataclass(frozen=True, eq=False)
class Tree:
    """Joints as they hang together, at the base pose in the space of their Skeleton."""

    joints: tuple[Joint, ...]
    meshes: tuple[RigMesh, ...]

    @cached_property
    def world(self) -> Floats:
        """(joints, 4, 4)"""
        found: list[Floats] = []
        for joint in self.joints:
            found.append(joint.base @ found[joint.parent] if joint.parent >= 0 else joint.base)
        return np.array(found).reshape(-1, 4, 4)

    @cached_property
    def places(self) -> Floats:
        """(joints, 3)"""
        return np.asarray(self.world[:, 3, :3])

    @cached_property
    def frames(self) -> Floats:
        """(joints, 3, 3) rows are the own axes of each joint."""
        return rotation_part(self.world)

    @property
    def flat(self) -> bool:
        """Whether every joint is a root, as authored."""
        return all(joint.parent < 0 for joint in self.joints)

    @cached_property
    def parents(self) -> tuple[int, ...]:
        """As authored; where all joints of a flat skeleton are roots, as they look at each other."""
        authored = tuple(joint.parent for joint in self.joints)
        return authored if not self.flat else _looking(self.places, self.frames)

    @cached_property
    def children(self) -> tuple[tuple[int, ...], ...]:
        """Of each joint those below it, by `parents`."""
        found: list[list[int]] = [[] for _ in self.joints]
        for joint, parent in enumerate(self.parents):
            if parent >= 0:
                found[parent].append(joint)
        return tuple(tuple(each) for each in found)

    @cached_property
    def skin(self) -> tuple[tuple[Floats, Floats], ...]:
        """Of each joint the points (p, 3) on which it acts, bound, and its weights (p,)."""
        parts: list[list[tuple[Floats, Floats]]] = [[] for _ in self.joints]
        for mesh in self.meshes:
            if mesh.skin is None:
                continue
            bound = mesh.points @ mesh.skin.geom_bind[:3, :3] + mesh.skin.geom_bind[3, :3]
            points, weights, present, starts = mesh.skin.by_joint
            for row, joint in enumerate(present.tolist()):
                part = slice(starts[row], starts[row + 1])
                parts[joint].append((bound[points[part]], weights[part]))
        empty = (np.zeros((0, 3)), np.zeros(0))
        return tuple(
            (np.concatenate([p for p, _ in each]), np.concatenate([w for _, w in each])) if each else empty
            for each in parts
        )

    @cached_property
    def owners(self) -> frozenset[int]:
        """The joints on which skin hangs."""
        return frozenset(i for i, (_, weights) in enumerate(self.skin) if weights.max(initial=0.0) > _OWNS)

    @cached_property
    def depth(self) -> tuple[int, ...]:
        """Joints with skin in the longest chain from each joint down, itself included."""
        found = [0] * len(self.joints)
        for joint in self.from_the_ends():
            below = max((found[child] for child in self.children[joint]), default=0)
            found[joint] = below + (joint in self.owners)
        return tuple(found)

    def from_the_ends(self) -> list[int]:
        """Every joint after its children."""
        order = [joint for joint, parent in enumerate(self.parents) if parent < 0]
        for joint in order:
            order.extend(self.children[joint])
        return order[::-1]

    def next(self, joint: int) -> int:
        """The child that carries the chain on, or -1 at its end; a child without skin ends the last bone."""
        children = self.children[joint]
        length = {child: float(np.linalg.norm(self.places[child] - self.places[joint])) for child in children}
        return max(children, key=lambda child: (self.depth[child], length[child], -child), default=-1)

    def chain(self, joint: int) -> tuple[int, ...]:
        """The joints with skin from `joint` down if they are one chain, with no more than single joints beside it."""
        found: list[int] = []
        while joint >= 0 and self.depth[joint]:
            found.append(joint)
            ahead = self.next(joint)
            if any(self.depth[child] > 1 for child in self.children[joint] if child != ahead):
                return ()
            joint = ahead
        return tuple(found)

    def direction(self, chain: Sequence[int]) -> Floats:
        """(3,) unit vector along a chain."""
        end = self.next(chain[-1])
        return _unit(self.places[end if end >= 0 else chain[-1]] - self.places[chain[0]])

    def bend(self, chain: Sequence[int]) -> Floats:
        """(3,) sum of the cross products of successive unit bones: the axis about which a chain is bent already."""
        ends = [*chain, *([self.next(chain[-1])] if self.next(chain[-1]) >= 0 else [])]
        bones = [_unit(self.places[b] - self.places[a]) for a, b in pairwise(ends)]
        crosses = [np.cross(a, b) for a, b in pairwise(bones)]
        return np.sum(crosses, axis=0) if crosses else np.zeros(3)

    def own(self, joint: int, axis: Floats) -> Floats:
        """(3,) an axis in the frame of a joint."""
        return np.asarray(self.frames[joint] @ axis)

    @cached_property
    def mirror(self) -> tuple[int, float] | None:
        """Axis and offset of the plane that mirrors the joints; None where none does."""
        size = float(np.ptp(self.places, axis=0).max()) or 1.0
        for axis in range(3):
            middle = float(self.places[list(self.owners)][:, axis].mean())
            image = self.places.copy()
            image[:, axis] = 2.0 * middle - image[:, axis]
            apart = np.linalg.norm(image[:, None] - self.places[None], axis=2).min(axis=1)
            off = np.abs(self.places[:, axis] - middle) > _ON_PLANE * size
            if off.sum() >= 0.3 * len(off) and np.mean(apart < _ON_PLANE * size) > 0.8:
                return axis, middle
        return None


# --- hands -------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class _Finger:
    chain: tuple[int, ...]
    """Every joint with skin, the metacarpal included."""
    curl: Floats
    spread: Floats
    """(3,) axes."""

    def turns(self, tree: Tree) -> list[Turn]:
        curled = self.chain[-_FINGERS:]
        curl = np.array([tree.own(joint, self.curl) for joint in curled])
        spread = tree.own(curled[0], self.spread)[None]
        home = curled[len(curled) // 2]
        return [Turn("curl", home, curled, curl, CURL), Turn("spread", curled[0], curled[:1], spread, SPREAD)]


def _hands(tree: Tree) -> list[list[_Finger]]:
    """The fingers of every joint from which at least three chains run side by side."""
    found = []
    for joint in range(len(tree.joints)):
        chains = [chain for child in tree.children[joint] if len(chain := tree.chain(child)) >= 2]
        if len(chains) < _FINGERS:
            continue
        directions = np.array([tree.direction(chain[-_FINGERS:]) for chain in chains])
        middle = _unit(np.median(directions, axis=0))
        ahead = directions @ middle
        if (ahead >= _PARALLEL).sum() >= _FINGERS:
            kept = [i for i in range(len(chains)) if ahead[i] > 0.0]
            found.append(_fingers(tree, joint, [chains[i] for i in kept], directions[kept], middle))
    return found


def _fingers(tree: Tree, hand: int, chains: list[tuple[int, ...]], directions: Floats, middle: Floats) -> list[_Finger]:
    """The fingers of a hand: they curl about the line across their first joints, towards where they are bent."""
    thumb = directions @ middle < _THUMB
    thumb &= directions @ middle == (directions @ middle).min()
    bases = np.array([tree.places[chain[-_FINGERS:][0]] for chain in chains])
    row = bases[~thumb] - bases[~thumb].mean(axis=0)
    across = np.linalg.svd(row - np.outer(row @ middle, middle))[2][0]
    bends = np.array([tree.bend(chain[-_FINGERS:]) for chain in chains])
    evidence = float((bends[~thumb] @ across).sum())
    palm = np.cross(across, middle)
    if abs(evidence) < _BENT and thumb.any():
        evidence = float((tree.places[chains[int(np.argmax(thumb))][-1]] - tree.places[hand]) @ palm)
    across = across if evidence >= 0.0 else -across
    palm = np.cross(across, middle)
    fingers = []
    for chain, along, bend, apart in zip(chains, directions, bends, thumb, strict=True):
        axis = _level(across, along)
        if apart:
            axis = _unit(bend) if np.linalg.norm(bend) > _BENT else _level(palm, along)
            towards = bases[~thumb].mean(axis=0) - tree.places[chain[-1]]
            axis = axis if np.cross(axis, along) @ towards >= 0.0 else -axis
        fingers.append(_Finger(chain, axis, np.cross(along, axis)))
    return fingers


# --- limbs and what is left --------------------------------------------------------------------------


def _hinges(tree: Tree) -> dict[int, Floats]:
    """Elbows and knees, with their axes: the joint between the two long bones of each limb."""
    found = {}
    for start in range(len(tree.joints)):
        limb = _limb(tree, start)
        bones = np.array([np.linalg.norm(tree.places[b] - tree.places[a]) for a, b in pairwise(limb)])
        if len(bones) < 2:
            continue
        least = np.minimum(bones[:-1], bones[1:])
        at = int(np.argmax(least))
        joint, others = limb[at + 1], np.delete(bones, [at, at + 1])
        if joint in tree.owners and (least[at] > 1.2 * others).all():
            found[joint] = _hinge_axis(tree, limb[at : at + 3])
    return found


def _limb(tree: Tree, start: int) -> list[int]:
    """The joints from a `start` beside the mirror plane, where chains part, to the hand or the end; else empty."""
    parent = tree.parents[start]
    if parent < 0 or _on_plane(tree, start) or sum(tree.depth[c] > 1 for c in tree.children[parent]) < 2:
        return []
    limb = [start]
    while sum(tree.depth[child] > 1 for child in tree.children[limb[-1]]) <= 1:
        ahead = tree.next(limb[-1])
        if ahead < 0:
            break
        limb.append(ahead)
    return limb


def _on_plane(tree: Tree, joint: int) -> bool:
    if tree.mirror is None:
        return False
    axis, middle = tree.mirror
    return abs(float(tree.places[joint, axis]) - middle) < _ON_PLANE * float(np.ptp(tree.places, axis=0).max())


def _hinge_axis(tree: Tree, joints: Sequence[int]) -> Floats:
    """(3,) axis of the middle of three joints: that of its bend, or of a straight limb the one across the mirror plane
    and the limb."""
    a, b, c = (tree.places[joint] for joint in joints)
    before, after = _unit(b - a), _unit(c - b)
    bend = np.cross(before, after)
    if np.linalg.norm(bend) > _BENT:
        return _unit(bend)
    lateral = np.eye(3)[tree.mirror[0] if tree.mirror else 0]
    return _level(lateral, before) if abs(lateral @ before) < 0.7 else _level(np.roll(lateral, 1), before)


def _turns(tree: Tree, joint: int, hinges: dict[int, Floats]) -> list[Turn]:
    """The degrees of freedom of a joint that belongs to no finger."""
    if joint in hinges:
        return [_single("bend", tree, joint, hinges[joint], HINGE)]
    bone = _bone_below(tree, joint)
    if bone is not None:
        return [_single("twist", tree, joint, bone, BALL)]
    axes = range(3) if any(tree.depth[child] for child in tree.children[joint]) else _levers(tree, joint)
    return [Turn(f"r{'xyz'[axis]}", joint, (joint,), np.eye(3)[[axis]], BALL) for axis in axes]


def _single(name: str, tree: Tree, joint: int, axis: Floats, span: tuple[float, float]) -> Turn:
    return Turn(name, joint, (joint,), tree.own(joint, axis)[None], span)


def _bone_below(tree: Tree, joint: int) -> Floats | None:
    """(3,) direction of the parent's bone on which a joint without joints below lies, as twist joints do."""
    parent = tree.parents[joint]
    ahead = tree.next(parent) if parent >= 0 else -1
    if ahead in (-1, joint) or tree.depth[joint] > 1 or tree.depth[ahead] < 2:
        return None
    bone, way = tree.places[ahead] - tree.places[parent], tree.places[joint] - tree.places[parent]
    length = float(np.linalg.norm(bone))
    if length <= 0.0 or not 0.0 <= way @ bone <= length**2:
        return None
    return bone / length if np.linalg.norm(np.cross(way, bone)) <= _ALONG * length**2 else None


def _levers(tree: Tree, joint: int) -> list[int]:
    """The axes of a joint at the end of a chain about which its skin turns furthest, two at most."""
    points, weights = tree.skin[joint]
    arms = points - np.array(tree.joints[joint].bind)[3, :3]
    bind = rotation_part(np.array(tree.joints[joint].bind)[None])[0]
    levers = [float((weights * np.linalg.norm(np.cross(arms, axis), axis=1)).max(initial=0.0)) for axis in bind]
    ranked = sorted(range(3), key=lambda axis: (-round(levers[axis], 9), axis))[:2]
    return sorted(axis for axis in ranked if levers[axis] >= _MATTERS * max(levers))


# --- flat skeletons ----------------------------------------------------------------------------------


def _looking(places: Floats, frames: Floats) -> tuple[int, ...]:
    """A parent for each joint of a flat skeleton, or -1: the nearest one that looks at it along the axis by which most
    joints of the skeleton look at another; what is left hangs on a root that has it ahead."""
    way = places[None] - places[:, None]
    apart = np.linalg.norm(way, axis=2)
    apart[apart == 0.0] = np.inf
    best: list[int] = [-1] * len(places)
    for aim in (sign * frames[:, row] for row in range(3) for sign in (1.0, -1.0)):
        ahead = np.einsum("ijk,ik->ij", way, aim)
        cosine = np.maximum(ahead / apart, 1e-3)
        reach = apart / cosine**_STRAIGHT
        parents = _linked([-1] * len(places), np.where(cosine >= _AIM, reach, np.inf), places)
        if sum(parent >= 0 for parent in parents) > sum(parent >= 0 for parent in best):
            best = _linked(parents, np.where(cosine >= _AHEAD, reach, np.inf), places, roots_only=True)
    return tuple(best)


def _linked(parents: list[int], reach: Floats, places: Floats, *, roots_only: bool = False) -> list[int]:
    """The parents with those added that see a joint without one, at distances `reach` (joints, joints): the nearest
    pairs first, no joint below itself; `roots_only` joints that have no parent either."""
    parents = list(parents)
    if not roots_only:
        reach = np.where(reach <= reach.min(axis=1, keepdims=True), reach, np.inf)
    for pair in np.argsort(reach, axis=None, kind="stable"):
        joint, target = divmod(int(pair), len(places))
        if not np.isfinite(reach[joint, target]):
            break
        above, at = {joint}, joint
        while (at := parents[at]) >= 0:
            above.add(at)
        if parents[target] < 0 and target not in above and not (roots_only and parents[joint] >= 0):
            parents[target] = joint
    return parents


def posed_locals(tree: Tree, turn: Turn, degrees: Floats) -> Floats:
    """(k, joints, 4, 4) local transforms with `turn` at each of `degrees` (k,)."""
    found = []
    for value in degrees:
        own = tree.world.copy()
        turned: dict[int, Floats] = {}
        for joint in tree.from_the_ends()[::-1]:
            parent = tree.parents[joint]
            local = tree.world[joint] @ np.linalg.inv(tree.world[parent]) if parent >= 0 else tree.world[joint]
            if joint in turn.joints:
                spin = np.eye(4)
                spin[:3, :3] = rotations(np.radians(value) * turn.axes[turn.joints.index(joint)])
                local = spin @ local
            own[joint] = turned[joint] = local @ turned[parent] if parent >= 0 else local
        real = [joint.parent for joint in tree.joints]
        found.append([own[i] @ np.linalg.inv(own[p]) if p >= 0 else own[i] for i, p in enumerate(real)])
    return np.array(found)


def _unit(vector: Floats) -> Floats:
    return np.asarray(vector / max(float(np.linalg.norm(vector)), 1e-30))


def _level(axis: Floats, along: Floats) -> Floats:
    """(3,) unit vector of `axis` made perpendicular to `along`."""
    return _unit(axis - (axis @ along) * along)
