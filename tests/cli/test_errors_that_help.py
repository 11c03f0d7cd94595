"""What a wrong command line, configuration or file is answered: all of it at once, and with what was meant."""

import json

import pytest

from usdrigui.cli import main


def run(capsys, *arguments, expected):
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == expected
    return json.loads(capsys.readouterr().out)["issues"]


def test_everything_that_is_wrong_in_a_configuration_is_told_at_once(layer, capsys):
    asset = layer.with_name("char.usda")
    layer.with_name("char.rigui.toml").write_text(
        "[solve]\ngap = -1.0\ngop = 1\n[objective]\noverlap_max = 'much'\n[controls.smile_L]\nplace = 'moon'\n"
    )
    found = run(capsys, "process", asset, expected=2)
    assert {each["path"] for each in found} == {
        "solve.gap", "solve.gop", "objective.overlap_max", 'controls."smile_L".place',
    }  # fmt: skip
    assert main(["process", str(asset)]) == 2
    assert capsys.readouterr().err.count("repair:") == 4


def test_all_controls_that_no_rig_has_are_told_at_once(layer, capsys):
    names = ("smile_left", "brow.L", "tail")
    layer.with_name("char.rigui.toml").write_text("".join(f'[controls."{name}"]\nlabel = "x"\n' for name in names))
    found = run(capsys, "process", layer.with_name("char.usda"), expected=2)
    assert {each["path"] for each in found} == {f'controls."{name}"' for name in names}
    assert "did you mean 'smile_L'?" in found[0]["message"]


@pytest.mark.parametrize(
    ("command", "option", "meant"), [("process", "--previuos", "--previous"), ("check", "--jsn", "--json")]
)
def test_an_unknown_option_is_answered_with_its_commands_usage_and_what_was_meant(
    layer, capsys, command, option, meant
):
    with pytest.raises(SystemExit) as ended:
        main([command, str(layer), option])
    told = capsys.readouterr().err
    assert ended.value.code == 2
    assert f"usage: usdrigui {command}" in told
    assert f"did you mean {meant!r}?" in told


def test_a_dry_run_refuses_what_the_run_would_not_replace(layer, capsys):
    own = layer.with_name("mine.usda")
    own.write_text("#usda 1.0\n")
    found = run(capsys, "process", layer.with_name("char.usda"), "--dry-run", "-o", own, expected=3)
    assert [each["code"] for each in found] == ["FILE_TARGET"]


def test_viewers_of_an_asset_name_the_layout_beside_it(layer, capsys):
    found = run(capsys, "picture", layer.with_name("char.usda"), "-o", layer.with_name("a.png"), expected=1)
    assert found[0]["message"].endswith(f"{layer} beside it is a layout")
