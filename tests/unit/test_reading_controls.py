"""What becomes a control, between which values, under which name, and what is left off."""

import json

import numpy as np
import pytest
from pxr import Gf, Sdf, Tf, Usd, UsdGeom, UsdSkel, Vt
from skel_stages import (
    JOINTS,
    SIDE,
    add_animation,
    add_even_skin,
    add_mesh,
    add_shape,
    add_skeleton,
    character,
    head,
    matrix,
    new_stage,
    posed,
)

from usdrigui.character.deform import channel_state, deform
from usdrigui.character.rotation import rotations
from usdrigui.errors import RigUIError
from usdrigui.reader.existing_layouts import without_layout
from usdrigui.reading import pose as poses
from usdrigui.reading.character import read_rigs
from usdrigui.reading.clips import State
from usdrigui.settings import Settings, load


def read(path, config=None):
    (rig,) = read_rigs(path, load(config or {}))
    return rig


def controls(rig):
    return {control.name: control for control in rig.controls}


def span(control):
    return control.minimum, control.default, control.maximum, control.range_source


def spans(rig):
    """Of the smile and of the frown."""
    return [span(controls(rig)[name]) for name in ("smile", "frown")]


PLAIN = (0.0, 0.0, 1.0, "default")


def edited(tmp_path, edit, config=None):
    return read(head(tmp_path / "char.usda", edit=edit), config)


def _animation(stage):
    return UsdSkel.Animation(stage.GetPrimAtPath("/Char/Anim"))


# --- blend shapes ------------------------------------------------------------------------------------


def test_tokens_become_controls_over_zero_to_one(tmp_path):
    rig = read(head(tmp_path / "char.usda"))
    assert [*rig.control_names] == ["smile", "frown"]
    assert span(rig.controls[0]) == PLAIN
    assert (rig.left_off, rig.issues) == ((), ())


def test_tokens_are_mapped_by_name_over_meshes_and_animations(tmp_path):
    rig = read(character(tmp_path / "char.usda"))
    smile = controls(rig)["smile"]
    driven = {(rig.body.channels[i].token, rig.body.channels[i].animation) for i in smile.drive.channels}
    assert driven == {("smile", "/World/Char/Anim"), ("smile", "/World/Char/Anim2")}
    shapes = {shape.path for i in smile.drive.channels for _, shape in rig.body.shapes_by_channel[int(i)]}
    assert shapes == {f"/World/Char/{mesh}/s_smile" for mesh in ("Geo/Face", "Geo/Teeth", "Geo/Hat", "Tongue")}


def test_tokens_that_an_exporter_numbered_are_one_control(tmp_path):
    def edit(stage):
        UsdSkel.BindingAPI(stage.GetPrimAtPath("/Char/Face")).GetBlendShapesAttr().Set(["s_smile", "s_frown"])
        teeth = add_mesh(stage, "/Char/Teeth", "/Char/Skel")
        add_shape(teeth, "smile")
        UsdSkel.BindingAPI(teeth).GetBlendShapesAttr().Set(["s_smile2"])
        _animation(stage).GetBlendShapesAttr().Set(["s_smile", "s_frown", "s_smile2"])
        _animation(stage).GetBlendShapeWeightsAttr().Set([0.0, 0.0, 0.0])

    rig = edited(tmp_path, edit)
    assert {name: [*control.drive.channels] for name, control in controls(rig).items()} == {
        "s_smile": [0, 2],
        "s_frown": [1],
    }


def test_a_token_without_shape_is_left_off(tmp_path):
    rig = read(character(tmp_path / "char.usda"))
    assert [(each.control, each.stage, each.reason) for each in rig.left_off] == [
        ("unused", "read", "no mesh has a shape for it")
    ]


def test_an_empty_shape_is_left_off_and_so_its_twin_has_none(tmp_path):
    def edit(stage):
        UsdSkel.BlendShape(stage.GetPrimAtPath("/Char/Face/s_wink_L")).GetOffsetsAttr().Set(Vt.Vec3fArray())

    rig = read(head(tmp_path / "char.usda", ("wink_L", "wink_R", "frown"), edit))
    assert [*rig.control_names] == ["wink_R", "frown"]
    (lost,) = rig.left_off
    assert lost.control == "wink_L"
    assert lost.reason == "its shape /Char/Face/s_wink_L has no offsets; wink_R has no twin then"


def test_a_dangling_target_is_left_off_with_a_warning(tmp_path):
    rig = edited(tmp_path, lambda stage: stage.RemovePrim("/Char/Face/s_frown"))
    assert [each.control for each in rig.left_off] == ["frown"]
    assert [(each.code, each.path) for each in rig.issues if each.severity == "warning"] == [
        ("TARGET_INVALID", "/Char/Face/s_frown")
    ]


