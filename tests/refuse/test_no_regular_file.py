"""Whatever a command reads, a pipe, a device, a folder or a file without end is refused, at once."""

import os
import signal

import pytest

from usdrigui.cli import main
from usdrigui.cli.parser import parser

pytestmark = pytest.mark.skipif(os.name != "posix", reason="POSIX pipes and devices")

COMMANDS = {
    "process": "process BAD",
    "a configuration": "process CHAR --config BAD",
    "a pose": "process CHAR --pose BAD",
    "an earlier layout": "process CHAR --previous BAD",
    "a fixed layout": "process CHAR --fixed BAD",
    "another's layout": "process CHAR --like BAD",
    "an animation": "process CHAR --animation BAD",
    "inspect": "inspect BAD",
    "check": "check BAD",
    "diff": "diff LAYER BAD",
    "a page": "view BAD --html OUT.html",
    "a review": "view LAYER --review BAD --html OUT.html",
    "a live link": "view LAYER --live BAD",
    "a picture": "picture BAD -o OUT.png",
    "a picture's pose": "picture LAYER --pose BAD -o OUT.png",
    "a picker": "picker BAD --svg OUT.svg",
    "a study": "study BAD",
    "a batch's settings": "batch CHAR --config BAD",
    "an attached layout": "attach CHAR BAD",
    "an attachment": "attach BAD BARE",
}


@pytest.fixture(scope="module")
def folder(laid_out):
    assert main(["process", str(laid_out / "char.usda"), "--bare", "-o", str(laid_out / "bare.usda"), "--quiet"]) == 0
    os.mkfifo(laid_out / "pipe.usda")
    (laid_out / "folder.usda").mkdir()
    (laid_out / "device.usda").symlink_to("/dev/zero")
    (laid_out / "endless.usda").touch()
    os.truncate(laid_out / "endless.usda", 1 << 40)
    return laid_out


@pytest.mark.parametrize("what", COMMANDS)
def test_it_is_refused(what, folder, capsys, monkeypatch):
    monkeypatch.chdir(folder)
    before = sorted(each.name for each in folder.iterdir())
    for bad in ("pipe.usda", "folder.usda", "device.usda", "endless.usda"):
        named = {"BAD": bad, "CHAR": "char.usda", "LAYER": "char.rigui.usda", "BARE": "bare.usda"}
        signal.alarm(30)  # ends the process: nothing else ends a wait for a pipe
        code = main([named.get(word, word) for word in COMMANDS[what].split()])
        signal.alarm(0)
        said = capsys.readouterr()
        assert code in (1, 2, 3, 4), bad
        assert "Traceback" not in said.out + said.err
        assert sorted(each.name for each in folder.iterdir()) == before


def test_only_what_reads_nothing_runs_outside_of_a_worker():
    commands = parser().commands
    light = {name for name, command in commands.items() if command.get_default("light")}
    assert light == {"schema-path", "config-schema"}
