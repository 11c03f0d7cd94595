"""A written layer, baked by UsdSkel alone: handles stay on the skin, tracks ignore their own controls."""

from __future__ import annotations

import laid_out
import numpy as np
import pytest
import skinned_stages
from pxr import Sdf, UsdGeom

from usdrigui.deform import deform
from usdrigui.settings import OutputSettings, Settings, load
from usdrigui.usd.layer import layer_for, stage_metadata
from usdrigui.usd.rig import read_rigs

CLOSE = 1e-5
"""Of the diagonal of the character's box."""
JAW = ("Hips/Head/Jaw",)
KINDS = {
    "linear": {},
    "dual quaternion": {"method": "dualQuaternion"},
    "without skin": {"skinned": False},
    "left-handed": {"left_handed": True},
    "joints in another order": {"reordered": True},
    "transforms everywhere": {"moved": True},
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


def written(folder, rig, layout, source, **settings):
    """The layer of one layout, saved over its source."""
    path = folder / "char.rigui.usda"
    metadata = stage_metadata(Sdf.Layer.FindOrOpen(str(source)))
    layer = layer_for([(rig, layout)], f"./{source.name}", OutputSettings(**settings), metadata)
    layer.Export(str(path))
    return Sdf.Layer.FindOrOpen(str(path))


def read(folder, settings=None, **kind):
    source = skinned_stages.character(folder / "char.usda", **kind)
    (rig,) = read_rigs(source, settings or Settings())
    return source, rig


def diagonal(rig):
    return float(np.linalg.norm(np.ptp(deform(rig), axis=0)))


def parts(stage, rig, element, role):
    """Prims of one element's tracks, areas or handle."""
    scope = stage.GetPrimAtPath(rig.root).GetChild("RigUI")
    xform = next(
        prim
        for prim in scope.GetChildren()
        if prim.GetAttribute("rigUI:element:name").Get() == element.name or prim.GetName() == element.name
    )
    return [prim for prim in xform.GetChildren() if prim.GetName().partition("_")[0] == role]


def points_of(stage, rig, prim, time):
    return laid_out.root_points(stage, str(prim.GetPath()), rig.root, time)


@pytest.mark.parametrize("kind", KINDS)
def test_handles_are_centred_on_their_deformed_anchors(tmp_path, kind):
    source, rig = read(tmp_path, **KINDS[kind])
    layout = laid_out.layout_of(rig)
    rng = np.random.default_rng(5)
    poses = [laid_out.defaults(rig), *(laid_out.random_values(rig, rng) for _ in range(3))]
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, poses)
    assert len(layout.elements) == len(rig.controls)
    travel = 0.0
    for element in layout.elements:
        (handle,) = parts(stage, rig, element, "handle")
        for time in range(len(poses)):
            centre = points_of(stage, rig, handle, time).mean(axis=0)
            anchor = laid_out.root_points(stage, element.anchor.mesh, rig.root, time)[element.anchor.point]
            assert np.abs(centre - anchor).max() < CLOSE * diagonal(rig), (element.name, time)
            travel = max(travel, float(np.linalg.norm(anchor - element.anchor.position)))
    assert travel > 0.02 * diagonal(rig)


@pytest.mark.parametrize("kind", KINDS)
def test_tracks_do_not_move_with_their_own_controls(tmp_path, kind):
    source, rig = read(tmp_path, **KINDS[kind])
    layout = laid_out.layout_of(rig, seed=3)
    names = [control.name for control in rig.controls]
    layer = written(tmp_path, rig, layout, source)
    around = laid_out.random_values(rig, np.random.default_rng(6))
    poses = [around]
    for control in rig.controls:
        for value in (control.minimum, control.maximum):
            pose = around.copy()
            pose[names.index(control.name)] = value
            poses.append(pose)
    stage = laid_out.baked(layer, rig, poses)
    for element in layout.elements:
        (track,), (handle,) = parts(stage, rig, element, "track"), parts(stage, rig, element, "handle")
        own = names.index(element.name)
        low, high = (points_of(stage, rig, track, 1 + 2 * own + end) for end in (0, 1))
        assert np.abs(high - low).max() < 1e-6 * diagonal(rig), element.name
        moved = points_of(stage, rig, handle, 2 + 2 * own) - points_of(stage, rig, handle, 1 + 2 * own)
        assert np.abs(moved).max() > 1e-3 * diagonal(rig), element.name


@pytest.mark.parametrize("kind", [name for name in KINDS if "all at once" not in name])
def test_handles_stay_on_their_tracks_whatever_else_moves(tmp_path, kind):
    source, rig = read(tmp_path, **KINDS[kind])
    names = [control.name for control in rig.controls]
    shapes = [control.name for control in rig.controls if control.kind == "blendShape"]
    layout = laid_out.layout_of(rig, seed=4, only=shapes)
    around = laid_out.random_values(rig, np.random.default_rng(8))
    poses, times = [], {}
    for element in layout.elements:
        for k, value in enumerate(element.members[0].values):
            times[element.name, k] = len(poses)
            poses.append(around.copy())
            poses[-1][names.index(element.name)] = value
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, poses)
    for element in layout.elements:
        (track,), (handle,) = parts(stage, rig, element, "track"), parts(stage, rig, element, "handle")
        for k in range(len(element.members[0].values)):
            time = times[element.name, k]
            centre = points_of(stage, rig, handle, time).mean(axis=0)
            there = points_of(stage, rig, track, time)[k]
            assert np.abs(centre - there).max() < CLOSE * diagonal(rig), (element.name, k)


