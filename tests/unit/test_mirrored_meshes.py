"""Faces of meshes that a transform mirrors (USD's scale of -1) look outward all the same, as a renderer shows them."""

import numpy as np
import pytest
from pxr import UsdGeom
from skel_stages import add_even_skin, add_mesh, add_shape, add_skeleton, matrix, new_stage

from usdrigui.character import surface
from usdrigui.character.deform import deform
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load

MIRROR, BOTH = matrix(scale=(-1, 1, 1)), matrix(scale=(-1, -1, 1))


def towards(tmp_path, *, mesh=None, skeleton=None, geom_bind=None, skinned=False, turned=False):
    """Mean normal, along +z of root space, of a sheet whose faces are counter-clockwise seen from there."""
    stage, _ = new_stage(tmp_path / "char.usda")
    joints = ("all",) if skinned else ()
    add_skeleton(stage, "/Char/Skel", joints, [matrix()] * len(joints), transform=skeleton)
    sheet = add_mesh(stage, "/Char/Face", "/Char/Skel", transform=mesh)
    add_shape(sheet, "smile")
    if skinned:
        add_even_skin(sheet, 1, geom_bind)
    if turned:
        sheet.CreateOrientationAttr(UsdGeom.Tokens.leftHanded)
    stage.GetRootLayer().Save()
    (rig,) = read_rigs(tmp_path / "char.usda", load({}))
    points, corners = deform(rig), surface.mesh_triangles(rig.body.meshes)
    return float(surface.vertex_normals(points, corners, np.arange(len(points)))[:, 2].mean())


@pytest.mark.parametrize(
    "how",
    [
        {},
        {"mesh": MIRROR},
        {"mesh": BOTH},
        {"skinned": True},
        {"skinned": True, "skeleton": MIRROR},
        {"skinned": True, "geom_bind": MIRROR},
        {"skinned": True, "geom_bind": MIRROR, "skeleton": MIRROR},
        {"skinned": True, "mesh": MIRROR},  # a skinned mesh goes by its Skeleton
    ],
)
def test_faces_look_outward_however_a_mesh_is_mirrored(tmp_path, how):
    assert towards(tmp_path, **how) > 0.5
    assert towards(tmp_path, **how, turned=True) < -0.5
