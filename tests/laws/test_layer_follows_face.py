"""A written layer, baked by UsdSkel alone: handles stay on the skin, tracks ignore their own controls."""

import laid_out
import numpy as np
import pytest
import skinned_stages
from laid_out import diagonal, written
from pxr import Gf, Usd, UsdGeom, UsdSkel

from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings, load

pytestmark = pytest.mark.usefixtures("every_point_drawn")
CLOSE = 1e-5
"""Of the diagonal of the character's box."""
HAIR = 0.3
"""Of a handle's width: as far as a track may be from where it would be if it followed everything exactly."""
JAW = ("Hips/Head/Jaw",)
KINDS = {
    "linear": {},
    "dual quaternion": {"method": "dualQuaternion"},
    "without skin": {"skinned": False},
    "left-handed": {"left_handed": True},
    "joints in another order": {"reordered": True},
    "transforms everywhere": {"moved": 100},
    "without skin, transforms": {"moved": True, "skinned": False},
    "two meshes, dual quaternion, all at once": {
        "method": "dualQuaternion",
        "meshes": 2,
        "moved": True,
        "reordered": True,
        "animated_joints": ("Hips/Head", *JAW),
    },
    "a joint twice at a point": {"hinged": True, "animated_joints": ("Hips/Head", *JAW)},
    "rigid": {"rigid": True, "animated_joints": ("Hips/Head", *JAW)},
    "rigid, dual quaternion": {"rigid": True, "method": "dualQuaternion", "moved": True, "animated_joints": JAW},
    "joint controls": {"animated_joints": ("Hips", "Hips/Head", *JAW)},
}


def posed(rig, pose, values):
    """The values of all controls of a `pose`, some of them others, by name."""
    found = pose.copy()
    found[[rig.control_indices[name] for name in values]] = [*values.values()]
    return found


def handle_of(stage, rig, element, time):
    return laid_out.handle(stage, rig.path, element, time)


def track_of(stage, rig, element, time, member=0):
    return laid_out.tracks(stage, rig.path, element, time)[member]


@pytest.mark.parametrize("kind", KINDS)
def test_handles_are_centred_on_their_deformed_anchors(tmp_path, kind):
    source, rig = skinned_stages.read(tmp_path, **KINDS[kind])
    layout = laid_out.layout_of(rig)
    rng = np.random.default_rng(5)
    poses = [rig.defaults, *(laid_out.random_values(rig, rng) for _ in range(3))]
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    assert len(layout.elements) == len(rig.controls)
    travel = 0.0
    for element in layout.elements:
        for time in range(len(poses)):
            centre = handle_of(stage, rig, element, time)[0]
            anchor = laid_out.root_points(stage, element.anchor.mesh, rig.path, time)[element.anchor.point]
            assert np.abs(centre - anchor).max() < CLOSE * diagonal(rig), (element.name, time)
            travel = max(travel, float(np.linalg.norm(anchor - element.anchor.position)))
    assert travel > 0.02 * diagonal(rig)


def with_far_shape(source, far):
    """The rig with one more shape, which takes every point of the face out of sight."""
    stage = Usd.Stage.Open(str(source))
    mesh = UsdGeom.Mesh(stage.GetPrimAtPath("/World/Char/face0"))
    shape = UsdSkel.BlendShape.Define(stage, "/World/Char/face0/hide")
    shape.CreateOffsetsAttr([Gf.Vec3f(0.3 * far, far, 0)] * len(mesh.GetPointsAttr().Get()))
    binding = UsdSkel.BindingAPI(mesh)
    binding.GetBlendShapesAttr().Set([*binding.GetBlendShapesAttr().Get(), "hide"])
    binding.GetBlendShapeTargetsRel().AddTarget(shape.GetPath())
    (animation,) = (UsdSkel.Animation(prim) for prim in stage.Traverse() if prim.IsA(UsdSkel.Animation))
    animation.GetBlendShapesAttr().Set([*animation.GetBlendShapesAttr().Get(), "hide"])
    animation.GetBlendShapeWeightsAttr().Set([*animation.GetBlendShapeWeightsAttr().Get(), 0.0])
    stage.Save()
    (rig,) = read_rigs(source, Settings())
    return rig