@pytest.mark.parametrize("moved", [False, True])
def test_joint_tracks_follow_shapes_and_parents_exactly_on_a_hinge(tmp_path, moved):
    """Skin of head and jaw alone: the jaw's track is carried by the head and turned shapes ride along."""
    source, rig = read(tmp_path, animated_joints=("Hips/Head", *JAW), hinged=True, moved=moved)
    names = [control.name for control in rig.controls]
    layout = laid_out.layout_of(rig, seed=1, only=["Jaw:rx"])
    (element,) = layout.elements
    jaw = [name for name in names if name.startswith("Jaw:")]
    poses = []
    around = laid_out.random_values(rig, np.random.default_rng(9))
    for name in jaw:
        around[names.index(name)] = 0.0
    for value in element.members[0].values:
        poses.append(around.copy())
        poses[-1][names.index("Jaw:rx")] = value
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, poses)
    (track,), (handle,) = parts(stage, rig, element, "track"), parts(stage, rig, element, "handle")
    assert len(poses) > 2
    for time in range(len(poses)):
        centre = points_of(stage, rig, handle, time).mean(axis=0)
        assert np.abs(centre - points_of(stage, rig, track, time)[time]).max() < CLOSE * diagonal(rig)
    away = points_of(stage, rig, track, 0) - element.members[0].track
    assert np.abs(away).max() > 0.01 * diagonal(rig)


def test_pose_controls_leave_their_own_tracks_alone(tmp_path):
    settings = load({"poses": {"talk": {"frame": 10.0}, "mix": {"weights": {"brow_L": 0.6, "chin": 1.0}}}})
    source, rig = read(tmp_path, settings, animated_joints=JAW)
    names = [control.name for control in rig.controls]
    layout = laid_out.layout_of(rig, only=["talk", "mix"])
    assert [element.name for element in layout.elements] == ["talk", "mix"]
    base = laid_out.defaults(rig)
    poses = [base]
    for name in ("talk", "mix"):
        poses.append(base.copy())
        poses[-1][names.index(name)] = 1.0
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, poses)
    for time, element in enumerate(layout.elements, start=1):
        (track,), (handle,) = parts(stage, rig, element, "track"), parts(stage, rig, element, "handle")
        assert np.abs(points_of(stage, rig, track, time) - points_of(stage, rig, track, 0)).max() < 1e-6
        end = points_of(stage, rig, handle, time).mean(axis=0)
        assert np.abs(end - element.members[0].track[-1]).max() < CLOSE * diagonal(rig)
        assert np.linalg.norm(end - element.anchor.position) > 1e-3


def test_the_root_joint_leaves_its_own_track_behind(tmp_path):
    """Nothing above the root carries the track, so it stays where it is."""
    source, rig = read(tmp_path, animated_joints=("Hips",))
    layout = laid_out.layout_of(rig, only=["Hips:rx"])
    names = [control.name for control in rig.controls]
    pose = laid_out.defaults(rig)
    pose[names.index("Hips:rx")] = rig.controls[names.index("Hips:rx")].maximum
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, [laid_out.defaults(rig), pose])
    (element,) = layout.elements
    (track,), (handle,) = parts(stage, rig, element, "track"), parts(stage, rig, element, "handle")
    for time in (0, 1):
        assert np.abs(points_of(stage, rig, track, time) - element.members[0].track).max() < CLOSE * diagonal(rig)
    assert np.abs(points_of(stage, rig, handle, 1).mean(axis=0) - element.members[0].track[-1]).max() < 1e-4


def test_areas_hold_the_handle_and_ignore_all_their_controls(tmp_path):
    source, rig = read(tmp_path, animated_joints=JAW)
    group = ("smile_L", "sneer_L")
    layout = laid_out.layout_of(rig, seed=2, groups=[group, ("jawLeft", "chin", "jaw:open")])
    names = [control.name for control in rig.controls]
    around = laid_out.random_values(rig, np.random.default_rng(3))
    poses = []
    for corner in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)):
        poses.append(around.copy())
        for name, value in zip(group, corner, strict=True):
            poses[-1][names.index(name)] = value
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, poses)
    patch = layout.elements[0]
    (area,), (handle,) = parts(stage, rig, patch, "area"), parts(stage, rig, patch, "handle")
    weights = np.array(area.GetAttribute("rigUI:track:weights").Get()).reshape(-1, 2)
    still = points_of(stage, rig, area, 0)
    for time, corner in enumerate(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0))):
        assert np.abs(points_of(stage, rig, area, time) - still).max() < 1e-6
        vertex = np.flatnonzero((weights == corner).all(axis=1))
        centre = points_of(stage, rig, handle, time).mean(axis=0)
        assert np.abs(still[vertex] - centre).max() < CLOSE * diagonal(rig)
    (fan,) = parts(stage, rig, layout.elements[1], "area")
    assert len(parts(stage, rig, layout.elements[1], "track")) == 3
    assert set(UsdGeom.Mesh(fan).GetFaceVertexCountsAttr().Get()) == {4}


