"""`usdrigui attach` and `detach`: the one edit of an asset, and everything that they refuse."""

import os
import shutil
import time

import pytest
import skinned_stages
from commands import run
from pxr import Sdf, Usd, UsdGeom

from usdrigui.cli import main
from usdrigui.clients.attaching import attach as edit
from usdrigui.clients.attaching.attach import attach, detach, write_bare
from usdrigui.clients.attaching.layer_text import with_sublayer
from usdrigui.errors import RigUIError
from usdrigui.settings import Settings


def lay_out_bare(asset, bare):
    assert main(["process", str(asset), "--bare", "-o", str(bare), "--quiet"]) == 0


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory):
    """A character with a bare layout and one that stands over it."""
    folder = tmp_path_factory.mktemp("once")
    character = skinned_stages.character(folder / "char.usda")
    lay_out_bare(character, folder / "ui" / "bare.usda")
    assert main(["process", str(character), "--quiet"]) == 0
    return folder


def refusal(asset, layer, *, in_variant=False):
    before = asset.read_bytes() if asset.is_file() else b""
    with pytest.raises(RigUIError) as caught:
        attach(asset, layer, Settings(), in_variant=in_variant)
    assert (asset.read_bytes() if asset.is_file() else b"") == before
    return caught.value.issue.code


def test_a_layer_does_not_lose_its_sublayers_to_its_own_copy(folder):
    layer = folder / "char.rigui.usda"
    before = layer.read_bytes()
    with pytest.raises(RigUIError, match="FILE_TARGET"):
        write_bare(layer, folder / "ui" / ".." / layer.name)
    assert layer.read_bytes() == before


def layouts(path):
    stage = Usd.Stage.Open(Sdf.Layer.OpenAsAnonymous(str(path)) if path.suffix == ".usdc" else str(path))
    return [prim.GetPath() for prim in stage.TraverseAll() if prim.GetName() == "RigUI"]


def reworded(folder, text):
    """The character behind a root layer of that text."""
    (folder / "char.usda").rename(folder / "body.usda")
    asset = folder / "char.usda"
    asset.write_bytes(text.encode())
    return asset


TEXTS = {
    "no metadata": '#usda 1.0\n\nover "World" (\n    references = @./body.usda@</World>\n)\n{\n}\n',
    "metadata": (
        '#usda 1.0\n(\n    # a remark of the rigger\n    defaultPrim = "World"\n)\n\n'
        'def "World" (\n    prepend references = @./body.usda@</World>\n)\n{\n}\n'
    ),
    "sublayers": (
        '#usda 1.0\n(\n    "doc"   \n    subLayers = [ @./body.usda@ (offset = 10; scale = 2) ]  # odd\n'
        '    defaultPrim = "World"\n)\n'
    ),
    "empty list": (
        '#usda 1.0\n(\n    subLayers = []\n)\nover "World" (\n    references = @./body.usda@</World>\n)\n{\n}\n'
    ),
    "in other words": (
        '#usda 1.0\n(\n    """subLayers = ["""\n    customLayerData = {\n        string[] subLayers = ["it"]\n    }\n'
        "    # subLayers = [\n    subLayers = [\n        @./body.usda@\n    ]\n)\n"
    ),
    "comment first": "#usda 1.0\n# who made it\n(\n    subLayers = [\n        @./body.usda@\n    ]\n)\n",
}


@pytest.mark.parametrize("name", TEXTS)
def test_there_and_back_gives_the_same_text(folder, name):
    asset = reworded(folder, TEXTS[name])
    before = Sdf.Layer.OpenAsAnonymous(str(asset))
    assert attach(asset, folder / "ui" / "bare.usda", Settings()) == "written"
    after = Sdf.Layer.OpenAsAnonymous(str(asset))
    assert list(after.subLayerPaths) == ["./ui/bare.usda", *before.subLayerPaths]
    offsets, now = ([(x.offset, x.scale) for x in layer.subLayerOffsets] for layer in (before, after))
    assert now[1:] == offsets
    assert layouts(asset)
    assert all(line in asset.read_text() for line in TEXTS[name].splitlines() if "subLayers" not in line)
    assert detach(asset, folder / "ui" / "bare.usda", Settings()) == "written"
    assert asset.read_text() == TEXTS[name]


