"""The joints of a character as one tree: what hangs on what, what skin each owns, and which chains
run side by side.

A tree is built from the positions of the joints and the skin on them, never from names.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Floats, Joint, Record, RigMesh
from usdrigui.character.rotation import rotation_part
from usdrigui.character.skinning import base_locals, bind_poses, bound_points, in_skeleton_space

FINGERS = 3
"""Chains of a fan, at least, but for those shorter than their arm; and joints of a finger that
curl, at most."""
OWNS = 1e-3
"""Largest weight below which no skin hangs on a joint."""
_TRACE = 0.05
"""Largest weight of a joint and of all below it that is a trace: the arms that a bust is cut off
from leave .02 on its edge, one tip of a skirt has .03 and its mirror image nothing; of 51 skinned
characters no other limb holds less than .075 (the end of a finger)."""
_PARALLEL = 0.6
"""Least cosine of a chain to the mean direction of its fan; a thumb stays ahead."""
_SAME = 1e-4
"""Share of the skeleton's size within which two joints have the same place."""
_ON_PLANE = 0.02
"""Share of the skeleton's size within which a joint lies on the mirror plane."""
_AIM = 0.95
"""Least cosine of the axis along which a joint of a flat skeleton looks to the next joint."""
_AHEAD = 0.5
"""The same for a joint that no other looks at so closely."""
_ALONG = 0.1
"""Share of a bone's length from it within which a joint lies on the bone."""
_DETOUR = 1.5
"""Way past a joint without skin, times the straight way to the next one with skin, from which the
joint lies aside."""
_AWAY = 3.0
"""The same for a joint with no skin below it: its distance from the joint above, times that of the
farthest skin of that."""
_STRAIGHT = 8
"""Power of that cosine by which a distance is divided: the next joint lies straight ahead rather
than near."""


class Hanging(Record):
    """The joints below each joint, by the skin."""

    parents: tuple[int, ...]
    """Of each joint the one above on which it hangs, past those that lie aside; -1 for roots."""
    aside: frozenset[int]
    """Joints without skin off the way of their chains, as helpers at the origin are: the bones of a
    character neither end nor begin there."""


def _lies_aside(parent: Floats, place: Floats, ends: Floats, radius: float) -> bool:
    """Whether a joint without skin lies off the way from the one above, whose skin goes as far as
    `radius` (-1 without), to the next ones with skin at `ends` (e, 3)."""
    away = float(np.linalg.norm(place - parent))
    if not len(ends):
        return radius >= 0.0 and away > _AWAY * radius
    past = away + np.linalg.norm(ends - place, axis=1)
    return bool((past > _DETOUR * np.linalg.norm(ends - parent, axis=1)).all())


def _next_with_skin(joints: Sequence[Joint], joint: int, radius: Floats) -> list[int]:
    """The joints with skin below a joint that have none between them and it."""
    found, open_ended = [], {joint}
    for below in range(joint + 1, len(joints)):
        if joints[below].parent in open_ended:
            if radius[below] < 0.0:
                open_ended.add(below)
            else:
                found.append(below)
    return found


def _skin_radius(places: Floats, meshes: Sequence[RigMesh]) -> Floats:
    """(joints,) distance of the farthest skin of each joint, bound; -1 without skin."""
    found = np.full(len(places), -1.0)
    for joint, points, weights in _bound_skin(meshes):
        apart = np.linalg.norm(points[weights > OWNS] - places[joint], axis=1)
        found[joint] = apart.max(initial=found[joint])
    return found


def _bound_skin(meshes: Sequence[RigMesh]) -> Iterator[tuple[int, Floats, Floats]]:
    """Of each mesh, each joint that acts on it, the points (p, 3) on which it does, bound, and its
    weights (p,)."""
    for mesh in meshes:
        skin = mesh.skin
        if skin is None:
            continue
        bound = bound_points(mesh.points, skin)[:, :3]
        table = skin.by_joint
        for joint, (start, end) in enumerate(pairwise(table.indptr.tolist())):
            if end > start:
                yield joint, bound[table.indices[start:end]], table.data[start:end]


