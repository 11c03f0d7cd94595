"""`process --fixed`, `process --previous` and `usdrigui diff` over the life of a character's files."""

import re
import shutil
import tomllib

import pytest
from commands import run
from pxr import Sdf, Usd, UsdSkel

from usdrigui.cli import main
from usdrigui.errors import meant
from usdrigui.layer.read_layout import read_layout, with_corrections


@pytest.fixture
def folder(folder):
    (folder / "char.rigui.usda").rename(folder / "old.rigui.usda")
    return folder


def anchors(layer):
    (layout,) = read_layout(layer)
    return {element.name: (element.anchor.point, element.anchor.on_board) for element in layout.elements}


def decisions(layer):
    (layout,) = with_corrections(Usd.Stage.Open(str(layer)), read_layout(layer))
    return {element.name: element.pinned for element in layout.elements if element.pinned}


def solution(capsys, folder, *options):
    """Of a run: how its layout's cost is told."""
    report = run(capsys, "process", folder / "char.usda", *options, "-o", folder / "new.rigui.usda")
    (character,) = report["characters"]
    return character["solution"]


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
    (prim,) = [prim for prim in over.TraverseAll() if prim.GetName() == element and prim.GetTypeName() == "GeomSubset"]
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


def test_the_same_places_have_the_same_cost_whatever_made_them(capsys, folder):
    old, new = folder / "old.rigui.usda", folder / "new.rigui.usda"
    plain = solution(capsys, folder)
    assert plain["penalty"] == 0.0
    for option in ("--previous", "--fixed", "--like"):
        again = solution(capsys, folder, option, old)
        assert anchors(new) == anchors(old)
        assert again["cost"] == pytest.approx(plain["cost"], abs=1e-9)
        assert again["bound"] <= again["cost"]
        (layout,) = read_layout(new)
        assert (layout.proof.cost, layout.proof.bound) == pytest.approx((again["cost"], again["bound"]))


def test_what_no_layout_could_keep_costs_nothing(capsys, folder):
    """Controls that never move one point have no place together, wherever each of them stood."""
    far = "groups.groups.far=['chin', 'blink_L']"
    assert solution(capsys, folder, "--set", far, "--previous", folder / "old.rigui.usda")["penalty"] == 0.0


def test_the_cost_of_a_worse_place_is_the_one_that_check_gives(capsys, folder):
    plain = solution(capsys, folder)
    corrections = corrected(folder, "smile_L", another_point(folder, "smile_L"))
    fixed = solution(capsys, folder, "--fixed", corrections)
    assert fixed["cost"] > plain["cost"] + 1e-6
    assert fixed["bound"] <= fixed["cost"]
    (reviewed,) = run(capsys, "check", folder / "new.rigui.usda")["characters"]
    assert reviewed["cost"] == pytest.approx(fixed["cost"], abs=1e-6)


def test_a_fixed_layer_with_a_control_that_is_gone_is_refused(folder, capsys):
    lose_control(folder / "char.usda", "chin")
    told = run(capsys, "process", folder / "char.usda", "--fixed", folder / "old.rigui.usda", expected=2)
    assert told["issues"][0]["code"] == "CONFIG_UNKNOWN_CONTROL"
    assert "chin" in told["issues"][0]["message"]
    assert not (folder / "char.rigui.usda").exists()


def test_the_previous_layout_is_kept_and_the_diff_is_reported(folder, capsys):
    lose_control(folder / "char.usda", "half")
    told = run(capsys, "process", folder / "char.usda", "--previous", folder / "old.rigui.usda")
    found = told["characters"][0]["difference"]
    assert [(each["control"], each["kind"]) for each in found["changes"]] == [("half", "removed")]
    assert found["displaced"] == 0
    before, after = anchors(folder / "old.rigui.usda"), anchors(folder / "char.rigui.usda")
    assert {name: before[name] for name in after} == after
    capsys.readouterr()
    assert main(["process", str(folder / "char.usda"), "--previous", str(folder / "old.rigui.usda")]) == 0
    printed = capsys.readouterr().out
    assert "since the previous layout:" in printed
    assert "removed" in printed


