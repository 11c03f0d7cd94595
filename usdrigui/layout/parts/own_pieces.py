"""Eyes: joints that hold pieces of surface of their own.

An eyeball is a piece around its joint, all at nearly one distance from it: it turns on the spot.
"""

from __future__ import annotations

import numpy as np

from usdrigui.character import Body, Floats, Indices, Record
from usdrigui.character.joint_tree import Tree
from usdrigui.character.skinning import bound_points
from usdrigui.character.surface import components, mesh_triangles
from usdrigui.layout.shares import HARDLY_ANY, NEARLY_ALL

_BALL = 12
"""Points of an eyeball, at least."""


class Pieces(Record):
    """The connected pieces of a character's surface and the joints that hold them."""

    tree: Tree
    of_point: Indices
    """(n,) the piece of each point."""
    bound: Floats
    """(n, 3) points in the bind pose, in the space of the Skeleton."""
    held: Floats
    """(joints, pieces) share of the weights of each piece."""

    def whole(self, joint: int) -> Floats:
        """(p, 3) the points, bound, of the pieces that a joint holds alone, as good as."""
        return self.bound[np.isin(self.of_point, np.flatnonzero(self.held[joint] >= NEARLY_ALL))]


def pieces_of(body: Body, tree: Tree, places: Indices) -> Pieces:
    """The pieces of a rig whose points at the same position are one place, `places` (n,)."""
    of_point = components(mesh_triangles(body.meshes), places)
    bound = np.zeros((len(of_point), 3))
    held = np.zeros((len(body.joints), int(of_point.max(initial=-1)) + 1))
    for start, mesh in zip(body.starts, body.meshes, strict=False):
        skin = mesh.skin
        if skin is None:
            continue
        bound[start : start + len(mesh.points)] = bound_points(mesh.points, skin)[:, :3]
        acting = skin.by_joint.tocoo()
        np.add.at(held, (acting.col, of_point[start + acting.row]), acting.data)
    return Pieces(tree, of_point, bound, held / np.maximum(held.sum(axis=0), 1e-30))


def is_eye(pieces: Pieces, joint: int) -> bool:
    """Whether a joint that hangs on a head is that of an eyeball."""
    ways = pieces.whole(joint) - pieces.tree.joints[joint].bind[3, :3]
    if len(ways) < _BALL:
        return False
    distances = np.linalg.norm(ways, axis=1)
    radius = float(distances.mean())
    off = float(np.linalg.norm(ways.mean(axis=0)))
    # The front of a ball alone still is around its joint.
    return float(distances.std()) <= HARDLY_ANY * radius and off <= NEARLY_ALL * radius
