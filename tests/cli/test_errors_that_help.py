"""What a wrong command line, configuration or file is answered: all of it at once, and with what was meant."""

import json
from pathlib import Path

import pytest
from commands import run

from usdrigui.cli import main
from usdrigui.cli.options import files_read, passed_on, settings_of
from usdrigui.cli.parser import hint, options_of, parser


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
        ["process", str(layer.with_name("char.usda")), *files, "--set", "read.skel_root=/A", "--time", "0"]
    )
    found = settings_of(arguments)
    assert (found.solve.gap, found.solve.work_limit, found.read.skel_root) == (0.3, 1234, "/A")
    assert {Path(each) for each in files[1::2]} <= set(files_read(arguments))
    passed = [each.removeprefix("--config=") for each in passed_on(arguments)]
    assert passed == [*files[1::2], "--set=read.skel_root=/A", "--time=0.0"]
    layer.with_name("show.toml").write_text("[solve]\ngop = 1\n")
    assert [each["path"] for each in run(capsys, "process", "char.usda", *files, expected=2)["issues"]] == ["solve.gop"]
