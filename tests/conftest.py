"""What tests of several folders share."""

import pytest
import skinned_stages
from hypothesis import settings

from usdrigui.cli import main

# Every run draws the same examples, so that a change is judged by itself; `--hypothesis-profile=default` draws others.
settings.register_profile("same", derandomize=True)
settings.load_profile("same")


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory):
    """Folder of a character with its layout, made once a module; to be copied by every test that may spoil it."""
    character = skinned_stages.character(tmp_path_factory.mktemp("once") / "char.usda")
    assert main(["process", str(character), "--quiet"]) == 0
    return character.parent