def test_at_a_penalty_of_zero_the_previous_layout_changes_nothing(folder, capsys):
    corrections = corrected(folder, "smile_L", another_point(folder, "smile_L"))
    new = folder / "new.rigui.usda"
    zero = ("--set", "objective.keep_penalty=0")
    run(capsys, "process", folder / "char.usda", "--previous", corrections, *zero, "-o", new)
    run(capsys, "process", folder / "char.usda", *zero, "-o", folder / "plain.rigui.usda")
    assert new.read_bytes() == (folder / "plain.rigui.usda").read_bytes()


def test_a_stronger_layer_says_the_same_over_the_new_layout(folder, capsys):
    point = another_point(folder, "smile_L")
    corrections, new = corrected(folder, "smile_L", point), folder / "new.rigui.usda"
    run(capsys, "process", folder / "char.usda", "--previous", corrections, "-o", new)
    assert decisions(new) == {"smile_L": ("anchor",), "smile_R": ("anchor",)}
    layer = Sdf.Layer.FindOrOpen(str(corrections))
    layer.subLayerPaths[:] = ["./new.rigui.usda"]
    layer.Save()
    stage = Usd.Stage.Open(str(corrections))
    prim = stage.GetPrimAtPath("/World/Char/RigUI/FaceControls/smile_L")
    assert prim.GetDisplayName() == "corrected by hand"
    assert anchors(corrections)["smile_L"] == (point, False)


def test_diff_tells_what_moved_by_how_much_and_fails_when_strict(folder, capsys):
    point = another_point(folder, "smile_L")
    corrections = corrected(folder, "smile_L", point)
    found = run(capsys, "diff", folder / "old.rigui.usda", corrections)["characters"][0]
    (change,) = found["changes"]
    assert (change["control"], change["kind"]) == ("smile_L", "moved")
    assert main(["diff", str(folder / "old.rigui.usda"), str(corrections), "--strict"]) == 1
    capsys.readouterr()
    assert main(["diff", str(folder / "old.rigui.usda"), str(folder / "old.rigui.usda")]) == 0
    assert (
        capsys.readouterr().out.splitlines()[-1].endswith("0 of " + str(found["shared"]) + " common controls changed")
    )


@pytest.mark.parametrize("order", [1, -1])
def test_the_closing_line_names_the_file_that_was_refused(folder, capsys, order):
    pair = [str(folder / "char.usda"), str(folder / "old.rigui.usda")][::order]
    assert main(["diff", *pair]) == 1
    assert f"usdrigui: refused {folder / 'char.usda'}\n" in capsys.readouterr().err
    assert run(capsys, "diff", *pair, expected=1)["asset"] == str(folder / "char.usda")


def of_hero(folder):
    """The same layout for a character of another name."""
    layer = folder / "hero.rigui.usda"
    text = (folder / "old.rigui.usda").read_text()
    layer.write_text(text.replace('"Char"', '"Hero"').replace("/Char/", "/Hero/").replace("./char.usda", "./hero.usda"))
    hero = (folder / "char.usda").read_text().replace('"Char"', '"Hero"').replace("/Char", "/Hero")
    (folder / "hero.usda").write_text(hero)
    return layer


def test_layouts_of_different_characters_have_nothing_in_common(folder, capsys):
    pair = str(folder / "old.rigui.usda"), str(of_hero(folder))
    for options, expected in (((), 0), (("--strict",), 1)):
        assert main(["diff", *pair, *options]) == expected
        printed = capsys.readouterr().out
        assert printed.splitlines()[-1].endswith("they have no character in common")
        assert "common controls" not in printed
        assert all(f"/World/{name}: only one of the two layers" in printed for name in ("Char", "Hero"))
    assert run(capsys, "diff", *pair)["only_in_one"] == ["/World/Char", "/World/Hero"]


def test_the_layout_of_another_character_is_no_previous_one(folder, capsys):
    layer = of_hero(folder)
    layer.write_text(layer.read_text().replace("face0", "nose0"))
    told = run(capsys, "process", folder / "char.usda", "--previous", layer, expected=1)
    assert told["issues"][0]["code"] == "PREVIOUS_MISMATCH"
    assert "shares no control" not in told["issues"][0]["message"], "it has the same ones, on other meshes"
    told = run(capsys, "process", folder / "char.usda", "--fixed", layer, expected=2)
    assert told["issues"][0]["path"] == "--fixed"
    assert not (folder / "char.rigui.usda").exists()


