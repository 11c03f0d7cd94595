"""Names come from files: they steer no terminal, break no page, and fit through every locale."""

import json
import os
import subprocess
import sys

import pytest
import traps

ASCII = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "PYTHONIOENCODING": ""}
COMMANDS = (("process", "--verbose"), ("inspect",))
"""Those that name every control."""


def run(*arguments, environment=None):
    return subprocess.run(
        [sys.executable, "-m", "usdrigui", *map(str, arguments)],
        env={**os.environ, **(environment or {})},
        capture_output=True,
        check=False,
    )


@pytest.mark.parametrize("command", COMMANDS)
def test_no_name_steers_the_terminal(command, tmp_path):
    path = traps.trapped(tmp_path, "a name with control characters")
    done = run(*command, path)
    assert done.returncode == 0
    assert b"\x1b" not in done.stdout + done.stderr
    assert rb"smi\x1b[31mle" in done.stdout


def test_no_message_steers_the_terminal(tmp_path):
    done = run("process", tmp_path / "\x1b]0;title\x07.usda")
    assert done.returncode == 3
    assert b"\x1b" not in done.stderr
    assert b"\x07" not in done.stderr


@pytest.mark.parametrize("command", COMMANDS)
def test_an_ascii_terminal_is_no_obstacle(command, tmp_path):
    path = traps.trapped(tmp_path, "names that are not ASCII")
    done = run(*command, path, environment=ASCII)
    assert done.returncode == 0, done.stderr
    assert rb"l\xe4cheln" in done.stdout


@pytest.mark.parametrize("command", COMMANDS)
def test_json_is_utf8_in_every_locale(command, tmp_path):
    path = traps.trapped(tmp_path, "names that are not ASCII")
    done = run(*command, path, "--json", environment=ASCII)
    assert done.returncode == 0, done.stderr
    (found,) = json.loads(done.stdout.decode("utf-8"))["characters"]
    assert {each["control"] for each in found["controls"]} == {"lächeln", "怒り"}


def test_a_file_name_that_is_no_text(tmp_path):
    done = run("process", os.fsencode(tmp_path).decode() + os.fsdecode(b"/\xff.usda"), "--json")
    assert done.returncode in (1, 3)
    assert json.loads(done.stdout.decode("utf-8", "replace"))["issues"]
    assert b"Traceback" not in done.stderr


def test_no_name_breaks_out_of_the_page(tmp_path):
    assert run("process", traps.trapped(tmp_path, "a name with markup")).returncode == 0
    page = tmp_path / "page.html"
    assert run("view", tmp_path / "char.rigui.usda", "--html", page).returncode == 0
    assert "<b>&" not in page.read_text(encoding="utf-8")
