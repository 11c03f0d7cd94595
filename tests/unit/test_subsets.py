"""GeomSubsets: read with the mesh, and good for keeping a control in its place."""

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, UsdSkel, Vt

from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings, load


@pytest.fixture
def asset(tmp_path):
    """A strip of four quads with one shape, a subset of faces and one of points."""
    stage = Usd.Stage.CreateNew(str(tmp_path / "strip.usda"))
    root = UsdSkel.Root.Define(stage, "/Root")
    stage.SetDefaultPrim(root.GetPrim())
    UsdSkel.Skeleton.Define(stage, "/Root/skel")
    mesh = UsdGeom.Mesh.Define(stage, "/Root/mesh")
    points = np.array([[x, y, 0.0] for y in (0.0, 1.0) for x in range(5)], dtype=np.float32)
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points))
    mesh.CreateFaceVertexCountsAttr([4] * 4)
    mesh.CreateFaceVertexIndicesAttr([i for f in range(4) for i in (f, f + 1, f + 6, f + 5)])
    shape = UsdSkel.BlendShape.Define(stage, "/Root/mesh/up")
    shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(np.tile(np.float32([0, 0, 1]), (10, 1))))
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets(["/Root/skel"])
    binding.CreateBlendShapesAttr(["up"])
    binding.CreateBlendShapeTargetsRel().SetTargets(["/Root/mesh/up"])
    anim = UsdSkel.Animation.Define(stage, "/Root/anim")
    anim.CreateBlendShapesAttr(["up"])
    anim.CreateBlendShapeWeightsAttr([0.0])
    UsdSkel.BindingAPI.Apply(stage.GetPrimAtPath("/Root/skel")).CreateAnimationSourceRel().SetTargets(
        [Sdf.Path("/Root/anim")]
    )
    UsdGeom.Subset.CreateGeomSubset(mesh, "end", UsdGeom.Tokens.face, Vt.IntArray([3, 4]))
    UsdGeom.Subset.CreateGeomSubset(mesh, "corner", UsdGeom.Tokens.point, Vt.IntArray([9, 4, -1, 10]))
    UsdGeom.Subset.CreateGeomSubset(mesh, "nothing", UsdGeom.Tokens.face, Vt.IntArray([]))
    stage.Save()
    return tmp_path / "strip.usda"


def test_subsets_are_read_with_the_points_of_their_faces(asset):
    (rig,) = read_rigs(asset, Settings())
    found = {subset.path: subset.points.tolist() for subset in rig.body.meshes[0].topology.subsets}
    assert found == {"/Root/mesh/end": [3, 4, 8, 9], "/Root/mesh/corner": [4, 9]}


def test_a_control_can_be_kept_near_a_subset(asset):
    import chain

    (rig,) = read_rigs(asset, Settings())
    near = {"near": "/Root/mesh/end", "within": 0.01}
    said = load({"controls": {"up": near}, "candidates": {"occlusion": False, "board_global": False}})
    assert chain.problem_of(rig, said).candidates.sets[0].points.tolist() == [3, 4, 8, 9]