def test_a_token_that_no_animation_lists_is_still_a_control(tmp_path):
    def edit(stage):
        _animation(stage).GetBlendShapesAttr().Set(["smile"])
        _animation(stage).GetBlendShapeWeightsAttr().Set([0.0])

    rig = edited(tmp_path, edit)
    assert list(controls(rig)) == ["smile", "frown"]
    frown = rig.body.channels[int(controls(rig)["frown"].drive.channels[0])]
    assert (frown.animation, frown.index) == ("", -1)
    assert [each.code for each in rig.issues] == ["TOKEN_NOT_ANIMATED"]


def test_no_animation_at_all(tmp_path):
    rig = edited(tmp_path, lambda stage: stage.RemovePrim("/Char/Anim"))
    assert list(controls(rig)) == ["smile", "frown"]
    assert (len(rig.clip.times), rig.clip.weights.tolist()) == (1, [[0.0, 0.0]])


def test_a_mesh_without_skeleton_cannot_move(tmp_path):
    def edit(stage):
        mesh = add_mesh(stage, "/Char/Loose")
        add_shape(mesh, "float")

    rig = edited(tmp_path, edit)
    assert list(controls(rig)) == ["smile", "frown"]
    assert [(each.control, each.reason) for each in rig.left_off] == [("float", "no Skeleton is bound to /Char/Loose")]
    assert [(each.code, each.path) for each in rig.issues] == [("MESH_UNBOUND", "/Char/Loose")]
    assert len(rig.body.meshes) == 2


def test_a_mesh_with_influences_and_a_skeleton_in_vain_is_reported(tmp_path):
    def edit(stage):
        stage.DefinePrim("/Char/Extra")
        mesh = add_mesh(stage, "/Char/Extra/Hat", skeleton="/Char/Skel")
        add_even_skin(mesh, 1)
        loose = add_mesh(stage, "/Char/Loose")  # nobody says what should move it: a prop as good as any
        add_even_skin(loose, 1)

    rig = edited(tmp_path, edit)
    assert list(controls(rig)) == ["smile", "frown"]
    assert [(each.code, each.path) for each in rig.issues] == [("MESH_UNBOUND", "/Char/Extra/Hat")]
    assert "/Char/Extra has no type" in rig.issues[0].message


@pytest.mark.parametrize(
    ("hide", "why"),
    [
        (lambda stage: UsdGeom.Imageable(stage.GetPrimAtPath("/Char/Face")).MakeInvisible(), "is invisible; "),
        (
            lambda stage: UsdGeom.Imageable(stage.GetPrimAtPath("/Char")).MakeInvisible(),
            "is invisible; ",
        ),
        (
            lambda stage: UsdGeom.Imageable(stage.GetPrimAtPath("/Char")).CreatePurposeAttr("proxy"),
            "has the purpose proxy; ",
        ),
    ],
)
def test_a_mesh_that_nobody_sees_is_reported(tmp_path, hide, why):
    rig = edited(tmp_path, hide)
    assert [(each.code, each.path) for each in rig.issues] == [("MESH_HIDDEN", "/Char/Face")]
    assert rig.issues[0].message == f"{why}2 of its blend shapes are on no mesh that is drawn"


def test_a_hidden_stand_in_for_what_is_seen_is_nothing_to_tell(tmp_path):
    def edit(stage):
        mesh = add_mesh(stage, "/Char/Proxy", skeleton="/Char/Skel")
        add_shape(mesh, "smile")
        add_even_skin(mesh, 1)
        UsdGeom.Imageable(mesh).CreatePurposeAttr("proxy")

    assert edited(tmp_path, edit).issues == ()


def test_points_prims_are_not_supported(tmp_path):
    def edit(stage):
        points = UsdGeom.Points.Define(stage, "/Char/Sparks")
        points.CreatePointsAttr(Vt.Vec3fArray(SIDE**2))
        UsdSkel.BindingAPI.Apply(points.GetPrim()).CreateSkeletonRel().SetTargets(["/Char/Skel"])
        add_shape(points, "sparkle")

    rig = edited(tmp_path, edit)
    assert [each.control for each in rig.left_off] == ["sparkle"]
    assert [(each.code, each.path) for each in rig.issues] == [("PRIM_UNSUPPORTED", "/Char/Sparks")]


