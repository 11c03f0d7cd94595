"""A character's face as measured: what the stages that place elements read, and terms of other
packages too."""

from __future__ import annotations

from functools import cached_property

from usdrigui.character import Flags, Floats, Record, Rig
from usdrigui.conventions import Meaning
from usdrigui.layout.canonical_face import Expectation
from usdrigui.layout.visibility import Views, clear_handles
from usdrigui.model import Symmetry, Trajectories


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
    """Whether elements are kept apart as they are seen on the screen, not in space."""

    @property
    def drawing_axes(self) -> Floats:
        """(d, 3) the axes along which drawn elements are measured."""
        return self.views.drawing_axes(self.flat)

    @cached_property
    def clear(self) -> Flags:
        """(n,) points at which a handle can be seen as a whole."""
        base, normals = self.trajectories.surface.points, self.trajectories.surface.normals
        return clear_handles(self.views, base, normals, self.handle_width)

    def control_name(self, control: int) -> str:
        """Name of a control by its index."""
        return self.rig.controls[control].name
