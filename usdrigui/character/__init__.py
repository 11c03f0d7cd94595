"""What a character is: its meshes, joints and controls, and how it deforms.  numpy and scipy
only."""

from usdrigui.character.controls import (
    Channel as Channel,
    Control as Control,
    ControlKind as ControlKind,
    Drive as Drive,
    Joint as Joint,
    Skeleton as Skeleton,
)
from usdrigui.character.mesh import (
    RigMesh as RigMesh,
    Shape as Shape,
    Skin as Skin,
    Subset as Subset,
    Texturing as Texturing,
    Topology as Topology,
)
from usdrigui.character.record import (
    Flags as Flags,
    Floats as Floats,
    Indices as Indices,
    Record as Record,
    Singles as Singles,
    Texels as Texels,
    freeze as freeze,
)
from usdrigui.character.rig import (
    Body as Body,
    Clip as Clip,
    Glyph as Glyph,
    LeftOff as LeftOff,
    Performance as Performance,
    Rig as Rig,
)
