"""An asset as studios build them: an entry with a payload, levels of detail and costumes as variants, rigid parts as
instances, proxies; and a shot of three such characters."""

from __future__ import annotations

from pathlib import Path

import makers
import numpy as np
import skel_stages
from pxr import Gf, Kind, Usd, UsdGeom, UsdSkel, Vt

LEVELS = {"high": (33, 41), "mid": (21, 25), "low": (13, 15)}
"""Columns and rows of the face of each level; the level ``box`` has no face."""


def asset(folder: Path, name: str = "char") -> Path:
    """``char.usda``: /Char, whose payload brings the variant sets LOD (high, mid, low, box) and costume."""
    for level, size in LEVELS.items():
        _level(folder / f"{name}_{level}.usda", *size)
    _eye(folder / f"{name}_eye.usda")
    inner = Usd.Stage.CreateNew(str(folder / f"{name}_payload.usda"))
    root = _root(inner)
    levels = root.GetVariantSets().AddVariantSet("LOD")
    for level in (*LEVELS, "box"):
        levels.AddVariant(level)
        levels.SetVariantSelection(level)
        with levels.GetVariantEditContext():
            if level in LEVELS:
                root.GetReferences().AddReference(f"./{name}_{level}.usda")
            else:
                UsdGeom.Cube.Define(inner, "/Char/Box")
    costumes = root.GetVariantSets().AddVariantSet("costume")
    for costume in ("plain", "mask"):
        costumes.AddVariant(costume)
    costumes.SetVariantSelection("mask")
    with costumes.GetVariantEditContext():
        prop = UsdGeom.Mesh.Define(inner, "/Char/Mask")
        _quad(prop, 0.2, (0.0, 2.0, 0.0))
    costumes.ClearVariantSelection()
    levels.ClearVariantSelection()
    _parts(inner, name)
    inner.Save()
    entry = Usd.Stage.CreateNew(str(folder / f"{name}.usda"))
    root = _root(entry)
    root.GetPayloads().AddPayload(f"./{name}_payload.usda")
    root.GetVariantSet("LOD").SetVariantSelection("high")
    root.GetVariantSet("costume").SetVariantSelection("plain")
    entry.Save()
    return folder / f"{name}.usda"


def shot(path: Path, layout: str) -> Path:
    """Three of them: one as it is, one of a lower level, and one with a mesh hidden and animated."""
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    UsdGeom.Xform.Define(stage, "/Shot")
    for number, name in enumerate(("hero", "friend", "crowd")):
        prim = stage.DefinePrim(f"/Shot/{name}")
        prim.GetReferences().AddReference(layout)
        UsdGeom.XformCommonAPI(prim).SetTranslate((4.0 * number, 0.0, 0.0))
    stage.GetPrimAtPath("/Shot/friend").GetVariantSet("LOD").SetVariantSelection("low")
    weights = UsdSkel.Animation(stage.GetPrimAtPath("/Shot/crowd/Anim")).GetBlendShapeWeightsAttr()
    for time in (1.0, 12.0):
        weights.Set([0.5 * (time > 1.0)] * len(weights.Get()), time)
    stage.Save()
    return path


def _root(stage: Usd.Stage) -> Usd.Prim:
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    root = UsdSkel.Root.Define(stage, "/Char").GetPrim()
    stage.SetDefaultPrim(root)
    Usd.ModelAPI(root).SetKind(Kind.Tokens.component)
    return root


def _level(path: Path, columns: int, rows: int) -> None:
    """One level of detail: the face, its skeleton and its animation."""
    stage = Usd.Stage.CreateNew(str(path))
    _root(stage)
    points, quads = makers.mask(columns, rows)
    shapes = makers.face_shapes(points)
    UsdGeom.Xform.Define(stage, "/Char/Geo")
    mesh = UsdGeom.Mesh.Define(stage, "/Char/Geo/face")
    mesh.CreatePointsAttr(_vectors(points))
    mesh.CreateFaceVertexCountsAttr([4] * len(quads))
    mesh.CreateFaceVertexIndicesAttr([point for quad in quads for point in quad])
    mesh.CreateSubdivisionSchemeAttr("none")
    for name, offsets in shapes.items():
        skel_stages.add_shape(mesh, name, offsets)
    skel_stages.add_skin(mesh, [0], [1.0], 1, rigid=True)
    skeleton = skel_stages.add_skeleton(stage, "/Char/Skel", ["Head"], [Gf.Matrix4d(1)])
    skel_stages.add_animation(stage, "/Char/Anim", "/Char/Skel", list(shapes))
    UsdSkel.BindingAPI.Apply(stage.GetPrimAtPath("/Char")).CreateSkeletonRel().SetTargets([skeleton.GetPath()])
    stage.Save()


def _parts(stage: Usd.Stage, name: str) -> None:
    """Two eyes, instances of one file that follow the head rigidly, and a proxy beside what is rendered."""
    UsdGeom.Xform.Define(stage, "/Char/Eyes")
    for side, sign in (("L", 1.0), ("R", -1.0)):
        eye = UsdGeom.Xform.Define(stage, f"/Char/Eyes/{side}")
        eye.GetPrim().GetReferences().AddReference(f"./{name}_eye.usda")
        eye.GetPrim().SetInstanceable(True)
        UsdGeom.XformCommonAPI(eye).SetTranslate((0.35 * sign, 0.3, 0.45))
        skel_stages.add_skin(eye, [0], [1.0], 1, rigid=True)
    proxy = UsdGeom.Mesh.Define(stage, "/Char/Proxy")
    _quad(proxy, 1.0, (0.0, 0.0, 0.7))
    proxy.CreatePurposeAttr(UsdGeom.Tokens.proxy)


def _eye(path: Path) -> None:
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.Xform.Define(stage, "/Eye")
    stage.SetDefaultPrim(stage.GetPrimAtPath("/Eye"))
    _quad(UsdGeom.Mesh.Define(stage, "/Eye/ball"), 0.08, (0.0, 0.0, 0.0))
    stage.Save()


def _quad(mesh: UsdGeom.Mesh, size: float, centre: tuple[float, float, float]) -> None:
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * size + np.array(centre)
    mesh.CreatePointsAttr(_vectors(corners))
    mesh.CreateFaceVertexCountsAttr([4])
    mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3])
    mesh.CreateSubdivisionSchemeAttr("none")


def _vectors(rows: object) -> Vt.Vec3fArray:
    return Vt.Vec3fArray.FromNumpy(np.asarray(rows, dtype=np.float32))


def add_shape(path: Path, above: str) -> None:
    """A shot gives one of its characters a shape of its own, as the last one."""
    stage = Usd.Stage.Open(str(path))
    mesh = stage.GetPrimAtPath(f"{above}/Geo/face")
    points = np.array(mesh.GetAttribute("points").Get())
    shape = UsdSkel.BlendShape.Define(stage, mesh.GetPath().AppendChild("crease"))
    shape.CreateOffsetsAttr(_vectors(makers.bump(points, (0.0, 0.75), (0.0, 0.5, 1.0))))
    binding = UsdSkel.BindingAPI(mesh)
    tokens = [*binding.GetBlendShapesAttr().Get(), "crease"]
    binding.GetBlendShapesAttr().Set(tokens)
    binding.GetBlendShapeTargetsRel().AddTarget(shape.GetPath(), Usd.ListPositionBackOfAppendList)
    animation = UsdSkel.Animation(stage.GetPrimAtPath(f"{above}/Anim"))
    animation.GetBlendShapesAttr().Set(tokens)
    animation.GetBlendShapeWeightsAttr().Set([0.0] * len(tokens))
    stage.Save()
