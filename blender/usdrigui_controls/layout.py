"""A layout as plain records that travel as JSON, so that a saved file keeps its controls without
the layer.

Positions are in the space of the SkelRoot ("root space"), in scene units; matrices are 4x4 in USD's
row-vector convention, as nested tuples.  Nothing here knows Blender or USD.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, is_dataclass
from typing import Any, get_args, get_type_hints

Matrix = tuple[tuple[float, float, float, float], ...]
Place = tuple[float, float, float]


class LayoutError(Exception):
    """A layer or a character that cannot be used, with a message for people."""


@dataclass(frozen=True)
class JointDrive:
    """What a control does to one joint, per key: see RigUIControlAPI."""

    skeleton: str
    joint: str
    rotations: tuple[Place, ...]
    translations: tuple[Place, ...]
    scales: tuple[Place, ...]


@dataclass(frozen=True)
class ShapeDrive:
    """The weight that a control adds to one blend-shape token, per key."""

    token: str
    weights: tuple[float, ...]


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
    keys: tuple[float, ...]
    """Ascending values of the drive's keys; empty where the weight of the only token is the value
    itself."""
    shapes: tuple[ShapeDrive, ...]
    joints: tuple[JointDrive, ...]

    @property
    def plain(self) -> bool:
        """Whether the value is the weight of one blend shape."""
        return not self.keys and len(self.shapes) == 1 and not self.joints


@dataclass(frozen=True)
class Member:
    """One control of an element with its track: positions at ascending control values, in the base
    pose."""

    control: str
    values: tuple[float, ...]
    track: tuple[Place, ...]
    magnification: float


@dataclass(frozen=True)
class Element:
    """What the animator sees and grabs."""

    name: str
    label: str
    kind: str
    members: tuple[Member, ...]
    mesh: str
    """Prim path of the mesh it stands on; empty on the board."""
    point: int
    position: Place
    normal: Place
    follows: bool
    """Whether it follows the deforming skin; else it hangs rigidly on `carriers`."""
    carriers: tuple[tuple[str, float], ...]
    """Joints and weights that carry an element which does not follow the skin."""
    skeleton: str
    side: str
    mirror: str
    reversed: tuple[int, ...]
    """Positions of members that mirror those of `mirror` with the opposite sign."""
    inner: tuple[str, ...]
    """For a coarse element, the names of those that are shown in its place when it is opened."""
    reason: str
    axes: tuple[tuple[int, ...], ...]
    """Positions of the members of each axis: one control, or the negative and the positive end of a
    signed axis."""
    width: float
    """Of its handle, as its part has it; 0 where it is `Layout.handle_width`."""


@dataclass(frozen=True)
class MeshRest:
    """One mesh under the SkelRoot."""

    path: str
    points: int
    to_root: Matrix
    """Mesh space to root space at the bind pose."""


@dataclass(frozen=True)
class JointRest:
    """One joint: local transforms of the bind pose and of the rest pose."""

    path: str
    bind: Matrix
    rest: Matrix


@dataclass(frozen=True)
class SkeletonRest:
    """One Skeleton under the SkelRoot."""

    path: str
    to_root: Matrix
    joints: tuple[JointRest, ...]


@dataclass(frozen=True)
class Layout:
    """Everything that the controls of one character need."""

    root: str
    handle_width: float
    controls: tuple[Control, ...]
    elements: tuple[Element, ...]
    meshes: tuple[MeshRest, ...]
    skeletons: tuple[SkeletonRest, ...]

    def width_of(self, element: Element) -> float:
        """Width of the handle of an element: that of its part."""
        return element.width or self.handle_width

    def element(self, name: str) -> Element | None:
        """An element by its name, if there is one."""
        return next((each for each in self.elements if each.name == name), None)

    def partners(self) -> dict[str, tuple[str, bool]]:
        """The twin of each control that has one, and whether it goes the other way; from mirrored
        elements."""
        found = {}
        for element in self.elements:
            other = self.element(element.mirror)
            if other is not None and len(other.members) == len(element.members):
                for i, (mine, theirs) in enumerate(
                    zip(element.members, other.members, strict=True)
                ):
                    found[mine.control] = theirs.control, i in element.reversed
        return found


def to_json(layout: Layout) -> str:
    """The layout as JSON text."""
    return json.dumps(asdict(layout), separators=(",", ":"))


def from_json(text: str) -> Layout:
    """The layout that `to_json` wrote.  Raises LayoutError when it is none."""
    try:
        return _record(Layout, json.loads(text))
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise LayoutError(f"the controls stored in this file cannot be read: {error!r}") from error


def _record(kind: Any, values: dict[str, Any]) -> Any:
    return kind(**{name: _as(said, values[name]) for name, said in get_type_hints(kind).items()})


def _as(said: Any, value: Any) -> Any:
    """A value of JSON as the type that a field says: tuples for lists, records within them."""
    inside = get_args(said)
    if inside and is_dataclass(inside[0]):
        return tuple(_record(inside[0], each) for each in value)
    return _frozen(value)


def _frozen(value: Any) -> Any:
    return tuple(_frozen(each) for each in value) if isinstance(value, list) else value
