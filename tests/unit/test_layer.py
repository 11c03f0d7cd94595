"""Layers: what is written is read back, the same from the same, and says what USD and clients need."""

import tempfile
from dataclasses import replace
from pathlib import Path

import laid_out
import numpy as np
import pytest
import skinned_stages
from makers import changed
from pxr import Sdf, Tf, Usd, UsdGeom

from usdrigui.character import LeftOff
from usdrigui.errors import Exit, RigUIError
from usdrigui.layer.read_layout import read_layout, source_of
from usdrigui.layer.write_layout import layer_bytes, layer_for, relative_asset_path, stage_metadata, write_layout
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

GROUPS = [("smile_L", "sneer_L"), ("jawLeft", "jawRight"), ("half",), ("pucker", "chin", "brow_L"), ("Jaw:rx",)]


@pytest.fixture
def char(tmp_path):
    """Source, rig and a layout with every kind of element, at a base pose away from rest."""
    source = skinned_stages.character(
        tmp_path / "char.usda", moved=True, meshes=2, animated_joints=("Hips/Head", "Hips/Head/Jaw")
    )
    (rig,) = read_rigs(source, Settings())
    layout = laid_out.layout_of(
        rig, groups=GROUPS, beside=("half",), base_values=0.3 * laid_out.random_values(rig, np.random.default_rng(0))
    )
    elements = list(layout.elements)
    elements[0] = replace(
        elements[0],
        mirror=elements[3].name,
        side="middle",
        reason="they are alike",
    )
    elements[1] = replace(
        elements[1],
        kind="slider",
        opposed=((1, 0),),
        label="Jaw, sideways",
        adapt="static",
    )
    elements[4] = replace(elements[4], name="25 jaw:rx", side="none")
    layout = replace(
        layout, elements=tuple(elements), left_off=(LeftOff("a", "read", 'has "quotes"'), LeftOff("ü", "solve", ""))
    )
    return source, rig, layout


def metadata(source):
    return stage_metadata(Sdf.Layer.FindOrOpen(str(source)))


@pytest.mark.parametrize("suffix", [".usda", ".usdc", ".usd"])
def test_a_layout_comes_back_as_it_was(char, tmp_path, suffix):
    source, rig, layout = char
    target = tmp_path / f"char.rigui{suffix}"
    assert write_layout([(rig, layout)], source, target, metadata(source)) == "written"
    assert write_layout([(rig, layout)], source, target, metadata(source)) == "unchanged"
    (back,) = read_layout(target)
    laid_out.close(layout, back)
    (again,) = read_layout(Sdf.Layer.FindOrOpen(str(target)))
    laid_out.close(layout, again)


def test_the_source_is_sublayered_by_a_relative_path(char, tmp_path):
    source, rig, layout = char
    shelf = tmp_path / "layouts"
    shelf.mkdir()
    for target, path in ((tmp_path / "a.usda", "./char.usda"), (shelf / "a.usda", "../char.usda")):
        write_layout([(rig, layout)], source, target, metadata(source))
        assert list(Sdf.Layer.FindOrOpen(str(target)).subLayerPaths) == [path]
        assert Path(source_of(target)).resolve() == source.resolve()


@pytest.mark.parametrize("name", ["a b.usda", "ä@home.usda", "a#1.usda"])
def test_odd_source_names_are_referred_to(tmp_path, name):
    source = skinned_stages.character(tmp_path / name)
    (rig,) = read_rigs(source, Settings())
    assert staged(source, rig, laid_out.layout_of(rig), tmp_path).GetPrimAtPath(rig.path).IsDefined()


@pytest.mark.parametrize("name", ["a:SDF_FORMAT_ARGS:b.usda", "a@@@b.usda", "a\nb.usda"])
def test_names_that_usd_cannot_refer_to_are_refused(tmp_path, name):
    with pytest.raises(RigUIError, match="SOURCE_UNREFERABLE"):
        relative_asset_path(tmp_path / name, tmp_path / "out.usda")


def test_a_bare_layer_stands_alone_and_can_be_sublayered_by_the_asset(char, tmp_path):
    source, rig, layout = char
    target = tmp_path / "bare.usda"
    write_layout([(rig, layout)], source, target, metadata(source), bare=True)
    assert source_of(target) == ""
    laid_out.close(layout, read_layout(target)[0])
    asset = Sdf.Layer.FindOrOpen(str(source))
    asset.subLayerPaths.append("./bare.usda")
    laid_out.close(layout, read_layout(asset)[0])
    asset.subLayerPaths.clear()


