"""Values keyed on the controls in stock USD, baked, and played by UsdSkel."""

import laid_out
import numpy as np
import pytest
import skinned_stages
from pxr import Sdf, Usd, UsdSkel

import usdrigui
from usdrigui import pipeline
from usdrigui.character.deform import deform
from usdrigui.errors import RigUIError
from usdrigui.layer.baking import apart, bake, valued
from usdrigui.layer.read_layout import element_prims
from usdrigui.reader.in_memory import read_open_layouts
from usdrigui.reading.character import read_rigs
from usdrigui.settings import ReadSettings, Settings
from usdrigui.view.clip import clip_values

CLOSE = 1e-5
"""Of the character's size, which is 2 units."""
ROOT = "/World/Char"
GROUPS = (
    ("Jaw:rx", "Jaw:ry"),
    ("half",),
    ("smile_L", "sneer_L"),
    ("brow_L",),
    ("pucker", "jawLeft", "chin"),
    ("Eye:rx", "Eye:ry"),
    ("Head:rx", "Head:ry"),
)
"""Joystick of a joint, in-betweens, patch and fan of shapes, and joints above and beside."""


@pytest.fixture(scope="module")
def shot(tmp_path_factory):
    """Rig, and a layout layer over its character, which is animated."""
    folder = tmp_path_factory.mktemp("valued")
    joints = ("Hips/Head", "Hips/Head/Jaw", "Hips/Head/Eye")
    source = skinned_stages.character(folder / "made.usda", animated_joints=joints, reordered=True, moved=True)
    (rig,) = read_rigs(source, Settings())
    layout = laid_out.layout_of(rig, groups=GROUPS)
    laid_out.written(source, rig, layout, "layout.usda")
    return rig, folder / "layout.usda"


def opened(path):
    stage = Usd.Stage.Open(str(path))
    stage.SetEditTarget(stage.GetSessionLayer())
    return stage


def attributes(stage):
    """By the name of a control, that of its value."""
    found = {}
    for prim in element_prims(laid_out.scope_of(stage, ROOT)):
        for each in prim.GetAttributes():
            if each.GetName().endswith(":value"):
                name = prim.GetAttribute(each.GetName()[: -len("value")] + "name").Get()
                found[name or each.GetName().split(":")[2]] = each
    return found


def over(stage, layer):
    """The stage with a layer above all that it has."""
    whole = Sdf.Layer.CreateAnonymous(".usda")
    whole.subLayerPaths[:] = [layer.identifier, stage.GetSessionLayer().identifier, stage.GetRootLayer().identifier]
    whole.timeCodesPerSecond = stage.GetTimeCodesPerSecond()
    return Usd.Stage.Open(whole)


def points(stage, rig, time):
    return np.concatenate([laid_out.root_points(stage, mesh.path, ROOT, time) for mesh in rig.body.meshes])


@pytest.fixture(scope="module")
def keyed(shot):
    """The stage with each control keyed, what it was keyed to, (10, controls), and the layer that is baked."""
    rig, path = shot
    stage, rng = opened(path), np.random.default_rng(3)
    values = np.array([laid_out.random_values(rig, rng) for _ in range(10)])
    for index, control in enumerate(rig.controls):
        if control.name in attributes(stage):
            for time in range(0, 10, 3):
                attributes(stage)[control.name].Set(values[time, index], time)
    return stage, values, usdrigui.bake(stage)


def test_usdskel_plays_what_the_values_say_at_every_frame(shot, keyed):
    (rig, _), (stage, _, layer) = shot, keyed
    played = over(stage, layer)
    assert UsdSkel.BakeSkinning(UsdSkel.Root(played.GetPrimAtPath(ROOT)))
    read = attributes(stage)
    assert {*read} == {name for group in GROUPS for name in group}
    for time in (*range(10), 1.5, 4.25):
        # Between frames joints turn on the sphere: exact are the shapes.
        values = [read[each.name].Get(time) if each.name in read else each.default for each in rig.controls]
        far = np.abs(points(played, rig, time) - deform(rig, values)).max()
        assert far < (2 * CLOSE if time == int(time) else 3e-2), time


def test_the_values_come_back_from_the_samples(keyed):
    stage, _, layer = keyed
    played = over(stage, layer)
    (read,) = read_rigs(played, Settings())
    back, names = clip_values(read), read.control_names
    for name, attribute in attributes(stage).items():
        at = [attribute.Get(time) for time in read.clip.times]
        assert np.abs(back[:, names.index(name)] - at).max() < 1e-4, name


def test_what_is_baked_agrees_and_is_baked_again_to_the_same(keyed):
    stage, _, layer = keyed
    settings, scope = ReadSettings(), laid_out.scope_of(stage, ROOT)
    assert {each.code for each in apart(valued(scope, settings))} == {"LAYOUT_VALUE"}
    played = over(stage, layer)
    assert not [*apart(valued(laid_out.scope_of(played, ROOT), settings))]
    again, path = bake(played, settings), Sdf.Path(f"{ROOT}/Anim.blendShapeWeights")
    for time in layer.ListTimeSamplesForPath(path):
        assert np.allclose(*(each.QueryTimeSample(path, time) for each in (layer, again)), atol=1e-6)


