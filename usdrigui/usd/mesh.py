"""Meshes of one SkelRoot: points, faces, influences and blend shapes."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Sdf, Usd, UsdGeom, UsdSkel

from usdrigui.errors import Issue, issue, refuse
from usdrigui.model import Floats, Indices, LeftOff, RigMesh, Shape, Singles, Skin
from usdrigui.usd.skeleton import Armature, Frames, repeated


@dataclass
class Found:
    """What reading the meshes brought up besides the meshes."""

    tokens: dict[tuple[str, str], int] = field(default_factory=dict)
    """Channel index by (token, animation path); grows by tokens that no animation lists."""
    shapeless: dict[str, str] = field(default_factory=dict)
    """Why a token got no shape from some mesh."""
    issues: list[Issue] = field(default_factory=list)


@dataclass(frozen=True)
class Binding:
    """How a prim hangs on a Skeleton."""

    armature: Armature
    query: UsdSkel.SkinningQuery


def read_meshes(
    root: Usd.Prim, bindings: Mapping[Sdf.Path, Binding], frames: Frames, found: Found
) -> tuple[RigMesh, ...]:
    """All meshes under the SkelRoot, in stage order; `found` takes the new tokens and the issues.

    Raises RigUIError for arrays that contradict each other (see `usdrigui.errors`).
    """
    meshes = []
    for prim in _drawable(root):
        path = prim.GetPath()
        binding = bindings.get(path)
        if not prim.IsA(UsdGeom.Mesh):
            if binding is not None:
                found.issues.append(issue("PRIM_UNSUPPORTED", str(path), f"is a {prim.GetTypeName()}"))
                _note_tokens(prim, found, f"only {path}, a {prim.GetTypeName()}, has it")
            continue
        mesh = _mesh(prim, binding, frames, found)
        if mesh is not None:
            meshes.append(mesh)
    return tuple(meshes)


def _drawable(root: Usd.Prim) -> list[Usd.Prim]:
    """Point-based prims under the SkelRoot, without nested SkelRoots and earlier layouts."""
    prims = []
    walk = iter(Usd.PrimRange(root, Usd.TraverseInstanceProxies()))
    for prim in walk:
        nested = prim != root and prim.IsA(UsdSkel.Root)
        if nested or "RigUILayoutAPI" in prim.GetPrimTypeInfo().GetAppliedAPISchemas():
            walk.PruneChildren()
        elif prim.IsA(UsdGeom.PointBased):
            prims.append(prim)
    return prims


def _mesh(prim: Usd.Prim, binding: Binding | None, frames: Frames, found: Found) -> RigMesh | None:
    mesh, path = UsdGeom.Mesh(prim), str(prim.GetPath())
    points = _points(mesh, frames.time, path)
    if not len(points):
        found.issues.append(issue("MESH_EMPTY", path, "has no points"))
        _note_tokens(prim, found, f"{path} has no points")
        return None
    counts, indices = _faces(mesh, frames.time, path, len(points))
    if mesh.GetPointsAttr().GetNumTimeSamples() > 1 or mesh.GetFaceVertexIndicesAttr().GetNumTimeSamples() > 1:
        found.issues.append(issue("POINTS_ANIMATED", path, f"taken at {_time_name(mesh, frames.time)}"))
    shapes = _shapes(prim, binding, len(points), found)
    skin = _skin(binding, len(points), path, frames.time, found)
    if binding is not None and prim.IsInstanceProxy():
        raise refuse("INSTANCE", path, "a deforming mesh lies inside an instance")
    return RigMesh(
        path=path,
        points=points,
        face_counts=counts,
        face_indices=indices,
        left_handed=mesh.GetOrientationAttr().Get() == UsdGeom.Tokens.leftHanded,
        visible=_visible(mesh, frames.time),
        subdivision=str(mesh.GetSubdivisionSchemeAttr().Get()),
        to_root=frames.to_root(prim),
        skin=skin,
        shapes=shapes,
        topology_hash=topology_hash(len(points), counts, indices),
    )


def topology_hash(points: int, counts: Indices, indices: Indices) -> str:
    """Hex digest of a mesh's topology: number of points, face counts and face indices."""
    digest = hashlib.blake2b(digest_size=16)
    digest.update(np.array([points, len(counts), len(indices)], dtype="<i8").tobytes())
    digest.update(counts.astype("<i4").tobytes())
    digest.update(indices.astype("<i4").tobytes())
    return digest.hexdigest()


