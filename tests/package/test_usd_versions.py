"""Other versions of USD read our layers in silence: this one always, more by USDRIGUI_OTHER_USD."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
import skinned_stages
import usd_versions

ROOT = Path(__file__).resolve().parents[2]
OTHERS = [each for each in os.environ.get("USDRIGUI_OTHER_USD", "").split(os.pathsep) if each]

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def samples(tmp_path_factory):
    folder = tmp_path_factory.mktemp("layers")
    return folder, usd_versions.write_samples(folder)


@pytest.mark.parametrize("plugin", [False, True])
@pytest.mark.parametrize("python", [sys.executable, *OTHERS])
def test_layers_open_without_a_word_and_handles_follow(samples, python, plugin):
    folder, written = samples
    for name, (root, expected) in written.items():
        assert usd_versions.complaint(python, folder / name, root, expected, plugin) == "", name


@pytest.mark.parametrize("python", OTHERS)
def test_a_python_with_another_usd_writes_the_same_bytes(tmp_path, python):
    """Where the packages that usdrigui needs are installed beside that USD, such as usd-exchange."""
    version = "from pxr import Usd; print(Usd.GetVersion() >= (0, 25, 11))"
    if subprocess.check_output([python, "-c", version], text=True).strip() != "True":
        pytest.skip("USD before 25.11 does not know the limits of weights")
    source = skinned_stages.character(tmp_path / "char.usda")
    layers = []
    for interpreter in (sys.executable, python):
        layers.append(tmp_path / f"layout{len(layers)}.usda")
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        command = [interpreter, "-m", "usdrigui", "process", str(source), "-o", str(layers[-1]), "--quiet"]
        done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=300, check=False)
        if interpreter == python and "ModuleNotFoundError" in done.stderr:
            pytest.skip(f"{python} lacks packages that usdrigui needs")
        assert done.returncode == 0, done.stderr
    assert layers[0].read_bytes() == layers[1].read_bytes()


def test_a_complaint_and_a_handle_that_strays_are_noticed(samples):
    folder, written = samples
    name, (root, expected) = next(iter(written.items()))
    text = (folder / name).read_text()
    broken = folder / "broken.usda"
    broken.write_text(text.replace("subLayers = [", "subLayers = [\n        @./missing.usda@,"))
    assert "missing.usda" in usd_versions.complaint(sys.executable, broken, root, expected, False)
    wrong = json.dumps({**json.loads(expected), "diagonal": 1e-9})
    assert "off by" in usd_versions.complaint(sys.executable, folder / name, root, wrong, False)