class Tree(Record):
    """Joints as they hang together, at the base pose in the space of their Skeleton, or `bound`: in
    a pose a fist no longer leads on from its arm."""

    joints: tuple[Joint, ...]
    meshes: tuple[RigMesh, ...]
    bound: bool = False

    @cached_property
    def world(self) -> Floats:
        """(joints, 4, 4)"""
        if self.bound:
            return bind_poses(self.joints)
        return in_skeleton_space(self.joints, base_locals(self.joints))

    @cached_property
    def places(self) -> Floats:
        """(joints, 3)"""
        return self.world[:, 3, :3]

    @cached_property
    def size(self) -> float:
        """The greatest extent of the joints."""
        return float(np.ptp(self.places, axis=0).max())

    @cached_property
    def frames(self) -> Floats:
        """(joints, 3, 3) rows are the own axes of each joint."""
        return rotation_part(self.world)

    @property
    def flat(self) -> bool:
        """Whether every joint is a root, as authored."""
        return {joint.parent for joint in self.joints} == {-1}

    @cached_property
    def hanging(self) -> Hanging:
        """What hangs on what, as authored, at the bind pose."""
        joints = self.joints
        places = bind_poses(joints)[:, 3, :3]
        radius = _skin_radius(places, self.meshes)
        parents, aside = [joint.parent for joint in joints], set[int]()
        for joint, parent in enumerate(parents):
            if parent in aside:
                parents[joint] = parent = parents[parent]
            if parent >= 0 and radius[joint] < 0.0:
                ends = places[_next_with_skin(joints, joint, radius)]
                if _lies_aside(places[parent], places[joint], ends, float(radius[parent])):
                    aside.add(joint)
        return Hanging(tuple(parents), frozenset(aside))

    @cached_property
    def parents(self) -> tuple[int, ...]:
        """As authored, past what lies aside; where all joints of a flat skeleton are roots, as they
        look at each other."""
        return self.hanging.parents if not self.flat else _looking(self.places, self.frames)

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
        """Of each joint the points (p, 3) on which it acts, bound, and its weights (p,); what a
        stand-in holds is of the joint above."""
        none = np.zeros((0, 3)), np.zeros(0)
        parts = [[none] for _ in self.joints]
        for owner, points, weights in _bound_skin(self.meshes):
            parts[owner].append((points, weights))
        for joint, parent in self._stand_ins(
            frozenset(i for i, each in enumerate(parts) if len(each) > 1)
        ):
            parts[parent] += parts[joint]
            parts[joint] = [none]
        return tuple(
            (np.concatenate([p for p, _ in each]), np.concatenate([w for _, w in each]))
            for each in parts
        )

    def _stand_ins(self, skinned: frozenset[int]) -> list[tuple[int, int]]:
        """Joints at the end of a chain that hold the skin of the joint above, which stands at the
        same place and holds none, and that one: exports have a joint to pose and one to deform."""
        ends = skinned - {joint.parent for joint in self.joints}
        return [
            (i, parent)
            for i in sorted(ends)
            if (parent := self.joints[i].parent) >= 0
            and parent not in skinned
            and np.linalg.norm(self.places[i] - self.places[parent]) <= _SAME * self.size
        ]

    @cached_property
    def most(self) -> Floats:
        """(joints,) largest weight of each."""
        return np.array([weights.max(initial=0.0) for _, weights in self.skin])

    @cached_property
    def owners(self) -> frozenset[int]:
        """The joints on which skin hangs."""
        return frozenset(np.flatnonzero(self.most > OWNS).tolist())

    @cached_property
    def depth(self) -> tuple[int, ...]:
        """Joints with skin in the longest chain from each joint down, itself included."""
        found = [0] * len(self.joints)
        for joint in self.from_the_ends():
            below = max((found[child] for child in self.children[joint]), default=0)
            found[joint] = below + (joint in self.owners)
        return tuple(found)

    @cached_property
    def twists(self) -> dict[int, int]:
        """The joints of chains that lie on the bone to another joint below the same one, and the
        joint at the start of that bone."""
        found = {}
        for joint, children in enumerate(self.children):
            lines = {child: self.below([child]) for child in children}
            for end in children:
                on_it = {c for c in children if c != end and self._on_bone(lines[c], joint, end)}
                # Small joints of a face lie in one line by chance.
                alone = self.depth[end] == 1 and len(on_it) == len(children) - 1
                if self.depth[end] > 1 or alone:
                    found.update({each: joint for child in on_it for each in lines[child]})
        return found

    @cached_property
    def bearers(self) -> frozenset[int]:
        """The joints that skin follows: those on which it hangs, and those whose skin hangs on
        their twist joints."""
        return self.owners | {self.twists[joint] for joint in self.owners & self.twists.keys()}

    @cached_property
    def cut_off(self) -> frozenset[int]:
        """The joints that with all below hold a trace of the skin."""
        return frozenset(i for i in self.owners if self.most[[*self.below([i])]].max() <= _TRACE)

    def above(self, joint: int) -> Iterator[int]:
        """The joints from the parent up to the root."""
        while (joint := self.parents[joint]) >= 0:
            yield joint

    def below(self, joints: Iterable[int]) -> set[int]:
        """The joints and all that hangs on them."""
        found, pending = set[int](), list(joints)
        while pending:
            joint = pending.pop()
            found.add(joint)
            pending.extend(self.children[joint])
        return found

    def branches(self, joint: int) -> list[int]:
        """The joints below on which chains hang, twist joints left out."""
        return [
            child
            for child in self.children[joint]
            if self.depth[child] > 1 and child not in self.twists
        ]

    def _on_bone(self, joints: Collection[int], start: int, end: int) -> bool:
        """Whether joints lie on the bone between two others, before its end."""
        bone = self.places[end] - self.places[start]
        ways = self.places[list(joints)] - self.places[start]
        length = float(np.linalg.norm(bone))
        along, beside = ways @ bone, np.linalg.norm(np.cross(ways, bone), axis=1)
        return bool(np.all((along >= 0.0) & (along < length**2) & (beside <= _ALONG * length**2)))

    def from_the_ends(self) -> list[int]:
        """Every joint after its children."""
        order = [joint for joint, parent in enumerate(self.parents) if parent < 0]
        for joint in order:
            order.extend(self.children[joint])
        return order[::-1]

    def next(self, joint: int) -> int:
        """The child that carries the chain on, or -1 at its end; a child without skin ends the last
        bone."""
        children = [c for c in self.children[joint] if c not in self.hanging.aside]
        lengths = np.linalg.norm(self.places[children] - self.places[joint], axis=1).tolist()
        ranks = [(self.depth[c], length, -c) for c, length in zip(children, lengths, strict=True)]
        return -max(ranks)[2] if ranks else -1

    def chain(self, joint: int) -> tuple[int, ...]:
        """The joints with skin from `joint` down if they are one chain, with no more than single
        joints beside it; several in the middle of a character are the ears and jaw at the end of
        its neck."""
        found: list[int] = []
        while joint >= 0 and self.depth[joint]:
            found.append(joint)
            ahead = self.next(joint)
            beside = [self.depth[child] for child in self.children[joint] if child != ahead]
            if max(beside, default=0) > 1 or (sum(beside) > 1 and self.on_plane(joint)):
                return ()
            joint = ahead
        return tuple(found)

    def max_path(self, joint: int, start: int) -> float:
        """Greatest distance from the joint `start` to `joint` and what hangs on it."""
        ways = self.places[[*(self.below([joint]) - self.hanging.aside)]] - self.places[start]
        return float(np.linalg.norm(ways, axis=1).max())

    def arm(self, joint: int) -> float:
        """Length of the arm that carries a joint: its distance from the nearest joint above, or
        itself, where more than single chains part; inf without such a joint, as of a hand by
        itself."""
        parting = [
            each
            for each in (joint, *self.above(joint))
            if len(out := self.branches(each)) > max(1, sum(map(bool, map(self.chain, out))))
        ]
        ways = self.places[parting] - self.places[joint]
        return float(np.linalg.norm(ways, axis=1).min(initial=np.inf))

    def direction(self, chain: Sequence[int]) -> Floats:
        """(3,) unit vector along a chain."""
        end = self.next(chain[-1])
        return unit(self.places[end if end >= 0 else chain[-1]] - self.places[chain[0]])

    def bend(self, chain: Sequence[int]) -> Floats:
        """(3,) sum of the cross products of successive unit bones: the axis about which a chain is
        bent already."""
        end = self.next(chain[-1])
        ends = [*chain, end] if end >= 0 else chain
        bones = [unit(self.places[b] - self.places[a]) for a, b in pairwise(ends)]
        crosses = [np.cross(a, b) for a, b in pairwise(bones)]
        return np.sum(crosses, axis=0) if crosses else np.zeros(3)

    def own(self, joint: int, axis: Floats) -> Floats:
        """(3,) an axis in the frame of a joint."""
        return np.asarray(self.frames[joint] @ axis)

    @cached_property
    def mirror(self) -> tuple[int, Floats] | None:
        """Axis across the plane that mirrors the joints, and how far (joints,) they are to one side
        of it, at the bind pose where the base pose has none; None where neither has."""
        near = _ON_PLANE * self.size
        for places in (self.places, bind_poses(self.joints)[:, 3, :3]):
            for axis in range(3):
                aside = places[:, axis] - np.median(places[list(self.owners)][:, axis])
                image = places.copy()
                image[:, axis] -= 2.0 * aside
                apart = cdist(image, places).min(axis=1)
                off = np.abs(aside) > near
                if off.sum() >= 0.3 * len(off) and np.mean(apart < near) > 0.8:
                    return axis, aside
        return None

    def on_plane(self, joint: int) -> bool:
        """Whether a joint lies on the plane that mirrors the joints."""
        near = _ON_PLANE * self.size
        return self.mirror is not None and abs(float(self.mirror[1][joint])) < near