def _points(mesh: UsdGeom.Mesh, time: Usd.TimeCode, path: str) -> Floats:
    return _vectors(_value(mesh.GetPointsAttr(), time), path, "points").astype(np.float64)


def _faces(mesh: UsdGeom.Mesh, time: Usd.TimeCode, path: str, count: int) -> tuple[Indices, Indices]:
    counts = _integers(_value(mesh.GetFaceVertexCountsAttr(), time), path, "faceVertexCounts")
    indices = _integers(_value(mesh.GetFaceVertexIndicesAttr(), time), path, "faceVertexIndices")
    if (counts < 0).any() or counts.sum() != len(indices):
        raise refuse(
            "TOPOLOGY_INVALID", path, f"faceVertexCounts add up to {counts.sum()}, faceVertexIndices has {len(indices)}"
        )
    _check_range(indices, count, path, "faceVertexIndices")
    return counts, indices


def _visible(mesh: UsdGeom.Mesh, time: Usd.TimeCode) -> bool:
    drawn = mesh.ComputePurpose() in (UsdGeom.Tokens.default_, UsdGeom.Tokens.render)
    return bool(drawn and mesh.ComputeVisibility(time) != UsdGeom.Tokens.invisible)


def _time_name(mesh: UsdGeom.Mesh, time: Usd.TimeCode) -> str:
    if not time.IsDefault():
        return f"time {time.GetValue():g}"
    return "the default value" if mesh.GetPointsAttr().Get() is not None else "the earliest time"


# --- influences --------------------------------------------------------------------------------------


def _skin(binding: Binding | None, count: int, path: str, time: Usd.TimeCode, found: Found) -> Skin | None:
    """Influences with joints numbered as in `Rig.joints`; None where UsdSkel would not skin either."""
    if binding is None or not binding.armature.joint_names or not binding.query.HasJointInfluences():
        return None
    query = binding.query
    joints = _integers(_value(query.GetJointIndicesPrimvar(), time), path, "primvars:skel:jointIndices")
    weights = _floats(_value(query.GetJointWeightsPrimvar(), time), path, "primvars:skel:jointWeights")
    rigid = query.IsRigidlyDeformed()
    width = query.GetNumInfluencesPerComponent()
    expected = width if rigid else width * count
    if len(joints) != expected or len(weights) != expected or width < 1:
        raise refuse(
            "INFLUENCES_LENGTH",
            path,
            f"{count} points, {width} influences each, but {len(joints)} jointIndices and {len(weights)} jointWeights",
        )
    order = _joint_order(binding, path)
    _check_range(joints, len(order), path, "primvars:skel:jointIndices")
    _check_finite(weights, path, "primvars:skel:jointWeights")
    weights = weights.astype(np.float64).reshape(-1, width)
    _note_sums(weights, path, found)
    return Skin(
        joints=np.broadcast_to(order[joints].reshape(-1, width), (count, width)),
        weights=np.broadcast_to(weights, (count, width)),
        method=_method(query, path, found),
        geom_bind=np.array(query.GetGeomBindTransform(time), dtype=np.float64),
        rigid=rigid,
    )


def _joint_order(binding: Binding, path: str) -> Indices:
    """Index into `Rig.joints` of each joint that the mesh counts by."""
    armature = binding.armature
    own = binding.query.GetJointOrder()
    if own is None or len(own) == 0:
        return armature.first + np.arange(len(armature.joint_names), dtype=np.int64)
    place = {name: armature.first + i for i, name in enumerate(armature.joint_names)}
    unknown = [str(name) for name in own if str(name) not in place]
    if unknown:
        raise refuse("JOINT_UNKNOWN", path, f"skel:joints names {unknown[0]!r}, which {armature.record.path} lacks")
    return np.array([place[str(name)] for name in own], dtype=np.int64)


def _method(query: UsdSkel.SkinningQuery, path: str, found: Found) -> Any:
    method = str(query.GetSkinningMethod())
    if method in ("classicLinear", "dualQuaternion"):
        return method
    found.issues.append(issue("SKINNING_METHOD", path, f"is {method!r}"))
    return "classicLinear"


