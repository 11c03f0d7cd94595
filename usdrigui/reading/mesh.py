"""Meshes of one SkelRoot: points, faces and joint influences."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from pxr import Sdf, Usd, UsdGeom, UsdSkel
from scipy.spatial import cKDTree

from usdrigui.character import (
    Floats,
    Indices,
    RigMesh,
    Skin,
    Subset,
    Topology,
)
from usdrigui.character.surface import faces_inward, mesh_triangles
from usdrigui.errors import Issue, issue, refuse
from usdrigui.reading.blend_shape import (
    Binding,
    Found,
    legible_tokens,
    note_tokens,
    read_shapes,
)
from usdrigui.reading.skeleton import Frames, deforming
from usdrigui.stages import schema
from usdrigui.stages.arrays import (
    check_finite,
    check_range,
    floats,
    integers,
    value_at,
    vectors,
)
from usdrigui.stages.colours import colours_and_images

_DRAWN = (UsdGeom.Tokens.default_, UsdGeom.Tokens.render)
"""Purposes of what a default render draws."""
_UNEVEN = 1.5
"""Medians that a point of an outline may lie from what is outlined: a copy pushed outward lies at
one distance, sockets and linings of faces at 1.6 medians and more."""


def read_meshes(
    prims: Iterable[Usd.Prim], bindings: Mapping[Sdf.Path, Binding], frames: Frames, found: Found
) -> tuple[RigMesh, ...]:
    """The meshes among some prims below the SkelRoot, in their order; `found` takes the new tokens
    and the issues.

    A mesh whose arrays contradict each other is left off (decision 023).
    """
    meshes = []
    for prim in prims:
        path = prim.GetPath()
        binding = bindings.get(path)
        if not prim.IsA(UsdGeom.Mesh):
            if binding is not None:
                found.issues.append(issue("PRIM_UNSUPPORTED", path, f"is a {prim.GetTypeName()}"))
                note_tokens(prim, found, f"only {path}, a {prim.GetTypeName()}, has it")
            continue
        with found.leaving_off(str(path), legible_tokens(prim)):
            mesh = _mesh(prim, binding, frames, found)
            if mesh is not None:
                meshes.append(mesh)
    return _without_outlines(meshes)


def _without_outlines(read: Sequence[tuple[RigMesh, Floats, bool]]) -> tuple[RigMesh, ...]:
    """The meshes that are `read`; those that toon shading draws as an outline are not visible.

    An outline is a copy of what it surrounds, pushed outward, that shows its inner side alone: it
    hides nothing that faces the viewer.
    """
    shown = [at for mesh, at, inside_out in read if mesh.visible and not inside_out]
    around = cKDTree(np.concatenate(shown)) if 0 < len(shown) < len(read) else None
    meshes = []
    for mesh, at, inside_out in read:
        if inside_out and around is not None:
            apart, _ = around.query(at)
            if np.quantile(apart, 0.95) <= _UNEVEN * np.median(apart):
                mesh = replace(mesh, visible=False)
        meshes.append(mesh)
    return tuple(meshes)


def outside_issues(stage: Usd.Stage) -> tuple[Issue, ...]:
    """One for each mesh that looks like a part of a character but has no SkelRoot above it."""
    found = []
    walk = iter(Usd.PrimRange.Stage(stage))
    for prim in walk:
        if prim.IsA(UsdSkel.Root):
            walk.PruneChildren()
        elif prim.IsA(UsdGeom.Mesh) and (inputs := deforming(prim)):
            found.append(issue("MESH_OUTSIDE", prim.GetPath(), f"has {' and '.join(inputs)}"))
    return tuple(found)


def drawable(root: Usd.Prim) -> list[Usd.Prim]:
    """Point-based prims under the SkelRoot, without nested SkelRoots and earlier layouts."""
    prims = []
    walk = iter(Usd.PrimRange(root, Usd.TraverseInstanceProxies()))
    for prim in walk:
        nested = prim != root and prim.IsA(UsdSkel.Root)
        if nested or any(map(schema.is_layout, prim.GetPrimTypeInfo().GetAppliedAPISchemas())):
            walk.PruneChildren()
        elif prim.IsA(UsdGeom.PointBased):
            prims.append(prim)
    return prims


def _mesh(
    prim: Usd.Prim, binding: Binding | None, frames: Frames, found: Found
) -> tuple[RigMesh, Floats, bool] | None:
    """A mesh, its points (n, 3) in root space as they are bound, and whether it shows its inner
    side alone; None of one without points."""
    mesh, path, time = UsdGeom.Mesh(prim), str(prim.GetPath()), frames.time
    points = vectors(value_at(mesh.GetPointsAttr(), time), path, "points").astype(np.float64)
    if not len(points):
        found.issues.append(issue("MESH_EMPTY", path, "has no points"))
        note_tokens(prim, found, f"{path} has no points")
        return None
    counts, indices = checked_faces(mesh, time, len(points))
    varying = (mesh.GetPointsAttr(), mesh.GetFaceVertexIndicesAttr())
    if any(attribute.GetNumTimeSamples() > 1 for attribute in varying):
        when = "the default or earliest" if time.IsDefault() else f"{time.GetValue():g}"
        found.issues.append(issue("POINTS_ANIMATED", path, f"taken at time {when}"))
    # The skin first: a mesh that is left off for it must not have named channels.
    skin, to_root = _skin(binding, len(points), path, time, found), frames.to_root(prim)
    shapes = read_shapes(prim, binding, len(points), found)
    to_bound = to_root
    if skin is not None and binding is not None:
        # A skinned mesh goes by its Skeleton.
        to_bound = skin.geom_bind @ binding.armature.record.to_root
    topology = Topology(
        counts,
        indices,
        left_handed(mesh, to_bound[:3, :3]),
        topology_hash(len(points), counts, indices),
        _subsets(mesh, counts, indices, len(points), found),
    )
    colours, texturing = colours_and_images(prim, len(points), topology, time)
    record = RigMesh(
        path,
        points,
        topology,
        to_root,
        skin,
        shapes,
        _visible(mesh, time),
        colours,
        texturing,
    )
    bound = points @ to_bound[:3, :3] + to_bound[3, :3]
    single_sided = not mesh.GetDoubleSidedAttr().Get()
    return record, bound, single_sided and faces_inward(bound, mesh_triangles([record]))


def left_handed(mesh: UsdGeom.Mesh, linear: Floats) -> bool:
    """Whether faces turn clockwise seen from outside, once a (3, 3) `linear` map in row-vector form
    is applied to the points: by its orientation, and the other way round where the map
    mirrors."""
    authored = mesh.GetOrientationAttr().Get() == UsdGeom.Tokens.leftHanded
    return bool(authored != (np.linalg.det(linear) < 0.0))


def _subsets(
    mesh: UsdGeom.Mesh, counts: Indices, indices: Indices, count: int, found: Found
) -> tuple[Subset, ...]:
    """GeomSubsets of faces or points; members that the mesh does not have are left out, as is one
    without integers."""
    owner, every, subsets = np.repeat(np.arange(len(counts)), counts), np.arange(count), []
    for subset in UsdGeom.Subset.GetAllGeomSubsets(mesh):
        path, members = str(subset.GetPath()), np.zeros(0, dtype=np.int64)
        with found.leaving_off(path):
            members = integers(subset.GetIndicesAttr().Get(), path, "indices")
        is_of_faces = subset.GetElementTypeAttr().Get() == UsdGeom.Tokens.face
        points = np.unique(indices[np.isin(owner, members)]) if is_of_faces else members
        points = every[np.isin(every, points)]
        if len(points):
            subsets.append(Subset(path, points))
    return tuple(subsets)


def topology_hash(points: int, counts: Indices, indices: Indices) -> str:
    """Hex digest of a mesh's topology: number of points, face counts and face indices."""
    digest = hashlib.blake2b(digest_size=16)
    digest.update(np.array([points, len(counts), len(indices)], dtype="<i8").tobytes())
    digest.update(counts.astype("<i4").tobytes())
    digest.update(indices.astype("<i4").tobytes())
    return digest.hexdigest()


def checked_faces(mesh: UsdGeom.Mesh, time: Usd.TimeCode, count: int) -> tuple[Indices, Indices]:
    """Counts and indices of the faces of a mesh of `count` points; raises ARRAY_TYPE,
    TOPOLOGY_INVALID and INDEX_RANGE."""
    path = mesh.GetPath()
    counts = integers(value_at(mesh.GetFaceVertexCountsAttr(), time), path, "faceVertexCounts")
    indices = integers(value_at(mesh.GetFaceVertexIndicesAttr(), time), path, "faceVertexIndices")
    if (counts < 0).any() or counts.sum() != len(indices):
        what = f"faceVertexCounts add up to {counts.sum()}, faceVertexIndices has {len(indices)}"
        raise refuse("TOPOLOGY_INVALID", path, what)
    check_range(indices, count, path, "faceVertexIndices")
    return counts, indices


def _visible(mesh: UsdGeom.Mesh, time: Usd.TimeCode) -> bool:
    drawn = mesh.ComputePurpose() in _DRAWN
    return bool(drawn and mesh.ComputeVisibility(time) != UsdGeom.Tokens.invisible)


# --- not drawn ------------------------------------------------------------------------------------


def hidden_issues(stage: Usd.Stage, meshes: tuple[RigMesh, ...]) -> tuple[Issue, ...]:
    """One for each mesh that is not drawn and has what no drawn mesh has: blend shapes, or being
    deformed at all.

    Hidden stand-ins for what is drawn share its blend shapes, and are nothing to wonder at.
    """
    shown = [mesh for mesh in meshes if mesh.visible and (mesh.shapes or mesh.skin is not None)]
    seen = {shape.channel for mesh in shown for shape in mesh.shapes}
    found = []
    for mesh in meshes:
        own = sum(shape.channel not in seen for shape in mesh.shapes)
        if mesh.visible or not (own or (mesh.skin is not None and not shown)):
            continue
        what = "no mesh that is drawn deforms"
        if own:
            what = f"{own} of its blend shapes are on no mesh that is drawn"
        purpose = UsdGeom.Imageable(stage.GetPrimAtPath(mesh.path)).ComputePurpose()
        why = "is invisible" if purpose in _DRAWN else f"has the purpose {purpose}"
        found.append(issue("MESH_HIDDEN", mesh.path, f"{why}; {what}"))
    return tuple(found)


