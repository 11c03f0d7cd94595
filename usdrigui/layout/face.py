"""A character's face as measured: what the stages that place elements read, and terms of other packages too."""

from __future__ import annotations

from dataclasses import dataclass

from usdrigui.layout.visibility import Views
from usdrigui.model import Rig, Symmetry, Trajectories


@dataclass(frozen=True, eq=False)
class Face:
    """What the stages before placing found out about a character at its base pose."""

    rig: Rig
    trajectories: Trajectories
    symmetry: Symmetry
    views: Views
    handle_width: float
    """Diameter of a handle in scene units."""

    def control_name(self, control: int) -> str:
        """Name of a control by its index."""
        return self.rig.controls[control].name
