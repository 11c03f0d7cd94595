"""`pin`, `unpin`, `pins`, `process --corrections`, opinions of stronger layers: what a person says is held or told."""

import shutil

import numpy as np
from commands import run
from pxr import Sdf, Usd, UsdGeom

import usdrigui
from usdrigui.layer.read_layout import read_layout


def elements(layer):
    (layout,) = read_layout(layer)
    return {member.control: each for each in layout.elements for member in each.members}


def another_point(folder, name):
    """The point that the control of an element moves, of some distance from where it stands."""
    anchor = elements(folder / "char.rigui.usda")[name].anchor
    stage = Usd.Stage.Open(str(folder / "char.usda"))
    shape = next(each for each in stage.Traverse() if each.GetName() == name and each.GetTypeName() == "BlendShape")
    offsets = np.linalg.norm(np.array(shape.GetAttribute("offsets").Get()), axis=1)
    points = shape.GetAttribute("pointIndices").Get()
    points = np.arange(len(offsets)) if points is None else np.array(points)
    good = points[offsets >= 0.6 * offsets.max()]
    return anchor.mesh, int(good[good != anchor.point][-1])


def with_another_mesh(folder):
    """The character with its first face turned: by its faces no layout can tell that its points are the same."""
    shutil.copy(folder / "char.usda", folder / "newer.usda")
    stage = Usd.Stage.Open(str(folder / "newer.usda"))
    (mesh,) = [UsdGeom.Mesh(each) for each in stage.Traverse() if each.IsA(UsdGeom.Mesh)]
    corners = list(mesh.GetFaceVertexIndicesAttr().Get())
    count = mesh.GetFaceVertexCountsAttr().Get()[0]
    mesh.GetFaceVertexIndicesAttr().Set([*corners[1:count], corners[0], *corners[count:]])
    stage.GetRootLayer().Save()
    return folder / "newer.usda"


def test_decisions_hold_given_or_stacked_until_they_are_taken_back(folder, capsys):
    mesh, point = another_point(folder, "smile_L")
    layer, said = folder / "char.rigui.usda", folder / "corrections.usda"
    decisions = (f"smile_L={mesh}#{point}", "pucker=board", "chin=here", "chin.label=Jut", "chin.maximum=2")
    run(capsys, "pin", layer, *decisions, "-o", said, "--reason", "shot 12")
    assert {each["reason"] for each in run(capsys, "pins", said)["pins"]} == {"shot 12"}
    first, newer = elements(layer), with_another_mesh(folder)
    for options in (("--corrections", said), ("--previous", said)):
        out = folder / "out.rigui.usda"
        told = run(capsys, "process", newer, *options, "-o", out)
        assert not [each for each in told["issues"] if each["code"].startswith("PIN_")]
        found = elements(out)
        assert (found["smile_L"].anchor.point, found["pucker"].anchor.on_board) == (point, True)
        assert found["smile_R"].pinned == ("anchor",), "the twin follows"
        assert found["chin"].anchor.point == first["chin"].anchor.point
        assert found["chin"].label == "Jut"
        chin = next(each for each in found["chin"].members if each.control == "chin")
        assert chin.values[-1] == 2.0
    run(capsys, "unpin", folder / "out.rigui.usda", "smile_L", "pucker", "-o", said)
    told = {each["control"]: each["place"] for each in run(capsys, "pins", said)["pins"]}
    assert (told["smile_L"], told["pucker"]) == ("free", "free")
    run(capsys, "process", newer, "--previous", said, "-o", folder / "free.rigui.usda")
    found = elements(folder / "free.rigui.usda")
    assert not found["smile_L"].pinned
    assert not found["smile_R"].pinned, "nor is the one that followed"


