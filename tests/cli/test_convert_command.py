"""`convert`, and layers of the first format before every command; tests/first_format holds one as it was written."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import laid_out
import numpy as np
import pytest
from pxr import Sdf, Usd

from usdrigui.cli import main
from usdrigui.settings import Settings
from usdrigui.usd.read_layout import read_layout
from usdrigui.usd.rig import read_rigs

FIRST = Path(__file__).resolve().parents[1] / "first_format"


@pytest.fixture
def folder(tmp_path):
    return Path(shutil.copytree(FIRST, tmp_path / "char"))


def run(capsys, *arguments, expected=0):
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == expected
    return json.loads(capsys.readouterr().out)


def facts(element):
    moved, look, placement = element.manipulator, element.look, element.placement
    shown = (look.label, look.side, look.adapt, look.inner)
    return moved.kind, moved.opposed, moved.mirror, moved.reversed, shown, placement.category, placement.reason


def test_the_same_layout_is_written_in_the_format_of_today(folder, capsys):
    layer = folder / "char.rigui.usda"
    (before,) = read_layout(layer)
    assert run(capsys, "convert", layer)["outcome"] == "written"
    assert 'RigUILayoutAPI_1"' in layer.read_text()
    (after,) = read_layout(layer)
    assert [each.name for each in after.elements] == [each.name for each in before.elements]
    for one, other in zip(before.elements, after.elements, strict=True):
        assert facts(one) == facts(other)
        assert (one.anchor.mesh, one.anchor.point) == (other.anchor.mesh, other.anchor.point)
        for member, again in zip(one.manipulator.members, other.manipulator.members, strict=True):
            assert np.allclose(member.track, again.track, atol=1e-6)
            assert np.allclose(member.values, again.values, atol=1e-5)
    assert run(capsys, "check", layer, "--strict")["issues"] == []


def test_the_first_layer_may_stay_as_it_is(folder, capsys):
    text = (folder / "char.rigui.usda").read_text()
    run(capsys, "convert", folder / "char.rigui.usda", "-o", folder / "new.usdc")
    assert (folder / "char.rigui.usda").read_text() == text
    assert (
        run(capsys, "diff", folder / "char.rigui.usda", folder / "new.usdc", "--strict")["characters"][0]["changes"]
        == []
    )


def test_converted_handles_follow_the_face(folder, capsys):
    run(capsys, "convert", folder / "char.rigui.usda")
    (rig,), (layout,) = read_rigs(folder / "char.usda", Settings()), read_layout(folder / "char.rigui.usda")
    pose = laid_out.random_values(rig, np.random.default_rng(1))
    stage = laid_out.baked(Sdf.Layer.FindOrOpen(str(folder / "char.rigui.usda")), rig, [pose])
    on_face = [element for element in layout.elements if not element.anchor.on_board]
    assert on_face
    for element in on_face:
        anchor = laid_out.root_points(stage, element.anchor.mesh, rig.skel_root.path, 0)[element.anchor.point]
        assert np.abs(laid_out.handle(stage, rig.skel_root.path, element, 0).mean(axis=0) - anchor).max() < 5e-5


@pytest.mark.parametrize("arguments", [["check"], ["process", "--previous"], ["picker", "--svg", "picker.svg"]])
def test_layers_of_the_first_format_are_read_by_every_command(folder, capsys, arguments, monkeypatch):
    monkeypatch.chdir(folder)
    command, *options = arguments
    if command == "process":
        arguments = [command, "char.usda", *options, "char.rigui.usda", "-o", "again.rigui.usda"]
    else:
        arguments = [command, "char.rigui.usda", *options]
    assert main(arguments) == 0
    if command == "process":
        assert run(capsys, "diff", "char.rigui.usda", "again.rigui.usda", "--strict")["characters"][0]["changes"] == []


def test_a_shot_over_a_layer_of_the_first_format_moves_its_handles(folder, capsys):
    """The base keeps its format; what is drawn of it follows a shape that only the shot has."""
    shot = Usd.Stage.CreateNew(str(folder / "shot.usda"))
    shot.GetRootLayer().subLayerPaths.append("./char.usda")
    face = shot.GetPrimAtPath("/Char/Face")
    shape = shot.DefinePrim("/Char/Face/fix", "BlendShape")
    shape.CreateAttribute("offsets", Sdf.ValueTypeNames.Vector3fArray).Set([(0, 0.5, 0)] * 6)
    names = ["smile", "frown", "fix"]
    face.GetAttribute("skel:blendShapes").Set(names)
    face.GetRelationship("skel:blendShapeTargets").SetTargets([f"/Char/Face/{name}" for name in names])
    shot.GetPrimAtPath("/Char/Anim").GetAttribute("blendShapes").Set(names)
    shot.GetPrimAtPath("/Char/Anim").GetAttribute("blendShapeWeights").Set([0, 0, 0])
    shot.GetRootLayer().Save()
    base, made = folder / "char.rigui.usda", folder / "shot.rigui.usda"
    run(capsys, "process", folder / "shot.usda", "--base", base, "-o", made)
    stage = Usd.Stage.Open(str(made))
    handles = [stage.GetPrimAtPath(f"/Char/RigUI/{name}/handle") for name in ("smile", "frown")]
    for handle in handles:
        assert "fix" in list(handle.GetAttribute("skel:blendShapes").Get())


def test_a_layout_from_another_layer_is_not_converted_here(folder, capsys):
    shot = folder / "shot.usda"
    shot.write_text("#usda 1.0\n(\n    subLayers = [@./char.rigui.usda@]\n)\n")
    assert run(capsys, "convert", shot, expected=1)["issues"][0]["code"] == "CONVERT_COMPOSED"
    (folder / "char.usda").write_text((folder / "char.usda").read_text().replace('"frown"', '"frowns"'))
    told = run(capsys, "convert", folder / "char.rigui.usda", expected=1)
    assert told["issues"][0]["code"] == "LAYOUT_STALE"
