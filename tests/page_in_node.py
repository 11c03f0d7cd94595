"""The page's own sources in Node.js, without a browser."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest

PLACED = Path(__file__).with_name("clients") / "placed.mjs"


def placed_by_the_page(cases):
    """What the page makes of cases {scene, times}, as placed.mjs says; one process for all."""
    if shutil.which("node") is None:
        pytest.skip("Node.js is not installed")
    done = subprocess.run(
        ["node", str(PLACED)], input=json.dumps(cases), capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
