"""GeomSubsets: read with the mesh, and good for keeping a control in its place."""

import pytest
from pxr import UsdGeom, UsdSkel
from skel_stages import head

from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings, load


@pytest.fixture
def asset(tmp_path):
    """A mesh with one shape, a subset of faces and one of points."""

    def divided(stage):
        mesh = UsdGeom.Mesh.Get(stage, "/Char/Face")
        UsdSkel.BlendShape.Get(stage, "/Char/Face/s_up").GetOffsetsAttr().Set([(0, 0, 1)] * 25)
        for name, kind, indices in (
            ("end", "face", [3, 99]),
            ("corner", "point", [9, 4, -1, 99]),
            ("nothing", "face", []),
        ):
            UsdGeom.Subset.CreateGeomSubset(mesh, name, kind, indices)

    return head(tmp_path / "char.usda", ("up",), divided)


def test_subsets_are_read_with_the_points_of_their_faces(asset):
    (rig,) = read_rigs(asset, Settings())
    found = {subset.path: subset.points.tolist() for subset in rig.body.meshes[0].topology.subsets}
    assert found == {"/Char/Face/end": [3, 4, 8, 9], "/Char/Face/corner": [4, 9]}


def test_a_control_can_be_kept_near_a_subset(asset):
    import chain

    (rig,) = read_rigs(asset, Settings())
    near = {"near": "/Char/Face/end", "within": 0.01}
    said = load({"controls": {"up": near}, "candidates": {"occlusion": False, "board_global": False}})
    assert chain.problem_of(rig, said).candidates.sets[0].points.tolist() == [3, 4, 8, 9]
