"""Controls, and what they set: joints and blend-shape weights."""

from __future__ import annotations

from typing import Literal

from usdrigui.character.record import Floats, Indices, Record

ControlKind = Literal["blendShape", "joint", "pose"]


class Control(Record):
    """One rig parameter (paper: c_j)."""

    name: str
    """Unique in the rig: the token, ``joint:rx`` or the pose's name, after renaming by the
    config."""
    label: str
    """For people; the name unless the config gives another."""
    kind: ControlKind
    source: str
    """Blend-shape token, joint path or pose name as authored."""
    minimum: float
    default: float
    maximum: float
    range_source: Literal["config", "limits", "animation", "inbetweens", "metadata", "default"]
    drive: Drive


class Drive(Record):
    """What a control sets, as a piecewise linear function of its value.

    At value v the control adds to the base pose: blend-shape weights, joint rotations (as rotation
    vectors about the joint's own axes), translations and logarithms of scales.  A base transform
    with linear part S R (stretch, rotation) and translation t becomes ``exp(scales) S
    exp(rotations) R`` and ``t + translations``, which is what a SkelAnimation holds.  Between keys
    all are interpolated linearly (rotation vectors too: with two keys that is slerp), beyond the
    ends they are extrapolated.  All rows are zero where the value is the default.
    """

    values: Floats
    """(k,) ascending control values of the keys, k >= 2."""
    channels: Indices
    """(t,) indices into `Body.channels`."""
    weights: Floats
    """(k, t) added weights."""
    joints: Indices
    """(j,) indices into `Body.joints`."""
    moves: Floats
    """(k, 3, j, 3) rotation vectors in radians, what is added to the joints' local translations,
    and logarithms of scale factors along the joints' local axes."""

    @property
    def rotations(self) -> Floats:
        """(k, j, 3) rotation vectors, radians."""
        return self.moves[:, 0]

    @property
    def translations(self) -> Floats:
        """(k, j, 3)."""
        return self.moves[:, 1]

    @property
    def scales(self) -> Floats:
        """(k, j, 3) logarithms."""
        return self.moves[:, 2]

    @property
    def turn(self) -> Floats:
        """(3,) by which a rise of 1 turns the joints, added up, each about its own axes."""
        rise: Floats = (self.rotations[-1] - self.rotations[0]).sum(axis=0)
        return rise * (1.0 / float(self.values[-1] - self.values[0]))


class Channel(Record):
    """One blend-shape weight of one SkelAnimation."""

    token: str
    animation: str
    """Prim path of the SkelAnimation, or empty if none lists the token."""
    index: int
    """Position in `SkelAnimation.blendShapes`, or -1."""


class Joint(Record):
    """One joint of one skeleton; parents come before children in `Body.joints`."""

    path: str
    """Joint token as in `Skeleton.joints`, for example ``Head/Jaw``."""
    skeleton: int
    """Index into `Body.skeletons`."""
    parent: int
    """Index into `Body.joints`, or -1."""
    bind: Floats
    """(4, 4) bindTransforms entry (world at bind time)."""
    rest: Floats
    """(4, 4) local restTransforms entry."""
    base: Floats
    """(4, 4) local transform in the base pose (the rest transform unless a time or pose was
    chosen)."""

    @property
    def name(self) -> str:
        """The last name of its path."""
        return self.path.rsplit("/", 1)[-1]


class Skeleton(Record):
    """One Skeleton bound under the SkelRoot."""

    path: str
    animation: str
    """Prim path of the SkelAnimation that drives it, or empty."""
    to_root: Floats
    """(4, 4) skeleton space to root space."""
