"""No command parses what others made in its own process: where USD crashes, the command ends with the code."""

import json

import minimal_assets
import pytest
from commands import contents
from processes import impostor
from pxr import Sdf, Usd

from usdrigui.cli import main
from usdrigui.reader.reader_process import read_layer_isolated
from usdrigui.settings import ReadSettings

COMMANDS = (
    "process char.usda -o out.usda",
    "process char.usda --previous layer.usda -o out.usda",
    "process char.usda --base layer.usda -o out.usda",
    "process char.usda --fixed layer.usda -o out.usda",
    "process char.usda --like layer.usda -o out.usda",
    "process char.usda --animation layer.usda -o out.usda",
    "inspect char.usda",
    "check layer.usda",
    "diff layer.usda layer.usda",
    "view layer.usda --html page.html",
    "picture layer.usda -o picture.png",
    "attach char.usda layer.usda",
    "detach char.usda layer.usda",
)


@pytest.mark.parametrize("line", COMMANDS)
def test_a_crash_in_any_command(line, tmp_path, monkeypatch, capfd):
    minimal_assets.character(tmp_path)
    (tmp_path / "layer.usda").write_text("#usda 1.0\n")
    impostor(tmp_path, monkeypatch, "kill -SEGV $$")
    before = contents(tmp_path)
    opened = []
    for owner, name in ((Usd.Stage, "Open"), (Sdf.Layer, "FindOrOpen"), (Sdf.Layer, "OpenAsAnonymous")):
        monkeypatch.setattr(owner, name, lambda *named: opened.append(named))
    monkeypatch.chdir(tmp_path)
    code = main([*line.split(), "--json"])
    monkeypatch.undo()
    printed = capfd.readouterr()
    assert (code, json.loads(printed.out)["issues"][0]["code"]) == (1, "SOURCE_CRASHES_USD")
    assert opened == []
    assert "Traceback" not in printed.err
    assert contents(tmp_path) == before


def test_a_layer_by_itself_names_all_that_it_brings_along(tmp_path):
    """What no composition would load is named too; what is not there is no fault."""
    for name, text in {
        "a.usda": '(\n    subLayers = [@./gone.usda@, @./b.usda@]\n)\ndef "A" (references = @sub/c.usda@)\n{\n}\n',
        "b.usda": 'def "B" (active = false\n references = @a.usda@)\n{\n}\n',
        "sub/c.usda": 'def "C" (payload = @d.usda@)\n{\n}\n',
    }.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(f"#usda 1.0\n{text}")
    found = read_layer_isolated(tmp_path / "a.usda", ReadSettings())
    assert found.sublayers == ("./gone.usda", "./b.usda")
    assert {str((tmp_path / each).resolve().relative_to(tmp_path.resolve())) for each in found.needed} == {
        "gone.usda",
        "b.usda",
        "a.usda",
        "sub/c.usda",
        "sub/d.usda",
    }
