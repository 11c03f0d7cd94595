"""Small characters written as USD stages, for tests of the layer: every way in which UsdSkel moves a point."""

from __future__ import annotations

from pathlib import Path

import makers
import numpy as np
from pxr import Gf, Usd, UsdGeom, UsdSkel, Vt

from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

JOINTS = ("Hips", "Hips/Head", "Hips/Head/Jaw", "Hips/Head/Eye")
_PLACES = {
    "Hips": (0, -3, 0),
    "Hips/Head": (0, 2, -0.3),
    "Hips/Head/Jaw": (0, -0.2, 0.2),
    "Hips/Head/Eye": (0.3, 0.4, 0.4),
}


def character(
    path: Path,
    *,
    method: str = "classicLinear",
    skinned: bool = True,
    left_handed: bool = False,
    reordered: bool = False,
    moved: float = 0,
    meshes: int = 1,
    animated_joints: tuple[str, ...] = (),
    hinged: bool = False,
    rigid: bool = False,
) -> Path:
    """A mask of a face with dense, sparse, in-between and signed shapes on a skeleton of four joints.

    `reordered` gives meshes and animation joint orders of their own; `moved` puts transforms, a
    geomBindTransform and a rest pose unlike the bind pose everywhere, and makes the rest pose so
    many times as large; the second mesh, if any, shares tokens with the first; `hinged` skins every
    point to head and jaw alone; `rigid` gives all points the influences of the first.
    """
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    stage.SetTimeCodesPerSecond(30)
    root = UsdSkel.Root.Define(stage, "/World/Char")
    stage.SetDefaultPrim(stage.GetPrimAtPath("/World"))
    skeleton = _skeleton(stage, moved)
    tokens = _animation(stage, skeleton, reordered, animated_joints)
    rng = np.random.default_rng(7)
    for index in range(meshes):
        _mesh(
            stage,
            f"/World/Char/face{index}",
            index,
            tokens,
            rng,
            method,
            skinned,
            left_handed,
            reordered,
            moved,
            hinged,
            rigid,
        )
    if moved:
        UsdGeom.XformCommonAPI(root).SetTranslate((5, 1, -2))
    stage.Save()
    return path


def keyed(stage: Usd.Stage, rows: dict[float, dict[str, float]]) -> None:
    """Give the animation of a character, by time code, the weights of some shapes, and zero to the others."""
    animation = UsdSkel.Animation(stage.GetPrimAtPath("/World/Char/Anim"))
    for time, row in rows.items():
        weights = [row.get(token, 0.0) for token in animation.GetBlendShapesAttr().Get()]
        animation.GetBlendShapeWeightsAttr().Set(weights, time)


def _skeleton(stage: Usd.Stage, moved: float) -> UsdSkel.Skeleton:
    skeleton = UsdSkel.Skeleton.Define(stage, "/World/Char/Skel")
    local = [Gf.Matrix4d().SetTranslate(_PLACES[joint]) for joint in JOINTS]
    bind = []
    for joint, matrix in zip(JOINTS, local, strict=True):
        parent = joint.rpartition("/")[0]
        bind.append(matrix * bind[JOINTS.index(parent)] if parent else matrix)
    if moved:
        UsdGeom.XformCommonAPI(skeleton).SetRotate((10, 20, 30))
        UsdGeom.XformCommonAPI(skeleton).SetTranslate((0.5, 0, 0.25))
        local[0] = Gf.Matrix4d().SetScale(moved) * local[0]
        local[2] = Gf.Matrix4d().SetRotate(Gf.Rotation((1, 0, 0), 12)) * local[2]
    skeleton.CreateJointsAttr(JOINTS)
    skeleton.CreateBindTransformsAttr(bind)
    skeleton.CreateRestTransformsAttr(local)
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets(["/World/Char/Anim"])
    return skeleton


def _animation(stage: Usd.Stage, skeleton: UsdSkel.Skeleton, reordered: bool, animated: tuple[str, ...]) -> list[str]:
    animation = UsdSkel.Animation.Define(stage, "/World/Char/Anim")
    points, _ = makers.mask(9, 11)
    tokens = [*makers.face_shapes(points), "half", "jaw:open"]
    animation.CreateBlendShapesAttr(tokens[::-1] if reordered else tokens)
    animation.CreateBlendShapeWeightsAttr([0.0] * len(tokens))
    joints = JOINTS[::-1] if reordered else JOINTS
    animation.CreateJointsAttr(joints)
    rest = dict(zip(JOINTS, skeleton.GetRestTransformsAttr().Get(), strict=True))
    for time in (1.0, 10.0, 20.0):
        local = []
        for joint in joints:
            turn = 25.0 * np.sin(time / 3.0) if joint in animated and time > 1.0 else 0.0
            local.append(Gf.Matrix4d().SetRotate(Gf.Rotation((1, 0.3, 0), float(turn))) * rest[joint])
        animation.SetTransforms(Vt.Matrix4dArray(local), time)
    return tokens


