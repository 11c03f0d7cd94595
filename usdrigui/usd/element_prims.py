"""The gprims of an element, as UsdSkel applications deform and draw them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from pxr import Sdf, UsdGeom, Vt

from usdrigui.model import Element, Floats, Indices, Rig, Side
from usdrigui.usd import author, schema
from usdrigui.usd.carry import Hold, PointShape
from usdrigui.usd.drawn import Drawn

_COLOURS: Mapping[Side, tuple[float, float, float]] = {
    "left": (0.15, 0.45, 0.95),
    "right": (0.95, 0.25, 0.2),
    "middle": (0.95, 0.8, 0.15),
    "none": (0.75, 0.75, 0.75),
}
"""The animators' custom: blue on the character's left, red on its right, yellow in the middle."""
_TRACK_WIDTH = 0.15
"""Of a handle's."""
_AREA_OPACITY = 0.4
_VECTORS = Sdf.ValueTypeNames.Vector3fArray


def author_part(
    xform: Sdf.PrimSpec,
    name: str,
    part: Drawn,
    rig: Rig,
    element: Element,
    instances: Mapping[str, str],
    handle_width: float,
) -> None:
    """Define one drawn part below its element.

    `instances` gives the RigUIControlAPI instance of each control; `handle_width` is in scene units.
    """
    is_curve = part.role == "track" or (part.glyph is not None and part.glyph.form == "curve")
    api = schema.HANDLE if part.role == "handle" else schema.TRACK
    prim = author.prim(xform, name, "BasisCurves" if is_curve else "Mesh", (api, "SkelBindingAPI"))
    author.put(prim, "points", "point3f[]", part.points)
    if is_curve:
        counts = [len(part.points)] if part.glyph is None else part.glyph.counts
        _author_curves(prim, counts, _TRACK_WIDTH * handle_width)
    else:
        _author_faces(prim, part)
    author.put(prim, "primvars:displayColor", "color3f[]", [_COLOURS[element.side]], interpolation="constant")
    _author_binding(prim, rig, part.hold, len(part.points))
    _author_shapes(prim, rig, part.shapes)
    if part.role == "handle":
        _author_handle_api(prim, part, element)
    else:
        _author_track_api(prim, part, element, instances)


def _author_curves(prim: Sdf.PrimSpec, counts: Sequence[int] | Indices, width: float) -> None:
    author.put(prim, "type", "token", "linear", uniform=True)
    author.put(prim, "curveVertexCounts", "int[]", counts)
    author.put(prim, "widths", "float[]", [width], interpolation="constant")
    _author_extent(prim, UsdGeom.Curves.ComputeExtent(_written(prim, "points"), _written(prim, "widths")))


def _author_faces(prim: Sdf.PrimSpec, part: Drawn) -> None:
    counts, indices = np.full(len(part.faces), part.faces.shape[1]), part.faces.ravel()
    if part.glyph is not None:
        counts, indices = part.glyph.counts, part.glyph.indices
    author.put(prim, "faceVertexCounts", "int[]", counts)
    author.put(prim, "faceVertexIndices", "int[]", indices)
    # Flat faces whose normals are theirs in every pose.  A mesh of the scheme "none" would have to author normals.
    author.put(prim, "subdivisionScheme", "token", "bilinear", uniform=True)
    _author_extent(prim, UsdGeom.PointBased.ComputeExtent(_written(prim, "points")))
    if part.role == "area" or part.glyph is not None:
        author.put(prim, "doubleSided", "bool", True, uniform=True)
    if part.role == "area":
        author.put(prim, "primvars:displayOpacity", "float[]", [_AREA_OPACITY], interpolation="constant")


def _author_extent(prim: Sdf.PrimSpec, extent: Vt.Vec3fArray) -> None:
    """The extent to the last bit as USD computes it of what is written, in single precision."""
    Sdf.AttributeSpec(prim, "extent", Sdf.ValueTypeNames.Float3Array, Sdf.VariabilityVarying).default = extent


def _written(prim: Sdf.PrimSpec, name: str) -> Any:
    return prim.attributes[name].default


