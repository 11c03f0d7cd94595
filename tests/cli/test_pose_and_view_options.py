"""`usdrigui process` with --time, --view and --space: what the written layer then holds."""

import laid_out
import numpy as np
import pytest
import skinned_stages
from laid_out import on_face
from pxr import Gf, Usd, UsdGeom, UsdSkel
from scipy.spatial.distance import pdist

from usdrigui.cli import main
from usdrigui.cli.parser import parsed
from usdrigui.layer.read_layout import read_layout

JAW = "Hips/Head/Jaw"


@pytest.fixture(scope="module")
def character(tmp_path_factory):
    """A character whose jaw turns and whose shapes open between frames 1 and 20, and a camera on its left."""
    path = skinned_stages.character(tmp_path_factory.mktemp("posed") / "char.usda", animated_joints=(JAW,))
    stage = Usd.Stage.Open(str(path))
    skinned_stages.keyed(stage, {1.0: {}, 20.0: {"chin": 0.4, "brow_L": 0.4}})
    camera = UsdGeom.Camera.Define(stage, "/World/Cam")
    camera.AddTransformOp().Set(Gf.Matrix4d().SetLookAt((9, 1, 0), (0, 0, 0), (0, 1, 0)).GetInverse())
    stage.Save()
    return path


def processed(character, tmp_path, *arguments):
    """The layout in the layer that the command writes, and the stage of that layer."""
    # A name of its own: USD keeps layers that are open.
    target = tmp_path / f"layout{len(list(tmp_path.iterdir()))}.usda"
    assert main(["process", str(character), "-o", str(target), "--quiet", *arguments]) == 0
    stage = Usd.Stage.Open(str(target))
    (layout,) = read_layout(stage)
    return layout, stage


def test_a_time_is_the_base_pose_and_elements_rest_where_it_puts_them(character, tmp_path):
    layout, stage = processed(character, tmp_path, "--time", "20")
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath(layout.root)))
    elements = on_face(layout)
    assert len(elements) >= 8
    moved = 0.0
    for element in elements:
        there = laid_out.root_points(stage, element.anchor.mesh, layout.root, 20.0)[element.anchor.point]
        rest = laid_out.root_points(stage, element.anchor.mesh, layout.root, 1.0)[element.anchor.point]
        assert np.abs(element.anchor.position - there).max() < 1e-5
        moved = max(moved, float(np.linalg.norm(there - rest)))
    assert moved > 0.02
    values = dict(zip(layout.listed, layout.base_values.tolist(), strict=True))
    assert values["chin"] == values["brow_L"] == pytest.approx(0.4)
    assert values["smile_L"] == 0.0


def test_without_a_time_they_rest_in_the_neutral_pose(character, tmp_path):
    layout, _ = processed(character, tmp_path)
    assert dict(zip(layout.listed, layout.base_values.tolist(), strict=True))["chin"] == 0.0


@pytest.mark.parametrize(
    ("view", "toward"), [("side", (1, 0, 0)), ("90,0", (1, 0, 0)), ("/World/Cam", (9 / 82**0.5, 1 / 82**0.5, 0))]
)
def test_a_view_is_recorded_and_only_what_it_sees_holds_elements(character, tmp_path, view, toward):
    layout, _ = processed(character, tmp_path, "--view", view)
    assert layout.frame.view == pytest.approx(np.array(toward), abs=1e-5)
    elements = on_face(layout)
    assert elements
    front, _ = processed(character, tmp_path, "--view", "front")
    assert all(element.anchor.position[0] > -0.1 for element in elements)
    assert len(elements) < len(layout.elements), "what it does not see stands on the board"
    assert min(float(each.anchor.position[0]) for each in on_face(front)) < -0.1


def test_a_flat_layout_keeps_handles_apart_in_the_picture(character, tmp_path):
    size = ("--set", "objective.handle_size=0.12", "--set", "objective.max_neighbours=0")
    flat, _ = processed(character, tmp_path, "--space", "view", "--view", "55,0", *size)
    assert flat.frame.space == "view"
    assert nearest(flat) >= flat.frame.handle_width * (1.0 - 1e-5)
    solid, _ = processed(character, tmp_path, "--space", "object", "--view", "55,0", *size)
    assert solid.frame.space == "object"
    assert nearest(solid) < flat.frame.handle_width


def nearest(layout):
    """Least distance of two handles as the layout's viewer sees them."""
    spots = np.array([element.anchor.position for element in on_face(layout)])
    spots = spots - np.outer(spots @ layout.frame.view, layout.frame.view)
    return pdist(spots).min()


def test_a_view_that_begins_with_a_hyphen_needs_no_equals_sign():
    for words in (["--view", "-90,0"], ["--view=-90,0"]):
        assert parsed(["process", "char.usda", *words, "-q"]).view == "-90,0"