def test_the_previous_layout_of_a_character_that_was_renamed_is_kept(folder, capsys):
    """Corrections by hand, too."""
    corrections = corrected(folder, "smile_L", another_point(folder, "smile_L"))
    before = anchors(corrections)
    of_hero(folder)
    told = run(capsys, "process", folder / "hero.usda", "--previous", corrections)
    assert "PREVIOUS_RENAMED" in {each["code"] for each in told["issues"]}
    (follower,) = told["characters"][0]["difference"]["changes"]
    assert follower["control"] == "smile_R", "it follows its twin"
    after = anchors(folder / "hero.rigui.usda")
    assert {name: place[0] for name, place in after.items() if name != "smile_R"} == {
        name: place[0] for name, place in before.items() if name != "smile_R"
    }


NEW_NAMES = {"smile_L": "LeftGrin", "smile_R": "RightGrin", "pucker": "target.7"}


def rename_controls(asset, names=None):
    """The character's blend shapes by other tokens; their prims keep their names."""
    text = asset.read_text()
    for before, after in (names or NEW_NAMES).items():
        assert f'"{before}"' in text
        text = re.sub(rf'(?<!BlendShape )"{before}"', f'"{after}"', text)
    asset.write_text(text)


def test_renamed_controls_keep_their_elements_and_corrections(folder, capsys):
    point = another_point(folder, "smile_L")
    corrections = corrected(folder, "smile_L", point)
    before = anchors(corrections)
    rename_controls(folder / "char.usda")
    told = run(capsys, "check", folder / "old.rigui.usda", expected=1)
    gone = {each["path"]: each["message"] for each in told["issues"] if each["code"] == "LAYOUT_CONTROL_GONE"}
    assert all(f"; {NEW_NAMES[name]!r} moves as it did" in gone[name] for name in NEW_NAMES)
    told = run(capsys, "process", folder / "char.usda", "--previous", corrections)
    (character,) = told["characters"]
    changes = {(each["was"], each["control"]): each for each in character["difference"]["changes"]}
    assert changes.keys() == NEW_NAMES.items()
    assert {each["kind"] for each in changes.values()} == {"renamed", "moved"}
    assert "was decided by a person" in changes["smile_R", "RightGrin"]["why"][0], "it follows its twin"
    matches = {each["before"]: each["after"] for each in character["matchings"]["previous"]["matches"]}
    assert {name: matches[name] for name in NEW_NAMES} == NEW_NAMES
    assert all(matches[name] == name for name in matches.keys() - NEW_NAMES.keys())
    after = anchors(folder / "char.rigui.usda")
    assert {NEW_NAMES.get(n, n): place for n, place in before.items() if n != "smile_R"}.items() <= after.items()
    assert after["LeftGrin"] == (point, False)
    assert {each["path"] for each in told["issues"] if each["code"] == "CONTROL_RENAMED"} == NEW_NAMES.keys()


def test_a_base_whose_controls_were_renamed_names_all_of_them(folder, capsys):
    rename_controls(folder / "char.usda")
    arguments = ("--base", folder / "old.rigui.usda", "-o", folder / "shot.rigui.usda")
    told = run(capsys, "process", folder / "char.usda", *arguments, expected=1)
    assert {each["code"] for each in told["issues"]} == {"LAYOUT_CONTROL_GONE"}
    for before, after in NEW_NAMES.items():
        assert any(f"{before!r}; {after!r} moves as it did" in each["message"] for each in told["issues"])
    assert "--previous" in told["issues"][0]["repair"]


def test_a_fixed_layout_of_renamed_controls_stands_to_the_point(folder, capsys):
    rename_controls(folder / "char.usda")
    old, new = folder / "old.rigui.usda", folder / "char.rigui.usda"
    run(capsys, "process", folder / "char.usda", "--fixed", old)
    assert {NEW_NAMES.get(name, name): place for name, place in anchors(old).items()} == anchors(new)
    (found,) = run(capsys, "diff", old, new)["characters"]
    assert (found["displaced"], found["renamed"]) == (0, 3)
    assert main(["diff", str(old), str(new)]) == 0
    assert "0 came or went, 3 were renamed" in capsys.readouterr().out


