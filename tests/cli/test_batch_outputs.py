"""What a batch writes: every name is checked before any work, and no two jobs write the same file."""

import shutil
from dataclasses import replace
from pathlib import Path

import commands
import pytest

from usdrigui.cli import main
from usdrigui.clients.batch import jobs, places, run, state
from usdrigui.clients.batch.job import Job, Row
from usdrigui.errors import RigUIError


@pytest.fixture
def idle(monkeypatch, tmp_path):
    """The folder of an asset, which becomes the working folder; laying anything out in it is a mistake."""

    def never(asked, workers):
        raise AssertionError(f"began to work on {asked} with {workers}")

    monkeypatch.setattr(run, "run_local", never)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "char.usda").touch()
    return tmp_path


@pytest.mark.parametrize(
    ("options", "code"),
    [
        (("--summary", "s.usda"), "FILE_TARGET s.usda"),
        (("--sheet", "s.usd"), "FILE_TARGET s.usd"),
        (("--sheet", "s.jpg"), "CONFIG_VALUE --sheet"),
        (("--sheet", "s"), "CONFIG_VALUE --sheet"),
        (("--summary", "folder"), "FILE_TARGET folder"),
        (("--summary", "char.usda/s.json"), "FILE_TARGET char.usda/s.json"),
        (("--sheet", "folder.png"), "FILE_TARGET folder.png"),
        (("--summary", "s.png", "--sheet", "../folder/s.png", "--output-dir", "."), "FILE_TARGET s.png"),
        (("--sheet", "char.rigui.png"), "FILE_TARGET char.rigui.png"),
        (("--summary", "char.rigui.batch.json"), "FILE_TARGET char.rigui.batch.json"),
    ],
)
def test_a_name_that_cannot_be_is_refused_before_any_work(idle, capsys, options, code):
    (idle / "folder").mkdir()
    (idle / "folder.png").mkdir()
    options = [each.replace("../folder", f"../{idle.name}") for each in options]
    before = sorted(idle.rglob("*"))
    assert main(["batch", "*.usda", *options]) == (3 if "FILE" in code else 2)
    assert code in capsys.readouterr().err
    assert sorted(idle.rglob("*")) == before


def layers(folder, *names, output_dir=None):
    """Names, below the folder, of the layers of a batch of these files."""
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    found = [*map(Path, names)]
    return [each.as_posix() for each in places.outputs_of(found, output_dir)]


def test_one_folder_under_two_names_is_one_folder(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a").mkdir()
    (tmp_path / "link").symlink_to("a")
    there = f"{tmp_path.as_posix()}/a"
    assert layers(tmp_path, "a/char.usda", f"{there}/char.usdc", "link/char.usd", "a/other.usda") == [
        "a/char_usda.rigui.usda",
        f"{there}/char_usdc.rigui.usda",
        "link/char_usd.rigui.usda",
        "a/other.rigui.usda",
    ]
    below = [each.replace(there, "a") for each in layers(tmp_path, "a/char.usda", f"{there}/char.usdc")]
    assert layers(tmp_path, "a/char.usda", f"{there}/char.usdc", output_dir=Path("a")) == below


def test_a_name_with_its_extension_that_another_asset_has_too(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert layers(tmp_path, "char.usda", "char.usdc", "char_usda.usda", "char_usda_usda.usda") == [
        "char_usda.rigui.usda",
        "char_usdc.rigui.usda",
        "char_usda_usda.rigui.usda",
        "char_usda_usda_usda.rigui.usda",
    ]


def test_layers_that_would_be_one_file_are_refused_before_any_work(idle, capsys):
    (idle / "one").mkdir()
    (idle / "two").mkdir()
    (idle / "out").mkdir()
    (idle / "out" / "one").symlink_to(".")
    (idle / "out" / "two").symlink_to(".")
    for name in ("one", "two"):
        (idle / name / "char.usda").touch()
    for command in ("batch", "openjd"):
        assert main([command, "*/char.usda", "--output-dir", "out"]) == 3
        told = capsys.readouterr()
        assert "FILE_TARGET out/two/char_usda.rigui.usda: " in told.err
        assert "the layer of one/char.usda and the layer of two/char.usda" in told.err
        assert not told.out


def test_a_layer_that_leads_to_another_one_is_refused(idle):
    (idle / "other.usda").touch()
    (idle / "char.rigui.usda").symlink_to("other.rigui.usda")
    with pytest.raises(RigUIError, match="FILE_TARGET"):
        places.outputs_of([Path("char.usda"), Path("other.usda")], None)


def test_names_like_options_are_names(laid_out, monkeypatch, tmp_path, capsys):
    """The process of the asset must not take them for its own options."""
    monkeypatch.chdir(tmp_path)
    shutil.copy(laid_out / "char.usda", tmp_path / "-x.usda")
    (row,) = commands.run(capsys, "batch", "*.usda", "--sheet", "sheet.png")["assets"]
    assert (row["asset"], row["output"], row["picture"]) == ("-x.usda", "-x.rigui.usda", "-x.rigui.png")
    assert {each.name for each in tmp_path.iterdir()} == {
        "-x.usda",
        "-x.rigui.usda",
        "-x.rigui.png",
        "-x.rigui.batch.json",
        "sheet.png",
    }


def test_a_layer_under_another_name_than_last_time_is_skipped_all_the_same(monkeypatch, tmp_path):
    """What is remembered says where the layer was then; rows are told apart by where it is now."""
    monkeypatch.chdir(tmp_path)
    Path("char.usda").touch()
    Path("char.rigui.usda").touch()
    before = Job("char.usda", "char.rigui.usda", "", settings="settings")
    sources = [{"path": "char.usda", "sha256": state.hashed("char.usda").sha256}]
    state.remember(before, sources, Row(before.asset, before.output, "", "written", 0))
    now = replace(before, output=str(tmp_path / "char.rigui.usda"))
    again = jobs.run_job(now)
    assert (again.outcome, again.output) == ("skipped", now.output)
    assert run.in_order([again], [now]) == (again,)