# --- influences -----------------------------------------------------------------------------------


def _skin(
    binding: Binding | None, count: int, path: str, time: Usd.TimeCode, found: Found
) -> Skin | None:
    """Influences with joints numbered as in `Body.joints`; None where UsdSkel would not skin
    either."""
    if binding is None or not binding.armature.joint_names:
        return None
    query = binding.query
    if not query.HasJointInfluences():
        return None
    joints, weights = (
        value_at(primvar, time)
        for primvar in (query.GetJointIndicesPrimvar(), query.GetJointWeightsPrimvar())
    )
    joints = integers(joints, path, "primvars:skel:jointIndices")
    weights = floats(weights, path, "primvars:skel:jointWeights")
    rigid = query.IsRigidlyDeformed()
    width = query.GetNumInfluencesPerComponent()
    expected = width if rigid else width * count
    if len(joints) != expected or len(weights) != expected or width < 1:
        counts = f"{len(joints)} jointIndices and {len(weights)} jointWeights"
        what = f"{count} points, {width} influences each, but {counts}"
        raise refuse("INFLUENCES_LENGTH", path, what)
    order = _joint_order(binding, path)
    check_range(joints, len(order), path, "primvars:skel:jointIndices")
    check_finite(weights, path, "primvars:skel:jointWeights")
    weights = weights.astype(np.float64).reshape(-1, width)
    _note_sums(weights, path, found)
    geom_bind = np.array(query.GetGeomBindTransform(time), dtype=np.float64)
    check_finite(geom_bind, path, "primvars:skel:geomBindTransform")
    return Skin(
        joints=np.broadcast_to(order[joints].reshape(-1, width), (count, width)),
        weights=np.broadcast_to(weights, (count, width)),
        method=_method(query, path, found),
        geom_bind=geom_bind,
        rigid=rigid,
    )


def _joint_order(binding: Binding, path: str) -> Indices:
    """Index into `Body.joints` of each joint that the mesh counts by."""
    armature = binding.armature
    names = binding.query.GetJointOrder() or armature.joint_names
    place = {name: armature.first + i for i, name in enumerate(armature.joint_names)}
    unknown = [str(name) for name in names if str(name) not in place]
    if unknown:
        what = f"skel:joints names {unknown[0]!r}, which {armature.record.path} lacks"
        raise refuse("JOINT_UNKNOWN", path, what)
    return np.array([place[str(name)] for name in names], dtype=np.int64)


def _method(query: UsdSkel.SkinningQuery, path: str, found: Found) -> Any:
    method = str(query.GetSkinningMethod())
    if method in ("classicLinear", "dualQuaternion"):
        return method
    found.issues.append(issue("SKINNING_METHOD", path, f"is {method!r}"))
    return "classicLinear"


def _note_sums(weights: Floats, path: str, found: Found) -> None:
    off = np.abs(weights.sum(axis=1) - 1.0)
    if off.max() > 1e-3:
        what = f"at {np.count_nonzero(off > 1e-3)} points, by up to {off.max():.3g}"
        found.issues.append(issue("WEIGHTS_UNNORMALISED", path, what))
