"""What a character is: its meshes, joints and controls, and how it deforms.  numpy and scipy
only."""

from __future__ import annotations

from usdrigui.character.controls import Channel, Control, ControlKind, Drive, Joint, Skeleton
from usdrigui.character.mesh import MeshBinding, MeshDisplay, RigMesh, Shape, Skin, Subset, Topology
from usdrigui.character.record import Flags, Floats, Indices, Record, Singles, freeze
from usdrigui.character.rig import (
    Body,
    Clip,
    Configured,
    Findings,
    Glyph,
    LeftOff,
    Performance,
    Rig,
    SkelRoot,
)

__all__ = [
    "Body",
    "Channel",
    "Clip",
    "Configured",
    "Control",
    "ControlKind",
    "Drive",
    "Findings",
    "Flags",
    "Floats",
    "Glyph",
    "Indices",
    "Joint",
    "LeftOff",
    "MeshBinding",
    "MeshDisplay",
    "Performance",
    "Record",
    "Rig",
    "RigMesh",
    "Shape",
    "Singles",
    "SkelRoot",
    "Skeleton",
    "Skin",
    "Subset",
    "Topology",
    "freeze",
]
