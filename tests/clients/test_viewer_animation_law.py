"""What the viewer shows at a frame is what USD evaluates from the layer that it saves over the source.

The viewer's sources run in Node.js, without a browser, on sessions of random keys; USD composes the saved layer
over the source and evaluates it.
"""

import base64
import json

import laid_out
import numpy as np
import pytest
from page_in_node import answer
from pxr import Sdf, Usd, UsdSkel
from random_characters import composed, off, random_character
from skel_stages import character

from usdrigui.layer import baking
from usdrigui.layer.read_layout import layout_scopes, read_layout
from usdrigui.reading.character import read_rigs
from usdrigui.settings import ReadSettings, load
from usdrigui.view.web.packing import pack

TOLERANCE = 1e-5
HALF = 2.0**-10
"""What USD itself leaves of scales that change in time: a SkelAnimation holds them as halves."""
SEEDS = range(24)


def random_actions(rig, rng, last):
    names = rig.control_names

    def some():
        return rng.choice(names, min(len(names), rng.integers(1, 4)), replace=False).tolist()

    def values():
        bounds = {control.name: (control.minimum, control.maximum) for control in rig.controls}
        return {name: float(rng.uniform(*bounds[name])) for name in some()}

    actions = []
    for _ in range(rng.integers(2, 7)):
        actions.append(["go", int(rng.integers(1, last + 1))])
        changed = values()
        actions.append(["set", changed])
        actions.append(
            [["key", [*changed]], ["key", some()], ["unkey", some()], ["reset"], ["undo"], ["redo"], ["autoKey", True]][
                rng.choice(7, p=[0.5, 0.14, 0.1, 0.06, 0.08, 0.06, 0.06])
            ]
        )
        actions.append(["go on", str(rng.choice(["linear", "smooth", "stepped"])), some()])
    actions.append(["bend", some(), rng.uniform(-0.2, 0.2)])
    return actions


def random_case(folder, seed):
    rng = np.random.default_rng(seed)
    path = folder / f"shot{seed}.usda"
    if seed % 6 == 5:
        character(path)
    else:
        (folder / str(seed)).mkdir()
        path = folder / str(seed) / "shot.usda"
        random_character(path, rng)
    poses = {"grin": {"weights": {"shared": 0.5, "a0": 1.0}}} if seed % 6 != 5 else {}
    joints = ["all", "none", "auto"][seed % 3]
    rig = read_rigs(path, load({"read": {"joints": joints}, "poses": poses}))[0]
    last = 30
    return path, rig, random_actions(rig, rng, last), [*range(1, last + 1), *(rng.uniform(0, last, 10).tolist())]


def layer_of(source):
    return source.with_suffix(".rigui.usda")


def written_layout(source, rig):
    """A layout of all controls as it is read from its layer, which sublayers the source."""
    laid_out.written(source, rig, laid_out.layout_of(rig), layer_of(source).name)
    (layout,) = read_layout(layer_of(source))
    return layout


@pytest.fixture(scope="module")
def replayed(tmp_path_factory):
    """Every case with what the viewer makes of it; one process for all."""
    folder = tmp_path_factory.mktemp("law")
    cases = [random_case(folder, seed) for seed in SEEDS]
    asked = [
        {
            "scene": base64.b64encode(pack([(rig, written_layout(path, rig))], "law")).decode(),
            "actions": actions,
            "times": times,
        }
        for path, rig, actions, times in cases
    ]
    return list(zip(cases, json.loads(answer("replay.mjs", asked)), strict=True))