@pytest.mark.parametrize("far", [1e4, 1e6])
def test_a_shape_that_hides_the_face_far_away_moves_no_handle(tmp_path, far):
    source, plain = skinned_stages.read(tmp_path)
    names = plain.control_names
    alone = laid_out.baked(written(source, plain, laid_out.layout_of(plain)), plain, [plain.defaults])
    rig = with_far_shape(source, far)
    layout = laid_out.layout_of(rig, only=names)
    rng = np.random.default_rng(9)
    poses = [rig.defaults, *(posed(rig, laid_out.random_values(rig, rng), {"hide": 0.0}) for _ in range(3))]
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    for element in layout.elements:
        drawn = handle_of(stage, rig, element, 0)
        assert np.abs(drawn - handle_of(alone, plain, element, 0)).max() < 1e-6 * diagonal(plain), element.name
        for time in range(len(poses)):
            anchor = laid_out.root_points(stage, element.anchor.mesh, rig.path, time)[element.anchor.point]
            assert np.abs(handle_of(stage, rig, element, time)[0] - anchor).max() < 1e-6 * diagonal(plain)


@pytest.mark.parametrize("kind", KINDS)
def test_tracks_do_not_move_with_their_own_controls(tmp_path, kind):
    source, rig = skinned_stages.read(tmp_path, **KINDS[kind])
    layout = laid_out.layout_of(rig, seed=3)
    layer = written(source, rig, layout)
    around = laid_out.random_values(rig, np.random.default_rng(6))
    ends = [(each.name, value) for each in rig.controls for value in (each.minimum, each.maximum)]
    stage = laid_out.baked(layer, rig, [around, *(posed(rig, around, dict([end])) for end in ends)])
    for element in layout.elements:
        own = rig.control_indices[element.name]
        low, high = (track_of(stage, rig, element, 1 + 2 * own + end) for end in (0, 1))
        assert np.abs(high - low).max() < 1e-6 * diagonal(rig), element.name
        moved = handle_of(stage, rig, element, 2 + 2 * own) - handle_of(stage, rig, element, 1 + 2 * own)
        assert np.abs(moved).max() > 1e-3 * diagonal(rig), element.name


@pytest.mark.parametrize("kind", [name for name in KINDS if "all at once" not in name])
def test_handles_stay_on_their_tracks_whatever_else_moves(tmp_path, kind):
    source, rig = skinned_stages.read(tmp_path, **KINDS[kind])
    shapes = [control.name for control in rig.controls if control.kind == "blendShape"]
    layout = laid_out.layout_of(rig, seed=4, only=shapes)
    around = laid_out.random_values(rig, np.random.default_rng(8))
    poses, times = [], {}
    for element in layout.elements:
        for k, value in enumerate(element.members[0].values):
            times[element.name, k] = len(poses)
            poses.append(posed(rig, around, {element.name: value}))
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    for element in layout.elements:
        for k in range(len(element.members[0].values)):
            time = times[element.name, k]
            centre = handle_of(stage, rig, element, time)[0]
            there = track_of(stage, rig, element, time)[k]
            assert np.abs(centre - there).max() < HAIR * layout.frame.handle_width, (element.name, k)


@pytest.mark.parametrize("moved", [False, True])
def test_joint_tracks_follow_shapes_and_parents_exactly_on_a_hinge(tmp_path, moved):
    """Skin of head and jaw alone: the jaw's track is carried by the head and turned shapes ride along."""
    source, rig = skinned_stages.read(tmp_path, animated_joints=("Hips/Head", *JAW), hinged=True, moved=moved)
    layout = laid_out.layout_of(rig, seed=1, only=["Jaw:rx"])
    (element,) = layout.elements
    around = laid_out.random_values(rig, np.random.default_rng(9))
    closed = {name: 0.0 for name in rig.control_names if name.startswith("Jaw:")}
    poses = [posed(rig, around, {**closed, "Jaw:rx": value}) for value in element.members[0].values]
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    assert len(poses) > 2
    for time in range(len(poses)):
        centre = handle_of(stage, rig, element, time)[0]
        assert np.abs(centre - track_of(stage, rig, element, time)[time]).max() < HAIR * layout.frame.handle_width
    away = track_of(stage, rig, element, 0) - element.members[0].track
    assert np.abs(away).max() > 0.01 * diagonal(rig)


def test_pose_controls_leave_their_own_tracks_alone(tmp_path):
    settings = load({"poses": {"talk": {"frame": 10.0}, "mix": {"weights": {"brow_L": 0.6, "chin": 1.0}}}})
    source, rig = skinned_stages.read(tmp_path, settings, animated_joints=JAW)
    layout = laid_out.layout_of(rig, only=["talk", "mix"])
    assert [element.name for element in layout.elements] == ["talk", "mix"]
    base = rig.defaults
    poses = [base, *(posed(rig, base, {name: 1.0}) for name in ("talk", "mix"))]
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    for time, element in enumerate(layout.elements, start=1):
        assert np.abs(track_of(stage, rig, element, time) - track_of(stage, rig, element, 0)).max() < 1e-6
        end = handle_of(stage, rig, element, time)[0]
        assert np.abs(end - element.members[0].track[-1]).max() < CLOSE * diagonal(rig)
        assert np.linalg.norm(end - element.anchor.position) > 1e-3