def _note_sums(weights: Floats, path: str, found: Found) -> None:
    off = np.abs(weights.sum(axis=1) - 1.0)
    if off.max() > 1e-3:
        found.issues.append(
            issue("WEIGHTS_UNNORMALISED", path, f"at {np.count_nonzero(off > 1e-3)} points, by up to {off.max():.3g}")
        )


# --- blend shapes ------------------------------------------------------------------------------------


def _shapes(prim: Usd.Prim, binding: Binding | None, count: int, found: Found) -> tuple[Shape, ...]:
    api = UsdSkel.BindingAPI(prim)
    tokens = [str(token) for token in api.GetBlendShapesAttr().Get() or ()]
    if not tokens and not api.GetBlendShapeTargetsRel().HasAuthoredTargets():
        return ()
    path = str(prim.GetPath())
    targets = api.GetBlendShapeTargetsRel().GetTargets()
    if len(tokens) != len(targets):
        raise refuse(
            "TARGETS_LENGTH", path, f"{len(tokens)} skel:blendShapes but {len(targets)} skel:blendShapeTargets"
        )
    if binding is None:
        found.issues.append(issue("MESH_UNBOUND", path, f"has {len(tokens)} blend shapes"))
        found.shapeless.update(dict.fromkeys(tokens, f"no Skeleton is bound to {path}"))
        return ()
    found.issues.extend(repeated(tokens, path, "skel:blendShapes"))
    shapes = []
    for token, target in dict(zip(tokens, targets, strict=True)).items():
        shape = _shape(prim.GetStage(), token, target, binding.armature, count, found)
        if shape is not None:
            shapes.append(shape)
    return tuple(shapes)


def _shape(
    stage: Usd.Stage, token: str, target: Sdf.Path, armature: Armature, count: int, found: Found
) -> Shape | None:
    prim, path = stage.GetPrimAtPath(target), str(target)
    if not prim or not prim.IsActive() or not prim.IsA(UsdSkel.BlendShape):
        found.issues.append(issue("TARGET_INVALID", path, f"is the target of {token!r}"))
        found.shapeless[token] = f"its target {path} is not an active BlendShape"
        return None
    offsets = _offsets(prim.GetAttribute("offsets").Get(), path, "offsets")
    indices = prim.GetAttribute("pointIndices").Get()
    between = _inbetweens(prim, found)
    size = len(indices) if indices is not None and len(indices) else count
    for name, array in (("offsets", offsets), *((f"inbetweens:{w:g}", o) for w, o in between)):
        if len(array) not in (0, size):
            what = "pointIndices" if size != count or (indices is not None and len(indices)) else "points"
            raise refuse("OFFSETS_LENGTH", path, f"{len(array)} {name} for {size} {what}")
    if not len(offsets) and not any(len(each) for _, each in between):
        found.shapeless[token] = f"its shape {path} has no offsets"
        return None
    return _assembled(_channel(token, armature, found), path, indices, offsets, between, size, count)


def _assembled(
    channel: int,
    path: str,
    indices: Any,
    offsets: Singles,
    between: list[tuple[float, Singles]],
    size: int,
    count: int,
) -> Shape:
    """A Shape with its rows in the order of weight and its points ascending and unique."""
    rows = sorted([(1.0, offsets), *between], key=lambda row: row[0])
    empty = np.zeros((size, 3), dtype=np.float32)
    table = np.stack([each if len(each) else empty for _, each in rows]) if between else offsets[None]
    if indices is None or not len(indices):
        points = np.flatnonzero(table.any(axis=(0, 2)))
        table = table if len(points) == count else table[:, points]
    else:
        points = _integers(indices, path, "pointIndices")
        if (points[1:] <= points[:-1]).any():
            points, table = _merged(points, table)
        if points[0] < 0 or points[-1] >= count:
            _check_range(points, count, path, "pointIndices")
    return Shape(channel, path, np.array([weight for weight, _ in rows]), points, table)


def _merged(points: Indices, table: Singles) -> tuple[Indices, Singles]:
    """Points ascending and unique; offsets of a repeated point add up, as in UsdSkel."""
    unique, place = np.unique(points, return_inverse=True)
    merged = np.zeros((len(table), len(unique), 3), dtype=np.float32)
    for row, offsets in zip(merged, table, strict=True):
        np.add.at(row, place, offsets)
    return unique, merged


