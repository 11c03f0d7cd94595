"""Which elements stand behind others though nobody asks for levels.

In each region of a crowded face all stand behind the element that it is known for.  What a region
is, the conventions tell (brows, eyes, nose, mouth ...); controls whose names mean nothing are of
one region where they are near each other.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product
from typing import NamedTuple

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Floats
from usdrigui.layout.face import AROUND, FAR, Face
from usdrigui.layout.motion.similarity import Similarity
from usdrigui.layout.place.handle_width import wanted
from usdrigui.layout.shares import MOST
from usdrigui.model import Group


class _Standing(NamedTuple):
    """A group, in the order of how well it is known: by the conventions, then by how much it
    moves."""

    importance: float
    """Negative."""
    vague: bool
    moved: float
    """Negative."""
    name: str
    region: str
    places: Floats
    """(copies, d) the middle of where each copy's first control keeps most of its displacement;
    handle widths."""


def crowded_regions(
    face: Face, groups: tuple[Group, ...], comfortable: float
) -> dict[str, set[str]]:
    """The coarse group of each region with more elements around one than half a comfortable number,
    and its members, by name: either level has its half."""
    standing = sorted(_standing(face, group) for group in groups if not group.category)
    regions: list[list[_Standing]] = []
    for each in standing:
        near = (
            region
            for region in regions
            if region[0].region == each.region and _apart([each], region[:1]).min() <= FAR
        )
        home = next(near, [])
        home.append(each)
        if len(home) == 1:
            regions.append(home)
    return {
        region[0].name: {each.name for each in region[1:]}
        for region in regions
        if len(region) > 1
        and (_apart(region, standing) <= AROUND).sum(axis=1).mean() > 0.5 * comfortable
    }


def joints_behind_shapes(
    face: Face, similarity: Similarity, groups: Iterable[Group]
) -> dict[str, set[str]]:
    """By the name of a group of blend shapes, the groups of joints each axis of which moves the
    skin much as one of these shapes does.

    An eye that shapes and a joint turn has one gaze at a time, the shapes' first: lids follow it.
    """
    row = {motion.control: i for i, motion in enumerate(face.trajectories.motions)}
    of_kind = {"joint": list[Group](), "blendShape": list[Group](), "pose": list[Group]()}
    for group in groups:
        if not group.category:
            of_kind[face.rig.controls[group.controls[0]].kind].append(group)
    found: dict[str, set[str]] = {}
    for shapes, joint in product(of_kind["blendShape"], of_kind["joint"]):
        rows, columns = ([row[control] for control in each.controls] for each in (joint, shapes))
        # .9 and more for the eyes of eight avatars, .25 at most for any other joint.
        alike = np.abs(similarity.cosine[np.ix_(rows, columns)]).max(axis=1)
        if alike.min() >= MOST:
            found.setdefault(shapes.name, set()).add(joint.name)
    return found


def _apart(some: list[_Standing], others: list[_Standing]) -> Floats:
    """(n, m) distances of all places."""
    one, other = (np.concatenate([each.places for each in them]) for them in (some, others))
    return np.asarray(cdist(one, other))


def _standing(face: Face, group: Group) -> _Standing:
    surface = face.surface
    known = [each.action for i in group.controls if (each := face.meanings[i]) is not None]
    own = [face.trajectories.motion_of(i) for i in group.controls]
    places = []
    for copy in group.copies:
        points, shares = wanted(
            face.trajectories, face.views.anywhere, face.trajectories.motion_of(copy[0])
        )
        places.append(shares @ surface.points[points])
    return _Standing(
        -max((each.importance for each in known), default=0.0),
        all(each.vague for each in known),
        -sum(float(each.arc_length @ surface.areas[each.points]) for each in own),
        group.name,
        known[0].region if known else "",
        np.array(places) @ face.drawing_axes.T / face.handle_width,
    )