class Fan(Record):
    """Chains that run side by side from one joint: the fingers of a hand, toes, strands of hair."""

    joint: int
    chains: tuple[tuple[int, ...], ...]
    """Joints with skin, metacarpals included."""
    directions: Floats
    """(chains, 3) unit vectors."""
    middle: Floats
    """(3,) unit vector: the direction that most of them have."""


def fans(tree: Tree) -> list[Fan]:
    """The fans of chains of two joints with skin or more, in the order of their joints: three side
    by side at least, or beside the middle two that are shorter than their arm, as cartoons have."""
    found = []
    for joint in range(len(tree.joints)):
        chains = [each for child in tree.branches(joint) if (each := tree.chain(child))]
        if len(chains) < 2:
            continue
        least = 2 if _are_short(tree, joint, chains) else FINGERS
        directions = np.array([tree.direction(chain[-FINGERS:]) for chain in chains])
        middle = unit(np.median(directions, axis=0))
        cosines = directions @ middle
        if (cosines >= _PARALLEL).sum() >= least:
            kept = np.flatnonzero(cosines > 0.0)
            found.append(Fan(joint, tuple(chains[i] for i in kept), directions[kept], middle))
    return found


def _are_short(tree: Tree, joint: int, chains: Sequence[Sequence[int]]) -> bool:
    """Whether chains from a joint beside the middle are shorter than the arm that carries them, as
    legs and a pair of ears are not."""
    lengths = [tree.max_path(chain[0], chain[0]) for chain in chains]
    return not tree.on_plane(joint) and max(lengths) < tree.arm(joint) < np.inf


