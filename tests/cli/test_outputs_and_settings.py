"""What a run may replace, and what a configuration may say: end to end."""

import json
import re
import shutil

import pytest
import skinned_stages
from folders import ROOT
from pxr import Sdf, Usd

from usdrigui.cli import main

QUICK = ("--quiet", "--set", "solve.work_limit=20000")


@pytest.fixture
def sample(tmp_path):
    folder = tmp_path / "asset"
    folder.mkdir()
    for name in ("char.usda", "char_geometry.usda"):
        shutil.copy(ROOT / "sample_assets" / name, folder / name)
    return folder / "char.usda"


@pytest.fixture
def character(tmp_path):
    return skinned_stages.character(tmp_path / "char.usda")


def test_the_configuration_of_the_readme_is_heeded_end_to_end(sample, tmp_path):
    block = re.search(r"```toml\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL).group(1)
    block = block.replace("helper_sculpt", "tongueOut")
    sample.with_suffix(".rigui.toml").write_text(block, encoding="utf-8")
    report = tmp_path / "out.json"
    assert main(["process", str(sample), "--report", str(report), *QUICK]) == 0
    document = json.loads(report.read_text())
    assert document["settings"]["controls"]["jawOpen"]["maximum"] == 1.2
    rows = {row["control"]: row for row in document["characters"][0]["controls"]}
    assert rows["tongueOut"]["place"] == "left off"
    assert rows["tongueOut"]["reason"]


def test_a_pose_file_is_heeded(character, tmp_path):
    name = json.loads(_json(["inspect", str(character), "--json"]))["characters"][0]["controls"][0]["control"]
    pose = tmp_path / "pose.toml"
    pose.write_text(f'"{name}" = 0.5\n')
    assert main(["process", str(character), "--pose", str(pose), *QUICK]) == 0


def test_the_layout_of_another_file_of_that_name_is_not_replaced(character, capsys):
    other = character.with_suffix(".usdc")
    Sdf.Layer.FindOrOpen(str(character)).Export(str(other))
    assert main(["process", str(character), *QUICK[1:]]) == 0
    layout = character.with_name(character.stem + ".rigui.usda")
    before = layout.read_bytes()
    assert main(["process", str(other), *QUICK[1:]]) == 3
    assert f"is the layout of {character.name}, not of {other.name}" in capsys.readouterr().err
    assert layout.read_bytes() == before
    assert main(["process", str(other), "-o", str(layout), *QUICK[1:]]) == 0, "who names it means it"
    other.rename(other.with_name("old.usdc"))
    assert main(["process", str(character), *QUICK[1:]]) == 0, "nor is it missed by a source that is gone"


def _attached(character):
    """A copy of the character with its layout attached."""
    asset = character.with_name("attached.usda")
    shutil.copy(character, asset)
    bare = character.with_name("bare.usda")
    assert main(["process", str(character), "--bare", "-o", str(bare), *QUICK]) == 0
    assert main(["attach", str(asset), str(bare), "--quiet"]) == 0
    return asset


def _shot(character):
    """A layer with work of its own over the layout."""
    shot = character.with_name("shot.usda")
    shot.write_text('#usda 1.0\n(\n subLayers = [@./char.rigui.usda@]\n)\ndef Xform "work" {}\n')
    return shot


def _corrections(character):
    corrections = character.with_name("corrections.usda")
    corrections.write_text("#usda 1.0\n(\n subLayers = [@./char.rigui.usda@]\n)\n")
    return corrections


def _pointer(character):
    """What a version control leaves where it did not fetch a file."""
    pointer = character.with_name("pointer.usdc")
    pointer.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12\n")
    return pointer


@pytest.mark.parametrize("made", [_attached, _shot, _corrections, _pointer])
def test_what_only_brings_a_layout_in_is_not_replaced(character, capsys, made):
    assert main(["process", str(character), *QUICK]) == 0
    mine = made(character)
    before = mine.read_bytes()
    capsys.readouterr()
    assert main(["process", str(character), "-o", str(mine), *QUICK]) == 3
    assert "FILE_TARGET" in capsys.readouterr().err
    assert mine.read_bytes() == before


def test_a_character_is_not_replaced_by_a_report_or_an_archive(character, capsys):
    loud = character.with_name("CHAR2.USDA")
    shutil.copy(character, loud)
    before = loud.read_bytes()
    for said in (
        ["process", str(character), "--report", str(loud), *QUICK],
        ["blender-extension", str(loud)],
        ["blender-extension", str(character)],
    ):
        assert main(said) == 3, said
        assert "FILE_TARGET" in capsys.readouterr().err
    assert loud.read_bytes() == before


def test_a_layer_of_somebody_else_is_not_replaced(character, capsys):
    mine = character.with_name("mine.usda")
    mine.write_text('#usda 1.0\ndef Xform "work" {}\n')
    before = mine.read_bytes()
    assert main(["process", str(character), "-o", str(mine), *QUICK[1:]]) == 3
    told = capsys.readouterr().err
    assert "FILE_TARGET" in told
    assert "solve" not in told, "it is told before the work"
    assert mine.read_bytes() == before


def test_a_picture_that_cannot_be_written_leaves_layer_and_report_as_they_were(character, capsys):
    layer, report, picture = (character.with_name(name) for name in ("l.usda", "l.json", "p.png"))
    command = ["process", str(character), "-o", str(layer), "--report", str(report), "--preview"]
    assert main([*command, str(picture)]) == 0
    before = [each.read_bytes() for each in (layer, report, picture)]
    assert main([*command, str(character / "p.png"), "--set", "objective.handle_size=0.05"]) == 3
    assert "nothing was written" in capsys.readouterr().err
    assert [each.read_bytes() for each in (layer, report, picture)] == before


@pytest.mark.parametrize(
    ("options", "code"),
    [
        (["-o", "out.txt"], "FILE_TARGET"),
        (["-o", "out.usdz"], "FILE_TARGET"),
        (["--preview", "c.usda"], "FILE_TARGET"),
        (["--preview", "c.jpg"], "a picture ends in .png"),
        (["--report", "c.usdc"], "FILE_TARGET"),
        (["--view", "frnt"], "did you mean 'front'?"),
        (["--set", "objective.handle_sise=3"], "there is no setting of this name; did you mean 'handle_size'?"),
        (["--set", "objective.nonsense=3"], "known here: displacement_weight, "),
        (["--preset", "papr"], "there are default and paper; did you mean 'paper'?"),
        (["--view", "nan,0"], "CONFIG_VALUE"),
        (["--set", "candidates.view=1,2,3"], "CONFIG_VALUE"),
    ],
)
def test_what_the_command_line_gets_wrong_is_reported_before_the_asset_is_read(tmp_path, options, code, capsys):
    main(["process", str(tmp_path / "missing.usda"), *options])
    told = capsys.readouterr().err
    assert code in told
    assert "FILE_NOT_FOUND" not in told


def test_a_picture_of_an_unknown_kind_is_refused_before_the_layer_is_read(tmp_path, capsys):
    main(["picture", str(tmp_path / "missing.usda"), "-o", "p.jpg"])
    assert "ends in .png or .gif" in capsys.readouterr().err


def test_a_linked_asset_is_referred_to_by_its_link(sample, tmp_path):
    store = tmp_path / "store"
    store.mkdir()
    sample.rename(store / "blob.usda")
    sample.symlink_to(store / "blob.usda")
    assert main(["process", str(sample), *QUICK]) == 0
    layer = sample.with_name("char.rigui.usda")
    assert "@./char.usda@" in layer.read_text()
    assert Usd.Stage.Open(str(layer)).GetPrimAtPath("/Char/Geometry/Head")


def _json(arguments):
    import contextlib
    import io

    with contextlib.redirect_stdout(io.StringIO()) as out:
        assert main(arguments) == 0
    return out.getvalue()
