"""Meshes as authored: points, blend shapes, skinning."""

from __future__ import annotations

from functools import cached_property
from typing import Literal

import numpy as np
from scipy.sparse import csc_array

from usdrigui.character.record import Floats, Indices, Record, Singles, Texels


class RigMesh(Record):
    """One mesh under the SkelRoot, as authored."""

    path: str
    points: Floats
    """(n, 3) `points` in the mesh's own space."""
    topology: Topology
    to_root: Floats
    """(4, 4) mesh space to root space; used where there is no skin."""
    skin: Skin | None = None
    shapes: tuple[Shape, ...] = ()
    visible: bool = True
    """False when the visibility or the purpose hides it from a default render, or when it is the
    outline of others."""
    colours: Floats | None = None
    """(n, 3) linear colours from 0 to 1 at the points; None where neither a material nor
    displayColor has."""
    texturing: Texturing | None = None
    """None where no image gives the colours."""


class Topology(Record):
    """The faces of a mesh."""

    face_counts: Indices
    face_indices: Indices
    """Local point indices."""
    left_handed: bool
    """Whether faces turn clockwise seen from outside *in root space*: a mirroring transform turns
    them round."""
    hash: str
    """Hex digest of point count, face counts and face indices: changes when point indices mean
    others."""
    subsets: tuple[Subset, ...] = ()
    """GeomSubsets, for locality."""


class Texturing(Record):
    """Images that give the faces of a mesh their colours."""

    uv: Floats
    """(c, 2) where each corner of the faces lies in its image, from the left and from below; beyond
    0 to 1 the image is repeated."""
    image: Indices
    """(f,) of each face, by index into `images`; -1 for a face of none."""
    images: tuple[Texels, ...]
    """(tall, wide, 4) each, encoded as sRGB, with opacity; scaled down as `usdrigui.stages.colours`
    says."""


class Subset(Record):
    """A GeomSubset: a named part of a mesh."""

    path: str
    points: Indices
    """Local points, ascending: those of its faces, for a subset of faces."""


class Shape(Record):
    """What one blend-shape token does to one mesh.

    The offset of a point at weight w is piecewise linear in w through the origin and `weights`, and
    is extrapolated beyond the ends along the first and last pieces, as UsdSkelBlendShapeQuery does.
    """

    channel: int
    """Index of the weight that drives it, into `Body.channels`; several shapes of a mesh may share
    it."""
    path: str
    """Prim path of the BlendShape."""
    weights: Floats
    """(k,) ascending in-between weights and 1; never 0."""
    points: Indices
    """(p,) local point indices that have an offset, ascending, unique."""
    offsets: Singles
    """(k, p, 3) offsets in the mesh's own space."""


class Skin(Record):
    """Joint influences of one mesh."""

    joints: Indices
    """(n, k) joint indices into `Body.joints`."""
    weights: Floats
    """(n, k) weights as authored; like UsdSkel, nothing normalises them."""
    method: Literal["classicLinear", "dualQuaternion"]
    geom_bind: Floats
    """(4, 4) geomBindTransform."""
    rigid: bool
    """True when the influences are constant over the mesh (n is still the number of points)."""

    @cached_property
    def by_joint(self) -> csc_array:
        """(n, joints up to the last that acts) the same influences, without zeros; those of a joint
        are a column, by point."""
        points, slots = np.nonzero(self.weights)
        joints = self.joints[points, slots]
        shape = (len(self.joints), int(joints.max(initial=-1)) + 1)
        return csc_array((self.weights[points, slots], (points, joints)), shape=shape)
