"""What a person decides about controls, apart from any layout."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any, Literal

from usdrigui.character.record import Record

CorrectedPlace = Literal["", "point", "face", "board", "free"]


class Correction(Record):
    """A decision about one control (RigUICorrectionAPI of the schema); what it leaves empty is not
    decided."""

    root: str
    """Prim path of the SkelRoot."""
    control: str
    """Name of the control when the correction was made."""
    place: CorrectedPlace = ""
    """``point``, anywhere on the face, on the board; ``free`` takes back what is on record."""
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Of the point, at rest, in root space, on the character for which it was made."""
    up: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Unit up direction of that character in root space; 0 where unknown."""
    unit: float = 0.0
    """Meters of a unit of that scene; 0 where unknown."""
    mesh: str = ""
    """Prim path of the point's mesh, as a hint."""
    point: int = -1
    """Its local index, as a hint."""
    group: tuple[str, ...] = ()
    """Controls that share its element, itself among them."""
    settings: Mapping[str, Any] = field(default_factory=dict)
    """Keys of ``[controls.NAME]`` and their values."""
    reason: str = ""
