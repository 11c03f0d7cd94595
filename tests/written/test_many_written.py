"""A few dozen written characters of every campaign; USDRIGUI_WRITTEN asks for more (docs/reliability.md)."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import failing
import numpy as np
import pytest

import usdrigui
from usdrigui.settings import load

HERE = Path(__file__).parent
COUNT = int(os.environ.get("USDRIGUI_WRITTEN", "24"))

pytestmark = [pytest.mark.slow, pytest.mark.skipif(sys.platform != "linux", reason="readers are forked")]


@pytest.mark.parametrize("kind", ["valid", "damaged", "ends"])
def test_every_end_is_a_good_one(kind):
    command = [sys.executable, str(HERE / "many_written.py"), kind, "--count", str(COUNT)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stdout, f"the process under test died ({done.returncode}): {done.stderr[-2000:]}"
    found = json.loads(done.stdout)
    assert found["faults"] == []
    assert found["runs"] == COUNT


def test_the_first_call_of_every_kind_fails_on_a_written_character():
    sys.path.append(str(HERE))
    from written_rigs import write_rig

    def make(folder):
        write_rig(4, folder).rename(folder / "char.usda")

    assert failing.campaign(1 << 20, ["process"], make)["faults"] == []


def test_pairs_that_joints_bring_together_tilt_no_plane(tmp_path):
    sys.path.append(str(HERE))
    from written_rigs import write_rig

    report = usdrigui.process(write_rig(61, tmp_path), load({"solve": {"work_limit": 2000}}))
    (character,) = report.characters
    assert all(np.isfinite(member.track).all() for e in character.layout.elements for member in e.manipulator.members)