def test_stage_metadata_is_repeated(tmp_path):
    source = tmp_path / "a.usda"
    layer = Sdf.Layer.CreateNew(str(source))
    layer.ImportFromString("""#usda 1.0
(
    defaultPrim = "Char"
    upAxis = "Z"
    startTimeCode = 1
    endTimeCode = 48
    timeCodesPerSecond = 48
    framesPerSecond = 24
    expressionVariables = {
        string SHOT = "a"
    }
    customLayerData = {
        string secret = "stays behind"
    }
)
""")
    found = stage_metadata(layer)
    assert (found["expressionVariables"], found["defaultPrim"]) == ({"SHOT": "a"}, "Char")
    assert "customLayerData" not in found
    assert found["metersPerUnit"] == 0.01
    stage = Usd.Stage.Open(layer_for([], "./a.usda", found))
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert (stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (1, 48)
    assert (stage.GetTimeCodesPerSecond(), stage.GetFramesPerSecond()) == (48, 24)
    assert layer_for([], "", {"metersPerUnit": 1}).pseudoRoot.GetInfo("metersPerUnit") == 1.0


def test_a_source_without_metadata_gets_a_layer_that_validates(tmp_path):
    source = skinned_stages.character(tmp_path / "char.usda")
    bare = Sdf.Layer.FindOrOpen(str(source))
    for key in ("upAxis", "metersPerUnit", "defaultPrim", "timeCodesPerSecond"):
        bare.pseudoRoot.ClearInfo(key)
    bare.Save()
    (rig,) = read_rigs(source, Settings())
    stage = staged(source, rig, laid_out.layout_of(rig), tmp_path)
    assert stage.GetDefaultPrim().GetName() == "World"
    assert UsdGeom.GetStageMetersPerUnit(stage) == UsdGeom.GetStageMetersPerUnit(Usd.Stage.Open(str(source)))
    assert laid_out.validation_errors(stage) == []


def staged(source, rig, layout, folder):
    """The stage of a layer with one layout."""
    target = folder / "a.usda"
    write_layout([(rig, layout)], source, target, metadata(source))
    return Usd.Stage.Open(str(target))


def test_the_default_prim_is_the_top_of_the_first_character_where_the_source_names_none(char):
    _, rig, layout = char
    other = replace(layout, elements=(), root="/Crowd/Second")
    assert layer_for([(rig, layout), (changed(rig, path=other.root), other)], "", {}).defaultPrim == "World"


@pytest.mark.parametrize(("parts", "told"), [(("face",) * 5, False), (("face", "body", "face", "body", "face"), True)])
def test_the_order_of_elements_is_written_where_their_prims_do_not_tell_it(char, parts, told):
    _, rig, layout = char
    elements = tuple(replace(each, part=part) for each, part in zip(layout.elements, parts, strict=True))
    layer = layer_for([(rig, replace(layout, elements=elements))], "", {})
    assert ("rigUI:layout:elements" in layer.ExportToString()) == told
    assert [each.name for each in read_layout(layer)[0].elements] == [each.name for each in elements]


def test_meshes_are_named_after_their_part_and_what_no_joint_moves(tmp_path):
    """Some outliners show no subsets, and some lists of meshes no parents."""
    source = skinned_stages.character(tmp_path / "char.usda", animated_joints=("Hips",))
    (rig,) = read_rigs(source, Settings())
    layout = laid_out.layout_of(rig, only=["Hips:rx"])  # nothing above the root carries its track
    layout = replace(
        layout,
        elements=tuple(replace(each, part="body") for each in layout.elements),
    )
    stage = staged(source, rig, layout, tmp_path)
    skinned, still = stage.GetPrimAtPath(rig.path).GetChild("RigUI").GetChildren()
    assert (skinned.GetName(), still.GetName()) == ("BodyControls", "BodyStillControls")
    assert skinned.GetAttribute("skel:joints").HasAuthoredValue()
    assert not still.GetAttribute("skel:joints").HasAuthoredValue()


# --- layers by other hands ---------------------------------------------------------------------------

HAND_MADE = """#usda 1.0
over "Char"
{
    def Scope "MyControls" (
        prepend apiSchemas = ["RigUILayoutAPI"]
    )
    {
        double rigUI:layout:handleWidth = 0.5
        def Mesh "knobs" (
            prepend apiSchemas = ["RigUIDrawingAPI"]
        )
        {
            point3f[] points = [(-1, -1, 0), (1, -1, 0), (0, 1, 0)]
            int[] faceVertexCounts = [3]
            int[] faceVertexIndices = [0, 1, 2]
            token[] primvars:rigUI:role = ["handle"] (interpolation = "constant")
            def GeomSubset "smile" (
                prepend apiSchemas = ["RigUIElementAPI", "RigUIControlAPI:smile"]
            )
            {
                int[] indices = [0]
                rel rigUI:anchor:prim = </Char/face>
                int rigUI:anchor:pointIndex = 7
                point3f[] rigUI:control:smile:trackPoints = [(0, 0, 0), (0, 1, 0)]
            }
        }
    }
}
"""


def hand_made(text=HAND_MADE):
    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.ImportFromString(text)
    return layer


def test_a_layer_written_by_hand_takes_the_fallbacks():
    (layout,) = read_layout(hand_made())
    (element,) = layout.elements
    (member,) = element.members
    assert (layout.root, layout.frame.space, layout.proof.status, layout.frame.handle_width) == (
        "/Char",
        "object",
        "stopped",
        0.5,
    )
    assert layout.proof.bound == -np.inf
    assert (element.name, element.label, element.kind, element.adapt) == (
        "smile",
        "smile",
        "slider",
        "deform",
    )
    assert (member.control, member.magnification) == ("smile", 1.0)
    assert member.values.tolist() == [0.0, 1.0]
    assert member.track.tolist() == [[0, 0, 0], [0, 1, 0]]
    assert (element.anchor.mesh, element.anchor.point, element.anchor.on_board) == ("/Char/face", 7, False)
    assert read_layout(Usd.Stage.Open(hand_made()))[0].listed == ()


AT = 'def Mesh "knobs"'
CONTRADICTIONS = [
    ('"RigUILayoutAPI"', '"SomeAPI"', "LAYOUT_MISSING", "RigUILayoutAPI"),
    ("int rigUI:anchor:pointIndex = 7", "", "LAYOUT_INVALID", "pointIndex"),
    ("point3f[] rigUI:control:smile:trackPoints = [(0, 0, 0), (0, 1, 0)]", "", "LAYOUT_INVALID", "trackPoints"),
    (AT, f'def Xform "b" (\napiSchemas = ["RigUIElementAPI"]\n) {{}}\n{AT}', "LAYOUT_INVALID", "no control"),
    ("int rigUI:anchor:pointIndex", "double rigUI:anchor:pointIndex", "LAYOUT_INVALID", "double, not int"),
    ("double rigUI:layout:handleWidth = 0.5", "", "LAYOUT_INVALID", "handleWidth is missing"),
    ("RigUILayoutAPI", "RigUILayoutAPI_99", "LAYOUT_VERSION", "99"),
    ("RigUIControlAPI:smile", "RigUIControlAPI_2:smile", "LAYOUT_VERSION", "RigUIControlAPI_2"),
    ('LayoutAPI"]\n', 'LayoutAPI"]\ncustomData = {\nstring usdrigui = "{}"\n}\n', "LAYOUT_INVALID", "record"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "code", "told"), CONTRADICTIONS)
def test_layers_that_contradict_themselves_are_refused(old, new, code, told):
    assert old in HAND_MADE
    with pytest.raises(RigUIError) as caught:
        read_layout(hand_made(HAND_MADE.replace(old, new, 1)))
    assert caught.value.issue.code == code
    assert told in f"{caught.value.issue.path} {caught.value.issue.message}"


def test_a_missing_layer_and_a_wrong_suffix(tmp_path):
    with pytest.raises(RigUIError, match="FILE_NOT_FOUND"):
        read_layout(tmp_path / "none.usda")
    with pytest.raises(RigUIError, match="FILE_NOT_FOUND"):
        source_of(tmp_path / "none.usda")
    with pytest.raises(RigUIError, match="FILE_TARGET"):
        layer_bytes(hand_made(), ".usdz")
    with pytest.raises(RigUIError) as caught:
        write_layout([], tmp_path / "char.usda", tmp_path / "layout.txt", {})
    assert caught.value.issue.path == str(tmp_path / "layout.txt")


def test_no_room_for_a_temporary_crate(monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "gone"))
    with pytest.raises(RigUIError) as caught:
        layer_bytes(hand_made(), ".usdc")
    assert caught.value.exit_code is Exit.FILE
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(Sdf.Layer, "Export", lambda *_: Tf.RaiseRuntimeError("disk full"))
    with pytest.raises(RigUIError, match="FILE_WRITE"):
        layer_bytes(hand_made(), ".usdc")
    assert list(tmp_path.iterdir()) == []
