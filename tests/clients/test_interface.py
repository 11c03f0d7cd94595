"""The Python interface: files, open stages and layers, what notebooks show, and that nothing is written."""

import json
import shutil
from pathlib import Path

import pytest
from commands import contents
from folders import ROOT
from pxr import Sdf, Usd

import usdrigui
from usdrigui import RigUIError
from usdrigui.cli import main

QUICK = {"solve": {"gap": 5e-2}}


def test_dir_lists_the_interface_and_all_of_it_is_there():
    assert dir(usdrigui) == sorted(usdrigui.__all__)
    assert all(hasattr(usdrigui, name) for name in dir(usdrigui))


@pytest.mark.parametrize("kind", ["stage", "layer", "unsaved"])
def test_an_open_stage_is_laid_out_in_memory_as_the_file_would_be(folder, kind):
    """What is unsaved counts, and the stage is what it was."""
    before = contents(folder)
    stage = Usd.Stage.Open(str(folder / "char.usda"))
    if kind == "unsaved":
        stage.GetPrimAtPath("/World/Char").GetAttribute("visibility")
        animation = stage.GetPrimAtPath("/World/Char/Anim").GetAttribute("blendShapes")
        animation.Set([f"new_{token}" for token in animation.Get()])
        mesh = stage.GetPrimAtPath("/World/Char/face0").GetAttribute("skel:blendShapes")
        mesh.Set([f"new_{token}" for token in mesh.Get()])
    text = stage.ExportToString()
    report = usdrigui.process(stage.GetRootLayer() if kind == "layer" else stage)
    assert report.outcome == "in memory"
    controls = {row.control for row in report.characters[0].rows}
    assert all(name.startswith("new_") for name in controls) is (kind == "unsaved")
    assert stage.ExportToString() == text
    assert contents(folder) == before
    if kind != "unsaved":
        asked = usdrigui.load_settings({"output": {"bare": True}})
        bare = usdrigui.process(folder / "char.usda", asked, output=folder / "b.usda")
        assert report.layer.ExportToString().encode() == (folder / "b.usda").read_bytes()
        assert bare.outcome == "written"


def test_a_layout_on_an_open_stage_is_opened_posed_seen_and_checked(folder):
    stage = Usd.Stage.Open(str(folder / "char.usda"))
    layer = usdrigui.process(stage).layer
    stage.GetSessionLayer().subLayerPaths.append(layer.identifier)
    layout = usdrigui.open(stage)
    assert {control.name for control in layout.controls} >= {"smile_L", "jawLeft"}
    smile = [each.name for each in layout.elements].index("smile_L")
    rest, posed = layout.pose({}), layout.pose({"smile_L": 1.0})
    assert abs(posed.elements[smile].handle - rest.elements[smile].handle).max() > 0.0
    assert not [each for each in layout.check().issues if each.severity == "error"]
    assert usdrigui.check(stage).issues == layout.check().issues
    assert layout.picture()._repr_png_().startswith(b"\x89PNG")
    assert "<iframe" in layout.view()._repr_html_()
    stage.GetPrimAtPath("/World/Char/face0").SetActive(False)
    with pytest.raises(usdrigui.RigUIError) as refused:
        usdrigui.open(stage)
    assert refused.value.issue.code == "LAYOUT_MESH_GONE"


def test_a_picture_at_a_pose_is_the_same_from_python_and_the_command(folder):
    layer = folder / "char.rigui.usda"
    layout, target = usdrigui.open(layer), folder / "posed.png"
    posed = layout.picture(pose={"smile_L": 1.0}).png
    assert posed != layout.picture().png
    assert main(["picture", str(layer), "-o", str(target), "--set", "read.pose.smile_L=1.0"]) == 0
    assert target.read_bytes() == posed
    with pytest.raises(usdrigui.RigUIError, match="POSE_CONTROL nobody"):
        layout.picture(pose={"nobody": 1.0})


