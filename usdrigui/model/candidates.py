"""Where controls may be anchored, and which of them share an element."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from usdrigui.character.record import Indices, Record
from usdrigui.character.rig import LeftOff
from usdrigui.model.motion import Motion

ElementKind = Literal["slider", "patch", "fan"]
Category = Literal[
    "",
    "global",
    "hidden",
    "composite",
    "viseme",
    "emotion",
    "identity",
    "interior",
    "combination",
    "requested",
]
"""Why a control is off the face: it moves the face as a whole, only affects geometry
hidden in all views, repeats others, stays with its family, or is sent there by configuration;
empty for a control of the face."""


@dataclass(frozen=True)
class Classification:
    """Whether a control is on the face, and if not, in which category it falls and why."""

    category: Category = ""
    """Empty for a control of the face."""
    off_face_reason: str = ""
    coverage: float = 0.0
    """Share of the visible face that it moves notably."""
    explained_by: tuple[tuple[int, float], ...] = ()
    """Motions of which that of a composite is the sum, and how far each of them goes, the strongest
    first."""


class Candidates(Record):
    """The candidates of every control that has any (paper section 4.2, pruning)."""

    sets: Mapping[int, CandidateSet]
    """By index into `Rig.controls`."""
    left_off: tuple[LeftOff, ...]


class CandidateSet(Record):
    """Where one control may be anchored."""

    motion: Motion
    points: Indices
    """(p,) points, ascending; of a control off the face the one where it moves most."""
    sources: Indices
    """(p,) point whose trajectory is drawn at each of `points`: the same point, unless the control
    is shown at a visible proxy of a hidden region."""


@dataclass(frozen=True, slots=True)
class Group:
    """Controls that share one element (paper: g)."""

    name: str
    kind: ElementKind
    controls: tuple[int, ...]
    """Indices into `Rig.controls`, in the element's order; opposed controls are next to each
    other."""
    opposed: tuple[tuple[int, int], ...]
    """Pairs of `controls` that are the two ends of one axis (negative, positive)."""
    mirror: tuple[int, ...]
    """The twins of `controls` in the same order, if the element is one of a symmetric pair; else
    empty."""
    reason: str
    """Why they are grouped; empty for a single control."""
    category: Category = ""
    """That of its controls; a group with a category goes to the board whatever the costs."""
    images: tuple[tuple[int, ...], ...] = ()
    """The controls of every further copy under the symmetry, in the same order: `mirror` for a
    pair, n - 1 tuples for an n-fold orbit."""
    image_names: tuple[str, ...] = ()
    """Names that the configuration gives to those copies; empty strings where it gives none."""
    image_reason: str = ""
    """The reason of a mirror copy, which has controls of its own; empty for any other."""
    inner: tuple[str, ...] = ()
    """Names of the groups that are shown in place of this one when it is opened; none unless it is
    coarse."""
    part: bool = False
    """True for a slider of its own of controls that another, coarse, group holds too."""
    states: frozenset[int] = frozenset({0})
    """States of the layout in which it is visible: 0 with nothing opened, k with the k-th coarse
    group opened."""

    def reason_of(self, controls: tuple[int, ...]) -> str:
        """The reason of the copy of these controls."""
        return self.image_reason if self.image_reason and controls == self.mirror else self.reason

    def apart(self, other: str) -> list[Group]:
        """The two elements of a pair, each by itself, that of the other side called `other` unless
        it has a name; the one of a doubled element."""
        alone = replace(self, mirror=(), images=(), image_names=(), image_reason="")
        if self.doubled:
            return [alone]
        name, reason = self.image_names[0] or other, self.reason_of(self.mirror)
        return [alone, replace(alone, name=name, controls=self.mirror, reason=reason)]

    @property
    def all_controls(self) -> frozenset[int]:
        """The controls of the element and of its images, together."""
        return frozenset().union(*self.copies)

    @property
    def copies(self) -> tuple[tuple[int, ...], ...]:
        """The controls of the element and of its images."""
        return (self.controls, *self.images)

    @property
    def doubled(self) -> bool:
        """Whether it is its own mirror image and has a copy on either side, of the same
        controls."""
        return bool(self.images) and set(self.mirror) == set(self.controls)

    @property
    def axes(self) -> tuple[tuple[int, ...], ...]:
        """Positions in `controls` of each axis: one control, or the negative and the positive end
        of a signed axis."""
        return axes_of(len(self.controls), self.opposed)


def axes_of(count: int, opposed: tuple[tuple[int, int], ...]) -> tuple[tuple[int, ...], ...]:
    """The axes of `count` controls: each pair of `opposed` is one, every other control one of its
    own."""
    ends = {end: pair for pair in opposed for end in pair}
    return tuple(sorted({ends.get(i, (i,)) for i in range(count)}, key=min))