def test_invalid_inbetweens_are_ignored_as_usdskel_does(tmp_path):
    def edit(stage):
        shape = UsdSkel.BlendShape(stage.GetPrimAtPath("/Char/Face/s_smile"))
        for name, weight in (("zero", 0.0), ("one", 1.0), ("none", None), ("half", 0.5)):
            between = shape.CreateInbetween(name)
            between.SetOffsets(Vt.Vec3fArray(SIDE**2))
            if weight is not None:
                between.SetWeight(weight)

    rig = edited(tmp_path, edit)
    assert rig.body.meshes[0].shapes[0].weights.tolist() == [0.5, 1.0]
    assert [each.code for each in rig.issues].count("INBETWEEN_INVALID") == 3


def test_of_repeated_names_the_last_counts_as_in_usdskel(tmp_path):
    def edit(stage):
        UsdSkel.BindingAPI(stage.GetPrimAtPath("/Char/Face")).GetBlendShapesAttr().Set(["smile", "smile"])
        _animation(stage).GetBlendShapesAttr().Set(["smile", "frown", "smile"])
        _animation(stage).GetBlendShapeWeightsAttr().Set([0.0, 0.0, 0.0])

    path = head(tmp_path / "char.usda", edit=edit)
    rig = read(path)
    assert [(each.code, each.path) for each in rig.issues] == [
        ("TOKEN_REPEATED", "/Char/Anim"),
        ("TOKEN_REPEATED", "/Char/Face"),
    ]
    stage = Usd.Stage.Open(str(path))
    stage.SetEditTarget(stage.GetSessionLayer())
    weights = [0.0, 0.0, 0.0]
    weights[rig.body.channels[int(rig.controls[0].drive.channels[0])].index] = 1.0
    _animation(stage).GetBlendShapeWeightsAttr().Set(weights)
    UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath("/Char")), Gf.Interval(1, 1))
    baked = UsdGeom.Mesh(stage.GetPrimAtPath("/Char/Face")).GetPointsAttr().Get(1)
    assert np.abs(deform(rig, [1.0]) - np.asarray(baked)).max() < 1e-6


# --- ranges ------------------------------------------------------------------------------------------


def test_inbetweens_widen_the_range(tmp_path):
    def edit(stage):
        shape = UsdSkel.BlendShape(stage.GetPrimAtPath("/Char/Face/s_smile"))
        for i, weight in enumerate((-0.5, 0.5, 1.5)):
            between = shape.CreateInbetween(f"b{i}")
            between.SetWeight(weight)
            between.SetOffsets(Vt.Vec3fArray(SIDE**2))

    assert spans(edited(tmp_path, edit))[0] == (-0.5, 0.0, 1.5, "inbetweens")


def test_an_animation_widens_the_range_but_never_narrows_it(tmp_path):
    def edit(stage):
        weights = _animation(stage).GetBlendShapeWeightsAttr()
        for time, values in ((1.0, [0.0, 0.2]), (2.0, [-0.75, 0.3]), (3.0, [2.5, 1.004])):
            weights.Set(values, time)

    rig = edited(tmp_path, edit)
    assert spans(rig) == [(-0.75, 0.0, 2.5, "animation"), PLAIN]
    assert rig.clip.times.tolist() == [1.0, 2.0, 3.0]
    assert np.allclose(rig.clip.weights[:, 0], [0.0, -0.75, 2.5])


@pytest.mark.parametrize("as_text", [True, False])
def test_ranges_in_custom_data(tmp_path, as_text):
    def edit(stage):
        ranges = {"smile": [-1, 1]}
        table = json.dumps(ranges) if as_text else {"smile": Vt.DoubleArray([-1, 1])}
        stage.GetRootLayer().customLayerData = {"ranges": table}

    rig = edited(tmp_path, edit)
    assert spans(rig) == [(-1.0, 0.0, 1.0, "metadata"), PLAIN]


def test_a_custom_range_that_is_none_is_reported(tmp_path):
    def edit(stage):
        stage.GetRootLayer().customLayerData = {"ranges": json.dumps({"smile": [1, -1], "frown": "wide"})}

    rig = edited(tmp_path, edit)
    assert [each.code for each in rig.issues] == ["RANGE_INVALID", "RANGE_INVALID"]
    assert spans(rig)[0] == PLAIN


def _with_limits(tmp_path, kind, minimum, maximum):
    """The asset with `limits` metadata, written as text since older USD cannot author it."""
    path = head(tmp_path / "char.usda")
    text = path.read_text()
    value = "float[] blendShapeWeights = [0, 0]"
    limits = f"(limits = {{ dictionary {kind} = {{ float[] maximum = {maximum}\n float[] minimum = {minimum}\n }} }})"
    assert value in text
    path.write_text(text.replace(value, f"{value} {limits}"))
    return path