def unit(vector: Floats) -> Floats:
    """(3,) the vector at length 1; zero stays zero."""
    return vector / max(float(np.linalg.norm(vector)), 1e-30)


def level(vector: Floats, along: Floats) -> Floats:
    """(3,) unit vector of `vector` made perpendicular to the unit vector `along`."""
    return unit(vector - (vector @ along) * along)


# --- flat skeletons -------------------------------------------------------------------------------


def _looking(places: Floats, frames: Floats) -> tuple[int, ...]:
    """A parent for each joint of a flat skeleton, or -1: the nearest one that looks at it along the
    axis by which most joints of the skeleton look at another; what is left hangs on a root that has
    it ahead."""
    way = places[None] - places[:, None]
    apart = np.linalg.norm(way, axis=2)
    apart[apart == 0.0] = np.inf
    best, most = [-1] * len(places), 0
    for aim in (sign * frames[:, row] for row in range(3) for sign in (1.0, -1.0)):
        ahead = np.einsum("ijk,ik->ij", way, aim)
        cosine = np.maximum(ahead / apart, 1e-3)
        distance = apart / cosine**_STRAIGHT
        parents = _linked([-1] * len(places), np.where(cosine >= _AIM, distance, np.inf), places)
        whole = _linked(
            parents, np.where(cosine >= _AHEAD, distance, np.inf), places, roots_only=True
        )
        linked = sum(parent >= 0 for parent in whole)
        if linked > most:
            best, most = whole, linked
    return tuple(best)


def _linked(
    parents: list[int], distance: Floats, places: Floats, *, roots_only: bool = False
) -> list[int]:
    """The parents with those added that see a joint without one, at distances `distance` (joints,
    joints): the nearest pairs first, no joint below itself; `roots_only` joints that have no parent
    either."""
    parents = list(parents)
    for pair in np.argsort(distance, axis=None, kind="stable"):
        joint, target = divmod(int(pair), len(places))
        if not np.isfinite(distance[joint, target]):
            break
        above, at = {joint}, joint
        while (at := parents[at]) >= 0:
            above.add(at)
        if parents[target] < 0 and target not in above and not (roots_only and parents[joint] >= 0):
            parents[target] = joint
    return parents
