"""Sessions of commands on a small character: what each prints and what is written, as it is kept in sessions/NAME.

Lines of a session that begin with ``$`` are run, one after the other; to change what comes out, see tests/figures.py.
"""

import itertools
import json
import os
import re
import shlex
import shutil
from pathlib import Path

import figures
import numpy as np
import pytest
from PIL import Image
from pxr import Sdf

from usdrigui.cli import main

SESSIONS = Path(__file__).with_name("sessions")


NUMBER = re.compile(r"-?\d+\.\d+(?:e[-+]\d+)?|\bnan\b")


def told(text, folder, numbers):
    """Printed lines without what every run or machine has otherwise, and what USD says in words of its own; their
    numbers are left open, and those of lines without times added to `numbers`."""
    lines = [re.sub(" +", " ", line) for line in text.replace(f"{folder}/", "").splitlines()]
    lines = [line for line in lines if line.strip() and "USD_DIAGNOSTIC" not in line]
    for line in lines:
        if not re.search(r"\d s\b|second|a minute", line):
            numbers.setdefault(NUMBER.sub("0.0", line), []).extend(map(float, NUMBER.findall(line)))
    return [NUMBER.sub("0.0", line) for line in lines]


@pytest.mark.parametrize("name", sorted(each.name for each in SESSIONS.iterdir()))
def test_a_session_goes_as_it_is_kept(name, folder, monkeypatch, capsys):
    shutil.copytree(SESSIONS / name, folder, dirs_exist_ok=True)
    monkeypatch.chdir(folder)
    given = [each.name for each in folder.iterdir()]
    kept = (SESSIONS / name / "session.txt").read_text()
    now, numbers = [], {}
    for line in re.findall(r"^\$ usdrigui (.*)", kept, re.MULTILINE):
        ended = main(shlex.split(line))
        printed = capsys.readouterr()
        # A table of assets has a column of seconds.
        lines = (told(each, folder, {} if line.startswith("batch") else numbers) for each in printed)
        now += [f"$ usdrigui {line}", *itertools.chain(*lines), f"{ended}"]
    if os.environ.get("USDRIGUI_GOLDEN") == "write":
        (SESSIONS / name / "session.txt").write_text("\n".join([*now, ""]))
    else:
        assert now == kept.splitlines()
    written = [each for each in sorted(folder.iterdir()) if each.name not in given]
    said = {each.name: figured(each) for each in written if each.suffix in (".usda", ".json", ".svg")}
    said["printed"] = {line: found for line, found in numbers.items() if found}
    assert figures.other_than_kept(f"session_{name}", said) == {}
    # A sheet with what was refused shows paths of this very run.
    pictures = [each for each in written if each.suffix == ".png" and each.name != "paths.png"]
    assert [each.name for each in pictures if not as_kept(each, SESSIONS / name)] == []


def as_kept(picture, session):
    """Whether a picture in 48 by 48 cells is as it is kept: what is drawn where, if not how a letter is."""
    cells, kept = Image.open(picture).convert("RGB").resize((48, 48), Image.Resampling.BOX), session / "pictures"
    if os.environ.get("USDRIGUI_GOLDEN") == "write":
        kept.mkdir(exist_ok=True)
        cells.save(kept / picture.name)
    apart = np.asarray(cells, dtype=float) - np.asarray(Image.open(kept / picture.name), dtype=float)
    return np.abs(apart).max() <= 3.0


def figured(path):
    """What a file says by name: a document itself, a drawing its numbers, a layer the values of its attributes, those
    of all prims and times together."""
    if path.suffix == ".json":
        return json.loads(path.read_text().replace(f"{path.parent}/", ""))
    if path.suffix == ".svg":
        return {"numbers": [*map(float, re.findall(r"-?\d+\.?\d*", path.read_text()))]}
    layer, found = Sdf.Layer.FindOrOpen(str(path)), {}

    def note(at):
        if at.IsPropertyPath() and (spec := layer.GetAttributeAtPath(at)):
            samples = [layer.QueryTimeSample(at, time) for time in layer.ListTimeSamplesForPath(at)]
            found.setdefault(at.name, []).extend([spec.default, *samples])

    layer.Traverse("/", note)
    return found
