"""Left and right of the skeleton, and which joint mirrors which: by the sides in names of joints
and their places in the tree."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from itertools import product

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Body, Floats, Joint
from usdrigui.character.joint_tree import Tree, level, unit
from usdrigui.conventions.sides import mirrored, side_of
from usdrigui.layout.motion.owned_skin import joint_places
from usdrigui.layout.parts.joint_regions import LIMB
from usdrigui.layout.shares import HARDLY_ANY, NEARLY_ALL
from usdrigui.model import MirrorPlane

ONE_WAY = 0.7
"""Cosine from which two directions are one: nearer to each other than to what is across them."""
_COUNT = re.compile(r"[ _.-]*\d+$")
"""What an exporter counts the joints with."""


def plane_of_names(body: Body) -> MirrorPlane | None:
    """The plane between the joints whose names have left and right, at the base pose; None where
    too few do or they do not agree."""
    twins = _twins(body.joints).items()
    return plane_of_pairs(
        body, {i: twin for i, twin in twins if side_of(body.joints[i].name) == "left"}
    )


def plane_of_pairs(body: Body, pairs: Mapping[int, int]) -> MirrorPlane | None:
    """The plane, at the base pose, between joints on the left and those that mirror them: between
    hips and shoulders, for what hangs on a pair swings as it likes, and all that are mirrored as
    they are.  None where too few are or they do not agree."""
    tree, places = Tree(body.joints, body.meshes), joint_places(body)
    chosen = [i for i in pairs if tree.depth[i]]  # Helpers bear no skin.
    if len(chosen) < 2:
        return None
    first = np.array([pairs.keys().isdisjoint(tree.above(i)) for i in chosen])
    left, right = places[chosen], places[[pairs[i] for i in chosen]]
    plane, agreement = plane_between(left[first], right[first])
    missed = np.linalg.norm(plane.reflected(left) - right, axis=1)
    near = first | (missed <= HARDLY_ANY * np.linalg.norm(left - right, axis=1))
    return plane_between(left[near], right[near])[0] if agreement >= ONE_WAY else None


def plane_between(left: Floats, right: Floats) -> tuple[MirrorPlane, float]:
    """The plane between points (p, 3) on the left and those that mirror them, in the middle, and
    the mean cosine of the lines between them to its normal."""
    across = (left - right) / np.maximum(np.linalg.norm(left - right, axis=1), 1e-30)[:, None]
    normal = unit(np.median(across, axis=0))
    offset = float(np.median(0.5 * (left + right) @ normal))
    return MirrorPlane(offset * normal, normal), (across @ normal).mean()


def _twins(joints: tuple[Joint, ...]) -> dict[int, int]:
    """Joints whose names are those of others with the sides swapped, to these; a number at the end,
    by which exporters count joints, may differ where the name is the only one of its kind."""
    found: dict[int, int] = {}
    names = [joint.name for joint in joints]
    for spelt in (names, [_COUNT.sub("", name) for name in names]):
        keys = [(joint.skeleton, name.lower()) for joint, name in zip(joints, spelt, strict=True)]
        counts = Counter(keys)
        alone = {key: i for i, key in enumerate(keys) if counts[key] == 1}
        for (skeleton, _), i in alone.items():
            # Capitals part the words of "LeftArm".
            other = alone.get((skeleton, mirrored(spelt[i])), i)
            if other != i:
                found.setdefault(i, other)
    return found


def mirrored_joints(body: Body, plane: MirrorPlane) -> dict[int, int]:
    """The mirror image of each joint that has one; itself in the middle.

    From the roots down, the joints on a joint of the middle mirror each other, those on a joint of
    one side those of its pair.  Where names have sides they decide, else what is nearest to the
    mirror image and has as many joints below.
    """
    if not body.joints:
        return {}
    tree, named = Tree(body.joints, body.meshes), _twins(body.joints)
    places = joint_places(body)
    # Characters rest in poses: a joint may miss the mirror image of its pair.
    reach = HARDLY_ANY * float(np.ptp(places, axis=0).max()) or 1.0
    apart = cdist(plane.reflected(places), places)
    below = [len(tree.below((joint,))) for joint in range(len(body.joints))]
    found: dict[int, int] = {}

    def cost(pair: tuple[int, int]) -> float:
        a, b = pair
        unlike = 0.5 if below[a] != below[b] else 0.0
        return round(unlike + float(apart[a, b]) / reach, 3)

    roots = [joint for joint, parent in enumerate(tree.parents) if parent < 0]
    pending = [(roots, roots)]
    while pending:
        ours, theirs = pending.pop()
        for a, b in sorted(product(ours, theirs), key=cost):
            # A name counts among those that may mirror each other, as counts down two arms may not.
            claimed = named.get(a) in theirs or named.get(b) in ours
            near = named.get(a) == b or (apart[a, b] <= reach and not claimed)
            if near and a not in found and b not in found:
                found[a], found[b] = b, a
                pending.append(([*tree.children[a]], [*tree.children[b]]))
    return found


def legs_point(body: Body, plane: MirrorPlane) -> Floats:
    """(3,) unit direction of the limbs that part from the skeleton first, of both sides together:
    legs go down, under whatever stands on them.  Zero where these do not go one way, as the arms of
    a bust do not, or go along the trunk, as arms do that hang, and where there are none."""
    tree = Tree(body.joints, body.meshes)
    twins = mirrored_joints(body, plane) if plane.normal.any() else {}
    above = {
        joint: len([*tree.above(joint)])
        for joint, twin in twins.items()
        if twin != joint and tree.depth[joint] >= LIMB
    }
    if not above:
        return np.zeros(3)
    places, ways = joint_places(body), np.zeros((1, 3))
    tops = sorted(joint for joint, count in above.items() if count == min(above.values()))
    trunk = places[[joint for joint in sorted(tree.owners) if twins.get(joint) == joint]]
    for top in tops:
        end = top
        while tree.next(end) >= 0:
            end = tree.next(end)
        ways = np.vstack([ways, places[end] - places[top]])
    together = ways.sum(axis=0)
    found = level(together, plane.normal)
    # .98 or more in five bodies, whose arms go .07 to .81 of theirs.
    one_way = found @ together >= NEARLY_ALL * np.linalg.norm(ways, axis=1).sum()
    on_them = ((trunk - places[tops].mean(axis=0)) @ found).sum() <= 0.0
    return found if one_way and on_them else np.zeros(3)
