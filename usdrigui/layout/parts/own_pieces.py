"""Eyes and props: joints that hold pieces of surface of their own.

An eyeball is a piece around its joint, all at one distance from it: it turns on the spot.  A prop
is what hangs beside the chains of a skinned character: a sword, a hat, a bag.
"""

from __future__ import annotations

from collections.abc import Iterable, Set as AbstractSet
from dataclasses import dataclass

import numpy as np

from usdrigui.character import Body, Flags, Floats, Indices
from usdrigui.character.joint_tree import Tree
from usdrigui.character.skinning import bound_points
from usdrigui.character.surface import components, mesh_triangles

NEARLY_ALL = 0.9
"""Share from which skin, votes or motions count as all: of the weights of a piece, by which it is
held as a whole."""
_TOUCHED = 0.05
"""Share of the weights of a piece, or of a joint, from which the joint holds that piece, too."""
_ROUND = 0.15
"""Deviation of an eyeball's distances from its joint, as a share of their mean, at most."""
_AROUND = 0.85
"""Distance of an eyeball's middle from its joint, as a share of its radius, at most: the front of a
ball still is around it."""
_BALL = 12
"""Points of an eyeball, at least."""
_JOINTED = 2
"""Joints with skin in the longest chain of a prop, at most: hair and tails have more."""


@dataclass(frozen=True, eq=False)
class Pieces:
    """The connected pieces of a character's surface and the joints that hold them."""

    tree: Tree
    of_point: Indices
    """(n,) the piece of each point."""
    bound: Floats
    """(n, 3) points in the bind pose, in the space of the Skeleton."""
    held: Floats
    """(joints, pieces) share of the weights of each piece."""
    holds: Flags
    """(joints, pieces) whether it is no trifle, of the piece or of the joint."""
    owners: Indices
    """(n,) the joint that holds each point most firmly, -1 where none does."""

    def whole(self, joints: Iterable[int]) -> Indices:
        """The pieces that some joints hold alone, as good as."""
        return np.flatnonzero(self.held[list(joints)].sum(axis=0) >= NEARLY_ALL)

    def touched(self, joints: Iterable[int]) -> Indices:
        """The pieces that some joints hold, alone or with others."""
        return np.flatnonzero(self.holds[list(joints)].any(axis=0))

    def points(self, pieces: Indices) -> Floats:
        """(p, 3) the points of some pieces, bound."""
        return self.bound[np.isin(self.of_point, pieces)]


def pieces_of(body: Body, tree: Tree, places: Indices, owners: Indices) -> Pieces:
    """The pieces of a rig whose points at the same position are one place, `places` (n,).

    `owners` (n,) is as of `Pieces`.
    """
    of_point = components(mesh_triangles(body.meshes), places)
    bound = np.zeros((len(of_point), 3))
    held = np.zeros((len(body.joints), int(of_point.max(initial=-1)) + 1))
    for start, mesh in zip(body.starts, body.meshes, strict=False):
        skin = mesh.binding.skin
        if skin is None:
            continue
        bound[start : start + len(mesh.points)] = bound_points(mesh.points, skin)[:, :3]
        acting = skin.by_joint.tocoo()
        np.add.at(held, (acting.col, of_point[start + acting.row]), acting.data)
    of_piece, of_joint = (
        held / np.maximum(held.sum(axis=axis, keepdims=True), 1e-30) for axis in (0, 1)
    )
    holds = np.maximum(of_piece, of_joint) >= _TOUCHED
    return Pieces(tree, of_point, bound, of_piece, holds, owners)


def eyes(pieces: Pieces, below_heads: Iterable[int]) -> set[int]:
    """The joints of eyeballs among those that hang on a head."""
    return {joint for joint in below_heads if _is_eye(pieces, joint)}


def _is_eye(pieces: Pieces, joint: int) -> bool:
    points = pieces.points(pieces.whole((joint,)))
    ways = points - pieces.tree.joints[joint].bind[3, :3]
    if len(ways) < _BALL:
        return False
    distances = np.linalg.norm(ways, axis=1)
    radius = float(distances.mean())
    off = float(np.linalg.norm(ways.mean(axis=0)))
    return float(distances.std()) <= _ROUND * radius and off <= _AROUND * radius


def props(pieces: Pieces, heads: AbstractSet[int], eyes: AbstractSet[int]) -> set[int]:
    """The joints from which props hang; none hangs on a head, for hats are set with the face."""
    tree = pieces.tree
    below_heads, found = tree.below(heads), set[int]()
    for joint in tree.from_the_ends()[::-1]:
        branch = tree.below((joint,))
        if (
            joint not in below_heads
            and not found & set(tree.above(joint))
            and not branch & (heads | eyes)
            and 0 < tree.depth[joint] <= _JOINTED
            and _beside(tree, joint)
            and _apart(pieces, branch)
            and _on_skin(pieces, joint, branch)
        ):
            found.add(joint)
    return found


def _beside(tree: Tree, joint: int) -> bool:
    """Whether the chain goes on without a joint: another one carries it on, or the joint of the
    other side has no such joint (an axe in one hand)."""
    parent = tree.parents[joint]
    if parent < 0:
        return False
    return tree.next(parent) != joint or tree.one_sided(joint)


def _apart(pieces: Pieces, branch: set[int]) -> bool:
    """Whether joints hold nothing but pieces that no other joint holds."""
    touched = pieces.touched(branch)
    return bool(len(touched)) and bool(np.isin(touched, pieces.whole(branch)).all())


def _on_skin(pieces: Pieces, joint: int, branch: set[int]) -> bool:
    """Whether it hangs on skin that several joints share: the limbs of a robot are no props."""
    above = next((k for k in pieces.tree.above(joint) if k in pieces.tree.owners), None)
    if above is None:
        return False
    others = [k for k in range(len(pieces.held)) if k != above and k not in branch]
    return bool(np.isin(pieces.touched((above,)), pieces.touched(others)).any())
