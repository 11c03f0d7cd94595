"""The records that the stages hand to each other; numpy only, read-only throughout.

    Usd.Stage → Rig → Trajectories → Candidates → Groups → LayoutProblem → Assignment → Layout →
    Sdf.Layer

Coordinates: unless a field's documentation differs, positions are in the space of the SkelRoot
("root space"), column ``(x, y, z)`` triples in scene units.  Matrices are 4x4 in USD's row-vector
convention (``p' = p @ M``).  *Point* means an index into the concatenation of all meshes' points,
in the order of `Body.meshes`; *local* point means an index into one mesh.
"""

from __future__ import annotations

from usdrigui.model.assignment import GAP_FLOOR, Assignment, Status, Step
from usdrigui.model.candidates import Candidates, CandidateSet, Category, ElementKind, Group
from usdrigui.model.controls import Channel, Control, ControlKind, Drive, Joint, Skeleton
from usdrigui.model.layout import (
    Anchor,
    Decision,
    Element,
    ExistingPrim,
    ExistingSpan,
    Layout,
    LayoutCharacter,
    LayoutFrame,
    LayoutPart,
    Look,
    Manipulator,
    Member,
    Placement,
    Proof,
    Side,
)
from usdrigui.model.mesh import MeshBinding, MeshDisplay, RigMesh, Shape, Skin, Subset, Topology
from usdrigui.model.motion import (
    BaseSurface,
    MirrorPlane,
    Motion,
    Polylines,
    Shares,
    Symmetry,
    Trajectories,
)
from usdrigui.model.problem import (
    AnyOverlap,
    Choice,
    ExtraPairs,
    LayoutProblem,
    MeanOverlap,
    Overlap,
    Variable,
)
from usdrigui.model.record import Flags, Floats, Indices, Record, Singles, freeze
from usdrigui.model.rig import (
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
    "GAP_FLOOR",
    "Anchor",
    "AnyOverlap",
    "Assignment",
    "BaseSurface",
    "Body",
    "CandidateSet",
    "Candidates",
    "Category",
    "Channel",
    "Choice",
    "Clip",
    "Configured",
    "Control",
    "ControlKind",
    "Decision",
    "Drive",
    "Element",
    "ElementKind",
    "ExistingPrim",
    "ExistingSpan",
    "ExtraPairs",
    "Findings",
    "Flags",
    "Floats",
    "Glyph",
    "Group",
    "Indices",
    "Joint",
    "Layout",
    "LayoutCharacter",
    "LayoutFrame",
    "LayoutPart",
    "LayoutProblem",
    "LeftOff",
    "Look",
    "Manipulator",
    "MeanOverlap",
    "Member",
    "MeshBinding",
    "MeshDisplay",
    "MirrorPlane",
    "Motion",
    "Overlap",
    "Performance",
    "Placement",
    "Polylines",
    "Proof",
    "Record",
    "Rig",
    "RigMesh",
    "Shape",
    "Shares",
    "Side",
    "Singles",
    "SkelRoot",
    "Skeleton",
    "Skin",
    "Status",
    "Step",
    "Subset",
    "Symmetry",
    "Topology",
    "Trajectories",
    "Variable",
    "freeze",
]
