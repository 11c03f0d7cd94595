"""USD reads our layers in silence, and moves the handles as we say; other versions by the command usd_versions.py."""

import json
import sys
from pathlib import Path

import pytest
import usd_versions

ROOT = Path(__file__).resolve().parents[2]

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def samples(tmp_path_factory):
    folder = tmp_path_factory.mktemp("layers")
    return folder, usd_versions.write_samples(folder)


@pytest.mark.parametrize("plugin", [False, True])
def test_layers_open_without_a_word_and_handles_follow(samples, plugin):
    folder, written = samples
    for name, (root, expected) in written.items():
        assert usd_versions.complaint(sys.executable, folder / name, root, expected, plugin) == "", name


def test_a_complaint_and_a_handle_that_strays_are_noticed(samples):
    folder, written = samples
    name, (root, expected) = next(iter(written.items()))
    text = (folder / name).read_text()
    broken = folder / "broken.usda"
    broken.write_text(text.replace("subLayers = [", "subLayers = [\n        @./missing.usda@,"))
    assert "missing.usda" in usd_versions.complaint(sys.executable, broken, root, expected, False)
    wrong = json.dumps({**json.loads(expected), "diagonal": 1e-9})
    assert "off by" in usd_versions.complaint(sys.executable, folder / name, root, wrong, False)
