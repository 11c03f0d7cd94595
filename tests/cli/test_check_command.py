"""`usdrigui check`: silent on a good layout, names each fault of a spoiled one by its code."""

import pytest
from commands import run
from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.cli import main
from usdrigui.layer.read_layout import element_prims
from usdrigui.pipeline import load_layer
from usdrigui.settings import Settings


def codes(layer, capsys, expected_exit=0, *options):
    found = run(capsys, "check", layer, *options, expected=expected_exit)["issues"]
    return {each["code"] for each in found if each["severity"] != "info"}


def elements(stage):
    scope = next(prim for prim in stage.TraverseAll() if prim.GetName() == "RigUI")
    return [prim for prim in element_prims(scope) if prim.GetRelationship("rigUI:anchor:prim").GetTargets()]


def test_a_fresh_layout_is_silent(layer, capsys):
    assert codes(layer, capsys) == set()


def test_rates_every_element_on_the_face(layer, capsys):
    rated = run(capsys, "check", layer)["characters"][0]["elements"]
    assert len(rated) == len(elements(Usd.Stage.Open(str(layer))))
    assert all(0.0 < each["kept"] <= 1.0 + 1e-6 for each in rated)


def test_a_sculpt_after_the_layout_was_made_is_one_finding(layer, capsys):
    source = str(layer.with_name("char.usda"))
    stage = Usd.Stage.Open(source)
    for prim in stage.Traverse():
        for array in filter(None, map(prim.GetAttribute, ("points", "offsets"))):
            array.Set([(0.85 * x, 1.1 * y, 1.2 * z) for x, y, z in array.Get()])
    stage.GetRootLayer().Save()
    assert {"LAYOUT_RESHAPED", "LAYOUT_TRACK", "LAYOUT_DRAWN"} <= codes(layer, capsys, expected_exit=1)
    assert main(["check", str(layer)]) == 1
    told = [line for line in capsys.readouterr().out.splitlines() if "LAYOUT_" in line]
    assert len(told) == 1
    assert told[0].startswith("error: LAYOUT_RESHAPED")
    assert main(["process", source, "--previous", str(layer)]) == 0
    assert codes(layer, capsys) == set()


@pytest.mark.parametrize("variant", ["none", "slip"])
def test_a_character_whose_layout_is_not_composed_is_no_layout_that_fits(layer, variant, capsys):
    shot = Usd.Stage.CreateNew(str(layer.with_name("shot.usda")))
    prim = shot.DefinePrim("/Char")
    prim.GetReferences().AddReference(layer.name)
    (root,) = (each for each in shot.Traverse() if each.IsA(UsdSkel.Root))
    root.GetVariantSet("rigUI").SetVariantSelection(variant)
    shot.Save()
    path = str(layer.with_name("shot.usda"))
    assert main(["check", path, "--strict"]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "has its layouts switched off; the asset is valid" in said
    assert f"is switched off, by rigUI = {variant} on {root.GetPath()}. Select `rigUI = ui`" in said
    for command in (
        ["picture", "-o", path + ".png"],
        ["view", "--html", path + ".html"],
        ["picker", "--svg", path + ".svg"],
    ):
        assert main([*command, path]) == 1
        assert "LAYOUT_OFF" in capsys.readouterr().err
    assert main(["check", path, "--variant", "rigUI=ui"]) == 0
    assert "fits its rig" in capsys.readouterr().out


@pytest.mark.parametrize("turn", [(-90, 0, 0), (90, 0, 40), (0, 20, 90)])
def test_a_character_that_lies_down_in_a_shot_is_judged_as_it_stands(layer, turn, capsys):
    """A Z-up asset in a Y-up shot lies on its back: the views turn with it."""
    shot = Usd.Stage.CreateNew(str(layer.with_name("shot.usda")))
    place = UsdGeom.Xform.Define(shot, "/Hero")
    place.GetPrim().GetReferences().AddReference(layer.name)
    place.AddRotateXYZOp().Set(turn)
    shot.Save()
    assert codes(layer.with_name("shot.usda"), capsys) == set()
    ((rig, _),) = load_layer(layer.with_name("shot.usda"), Settings()).characters
    assert rig.up.tolist() == [0, 1, 0], "pictures, too"


def test_what_only_reads_does_not_say_that_it_wrote_nothing(capsys):
    for command in (["check", "no.usda"], ["diff", "no.usda", "no.usda"], ["inspect", "no.usda"]):
        assert main(command) != 0
        assert "written" not in capsys.readouterr().err


@pytest.mark.parametrize(
    ("kind", "inner", "code"),
    [("Xform", "", "SKELROOT_MISSING"), ("Xform", "SkelRoot", "INSTANCE"), ("SkelRoot", "Xform", "INSTANCE")],
)
def test_an_asset_that_process_would_refuse_is_refused_alike(tmp_path, kind, inner, code, capsys):
    asset = tmp_path / "char.usda"
    own = f'over "Own"\n{{\n    def {inner} "body"\n    {{\n    }}\n}}\n' if inner else ""
    arc = " (\n    instanceable = true\n    references = </Own>\n)" if inner else ""
    asset.write_text(f'#usda 1.0\n\ndef {kind} "Char"{arc}\n{{\n}}\n\n{own}')
    assert code in codes(asset, capsys, expected_exit=1)
    assert main(["process", str(asset)]) == 1
    assert code in capsys.readouterr().err


def test_a_source_asset_is_checked_for_all_its_faults(layer, capsys):
    source = layer.with_name("char.usda")
    assert not codes(source, capsys) & {"TARGET_INVALID", "INBETWEEN_INVALID", "OFFSETS_LENGTH"}
    stage = Usd.Stage.Open(str(source))
    first, second = [prim for prim in stage.Traverse() if prim.GetTypeName() == "BlendShape"][:2]
    offsets = first.GetAttribute("offsets")
    offsets.Set(offsets.Get()[1:])
    stage.RemovePrim(second.GetPath())
    stage.GetRootLayer().Save()
    assert codes(source, capsys, expected_exit=1) == {"OFFSETS_LENGTH", "TARGET_INVALID"}, "each once"
