"""Shots over a character: layers that add corrective shapes to one of its meshes, and to nothing else."""

from __future__ import annotations

from pathlib import Path

import makers
import numpy as np
from pxr import Sdf, Usd, UsdGeom, UsdSkel, Vt

from usdrigui.layer.read_layout import element_prims, layout_scopes


def shot(path: Path, asset: str, mesh: str, shapes: dict[str, tuple], *, at: str = "", root: str = "/World") -> Path:
    """A shot that sublayers `asset`, or references it at the path `at`, and adds `shapes` to `mesh`.

    `mesh` is its path in the shot, `root` the asset's prim to reference; each shape is (centre, direction, radius,
    amount) of a bump.
    """
    stage = Usd.Stage.CreateNew(str(path))
    if at:
        stage.DefinePrim(at).GetReferences().AddReference(asset, root)
    else:
        stage.GetRootLayer().subLayerPaths.append(asset)
        stage.SetDefaultPrim(stage.GetPrimAtPath(root))
        UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
        UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    prim = stage.GetPrimAtPath(mesh)
    points = np.array(UsdGeom.Mesh(prim).GetPointsAttr().Get(), dtype=np.float64)
    for name, (centre, direction, radius, amount) in shapes.items():
        _add(stage, prim, name, makers.bump(points, centre, direction, radius, amount))
    stage.GetRootLayer().Save()
    return path


def _add(stage: Usd.Stage, prim: Usd.Prim, name: str, offsets: np.ndarray) -> None:
    moving = np.flatnonzero(np.abs(offsets).max(axis=1) > 0.0)
    made = UsdSkel.BlendShape.Define(stage, prim.GetPath().AppendChild(name))
    made.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(offsets[moving].astype(np.float32)))
    made.CreatePointIndicesAttr(Vt.IntArray.FromNumpy(moving.astype(np.int32)))
    binding = UsdSkel.BindingAPI(prim)
    binding.GetBlendShapesAttr().Set([*binding.GetBlendShapesAttr().Get(), name])
    binding.GetBlendShapeTargetsRel().AddTarget(made.GetPath(), Usd.ListPositionBackOfAppendList)
    for each in stage.Traverse():
        if each.IsA(UsdSkel.Animation):
            animation = UsdSkel.Animation(each)
            animation.GetBlendShapesAttr().Set([*animation.GetBlendShapesAttr().Get(), name])
            weights = animation.GetBlendShapeWeightsAttr()
            times = weights.GetTimeSamples() or [Usd.TimeCode.Default()]
            rows = [[*(weights.Get(time) or ()), 0.0] for time in times]  # all, before this layer speaks of any
            for time, row in zip(times, rows, strict=True):
                weights.Set(row, time)


def take(path: Path, moves: dict[str, np.ndarray], prim: str = "/Take") -> Usd.Stage:
    """A file with one SkelAnimation at `prim`: a column of weights, one per time code, for each blend shape."""
    stage = Usd.Stage.CreateNew(str(path))
    animation = UsdSkel.Animation.Define(stage, prim)
    animation.CreateBlendShapesAttr(list(moves))
    for time, row in enumerate(np.stack(list(moves.values()), axis=1)):
        animation.CreateBlendShapeWeightsAttr().Set(Vt.FloatArray.FromNumpy(row.astype(np.float32)), time)
    stage.GetRootLayer().Save()
    return stage


def layout_prims(stage: Usd.Stage) -> list[Sdf.Path]:
    """Elements of the layouts on a stage."""
    return [prim.GetPath() for scope in layout_scopes(stage) for prim in element_prims(scope)]
