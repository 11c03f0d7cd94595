"""Which configuration a layout is judged and shown with, wherever it lies; and what `--set` can say."""

import shutil

import pytest
import skinned_stages
import triggers
from commands import run

from usdrigui.cli import main, parsed
from usdrigui.cli.options import settings_of
from usdrigui.settings import RunSettings
from usdrigui.settings.loading import load_beside

CONFIGURATION = """\
[controls.chin]
rename = "chinUp"

[poses.grin.weights]
smile_L = 1.0
smile_R = 1.0

[joints.Jaw]
axes = ["x"]
"""
UNRELATED = '[export]\ntarget = "film"\n'


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A configured character, its layouts beside it and elsewhere, and a copy with the layout inside."""
    folder = tmp_path_factory.mktemp("configured") / "asset"
    folder.mkdir()
    character = skinned_stages.character(folder / "char.usda")
    character.with_name("char.rigui.toml").write_text(CONFIGURATION)
    for target in ("char.rigui.usda", "layouts/cfg.usda", "attached/ui.usda"):
        (folder / target).parent.mkdir(exist_ok=True)
        bare = ["--bare"] if "ui" in target.split("/")[-1].split(".")[0] else []
        assert main(["process", str(character), "-o", str(folder / target), "--quiet", *bare]) == 0
    for name in ("char.usda", "char.rigui.toml"):
        shutil.copy(folder / name, folder / "attached" / name)
    assert main(["attach", str(folder / "attached/char.usda"), str(folder / "attached/ui.usda"), "--quiet"]) == 0
    (folder / "corrections.usda").write_text("#usda 1.0\n(\n    subLayers = [@./layouts/cfg.usda@]\n)\n")
    return folder


def shown(layer, *options, by=("check",)):
    """The exit codes of the commands that take a layout: 0 where they can show it and find nothing wrong with it."""
    folder = layer.parent
    commands = (
        ["check", "--strict"],
        ["view", "--html", str(folder / "page.html")],
        ["picture", "-o", str(folder / "picture.png")],
        ["picker", "--svg", str(folder / "picker.svg")],
    )
    return [main([name, str(layer), *own, *options]) for name, *own in commands if name in by]


def issues(layer, *options):
    code, found = triggers.command("check", layer, *options)
    return code, {each["code"] for each in found}


@pytest.mark.parametrize("layer", ["char.rigui.usda", "layouts/cfg.usda", "attached/char.usda", "corrections.usda"])
def test_a_configured_layout_is_shown_wherever_it_lies(folder, layer):
    assert shown(folder / layer) == [0]


def test_every_command_takes_the_configuration_of_a_layout(folder):
    assert shown(folder / "layouts/cfg.usda", by=("view", "picture", "picker")) == [0, 0, 0]


def test_a_layout_made_with_another_configuration_is_shown_with_that(folder, tmp_path):
    said = tmp_path / "said.toml"
    (folder / "char.rigui.toml").rename(said)
    assert shown(folder / "layouts/cfg.usda", "--config", str(said)) == [0]
    assert shown(folder / "layouts/cfg.usda") != [0]


def test_what_was_set_when_a_layout_was_made_can_be_set_again(folder):
    (folder / "char.rigui.toml").unlink()
    options = ["--set", "controls.chin.rename=chinUp", "--set", 'joints.Jaw.axes=["x"]']
    options += ["--set", "poses.grin.weights.smile_L=1", "--set", "poses.grin.weights.smile_R=1"]
    assert shown(folder / "char.rigui.usda", *options) == [0]


def test_a_given_configuration_is_stronger_than_one_of_the_layers_name_and_that_than_the_assets(folder):
    layer, said = folder / "layouts/cfg.usda", folder / "said.toml"
    (folder / "char.rigui.toml").write_text("[controls.chin]\nexclude = true\n")
    assert issues(layer)[0] == 1
    layer.with_suffix(".toml").write_text(CONFIGURATION)
    assert issues(layer)[0] == 0
    said.write_text("[nonsense]\n")
    assert issues(layer, "--config", said) == (2, {"CONFIG_UNKNOWN_KEY"})


@pytest.mark.parametrize("asset", ["char.usda", "attached/char.usda"])
def test_a_file_of_the_assets_name_is_somebody_elses(folder, asset):
    (folder / asset).with_suffix(".toml").write_text(UNRELATED)
    code, found = issues(folder / asset)
    assert code == 0
    assert not {each for each in found if each.startswith("CONFIG")}


@pytest.mark.parametrize("asset", ["char.usda", "attached/char.usda"])
def test_a_broken_configuration_of_an_asset_is_reported(folder, asset):
    (folder / asset).with_suffix(".rigui.toml").write_text("[controls.chin]\nexclud = true\n")
    assert issues(folder / asset) == (2, {"CONFIG_UNKNOWN_KEY"})


def parsed_for(path, *options):
    return parsed(["check", str(path), *options])


ATTACK = """[run]
time_limit = 0
memory_limit = 1000000000
[read]
time_limit = 9000.0
memory_limit = 10000
size_limit = 5000
"""


@pytest.mark.parametrize("name", ["char.usda", "char.rigui.usda"])
def test_a_file_beside_an_asset_can_lower_its_limits_only(folder, name, monkeypatch):
    (folder / "char.rigui.toml").write_text(ATTACK + CONFIGURATION)
    plain = settings_of(parsed_for(folder / name))
    assert plain.run == RunSettings()
    assert (plain.read.time_limit, plain.read.memory_limit) == (300.0, 8192)
    assert plain.read.size_limit == 5000
    assert load_beside(folder / name).run == RunSettings()
    given = parsed_for(folder / name, "--config", str(folder / "char.rigui.toml"))
    assert settings_of(given).run.time_limit == 0.0
    assert settings_of(parsed_for(folder / name, "--set", "run.time_limit=0")).run.time_limit == 0.0
    monkeypatch.setenv("USDRIGUI_READ_TIME_LIMIT", "0.001")
    assert issues(folder / "char.usda")[1] >= {"SOURCE_TIME_LIMIT"}


def test_layers_over_each_other_in_a_circle_have_an_end(folder):
    for name, below in (("one.usda", "@./two.usda@, @./layouts/cfg.usda@"), ("two.usda", "@./one.usda@")):
        (folder / name).write_text(f"#usda 1.0\n(\n    subLayers = [{below}]\n)\n")
    (folder / "char.rigui.toml").unlink()
    assert shown(folder / "one.usda") != [0]


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        (["controls.chin.maximum=0.5"], {"maximum": 0.5}),
        (["controls.chin.maximum=0.5", "controls.chin.label=Big chin"], {"maximum": 0.5, "label": "Big chin"}),
        (["controls={chin={maximum=0.5}}"], {"maximum": 0.5}),
        (["controls.chin={maximum=0.5}"], {"maximum": 0.5}),
        (['controls."chin".maximum=0.5'], {"maximum": 0.5}),
        (["controls.'chin'.label=a=b"], {"label": "a=b"}),
    ],
)
def test_what_is_said_of_one_control_can_be_set(made, texts, expected, capsys):
    settings = reported(made, capsys, texts)
    assert settings["controls"]["chin"] == {**settings["controls"]["chin"], "rename": "chinUp", **expected}


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("like.names.{}=x", "größe"),
        ("like.names.{}=x", "joint:Hips/Head"),
        ("like.names.{}=x", "it's"),
        ('like.names."{}"=x', "brow.L"),
        ("like.names.'{}'=x", "a=b"),
        ('like.names."{}"=x', 'with \\"quotes\\"'),
    ],
)
def test_any_name_can_stand_in_a_key(text, name):
    from usdrigui.cli.options import _assignment

    assert _assignment(text.format(name)) == {"like": {"names": {name.replace("\\", ""): "x"}}}


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("solve", "CONFIG_VALUE --set"),
        ("solve.=1", "CONFIG_VALUE --set"),
        (".gap=1", "CONFIG_VALUE --set"),
        ("=1", "CONFIG_VALUE --set"),
        ('controls."\\q".label=x', "CONFIG_VALUE --set"),
        ('controls."chin.label=x', "CONFIG_VALUE --set"),
        ("solve=1", "CONFIG_VALUE solve"),
        ("solve.gap.more=1", "CONFIG_VALUE solve.gap"),
        ("gap=1", "CONFIG_UNKNOWN_KEY gap"),
        ("controls.brow.L.label=x", "CONFIG_UNKNOWN_KEY"),
    ],
)
def test_what_sets_nothing_is_reported_before_the_layer_is_read(tmp_path, text, code, capsys):
    assert main(["check", str(tmp_path / "missing.usda"), "--set", text]) == 2
    assert code in capsys.readouterr().err


def reported(folder, capsys, texts):
    options = [part for text in texts for part in ("--set", text)]
    return run(capsys, "process", folder / "char.usda", "--dry-run", *options)["settings"]
