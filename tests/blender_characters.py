"""Characters with layouts for Blender, and where USD says that their points are in Blender's world."""

from __future__ import annotations

import laid_out
import numpy as np
import skinned_stages
from pxr import Sdf, Usd, UsdGeom
from usdskel_oracle import Oracle

from usdrigui.deform import channel_state
from usdrigui.settings import OutputSettings, Settings
from usdrigui.usd.layer import stage_metadata, write_layout
from usdrigui.usd.rig import read_rigs

Z_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""Row-vector map from Y up to Z up."""


def written(source, **options):
    """Lay a character out at random points; returns (layer, rig, layout)."""
    (rig,) = read_rigs(source, Settings())
    layout = laid_out.layout_of(rig, **options)
    target = source.with_name(f"{source.stem}.rigui.usda")
    write_layout([(rig, layout)], source, target, OutputSettings(), stage_metadata(Sdf.Layer.FindOrOpen(str(source))))
    return target, rig, layout


def skinned(folder, name, **kind):
    """One of the small, nasty skinned characters, laid out."""
    return written(skinned_stages.character(folder / f"{name}.usda", **kind))


def to_world(source, rig):
    """Function from root space to Blender's world: metres, Z up."""
    stage = Usd.Stage.Open(str(source))
    matrix = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(stage.GetPrimAtPath(rig.root)))
    turn = Z_UP if UsdGeom.GetStageUpAxis(stage) == "Y" else np.eye(3)
    size = UsdGeom.GetStageMetersPerUnit(stage)
    return lambda points: size * ((np.asarray(points) @ matrix[:3, :3] + matrix[3, :3]) @ turn)


def usdskel_points(source, rig, values):
    """By mesh path, UsdSkel's points in root space at control values."""
    points = Oracle(source, rig).deformed(*channel_state(rig, values))
    bounds = zip(rig.meshes, rig.starts[:-1], rig.starts[1:], strict=True)
    return {mesh.path: points[start:end] for mesh, start, end in bounds}


def diagonal(points):
    """Length of the diagonal of the box around all points."""
    return float(np.linalg.norm(np.ptp(np.concatenate(list(points)), axis=0)))