@pytest.mark.parametrize("kind", ["soft", "hard"])
def test_limits_win_over_the_rest(tmp_path, kind):
    rig = read(_with_limits(tmp_path, kind, [-0.25, 0], [0.5, 3]))
    assert spans(rig) == [(-0.25, 0.0, 0.5, "limits"), (0.0, 0.0, 3.0, "limits")]


def test_limits_of_another_length_are_reported(tmp_path):
    rig = read(_with_limits(tmp_path, "soft", [-0.25, 0, 0], [0.5, 3, 1]))
    assert [each.code for each in rig.issues] == ["RANGE_INVALID"]
    assert spans(rig)[0] == PLAIN


def test_limits_stay_those_of_their_shapes_where_a_shot_adds_others(tmp_path):
    _with_limits(tmp_path, "soft", [-0.25, 0], [0.5, 3])
    stage = Usd.Stage.CreateNew(str(tmp_path / "shot.usda"))
    stage.GetRootLayer().subLayerPaths = ["./char.usda"]
    (animation,) = (UsdSkel.Animation(each) for each in stage.Traverse() if each.IsA(UsdSkel.Animation))
    animation.GetBlendShapesAttr().Set(["crease", *animation.GetBlendShapesAttr().Get()])
    animation.GetBlendShapeWeightsAttr().Set([0.0, 0.0, 0.0])
    stage.GetRootLayer().Save()
    rig = read(tmp_path / "shot.usda")
    assert "RANGE_INVALID" not in {each.code for each in rig.issues}
    assert spans(rig) == [(-0.25, 0.0, 0.5, "limits"), (0.0, 0.0, 3.0, "limits")]


def test_the_configuration_wins(tmp_path):
    config = {"controls": {"smile": {"minimum": -2.0, "maximum": 0.75, "default": -1.0}}}
    rig = read(_with_limits(tmp_path, "soft", [-0.25, 0], [0.5, 3]), config)
    smile = controls(rig)["smile"]
    assert span(smile) == (-2.0, -1.0, 0.75, "config")
    # The default is the base pose: the drive adds to it and vanishes there.
    weights, _ = channel_state(rig)
    assert weights[smile.drive.channels].tolist() == [-1.0]
    values = rig.defaults
    values[0] = 0.5
    assert channel_state(rig, values)[0][smile.drive.channels].tolist() == [0.5]


# --- the configuration's other words -----------------------------------------------------------------


def test_exclude_rename_and_label(tmp_path):
    config = {"controls": {"smile": {"rename": "grin", "label": "Grin!"}, "frown": {"exclude": True}}}
    rig = read(head(tmp_path / "char.usda"), config)
    assert [(each.name, each.label, each.source) for each in rig.controls] == [("grin", "Grin!", "smile")]
    assert [(each.control, each.stage) for each in rig.left_off] == [("frown", "config")]
    assert [each.name for each in rig.excluded] == ["frown"]


def test_names_of_left_off_controls_are_known(tmp_path):
    """The configuration may go on naming a token that lost its shape."""
    rig = read(character(tmp_path / "char.usda"), {"controls": {"unused": {"label": "x"}}})
    assert "unused" not in controls(rig)


# --- joints ------------------------------------------------------------------------------------------


def test_animated_joints_become_controls_about_their_own_axes(tmp_path):
    rig = read(character(tmp_path / "char.usda"))
    joints = {name: control for name, control in controls(rig).items() if control.kind == "joint"}
    assert {name.split(":")[0] for name in joints} == {"neck", "jaw", "tip"}
    jaw = joints["jaw:rx"]
    assert jaw.source == JOINTS[1]
    # From 20 to 60 degrees about x, measured from the rest pose, without the noise of quaternions.
    assert span(jaw) == (0.0, 0.0, 40.0, "animation")
    assert "jaw:ry" not in joints


def test_joint_controls_turn_the_joint_about_its_own_axis(tmp_path):
    config = {"joints": {"lip": {"axes": ["y"], "minimum": -10.0, "maximum": 90.0, "label": "Lip"}}}
    rig = read(character(tmp_path / "char.usda"), config)
    lip = controls(rig)["lip:ry"]
    assert (span(lip), lip.label) == ((-10.0, 0.0, 90.0, "config"), "Lip y")
    values = rig.defaults
    values[rig.controls.index(lip)] = 90.0
    local = channel_state(rig, values)[1][2]
    expected = np.array(matrix((0, 90, 0)) * Gf.Matrix4d(*rig.body.joints[2].base.ravel().tolist()))
    assert np.allclose(local, expected, atol=1e-9)


