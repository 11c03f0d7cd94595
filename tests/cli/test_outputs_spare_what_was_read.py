"""No output of any command replaces the asset or another file that the command reads, by whatever name it is called."""

import os
import shutil

import minimal_assets
import pytest
from commands import contents

from usdrigui.cli import main
from usdrigui.clients.batch import run

CLIP = """#usda 1.0
def SkelAnimation "Take" {
    uniform token[] blendShapes = ["smile"]
    float[] blendShapeWeights.timeSamples = {0: [0], 1: [1]}
}
"""
STAR = """#usda 1.0
(
    subLayers = [@./more.usda@]
)
def Mesh "Star" {
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 0, 1)]
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
}
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Everything that a run can read."""
    folder = tmp_path_factory.mktemp("once")
    minimal_assets.character(folder)
    (folder / "take.usda").write_text(CLIP)
    (folder / "star.usda").write_text(STAR)
    (folder / "more.usda").write_text("#usda 1.0\n")
    (folder / "pose.toml").write_text("smile = 0.5\n")
    (folder / "char.rigui.toml").write_text('[controls.smile]\nglyph = "star.usda</Star>"\n')
    assert main(["process", str(folder / "char.usda"), "--quiet"]) == 0
    shutil.copy(folder / "char.rigui.usda", folder / "before.rigui.usda")
    return folder


@pytest.fixture
def folder(folder, monkeypatch):
    monkeypatch.chdir(folder)
    return folder


PROCESS = ("process", "char.usda", "-o", "new.rigui.usda", "--animation", "take.usda", "--pose", "pose.toml")
PROCESS += ("--previous", "before.rigui.usda")
ASSET, CONFIGURATION = "char.usda", "char.rigui.toml"
CASES = [
    *(((*PROCESS, "--report", "out.json"), name) for name in (ASSET, CONFIGURATION, "take.usda", "pose.toml")),
    *(((*PROCESS, "--report", "out.json"), name) for name in ("before.rigui.usda", "star.usda", "more.usda")),
    ((*PROCESS, "--preview", "out.png"), ASSET),
    (("process", ASSET, "--dry-run", "--report", "out.json"), ASSET),
    (("process", ASSET, "-o", "out.usda"), ASSET),
    (("process", ASSET, "-o", "out.usda", "--like", "before.rigui.usda"), "before.rigui.usda"),
    (("view", "char.rigui.usda", "--html", "out.html"), ASSET),
    (("view", "char.rigui.usda", "--html", "out.html"), "char.rigui.usda"),
    (("view", "char.rigui.usda", "--html", "out.html"), CONFIGURATION),
    (("picture", "char.rigui.usda", "-o", "out.png"), ASSET),
    (("picker", "char.rigui.usda", "--svg", "out.svg"), ASSET),
    (("picker", "char.rigui.usda", "--dwpicker", "out.json"), "star.usda"),
    (("batch", ASSET, "--summary", "out.json"), ASSET),
    (("batch", ASSET, "--summary", "out.json"), CONFIGURATION),
    (("batch", ASSET, "--sheet", "out.png"), ASSET),
    (("openjd", ASSET, "-o", "out.json"), ASSET),
    (("openjd", ASSET, "-o", "out.json", "--pose", "pose.toml"), "pose.toml"),
]


@pytest.mark.parametrize("link", [os.symlink, os.link], ids=["link", "hard link"])
@pytest.mark.parametrize(("command", "victim"), CASES, ids=[f"{c[0]} {c[-2]} {victim}" for c, victim in CASES])
def test_an_output_that_is_a_file_of_the_run_is_refused(folder, monkeypatch, capsys, command, victim, link):
    monkeypatch.setattr(run, "run_local", lambda *_: pytest.fail("the batch began to work"))
    (output,) = (each for each in command if each.startswith("out."))
    link(victim, output)
    before = contents(folder)
    assert main([*command]) == 3
    assert f"FILE_TARGET {output}" in capsys.readouterr().err
    assert contents(folder) == before


@pytest.mark.parametrize("name", ["char.rigui.png", "char.rigui.batch.json"])
@pytest.mark.usefixtures("folder")
def test_what_a_batch_writes_by_itself_spares_the_assets_too(capsys, name):
    os.link(ASSET, name)
    assert main(["batch", ASSET, "--sheet", "sheet.png"]) == 3
    assert f"FILE_TARGET {name}" in capsys.readouterr().err


def test_an_archive_does_not_replace_an_asset_behind_a_link(folder, capsys):
    (folder / "out.zip").symlink_to(ASSET)
    before = (folder / ASSET).read_bytes()
    assert main(["blender-extension", "out.zip"]) == 3
    assert "FILE_TARGET" in capsys.readouterr().err
    assert (folder / ASSET).read_bytes() == before


def test_the_layout_that_a_run_succeeds_is_replaced(folder):
    """`--previous` names it in order to replace it; an attached one is replaced under `--bare`."""
    before = (folder / "before.rigui.usda").read_bytes()
    longer = ("--set", "objective.keep_penalty=0", "--set", "objective.handle_size=0.05")
    assert main(["process", ASSET, "--previous", "before.rigui.usda", "-o", "before.rigui.usda", *longer]) == 0
    assert (folder / "before.rigui.usda").read_bytes() != before
    assert main(["process", ASSET, "--bare", "-o", "bare.usda"]) == 0
    assert main(["attach", ASSET, "bare.usda"]) == 0
    assert main(["process", ASSET, "--bare", "-o", "bare.usda", *longer[2:]]) == 0


def test_two_outputs_of_one_run_are_two_files(folder, capsys):
    before = contents(folder)
    assert main(["process", ASSET, "--report", "out.png", "--preview", "./out.png", "-o", "new.usda"]) == 3
    assert "FILE_TARGET out.png: is out.png, which this run writes already" in capsys.readouterr().err
    assert contents(folder) == before