def test_wrong_arguments_are_reported_in_the_words_of_the_interface(folder):
    for take in (usdrigui.process, usdrigui.check, usdrigui.open):
        with pytest.raises(TypeError, match=r"expected a path, a Usd\.Stage or an Sdf\.Layer, not int"):
            take(3)
    for take in (usdrigui.process, usdrigui.check, usdrigui.open, usdrigui.inspect):
        with pytest.raises(TypeError, match=r"expected usdrigui\.load_settings\(\.\.\.\) as settings, not dict"):
            take(folder / "char.rigui.usda", QUICK)
    layout = usdrigui.open(folder / "char.rigui.usda")
    assert [each.name for each in layout.pose({}).elements] == [each.name for each in layout.elements]
    name = layout.controls[0].name
    with pytest.raises(TypeError, match="a mapping of control names"):
        layout.pose([1.0])
    for value in ("x", None, [1.0, 2.0]):
        with pytest.raises(RigUIError, match=f"POSE_VALUE {name}: .* is not a number"):
            layout.pose({name: value})
    with pytest.raises(RigUIError, match=f"POSE_CONTROL .*did you mean '{name}'"):
        layout.pose({name + "x": 1.0})


def test_a_stage_that_has_a_layout_is_not_laid_out_again(folder):
    with pytest.raises(usdrigui.RigUIError) as refused:
        usdrigui.process(Usd.Stage.Open(str(folder / "char.rigui.usda")))
    assert refused.value.issue.code == "SOURCE_IS_LAYOUT"
    with pytest.raises(usdrigui.RigUIError) as refused:
        usdrigui.process(Sdf.Layer.CreateAnonymous(".usda"), output=folder / "no.usda")
    assert refused.value.issue.code == "CONFIG_VALUE"
    assert not (folder / "no.usda").exists()


def test_text_paths_and_the_configuration_beside_the_file_are_taken(folder, monkeypatch):
    monkeypatch.chdir(folder)
    Path("char.rigui.toml").write_text('[controls.smile_L]\nlabel = "grin"\n')
    report = usdrigui.process("char.usda", dry_run=True)
    assert report.settings["controls"]["smile_L"]["label"] == "grin"
    assert not [each for each in usdrigui.check("char.rigui.usda").issues if each.severity == "error"]
    assert usdrigui.diff("char.rigui.usda", "char.rigui.usda").empty


def test_reports_are_short_as_text(folder):
    report = usdrigui.process(folder / "char.usda", usdrigui.load_settings(QUICK), dry_run=True)
    assert len(repr(report)) < 200
    assert len(repr(usdrigui.open(folder / "char.rigui.usda"))) < 200


def test_the_notebook_of_the_documents_runs(tmp_path, monkeypatch, capsys):
    for name in ("char.usda", "char_geometry.usda"):
        shutil.copy(ROOT / "sample_assets" / name, tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("USDRIGUI_SOLVE_WORK_LIMIT", "2000")
    names = {}
    for cell in json.loads((ROOT / "docs" / "python.ipynb").read_text())["cells"]:
        if cell["cell_type"] == "code":
            exec(compile("".join(cell["source"]), "docs/python.ipynb", "exec"), names)
    assert {"char.rigui.usda", "layout.png", "layout.html", "char_ui.usda"} <= {
        path.name for path in tmp_path.iterdir()
    }
    assert "FILE_NOT_FOUND" in capsys.readouterr().out


@pytest.mark.parametrize("name", ["", "/", "a" * 300])
def test_what_can_name_no_file_is_refused(name):
    with pytest.raises(usdrigui.RigUIError, match=r"SOURCE_NOT_A_FILE|FILE_NOT_FOUND"):
        usdrigui.process(name)


USER = """
from pathlib import Path
import usdrigui

def lay_out(path: str) -> list[str]:
    def watch(event: usdrigui.Event) -> None:
        print(event.stage, event.seconds)
    report: usdrigui.Report = usdrigui.process(path, progress=watch)
    layout: usdrigui.OpenLayout = usdrigui.open(Path(report.output))
    layout.picture().save("picture.png")
    posed = layout.pose({"jawOpen": 0.5})
    print(posed.points.shape)
    return [issue.code for issue in layout.check().issues]
"""


@pytest.mark.slow
def test_a_script_of_a_user_passes_the_strict_type_check(tmp_path):
    from mypy import api

    (tmp_path / "user.py").write_text(USER)
    out, err, code = api.run(["--strict", "--config-file", str(ROOT / "pyproject.toml"), str(tmp_path / "user.py")])
    assert code == 0, out + err
