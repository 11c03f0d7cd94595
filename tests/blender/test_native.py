"""Characters that are native to Blender: one button lays them out on their own shape keys and bones, and their
animation goes home as a small layer."""

import sys

import numpy as np
import pytest
from pxr import Gf, Usd, UsdGeom, UsdSkel
from real_rigs import ASSETS

from usdrigui.layer import baking
from usdrigui.layer.read_layout import layout_scopes
from usdrigui.settings import ReadSettings

CLOSE = 1e-5
"""Of the diagonal of the character."""
RIGS = ["facecap_blender", "rpm_xr", "godette", "mh_expr34"]
SCENES = [("facecap_blender", "modified"), *((name, "plain") for name in RIGS)]


def asset(name):
    if not (ASSETS / f"{name}.usdc").is_file():
        pytest.skip(f"needs ../shared/assets/{name}.usdc")
    return str(ASSETS / f"{name}.usdc")


def baked(target):
    """The stage of a layer with UsdSkel's points in place of its skinning."""
    stage = Usd.Stage.Open(Usd.Stage.Open(str(target)).Flatten())
    for prim in list(stage.Traverse()):
        if prim.IsA(UsdSkel.Root):
            assert UsdSkel.BakeSkinning(UsdSkel.Root(prim), Gf.Interval(0, 100))
    return stage


def world_points(stage, path, time):
    """World points of a mesh."""
    mesh = UsdGeom.Mesh(stage.GetPrimAtPath(path))
    points = np.array(mesh.GetPointsAttr().Get(time), dtype=np.float64)
    matrix = np.array(mesh.ComputeLocalToWorldTransform(time))
    return points @ matrix[:3, :3] + matrix[3, :3]


REFUSED = {
    "nothing": "select the face",
    "no layer": "choose another",
    "no controls": "lay one out, or load a layout",
    "no keys": "select the mesh that has the expressions",
    "edit mode": "leave this mode first",
    "muted": "free those that are to have controls",
    "mirror": "the modifier Half of Cube changes its vertices: apply it",
    "no environment": "press Make Environment",
    "a python without usdrigui": "press Make Environment",
    "no room": "make room",
    "no room for the environment": "make room",
    "no network": "allow it in Preferences",
    "linked": "make a library override",
}


def test_what_cannot_be_done_is_told_in_one_line_with_what_to_do(run_inside, usd_python):
    found = run_inside([usd_python], "refusals", python=sys.executable)
    said = dict(zip(found["names"].tolist(), found["lines"].tolist(), strict=True))
    assert said.keys() == REFUSED.keys()
    for name, repair in REFUSED.items():
        assert repair in said[name]
        assert "\n" not in said[name]


@pytest.mark.real
@pytest.mark.parametrize(("name", "scene"), SCENES)
def test_one_button_binds_every_control_to_the_scenes_own_keys_and_leaves_the_rig_alone(
    run_inside, usd_python, name, scene
):
    found = run_inside([usd_python], "laid_out_here", source=asset(name), scene=scene, python=sys.executable)
    assert found["controls"] > 10
    assert not found["missing"].size
    assert found["unchanged"]
    assert found["removed"]
    assert found["worst"] < 1e-4
    assert found["kept"] > 0.9
    assert found["pinned"], "at the selected vertex, in the next layout"


@pytest.mark.real
def test_a_copy_and_a_neighbour_on_one_parent_are_characters_of_their_own(run_inside, usd_python):
    run_inside([usd_python], "beside", source=asset("godette"), scene="plain", python=sys.executable)


@pytest.mark.real
def test_a_library_override_keeps_its_controls_when_the_shot_is_opened_again(run_inside, usd_python):
    found = run_inside([usd_python], "overridden", source=asset("godette"), python=sys.executable)
    assert found["value"] == pytest.approx(0.4)
    assert not found["missing"].size
    assert found["kind"] == "EMPTY"


@pytest.mark.real
@pytest.mark.parametrize("name", ["facecap_blender", "godette"])
def test_bones_drive_the_same_values_and_leave_no_trace(run_inside, usd_python, name):
    found = run_inside([usd_python], "boned", source=asset(name), scene="plain", python=sys.executable)
    assert found["driven"] > 10
    assert max(found[each] for each in ("worst", "keyed", "back", "points")) < 1e-5
    assert found["clamped"] <= 0.0
    assert not found["renders"]
    assert not found["trace"]


@pytest.mark.real
@pytest.mark.parametrize(("name", "scene"), SCENES)
def test_the_animation_goes_home_in_kilobytes_and_is_that_of_blender(run_inside, usd_python, tmp_path, name, scene):
    target = tmp_path / "shot.anim.usda"
    found = run_inside(
        [usd_python], "taken_home", source=asset(name), scene=scene, python=sys.executable, target=str(target)
    )
    assert target.stat().st_size < 200_000
    stage = Usd.Stage.Open(str(target))
    told = baking.valued(next(layout_scopes(stage)), ReadSettings())
    assert len(told.values) > 4
    assert not [*baking.apart(told)]
    stage = baked(target)
    assert [stage.GetStartTimeCode(), stage.GetEndTimeCode()] == [1.0, 24.0]
    worst = 0.0
    for frame in range(1, 25):
        here = [found[f"{frame}_{i}"] for i in range(len(found["paths"]))]
        size = np.linalg.norm(np.ptp(np.concatenate(here), axis=0))
        for points, path in zip(here, found["paths"], strict=True):
            worst = max(worst, np.abs(points - world_points(stage, str(path), frame)).max() / size)
    assert worst < CLOSE
