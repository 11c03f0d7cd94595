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
from collections.abc import Mapping, Sequence
from typing import Literal

import numpy as np

from usdrigui.character import Body, Control
from usdrigui.character.rotation import rotation_part
from usdrigui.conventions import joysticks
from usdrigui.layout.canonical_face import kept_in
from usdrigui.layout.face import HELD, Face
from usdrigui.layout.motion.similarity import Similarity
from usdrigui.layout.shares import MOST, NOTHING
from usdrigui.ties import first_largest

Relation = Literal["convention", "open", ""]
"""The evidence of two controls' names: they belong together, none, or they do not."""

_LIKE = 0.16
"""Least amount of one axis of a joystick, or of one of two ends that no convention pairs, in shares
of the other's: no drag could aim at a far lesser one."""
_SHARED = 0.8
"""Least overlap of the regions of two axes that no convention joins, if they make a joystick."""
_ACROSS = 0.5
"""Largest cosine of the directions of two axes of a joystick; beyond it, directions, weighted by
displacement where both act, are alike or opposed."""


class Evidence:
    """Names, joints and motions of the controls of one character; indices are those of motions."""

    def __init__(self, face: Face, similarity: Similarity, twin: Mapping[int, int]) -> None:
        motions, controls = face.trajectories.motions, face.rig.controls
        self.face, self.similarity, self.twin = face, similarity, twin
        self.meanings = [face.meanings[motion.control] for motion in motions]
        self.joints = [_joints(face.rig.body, controls[motion.control]) for motion in motions]

    def relation(self, a: int, b: int) -> Relation:
        """The evidence of names and joints on one element for two controls."""
        one, other = self.meanings[a], self.meanings[b]
        if self.joints[a] != self.joints[b]:
            return ""
        if one is None or other is None:
            # The mirror image of a meaning has one too, whatever it is called.
            bound = self.twin.get(a, -1) != b and (self._specific(a) or self._specific(b))
            return "" if bound else "open"
        if one.action.in_family or other.action.in_family:
            return ""
        axes = {one.action.axis, other.action.axis}
        stick = len(axes) == 2 and axes in map(set, joysticks().values())
        if self.ends_by_convention(a, b) or (stick and one.side == other.side):
            return "convention"
        vague = one.action.vague or other.action.vague or one.action == other.action
        return "open" if vague and one.action.region == other.action.region else ""

    def ends_by_convention(self, a: int, b: int) -> bool:
        """Whether the conventions call two controls the ends of one axis; those of two joints are
        none."""
        one, other = self.meanings[a], self.meanings[b]
        if one is None or other is None or self.joints[a] != self.joints[b]:
            return False
        ends = one.action.axis == other.action.axis and one.action.pole == -other.action.pole
        return bool(one.action.axis) and ends and one.side == other.side

    def agrees(self, a: int, b: int) -> bool:
        """Whether the motions of two ends by convention agree with it: opposed, in one region."""
        return bool(
            self.similarity.direction[a, b] <= -_ACROSS and self.similarity.shared[a, b] >= MOST
        )

    def crossing(self, first: Sequence[int], second: Sequence[int]) -> tuple[Relation, float]:
        """What makes a joystick of two axes, empty if nothing: of controls whose names are specific
        the convention has to have it, and the motions agree.  And how well they cross, in
        [0, 1]."""
        known = self._of_axes(first, second)
        least = MOST if known == "convention" else _SHARED
        shared, across = self._compared(first, second)
        fits = shared >= least and across <= _ACROSS and self.like(first, second)
        flat = self._flatness(second[0]) if fits else 0.0
        return known if fits else "", shared * (1.0 - across) * flat

    def _of_axes(self, first: Sequence[int], second: Sequence[int]) -> Relation:
        """The evidence of names on a joystick of two axes."""
        found = {self.relation(a, b) for a in first for b in second}
        if found == {"convention"}:
            return "convention"
        return "" if "" in found or any(map(self._specific, (*first, *second))) else "open"

    def _compared(self, first: Sequence[int], second: Sequence[int]) -> tuple[float, float]:
        """Least overlap of the regions of two axes, and largest cosine of their directions."""
        pick = np.ix_(first, second)
        shared, direction = self.similarity.shared[pick], self.similarity.direction[pick]
        return float(shared.min()), float(np.abs(direction).max())

    def like(self, first: Sequence[int], second: Sequence[int]) -> bool:
        """Whether the controls of one axis move about as much as those of the other."""
        amounts = [float(self.similarity.norm[list(axis)].max()) for axis in (first, second)]
        return min(amounts) >= _LIKE * max(amounts)

    def one_place(self, motions: Sequence[int]) -> bool:
        """Whether some visible place keeps enough of all of these motions."""
        return self._held(motions) >= HELD

    def _held(self, motions: Sequence[int]) -> float:
        """Largest share of their own peaks that all of these motions keep at one visible place
        where they are expected."""
        face, share = self.face, np.ones(len(self.face.surface.points))
        for motion in (face.trajectories.motions[i] for i in motions):
            stands, expected = face.views.anywhere[motion.points], face.expected[motion.control]
            # The handle of an eye is where its lids are open, not on the skin that it owns most.
            stands = motion.stands_on(stands)
            if expected is not None and stands.any():
                around = expected.regions(face.surface.points[motion.points])[1]
                stands = kept_in(motion, stands, around, HELD)
            kept = np.zeros(len(share))
            kept[motion.points] = stands * motion.arc_length / motion.peak
            share = np.minimum(share, kept)
        return float(share.max(initial=0.0))

    # --- how the motions run ----------------------------------------------------------------------

    def signed(self, pair: tuple[int, ...]) -> tuple[int, ...]:
        """The pair with the end first that goes to the left or down as seen by the viewer."""
        fields = self.similarity.fields
        along = fields.weights @ (fields.vectors[pair[1]] - fields.vectors[pair[0]])
        flat = self.face.views.screen @ along
        return pair if flat[first_largest(np.abs(flat))] >= 0.0 else pair[::-1]

    def _flatness(self, index: int) -> float:
        """How far a motion runs along the surface rather than out of it: what a drag on a screen
        can follow."""
        fields, vectors = self.similarity.fields, self.similarity.fields.vectors[index]
        normals = self.face.surface.normals[fields.places]
        out = fields.weights @ np.einsum("mi,mi->m", vectors, normals) ** 2
        return 1.0 - float(out) / float(self.similarity.norm[index]) ** 2

    def uprightness(self, index: int) -> float:
        """Share of a motion that runs upright on the screen."""
        fields = self.similarity.fields
        across, upright = fields.weights @ np.abs(fields.vectors[index] @ self.face.views.screen.T)
        return float(upright / max(float(across + upright), 1e-300))

    # --- in words ---------------------------------------------------------------------------------

    def words(self, a: int, b: int) -> str:
        """The evidence for or against two opposed controls."""
        kept = f"both keep {self._held((a, b)):.0%} of their largest motion at one place"
        return f"{_alike(self.similarity.direction[a, b], self.similarity.shared[a, b])}, {kept}"

    def words_of_joystick(self, first: Sequence[int], second: Sequence[int]) -> str:
        """The reason for a joystick of two axes."""
        by = " by convention" if self._of_axes(first, second) == "convention" else ""
        shared, across = self._compared(first, second)
        return f"two axes of one region: a joystick{by} ({_alike(across, shared)})"

    def _specific(self, index: int) -> bool:
        meaning = self.meanings[index]
        return meaning is not None and not meaning.action.vague


def _alike(cosine: float, shared: float) -> str:
    """How two motions compare, in words, the same on every processor: the `cosine` of their
    directions and the share of their regions that is `shared`."""
    apart = math.degrees(math.acos(min(max(round(float(cosine), 6), -1.0), 1.0)))
    return f"their directions are {apart:.0f} degrees apart, their regions share {shared:.0%}"


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
    own = [turns[:, i] @ base for i, base in enumerate(bases)]  # radians
    return frozenset(
        joint
        for i, joint in enumerate(joints)
        if not any(
            parents[i] == parents[j] and np.allclose(own[i], own[j], atol=NOTHING) for j in range(i)
        )
    )