@pytest.mark.parametrize(("which", "count"), [("none", 0), ("all", 15), ("auto", 7), ("animated", 7)])
def test_which_joints(tmp_path, which, count):
    rig = read(character(tmp_path / "char.usda"), {"read": {"joints": which}})
    found = [control for control in rig.controls if control.kind == "joint"]
    if which in ("none", "all"):
        assert len(found) == count
    else:
        assert 3 <= len(found) <= count


def test_a_joint_without_axes_is_no_control(tmp_path):
    rig = read(character(tmp_path / "char.usda"), {"joints": {"neck": {"axes": []}}})
    assert not any(name.startswith("neck:") for name in controls(rig))


def test_joints_that_are_moved_or_scaled_are_mentioned(tmp_path):
    rig = read(posed(tmp_path / "p.usda", None))
    assert [(each.code, each.message) for each in rig.issues] == [
        ("JOINT_MOTION_IGNORED", "the animation moves or scales a, and controls of joints turn them")
    ]
    rig = read(posed(tmp_path / "q.usda", None), {"read": {"joints": "none"}, "poses": {"p": {"frame": 2.0}}})
    assert rig.issues == ()


# --- poses -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "names", [json.dumps(["Rest", "turn", "shift", "same"]), Vt.StringArray(["Rest", "turn", "shift", "same"])]
)
def test_named_frames_become_poses(tmp_path, names):
    rig = read(posed(tmp_path / "p.usda", names))
    assert [(control.name, control.kind) for control in rig.controls] == [("turn", "pose"), ("shift", "pose")]
    assert [(each.control, each.reason) for each in rig.left_off] == [("same", "the pose equals the base pose")]
    local = channel_state(rig, [0.5, 0.5])[1]
    assert np.allclose(local[0], np.array(matrix((0, 0, 0), (0, 0, 1))), atol=1e-6)
    assert np.allclose(local[1], np.array(matrix((0, 0, 15), (0, 1, 0))), atol=1e-6)


def test_named_frames_as_a_table_of_times(tmp_path):
    rig = read(posed(tmp_path / "p.usda", json.dumps({"rest": 0, "shift": 2})))
    assert [*rig.control_names] == ["shift"]


def test_too_few_frames_for_the_names(tmp_path):
    rig = read(posed(tmp_path / "p.usda", json.dumps(["Rest", "turn", "shift", "same", "lost"])))
    assert {each.control for each in rig.left_off} == {"lost", "same"}
    assert [each.code for each in rig.issues] == ["POSES_MISMATCH"]


def test_without_names_the_joints_are_controls(tmp_path):
    rig = read(posed(tmp_path / "p.usda", None))
    assert [*rig.control_names] == ["b:rz"]


def test_named_frames_and_joints_when_asked(tmp_path):
    path = posed(tmp_path / "p.usda", json.dumps(["Rest", "turn", "shift", "same"]))
    rig = read(path, {"read": {"joints": "animated"}})
    assert [*rig.control_names] == ["b:rz", "turn", "shift"]


def test_a_clip_passes_through_its_frames(tmp_path):
    rig = read(posed(tmp_path / "p.usda", None), {"poses": {"story": {"clip": [0.0, 2.0]}}})
    story = rig.control_indices["story"]
    assert rig.controls[story].drive.values.tolist() == [0.0, 0.5, 1.0]
    values = np.zeros(len(rig.controls))
    values[story] = 0.5
    assert np.allclose(channel_state(rig, values)[1][1], np.array(matrix((0, 0, 30), (0, 1, 0))), atol=1e-6)


def test_a_clip_that_starts_elsewhere_starts_at_the_base_pose(tmp_path):
    rig = read(posed(tmp_path / "p.usda", None), {"poses": {"story": {"clip": [1.0, 2.0]}}})
    story = next(control for control in rig.controls if control.name == "story")
    assert story.drive.values[0] == 0.0
    assert story.drive.values[-1] == 1.0
    assert len(story.drive.values) == 3
    for table in (story.drive.moves, story.drive.weights):
        assert not table[0].any()


def test_a_pose_of_weights(tmp_path):
    config = {"poses": {"smirk": {"weights": {"smile": 0.7}}}, "controls": {"smirk": {"label": "Smirk"}}}
    rig = read(head(tmp_path / "char.usda"), config)
    assert (controls(rig)["smirk"].kind, controls(rig)["smirk"].label) == ("pose", "Smirk")
    assert channel_state(rig, [0.0, 0.0, 0.5])[0].tolist() == [0.35, 0.0]


