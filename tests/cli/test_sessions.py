"""Sessions of commands on a small character: what each prints and what is written, as it is kept in sessions/NAME.

Lines of a session that begin with ``$`` are run, one after the other; to change what comes out, see tests/figures.py.
"""

import os
import re
import shlex
import shutil
from pathlib import Path

import figures
import pytest
from pxr import Sdf

from usdrigui.cli import main

SESSIONS = Path(__file__).with_name("sessions")


def told(text, folder):
    """Printed lines with what every run or machine has otherwise, measured numbers, and what USD
    says in words of its own, left open."""
    text = re.sub(r"-?\d+\.\d+(e[-+]\d+)?|\bnan\b", "0.0", text.replace(f"{folder}/", ""))
    return [line for line in re.sub(" +", " ", text).splitlines() if line.strip() and "USD_DIAGNOSTIC" not in line]


@pytest.mark.parametrize("name", sorted(each.name for each in SESSIONS.iterdir()))
def test_a_session_goes_as_it_is_kept(name, folder, monkeypatch, capsys):
    shutil.copytree(SESSIONS / name, folder, dirs_exist_ok=True)
    monkeypatch.chdir(folder)
    given = [each.name for each in folder.iterdir()]
    kept = (SESSIONS / name / "session.txt").read_text()
    now = []
    for line in re.findall(r"^\$ usdrigui (.*)", kept, re.MULTILINE):
        ended = main(shlex.split(line))
        printed = capsys.readouterr()
        now += [f"$ usdrigui {line}", *told(printed.out, folder), *told(printed.err, folder), f"{ended}"]
    if os.environ.get("USDRIGUI_GOLDEN") == "write":
        (SESSIONS / name / "session.txt").write_text("\n".join([*now, ""]))
    else:
        assert now == kept.splitlines()
    written = {each.name: figured(each) for each in folder.glob("*.usda") if each.name not in given}
    assert figures.other_than_kept(f"session_{name}", written) == {}


def figured(path):
    """The values of the attributes of a layer, by their names: those of all prims and times together."""
    layer, found = Sdf.Layer.FindOrOpen(str(path)), {}

    def note(at):
        if at.IsPropertyPath() and (spec := layer.GetAttributeAtPath(at)):
            samples = [layer.QueryTimeSample(at, time) for time in layer.ListTimeSamplesForPath(at)]
            found.setdefault(at.name, []).extend([spec.default, *samples])

    layer.Traverse("/", note)
    return found
