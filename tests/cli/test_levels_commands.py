"""`[levels]` through the command line: authored, read back, checked, drawn and kept in a shot."""

import pytest
import shot_stages
import skinned_stages
from commands import elements, run
from PIL import Image
from pxr import Sdf, Usd, UsdGeom

from usdrigui.cli import main
from usdrigui.model.levels import inner_names

LEVELS = """
[poses.grin]
weights = { smile_L = 1.0, smile_R = 1.0, pucker = 0.5 }

[candidates]
board_composite = false

[groups.groups]
lower = ["chin", "jaw:open"]

[levels]
poses = true
groups = true
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A character with a layout of two levels."""
    character = skinned_stages.character(tmp_path_factory.mktemp("levels") / "char.usda")
    character.with_name("char.rigui.toml").write_text(LEVELS)
    assert main(["process", str(character), "--quiet"]) == 0
    return character.parent


def test_members_are_authored_and_come_back(made):
    found = elements(made / "char.rigui.usda")
    # A grin has a lobe at each corner of the mouth: a handle on each, which opens what lies on its side.
    assert set(found["grin"].inner) == {"pucker", "smile_L"}
    assert set(found["grin_mirror"].inner) == {"pucker", "smile_R"}
    assert set(found["lower"].inner) == {"chin", "jaw:open"}
    stage = Usd.Stage.Open(str(made / "char.rigui.usda"))
    grin = stage.GetPrimAtPath("/World/Char/RigUI/FaceControls/grin")
    targets = {path.name for path in grin.GetRelationship("rigUI:element:members").GetTargets()}
    assert targets == {"pucker", "smile_L"}


def test_applications_that_know_nothing_of_levels_show_the_first(made):
    found = elements(made / "char.rigui.usda")
    inner = inner_names(found.values())
    stage = Usd.Stage.Open(str(made / "char.rigui.usda"))
    for path in shot_stages.layout_prims(stage):
        name = stage.GetPrimAtPath(path).GetAttribute("rigUI:element:name").Get() or path.name
        seen = (
            UsdGeom.Imageable(stage.GetPrimAtPath(path.GetParentPath())).ComputeVisibility() != UsdGeom.Tokens.invisible
        )
        assert seen == (name not in inner)


def test_the_layout_is_sound_and_the_same_again(folder, capsys):
    assert run(capsys, "check", folder / "char.rigui.usda", "--strict")["issues"] == []
    before = (folder / "char.rigui.usda").read_bytes()
    run(capsys, "process", folder / "char.usda")
    assert (folder / "char.rigui.usda").read_bytes() == before


@pytest.mark.parametrize("option", ["--fixed", "--previous"])
def test_both_levels_are_kept(folder, capsys, option):
    new = folder / "new.rigui.usda"
    config = ("--config", folder / "char.rigui.toml")
    run(capsys, "process", folder / "char.usda", option, folder / "char.rigui.usda", "-o", new, *config)
    assert run(capsys, "diff", folder / "char.rigui.usda", new, "--strict")["characters"][0]["changes"] == []
    assert elements(new)["grin"].inner == elements(folder / "char.rigui.usda")["grin"].inner


def test_the_report_names_the_members(made, capsys):
    told = run(capsys, "process", made / "char.usda", "--dry-run")
    by_name = {each["name"]: each for each in told["characters"][0]["elements"]}
    assert set(by_name["lower"]["members"]) == {"chin", "jaw:open"}
    assert next(row for row in told["characters"][0]["controls"] if row["control"] == "chin")["element"] == "lower"


def test_pictures_show_one_level(folder, capsys):
    layer = folder / "char.rigui.usda"
    for name, options in (("first", ()), ("second", ("--level", "2")), ("opened", ("--open", "grin"))):
        assert main(["picture", str(layer), "-o", str(folder / f"{name}.png"), *options]) == 0
    pictures = [Image.open(folder / f"{name}.png").tobytes() for name in ("first", "second", "opened")]
    assert len(set(pictures)) == 3
    assert main(["picture", str(layer), "-o", str(folder / "x.png"), "--open", "chin"]) == 2
    assert "CONFIG_VALUE" in capsys.readouterr().err


def test_pickers_show_one_level(folder, capsys):
    layer, spots = folder / "char.rigui.usda", {}
    for level in ("1", "2"):
        assert main(["picker", str(layer), "--svg", str(folder / "p.svg"), "--level", level]) == 0
        spots[level] = (folder / "p.svg").read_text()
    capsys.readouterr()
    assert 'data-control="grin"' in spots["1"]
    assert 'data-control="grin"' not in spots["2"]
    assert 'data-control="pucker"' in spots["2"]
    assert 'data-control="pucker"' not in spots["1"]


def test_a_shot_over_two_levels(folder, capsys):
    shapes = {"browCrease": ((0.0, 0.55), (0, 0.3, 1), 0.25, 0.12)}
    shot_stages.shot(folder / "shot.usda", "./char.usda", "/World/Char/face0", shapes)
    config = ("--config", folder / "char.rigui.toml")
    run(capsys, "process", folder / "shot.usda", "--base", folder / "char.rigui.usda", *config)
    both = elements(folder / "shot.rigui.usda")
    assert both["grin"].inner == elements(folder / "char.rigui.usda")["grin"].inner
    assert "browCrease" in both


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("Members/pucker", "Members/nobody"),
        ("Members/pucker", "Controls/lower"),
    ],
)
def test_members_that_make_no_sense_are_refused(folder, capsys, old, new):
    layer = Sdf.Layer.FindOrOpen(str(folder / "char.rigui.usda"))
    relationship = layer.GetRelationshipAtPath("/World/Char{rigUI=ui}RigUI/FaceControls/grin.rigUI:element:members")
    paths = [*map(str, relationship.targetPathList.explicitItems)]
    assert any(old in path for path in paths)
    relationship.targetPathList.explicitItems = [Sdf.Path(path.replace(old, new)) for path in paths]
    layer.Save()
    told = run(capsys, "check", folder / "char.rigui.usda", expected=1)
    assert told["issues"][0]["code"] == "LAYOUT_INVALID"
