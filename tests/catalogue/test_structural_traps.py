"""Every structural trap ends as it should: refused with its code, or laid out with what is strange about it said."""

import pytest
import traps
import triggers
from pxr import Sdf

from usdrigui.layer.read_layout import read_layout


@pytest.mark.parametrize("name", traps.TRAPS)
def test_a_trap(name, tmp_path, capfd):
    _, expected_exit, expected = traps.TRAPS[name]
    exit_code, issues = triggers.command("process", traps.trapped(tmp_path, name))
    assert exit_code == expected_exit, issues
    assert expected <= {each["code"] for each in issues}
    assert "0x" not in str(issues), "an address of this run is in the report"
    layer = tmp_path / "char.rigui.usda"
    assert layer.exists() == (exit_code == 0)
    if not exit_code:
        assert read_layout(layer)
    assert "Traceback" not in capfd.readouterr().err


@pytest.mark.parametrize("name", ["names that are not ASCII", "a name with markup"])
def test_a_name_comes_back_from_the_layer(name, tmp_path):
    path = traps.trapped(tmp_path, name)
    assert triggers.command("process", path)[0] == 0
    (layout,) = read_layout(tmp_path / "char.rigui.usda")
    names = layout.controls
    assert names == ({"lächeln", "怒り"} if "ASCII" in name else {'<b>&"smile', "frown"})


@pytest.mark.parametrize("arc", ["subLayers", "references"])
def test_a_layer_that_brings_a_layout_in_gets_no_second_one(arc, tmp_path):
    """A shot over a layout layer, even one that corrects it, is added to (--base) or laid out apart (--bare)."""
    path = traps.minimal_assets.character(tmp_path)
    assert triggers.command("process", path)[0] == 0
    shot = tmp_path / "shot.usda"
    head = "(\n    subLayers = [@./char.rigui.usda@]\n)\n" if arc == "subLayers" else ""
    prim = 'over "Char"' if arc == "subLayers" else 'def "Char" (references = @./char.rigui.usda@</Char>)'
    over = prim + '\n{\nover "RigUI"\n{\nover "smile"\n{\ntoken visibility = "invisible"\n}\n}\n}\n'
    shot.write_text("#usda 1.0\n" + head + over)
    exit_code, (found,) = triggers.command("process", shot)
    assert (exit_code, found["code"]) == (1, "SOURCE_HAS_LAYOUT")
    assert str(tmp_path / "char.rigui.usda") in found["message"]
    assert not (tmp_path / "shot.rigui.usda").exists()
    for options in (("--base", tmp_path / "char.rigui.usda"), ("--bare",)):
        exit_code, issues = triggers.command("process", shot, "--dry-run", *options)
        assert exit_code == 0, issues
    shot.write_text(shot.read_text().replace('over "RigUI"', 'over "RigUI" (active = false)'))
    exit_code, (found,) = triggers.command("process", shot)
    assert found["code"] == "SOURCE_HAS_LAYOUT", "its layout would be inactive with the old one"


@pytest.mark.parametrize("version", [(0, 0, 0), (0, 99, 0), (1, 0, 0), (255, 255, 255)])
def test_a_crate_of_a_version_that_usd_does_not_read(version, tmp_path):
    text = traps.minimal_assets.character(tmp_path)
    path = tmp_path / "char.usdc"
    layer = Sdf.Layer.FindOrOpen(str(text))
    layer.Export(str(path))
    assert triggers.command("process", path, "--dry-run")[0] == 0
    content = bytearray(path.read_bytes())
    content[8:11] = bytes(version)
    path.write_bytes(content)
    exit_code, issues = triggers.command("process", path, "--dry-run")
    assert (exit_code, issues[0]["code"]) == (1, "FILE_NOT_USD")
