"""The page's own sources in Node.js, without a browser."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest


def placed_by_the_page(cases):
    """What the page makes of cases {scene, times}, as placed.mjs says; one process for all."""
    return json.loads(_answer("placed.mjs", cases))


def corrections_of_the_page(scene, control, mesh, point):
    """The layer that the page saves when the element of a control was moved to a point, as rearranged.mjs says."""
    return _answer("rearranged.mjs", {"scene": scene, "control": control, "mesh": mesh, "point": point})


def _answer(script, asked):
    if shutil.which("node") is None:
        pytest.skip("Node.js is not installed")
    path = Path(__file__).with_name("clients") / script
    done = subprocess.run(
        ["node", str(path)], input=json.dumps(asked), capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout
