"""`process --fixed`, `process --previous` and `usdrigui diff` over the life of a character's files."""

import json
import shutil

import pytest
import skinned_stages
from pxr import Sdf, Usd, UsdSkel

from usdrigui.cli import main
from usdrigui.usd.read_layout import edited_elements, read_layout


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory):
    character = skinned_stages.character(tmp_path_factory.mktemp("once") / "char.usda")
    assert main(["process", str(character), "--quiet"]) == 0
    return character.parent


@pytest.fixture
def folder(laid_out, tmp_path):
    shutil.copytree(laid_out, tmp_path / "asset")
    (tmp_path / "asset" / "char.rigui.usda").rename(tmp_path / "asset" / "old.rigui.usda")
    return tmp_path / "asset"


def run(capsys, *arguments, expected=0):
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == expected
    return json.loads(capsys.readouterr().out)


def anchors(layer):
    (layout,) = read_layout(layer)
    return {element.name: (element.anchor.point, element.anchor.beside) for element in layout.elements}


def on_face(layer):
    (layout,) = read_layout(layer)
    return [element for element in layout.elements if not element.anchor.beside and not element.mirror]


def lose_control(asset, token):
    """Take one blend shape off the character's meshes and animation."""
    stage = Usd.Stage.Open(str(asset))
    for prim in stage.Traverse():
        binding = UsdSkel.BindingAPI(prim)
        shapes = list(binding.GetBlendShapesAttr().Get() or ()) if binding.GetBlendShapesAttr() else []
        if token in shapes and prim.IsA("Mesh"):
            targets = binding.GetBlendShapeTargetsRel().GetTargets()
            targets.pop(shapes.index(token))
            shapes.remove(token)
            binding.GetBlendShapesAttr().Set(shapes)
            binding.GetBlendShapeTargetsRel().SetTargets(targets)
        if prim.IsA("SkelAnimation"):
            animation = UsdSkel.Animation(prim)
            tokens, weights = (
                list(animation.GetBlendShapesAttr().Get()),
                list(animation.GetBlendShapeWeightsAttr().Get()),
            )
            weights.pop(tokens.index(token))
            tokens.remove(token)
            animation.GetBlendShapesAttr().Set(tokens)
            animation.GetBlendShapeWeightsAttr().Set(weights)
    stage.GetRootLayer().Save()


def corrected(folder, element, point):
    """A stronger layer that moves one anchor, as an artist would, and paints its handle."""
    over = Usd.Stage.CreateNew(str(folder / "corrections.usda"))
    over.GetRootLayer().subLayerPaths.append("./old.rigui.usda")
    (prim,) = [scope.GetChild(element) for scope in over.TraverseAll() if scope.GetName() == "RigUI"]
    prim.GetAttribute("rigUI:anchor:pointIndex").Set(point)
    prim.SetDisplayName("corrected by hand")
    over.GetRootLayer().Save()
    return folder / "corrections.usda"


def another_point(folder, name):
    """A point that the element's control moves and that is nobody's anchor."""
    stage = Usd.Stage.Open(str(folder / "char.usda"))
    shapes = [UsdSkel.BlendShape(prim) for prim in stage.TraverseAll() if prim.IsA("BlendShape")]
    (shape,) = [shape for shape in shapes if shape.GetPrim().GetName() == name]
    offsets = shape.GetOffsetsAttr().Get()
    points = list(shape.GetPointIndicesAttr().Get() or range(len(offsets)))
    far = sorted(zip((offset.GetLength() for offset in offsets), points, strict=True))
    taken = {point for point, _ in anchors(folder / "old.rigui.usda").values()}
    return next(point for length, point in far if length > 0.3 * far[-1][0] and point not in taken)


def test_fixed_anchors_come_back_exactly(folder, capsys):
    new = folder / "new.rigui.usda"
    run(capsys, "process", folder / "char.usda", "--fixed", folder / "old.rigui.usda", "-o", new)
    assert anchors(new) == anchors(folder / "old.rigui.usda")
    assert run(capsys, "diff", folder / "old.rigui.usda", new, "--strict")["characters"][0]["changes"] == []


def test_a_fixed_layer_with_a_control_that_is_gone_is_refused(folder, capsys):
    lose_control(folder / "char.usda", "chin")
    told = run(capsys, "process", folder / "char.usda", "--fixed", folder / "old.rigui.usda", expected=2)
    assert told["issues"][0]["code"] == "CONFIG_UNKNOWN_CONTROL"
    assert "chin" in told["issues"][0]["message"]
    assert not (folder / "char.rigui.usda").exists()


def test_a_handle_fixed_on_another_is_refused(folder, capsys):
    places = anchors(folder / "old.rigui.usda")
    mesh = on_face(folder / "old.rigui.usda")[0].anchor.mesh
    (folder / "char.rigui.toml").write_text(
        "".join(f'[controls."{name}"]\nanchor = "{mesh}#{places["pucker"][0]}"\n' for name in ("pucker", "smile_L"))
    )
    told = run(capsys, "process", folder / "char.usda", expected=2)
    assert told["issues"][0]["code"] == "FIXED_IMPOSSIBLE"


