"""The records that the stages hand to each other; numpy only, read-only throughout.

    Usd.Stage → Rig → Trajectories → Candidates → Groups → LayoutProblem → Assignment → Layout →
    Sdf.Layer

Coordinates: unless a field's documentation differs, positions are in the space of the SkelRoot
("root space"), column ``(x, y, z)`` triples in scene units.  Matrices are 4x4 in USD's row-vector
convention (``p' = p @ M``).  *Point* means an index into the concatenation of all meshes' points,
in the order of `Body.meshes`; *local* point means an index into one mesh.
"""

from usdrigui.model.assignment import (
    GAP_FLOOR as GAP_FLOOR,
    Assignment as Assignment,
    Status as Status,
    Step as Step,
    gap_of as gap_of,
    proven as proven,
)
from usdrigui.model.candidates import (
    Candidates as Candidates,
    CandidateSet as CandidateSet,
    Category as Category,
    Classification as Classification,
    ElementKind as ElementKind,
    Group as Group,
)
from usdrigui.model.correction import (
    CorrectedPlace as CorrectedPlace,
    Correction as Correction,
)
from usdrigui.model.layout import (
    ONE_PLACE as ONE_PLACE,
    SURE as SURE,
    Anchor as Anchor,
    Decision as Decision,
    Element as Element,
    ExistingPrim as ExistingPrim,
    ExistingSpan as ExistingSpan,
    Layout as Layout,
    LayoutFrame as LayoutFrame,
    LayoutPart as LayoutPart,
    Legibility as Legibility,
    Match as Match,
    Member as Member,
    Proof as Proof,
    Side as Side,
    in_order as in_order,
    main_part as main_part,
)
from usdrigui.model.motion import (
    BaseSurface as BaseSurface,
    MirrorPlane as MirrorPlane,
    Motion as Motion,
    Symmetry as Symmetry,
    Trajectories as Trajectories,
)
from usdrigui.model.problem import (
    AnyOverlap as AnyOverlap,
    Choice as Choice,
    ExtraPairs as ExtraPairs,
    LayoutProblem as LayoutProblem,
    MeanOverlap as MeanOverlap,
    Overlap as Overlap,
    Variable as Variable,
)
