"""What speaks for two controls sharing an element: names that agree, motions that agree, one place
for both.

Names come first where they are specific: of two controls whose actions the conventions know, only
the ends of one axis (look up, look down) or the axes of one joystick are candidates, so that a cast
that shares a convention is grouped alike.  Geometry can refuse any of them, and decides alone where
names mean nothing.  Controls of different joints never share an element, nor do controls of
different regions, nor members of a family (a viseme, an emotion).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np

from usdrigui.character import Body, Control
from usdrigui.character.rotation import rotation_part
from usdrigui.conventions import Meaning, joysticks
from usdrigui.layout.face import Face
from usdrigui.layout.motion.similarity import Similarity
from usdrigui.settings import CandidateSettings

Relation = Literal["convention", "open", ""]
"""The evidence of two controls' names: they belong together, none, or they do not."""

OPPOSED = -0.5
"""Cosine of directions, weighted by displacement where both act, from which a pair of the
convention is opposed."""
TWINS_OPPOSED = -0.4
"""The same for twins of each other (jaw left, jaw right): what they do upward they do alike."""
SAME_REGION = 0.5
"""Least overlap of the regions of two controls, or axes, that the conventions join."""
_HELD = CandidateSettings().least_kept
"""Share of both peaks that one visible place must keep: what any control keeps at its place."""
_LIKE_AMOUNT = 0.25
"""Least amount of one end in shares of the other's, where no convention pairs them."""

_ALIKE = 1e-3
"""Radians within which two joints of one parent turn alike: single precision leaves less."""


def alike(cosine: float, shared: float) -> str:
    """How two motions compare, in words, the same on every processor: the `cosine` of their
    directions and the share of their regions that is `shared`."""
    apart = math.degrees(math.acos(min(max(round(cosine, 6), -1.0), 1.0)))
    return f"their directions are {apart:.0f} degrees apart, their regions share {shared:.0%}"


class Evidence:
    """Names, joints and motions of the controls of one character; indices are those of motions."""

    def __init__(self, face: Face, similarity: Similarity) -> None:
        motions, controls = face.trajectories.motions, face.rig.controls
        self.face, self.similarity = face, similarity
        self.meanings = [face.meanings[motion.control] for motion in motions]
        self.joints = [_joints(face.rig.body, controls[motion.control]) for motion in motions]
        self.ways = tuple(frozenset(pair) for pair in joysticks().values())

    def relation(self, a: int, b: int) -> Relation:
        """The evidence of names and joints on one element for two controls."""
        one, other = self.meanings[a], self.meanings[b]
        if self.joints[a] != self.joints[b]:
            return ""
        if one is None or other is None:
            return "" if self._specific(a) or self._specific(b) else "open"
        if one.action.in_family or other.action.in_family:
            return ""
        if self._ends_of_one_axis(one, other) or self._axes_of_one_joystick(one, other):
            return "convention"
        vague = one.action.vague or other.action.vague or one.action == other.action
        return "open" if vague and one.action.region == other.action.region else ""

    def crossing(self, first: Sequence[int], second: Sequence[int]) -> Relation:
        """The same of one joystick for two axes: of controls whose names are specific the
        convention has to have it."""
        found = {self.relation(a, b) for a in first for b in second}
        if found == {"convention"}:
            return "convention"
        return "" if "" in found or any(self._specific(i) for i in (*first, *second)) else "open"

    def ends_by_convention(self, a: int, b: int) -> bool:
        """Whether the conventions call two controls the ends of one axis; those of two joints are
        none."""
        if self.joints[a] != self.joints[b]:
            return False
        one, other = self.meanings[a], self.meanings[b]
        return one is not None and other is not None and self._ends_of_one_axis(one, other)

    def agrees(self, a: int, b: int, *, twins: bool) -> bool:
        """Whether the motions of two ends by convention agree with it: opposed, in one region, with
        one place."""
        least = TWINS_OPPOSED if twins else OPPOSED
        same_region = self.similarity.shared[a, b] >= SAME_REGION
        return bool(self.similarity.direction[a, b] <= least and same_region)

    def like_amount(self, a: int, b: int) -> bool:
        """Whether one control moves about as much as the other."""
        amounts = self.similarity.norm[[a, b]]
        return bool(amounts.min() >= _LIKE_AMOUNT * amounts.max())

    def one_place(self, motions: Sequence[int]) -> bool:
        """Whether some visible place keeps enough of all of these motions."""
        return self.held(motions) >= _HELD

    def held(self, motions: Sequence[int]) -> float:
        """Largest share of their own peaks that all of these motions keep at one visible place."""
        share = np.where(self.face.views.anywhere, 1.0, 0.0)
        for motion in (self.face.trajectories.motions[i] for i in motions):
            own = np.zeros(len(share))
            own[motion.points] = np.where(motion.stands_on(), motion.arc_length, 0.0) / max(
                motion.peak, 1e-300
            )
            share = np.minimum(share, own)
        return float(share.max(initial=0.0))

    def words(self, a: int, b: int) -> str:
        """The evidence for or against two opposed controls."""
        compared = alike(
            float(self.similarity.direction[a, b]), float(self.similarity.shared[a, b])
        )
        return f"{compared}, both keep {self.held((a, b)):.0%} of their largest motion at one place"

    def _specific(self, index: int) -> bool:
        meaning = self.meanings[index]
        return meaning is not None and not meaning.action.vague

    def _ends_of_one_axis(self, one: Meaning, other: Meaning) -> bool:
        a, b = one.action, other.action
        return bool(a.axis) and a.axis == b.axis and a.pole == -b.pole and one.side == other.side

    def _axes_of_one_joystick(self, one: Meaning, other: Meaning) -> bool:
        axes = frozenset((one.action.axis, other.action.axis))
        return len(axes) == 2 and one.side == other.side and axes in self.ways


def _joints(body: Body, control: Control) -> frozenset[int]:
    """The joints that a control of joints turns; none of another control.  Of joints of one parent
    that turn alike the first: where all joints of a hand are roots, a spread carries the whole
    finger, and is no more a turn of its end than in a chain of joints."""
    if control.kind != "joint":
        return frozenset()
    joints, turns = control.drive.joints.tolist(), control.drive.rotations
    parents = [body.joints[joint].parent for joint in joints]
    bases = [rotation_part(body.joints[joint].base) for joint in joints]
    # About the axes of the joints' parents.
    own = [turns[:, i] @ base for i, base in enumerate(bases)]
    return frozenset(
        joint
        for i, joint in enumerate(joints)
        if not any(
            parents[i] == parents[j] and np.allclose(own[i], own[j], atol=_ALIKE) for j in range(i)
        )
    )