TEXTS_OF_PRIMS = {
    **TEXTS,
    "the SkelRoot without metadata": (
        '#usda 1.0\n(\n    subLayers = [@./body.usda@]\n)\n\nover "Other"\n{\n    over "Char" {}\n}\n\n'
        'over Xform "World" ( kind = "group" )\n{\n    # a remark\n    over "Char"\n    {\n'
        "        float over = 1\n    }\n}\n"
    ),
    "the SkelRoot with metadata": (
        '#usda 1.0\n(\n    subLayers = [@./body.usda@]\n)\nover "World" {\n    over "Char" (\n'
        '        # a remark\n        kind = "component"\n    )\n    {\n        rel over = </World/Char>\n    }\n}\n'
    ),
}


@pytest.mark.parametrize("text", TEXTS_OF_PRIMS.values(), ids=TEXTS_OF_PRIMS.keys())
def test_a_layout_in_a_variant_is_opened_with_it_alone_and_leaves_no_trace(folder, text):
    asset, bare = reworded(folder, text), folder / "ui" / "bare.usda"
    assert attach(asset, bare, Settings(), in_variant=True) == "written"
    assert attach(asset, bare, Settings(), in_variant=True) == "unchanged"
    for load in (Usd.Stage.LoadAll, Usd.Stage.LoadNone):
        stage = Usd.Stage.Open(str(asset), load)
        stage.SetEditTarget(stage.GetSessionLayer())
        character = stage.GetPrimAtPath("/World/Char")
        drawn = [prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
        assert drawn
        assert not character.GetChild("RigUI")
        assert str(bare) not in [each.realPath for each in stage.GetUsedLayers()]
        character.GetVariantSet("rigUI").SetVariantSelection("ui")
        assert character.GetChild("RigUI")
        assert all(mesh.IsValid() and mesh.IsLoaded() for mesh in drawn)
        assert len([prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]) > len(drawn)
    bare.unlink()
    assert detach(asset, bare, Settings()) == "written"
    before = Sdf.Layer.CreateAnonymous(".usda")
    assert before.ImportFromString(text)
    assert Sdf.Layer.OpenAsAnonymous(str(asset)).ExportToString() == before.ExportToString()


def test_a_layout_in_a_variant_of_a_crate_leaves_no_trace(folder, capsys):
    asset, bare = folder / "crate.usdc", folder / "ui" / "bare.usda"
    Sdf.Layer.OpenAsAnonymous(str(folder / "char.usda")).Export(str(asset))
    before = Sdf.Layer.OpenAsAnonymous(str(asset)).ExportToString()
    attach(asset, bare, Settings(), in_variant=True)
    assert asset.read_bytes().startswith(b"PXR-USDC")
    for chosen in ((), ("--variant", "rigUI=ui")):
        codes = [each["code"] for each in run(capsys, "check", asset, "--strict", *chosen)["issues"]]
        assert ("LAYOUT_OFF" in codes) == (not chosen)
    assert main(["process", str(asset), "--quiet"]) == 1
    assert "SOURCE_HAS_LAYOUT" in capsys.readouterr().err
    lay_out_bare(asset, bare)
    detach(asset, bare, Settings())
    assert Sdf.Layer.OpenAsAnonymous(str(asset)).ExportToString() == before


def test_the_time_of_an_edit_grows_with_the_text_alone():
    """Of the head as of the body; a search that begins again at every line takes sixteen times as long for four."""

    def seconds(lines):
        text = f'#usda 1.0\n(\n{chr(10) * lines}    defaultPrim = "Char"\n)\n{chr(10) * lines}'
        before = time.process_time()
        assert "@./ui.usda@" in with_sublayer(text, "./ui.usda")
        return time.process_time() - before

    short, long = (min(seconds(lines) for _ in range(3)) for lines in (20_000, 80_000))
    assert long < 8.0 * max(short, 1e-3)


def test_a_save_while_the_edited_asset_is_checked_is_not_lost(folder, monkeypatch):
    asset = folder / "char.usda"
    saved = asset.read_bytes() + b"# somebody's save\n"
    monkeypatch.setattr(edit, "_holds_layouts", lambda *_: asset.write_bytes(saved))
    with pytest.raises(RigUIError, match="SOURCE_CHANGED"):
        attach(asset, folder / "ui" / "bare.usda", Settings())
    assert asset.read_bytes() == saved


@pytest.mark.parametrize("suffix", [".usdc", ".usd"])
def test_a_crate_stays_a_crate(folder, suffix):
    asset = folder / f"crate{suffix}"
    Sdf.Layer.FindOrOpen(str(folder / "char.usda")).Export(str(asset), args={"format": "usdc"})
    before = Sdf.Layer.OpenAsAnonymous(str(asset)).ExportToString()
    assert attach(asset, folder / "ui" / "bare.usda", Settings()) == "written"
    assert asset.read_bytes().startswith(b"PXR-USDC")
    assert list(Sdf.Layer.OpenAsAnonymous(str(asset)).subLayerPaths) == ["./ui/bare.usda"]
    assert detach(asset, folder / "ui" / "bare.usda", Settings()) == "written"
    assert Sdf.Layer.OpenAsAnonymous(str(asset)).ExportToString() == before


def test_twice_is_once(folder):
    asset, bare = folder / "char.usda", folder / "ui" / "bare.usda"
    attach(asset, bare, Settings())
    before = asset.read_bytes()
    assert attach(asset, bare, Settings()) == "unchanged"
    assert asset.read_bytes() == before
    detach(asset, bare, Settings())
    assert detach(asset, bare, Settings()) == "unchanged"


def test_a_layer_that_is_gone_can_be_detached(folder):
    asset, bare = folder / "char.usda", folder / "ui" / "bare.usda"
    before = asset.read_bytes()
    attach(asset, bare, Settings())
    bare.unlink()
    assert detach(asset, bare, Settings()) == "written"
    assert asset.read_bytes() == before


def test_a_locked_asset_stays_as_it_is(folder, monkeypatch):
    """What the file system says when the file may not be written, also where the tests run as root."""
    monkeypatch.setattr(os, "access", lambda *_, **__: False)
    assert refusal(folder / "char.usda", folder / "ui" / "bare.usda") == "FILE_PERMISSION"


def test_refuses_cycles(folder):
    asset = folder / "char.usda"
    assert refusal(asset, folder / "char.rigui.usda") == "ATTACH_CYCLE"
    round_about = Sdf.Layer.FindOrOpen(str(folder / "ui" / "bare.usda"))
    middle = Sdf.Layer.CreateNew(str(folder / "middle.usda"))
    middle.subLayerPaths.append("./char.usda")
    middle.Save()
    prim = Sdf.CreatePrimInLayer(round_about, "/Elsewhere")
    prim.referenceList.Prepend(Sdf.Reference("../middle.usda", "/World"))
    round_about.Save()
    assert refusal(asset, folder / "ui" / "bare.usda") == "ATTACH_CYCLE"


def test_an_asset_with_its_layout_inside_gets_no_second_one(folder, capsys):
    """Elements that the second one lacks would stay behind; replaced through --bare -o, the result passes `check`."""
    asset, bare = folder / "char.usda", folder / "ui" / "bare.usda"
    attach(asset, bare, Settings())
    (folder / "char.rigui.toml").write_text("[controls.smile_L]\nexclude = true\n")
    shutil.copy(bare, folder / "ui" / "other.usda")
    assert refusal(asset, folder / "ui" / "other.usda") == "SOURCE_HAS_LAYOUT"
    layer = folder / "char.rigui.usda"
    before = layer.read_bytes()
    assert main(["process", str(asset)]) == 1
    told = capsys.readouterr().err
    assert "SOURCE_HAS_LAYOUT" in told
    assert str(bare) in told
    assert "--bare -o" in told
    assert layer.read_bytes() == before
    lay_out_bare(asset, bare)
    assert main(["check", str(asset), "--config", str(folder / "char.rigui.toml"), "--strict"]) == 0


def test_an_asset_with_its_layout_inside_is_checked_viewed_and_processed_again(folder, capsys):
    asset, bare = folder / "char.usda", folder / "ui" / "bare.usda"
    assert main(["attach", str(asset), str(bare)]) == 0
    assert "usdrigui: written" in capsys.readouterr().out
    assert main(["check", str(asset), "--strict"]) == 0
    before = bare.read_bytes()
    assert main(["process", str(asset), "-o", str(bare), "--quiet"]) == 1
    assert "ATTACH_CYCLE" in capsys.readouterr().err
    lay_out_bare(asset, bare)
    assert bare.read_bytes() == before
    assert main(["detach", str(asset), str(bare), "--json"]) == 0