def test_what_no_value_reaches_stays_as_it_was(shot):
    """One control of one axis of a joint: no weight, no translation, and no other axis of that joint."""
    rig, path = shot
    stage = opened(path)
    keyed, times = attributes(stage)["Jaw:rx"], rig.clip.times.tolist()
    for time, value in ((1.0, 7.0), (20.0, -4.0)):
        keyed.Set(value, time)
    layer = bake(stage, ReadSettings())
    assert [each.name for each in layer.GetPrimAtPath(f"{ROOT}/Anim").properties] == ["rotations"]
    (after,) = read_rigs(over(stage, layer), Settings())
    rows = np.searchsorted(after.clip.times, times)
    now, old = clip_values(after)[rows], clip_values(rig)
    for index, control in enumerate(rig.controls):
        wanted = [keyed.Get(time) for time in times] if control.name == "Jaw:rx" else old[:, index]
        found = now[:, after.control_indices[control.name]]
        assert np.abs(found - wanted).max() < 1e-4, control.name


@pytest.mark.skipif(Usd.GetVersion() < (0, 25, 5), reason="attributes have the values of splines since USD 25.5")
def test_splines_are_sampled_at_every_frame(shot):
    from pxr import Ts

    _, path = shot
    stage = opened(path)
    spline = Ts.Spline("double")
    for time, value, way in ((0.0, 0.0, Ts.InterpCurve), (6.0, 1.0, Ts.InterpHeld), (7.5, 0.5, Ts.InterpHeld)):
        spline.SetKnot(Ts.Knot("double", time=time, value=value, nextInterp=way))
    attribute = attributes(stage)["brow_L"]
    assert attribute.SetSpline(spline)
    layer = bake(stage, ReadSettings())
    tokens = [*stage.GetPrimAtPath(f"{ROOT}/Anim").GetAttribute("blendShapes").Get()]
    played = over(stage, layer)
    for time in (*range(9), 7.49, 7.5):
        row = played.GetAttributeAtPath(f"{ROOT}/Anim.blendShapeWeights").Get(time)
        assert row[tokens.index("brow_L")] == pytest.approx(attribute.Get(time), abs=1e-6)


def test_a_still_value_is_a_default_where_nothing_moves_and_missing_entries_are_added(shot):
    rig, path = shot
    stage = opened(path)
    bare = stage.GetPrimAtPath(f"{ROOT}/Anim")
    for each in ("blendShapeWeights", "translations", "rotations", "scales"):
        bare.GetAttribute(each).Block()
    bare.GetAttribute("blendShapes").Set([])
    bare.GetAttribute("joints").Set([])
    attributes(stage)["smile_L"].Set(0.5)
    attributes(stage)["Jaw:rx"].Set(5.0)
    played = over(stage, bake(stage, ReadSettings()))
    assert UsdSkel.BakeSkinning(UsdSkel.Root(played.GetPrimAtPath(ROOT)))
    given = {"smile_L": 0.5, "Jaw:rx": 5.0}
    values = [given.get(each.name, each.default) for each in rig.controls]
    assert np.abs(points(played, rig, 0) - deform(rig, values)).max() < 2 * CLOSE


@pytest.mark.parametrize(("value", "code"), [(np.nan, "NOT_FINITE"), (None, "VALUES_MISSING")])
def test_what_cannot_be_baked_is_refused_by_a_code(shot, value, code):
    stage = opened(shot[1])
    if value is not None:
        attributes(stage)["smile_L"].Set(value)
    with pytest.raises(RigUIError, match=code):
        bake(stage, ReadSettings())


def test_the_command_writes_beside_the_shot_and_over_nothing_else(shot, tmp_path):
    text = f"#usda 1.0\n(\n    subLayers = [@{shot[1]}@]\n)\n"
    (tmp_path / "shot.usda").write_text(text)
    stage = Usd.Stage.Open(str(tmp_path / "shot.usda"))
    attributes(stage)["smile_L"].Set(0.5)
    stage.Save()
    state, target = pipeline.bake(tmp_path / "shot.usda", Settings())
    assert (state, target.name) == ("written", "shot.baked.usda")
    assert pipeline.bake(tmp_path / "shot.usda", Settings())[0] == "unchanged"
    for other in ("shot.usda", "own.usda", "shot.usdc"):
        (tmp_path / "own.usda").write_text("#usda 1.0\n")
        with pytest.raises(RigUIError, match="FILE_TARGET"):
            pipeline.bake(tmp_path / "shot.usda", Settings(), tmp_path / other)


def test_a_page_shows_what_the_values_say(shot):
    """No sample is baked: the clip is that of the values, and nothing changes on the caller's stage."""
    stage = opened(shot[1])
    for time in range(4):
        attributes(stage)["smile_L"].Set(0.25 * time, time)
    before = stage.GetSessionLayer().ExportToString()
    (read,) = read_open_layouts(stage, Settings())[1].rigs
    index = read.control_indices["smile_L"]
    rows = np.searchsorted(read.clip.times, range(4))
    assert clip_values(read)[rows, index] == pytest.approx([0.0, 0.25, 0.5, 0.75], abs=1e-6)
    assert stage.GetSessionLayer().ExportToString() == before