def test_patches_are_still_under_all_their_controls_and_span_an_area(tmp_path):
    source, rig = skinned_stages.read(tmp_path, animated_joints=JAW)
    group = ("smile_L", "sneer_L")
    layout = laid_out.layout_of(rig, seed=2, groups=[group, ("jawLeft", "chin", "jaw:open")])
    around = laid_out.random_values(rig, np.random.default_rng(3))
    corners = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0))
    poses = [posed(rig, around, dict(zip(group, corner, strict=True))) for corner in corners]
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    patch = layout.elements[0]
    still = laid_out.tracks(stage, rig.path, patch, 0)
    for time in range(4):
        for one, other in zip(laid_out.tracks(stage, rig.path, patch, time), still, strict=True):
            assert np.abs(one - other).max() < 1e-6
    for time, member in ((1, 0), (2, 1)):
        centre = handle_of(stage, rig, patch, time)[0]
        assert np.abs(still[member][-1] - centre).max() < HAIR * layout.frame.handle_width
    faces = {each.name: drawn_faces(stage, rig, each) for each in layout.elements}
    assert [*map(len, faces[patch.name])] == [3] * (7 + 2 + 1)
    fan = faces[layout.elements[1].name]
    assert len(laid_out.tracks(stage, rig.path, layout.elements[1], 0)) == 3
    assert len(fan) > 1 + sum(len(member.values) - 1 for member in layout.elements[1].members)


def drawn_faces(stage, rig, element):
    """The corners of every face of an element."""
    prim = laid_out.element_prim(stage, rig.path, element)
    mesh = UsdGeom.Mesh(prim.GetParent())
    ends = np.cumsum(mesh.GetFaceVertexCountsAttr().Get())
    faces = np.split(np.array(mesh.GetFaceVertexIndicesAttr().Get()), ends[:-1])
    return [faces[each] for each in UsdGeom.Subset(prim).GetIndicesAttr().Get()]


@pytest.mark.parametrize("adapt", ["deform", "static"])
@pytest.mark.parametrize("skinned", [False, True])
def test_elements_beside_the_face_or_static_do_not_deform_but_show_their_value(tmp_path, adapt, skinned):
    source, rig = skinned_stages.read(tmp_path, skinned=skinned, animated_joints=("Hips",))
    beside = ("brow_L", "chin") if adapt == "deform" else ()
    layout = laid_out.layout_of(rig, beside=beside, adapt=adapt, only=["brow_L", "chin", "half"])
    rng = np.random.default_rng(2)
    hips = [name for name in rig.control_names if name.startswith("Hips:")]
    shapes_only = posed(rig, laid_out.random_values(rig, rng), dict.fromkeys(hips, 0.0))
    turned = laid_out.random_values(rig, rng)
    stage = laid_out.baked(written(source, rig, layout), rig, [rig.defaults, shapes_only, turned])
    for element in layout.elements:
        if adapt == "deform" and element.name not in beside:
            continue
        member = element.members[0]
        assert np.abs(track_of(stage, rig, element, 1) - member.track).max() < CLOSE * diagonal(rig)
        value = shapes_only[rig.control_indices[element.name]]
        there = [np.interp(value, member.values, member.track[:, axis]) for axis in range(3)]
        centre = handle_of(stage, rig, element, 1)[0]
        assert np.abs(centre - there).max() < CLOSE * diagonal(rig), element.name
        if skinned:
            carried = np.abs(track_of(stage, rig, element, 2) - member.track).max()
            assert carried > 1e-3 * diagonal(rig), element.name


def test_layouts_of_another_base_pose_stand_where_the_pose_puts_them(tmp_path):
    source, rig = skinned_stages.read(tmp_path, animated_joints=("Hips/Head", *JAW), moved=True)
    base = 0.5 * laid_out.random_values(rig, np.random.default_rng(1))
    layout = laid_out.layout_of(rig, base_values=base)
    stage = laid_out.baked(written(source, rig, layout), rig, [base, rig.defaults])
    for element in layout.elements:
        assert np.abs(track_of(stage, rig, element, 0) - element.members[0].track).max() < CLOSE * diagonal(rig)
        rim = handle_of(stage, rig, element, 0)[2:] - element.anchor.position
        assert np.allclose(np.linalg.norm(rim, axis=1), np.hypot(0.35, 0.6) * layout.frame.handle_width, rtol=2e-2)