def _mesh(stage, path, index, tokens, rng, method, skinned, left_handed, reordered, moved, hinged, rigid):
    points, quads = makers.mask(9, 11)
    shapes = makers.face_shapes(points)
    mesh = UsdGeom.Mesh.Define(stage, path)
    order = [quad[::-1] if left_handed else quad for quad in quads]
    # Each lies behind the one before, which it would hide otherwise.
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points.astype(np.float32) - np.float32([0, 0, 0.1 * index])))
    mesh.CreateFaceVertexCountsAttr([4] * len(quads))
    mesh.CreateFaceVertexIndicesAttr([point for quad in order for point in quad])
    mesh.CreateSubdivisionSchemeAttr("none")
    if left_handed:
        mesh.CreateOrientationAttr("leftHanded")
    if moved:
        UsdGeom.XformCommonAPI(mesh).SetTranslate((0.3, -0.2, 0.1))
        UsdGeom.XformCommonAPI(mesh).SetRotate((0, 5 + 5 * index, 0))
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets(["/World/Char/Skel"])
    if skinned:
        _influences(binding, rng, len(points), method, reordered, moved, hinged, rigid)
    _shapes(stage, path, binding, tokens if index == 0 else tokens[::2], shapes, points)


def _influences(binding, rng, count, method, reordered, moved, hinged, rigid):
    joints = list(JOINTS[::-1] if reordered else JOINTS)
    if reordered:
        binding.CreateJointsAttr(joints)
    weights = rng.dirichlet(np.ones(3), size=count).astype(np.float32)
    order = np.argsort(rng.random((count, 4)), axis=1)[:, :3].astype(np.int32)
    if hinged:
        order[:] = [joints.index(JOINTS[i]) for i in (1, 2, 1)]
    if rigid:
        order, weights = order[:1], weights[:1]
    binding.CreateJointIndicesPrimvar(rigid, 3).Set(Vt.IntArray.FromNumpy(order.ravel()))
    binding.CreateJointWeightsPrimvar(rigid, 3).Set(Vt.FloatArray.FromNumpy(weights.ravel()))
    binding.CreateGeomBindTransformAttr(
        Gf.Matrix4d().SetRotate(Gf.Rotation((0, 1, 0), 15)) * Gf.Matrix4d().SetTranslate((0.1, 0.2, 0))
        if moved
        else Gf.Matrix4d(1)
    )
    binding.CreateSkinningMethodAttr(method)


def _shapes(stage, path, binding, tokens, shapes, points):
    binding.CreateBlendShapesAttr(tokens)
    targets = []
    for token in tokens:
        name = token.replace(":", "_")
        shape = UsdSkel.BlendShape.Define(stage, f"{path}/{name}")
        targets.append(shape.GetPath())
        if token == "half":
            full = makers.bump(points, (0.0, 0.2), (0, 1, 0.5), 0.5, 0.2)
            shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(full.astype(np.float32)))
            for weight, way in ((0.5, (1, 0.2, 0)), (-0.4, (-1, 0, 0))):
                between = makers.bump(points, (0.0, 0.2), way, 0.5, 0.1)
                made = shape.CreateInbetween(f"at{int(weight * 10)}".replace("-", "m"))
                made.SetWeight(weight)
                made.SetOffsets(Vt.Vec3fArray.FromNumpy(between.astype(np.float32)))
            continue
        offsets = shapes.get(token, makers.bump(points, (0, -0.6), (0, -1, 0.1), 0.6, 0.2))
        moving = np.flatnonzero(np.abs(offsets).max(axis=1) > 0.0)
        if len(token) % 2:
            shape.CreatePointIndicesAttr(Vt.IntArray.FromNumpy(moving.astype(np.int32)))
            offsets = offsets[moving]
        shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(offsets.astype(np.float32)))
    binding.CreateBlendShapeTargetsRel().SetTargets(targets)


def read(folder, settings=None, **kind):
    """Such a character in a folder, and its rig."""
    source = character(folder / "char.usda", **kind)
    (rig,) = read_rigs(source, settings or Settings())
    return source, rig