def test_a_drive_added_to_the_base_pose_is_the_pose_at_every_key():
    random = np.random.default_rng(5)
    rest, turned = random.random((3, 3)), random.random((3, 3, 3)) * [[[0.0]], [[0.5]], [[1.0]]]
    turned[1:, 2] = 2e-7  # the same, in single precision
    placed = np.tile(np.eye(4), (3, 3, 1, 1))  # keys, joints
    placed[..., :3, :3] = rotations(turned) @ rotations(rest)
    placed[..., 3, :3] = random.random((3, 3)) + turned
    weights = np.tile(random.random(4), (3, 1))
    weights[1:, [0, 1, 3]] += random.random((2, 3))
    base, states = State(weights[0], placed[0]), State(weights, placed)
    drive = poses.pose_drive(poses.NamedPose("clip", np.array([0.0, 0.5, 1.0]), states), base)
    assert (drive.channels.tolist(), drive.joints.tolist()) == ([0, 1, 3], [0, 1])
    assert np.allclose(weights[0, drive.channels] + drive.weights, weights[:, drive.channels])
    turns, shifts, scales = np.moveaxis(drive.moves, 1, 0)
    assert np.allclose(placed[0, drive.joints, 3, :3] + shifts, placed[:, drive.joints, 3, :3])
    assert np.allclose(turns, turned[:, :2])
    assert not scales.any()


def test_a_pose_named_like_a_token_keeps_apart(tmp_path):
    rig = read(head(tmp_path / "char.usda"), {"poses": {"smile": {"weights": {"frown": 1.0}}}})
    assert list(controls(rig)) == ["smile", "frown", "smile:pose"]


# --- base pose, space, several roots -----------------------------------------------------------------


def test_a_time_gives_the_base_pose(tmp_path):
    rig = read(character(tmp_path / "char.usda"), {"read": {"time": 10.0}})
    smile = controls(rig)["smile"]
    assert smile.default == pytest.approx(-0.7)
    assert smile.minimum <= smile.default
    assert not np.allclose(rig.body.joints[1].base, rig.body.joints[1].rest)


def test_up_and_units(tmp_path):
    rig = read(character(tmp_path / "char.usda"))
    assert np.linalg.norm(rig.up) == pytest.approx(1.0)
    # The SkelRoot is turned by about 31 degrees against the world's z axis.
    assert rig.up[2] == pytest.approx(np.cos(np.radians(np.hypot(30, 10))), abs=1e-6)
    assert rig.metres_per_unit == 1.0


def test_units_of_the_wrong_type(tmp_path):
    """The UsdGeom function raises where metersPerUnit is a float."""
    path = head(tmp_path / "char.usda")
    path.write_text(path.read_text().replace("#usda 1.0\n(", "#usda 1.0\n(\n    metersPerUnit = 1"))
    assert read(path).metres_per_unit == 1.0
    layer = Sdf.Layer.FindOrOpen(str(path))
    layer.pseudoRoot.SetInfo("metersPerUnit", 0.0)
    layer.Save()
    rig = read(path)
    assert rig.metres_per_unit == 0.01
    assert [each.code for each in rig.issues] == ["UNITS_TYPE"]


def test_units_of_a_type_that_usd_refuses(tmp_path):
    """Some exporters write metersPerUnit as a float, for which USD's own API raises."""
    text, path = head(tmp_path / "char.usda"), tmp_path / "char.usdc"
    text.write_text(text.read_text().replace("#usda 1.0\n(", "#usda 1.0\n(\n    metersPerUnit = 0.40625"))
    Sdf.Layer.FindOrOpen(str(text)).Export(str(path))
    as_double, as_float = b"\xd0\x3e\0\0\x09\x40", b"\xd0\x3e\0\0\x08\x40"  # The type is the byte before the last.
    content = path.read_bytes()
    assert content.count(as_double) == 1
    path.write_bytes(content.replace(as_double, as_float))
    with pytest.raises(Tf.ErrorException):
        UsdGeom.GetStageMetersPerUnit(Usd.Stage.Open(str(path)))
    rig = read(path)
    assert (rig.metres_per_unit, rig.issues) == (0.40625, ())


def test_a_mesh_outside_the_skelroot_is_named(tmp_path):
    def edit(stage):
        skinned, shaped, plain = (add_mesh(stage, f"/{name}", seed=4) for name in ("Skinned", "Shaped", "Plain"))
        add_even_skin(skinned, 1)
        add_shape(shaped, "smile")
        UsdSkel.BindingAPI.Apply(plain.GetPrim())

    rig = edited(tmp_path, edit)
    assert [(each.code, each.path) for each in rig.issues] == [
        ("MESH_OUTSIDE", "/Skinned"),
        ("MESH_OUTSIDE", "/Shaped"),
    ]
    assert [mesh.path for mesh in rig.body.meshes] == ["/Char/Face"]