@pytest.mark.parametrize("adapt", ["deform", "static"])
@pytest.mark.parametrize("skinned", [False, True])
def test_elements_beside_the_face_or_static_do_not_deform_but_show_their_value(tmp_path, adapt, skinned):
    source, rig = read(tmp_path, skinned=skinned, animated_joints=("Hips",))
    names = [control.name for control in rig.controls]
    beside = ("brow_L", "chin") if adapt == "deform" else ()
    layout = laid_out.layout_of(rig, beside=beside, adapt=adapt, only=["brow_L", "chin", "half"])
    rng = np.random.default_rng(2)
    shapes_only = laid_out.random_values(rig, rng)
    hips = [i for i, name in enumerate(names) if name.startswith("Hips:")]
    shapes_only[hips] = 0.0
    turned = laid_out.random_values(rig, rng)
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, [laid_out.defaults(rig), shapes_only, turned])
    for element in layout.elements:
        if adapt == "deform" and element.name not in beside:
            continue
        (track,), (handle,) = parts(stage, rig, element, "track"), parts(stage, rig, element, "handle")
        member = element.members[0]
        assert np.abs(points_of(stage, rig, track, 1) - member.track).max() < CLOSE * diagonal(rig)
        value = shapes_only[names.index(element.name)]
        there = [np.interp(value, member.values, member.track[:, axis]) for axis in range(3)]
        centre = points_of(stage, rig, handle, 1).mean(axis=0)
        assert np.abs(centre - there).max() < CLOSE * diagonal(rig), element.name
        if skinned:
            carried = np.abs(points_of(stage, rig, track, 2) - member.track).max()
            assert carried > 1e-3 * diagonal(rig), element.name


def test_a_static_element_is_carried_rigidly(tmp_path):
    source, rig = read(tmp_path, animated_joints=("Hips/Head", *JAW))
    layout = laid_out.layout_of(rig, adapt="static")
    pose = laid_out.random_values(rig, np.random.default_rng(2))
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, [laid_out.defaults(rig), pose])
    for element in layout.elements:
        for prim in parts(stage, rig, element, "track"):
            first, last = (points_of(stage, rig, prim, time) for time in (0, 1))
            for one in range(1, len(first)):
                before, after = np.linalg.norm(first[one] - first[0]), np.linalg.norm(last[one] - last[0])
                assert abs(before - after) < 1e-5 * diagonal(rig)
            assert not prim.GetRelationship("skel:blendShapeTargets").HasAuthoredTargets()


def test_layouts_of_another_base_pose_stand_where_the_pose_puts_them(tmp_path):
    source, rig = read(tmp_path, animated_joints=("Hips/Head", *JAW), moved=True)
    base = 0.5 * laid_out.random_values(rig, np.random.default_rng(1))
    layout = laid_out.layout_of(rig, base_values=base)
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, [base, laid_out.defaults(rig)])
    for element in layout.elements:
        (track,), (handle,) = parts(stage, rig, element, "track"), parts(stage, rig, element, "handle")
        assert np.abs(points_of(stage, rig, track, 0) - element.members[0].track).max() < CLOSE * diagonal(rig)
        ball = points_of(stage, rig, handle, 0) - element.anchor.position
        assert np.allclose(np.linalg.norm(ball, axis=1), 0.5 * layout.handle_width, rtol=1e-3)


@pytest.mark.parametrize("arc", ["references", "payload"])
def test_characters_behind_composition_arcs_are_laid_out_on_their_composed_path(tmp_path, arc):
    """A reference or payload inside a variant: the layer's overs reach what the asset's root layer composes."""
    skinned_stages.character(tmp_path / "model.usda")
    source = tmp_path / "shot.usda"
    source.write_text(f"""#usda 1.0
(
    defaultPrim = "Shot"
    upAxis = "Y"
)
def Xform "Shot"
{{
    def "Hero" (
        variants = {{
            string look = "young"
        }}
        prepend variantSets = "look"
    )
    {{
        variantSet "look" = {{
            "young" (
                prepend {arc} = @./model.usda@
            )
            {{
            }}
        }}
    }}
}}
""")
    (rig,) = read_rigs(source, Settings())
    assert rig.root == "/Shot/Hero/Char"
    layout = laid_out.layout_of(rig)
    pose = laid_out.random_values(rig, np.random.default_rng(5))
    stage = laid_out.baked(written(tmp_path, rig, layout, source), rig, [pose])
    for element in layout.elements:
        (handle,) = parts(stage, rig, element, "handle")
        anchor = laid_out.root_points(stage, element.anchor.mesh, rig.root, 0)[element.anchor.point]
        assert np.abs(points_of(stage, rig, handle, 0).mean(axis=0) - anchor).max() < CLOSE * diagonal(rig)
