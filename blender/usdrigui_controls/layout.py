"""A layout as plain records that travel as JSON, so that a saved file keeps its controls without
the layer.

Positions are in the space of the SkelRoot ("root space"), in scene units; matrices are 4x4 in USD's
row-vector convention, as nested tuples.  Nothing here knows Blender or USD.
"""

from __future__ import annotations

import json
from collections import defaultdict
from dataclasses import asdict, dataclass
from functools import cached_property

import numpy as np

from .joints import JointFrame
from .maths.handle_track import along


class LayoutError(Exception):
    """A layer or a character that cannot be used, with a message for people."""


@dataclass(frozen=True)
class JointDrive:
    """What a control does to one joint, per key: see RigUIControlAPI."""

    at: tuple
    """Which joint it is: its skeleton and its path."""
    moves: tuple
    """Per key, the rotation vector, the translation and the logarithms of the scales."""


@dataclass(frozen=True)
class ShapeDrive:
    """The weight that a control adds to one blend-shape token, per key."""

    token: str
    weights: tuple


@dataclass(frozen=True)
class Control:
    """One control of the character."""

    name: str
    label: str
    minimum: float
    default: float
    maximum: float
    base: float
    """Value in the base pose."""
    keys: tuple
    """Ascending values of the drive's keys; empty where the weight of the only token is the value
    itself."""
    shapes: tuple
    joints: tuple
    attribute: str
    """Path of the attribute that holds its value."""

    @property
    def plain(self):
        """Whether the value is the weight of one blend shape."""
        return not self.keys and len(self.shapes) == 1 and not self.joints

    def step(self, parts, values):
        """What it gains from the first of two values to the second of what its drive has per key:
        the ``weights`` of a shape or the ``moves`` of a joint."""
        if self.keys:
            values = [along(self.keys, np.array(parts), each) for each in values]
        before, after = values
        return after - before


def gained(controls, before, after):
    """What some controls add to weights, by token, and to moves (3, 3), by (skeleton, joint), from
    the values ``before``, by name, to those ``after``."""
    weights, moves = defaultdict(float), defaultdict(lambda: np.zeros((3, 3)))
    for control in controls:
        values = before[control.name], after[control.name]
        for shape in control.shapes:
            weights[shape.token] += control.step(shape.weights, values)
        for joint in control.joints:
            moves[joint.at] += control.step(joint.moves, values)
    return weights, moves


@dataclass(frozen=True)
class Member:
    """One control of an element with its track: positions at ascending control values, in the base
    pose."""

    control: str
    values: tuple
    track: tuple
    magnification: float
    reversed: bool
    """Whether its mirror's member goes the other way."""


@dataclass(frozen=True)
class Element:
    """What the animator sees and grabs."""

    name: str
    label: str
    kind: str
    members: tuple
    mesh: str
    """Prim path of the mesh it stands on; empty on the board."""
    point: int
    position: tuple
    normal: tuple
    follows: bool
    """Whether it follows the deforming skin; else it hangs rigidly on `carriers`."""
    carriers: tuple
    """Joints and weights that carry an element which does not follow the skin."""
    skeleton: str
    side: str
    mirror: str
    inner: tuple
    """For a coarse element, the names of those that are shown in its place when it is opened."""
    reason: str
    axes: tuple
    """Positions of the members of each axis: one control, or the negative and the positive end of a
    signed axis."""
    width: float
    """Of its handle: that of its part."""


@dataclass(frozen=True)
class MeshRest:
    """One mesh under the SkelRoot."""

    path: str
    points: int
    to_root: tuple
    """Mesh space to root space at the bind pose."""


@dataclass(frozen=True)
class JointRest:
    """One joint: local transforms of the bind pose and of the rest pose."""

    path: str
    bind: tuple
    rest: tuple


@dataclass(frozen=True)
class SkeletonRest:
    """One Skeleton under the SkelRoot."""

    path: str
    to_root: tuple
    joints: tuple


@dataclass(frozen=True)
class Layout:
    """Everything that the controls of one character need."""

    root: str
    normal: tuple
    """Of the plane of symmetry; zero where there is none."""
    controls: tuple
    elements: tuple
    meshes: tuple
    skeletons: tuple

    @property
    def paths(self):
        """Of the skeletons and the meshes."""
        return [each.path for each in (*self.skeletons, *self.meshes)]

    def element(self, name):
        """An element by its name, if there is one."""
        return next((each for each in self.elements if each.name == name), None)

    @cached_property
    def frames(self):
        """The `JointFrame` of each joint, by skeleton and path."""
        found = {}
        for skeleton in self.skeletons:
            for joint in skeleton.joints:
                above = found.get((skeleton.path, joint.path.rpartition("/")[0]))
                unit = above.unit * np.cbrt(np.prod(above.size)) if above else 1.0
                found[skeleton.path, joint.path] = JointFrame(joint.bind, joint.rest, unit)
        return found

    def to_root(self, path):
        """(4, 4) from the space of a mesh or a skeleton to root space, for column vectors; none
        where it is neither."""
        parts = (*self.meshes, *self.skeletons)
        return next((np.array(each.to_root).T for each in parts if each.path == path), np.eye(4))


_RECORDS = {
    frozenset(each.__dataclass_fields__): each
    for each in (
        JointDrive,
        ShapeDrive,
        Control,
        Member,
        Element,
        MeshRest,
        JointRest,
        SkeletonRest,
        Layout,
    )
}
"""The records by the names of their fields, which tell them apart."""


def to_json(layout):
    """The layout as JSON text."""
    return json.dumps(asdict(layout), separators=(",", ":"))


def from_json(text):
    """The layout that `to_json` wrote.  Raises LayoutError when it is none."""
    try:
        found = json.loads(text, object_hook=_record)
    except (ValueError, KeyError) as error:
        raise LayoutError(f"the controls stored in this file cannot be read: {error!r}") from error
    if not isinstance(found, Layout):
        raise LayoutError("the controls stored in this file are none")
    return found


def _record(values):
    kind = _RECORDS[frozenset(values)]
    return kind(**{name: frozen(value) for name, value in values.items()})


def frozen(value):
    """Lists within lists as tuples."""
    return tuple(map(frozen, value)) if isinstance(value, list) else value