def test_what_cannot_be_held_is_told_with_what_is_meant(folder, capsys):
    said = folder / "corrections.usda"
    run(capsys, "pin", folder / "char.rigui.usda", "chin=here", "-o", said)
    text = said.read_text()
    said.write_text(text.replace('control = "chin"', 'control = "chim"'))
    told = run(capsys, "process", folder / "char.usda", "--corrections", said, "--strict", "--dry-run", expected=1)
    (lost,) = [each for each in told["issues"] if each["code"] == "PIN_LOST"]
    assert lost["path"] == "chim"
    assert "did you mean 'chin'" in lost["message"]
    (lost,) = [each for each in run(capsys, "check", said)["issues"] if each["code"] == "PIN_LOST"]
    assert lost["path"] == "chim"
    said.write_text(text.replace("</World/Char", "</World/Hero").replace('"Char"', '"Hero"'))
    told = run(capsys, "process", folder / "char.usda", "--corrections", said, "--dry-run")
    assert not [each for each in told["issues"] if each["code"] == "PIN_LOST"], "the only character is meant"


def over(folder, path, point):
    """A stronger layer that names another point for the prim at a path, and nothing else."""
    layer = Sdf.Layer.CreateNew(str(folder / "over.usda"))
    layer.subLayerPaths.append("./char.rigui.usda")
    spec = Sdf.CreatePrimInLayer(layer, path)
    attribute = Sdf.AttributeSpec(spec, "rigUI:anchor:pointIndex", Sdf.ValueTypeNames.Int, Sdf.VariabilityUniform)
    attribute.default = point
    layer.Save()
    return folder / "over.usda"


def test_an_opinion_where_no_prim_is_is_told_by_every_command(folder, capsys):
    layer = over(folder, "/World/Char/RigUI/chin", 3)
    commands = (
        ("check", layer),
        ("diff", folder / "char.rigui.usda", layer),
        ("process", folder / "char.usda", "--previous", layer, "--dry-run"),
    )
    for words in commands:
        found = run(capsys, *words, "--strict", expected=1)["issues"]
        (told,) = [each for each in found if each["code"] == "OPINION_IGNORED"]
        assert told["path"] == "/World/Char/RigUI/chin"
        assert "/World/Char/RigUI/FaceControls/" in told["message"], "the element that is meant"


def test_a_point_means_the_mesh_on_which_it_was_given(folder, capsys):
    """Though the character has another mesh by now, and the layer gives no position."""
    mesh, point = another_point(folder, "smile_L")
    layer = over(folder, "/World/Char/RigUI/FaceControls/smile_L", point)
    out = folder / "out.rigui.usda"
    told = run(capsys, "process", with_another_mesh(folder), "--previous", layer, "-o", out)
    assert not [each for each in told["issues"] if each["code"].startswith("PIN_")]
    found = elements(out)
    left, right = found["smile_L"], found["smile_R"]
    assert (left.anchor.mesh, left.anchor.point, left.pinned) == (mesh, point, ("anchor",))
    assert right.pinned == ("anchor",), "the twin follows"
    np.testing.assert_allclose(right.anchor.position, left.anchor.position * [-1.0, 1.0, 1.0], atol=1e-5)
    layer.rename(folder / "first.usda")
    out.rename(folder / "char.rigui.usda")
    layer = over(folder, "/World/Char/RigUI/FaceControls/smile_L", another_point(folder, "smile_L")[1])
    run(capsys, "process", folder / "newer.usda", "--previous", layer, "-o", out)
    moved, right = elements(out)["smile_L"].anchor, elements(out)["smile_R"].anchor
    assert moved.point not in (left.anchor.point, point)
    np.testing.assert_allclose(right.position, moved.position * [-1.0, 1.0, 1.0], atol=1e-5)


def test_an_open_stage_is_laid_out_with_the_corrections_that_it_has(folder, capsys):
    said = folder / "corrections.usda"
    run(capsys, "pin", folder / "char.rigui.usda", "pucker=board", "-o", said)
    said.write_text(said.read_text().replace("char.rigui.usda", "char.usda"))
    report = usdrigui.process(Usd.Stage.Open(str(said)))
    rows = {row.control: row.place for row in report.characters[0].rows}
    assert rows["pucker"] == "board"
