"""The records that the stages hand to each other; numpy only, read-only throughout.

    Usd.Stage → Rig → Trajectories → Candidates → Groups → LayoutProblem → Assignment → Layout →
    Sdf.Layer

Coordinates: unless a field's documentation differs, positions are in the space of the SkelRoot
("root space"), column ``(x, y, z)`` triples in scene units.  Matrices are 4x4 in USD's row-vector
convention (``p' = p @ M``).  *Point* means an index into the concatenation of all meshes' points,
in the order of `Body.meshes`; *local* point means an index into one mesh.
"""

from __future__ import annotations

from usdrigui.model.assignment import GAP_FLOOR, Assignment, Status, Step, gap_of, proven
from usdrigui.model.candidates import Candidates, CandidateSet, Category, ElementKind, Group
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
    Legibility,
    Look,
    Manipulator,
    Member,
    Placement,
    Proof,
    Side,
)
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

__all__ = [
    "GAP_FLOOR",
    "Anchor",
    "AnyOverlap",
    "Assignment",
    "BaseSurface",
    "CandidateSet",
    "Candidates",
    "Category",
    "Choice",
    "Decision",
    "Element",
    "ElementKind",
    "ExistingPrim",
    "ExistingSpan",
    "ExtraPairs",
    "Group",
    "Layout",
    "LayoutCharacter",
    "LayoutFrame",
    "LayoutPart",
    "LayoutProblem",
    "Legibility",
    "Look",
    "Manipulator",
    "MeanOverlap",
    "Member",
    "MirrorPlane",
    "Motion",
    "Overlap",
    "Placement",
    "Polylines",
    "Proof",
    "Shares",
    "Side",
    "Status",
    "Step",
    "Symmetry",
    "Trajectories",
    "Variable",
    "gap_of",
    "proven",
]
