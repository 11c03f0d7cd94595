"""A character's face as measured: what the stages that place elements read, and terms of other
packages too."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from usdrigui.character import Flags, Floats, Indices, Record, Rig
from usdrigui.character.surface import components, mesh_triangles
from usdrigui.conventions import Meaning
from usdrigui.layout.canonical_face import Expectation
from usdrigui.layout.visibility import Views, clear_handles
from usdrigui.model import Anchor, BaseSurface, Symmetry, Trajectories
from usdrigui.settings import CandidateSettings
from usdrigui.ties import first_largest

AROUND = 4.0
"""Handle widths: what is nearer than this to a handle is around it."""
FAR = 3.0 * AROUND
"""Handle widths: what is farther is elsewhere, of another region; a control leaves the face rather
than go so far from its earlier place."""

HELD = CandidateSettings().least_kept
"""Share of its visible peak that any control keeps at its place: what two that share one, or one
that is expected somewhere, must keep there."""


_BESIDE = 8.0
"""Lengths of a hand by which the image of the other one is measured beside it, in nobody's way."""


class Face(Record):
    """What the stages before placing found out about a character at its base pose."""

    rig: Rig
    trajectories: Trajectories
    symmetry: Symmetry
    views: Views
    meanings: tuple[Meaning | None, ...] = ()
    """(controls,) how the name of each is read; None where it means nothing or is not read."""
    expected: tuple[Expectation | None, ...] = ()
    """(controls,) where each is expected; None where its name means nothing."""
    handle_width: float = 0.0
    """Diameter of a handle in scene units."""
    crowded: bool = False
    """Whether more controls want the same places than one level has handles for."""
    flat: bool = False
    """Whether elements are measured as they are seen on the screen, not in space."""
    behind: bool = False
    """Whether the handles of a flat layout may stand behind each other, as those of a wrist behind
    those of the fingers: it costs them then that they are near each other on the screen."""

    each_side: bool = False
    """Whether each side is looked at by itself, from mirrored directions."""

    @property
    def surface(self) -> BaseSurface:
        """The character at its base pose."""
        return self.trajectories.surface

    @property
    def names(self) -> list[str]:
        """(motions,) of the controls that make them."""
        return [self.control_name(motion.control) for motion in self.trajectories.motions]

    @property
    def drawing_axes(self) -> Floats:
        """(d, 3) the axes along which drawn elements are measured."""
        return self.views.drawing_axes(self.flat)

    @property
    def handle_axes(self) -> Floats:
        """(d, 3) the axes along which handles are kept apart, those of drawing first."""
        return self.views.axes if self.behind else self.drawing_axes

    def seen(self, axes: Floats, positions: Floats, aside: Floats) -> Floats:
        """(..., d) `positions` (..., 3) along some axes, of what is `aside` so far from the middle:
        where each side is looked at by itself, the right one as its mirror image, well beside the
        left."""
        if self.each_side:
            right = (aside < 0.0).reshape(aside.shape + (1,) * (positions.ndim - aside.ndim))
            image = self.symmetry.plane.reflected(positions)
            beside = image + _BESIDE * self.surface.face_size * self.views.axes[0]
            positions = np.where(right, beside, positions)
        return positions @ axes.T

    @cached_property
    def aside(self) -> Floats:
        """(n,) how far each point is to the left of the middle, in face sizes."""
        return self.symmetry.apart / self.surface.face_size

    @cached_property
    def clear(self) -> Flags:
        """(n,) points at which a handle can be seen as a whole."""
        base, normals = self.surface.points, self.surface.normals
        return clear_handles(self.views, base, normals, self.handle_width)

    @cached_property
    def twins(self) -> Indices:
        """(motions,) the mirror motion of each, itself, or -1."""
        rows = {motion.control: i for i, motion in enumerate(self.trajectories.motions)}
        found = [rows.get(int(self.symmetry.twins[control]), -1) for control in rows]
        return np.array(found, dtype=np.int64)

    @cached_property
    def peaks(self) -> list[int]:
        """(motions,) the point where each motion is largest, as far as it is seen."""
        seen = self.views.anywhere
        return [
            int(m.points[first_largest(np.where(seen[m.points], m.arc_length, 0.0))])
            for m in self.trajectories.motions
        ]

    @cached_property
    def pieces(self) -> Indices:
        """(n,) the connected piece of surface of each point."""
        return components(mesh_triangles(self.rig.body.meshes), self.surface.places)

    def control_name(self, control: int) -> str:
        """Name of a control by its index."""
        return self.rig.control_names[control]

    def anchor(self, point: int) -> Anchor:
        """The anchor on a point of the face."""
        mesh, local = self.rig.body.mesh_of(point)
        base, normal = self.surface.points[point], self.surface.normals[point]
        return Anchor(mesh.path, local, len(mesh.points), mesh.topology.hash, base, normal, False)