def test_another_character_is_imitated_whatever_its_controls_are_called(folder, capsys):
    """And the names can be written down, which says the same."""
    shutil.copytree(folder, folder / "hero")
    rename_controls(folder / "hero" / "char.usda")
    hero, old = folder / "hero" / "char.usda", folder / "old.rigui.usda"
    told = run(capsys, "process", hero, "--like", old, "-o", folder / "one.rigui.usda")
    assert not told["characters"][0]["matchings"]["like"]["left_before"]
    before, after = anchors(old), anchors(folder / "one.rigui.usda")
    imitated = {NEW_NAMES.get(name, name): place for name, place in before.items()}
    moved = {name for name in after if imitated[name] != after[name]}
    assert imitated.keys() == after.keys()
    assert moved <= {"blink_L", "blink_R"}, "fewer names tell where the lids are: a near tie is decided the other way"
    (character,) = run(capsys, "inspect", hero, "--like", old)["characters"]
    draft = character["likeness"]["configuration"]
    assert tomllib.loads(draft)["like"]["names"] == NEW_NAMES
    (folder / "draft.toml").write_text(draft)
    run(capsys, "process", hero, "--like", old, "--config", folder / "draft.toml", "-o", folder / "two.rigui.usda")
    assert anchors(folder / "two.rigui.usda") == after
    assert main(["inspect", str(hero), "--like", str(old)]) == 0
    assert draft in capsys.readouterr().out


@pytest.mark.parametrize(
    ("configuration", "wanted"),
    [
        ("[objectve]\nhandle_size = 0.1", "objective"),
        ('[controls.smile_l]\nlabel = "x"', "smile_L"),
        ('[controls.smile_L]\ntwin = "smileR"', "smile_R"),
        ("[read.pose]\nsmyle_L = 1.0", "smile_L"),
        ('[groups.groups]\na = ["smile_LL", "chin"]', "smile_L"),
        ('[controls.chin]\norbit = ["smile_LL", "smile_R"]', "smile_L"),
        ("[poses.a.weights]\nsmile_LL = 1.0", "smile_L"),
        ('[levels.members]\nchin = ["smile_LL"]', "smile_L"),
        ('[like.names]\nsmile_LL = "smile_L"', "smile_L"),
        ('[controls."L-smile"]\nlabel = "x"', "smile_L"),
        ("[controls.eyes_closed_right]\nlabel = 'x'", "blink_R"),
    ],
)
def test_a_name_that_is_nearly_right_is_suggested(folder, capsys, configuration, wanted):
    (folder / "char.rigui.toml").write_text(configuration)
    like = ("--like", folder / "old.rigui.usda") if "like" in configuration else ()
    told = run(capsys, "process", folder / "char.usda", "--dry-run", *like, expected=2)
    assert told["issues"][0]["message"].endswith(f"; did you mean {wanted!r}?")


@pytest.mark.parametrize(
    ("name", "known", "wanted"),
    [
        ("jawOpn", ["Jaw:rx", "jawOpen"], "jawOpen"),
        ("mouthStrechLeft", ["mouthLeft", "mouthStretchLeft"], "mouthStretchLeft"),
        ("eyeBlink_L", ["eyeBlink_R", "eyeBlinkLeft"], "eyeBlinkLeft"),
    ],
)
def test_a_slip_of_a_letter_is_no_other_control(name, known, wanted):
    assert meant(name, known) == f"; did you mean {wanted!r}?"


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


def test_of_a_shot_of_several_characters_one_must_be_named_to_be_imitated(folder, capsys):
    stage = Usd.Stage.CreateNew(str(folder / "shot.usda"))
    for name in "AB":
        stage.DefinePrim(f"/Shot/{name}").GetReferences().AddReference("./old.rigui.usda")
    stage.GetRootLayer().Save()
    told = run(capsys, "process", folder / "char.usda", "--like", folder / "shot.usda", expected=2)
    assert "has layouts of /Shot/A/Char, /Shot/B/Char" in told["issues"][0]["message"]
