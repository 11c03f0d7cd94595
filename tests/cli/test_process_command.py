"""`usdrigui process` as a rigger, a pipeline TD and a farm use it."""

import json
import os

import pytest
import skinned_stages
from commands import run
from programs import ran

from usdrigui.cli import main


@pytest.fixture
def character(tmp_path):
    return skinned_stages.character(tmp_path / "char.usda")


def test_writes_the_layer_beside_the_source_and_leaves_the_source_alone(character, capsys):
    before = character.read_bytes()
    assert main(["process", str(character)]) == 0
    layer = character.with_name("char.rigui.usda")
    assert layer.is_file()
    assert character.read_bytes() == before
    printed = capsys.readouterr()
    assert printed.out.splitlines()[-1].startswith(f"usdrigui: written {layer}")
    of_face = [line.split()[0] for line in printed.err.splitlines() if line.endswith(" s face")]
    assert of_face == ["candidates", "problem", "solve", "layout"]


def test_of_several_characters_each_stage_says_whose_it_is(character, capsys):
    stage = character.with_name("crowd.usda")
    both = [f'def "{name}" (references = @{character.name}@) {{}}' for name in "AB"]
    stage.write_text("\n".join(["#usda 1.0", *both]))
    for command, path in (("process", stage), ("inspect", stage), ("check", stage.with_suffix(".rigui.usda"))):
        assert main([command, str(path)]) == 0
        told = capsys.readouterr().err.splitlines()
        whose = [line.split()[-2:] for line in told if line.startswith("candidates")]
        assert whose == [["/A/Char", "face"], ["/B/Char", "face"]], command


def test_again_gives_the_same_bytes_and_says_unchanged(character, capsys):
    layer = character.with_name("char.rigui.usda")
    main(["process", str(character)])
    first = layer.read_bytes()
    capsys.readouterr()
    assert main(["process", str(character)]) == 0
    assert layer.read_bytes() == first
    assert "usdrigui: unchanged" in capsys.readouterr().out


def test_inspecting_and_a_dry_run_write_nothing(character, tmp_path, capsys):
    files = sorted(tmp_path.iterdir())
    assert main(["inspect", str(character)]) == 0
    assert main(["process", str(character), "--dry-run"]) == 0
    assert sorted(tmp_path.iterdir()) == files
    assert "dry run" in capsys.readouterr().out


def test_json_accounts_for_every_control(character, capsys):
    (only,) = run(capsys, "process", character)["characters"]
    laid = {name for element in only["elements"] for name in element["controls"]}
    assert laid == {row["control"] for row in only["controls"] if row["place"] != "left off"}
    assert all(row["reason"] for row in only["controls"] if row["place"] == "left off")
    assert only["solution"]["bound"] <= only["solution"]["cost"] + 1e-9


def test_report_and_preview_are_written(character, tmp_path):
    report, picture = tmp_path / "deep" / "out.json", tmp_path / "out.png"
    assert main(["process", str(character), "--report", str(report), "--preview", str(picture)]) == 0
    assert json.loads(report.read_text())["outcome"] == "written"
    assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("argument", ["--help", "--version"])
def test_help_and_version_load_nothing_heavy(argument):
    code = (
        f"import sys\nfrom usdrigui.cli import main\nmain([{argument!r}])\n"
        "heavy = ('pxr', 'scipy', 'highspy', 'numpy', 'usdrigui.settings')\n"
        "print([name for name in heavy if name in sys.modules], file=sys.stderr)"
    )
    done = ran("-c", code)
    assert done.stderr.strip() == "[]"


def test_a_run_loads_nothing_that_few_layouts_need():
    parts = ("scipy.stats", "scipy.interpolate", "scipy.ndimage", "PIL", "rich.console")
    code = (
        "import sys, usdrigui.pipeline, usdrigui.cli.terminal.review_lines; from usdrigui.reader import reader_main;"
        f"print([name for name in {parts} if name in sys.modules])"
    )
    assert ran("-c", code).stdout == "[]\n"


def test_importing_the_package_loads_no_usd():
    code = "import sys, usdrigui; usdrigui.Settings; usdrigui.process; print('pxr' in sys.modules)"
    assert ran("-c", code).stdout == "False\n"


def test_schema_path_is_a_folder_with_a_plugin(capsys):
    assert main(["schema-path"]) == 0
    from pathlib import Path

    assert (Path(capsys.readouterr().out.strip()) / "plugInfo.json").is_file()


@pytest.mark.parametrize("target", ["folder.usda", "file/x.usda", "locked/x.usda"])
def test_a_dry_run_checks_where_the_layer_would_go(target, character, tmp_path, capsys, monkeypatch):
    (tmp_path / "folder.usda").mkdir()
    (tmp_path / "file").write_text("")
    (tmp_path / "locked").mkdir()
    monkeypatch.setattr(os, "access", lambda path, _: "locked" not in str(path))
    before = sorted(tmp_path.rglob("*"))
    assert main(["process", str(character), "--dry-run", "-o", str(tmp_path / target)]) == 3
    assert ("FILE_PERMISSION" if "locked" in target else "FILE_TARGET") in capsys.readouterr().err
    assert sorted(tmp_path.rglob("*")) == before
