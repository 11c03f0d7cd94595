"""Other versions of USD read our layers in silence: this one always, more by USDRIGUI_OTHER_USD."""

from __future__ import annotations

import json
import os
import sys

import pytest
import usd_versions

OTHERS = [each for each in os.environ.get("USDRIGUI_OTHER_USD", "").split(os.pathsep) if each]


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


def test_a_complaint_and_a_handle_that_strays_are_noticed(samples):
    folder, written = samples
    name, (root, expected) = next(iter(written.items()))
    text = (folder / name).read_text()
    broken = folder / "broken.usda"
    broken.write_text(text.replace("subLayers = [", "subLayers = [\n        @./missing.usda@,"))
    assert "missing.usda" in usd_versions.complaint(sys.executable, broken, root, expected, False)
    wrong = json.dumps({**json.loads(expected), "diagonal": 1e-9})
    assert "off by" in usd_versions.complaint(sys.executable, folder / name, root, wrong, False)
