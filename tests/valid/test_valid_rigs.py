"""A dozen valid rigs and a dozen written ones, laid out, checked and viewed; docs/reliability.md has the thousand."""

import sys
from pathlib import Path

import failing
import numpy as np
import pytest
from programs import figures
from written_rigs import write_rig

import usdrigui
from usdrigui.settings import load

HERE = Path(__file__).parent


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="readers are forked, which needs Linux")
@pytest.mark.parametrize("kind", ["--small", "--written"])
def test_every_valid_rig_is_laid_out_checked_and_viewed(kind):
    found = figures(HERE / "many_rigs.py", kind, "--count", 5)
    assert found["not exit 0"] == []
    assert {*found["ends"].values()} == {5}


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="readers are forked, which needs Linux")
def test_the_first_call_of_every_kind_fails_on_a_written_character():
    def make(folder):
        write_rig(4, folder).rename(folder / "char.usda")

    assert failing.campaign(1 << 20, ["process"], make)["faults"] == []


@pytest.mark.slow
def test_pairs_that_joints_bring_together_tilt_no_plane(tmp_path):
    report = usdrigui.process(write_rig(61, tmp_path), load({"solve": {"work_limit": 2000}}))
    (character,) = report.characters
    assert all(np.isfinite(member.track).all() for e in character.layout.elements for member in e.members)