def _inbetweens(prim: Usd.Prim, found: Found) -> list[tuple[float, Singles]]:
    """Weight and offsets of each in-between that UsdSkel would use."""
    if not any(name.startswith("inbetweens:") for name in prim.GetPropertyNames()):
        return []
    path, taken, between = str(prim.GetPath()), {0.0, 1.0}, []
    for each in UsdSkel.BlendShape(prim).GetInbetweens():
        weight, name = each.GetWeight(), each.GetAttr().GetName()
        if weight is None or not np.isfinite(weight) or any(abs(weight - other) < 1e-6 for other in taken):
            found.issues.append(issue("INBETWEEN_INVALID", path, f"{name} has weight {weight}"))
            continue
        taken.add(float(weight))
        between.append((float(weight), _offsets(each.GetOffsets(), path, name)))
    return between


def _channel(token: str, armature: Armature, found: Found) -> int:
    """Index of the weight that drives a token under a Skeleton; a new one if no animation lists it."""
    key = (token, armature.record.animation)
    if key in found.tokens:
        return found.tokens[key]
    return found.tokens.setdefault((token, ""), len(found.tokens))


def _note_tokens(prim: Usd.Prim, found: Found, reason: str) -> None:
    for token in UsdSkel.BindingAPI(prim).GetBlendShapesAttr().Get() or ():
        found.shapeless[str(token)] = reason


def left_off_tokens(found: Found, used: set[int]) -> tuple[LeftOff, ...]:
    """Tokens that no mesh implements, with the reason."""
    shaped = {token for (token, _), channel in found.tokens.items() if channel in used}
    names = dict.fromkeys([*(token for token, _ in found.tokens), *found.shapeless])
    return tuple(
        LeftOff(name, "read", found.shapeless.get(name, "no mesh has a shape for it"))
        for name in names
        if name not in shaped
    )


# --- arrays ------------------------------------------------------------------------------------------


def _value(attribute: Any, time: Usd.TimeCode) -> Any:
    """The value at a time; the earliest sample where there is no default."""
    value = attribute.Get(time)
    return attribute.Get(Usd.TimeCode.EarliestTime()) if value is None else value


def _integers(values: Any, path: str, name: str) -> Indices:
    if values is None:
        return np.zeros(0, dtype=np.int64)
    numbers = _numbers(values, path, name)
    if numbers.dtype.kind not in "iu":
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold integers")
    return numbers.astype(np.int64)


def _floats(values: Any, path: str, name: str) -> NDArray[Any]:
    numbers = _numbers(values, path, name)
    return numbers if numbers.dtype.kind == "f" else numbers.astype(np.float64)


def _vectors(values: Any, path: str, name: str) -> NDArray[Any]:
    """(p, 3) finite numbers, without a copy where they are in single precision already."""
    vectors = _floats(values, path, name)
    if vectors.size % 3:
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold 3-vectors")
    vectors = vectors.reshape(-1, 3)
    _check_finite(vectors, path, name)
    return vectors


def _numbers(values: Any, path: str, name: str) -> NDArray[Any]:
    """A numeric array; arrays of USD are viewed, not copied."""
    numbers = np.asarray(() if values is None else values)
    if numbers.dtype.kind not in "fiu":
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold numbers")
    return numbers


def _offsets(values: Any, path: str, name: str) -> Singles:
    return _vectors(values, path, name).astype(np.float32, copy=False)


def _check_finite(values: NDArray[np.floating], path: str, name: str) -> None:
    # One pass without a temporary; only a sum that is not finite calls for a closer look.
    flat = values.reshape(-1)
    if not np.isfinite(flat @ flat) and not np.isfinite(flat).all():
        where = int(np.flatnonzero(~np.isfinite(values).reshape(len(values), -1).all(axis=1))[0])
        raise refuse("NOT_FINITE", path, f"{name}[{where}] is not a finite number")


def _check_range(indices: Indices, count: int, path: str, name: str) -> None:
    if len(indices) and (indices.min() < 0 or indices.max() >= count):
        wrong = indices[(indices < 0) | (indices >= count)][0]
        raise refuse("INDEX_RANGE", path, f"{name} holds {wrong}; only 0 to {count - 1} exist")
