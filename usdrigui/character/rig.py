"""A character as the layout sees it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np

from usdrigui.character.controls import Channel, Control, Joint, Skeleton
from usdrigui.character.mesh import RigMesh, Shape, Skin
from usdrigui.character.record import Flags, Floats, Indices, Record
from usdrigui.errors import Issue


class Rig(Record):
    """A character under one SkelRoot: everything the layout needs, and no USD object."""

    path: str
    """Prim path of the SkelRoot."""
    up: Floats
    """(3,) unit up direction in root space."""
    metres_per_unit: float
    body: Body
    controls: tuple[Control, ...]
    left_off: tuple[LeftOff, ...] = ()
    """Controls that the source has but the rig does not."""
    issues: tuple[Issue, ...] = ()
    """Of the source."""
    variant_path: str = ""
    """`path` with the variants that are to hold the layout, ``/Char{LOD=low}``; empty
    without."""
    clip: Clip | None = None
    """The animation of what is bound under it."""
    time_codes: tuple[float, float, float] | None = None
    """First and last of its stage, and how many make a second; None where it has no range."""
    excluded: tuple[Control, ...] = ()
    """Controls that the configuration leaves out; what they move still counts for the size of the
    face."""
    glyphs: Mapping[str, Glyph] = field(default_factory=dict)
    """Shapes that it wants drawn as handles, by the name that it gives them."""
    camera: Floats | None = None
    """(3,) unit direction to the viewer of the camera from which it is to be laid out, if any."""
    to_world: Floats = field(default_factory=lambda: np.eye(4)[None])
    """(frames, 4, 4) from root space to its stage's world at each time code from the first on, or
    (1, 4, 4) where it stands still."""
    shot_camera: Floats | None = None
    """(frames, 14) the camera of its stage at each time code from the first on, in root space: unit
    rows to the right, up and to the viewer, its place, and half of the width and height of what it
    sees at a distance of 1."""

    @property
    def path_in_variants(self) -> str:
        """Of the SkelRoot, with the variants that are to hold the layout, if any: what findings
        call the character."""
        return self.variant_path or self.path

    @property
    def defaults(self) -> Floats:
        """(controls,) the default value of each."""
        return np.array([control.default for control in self.controls])

    @cached_property
    def control_names(self) -> tuple[str, ...]:
        """The names of all controls, in their order."""
        return tuple(control.name for control in self.controls)

    @cached_property
    def control_indices(self) -> Mapping[str, int]:
        """The place of every control in `controls`, by its name."""
        return {control.name: i for i, control in enumerate(self.controls)}


class Body(Record):
    """What UsdSkel poses under one SkelRoot: meshes by joints and by blend-shape weights."""

    meshes: tuple[RigMesh, ...]
    skeletons: tuple[Skeleton, ...]
    joints: tuple[Joint, ...]
    channels: tuple[Channel, ...]
    base_weights: Floats
    """(len(channels),) weights in the base pose (0 unless a time or pose was chosen)."""

    @cached_property
    def shapes_by_channel(self) -> Mapping[int, tuple[tuple[int, Shape], ...]]:
        """(mesh index, shape) of every shape that a channel drives; channels without shapes are
        absent."""
        found: dict[int, tuple[tuple[int, Shape], ...]] = {}
        for index, mesh in enumerate(self.meshes):
            for shape in mesh.shapes:
                found[shape.channel] = (*found.get(shape.channel, ()), (index, shape))
        return found

    @cached_property
    def by_path(self) -> Mapping[str, RigMesh]:
        """The meshes by their prim paths."""
        return {mesh.path: mesh for mesh in self.meshes}

    @property
    def starts(self) -> Indices:
        """(len(meshes) + 1,) first point of each mesh; the last entry is the number of points."""
        return np.cumsum([0, *(len(mesh.points) for mesh in self.meshes)], dtype=np.int64)

    @property
    def drawn(self) -> Flags:
        """(n,) points of visible meshes."""
        visible = [mesh.visible for mesh in self.meshes]
        return np.repeat(np.array(visible, dtype=bool), np.diff(self.starts))

    def point_of(self, path: str, local: int) -> int:
        """Point of a local point of the mesh at a path; -1 where there is no such mesh or point."""
        for start, mesh in zip(self.starts.tolist(), self.meshes, strict=False):
            if mesh.path == path and 0 <= local < len(mesh.points):
                return int(start + local)
        return -1

    def skeleton_of(self, skin: Skin) -> int:
        """Index of the Skeleton that a skin hangs on."""
        return self.joints[int(skin.joints[0, 0])].skeleton

    def bound_to(self, mesh: RigMesh) -> int:
        """Index of the Skeleton that a mesh is bound to: its joints', else the one whose animation
        drives its shapes; -1 where there is none."""
        if mesh.skin is not None:
            return self.skeleton_of(mesh.skin)
        animations = {self.channels[shape.channel].animation for shape in mesh.shapes} - {""}
        for index, skeleton in enumerate(self.skeletons):
            if skeleton.animation in animations:
                return index
        return 0 if self.skeletons else -1

    def mesh_of(self, point: int) -> tuple[RigMesh, int]:
        """Mesh and local point of a point."""
        starts = self.starts
        mesh = int(np.searchsorted(starts, point, side="right")) - 1
        return self.meshes[mesh], int(point - starts[mesh])


class Glyph(Record):
    """A curve or mesh that is drawn as an element's handle instead of the usual shape."""

    name: str
    """As the configuration names it."""
    form: Literal["curve", "mesh"]
    points: Floats
    """(q, 3).  In `Rig.glyphs`: x to the viewer's right, y up, z out of the face, in a
    sphere of radius 1 about the origin.  In `Element.glyph`: offsets from the handle's centre in
    the base pose; root space, scene units."""
    counts: Indices
    """(f,) points of each polyline or polygon."""
    indices: Indices
    """(sum of counts,) into `points`; polygons counter-clockwise from outside, polylines one after
    the other."""

    @property
    def parts(self) -> list[Indices]:
        """`indices` of each polyline or polygon."""
        return np.split(self.indices, np.cumsum(self.counts)[:-1])

    @property
    def turned_round(self) -> Indices:
        """`indices` with the corners of each face in the opposite order."""
        return np.concatenate([face[::-1] for face in self.parts])


@dataclass(frozen=True, slots=True)
class LeftOff:
    """A control, element or candidate that a stage dropped."""

    control: str
    stage: str
    """``read``, ``trajectories``, ``candidates``, ``groups``, ``solve`` or ``config``."""
    reason: str
    """For people: one clause, without a full stop."""


class Clip(Record):
    """What USD evaluates of the animation, one frame where nothing moves; empty arrays where
    nothing is authored."""

    times: Floats
    """(f,) time codes."""
    weights: Floats
    """(f, len(Body.channels)) absolute weights."""
    locals: Floats
    """(f, len(Body.joints), 4, 4) local joint transforms."""
    frames_per_second: float


class Performance(Record):
    """One SkelAnimation, sampled frame by frame, whatever character it is of."""

    source: str
    """Name of its file."""
    path: str
    """Prim path."""
    times: Floats
    """(f,) time codes, evenly spaced."""
    tokens: tuple[str, ...]
    weights: Floats
    """(f, len(tokens)) blend-shape weights."""
    joints: tuple[str, ...]
    """Joint tokens."""
    rotations: Floats
    """(f, len(joints), 3, 3) local rotations."""