def test_every_frame_shown_is_what_usd_evaluates(replayed, tmp_path):
    saved = 0
    for seed, ((source, rig, actions, times), found) in zip(SEEDS, replayed, strict=True):
        assert found["unwritten"] == []
        stage = composed(tmp_path / f"{seed}.usda", found["layer"] or "#usda 1.0\n", source)
        saved += bool(found["layer"])
        for time, shown, again in zip(times, found["frames"], found["again"] or found["frames"], strict=True):
            of_weights, of_joints = off(shown, stage, rig, time)
            rounding = HALF if seed % 6 == 5 else 0.0
            assert of_weights < TOLERANCE, (seed, time, actions)
            if float(time).is_integer():
                assert of_joints < TOLERANCE + rounding, (seed, time, actions)
            assert np.allclose(shown["weights"], again["weights"], atol=1e-7), (seed, time)
            assert np.allclose(np.ravel(shown["locals"]), np.ravel(again["locals"]), atol=1e-7), (seed, time)
    assert saved > 0.8 * len(SEEDS)


def test_the_values_saved_are_what_the_samples_show(replayed, tmp_path):
    valued = 0
    for seed, ((source, _, actions, _), found) in zip(SEEDS, replayed, strict=True):
        for name, text in (("layer", found["layer"] or "#usda 1.0\n"), ("pose", found["pose"]["text"])):
            stage = composed(tmp_path / f"{seed}.{name}.usda", text, layer_of(source))
            (scope,) = layout_scopes(stage)
            told = baking.valued(scope, ReadSettings())
            valued += bool(told) and len(told.values)
            assert not [*baking.apart(told)], (seed, name, actions)
    assert valued > 3 * len(SEEDS)


def test_a_saved_pose_is_the_pose_shown(replayed, tmp_path):
    for seed, ((source, rig, actions, _), found) in zip(SEEDS, replayed, strict=True):
        stage = composed(tmp_path / f"{seed}.usda", found["pose"]["text"], source)
        of_weights, of_joints = off(found["pose"]["shown"], stage, rig, 5.0)
        assert of_weights < TOLERANCE, (seed, actions)
        # The joints are written where a control turns some, else the source has the say.
        if any(len(control.drive.joints) for control in rig.controls) and len(rig.body.skeletons) == 1:
            assert of_joints < TOLERANCE + HALF, (seed, actions)


def test_kept_poses_are_skel_animations_of_their_own_channels(replayed):
    reached = 0
    for seed, (_, found) in zip(SEEDS, replayed, strict=True):
        shelf = found["shelf"]
        assert shelf["again"] == [[name, pytest.approx(values, rel=1e-8)] for name, values in shelf["kept"]], seed
        stage = Usd.Stage.CreateInMemory()
        assert stage.GetRootLayer().ImportFromString(shelf["text"]), seed
        poses = stage.GetDefaultPrim().GetChildren()
        assert [prim.GetDisplayName() for prim in poses] == [name for name, _ in shelf["kept"]]
        for prim, expected in zip(poses, shelf["expected"], strict=True):
            written = {}
            for animation in map(UsdSkel.Animation, prim.GetChildren()):
                tokens, weights = animation.GetBlendShapesAttr().Get() or [], animation.GetBlendShapeWeightsAttr().Get()
                written |= dict(zip(map(str, tokens), weights or [], strict=True))
            assert written == pytest.approx(expected, abs=TOLERANCE), seed
            reached += len(written)
    assert reached > 50


def test_joints_without_keys_are_left_to_the_source(replayed):
    left = 0
    for seed, ((_, rig, _, _), found) in zip(SEEDS, replayed, strict=True):
        if not found["layer"]:
            continue
        layer = Sdf.Layer.CreateAnonymous(".usda")
        layer.ImportFromString(found["layer"])
        work = json.loads(layer.customLayerData["usdrigui"]["work"])
        reached = {
            rig.body.joints[int(joint)].skeleton
            for control in rig.controls
            if control.name in work["keys"] or control.name in work["standing"]
            for joint in control.drive.joints
        }
        for index, skeleton in enumerate(rig.body.skeletons):
            path = skeleton.animation or f"{skeleton.path}/usdrigui_animation"
            written = layer.GetAttributeAtPath(f"{path}.rotations") is not None
            assert written == (index in reached), seed
            left += not written and bool(skeleton.animation)
    assert left > 5
