"""The extension, built, and the interpreters with Blender's bpy that USDRIGUI_BPY names."""

import json
import os
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from usdrigui.clients.blender_extension import NAME, extension_files

INSIDE = Path(__file__).parent / "inside"
PYTHONS = [each for each in os.environ.get("USDRIGUI_BPY", "").split(os.pathsep) if each]
NO_BPY = pytest.param("", marks=pytest.mark.skip("USDRIGUI_BPY names no interpreter that can import bpy"))


@pytest.fixture(params=PYTHONS or [NO_BPY], ids=lambda python: Path(python).parts[-3] if python else "none")
def bpy_python(request):
    """An interpreter with bpy; never the one of the tests: two USDs in one process disturb each other."""
    return request.param


@pytest.fixture
def usd_python(bpy_python):
    """The same; skips those whose bpy brings no Python modules of USD."""
    if not _has_usd(bpy_python):
        pytest.skip("this bpy comes without USD's Python modules")
    return bpy_python


@cache
def _has_usd(python):
    program = "import bpy; getattr(bpy.utils, 'expose_bundled_modules', int)(); import pxr.Usd"
    return subprocess.run([python, "-c", program], capture_output=True, timeout=120, check=False).returncode == 0


@pytest.fixture(scope="session")
def extension(tmp_path_factory):
    """The folder in which the built extension lies as a package."""
    folder = tmp_path_factory.mktemp("extension")
    for name, content in extension_files().items():
        path = folder / NAME / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return folder


@pytest.fixture
def run_inside(tmp_path, extension):
    """Run a script of `inside` with a job; returns the arrays that it saved.

    Each runs in a process of its own with a time limit: some Blenders hang when they should end.
    """

    def run(command, script, environment=None, **job):
        path, result = tmp_path / f"{script}.json", tmp_path / f"{script}.npz"
        path.write_text(json.dumps({"extension": str(extension), "result": str(result), **job}))
        done = subprocess.run(
            [*command, str(INSIDE / f"{script}.py"), *(["--"] if "-P" in command else []), str(path)],
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
            env={**os.environ, "PYTHONPATH": str(INSIDE), **(environment or {})},
        )
        assert done.returncode == 0, f"{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
        assert "Traceback" not in done.stderr, done.stderr[-3000:]
        return np.load(result) if result.exists() else done.stdout

    return run
