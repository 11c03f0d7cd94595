"""The meshes that draw a layout, as UsdSkel applications deform them: few of them, shared by all
elements.

What hangs on one skeleton in one way is one Mesh, with a GeomSubset per element and one BlendShape
per channel that moves any of them.  See decision 050.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from pxr import Sdf, UsdGeom

from usdrigui.character import Body, Channel, Floats, Indices, Record
from usdrigui.character.palette import linear
from usdrigui.layer import author
from usdrigui.layer.drawn import Drawn, together
from usdrigui.layer.skin_binding import JointBinding, PointShape
from usdrigui.model import Element
from usdrigui.stages import schema

_AREA_OPACITY = 0.4
_FAMILY = "rigUI"


class DrawnElement(Record):
    """An element with all that is drawn of it, the handle first."""

    element: Element
    inner: bool
    """Whether it is shown only when a coarse element is opened."""
    parts: tuple[Drawn, ...]


class Drawing(Record):
    """What one Mesh draws: parts of elements that hang on one skeleton in one way, in one part of
    the character."""

    part: str
    inner: bool
    parts: tuple[tuple[int, Drawn], ...]
    """With the position of the element that each belongs to; in the order of the elements."""

    @property
    def joint_binding(self) -> JointBinding:
        """Of the first part; the others have the same skeleton and method."""
        return self.parts[0][1].joint_binding


def drawings(elements: Sequence[DrawnElement]) -> tuple[Drawing, ...]:
    """The meshes that the elements need, in the order in which they are first needed."""
    found: dict[tuple[object, ...], list[tuple[int, Drawn]]] = {}
    for position, each in enumerate(elements):
        for part in each.parts:
            bound = part.joint_binding
            # UsdSkel takes a point without influences to the origin.
            skinned = bool(len(bound.joints))
            key = (
                each.element.part,
                each.inner,
                bound.skeleton,
                bound.method if skinned else "",
                skinned,
            )
            found.setdefault(key, []).append((position, part))
    return tuple(Drawing(str(key[0]), bool(key[1]), tuple(parts)) for key, parts in found.items())


def drawing_name(drawing: Drawing, others: Iterable[Drawing]) -> str:
    """``FaceControls``, ``FaceMembers``, ``HandsStillControls``: names its content wherever an
    outliner lists it.

    *Still* is what no joint moves, where joints move the rest.
    """
    moved = [len(each.joint_binding.joints) > 0 for each in others]
    still = not len(drawing.joint_binding.joints) and any(moved)
    return (
        drawing.part.title()
        + ("Still" if still else "")
        + ("Members" if drawing.inner else "Controls")
    )


def drawing_about(drawing: Drawing) -> str:
    """What a person who meets the mesh in a layer has to know."""
    shown = ", shown when a coarse element is opened" if drawing.inner else ""
    return (
        f"Handles, tracks and areas of the elements of the {drawing.part or 'character'}{shown}."
        " Each element is a GeomSubset, each BlendShape does to all of them what its source does."
    )


def author_drawing(
    mesh: Sdf.PrimSpec,
    body: Body,
    drawing: Drawing,
    elements: Sequence[DrawnElement],
    names: Sequence[str],
) -> dict[int, Sdf.PrimSpec]:
    """Fill in a Mesh; returns the GeomSubset of each element whose handle it draws, by position.

    `names` are the prims of the elements.
    """
    _author_faces(mesh, drawing, elements)
    _author_binding(mesh, body, drawing)
    subsets = _author_subsets(mesh, drawing, names)
    author_shapes(mesh, body.channels, _spans(body, drawing), set(names))
    return subsets


# --- faces ----------------------------------------------------------------------------------------


def _author_faces(mesh: Sdf.PrimSpec, drawing: Drawing, elements: Sequence[DrawnElement]) -> None:
    parts = [part for _, part in drawing.parts]
    points, faces = together([(part.points, part.faces) for part in parts])
    author.put(mesh, "points", "point3f[]", points, exact=True)
    author.put(mesh, "faceVertexCounts", "int[]", faces.counts)
    author.put(mesh, "faceVertexIndices", "int[]", faces.indices)
    # Flat faces whose normals are theirs in every pose.  A mesh of the scheme "none" would have to
    # author normals.
    author.put(mesh, "subdivisionScheme", "token", "bilinear", uniform=True)
    author.put(mesh, "doubleSided", "bool", True, uniform=True)
    # To the last bit as USD computes it of what is written, in single precision.
    extent = UsdGeom.PointBased.ComputeExtent(mesh.attributes["points"].default)
    author.put(mesh, "extent", "float3[]", extent, exact=True)
    sides = [elements[position].element.side for position, _ in drawing.parts]
    used_sides = [*dict.fromkeys(sides)]
    which = [*map(used_sides.index, sides)]
    repeated = np.repeat(which, [len(part.faces.counts) for part in parts])
    colours = [*map(linear, used_sides)]
    _author_per_face(mesh, "primvars:displayColor", "color3f[]", colours, repeated)
    roles = np.concatenate([_roles(part) for part in parts])
    used, role_indices = np.unique(roles, return_inverse=True)
    names = [schema.ROLES[role] for role in used]
    _author_per_face(mesh, f"primvars:{schema.ROLE}", "token[]", names, role_indices)
    areas = roles == schema.ROLES.index("area")
    if areas.any():
        _author_per_face(mesh, "primvars:displayOpacity", "float[]", [1.0, _AREA_OPACITY], areas)


def _roles(part: Drawn) -> Indices:
    """(f,) what each face is, as positions in `schema.ROLES`."""
    count = len(part.faces.counts)
    roles = np.full(count, schema.ROLES.index("handle" if part.role == "handle" else "track"))
    roles[count - part.areas :] = schema.ROLES.index("area")
    return roles


def _author_per_face(
    mesh: Sdf.PrimSpec, name: str, type_name: str, values: Any, which: Any
) -> None:
    """A primvar with one of `values` for each face."""
    several = len(values) > 1
    author.put(mesh, name, type_name, values, interpolation="uniform" if several else "constant")
    if several:
        author.put(mesh, f"{name}:indices", "int[]", which)


def _author_subsets(
    mesh: Sdf.PrimSpec, drawing: Drawing, names: Sequence[str]
) -> dict[int, Sdf.PrimSpec]:
    author.put(mesh, f"subsetFamily:{_FAMILY}:familyType", "token", "nonOverlapping", uniform=True)
    ranges = _ranges([len(part.faces.counts) for _, part in drawing.parts])
    faces: dict[int, list[Indices]] = {}
    for (position, _), own in zip(drawing.parts, ranges, strict=True):
        faces.setdefault(position, []).append(own)
    handles = {position: part for position, part in drawing.parts if part.role == "handle"}
    subsets = {}
    for position, several in faces.items():
        subset = author.prim(mesh, names[position], "GeomSubset")
        author.put(subset, "familyName", "token", _FAMILY, uniform=True)
        author.put(subset, "indices", "int[]", np.concatenate(several))
        if position in handles:
            author.declare(subset, schema.HANDLE, {"lift": handles[position].lift})
            subsets[position] = subset
    return subsets


def _ranges(counts: Sequence[int]) -> list[Indices]:
    """Successive numbers from 0, so many of them in each."""
    return np.split(np.arange(sum(counts)), np.cumsum(counts)[:-1])


# --- UsdSkel --------------------------------------------------------------------------------------


def _author_binding(mesh: Sdf.PrimSpec, body: Body, drawing: Drawing) -> None:
    """Skeleton and influences, complete: nothing is left to be inherited."""
    bound, skeletons, joints = drawing.joint_binding, body.skeletons, body.joints
    if bound.skeleton >= 0:
        author.link(mesh, "skel:skeleton", [skeletons[bound.skeleton].path])
    if not len(bound.joints):
        return
    # All of the skeleton in its own order: any other has to be mapped at every frame.
    listed = np.flatnonzero([joint.skeleton == bound.skeleton for joint in joints])
    author.put(
        mesh, "skel:joints", "token[]", [joints[joint].path for joint in listed], uniform=True
    )
    author.put(
        mesh,
        "primvars:skel:geomBindTransform",
        "matrix4d",
        np.linalg.inv(skeletons[bound.skeleton].to_root),
    )
    author.put(mesh, "primvars:skel:skinningMethod", "token", bound.method, uniform=True)
    bindings = [(part.joint_binding, len(part.points)) for _, part in drawing.parts]
    width = max(len(each.joints) for each, _ in bindings)
    for name, type_name, values in (
        ("jointIndices", "int[]", [np.searchsorted(listed, each.joints) for each, _ in bindings]),
        ("jointWeights", "float[]", [_shares(each.weights) for each, _ in bindings]),
    ):
        rows = [
            np.tile(np.pad(row, (0, width - len(row))), count)
            for row, (_, count) in zip(values, bindings, strict=True)
        ]
        author.put(
            mesh,
            f"primvars:skel:{name}",
            type_name,
            np.concatenate(rows),
            interpolation="vertex",
            elementSize=width if width > 1 else None,
        )


def _shares(weights: Floats) -> Floats:
    """The weights in six decimals; their sum stays what it is, and with it the place of what they
    carry."""
    short = np.round(weights, 6)
    short[short.argmax()] += weights.sum() - short.sum()
    return np.round(short, 7)


# --- shapes ---------------------------------------------------------------------------------------

Spans = Sequence[tuple[Indices, Sequence[PointShape]]]
"""Points of a mesh, and the shapes that move them, with one offset for each."""


def _spans(body: Body, drawing: Drawing) -> Spans:
    """Every part's points with those of its shapes that the mesh's own animation drives."""
    ranges = _ranges([len(part.points) for _, part in drawing.parts])
    skeleton, channels = drawing.joint_binding.skeleton, body.channels
    driven = (
        {"", body.skeletons[skeleton].animation}
        if skeleton >= 0
        else {each.animation for each in channels}
    )
    return [
        (points, [each for each in part.shapes if channels[each.channel].animation in driven])
        for points, (_, part) in zip(ranges, drawing.parts, strict=True)
    ]


def author_shapes(
    mesh: Sdf.PrimSpec,
    channels: tuple[Channel, ...],
    spans: Spans,
    taken: set[str],
    existing: Sequence[tuple[str, Sdf.Path]] = (),
) -> None:
    """Let points of a mesh follow shapes: one BlendShape for each channel whose token the mesh does
    not have yet.

    `existing` are the tokens and targets that it has, `taken` the names of its children.
    """
    merged: dict[int, list[tuple[Indices, PointShape]]] = {}
    for points, shapes in spans:
        for shape in shapes:
            merged.setdefault(shape.channel, []).append((points, shape))
    targets = list(existing)
    for channel in sorted(merged):
        token = channels[channel].token
        if token in {known for known, _ in targets}:
            continue
        name = author.identifier(f"shape_{token}", taken)
        points, shape = _one_shape(channel, merged[channel])
        _author_shape(Sdf.PrimSpec(mesh, name, Sdf.SpecifierDef, "BlendShape"), points, shape)
        targets.append((token, mesh.path.AppendChild(name)))
    if len(targets) > len(existing):
        author.put(
            mesh, "skel:blendShapes", "token[]", [token for token, _ in targets], uniform=True
        )
        author.link(mesh, "skel:blendShapeTargets", [target for _, target in targets])


def _one_shape(
    channel: int, pieces: Sequence[tuple[Indices, PointShape]]
) -> tuple[Indices, PointShape]:
    """The shapes of one channel as one; each is piecewise linear, and so is the whole with the
    knots of all."""
    weights = np.unique(np.concatenate([shape.weights for _, shape in pieces]))
    rows = [
        (
            shape.offsets
            if np.array_equal(shape.weights, weights)
            else np.stack([shape.at(each) for each in weights])
        )
        for _, shape in pieces
    ]
    points = np.concatenate([points for points, _ in pieces])
    return points, PointShape(channel, weights, np.concatenate(rows, axis=1))


def _author_shape(child: Sdf.PrimSpec, points: Indices, shape: PointShape) -> None:
    between: set[str] = set()
    moved = np.flatnonzero(shape.offsets.any(axis=(0, 2)))
    moved = moved if len(moved) else np.arange(1)
    for weight, offsets in zip(shape.weights.tolist(), shape.offsets[:, moved], strict=True):
        told = f"at_{weight:g}".replace("-", "minus_").replace(".", "_")
        name = "offsets" if weight == 1.0 else f"inbetweens:{author.identifier(told, between)}"
        at = None if weight == 1.0 else weight
        author.put(child, name, "vector3f[]", offsets, uniform=True, exact=True, weight=at)
    author.put(child, "pointIndices", "int[]", points[moved], uniform=True)
