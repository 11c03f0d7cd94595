"""Thirty valid rigs, laid out, checked and viewed; docs/reliability.md has the thousand."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from valid_rigs import SMALL, make_rig

HERE = Path(__file__).parent


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="readers are forked, which needs Linux")
def test_every_valid_rig_is_laid_out_checked_and_viewed():
    command = [sys.executable, str(HERE / "many_rigs.py"), "--small", "--count", "30"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=900, check=False)
    assert done.stdout, f"the process under test died ({done.returncode}): {done.stderr[-2000:]}"
    found = json.loads(done.stdout)
    assert found["not exit 0"] == []
    assert found["ends"] == {"check: exit 0": 30, "process: exit 0": 30, "view: exit 0": 30}


def test_a_seed_gives_the_same_rig_every_time(tmp_path):
    def made(seed, name):
        return make_rig(seed, tmp_path / f"{name}.usda", SMALL).read_bytes()

    assert made(3, "one") == made(3, "again") != made(4, "other")
