"""What a wrong command line, configuration or file is answered: all of it at once, and with what was meant."""

import json
from pathlib import Path

import pytest
from commands import run

from usdrigui.cli import main
from usdrigui.cli.options import files_read, passed_on, settings_of
from usdrigui.cli.parser import hint, options_of, parser
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load

VALUES = """
[solve]
gap = -1.0
gop = 1
[objective]
overlap_max = "much"
[candidates]
view = "above"
[controls.chin]
place = "moon"
"""
NAMES = """
[objective]
terms = ["no_such_term"]
[read.pose]
nobody = 1.0
[joints.tail]
axes = ["x"]
[poses.grin]
weights = { nobody = 1.0, no_one = 1.0 }
[parts.controls]
nobody = "face"
[groups.groups]
one = ["smile_L", "nobody", "grin"]
two = ["smile_L", "brow_L"]
[controls.tail]
exclude = true
[controls.smile_left]
exclude = true
[controls.smile_L]
minimum = 2.0
near = "joint:Jew"
anchor = "MESH#1000000"
twin = "no_one"
[controls.brow_L]
near = "MESH#1000000"
anchor = "MESH"
inner_anchor = "/Char/Hed#1"
orbit = ["brow_L", "nobody"]
glyph = "/Nowhere"
"""
WRONG_VALUES = ["candidates.view", 'controls."chin".place', "objective.overlap_max", "solve.gap", "solve.gop"]
WRONG_NAMES = [
    'controls."brow_L".anchor', 'controls."brow_L".glyph', 'controls."brow_L".inner_anchor', 'controls."brow_L".near',
    'controls."brow_L".orbit', 'controls."smile_L"', 'controls."smile_L".anchor', 'controls."smile_L".near',
    'controls."smile_L".twin', 'controls."smile_left"', 'controls."tail"', 'groups.groups."one"',
    'groups.groups."two"', 'joints."tail"', "objective.terms", 'parts.controls."nobody"', 'poses."grin".weights',
    'poses."grin".weights', 'read.pose."nobody"',
]  # fmt: skip


@pytest.mark.parametrize(
    ("texts", "wrong"),
    [([VALUES], WRONG_VALUES), ([NAMES], WRONG_NAMES), ([VALUES, NAMES], WRONG_VALUES + WRONG_NAMES)],
    ids=["values", "names", "both"],
)
@pytest.mark.parametrize("command", ["process", "inspect", "check"])
def test_everything_that_is_wrong_in_a_configuration_is_reported_at_once(command, texts, wrong, layer, capsys):
    asset = layer.with_name("char.usda")
    (mesh, *_) = read_rigs(asset, load())[0].body.meshes
    files = [layer.with_name(f"{i}.toml") for i in range(len(texts))]
    for file, text in zip(files, texts, strict=True):
        file.write_text(text.replace("MESH", mesh.path))
    given = [option for file in files for option in ("--config", file)]
    read = layer if command == "check" else asset
    found = run(capsys, command, read, *given, expected=2)["issues"]
    assert sorted(each["path"] for each in found) == sorted(wrong)
    assert all(each["message"].startswith(f"in {files[0]}: ") for each in found if each["path"] in WRONG_VALUES)
    hints = " ".join(each["message"] for each in found)
    assert texts == [VALUES] or ("'Jaw'" in hints and "'smile_L'" in hints)
    assert main([*map(str, (command, read, *given))]) == 2
    assert capsys.readouterr().err.count("repair:") == len(wrong)


def test_names_of_another_character_are_all_told_at_once(layer, capsys):
    layer.with_name("char.rigui.toml").write_text(
        '[like.names]\nnobody = "chin"\nchin = "no_one"\nbrow_L = ""\n[read.pose]\nnobody = 1.0\n'
    )
    found = run(capsys, "process", layer.with_name("char.usda"), "--like", layer, expected=2)["issues"]
    assert [each["path"] for each in found] == ['read.pose."nobody"', 'like.names."nobody"', 'like.names."chin"']


@pytest.mark.parametrize(
    ("command", "option", "hint"),
    [
        ("process", "--previuos", "did you mean '--previous'?"),
        ("check", "--jsn", "did you mean '--json'?"),
        ("view", "-o", "did you mean '--html'?"),
        ("view", "--output=x.html", "did you mean '--html'?"),
        ("picker", "--out", "did you mean '--svg'?"),
        ("batch", "--time-limits", "did you mean '--time-limit'?"),
        ("process", "--timeout", "did you mean '--time-limit'?"),
        ("batch", "-j", "did you mean '--jobs'?"),
        ("process", "-n", "did you mean '--dry-run'?"),
        ("check", "-o", "its result is printed: --json > FILE keeps it"),
        ("view", "--dry-run", "that is an option of process"),
        ("check", "--jobs", "that is an option of batch"),
        ("diff", "--config", "that is an option of process, inspect, check, pin, unpin, pins, view, bake, picture"),
    ],
)
def test_an_unknown_option_is_answered_with_its_commands_usage_and_what_was_meant(capsys, command, option, hint):
    assert main([command, "char.rigui.usda", *(["other.usda"] if command == "diff" else []), option, "--json"]) == 2
    told = capsys.readouterr()
    assert f"usage: usdrigui {command}" in told.err
    assert hint in json.loads(told.out)["issues"][0]["message"]


def test_a_command_that_is_misspelt_is_answered_with_what_was_meant(capsys):
    assert main(["procces"]) == 2
    assert "did you mean 'process'?" in capsys.readouterr().err


def test_every_option_of_another_command_is_answered_with_a_hint():
    every = {command: options_of(each) for command, each in parser().commands.items()}
    unanswered = {
        (command, option)
        for command, own in every.items()
        for option in set().union(*every.values()) - set(own)
        if not hint(option, command, every)
    }
    assert not unanswered


def test_of_several_configurations_a_later_one_wins_over_an_earlier(layer, capsys):
    texts = {"studio": "[solve]\ngap = 0.2\nwork_limit = 1234\n", "show": "[solve]\ngap = 0.3\n"}
    for name, text in texts.items():
        layer.with_name(f"{name}.toml").write_text(text)
    files = [each for name in texts for each in ("--config", str(layer.with_name(f"{name}.toml")))]
    arguments = parser().parse_args(
        ["process", str(layer.with_name("char.usda")), *files, "--set", "read.skel_root=/A"]
    )
    found = settings_of(arguments)
    assert (found.solve.gap, found.solve.work_limit, found.read.skel_root) == (0.3, 1234, "/A")
    assert {Path(each) for each in files[1::2]} <= set(files_read(arguments))
    passed = [each.removeprefix("--config=") for each in passed_on(arguments)]
    assert [each for each in passed if each.endswith(".toml")] == files[1::2]
    layer.with_name("show.toml").write_text("[solve]\ngop = 1\n")
    assert [each["path"] for each in run(capsys, "process", "char.usda", *files, expected=2)["issues"]] == ["solve.gop"]