def test_the_previous_layout_is_kept_and_the_diff_is_told(folder, capsys):
    lose_control(folder / "char.usda", "chin")
    told = run(capsys, "process", folder / "char.usda", "--previous", folder / "old.rigui.usda")
    found = told["characters"][0]["difference"]
    assert [(each["control"], each["kind"]) for each in found["changes"]] == [("chin", "removed")]
    assert found["displaced"] == 0
    before, after = anchors(folder / "old.rigui.usda"), anchors(folder / "char.rigui.usda")
    assert {name: before[name] for name in after} == after
    capsys.readouterr()
    assert main(["process", str(folder / "char.usda"), "--previous", str(folder / "old.rigui.usda")]) == 0
    printed = capsys.readouterr().out
    assert "since the previous layout:" in printed
    assert "removed" in printed


def test_at_a_price_of_zero_the_previous_layout_changes_nothing(folder, capsys):
    corrections = corrected(folder, "smile_L", another_point(folder, "smile_L"))
    new = folder / "new.rigui.usda"
    zero = ("--set", "objective.keep_price=0")
    run(capsys, "process", folder / "char.usda", "--previous", corrections, *zero, "-o", new)
    run(capsys, "process", folder / "char.usda", *zero, "-o", folder / "plain.rigui.usda")
    assert new.read_bytes() == (folder / "plain.rigui.usda").read_bytes()


def test_a_correction_in_a_stronger_layer_survives(folder, capsys):
    point = another_point(folder, "smile_L")
    corrections = corrected(folder, "smile_L", point)
    assert edited_elements(Usd.Stage.Open(str(corrections))) == {"/World/Char": ("smile_L",)}
    assert edited_elements(Usd.Stage.Open(str(folder / "old.rigui.usda"))) == {}
    new = folder / "new.rigui.usda"
    run(capsys, "process", folder / "char.usda", "--previous", corrections, "-o", new)
    assert anchors(new)["smile_L"] == (point, False)
    # The stronger layer over the new one says the same as over the old one, and the rest of it stands too.
    layer = Sdf.Layer.FindOrOpen(str(corrections))
    layer.subLayerPaths[:] = ["./new.rigui.usda"]
    layer.Save()
    stage = Usd.Stage.Open(str(corrections))
    (prim,) = [scope.GetChild("smile_L") for scope in stage.TraverseAll() if scope.GetName() == "RigUI"]
    assert prim.GetDisplayName() == "corrected by hand"
    assert anchors(corrections)["smile_L"] == (point, False)


def test_diff_tells_what_moved_by_how_much_and_fails_when_strict(folder, capsys):
    point = another_point(folder, "smile_L")
    corrections = corrected(folder, "smile_L", point)
    found = run(capsys, "diff", folder / "old.rigui.usda", corrections)["characters"][0]
    (change,) = found["changes"]
    assert (change["control"], change["kind"]) == ("smile_L", "moved")
    assert change["after"].endswith(f"#{point}")
    assert found["shared"] == sum(len(e.members) for e in read_layout(corrections)[0].elements)
    assert main(["diff", str(folder / "old.rigui.usda"), str(corrections), "--strict"]) == 1
    capsys.readouterr()
    assert main(["diff", str(folder / "old.rigui.usda"), str(folder / "old.rigui.usda")]) == 0
    assert (
        capsys.readouterr().out.splitlines()[-1].endswith("0 of " + str(found["shared"]) + " common controls changed")
    )


def test_diff_of_a_layer_without_layout_is_refused(folder, capsys):
    told = run(capsys, "diff", folder / "old.rigui.usda", folder / "char.usda", expected=1)
    assert told["issues"][0]["code"] == "LAYOUT_MISSING"


def test_another_characters_layout_is_imitated(folder, capsys):
    new = folder / "new.rigui.usda"
    run(capsys, "process", folder / "char.usda", "--like", folder / "old.rigui.usda", "-o", new)
    assert anchors(new) == anchors(folder / "old.rigui.usda")


@pytest.mark.parametrize(
    ("configuration", "options", "code"),
    [
        ('[like.names]\nnobody = "chin"\n', (), "CONFIG_UNKNOWN_CONTROL"),
        ('[like.names]\nchin = "nobody"\n', (), "CONFIG_UNKNOWN_CONTROL"),
        ("", ("--previous", "old.rigui.usda"), "CONFIG_VALUE"),
    ],
)
def test_what_cannot_be_imitated_is_refused(folder, capsys, configuration, options, code, monkeypatch):
    monkeypatch.chdir(folder)
    (folder / "char.rigui.toml").write_text(configuration)
    told = run(capsys, "process", "char.usda", "--like", "old.rigui.usda", *options, expected=2)
    assert told["issues"][0]["code"] == code
    assert not (folder / "char.rigui.usda").exists()


def test_a_layer_that_does_not_name_its_character_cannot_be_imitated(folder, capsys):
    run(capsys, "process", folder / "char.usda", "--bare", "-o", folder / "bare.rigui.usda")
    told = run(capsys, "process", folder / "char.usda", "--like", folder / "bare.rigui.usda", expected=1)
    assert told["issues"][0]["code"] == "SOURCE_MISSING"
