"""A law: no line that a command prints is longer than the terminal is wide, but for words that cannot be broken."""

import pytest
import skinned_stages

from usdrigui.cli import main
from usdrigui.cli.parser import parser

LONG = "face_rig_control_of_the_left_upper_eyelid_corner"
CONFIGURATION = f"""
[controls.blink_L]
rename = "{LONG}"
[controls.blink_R]
rename = "{LONG.replace("left", "right")}"
[controls.chin]
place = "board"
"""
COMMANDS = [
    "process char.usda --report report.json --preview char.png",
    "inspect char.usda --animation char.usda",
    "process char.usda --set objective.overlap_radius=0.2 -o other.usda --previous char.rigui.usda",
    "check char.rigui.usda",
    "diff char.rigui.usda other.usda",
    "picture char.usda -o other.png",
    "view char.rigui.usda --html page.html",
    "picker char.rigui.usda --svg picker.svg",
    "batch char.usda gone.usda --jobs 1",
    "process gone.usda",
    "process char.usda --set solve.gapp=1 --set objective.handle_sizes=2",
    "process char.usda --dry-run -o char.usda",
    "check char.usda --variant LOD=low",
    "process char.usda --previus char.rigui.usda",
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("fit")
    skinned_stages.character(folder / "char.usda")
    (folder / "char.rigui.toml").write_text(CONFIGURATION)
    return folder


@pytest.fixture
def width(monkeypatch, folder):
    """Narrower than lines are where nothing is known of the terminal."""
    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.chdir(folder)
    return 60


def too_long(text, width):
    """Lines with room for a break; what is to be pasted into a configuration is as long as it is."""
    told, _, _ = text.partition("as a configuration:")
    return [line for line in told.splitlines() if len(line) > width and len(line.split()) > 1]


def test_what_commands_print_fits(width, capsys):
    for command in COMMANDS:
        main(command.split())
        printed = capsys.readouterr()
        for text in (printed.out, printed.err):
            assert not too_long(text, width), command


def test_help_fits(width):
    for name, command in parser().commands.items():
        assert not too_long(command.format_help(), width), name