def test_hidden_and_left_handed_meshes_are_marked(tmp_path):
    rig = read(character(tmp_path / "char.usda"))
    hair = next(mesh for mesh in rig.body.meshes if mesh.path.endswith("Hair"))
    assert (hair.visible, hair.topology.left_handed, hair.skin) == (False, True, None)
    assert sum(mesh.visible for mesh in rig.body.meshes) == len(rig.body.meshes) - 1


@pytest.mark.parametrize(("purpose", "visible"), [("render", True), ("proxy", False), ("guide", False)])
def test_purpose_decides_visibility(tmp_path, purpose, visible):
    rig = edited(tmp_path, lambda stage: UsdGeom.Mesh(stage.GetPrimAtPath("/Char/Face")).CreatePurposeAttr(purpose))
    assert rig.body.meshes[0].visible is visible


def test_several_skelroots(tmp_path):
    path = head(tmp_path / "char.usda")
    stage = Usd.Stage.CreateNew(str(tmp_path / "shot.usda"))
    for name in ("A", "B"):
        stage.DefinePrim(f"/{name}").GetReferences().AddReference("./char.usda", "/Char")
    UsdSkel.Root.Define(stage, "/Bare")
    stage.GetRootLayer().Save()
    rigs = read_rigs(tmp_path / "shot.usda", Settings())
    assert [rig.path for rig in rigs] == ["/A", "/B"]
    assert read_rigs(tmp_path / "shot.usda", load({"read": {"skel_root": "/B"}}))[0].path == "/B"
    assert path.exists()


def test_a_nested_skelroot_is_a_character_of_its_own(tmp_path):
    def edit(stage):
        UsdSkel.Root.Define(stage, "/Char/Pet")
        add_skeleton(stage, "/Char/Pet/Skel")
        add_shape(add_mesh(stage, "/Char/Pet/Face", "/Char/Pet/Skel"), "bark")
        add_animation(stage, "/Char/Pet/Anim", "/Char/Pet/Skel", ())

    rigs = read_rigs(head(tmp_path / "char.usda", edit=edit), Settings())
    assert [(rig.path, list(controls(rig)), rig.left_off, [each.code for each in rig.issues]) for rig in rigs] == [
        ("/Char", ["smile", "frown"], (), []),
        ("/Char/Pet", ["bark"], (), ["TOKEN_NOT_ANIMATED"]),
    ]


@pytest.mark.parametrize("where", ["shared", "outside"])
def test_skeletons_may_share_an_animation_or_stand_outside(tmp_path, where):
    def edit(stage):
        path = "/Other/Skel" if where == "outside" else "/Char/Skel2"
        add_skeleton(stage, path)
        add_shape(add_mesh(stage, "/Char/Teeth", path), "smile")
        UsdSkel.BindingAPI.Apply(stage.GetPrimAtPath(path)).CreateAnimationSourceRel().SetTargets(["/Char/Anim"])

    rig = edited(tmp_path, edit)
    assert [channel.token for channel in rig.body.channels] == ["smile", "frown"]
    assert len(rig.body.shapes_by_channel[0]) == 2


def test_earlier_layouts_are_not_read_as_meshes(tmp_path):
    def edit(stage):
        scope = UsdGeom.Scope.Define(stage, "/Char/RigUI").GetPrim()
        scope.AddAppliedSchema("RigUILayoutAPI")
        handle = add_mesh(stage, "/Char/RigUI/smile/handle", "/Char/Skel", seed=2)
        add_shape(handle, "smile")

    rig = edited(tmp_path, edit)
    assert [mesh.path for mesh in rig.body.meshes] == ["/Char/Face"]


def test_missing_rest_transforms_come_from_the_bind_transforms(tmp_path):
    stage, _ = new_stage(tmp_path / "r.usda")
    rest = (matrix((0, 30, 0), (1, 0, 0)), matrix((10, 0, 0), (0, 1, 0)))
    add_skeleton(stage, "/Char/Skel", ("a", "a/b"), rest).GetRestTransformsAttr().Clear()
    mesh = add_mesh(stage, "/Char/Face", "/Char/Skel")
    add_shape(mesh, "smile")
    add_even_skin(mesh, 2)
    stage.GetRootLayer().Save()
    rig = read(tmp_path / "r.usda")
    assert "REST_MISSING" in [each.code for each in rig.issues]
    assert np.allclose(rig.body.joints[1].rest, np.array(rest[1]), atol=1e-9)