def _author_handle_api(prim: Sdf.PrimSpec, part: Drawn, element: Element) -> None:
    said: dict[str, Any] = {"adapt": element.adapt}
    if part.glyph is not None:
        said |= {"glyph": part.glyph.name, "glyphOffsets": part.glyph.points}
    author.declare(prim, schema.HANDLE, said)


def _author_track_api(prim: Sdf.PrimSpec, part: Drawn, element: Element, instances: Mapping[str, str]) -> None:
    alone = len(element.members) == 1
    author.declare(
        prim,
        schema.TRACK,
        {
            "controls": [] if alone else [instances[name] for name in part.controls],
            "weights": part.values.ravel(),
            "basePoints": [] if _same(part.points, part.base_points) else part.base_points,
        },
    )


def _same(first: Floats, second: Floats) -> bool:
    """Whether two arrays are one and the same in the single precision in which they are stored."""
    size = max(float(np.abs(second).max(initial=0.0)), 1e-30)
    return bool(np.abs(first - second).max(initial=0.0) <= 1e-7 * size)


# --- UsdSkel -----------------------------------------------------------------------------------------


def _author_binding(prim: Sdf.PrimSpec, rig: Rig, hold: Hold, count: int) -> None:
    """Skeleton and influences, complete: nothing is left to be inherited."""
    if hold.skeleton >= 0:
        author.link(prim, "skel:skeleton", [rig.skeletons[hold.skeleton].path])
    if not len(hold.joints):
        return
    bound = np.linalg.inv(rig.skeletons[hold.skeleton].to_root)
    width = len(hold.joints)
    # A joint may influence a point twice, but may be listed only once.
    listed, row = np.unique(hold.joints, return_inverse=True)
    author.put(prim, "skel:joints", "token[]", [rig.joints[joint].path for joint in listed], uniform=True)
    author.put(prim, "primvars:skel:geomBindTransform", "matrix4d", bound)
    author.put(prim, "primvars:skel:skinningMethod", "token", hold.method, uniform=True)
    for name, type_name, values in (
        ("primvars:skel:jointIndices", "int[]", row),
        ("primvars:skel:jointWeights", "float[]", hold.weights),
    ):
        # One row per point rather than one for all: rigid influences and shapes together confuse some readers.
        author.put(prim, name, type_name, np.tile(values, count), interpolation="vertex", element_size=width)


def _author_shapes(prim: Sdf.PrimSpec, rig: Rig, shapes: tuple[PointShape, ...]) -> None:
    if not shapes:
        return
    taken: set[str] = set()
    targets = []
    for shape in shapes:
        name = author.identifier(rig.channels[shape.channel].token, taken)
        targets.append(prim.path.AppendChild(name))
        author_shape(Sdf.PrimSpec(prim, name, Sdf.SpecifierDef, "BlendShape"), shape)
    tokens = [rig.channels[shape.channel].token for shape in shapes]
    author.put(prim, "skel:blendShapes", "token[]", tokens, uniform=True)
    author.link(prim, "skel:blendShapeTargets", targets)


def author_shape(child: Sdf.PrimSpec, shape: PointShape) -> None:
    """A layer has thousands of these, so nothing is looked up here."""
    between: set[str] = set()
    table = author.settled(shape.offsets, "vector3f[]").astype(np.float32)
    for weight, offsets in zip(shape.weights.tolist(), table, strict=True):
        name = "offsets" if weight == 1.0 else f"inbetweens:{_weight_name(weight, between)}"
        attribute = Sdf.AttributeSpec(child, name, _VECTORS, Sdf.VariabilityUniform)
        attribute.default = Vt.Vec3fArray.FromNumpy(offsets)
        if weight != 1.0:
            attribute.SetInfo("weight", weight)


def _weight_name(weight: float, taken: set[str]) -> str:
    """``at_0_5`` for 0.5, ``at_minus_0_5`` for -0.5."""
    return author.identifier(f"at_{weight:g}".replace("-", "minus_").replace(".", "_"), taken)