def test_the_topology_hash_tells_topologies_apart(tmp_path):
    plain = read(head(tmp_path / "a.usda")).body.meshes[0].topology.hash

    def moved(stage):
        UsdGeom.Mesh(stage.GetPrimAtPath("/Char/Face")).GetPointsAttr().Set(Vt.Vec3fArray([(1, 2, 3)] * SIDE**2))

    def turned(stage):
        indices = UsdGeom.Mesh(stage.GetPrimAtPath("/Char/Face")).GetFaceVertexIndicesAttr()
        indices.Set(list(indices.Get())[::-1])

    assert read(head(tmp_path / "b.usda", edit=moved)).body.meshes[0].topology.hash == plain
    assert read(head(tmp_path / "c.usda", edit=turned)).body.meshes[0].topology.hash != plain


def test_records_are_read_only(tmp_path):
    rig = read(character(tmp_path / "char.usda"))
    with pytest.raises(ValueError, match="read-only"):
        rig.body.meshes[0].points[0] = 0.0
    with pytest.raises(ValueError, match="read-only"):
        rig.body.meshes[0].shapes[0].offsets[0] = 0.0


def test_excluding_everything_is_refused(tmp_path):
    with pytest.raises(RigUIError) as caught:
        read(head(tmp_path / "char.usda", ("smile",)), {"controls": {"smile": {"exclude": True}}})
    assert caught.value.issue.code == "CONTROLS_MISSING"
    assert "excluded" in caught.value.issue.message


@pytest.mark.parametrize(
    ("said", "maxima"),
    [
        ({"brow_L": {"maximum": 0.5}}, [0.5, 0.5]),
        ({"brow_L": {"maximum": 0.5}, "brow_R": {"maximum": 0.8}}, [0.5, 0.8]),
        ({"brow_L": {"maximum": 0.5, "twin": "none"}}, [0.5, 1.0]),
        ({"brow_R": {"maximum": 0.5}, "brow_L": {"label": "Brow"}}, [0.5, 0.5]),
    ],
)
def test_a_range_of_one_side_holds_for_the_other_unless_set_otherwise(tmp_path, said, maxima):
    rig = read(head(tmp_path / "char.usda", ("brow_L", "brow_R")), {"controls": said})
    assert [control.maximum for control in rig.controls] == maxima


def test_characters_without_a_layout_are_those_whose_meshes_something_moves():
    stage = Usd.Stage.CreateInMemory()
    for name, attribute in (("shapes", "skel:blendShapes"), ("joints", "primvars:skel:jointIndices"), ("prop", "")):
        UsdSkel.Root.Define(stage, f"/{name}")
        mesh = UsdGeom.Mesh.Define(stage, f"/{name}/mesh").GetPrim()
        if attribute == "skel:blendShapes":
            mesh.CreateAttribute(attribute, Sdf.ValueTypeNames.TokenArray).Set(["smile"])
        elif attribute:
            mesh.CreateAttribute(attribute, Sdf.ValueTypeNames.IntArray).Set([0])
    found = [(each.code, each.path) for each in without_layout(stage, [], "")]
    assert found == [("LAYOUT_NONE", "/shapes"), ("LAYOUT_NONE", "/joints")]
    assert [each.path for each in without_layout(stage, ["/shapes"], "")] == ["/joints"]


def test_turns_go_on_beyond_a_half_turn():
    """From 170 to 190 degrees, which is -170 about the same axis."""
    turns = np.radians([170.0, -170.0, -150.0, 10.0])[:, None, None] * [[0.0, 0.0, 1.0]]
    assert np.degrees(poses.unwrapped(turns))[:, 0, 2] == pytest.approx([170.0, 190.0, 210.0, 370.0])
    turns[1] = 0.0
    assert np.degrees(poses.unwrapped(turns))[1, 0] == pytest.approx([0.0, 0.0, 0.0])


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ({"startTimeCode": 101, "endTimeCode": 148, "timeCodesPerSecond": 30}, (101.0, 148.0, 30.0)),
        ({"startTimeCode": 101, "endTimeCode": 148}, (101.0, 148.0, 24.0)),
        ({}, None),
        ({"startTimeCode": 5, "endTimeCode": 5}, None),
        ({"startTimeCode": 0, "endTimeCode": 1e300}, None),
    ],
)
def test_the_time_codes_of_a_stage_are_what_its_page_plays_without_a_clip(tmp_path, written, expected):
    path = head(tmp_path / "char.usda")
    layer = Sdf.Layer.FindOrOpen(str(path))
    for key in ("startTimeCode", "endTimeCode", "timeCodesPerSecond"):
        layer.pseudoRoot.ClearInfo(key)
    for key, value in written.items():
        layer.pseudoRoot.SetInfo(key, float(value))
    layer.Save()
    assert read(path).time_codes == expected
